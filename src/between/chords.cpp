#include "between/chords.hpp"
#include "between/segment_distance.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace tetloft::internal::between {

namespace {

double squared_length(const Point2& a, const Point2& b) {
  const double dx = b.x - a.x;
  const double dy = b.y - a.y;
  return dx * dx + dy * dy;
}

}  // namespace

ContourChords::ContourChords(const Contour& contour, double tolerance, double longest)
    : vertices_(contour.vertices),
      tolerance_(tolerance),
      kept_(contour.vertices.size(), 0),
      fixed_(contour.vertices.size(), 0) {
  if (vertices_.size() <= 4) {
    restore();
  } else {
    divide_all(tolerance, longest);
    changed_ = true;
    settle();
  }
}

// Vertices are counted cyclically: `last` may be 0 for the end of the contour.
std::size_t ContourChords::farthest(std::size_t first, std::size_t last, double& squared) const {
  const std::size_t end = last == 0 ? vertices_.size() : last;
  const Point2& a = vertices_[first];
  const Point2& b = vertices_[last];
  std::size_t best = first;
  squared = -1;
  for (std::size_t v = first + 1; v < end; ++v) {
    const double d = squared_distance(vertices_[v], a, b);
    if (d > squared) {
      squared = d;
      best = v;
    }
  }
  return best;
}

void ContourChords::divide_all(double tolerance, double longest) {
  // The two vertices that are farthest from each other, nearly; and one on either side between.
  std::size_t opposite = 0;
  for (std::size_t v = 1; v < vertices_.size(); ++v) {
    if (squared_length(vertices_[0], vertices_[v]) >
        squared_length(vertices_[0], vertices_[opposite])) {
      opposite = v;
    }
  }
  kept_[0] = kept_[opposite] = 1;
  struct Chord {
    std::size_t first, last;
    bool whole_side;
  };
  std::vector<Chord> waiting{{0, opposite, true}, {opposite, 0, true}};
  while (!waiting.empty()) {
    const Chord chord = waiting.back();
    waiting.pop_back();
    double squared = 0;
    std::size_t v = farthest(chord.first, chord.last, squared);
    if (v == chord.first) continue;
    if (!chord.whole_side && squared <= tolerance * tolerance) {
      if (squared_length(vertices_[chord.first], vertices_[chord.last]) <= longest * longest) {
        continue;
      }
      v = (chord.first + (chord.last == 0 ? vertices_.size() : chord.last)) / 2;
    }
    kept_[v] = 1;
    waiting.push_back({chord.first, v, false});
    waiting.push_back({v, chord.last, false});
  }
}

std::size_t ContourChords::next(std::size_t kept) const {
  std::size_t v = kept + 1;
  while (v < vertices_.size() && kept_[v] == 0) ++v;
  return v == vertices_.size() ? 0 : v;
}

bool ContourChords::divide(std::size_t chord) {
  const std::size_t first = start_[chord];
  const std::size_t last = next(first);
  double squared = 0;
  const std::size_t v = farthest(first, last, squared);
  const bool fixed = fixed_[first] != 0 && fixed_[last] != 0;
  if (v == first && fixed) return false;
  if (v != first) kept_[v] = 1;
  fixed_[first] = fixed_[last] = 1;
  return changed_ = true;
}

bool ContourChords::restore() {
  const auto all = [](const std::vector<std::uint8_t>& marks) {
    return std::find(marks.begin(), marks.end(), 0) == marks.end();
  };
  if (all(kept_) && all(fixed_)) return false;
  kept_.assign(vertices_.size(), 1);
  fixed_.assign(vertices_.size(), 1);
  changed_ = true;
  settle();
  return true;
}

// The area between the contour from `first` to `last` and their chord, to the right of it positive.
double ContourChords::area_beyond(std::size_t first, std::size_t last) const {
  const std::size_t end = last == 0 ? vertices_.size() : last;
  const Point2& a = vertices_[first];
  double twice = 0;
  for (std::size_t v = first + 1; v < end; ++v) {
    const Point2& p = vertices_[v];
    const Point2& q = vertices_[v + 1 == vertices_.size() ? 0 : v + 1];
    twice += (p.x - a.x) * (q.y - a.y) - (p.y - a.y) * (q.x - a.x);
  }
  return twice / 2;
}

// A vertex moved by d at right angles to the line from the one before to the one after it, L long,
// adds L d / 2: half of what both its chords have cut off.
void ContourChords::settle() {
  if (!changed_) return;
  changed_ = false;
  start_.clear();
  for (std::size_t v = 0; v < vertices_.size(); ++v) {
    if (kept_[v] != 0) start_.push_back(v);
  }
  const std::size_t n = start_.size();
  std::vector<double> beyond(n);
  for (std::size_t c = 0; c < n; ++c) {
    beyond[c] = area_beyond(start_[c], start_[c + 1 == n ? 0 : c + 1]);
  }
  simplified_.vertices.clear();
  for (std::size_t c = 0; c < n; ++c) {
    Point2 p = vertices_[start_[c]];
    const std::size_t previous = (c == 0 ? n : c) - 1;
    const Point2& from = vertices_[start_[previous]];
    const Point2& to = vertices_[start_[c + 1 == n ? 0 : c + 1]];
    const double length2 = squared_length(from, to);
    if (fixed_[start_[c]] == 0 && length2 > 0) {
      const double limit = tolerance_ / std::sqrt(length2);
      const double share = std::clamp((beyond[previous] + beyond[c]) / length2, -limit, limit);
      p = {p.x + share * (to.y - from.y), p.y - share * (to.x - from.x)};
    }
    simplified_.vertices.push_back(p);
  }
}

}  // namespace tetloft::internal::between

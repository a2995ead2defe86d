#include "between/given_labels.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

#include "between/segment_distance.hpp"
#include "spatial/box_tree.hpp"

namespace tetloft::internal::between {

namespace {

using motion::LatticeWindow;

// Parts thinner than this on both sides together have samples all the same.
constexpr double kThickening = 0.72;

// A contour of the class, in lattice units.
struct LatticeContour {
  std::vector<Point2> vertices;
  std::uint32_t solid = 0;       // of its region
  std::uint32_t hole = kNoNode;  // none of outer contours
  std::uint32_t depth = 0;
};

const Point2& lowest_vertex(const std::vector<Point2>& vertices) {
  return *std::min_element(vertices.begin(), vertices.end(),
                           [](const Point2& a, const Point2& b) { return canonical_less(a, b); });
}

// By their lowest vertices, so that nothing depends on their order in the section.
std::vector<LatticeContour> contours_of(const GivenRegions& given) {
  IdVector<RegionId, std::uint32_t> node(given.nesting.outer.size(), kNoNode);
  for (std::uint32_t n = 0; n < given.regions.size(); ++n) node[given.regions[n]] = n;
  std::vector<std::pair<Point2, ContourId>> members;
  for (const ContourId c : given.section.contours.ids()) {
    if (node[given.nesting.region[c]] == kNoNode) continue;
    members.emplace_back(lowest_vertex(given.section.contours[c].vertices), c);
  }
  std::sort(members.begin(), members.end(),
            [](const auto& a, const auto& b) { return canonical_less(a.first, b.first); });
  std::vector<LatticeContour> contours;
  std::uint32_t holes = kExterior;
  for (const auto& [lowest, c] : members) {
    LatticeContour& contour = contours.emplace_back();
    contour.solid = node[given.nesting.region[c]];
    contour.depth = given.nesting.depth[c];
    if (contour.depth % 2 == 1) contour.hole = ++holes;
    for (const Point2& p : given.section.contours[c].vertices) {
      contour.vertices.push_back({p.x / given.step, p.y / given.step});
    }
  }
  return contours;
}

// The least index of [low, high] that is at least `at`.
std::int64_t first_index(double at, std::int64_t low, std::int64_t high) {
  const double k = std::ceil(at);
  if (!(k > static_cast<double>(low))) return low;
  return k < static_cast<double>(high) ? static_cast<std::int64_t>(k) : high;
}

// From the sample on, its row is on the other side of the contour.
struct Passage {
  std::int64_t j, i;
  std::uint32_t contour;
  friend auto operator<=>(const Passage&, const Passage&) = default;
};

std::vector<Passage> passages_of(const std::vector<LatticeContour>& contours,
                                 const LatticeWindow& w) {
  std::vector<Passage> passages;
  for (std::uint32_t c = 0; c < contours.size(); ++c) {
    const std::vector<Point2>& vertices = contours[c].vertices;
    Point2 last = vertices.back();
    for (const Point2& next : vertices) {
      const bool up = last.y < next.y;
      const Point2& low = up ? last : next;
      const Point2& high = up ? next : last;
      const std::int64_t end = first_index(high.y, w.j0, w.j1);
      for (std::int64_t j = first_index(low.y, w.j0, w.j1); j < end; ++j) {
        const double t = (static_cast<double>(j) - low.y) / (high.y - low.y);
        passages.push_back({j, first_index(low.x + t * (high.x - low.x), w.i0, w.i1), c});
      }
      last = next;
    }
  }
  std::sort(passages.begin(), passages.end());
  return passages;
}

// The contours around a sample, as a row is run through.
class Around {
 public:
  explicit Around(const std::vector<LatticeContour>& contours) : contours_(contours) {}

  void pass(std::uint32_t contour) {
    const auto at = std::find(open_.begin(), open_.end(), contour);
    if (at == open_.end()) {
      open_.push_back(contour);
    } else {
      open_.erase(at);
    }
    innermost_ = nullptr;
    for (const std::uint32_t c : open_) {
      if (innermost_ == nullptr || contours_[c].depth > innermost_->depth) {
        innermost_ = &contours_[c];
      }
    }
  }
  [[nodiscard]] std::uint32_t solid() const {
    return innermost_ != nullptr && innermost_->hole == kNoNode ? innermost_->solid : kNoNode;
  }
  [[nodiscard]] std::uint32_t hole() const {
    return innermost_ == nullptr ? kExterior : innermost_->hole;
  }

 private:
  const std::vector<LatticeContour>& contours_;
  std::vector<std::uint32_t> open_;
  const LatticeContour* innermost_ = nullptr;
};

void label_rows(const std::vector<LatticeContour>& contours, const LatticeWindow& w,
                GivenLabels& labels) {
  const std::vector<Passage> passages = passages_of(contours, w);
  auto next = passages.begin();
  Around around(contours);
  std::size_t place = 0;
  for (std::int64_t j = w.j0; j < w.j1; ++j) {
    for (std::int64_t i = w.i0; i < w.i1; ++i, ++place) {
      for (; next != passages.end() && next->j == j && next->i == i; ++next) {
        around.pass(next->contour);
      }
      labels.solids.node[place] = around.solid();
      labels.voids.node[place] = around.hole();
    }
    // Those beyond the window close the row.
    for (; next != passages.end() && next->j == j; ++next) around.pass(next->contour);
  }
}

// Gives samples in no region to the nearest one.
void thicken(const std::vector<LatticeContour>& contours, const LatticeWindow& w,
             LayerLabels& solids) {
  struct Near {
    double squared;
    std::uint32_t place, solid;
  };
  std::vector<Near> found;
  for (const LatticeContour& contour : contours) {
    Point2 last = contour.vertices.back();
    for (const Point2& next : contour.vertices) {
      // From one order of the ends, whichever way the contour runs.
      const bool forward = canonical_less(last, next);
      const Point2& a = forward ? last : next;
      const Point2& b = forward ? next : last;
      const Box2 box = box_of(a, b);
      const std::int64_t i1 = first_index(box.x1 + kThickening, w.i0, w.i1);
      const std::int64_t j1 = first_index(box.y1 + kThickening, w.j0, w.j1);
      for (std::int64_t j = first_index(box.y0 - kThickening, w.j0, w.j1); j < j1; ++j) {
        for (std::int64_t i = first_index(box.x0 - kThickening, w.i0, w.i1); i < i1; ++i) {
          const auto place = static_cast<std::uint32_t>(w.place(i, j));
          if (solids.node[place] != kNoNode) continue;
          const Point2 p{static_cast<double>(i), static_cast<double>(j)};
          const double squared = squared_distance(p, a, b);
          if (squared < kThickening * kThickening) {
            found.push_back({squared, place, contour.solid});
          }
        }
      }
      last = next;
    }
  }
  std::sort(found.begin(), found.end(), [](const Near& x, const Near& y) {
    if (x.place != y.place) return x.place < y.place;
    return x.squared != y.squared ? x.squared < y.squared : x.solid < y.solid;
  });
  for (const Near& near : found) {
    if (solids.node[near.place] == kNoNode) solids.node[near.place] = near.solid;
  }
}

void count(LayerLabels& labels, std::size_t nodes) {
  labels.size.assign(nodes, 0);
  for (const std::uint32_t n : labels.node) {
    if (n != kNoNode) ++labels.size[n];
  }
}

// Regions too small to have a sample get the one nearest to their lowest vertex.
void give_one_each(const std::vector<LatticeContour>& contours, const LatticeWindow& w,
                   LayerLabels& solids) {
  for (const LatticeContour& contour : contours) {
    if (contour.hole != kNoNode || solids.size[contour.solid] > 0) continue;
    const Point2& lowest = lowest_vertex(contour.vertices);
    const std::int64_t i = first_index(lowest.x - 0.5, w.i0, w.i1 - 1);
    const std::int64_t j = first_index(lowest.y - 0.5, w.j0, w.j1 - 1);
    std::uint32_t& node = solids.node[w.place(i, j)];
    if (node != kNoNode && solids.size[node] == 1) continue;
    if (node != kNoNode) --solids.size[node];
    node = contour.solid;
    solids.size[node] = 1;
  }
}

}  // namespace

GivenLabels label_given(const GivenRegions& given, const LatticeWindow& window) {
  const std::vector<LatticeContour> contours = contours_of(given);
  GivenLabels labels;
  labels.solids.node.assign(window.size(), kNoNode);
  labels.voids.node.assign(window.size(), kExterior);
  label_rows(contours, window, labels);
  thicken(contours, window, labels.solids);
  count(labels.solids, given.regions.size());
  give_one_each(contours, window, labels.solids);
  const auto holes = std::count_if(contours.begin(), contours.end(),
                                   [](const auto& contour) { return contour.hole != kNoNode; });
  count(labels.voids, static_cast<std::size_t>(holes) + 1);
  labels.voids.size[kExterior] = kUnbounded;
  return labels;
}

}  // namespace tetloft::internal::between

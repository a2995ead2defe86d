#include "between/given_labels.hpp"

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <utility>

#include "between/segment_distance.hpp"
#include "core/buckets.hpp"
#include "motion/passed_rows.hpp"
#include "spatial/box_tree.hpp"

namespace tetloft::internal::between {

namespace {

using motion::first_index;
using motion::LatticeWindow;

// Parts thinner than this on both sides together have samples all the same.
constexpr double kThickening = 0.72;

const Point2& lowest_vertex(const std::vector<Point2>& vertices) {
  return *std::min_element(vertices.begin(), vertices.end(),
                           [](const Point2& a, const Point2& b) { return canonical_less(a, b); });
}

// Adds up the lengths of the runs of each node.
std::vector<std::size_t> sizes_of(const std::vector<LabelledRun>& runs, std::size_t nodes) {
  std::vector<std::size_t> size(nodes, 0);
  for (const LabelledRun& run : runs) size[run.node] += run.end - run.first;
  return size;
}

}  // namespace

class GivenLabels::Around {
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

// Calls visit(first place, place behind the last, what is around) for the samples of each row
// between two passages, none left out.
template <class Visit>
void GivenLabels::visit_runs(const Visit& visit) const {
  // From the sample on, its row is on the other side of the contour.
  struct Passage {
    std::int64_t j, i;
    std::uint32_t contour;
  };
  std::vector<Passage> passages;
  const LatticeWindow& w = window_;
  for (std::uint32_t c = 0; c < contours_.size(); ++c) {
    const std::vector<Point2>& vertices = contours_[c].vertices;
    Point2 last = vertices.back();
    for (const Point2& next : vertices) {
      motion::visit_passed(last, next, w, [&](std::int64_t i, std::int64_t j) {
        passages.push_back({j, i, c});
      });
      last = next;
    }
  }
  const Buckets rows(w.ny(), passages.size(),
                     [&](std::size_t p) { return static_cast<std::size_t>(passages[p].j - w.j0); });
  Around around(contours_);
  std::vector<Passage> row;
  for (std::size_t j = 0; j < w.ny(); ++j) {
    row.clear();
    for (const std::uint32_t p : rows[j]) row.push_back(passages[p]);
    std::sort(row.begin(), row.end(), [](const Passage& p, const Passage& q) {
      return p.i != q.i ? p.i < q.i : p.contour < q.contour;
    });
    const std::size_t begin = j * w.nx();
    std::size_t first = begin;
    for (const Passage& passage : row) {
      const std::size_t end = begin + static_cast<std::size_t>(passage.i - w.i0);
      if (first < end) visit(first, end, around);
      first = end;
      around.pass(passage.contour);
    }
    if (first < begin + w.nx()) visit(first, begin + w.nx(), around);
  }
}

// The samples in no region that are near one, each as a run of the nearest.
std::vector<LabelledRun> GivenLabels::samples_beside(const std::vector<LabelledRun>& runs) const {
  struct Near {
    double squared;
    std::uint32_t place, solid;
  };
  std::vector<Near> found;
  const LatticeWindow& w = window_;
  RunCursor within(runs, w);
  for (const LatticeContour& contour : contours_) {
    Point2 last = contour.vertices.back();
    for (const Point2& next : contour.vertices) {
      // From one order of the ends, whichever way the contour runs.
      const bool forward = canonical_less(last, next);
      const Point2& a = forward ? last : next;
      const Point2& b = forward ? next : last;
      const Box2 box = box_of(a, b);
      const std::int64_t i0 = first_index(box.x0 - kThickening, w.i0, w.i1);
      const std::int64_t i1 = first_index(box.x1 + kThickening, w.i0, w.i1);
      const std::int64_t j1 = first_index(box.y1 + kThickening, w.j0, w.j1);
      for (std::int64_t j = first_index(box.y0 - kThickening, w.j0, w.j1); j < j1; ++j) {
        for (std::int64_t i = i0; i < i1; ++i) {
          const auto place = static_cast<std::uint32_t>(w.place(i, j));
          if (within.node_at(static_cast<std::size_t>(j - w.j0), place) != kNoNode) continue;
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
  std::vector<LabelledRun> beside;
  for (const Near& near : found) {
    if (!beside.empty() && beside.back().first == near.place) continue;
    beside.push_back({near.place, near.place + 1, near.solid});
  }
  return beside;
}

// Regions too small to have a sample get the one nearest to their lowest vertex, if it can be
// spared.
void GivenLabels::give_one_each() {
  const auto is_empty = [&](const LatticeContour& contour) {
    return contour.hole == kNoNode && solids_.size[contour.solid] == 0;
  };
  if (std::none_of(contours_.begin(), contours_.end(), is_empty)) return;
  std::vector<std::uint32_t> node = solids_.nodes(window_.size());
  for (const LatticeContour& contour : contours_) {
    if (!is_empty(contour)) continue;
    const Point2& lowest = lowest_vertex(contour.vertices);
    const std::int64_t i = first_index(lowest.x - 0.5, window_.i0, window_.i1 - 1);
    const std::int64_t j = first_index(lowest.y - 0.5, window_.j0, window_.j1 - 1);
    std::uint32_t& at = node[window_.place(i, j)];
    if (at != kNoNode && solids_.size[at] == 1) continue;
    if (at != kNoNode) --solids_.size[at];
    at = contour.solid;
    solids_.size[at] = 1;
  }
  solids_.runs = runs_of(window_, node);
}

// By their lowest vertices, so that nothing depends on their order in the section.
void GivenLabels::add_contours(const GivenRegions& given) {
  IdVector<RegionId, std::uint32_t> node(given.nesting.outer.size(), kNoNode);
  for (std::uint32_t n = 0; n < given.regions.size(); ++n) node[given.regions[n]] = n;
  std::vector<std::pair<Point2, ContourId>> members;
  for (const ContourId c : given.section.contours.ids()) {
    if (node[given.nesting.region[c]] == kNoNode) continue;
    members.emplace_back(lowest_vertex(given.section.contours[c].vertices), c);
  }
  std::sort(members.begin(), members.end(),
            [](const auto& a, const auto& b) { return canonical_less(a.first, b.first); });
  for (const auto& [lowest, c] : members) {
    LatticeContour& contour = contours_.emplace_back();
    contour.solid = node[given.nesting.region[c]];
    contour.depth = given.nesting.depth[c];
    if (contour.depth % 2 == 1) contour.hole = kExterior + static_cast<std::uint32_t>(++holes_);
    for (const Point2& p : given.section.contours[c].vertices) {
      contour.vertices.push_back({p.x / given.step, p.y / given.step});
    }
  }
}

GivenLabels::GivenLabels(const GivenRegions& given, const LatticeWindow& window) : window_(window) {
  add_contours(given);
  std::vector<LabelledRun> within;
  visit_runs([&](std::size_t first, std::size_t end, const Around& around) {
    const std::uint32_t solid = around.solid();
    if (solid == kNoNode) return;
    within.push_back({static_cast<std::uint32_t>(first), static_cast<std::uint32_t>(end), solid});
  });
  const std::vector<LabelledRun> beside = samples_beside(within);
  std::merge(within.begin(), within.end(), beside.begin(), beside.end(),
             std::back_inserter(solids_.runs),
             [](const LabelledRun& a, const LabelledRun& b) { return a.first < b.first; });
  solids_.size = sizes_of(solids_.runs, given.regions.size());
  give_one_each();
}

LayerLabels GivenLabels::voids() const {
  LayerLabels labels;
  visit_runs([&](std::size_t first, std::size_t end, const Around& around) {
    if (around.hole() == kNoNode) return;
    labels.runs.push_back(
        {static_cast<std::uint32_t>(first), static_cast<std::uint32_t>(end), around.hole()});
  });
  labels.size = sizes_of(labels.runs, holes_ + 1);
  labels.size[kExterior] = kUnbounded;
  return labels;
}

}  // namespace tetloft::internal::between

#include "between/shared_samples.hpp"

#include <algorithm>
#include <cstdint>
#include <limits>
#include <span>
#include <utility>

namespace tetloft::internal::between {

namespace {

bool is_lone(const LayerPair& pair) {
  return pair.below.size.size() == 1 && pair.above.size.size() == 1;
}

// Samples that nodes share, as they are found.
class Shares {
 public:
  void add(const LayerEdge& nodes, std::size_t samples) {
    if (runs_.empty() || runs_.back().nodes != nodes) runs_.push_back({nodes});
    runs_.back().samples += samples;
  }
  /// Of two nodes only, with enough of them: how many more there are does not matter.
  [[nodiscard]] bool suffice(const LayerPair& pair) const {
    return is_lone(pair) && !runs_.empty() && pair.is_edge(runs_.back());
  }
  /// Of each two nodes; sorted.
  [[nodiscard]] std::vector<SharedSamples> summed() && {
    std::sort(runs_.begin(), runs_.end(),
              [](const SharedSamples& a, const SharedSamples& b) { return a.nodes < b.nodes; });
    std::vector<SharedSamples> result;
    for (const SharedSamples& run : runs_) {
      if (result.empty() || result.back().nodes != run.nodes) result.push_back({run.nodes});
      result.back().samples += run.samples;
    }
    return result;
  }

 private:
  std::vector<SharedSamples> runs_;
};

void share_at_rest(const LayerPair& pair, Shares& shares) {
  auto low = pair.below.runs.begin();
  auto high = pair.above.runs.begin();
  while (low != pair.below.runs.end() && high != pair.above.runs.end()) {
    const std::uint32_t first = std::max(low->first, high->first);
    const std::uint32_t end = std::min(low->end, high->end);
    if (first < end) {
      shares.add({low->node, high->node}, end - first);
      if (shares.suffice(pair)) return;
    }
    if (low->end == end) ++low;
    if (high->end == end) ++high;
  }
}

// Rows and columns of a window, from its first sample on.
struct Bounds {
  std::size_t i0 = std::numeric_limits<std::size_t>::max(), j0 = i0;
  std::size_t i1 = 0, j1 = 0;

  void add(const Bounds& b) {
    *this = {std::min(i0, b.i0), std::min(j0, b.j0), std::max(i1, b.i1), std::max(j1, b.j1)};
  }
  [[nodiscard]] Bounds common(const Bounds& b) const {
    return {std::max(i0, b.i0), std::max(j0, b.j0), std::min(i1, b.i1), std::min(j1, b.j1)};
  }
  [[nodiscard]] Bounds widened(std::size_t by, std::size_t nx, std::size_t ny) const {
    if (i1 == 0) return *this;
    return {i0 - std::min(i0, by), j0 - std::min(j0, by), std::min(i1 + by, nx),
            std::min(j1 + by, ny)};
  }
};

// Of the samples of all nodes but the exterior.
Bounds bounds_of(const LayerLabels& labels, std::size_t nx) {
  Bounds bounds;
  for (const LabelledRun& run : labels.runs) {
    if (labels.size[run.node] == kUnbounded) continue;
    const std::size_t i = run.first % nx;
    const std::size_t j = run.first / nx;
    bounds.add({i, j, i + (run.end - run.first), j + 1});
  }
  return bounds;
}

class MovedPair {
 public:
  MovedPair(const LayerPair& pair, double share)
      : pair_(pair),
        nx_(pair.shape.window.nx()),
        ny_(pair.shape.window.ny()),
        below_(pair.below.runs, pair.shape.window),
        above_(pair.above.runs, pair.shape.window),
        share_(share),
        by_(farthest()),
        until_(nx_, 0),
        outside_(pair.kind == NodeKind::solid ? kNoNode : kExterior) {}

  void share(Shares& shares) {
    const Bounds where = looked_at();
    if (pair_.kind == NodeKind::empty) share_exterior(shares);
    std::size_t seen = where.j0 - std::min(where.j0, by_);  // rows, from there on
    for (std::size_t j = where.j0; j < where.j1 && !shares.suffice(pair_); ++j) {
      for (; seen < std::min(j + by_ + 1, ny_); ++seen) see_row(seen);
      for (std::size_t i = where.i0; i < where.i1; ++i) {
        if (j >= until_[i]) continue;
        const Moved at = moved(i, j);
        const std::uint32_t below = node_at(below_, at.below);
        if (below == kNoNode) continue;
        const std::uint32_t above = node_at(above_, at.above);
        if (above != kNoNode) shares.add({below, above}, 1);
      }
    }
  }

 private:
  // No sample is moved by more, in samples along an axis, to the nearest one.
  [[nodiscard]] std::size_t farthest() const {
    const double most = std::min(share_ * pair_.longest, static_cast<double>(std::max(nx_, ny_)));
    return static_cast<std::size_t>(most) + 2;
  }

  // Where samples of which the number counts may be moved from: those of two solids, or of a void
  // that is not the exterior.
  [[nodiscard]] Bounds looked_at() const {
    const Bounds below = bounds_of(pair_.below, nx_).widened(by_, nx_, ny_);
    const Bounds above = bounds_of(pair_.above, nx_).widened(by_, nx_, ny_);
    if (pair_.kind == NodeKind::solid) return below.common(above);
    Bounds both = below;
    both.add(above);
    return both;
  }
  // The same, for the samples of a row: what is moved from no solid below counts no more.
  void see_row(std::size_t row) {
    see(below_.in_row(row), pair_.below, row);
    if (pair_.kind == NodeKind::empty) see(above_.in_row(row), pair_.above, row);
  }
  void see(std::span<const LabelledRun> runs, const LayerLabels& labels, std::size_t row) {
    for (const LabelledRun& run : runs) {
      if (labels.size[run.node] == kUnbounded) continue;
      const std::size_t first = run.first - row * nx_;
      const std::size_t end = run.end - row * nx_;
      std::fill(until_.begin() + static_cast<std::ptrdiff_t>(first - std::min(first, by_)),
                until_.begin() + static_cast<std::ptrdiff_t>(std::min(end + by_, nx_)),
                row + by_ + 1);
    }
  }

  // Whether the exteriors have a sample in common, which is enough: nearly always the first one.
  void share_exterior(Shares& shares) {
    for (std::size_t j = 0; j < ny_; ++j) {
      for (std::size_t i = 0; i < nx_; ++i) {
        const Moved at = moved(i, j);
        if (node_at(below_, at.below) != kExterior || node_at(above_, at.above) != kExterior)
          continue;
        shares.add({kExterior, kExterior}, 1);
        return;
      }
    }
  }

  // Where a sample is moved from.
  struct Moved {
    Point2 below, above;
  };
  [[nodiscard]] Moved moved(std::size_t i, std::size_t j) const {
    const Point2& u = pair_.shape.motion[j * nx_ + i];
    const Point2 by{share_ * u.x, share_ * u.y};
    const auto x = static_cast<double>(i);
    const auto y = static_cast<double>(j);
    return {{x - by.x, y - by.y}, {x + by.x, y + by.y}};
  }

  // The node at a place, from the first sample of the window on, to the nearest one: halves go up.
  [[nodiscard]] std::uint32_t node_at(RunCursor& runs, const Point2& p) const {
    const double i = p.x + 0.5;
    const double j = p.y + 0.5;
    if (!(i >= 0 && j >= 0 && i < static_cast<double>(nx_) && j < static_cast<double>(ny_))) {
      return outside_;
    }
    const auto row = static_cast<std::size_t>(static_cast<std::int64_t>(j));
    return runs.node_at(row, row * nx_ + static_cast<std::size_t>(static_cast<std::int64_t>(i)));
  }

  const LayerPair& pair_;
  std::size_t nx_, ny_;
  RunCursor below_, above_;
  double share_;
  std::size_t by_;
  std::vector<std::size_t> until_;  // by column: rows before are looked at, of those seen by now
  std::uint32_t outside_;           // the node beyond the window
};

}  // namespace

bool LayerPair::is_edge(const SharedSamples& shared) const {
  const std::size_t smaller =
      std::min(below.size[shared.nodes.first], above.size[shared.nodes.second]);
  if (smaller == kUnbounded) return true;
  return kind == NodeKind::solid ? 50 * shared.samples >= smaller : 10 * shared.samples > smaller;
}

std::vector<SharedSamples> shared_samples(const LayerPair& pair, double share) {
  Shares shares;
  if (share == 0 || pair.shape.motion.empty()) {
    share_at_rest(pair, shares);
  } else {
    MovedPair(pair, share).share(shares);
  }
  return std::move(shares).summed();
}

}  // namespace tetloft::internal::between

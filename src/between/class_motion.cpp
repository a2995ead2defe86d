// At every node all displacements in a disc are tried: how far the moved sections differ around it.
#include "between/class_motion.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>

#include "between/smoother.hpp"
#include "motion/distance_samples.hpp"
#include "spatial/box_tree.hpp"

namespace tetloft::internal::between {

namespace {

using motion::DistanceSamples;
using motion::kStepsPerGap;
using motion::LatticeEdges;
using motion::LatticeWindow;

// Nodes are every fourth sample, a gap apart; as far around the class, in samples, motion is looked
// for. What sections differ in is looked at tile by tile, as many nodes along each axis.
constexpr std::int64_t kStride = 4;
constexpr std::int64_t kTile = 16;
// As many nodes are sampled at once: what lies around them is sampled again for the next ones, so
// there are several tiles; their samples take some megabytes.
constexpr std::int64_t kBlock = 4 * kTile;
constexpr double kAround = 2 * kStepsPerGap;
constexpr double kNodesPerGap = static_cast<double>(kStepsPerGap) / kStride;
// All from here on settled by measurement, and flat: README. Both sections are moved by whole
// samples, half of the motion each: motions are half gaps, up to 1.12 gaps long.
constexpr std::int64_t kLongest2 = 5;
constexpr double kSigma = 0.8;     // of what counts around a node, in gaps
constexpr double kEvenness = 1.0;  // motions are smoothed by as much, in gaps
constexpr double kStiffness = 0.01;
constexpr double kNeighbours = 0.5;
// Misfits as much above the least, in gaps squared, weigh a sixteenth.
constexpr double kMisfitTolerance = 0.01;
// A class does not move if both sections share as much of what either covers.
constexpr double kAtRest = 0.95;
// A section farther beyond the slab, in gaps, says nothing of it.
constexpr double kFarthestNeighbour = 2;

// Half a motion, in samples.
struct Half {
  std::int64_t i = 0, j = 0;
};

std::vector<Half> all_halves() {
  std::vector<Half> halves;
  for (std::int64_t length2 = 0; length2 <= kLongest2; ++length2) {
    for (std::int64_t i = -kLongest2; i <= kLongest2; ++i) {
      for (std::int64_t j = -kLongest2; j <= kLongest2; ++j) {
        if (i * i + j * j == length2) halves.push_back({i, j});
      }
    }
  }
  return halves;
}

// n samples of a row, kStride apart, from (i, j) on; bilinear between samples.
void take_row(const DistanceSamples& samples, double i, double j, std::vector<double>& out) {
  const double fi = std::floor(i);
  const double fj = std::floor(j);
  const double fx = i - fi;
  const double fy = j - fj;
  const double* row = samples.at(static_cast<std::int64_t>(fi), static_cast<std::int64_t>(fj));
  if (fx == 0 && fy == 0) {
    for (double& value : out) {
      value = *row;
      row += kStride;
    }
    return;
  }
  const std::size_t nx = samples.window.nx();
  for (double& value : out) {
    const double low = row[0] + fx * (row[1] - row[0]);
    const double high = row[nx] + fx * (row[nx + 1] - row[nx]);
    value = low + fy * (high - low);
    row += kStride;
  }
}

LatticeWindow samples_of(const LatticeWindow& nodes) {
  return {nodes.i0 * kStride, nodes.j0 * kStride, nodes.i1 * kStride, nodes.j1 * kStride};
}

// Parts of a window, as long as `side` along each axis, row by row.
std::vector<LatticeWindow> tiles_of(const LatticeWindow& nodes, std::int64_t side) {
  std::vector<LatticeWindow> tiles;
  for (std::int64_t j = nodes.j0; j < nodes.j1; j += side) {
    for (std::int64_t i = nodes.i0; i < nodes.i1; i += side) {
      tiles.push_back({i, j, std::min(i + side, nodes.i1), std::min(j + side, nodes.j1)});
    }
  }
  return tiles;
}

// Are there different values in a part of the samples?
bool varies(const DistanceSamples& samples, const LatticeWindow& part) {
  const double first = *samples.at(part.i0, part.j0);
  for (std::int64_t j = part.j0; j < part.j1; ++j) {
    const double* const row = samples.at(part.i0, j);
    if (std::any_of(row, row + part.nx(), [=](double d) { return d != first; })) return true;
  }
  return false;
}

// How many samples of a row are inside in both sections.
std::int64_t shared_length(std::span<const motion::InsideSamples::Run> lower,
                           std::span<const motion::InsideSamples::Run> upper) {
  std::int64_t shared = 0;
  for (auto low = lower.begin(), high = upper.begin(); low != lower.end() && high != upper.end();) {
    shared += std::max(std::min(low->end, high->end) - std::max(low->first, high->first),
                       std::int64_t{0});
    if (low->end < high->end) {
      ++low;
    } else {
      ++high;
    }
  }
  return shared;
}

std::int64_t length(std::span<const motion::InsideSamples::Run> runs) {
  std::int64_t sum = 0;
  for (const auto& run : runs) sum += run.end - run.first;
  return sum;
}

// The class's distances in a slab, in quarters of the gap, one gap at most.
class Fit {
 public:
  explicit Fit(const ClassOutlines& outlines) {
    const double gap = *outlines.z[upper] - *outlines.z[lower];
    for (const Around s : {behind, lower, upper, beyond}) {
      edges_[s] = LatticeEdges(outlines.contours[s], gap / kStepsPerGap);
    }
    if (outlines.z[behind]) back_ = (*outlines.z[lower] - *outlines.z[behind]) / gap;
    if (outlines.z[beyond]) on_ = (*outlines.z[beyond] - *outlines.z[upper]) / gap;
    share_ = {-1 - 2 * back_, -1, 1, 1 + 2 * on_};
    tells_ = {!edges_[behind].empty() && back_ <= kFarthestNeighbour, !edges_[lower].empty(),
              !edges_[upper].empty(), !edges_[beyond].empty() && on_ <= kFarthestNeighbour};
    Box2 box = edges_[lower].box();
    box.add(edges_[upper].box());
    const auto first = [](double at) {
      return static_cast<std::int64_t>(std::floor((at - kAround) / kStride));
    };
    const auto end = [](double at) {
      return static_cast<std::int64_t>(std::floor((at + kAround) / kStride)) + 2;
    };
    nodes_ = {first(box.x0), first(box.y0), end(box.x1), end(box.y1)};
  }

  // All nodes.
  [[nodiscard]] const LatticeWindow& nodes() const { return nodes_; }
  [[nodiscard]] bool tells() const {
    return (tells_[behind] && tells_[lower]) || (tells_[lower] && tells_[upper]) ||
           (tells_[upper] && tells_[beyond]);
  }
  [[nodiscard]] bool at_rest() const {
    if (is_lone()) return false;
    const LatticeWindow window = samples_of(nodes_);
    const motion::InsideSamples in_lower(edges_[lower], window);
    const motion::InsideSamples in_upper(edges_[upper], window);
    std::int64_t both = 0;
    std::int64_t either = 0;
    for (std::int64_t j = window.j0; j < window.j1; ++j) {
      const std::int64_t shared = shared_length(in_lower.row(j), in_upper.row(j));
      both += shared;
      either += length(in_lower.row(j)) + length(in_upper.row(j)) - shared;
    }
    return static_cast<double>(both) >= kAtRest * static_cast<double>(either);
  }

  // Samples what is looked at of these nodes and of all among them.
  void sample(const LatticeWindow& nodes) {
    for (std::size_t s = 0; s < 4; ++s) {
      if (tells_[s]) samples_[s] = sample_distances(edges_[s], looked_at(nodes, s));
    }
  }

  // Turns to some nodes that were sampled. False if there is nothing to see: all is far inside or
  // far outside.
  bool look_at(const LatticeWindow& nodes) {
    tile_ = nodes;
    bool seen = false;
    for (std::size_t s = 0; s < 4; ++s) {
      if (!tells_[s]) continue;
      row_[s].resize(nodes.nx());
      seen = seen || varies(samples_[s], looked_at(nodes, s));
    }
    return seen;
  }

  // By node: the squared differences of neighbouring sections, both moved to there, summed.
  void squares(const Half& half, std::vector<double>& square) {
    square.assign(tile_.size(), 0);
    for (std::int64_t j = tile_.j0; j < tile_.j1; ++j) {
      for (std::size_t s = 0; s < 4; ++s) {
        if (!tells_[s]) continue;
        const double x = static_cast<double>(tile_.i0 * kStride);
        const double y = static_cast<double>(j * kStride);
        take_row(samples_[s], x + share_[s] * static_cast<double>(half.i),
                 y + share_[s] * static_cast<double>(half.j), row_[s]);
      }
      double* const out = square.data() + tile_.place(tile_.i0, j);
      for (const Around s : {lower, behind, upper}) {
        if (!tells_[s] || !tells_[s + 1]) continue;
        const double weight = s == lower || is_lone() ? 1 : kNeighbours;
        for (std::size_t k = 0; k < row_[s].size(); ++k) {
          const double e = row_[s + 1][k] - row_[s][k];
          out[k] += weight * (e * e);
        }
      }
    }
  }

 private:
  // The samples of a section that some half of a motion moves to one of these nodes.
  [[nodiscard]] LatticeWindow looked_at(const LatticeWindow& nodes, std::size_t s) const {
    const double longest = std::sqrt(static_cast<double>(kLongest2));
    const auto margin = static_cast<std::int64_t>(std::ceil(std::abs(share_[s]) * longest)) + 1;
    return samples_of(nodes).widened(margin);
  }

  // In one section of the slab only.
  [[nodiscard]] bool is_lone() const { return !tells_[lower] || !tells_[upper]; }

  std::array<LatticeEdges, 4> edges_;
  double back_ = 0, on_ = 0;       // the neighbours' distances, in gaps
  std::array<double, 4> share_{};  // of half a motion, from the middle of the slab on
  std::array<bool, 4> tells_{};
  std::array<DistanceSamples, 4> samples_;
  std::array<std::vector<double>, 4> row_;
  LatticeWindow nodes_, tile_;
};

// By half motion and node, in quarters of the gap, squared.
using Misfits = std::vector<std::vector<double>>;

void measure_misfits(Fit& fit, const LatticeWindow& nodes, const std::vector<Half>& halves,
                     Smoother& around, Misfits& misfit) {
  misfit.resize(halves.size());
  for (std::size_t m = 0; m < halves.size(); ++m) {
    fit.squares(halves[m], misfit[m]);
    around.smooth(misfit[m], nodes.nx(), nodes.ny());
    const auto length2 = static_cast<double>(halves[m].i * halves[m].i + halves[m].j * halves[m].j);
    for (double& e : misfit[m]) e += kStiffness * (4 * length2);
  }
}

// What a node says of the motion, in samples.
struct Vote {
  Point2 motion;
  double weight = 0;
};

// The mean of the motions, the more weight the less misfit. It counts by how far misfits differ.
Vote vote_of(const std::vector<Half>& halves, const Misfits& misfit, std::size_t node) {
  double least = misfit.front()[node];
  double all = 0;
  for (const std::vector<double>& e : misfit) {
    least = std::min(least, e[node]);
    all += e[node];
  }
  constexpr double kScale = 1 / (kMisfitTolerance * kStepsPerGap * kStepsPerGap);
  double sum = 0;
  Point2 mean;
  for (std::size_t m = 0; m < halves.size(); ++m) {
    const double above = 1 + (misfit[m][node] - least) * kScale;
    const double weight = 1 / (above * above * (above * above));
    sum += weight;
    mean.x += weight * static_cast<double>(2 * halves[m].i);
    mean.y += weight * static_cast<double>(2 * halves[m].j);
  }
  return {{mean.x / sum, mean.y / sum}, all / static_cast<double>(misfit.size()) - least};
}

// Where between two of [low, end) a coordinate lies: the lower one, and how far on.
std::pair<std::int64_t, double> place_between(double at, std::int64_t low, std::int64_t end) {
  const double on = at - static_cast<double>(low);
  const double last = static_cast<double>(end - low - 1);
  if (!(on > 0)) return {low, 0.0};
  if (on >= last) return {end - 2, 1.0};
  const auto whole = static_cast<std::int64_t>(on);
  return {low + whole, on - static_cast<double>(whole)};
}

Point2 part_of_way(const Point2& from, const Point2& to, double share) {
  return {from.x + share * (to.x - from.x), from.y + share * (to.y - from.y)};
}

}  // namespace

Point2 MotionField::at(const Point2& p) const {
  const auto [i, fx] = place_between(p.x / spacing, window.i0, window.i1);
  const auto [j, fy] = place_between(p.y / spacing, window.j0, window.j1);
  const Point2* const low = node.data() + window.place(i, j);
  const Point2* const high = low + window.nx();
  return part_of_way(part_of_way(low[0], low[1], fx), part_of_way(high[0], high[1], fx), fy);
}

std::vector<Point2> MotionField::at_samples(const motion::LatticeWindow& samples,
                                            double step) const {
  std::vector<std::pair<std::int64_t, double>> columns;
  for (std::int64_t i = samples.i0; i < samples.i1; ++i) {
    columns.push_back(place_between(static_cast<double>(i) * step / spacing, window.i0, window.i1));
  }
  std::vector<Point2> result(samples.size());
  auto next = result.begin();
  // At the columns, on the rows of nodes below and above; for one row of cells after the other.
  std::vector<Point2> below(columns.size());
  std::vector<Point2> above(columns.size());
  std::optional<std::int64_t> cells;
  for (std::int64_t j = samples.j0; j < samples.j1; ++j) {
    const auto [row, fy] =
        place_between(static_cast<double>(j) * step / spacing, window.j0, window.j1);
    if (row != cells) {
      for (std::size_t k = 0; k < columns.size(); ++k) {
        const Point2* const low = node.data() + window.place(columns[k].first, row);
        const Point2* const high = low + window.nx();
        below[k] = part_of_way(low[0], low[1], columns[k].second);
        above[k] = part_of_way(high[0], high[1], columns[k].second);
      }
      cells = row;
    }
    for (std::size_t k = 0; k < columns.size(); ++k) {
      *next++ = part_of_way(below[k], above[k], fy);
    }
  }
  return result;
}

std::optional<MotionField> estimate_motion(const ClassOutlines& outlines) {
  Fit fit(outlines);
  if (!fit.tells() || fit.at_rest()) return std::nullopt;
  const std::vector<Half> halves = all_halves();
  const LatticeWindow& nodes = fit.nodes();
  const double step = (*outlines.z[upper] - *outlines.z[lower]) / kStepsPerGap;
  std::vector<double> x(nodes.size(), 0);
  std::vector<double> y(nodes.size(), 0);
  std::vector<double> weight(nodes.size(), 0);
  Smoother around(kSigma * kNodesPerGap, Smoother::Outside::zero);
  Misfits misfit;
  for (const LatticeWindow& block : tiles_of(nodes, kBlock)) {
    fit.sample(block.widened(around.reach()));
    for (const LatticeWindow& tile : tiles_of(block, kTile)) {
      const LatticeWindow wide = tile.widened(around.reach());
      if (!fit.look_at(wide)) continue;
      measure_misfits(fit, wide, halves, around, misfit);
      for (std::int64_t j = tile.j0; j < tile.j1; ++j) {
        for (std::int64_t i = tile.i0; i < tile.i1; ++i) {
          const Vote vote = vote_of(halves, misfit, wide.place(i, j));
          const std::size_t k = nodes.place(i, j);
          x[k] = vote.weight * vote.motion.x;
          y[k] = vote.weight * vote.motion.y;
          weight[k] = vote.weight;
        }
      }
    }
  }
  Smoother even(kEvenness * kNodesPerGap, Smoother::Outside::zero);
  for (std::vector<double>* of_nodes : {&x, &y, &weight}) {
    even.smooth(*of_nodes, nodes.nx(), nodes.ny());
  }
  MotionField field{nodes, step * kStride, std::vector<Point2>(nodes.size())};
  for (std::size_t k = 0; k < nodes.size(); ++k) {
    if (weight[k] > 0) field.node[k] = {x[k] / weight[k] * step, y[k] / weight[k] * step};
  }
  return field;
}

}  // namespace tetloft::internal::between

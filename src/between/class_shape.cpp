#include "between/class_shape.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "between/class_motion.hpp"
#include "between/section_cubic.hpp"
#include "motion/distance_samples.hpp"
#include "spatial/box_tree.hpp"

namespace tetloft::internal::between {

namespace {

using motion::DistanceSamples;
using motion::LatticeEdges;
using motion::LatticeWindow;

// Distances are followed as far, in gaps, but no farther than as many sides of the class.
constexpr double kReach = 0.7;
constexpr double kWidest = 4;
// Between two sections a class grows beyond both by less than this part of the reach.
constexpr double kOvergrowth = 0.4;
// In steps: samples as near to the given outlines are in the window.
constexpr double kMargin = 2;
// No value is 0: samples on an outline count as this far from it, in steps.
constexpr double kOnOutline = 0x1p-30;
// Doubles measure to a fraction of a step below this, in steps.
constexpr double kLargestUnits = 0x1p40;

bool fits(const Box2& box) {
  return std::min(box.x0, box.y0) > -kLargestUnits && std::max(box.x1, box.y1) < kLargestUnits;
}

LatticeWindow window_around(const Box2& box, double margin) {
  return {static_cast<std::int64_t>(std::floor(box.x0 - margin)),
          static_cast<std::int64_t>(std::floor(box.y0 - margin)),
          static_cast<std::int64_t>(std::floor(box.x1 + margin)) + 2,
          static_cast<std::int64_t>(std::floor(box.y1 + margin)) + 2};
}

LatticeWindow common(const LatticeWindow& a, const LatticeWindow& b) {
  const LatticeWindow w{std::max(a.i0, b.i0), std::max(a.j0, b.j0), std::min(a.i1, b.i1),
                        std::min(a.j1, b.j1)};
  return w.i0 < w.i1 && w.j0 < w.j1 ? w : LatticeWindow{};
}

// Signed distances of one section at any place; those outside the samples are `far`.
struct DistanceField {
  DistanceSamples samples;
  double far = 0;

  [[nodiscard]] double at(std::int64_t i, std::int64_t j) const {
    const LatticeWindow& w = samples.window;
    if (i < w.i0 || i >= w.i1 || j < w.j0 || j >= w.j1) return far;
    return *samples.at(i, j);
  }
  [[nodiscard]] double at(double x, double y) const {
    const LatticeWindow& w = samples.window;
    const double on_x = x - static_cast<double>(w.i0);
    const double on_y = y - static_cast<double>(w.j0);
    if (!(on_x >= 0 && on_y >= 0)) return far;
    if (!(on_x < static_cast<double>(w.i1 - w.i0 - 1))) return far;
    if (!(on_y < static_cast<double>(w.j1 - w.j0 - 1))) return far;
    const auto i = static_cast<std::int64_t>(on_x);
    const auto j = static_cast<std::int64_t>(on_y);
    const double fx = on_x - static_cast<double>(i);
    const double fy = on_y - static_cast<double>(j);
    const double* const low = samples.at(w.i0 + i, w.j0 + j);
    const double* const high = low + w.nx();
    const double a = low[0] + fx * (low[1] - low[0]);
    const double b = high[0] + fx * (high[1] - high[0]);
    return a + fy * (b - a);
  }
};

double never_zero(double v) { return v == 0 ? kOnOutline : v; }

template <class Value>
std::vector<Value> part_of(const std::vector<Value>& all, const LatticeWindow& from,
                           const LatticeWindow& to) {
  std::vector<Value> part;
  part.reserve(to.size());
  for (std::int64_t j = to.j0; j < to.j1; ++j) {
    const auto row = all.begin() + static_cast<std::ptrdiff_t>(from.place(to.i0, j));
    part.insert(part.end(), row, row + static_cast<std::ptrdiff_t>(to.nx()));
  }
  return part;
}

// The samples inside in any layer, and those around them.
LatticeWindow inside_of(const ClassShape& shape, LatticeWindow inside) {
  const LatticeWindow& w = shape.window;
  for (const std::vector<double>& value : shape.value) {
    std::size_t k = 0;
    for (std::int64_t j = w.j0; j < w.j1; ++j) {
      for (std::int64_t i = w.i0; i < w.i1; ++i, ++k) {
        if (value[k] < 0) inside = inside.joined({i - 1, j - 1, i + 2, j + 2});
      }
    }
  }
  return inside;
}

void crop(ClassShape& shape, const LatticeWindow& to) {
  for (std::vector<double>& value : shape.value) value = part_of(value, shape.window, to);
  shape.motion = part_of(shape.motion, shape.window, to);
  shape.window = to;
}

// All in steps.
class Interpolation {
 public:
  Interpolation(const ClassOutlines& outlines, double step) {
    for (const Around s : {behind, lower, upper, beyond}) {
      edges_[s] = LatticeEdges(outlines.contours[s], step);
    }
    const double gap = *outlines.z[upper] - *outlines.z[lower];
    if (outlines.z[behind]) {
      beside_.behind = (*outlines.z[lower] - *outlines.z[behind]) / gap;
      beside_.ends_behind = edges_[behind].empty() && !edges_[lower].empty();
    }
    if (outlines.z[beyond]) {
      beside_.beyond = (*outlines.z[beyond] - *outlines.z[upper]) / gap;
      beside_.ends_beyond = edges_[beyond].empty() && !edges_[upper].empty();
    }
    share_ = {-beside_.behind.value_or(0), 0, 1, 1 + beside_.beyond.value_or(0)};
    box_ = edges_[lower].box();
    box_.add(edges_[upper].box());
    widest_ = kWidest * std::max(box_.x1 - box_.x0, box_.y1 - box_.y0);
    reach_ = std::max(std::min(kReach * (gap / step), widest_), 1.0);
  }

  [[nodiscard]] bool fits() const {
    return std::all_of(edges_.begin(), edges_.end(), [](const LatticeEdges& edges) {
      return edges.empty() || between::fits(edges.box());
    });
  }

  // The window in which the class may be if no motion is longer.
  [[nodiscard]] LatticeWindow window(double longest) const {
    return window_around(box_, kOvergrowth * reach_ + longest + kMargin);
  }
  // Motions much longer than the class is wide would cost more than they tell.
  [[nodiscard]] Point2 shortened(const Point2& u) const {
    return {std::clamp(u.x, -widest_, widest_), std::clamp(u.y, -widest_, widest_)};
  }

  // `motion` by samples of the window, none longer than `longest` along an axis.
  ClassShape shape(const std::vector<double>& at, std::vector<Point2> motion, double longest) {
    ClassShape result;
    result.window = window(longest);
    result.motion = std::move(motion);
    measure(result.window, longest);
    result.value.push_back(given(result.window, lower));
    for (const double share : at) result.value.push_back(layer(result, share));
    result.value.push_back(given(result.window, upper));
    crop(result, inside_of(result, window_around(box_, kMargin)));
    return result;
  }

 private:
  void measure(const LatticeWindow& window, double longest) {
    for (std::size_t s = 0; s < 4; ++s) {
      field_[s].far = reach_;
      if (edges_[s].empty()) continue;
      // Some gaps away nothing is near; farther off doubles do not measure.
      const double most = std::max(1 - share_[s], share_[s]) * longest;
      if (!(most < kLargestUnits)) continue;
      const LatticeWindow looked_at =
          window.widened(static_cast<std::int64_t>(std::ceil(most)) + 1);
      const LatticeWindow reached = window_around(edges_[s].box(), reach_ + 1);
      field_[s].samples = sample_distances(edges_[s], common(looked_at, reached), reach_);
    }
  }

  [[nodiscard]] std::vector<double> given(const LatticeWindow& w, Around s) const {
    std::vector<double> value;
    value.reserve(w.size());
    for (std::int64_t j = w.j0; j < w.j1; ++j) {
      for (std::int64_t i = w.i0; i < w.i1; ++i) value.push_back(never_zero(field_[s].at(i, j)));
    }
    return value;
  }

  [[nodiscard]] std::vector<double> layer(const ClassShape& result, double share) const {
    const SectionCubic cubic(share, beside_);
    const LatticeWindow& w = result.window;
    std::vector<double> value;
    value.reserve(w.size());
    auto motion = result.motion.begin();
    for (std::int64_t j = w.j0; j < w.j1; ++j) {
      for (std::int64_t i = w.i0; i < w.i1; ++i) {
        value.push_back(never_zero(between_sections(cubic, share, i, j, *motion++)));
      }
    }
    return value;
  }

  [[nodiscard]] double between_sections(const SectionCubic& cubic, double share, std::int64_t i,
                                        std::int64_t j, const Point2& u) const {
    const auto moved = [&](Around s) {
      if (u == Point2{}) return field_[s].at(i, j);
      const double by = share_[s] - share;
      return field_[s].at(static_cast<double>(i) + by * u.x, static_cast<double>(j) + by * u.y);
    };
    const double low = moved(lower);
    const double high = moved(upper);
    if (std::min(low, high) >= kOvergrowth * reach_) return std::min(low, high);
    if (std::max(low, high) <= -reach_) return -reach_;
    const double v = cubic.at({moved(behind), low, high, moved(beyond)});
    // What both sections share is not given up.
    return low < 0 && high < 0 ? std::min(v, 0.5 * std::max(low, high)) : v;
  }

  Beside beside_;
  std::array<double, 4> share_{};  // heights, in gaps
  std::array<LatticeEdges, 4> edges_;
  Box2 box_;           // of the class in the slab's sections
  double widest_ = 0;  // what counts as far for a class of that size
  double reach_ = 0;
  std::array<DistanceField, 4> field_;
};

}  // namespace

ClassShape interpolate(const ClassOutlines& outlines, double step, const std::vector<double>& at,
                       const std::optional<Point2>& rigid) {
  Interpolation interpolation(outlines, step);
  if (!interpolation.fits()) return {};
  // What moves by less than a step is not worth the looking.
  const bool moves = !rigid && *outlines.z[upper] - *outlines.z[lower] >= step;
  const std::optional<MotionField> field = moves ? estimate_motion(outlines) : std::nullopt;
  if (!field) {
    const Point2 u = rigid ? Point2{rigid->x / step, rigid->y / step} : Point2{};
    const double longest = std::max(std::abs(u.x), std::abs(u.y));
    return interpolation.shape(at, std::vector<Point2>(interpolation.window(longest).size(), u),
                               longest);
  }
  double longest = 0;
  for (const Point2& node : field->node) {
    const Point2 u = interpolation.shortened({node.x / step, node.y / step});
    longest = std::max({longest, std::abs(u.x), std::abs(u.y)});
  }
  const LatticeWindow w = interpolation.window(longest);
  std::vector<Point2> motion;
  motion.reserve(w.size());
  for (std::int64_t j = w.j0; j < w.j1; ++j) {
    for (std::int64_t i = w.i0; i < w.i1; ++i) {
      const Point2 u = field->at({static_cast<double>(i) * step, static_cast<double>(j) * step});
      motion.push_back(interpolation.shortened({u.x / step, u.y / step}));
    }
  }
  return interpolation.shape(at, std::move(motion), longest);
}

}  // namespace tetloft::internal::between

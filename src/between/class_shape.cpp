#include "between/class_shape.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>

#include "between/class_motion.hpp"
#include "between/layer_values.hpp"
#include "motion/distance_samples.hpp"
#include "spatial/box_tree.hpp"

namespace tetloft::internal::between {

namespace {

using motion::LatticeEdges;
using motion::LatticeWindow;

// Distances are followed as far, in gaps, but no farther than as many sides of the class.
constexpr double kReach = 0.7;
constexpr double kWidest = 4;
// In steps: samples as near to the given outlines are in the window.
constexpr double kMargin = 2;
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

// Keeps the values of a part of the window.
template <class Value>
void crop(std::vector<Value>& values, const LatticeWindow& from, const LatticeWindow& to) {
  auto kept = values.begin();
  for (std::int64_t j = to.j0; j < to.j1; ++j) {
    const auto row = values.begin() + static_cast<std::ptrdiff_t>(from.place(to.i0, j));
    kept = std::copy(row, row + static_cast<std::ptrdiff_t>(to.nx()), kept);
  }
  values.erase(kept, values.end());
}

// The samples inside in any layer, and those around them.
LatticeWindow inside_of(const ClassShape& shape, LatticeWindow inside) {
  const LatticeWindow& w = shape.window;
  const auto is_inside = [](double v) { return v < 0; };
  for (const std::vector<double>& value : shape.value) {
    for (std::int64_t j = w.j0; j < w.j1; ++j) {
      const auto row = value.begin() + static_cast<std::ptrdiff_t>(w.place(w.i0, j));
      const auto end = row + static_cast<std::ptrdiff_t>(w.nx());
      // Where the row is among those already, columns are looked at no farther than there.
      const bool known = inside.j0 < j && j + 1 < inside.j1;
      const auto first = std::find_if(row, known ? row + (inside.i0 + 1 - w.i0) : end, is_inside);
      if (first == end) continue;
      auto last = end;
      const auto least = known ? row + (inside.i1 - 1 - w.i0) : first + 1;
      while (last != least && !is_inside(*(last - 1))) --last;
      const std::int64_t i0 = w.i0 + (first - row);
      const std::int64_t i1 = w.i0 + (last - row);
      inside =
          inside.joined({i0 - 1, known ? inside.j0 : j - 1, i1 + 1, known ? inside.j1 : j + 2});
    }
  }
  return inside;
}

void crop(ClassShape& shape, const LatticeWindow& to) {
  for (std::vector<double>& value : shape.value) crop(value, shape.window, to);
  if (!shape.motion.empty()) crop(shape.motion, shape.window, to);
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
    Beside& beside = around_.beside;
    if (outlines.z[behind]) {
      beside.behind = (*outlines.z[lower] - *outlines.z[behind]) / gap;
      beside.ends_behind = edges_[behind].empty() && !edges_[lower].empty();
    }
    if (outlines.z[beyond]) {
      beside.beyond = (*outlines.z[beyond] - *outlines.z[upper]) / gap;
      beside.ends_beyond = edges_[beyond].empty() && !edges_[upper].empty();
    }
    around_.share = {-beside.behind.value_or(0), 0, 1, 1 + beside.beyond.value_or(0)};
    box_ = edges_[lower].box();
    box_.add(edges_[upper].box());
    widest_ = kWidest * std::max(box_.x1 - box_.x0, box_.y1 - box_.y0);
    around_.reach = std::max(std::min(kReach * (gap / step), widest_), 1.0);
  }

  [[nodiscard]] bool fits() const {
    return std::all_of(edges_.begin(), edges_.end(), [](const LatticeEdges& edges) {
      return edges.empty() || between::fits(edges.box());
    });
  }

  // The window in which the class may be if no motion is longer.
  [[nodiscard]] LatticeWindow window(double longest) const {
    return window_around(box_, kOvergrowth * around_.reach + longest + kMargin);
  }
  // Motions much longer than the class is wide would cost more than they tell.
  [[nodiscard]] Point2 shortened(const Point2& u) const {
    return {std::clamp(u.x, -widest_, widest_), std::clamp(u.y, -widest_, widest_)};
  }

  // `motion`: by samples of the window, none longer than `longest` along an axis; empty at rest.
  ClassShape shape(const std::vector<double>& at, std::vector<Point2> motion, double longest) {
    ClassShape result;
    result.window = window(longest);
    measure(result.window, longest);
    std::optional<WindowMotion> moves;
    if (!motion.empty()) moves.emplace(result.window, std::move(motion));
    result.value.push_back(given(result.window, lower));
    for (const double share : at) {
      result.value.push_back(
          layer_values(around_, result.window, moves ? &*moves : nullptr, share));
    }
    result.value.push_back(given(result.window, upper));
    if (moves) result.motion = std::move(*moves).of_samples();
    crop(result, inside_of(result, window_around(box_, kMargin)));
    return result;
  }

 private:
  void measure(const LatticeWindow& window, double longest) {
    const double reach = around_.reach;
    for (std::size_t s = 0; s < 4; ++s) {
      DistanceField& field = around_.field[s];
      field = DistanceField(reach);
      if (edges_[s].empty()) continue;
      // Some gaps away nothing is near; farther off doubles do not measure.
      const double share = around_.share[s];
      const double most = std::max(1 - share, share) * longest;
      if (!(most < kLargestUnits)) continue;
      const LatticeWindow looked_at =
          window.widened(static_cast<std::int64_t>(std::ceil(most)) + 1);
      const LatticeWindow reached = window_around(edges_[s].box(), reach + 1);
      field = DistanceField(sample_distances(edges_[s], common(looked_at, reached), reach), reach);
    }
  }

  [[nodiscard]] std::vector<double> given(const LatticeWindow& w, Around s) const {
    std::vector<double> value;
    value.reserve(w.size());
    std::vector<double> scratch;
    for (std::int64_t j = w.j0; j < w.j1; ++j) {
      const double* const row = around_.field[s].row(w.i0, w.i1, j, scratch);
      value.insert(value.end(), row, row + w.nx());
    }
    for (double& v : value) v = never_zero(v);
    return value;
  }

  std::array<LatticeEdges, 4> edges_;
  Box2 box_;           // of the class in the slab's sections
  double widest_ = 0;  // what counts as far for a class of that size
  FieldsAround around_;
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
    const std::size_t moved = u == Point2{} ? 0 : interpolation.window(longest).size();
    return interpolation.shape(at, std::vector<Point2>(moved, u), longest);
  }
  double longest = 0;
  for (const Point2& node : field->node) {
    const Point2 u = interpolation.shortened({node.x / step, node.y / step});
    longest = std::max({longest, std::abs(u.x), std::abs(u.y)});
  }
  const LatticeWindow w = interpolation.window(longest);
  std::vector<Point2> motion = field->at_samples(w, step);
  for (Point2& u : motion) u = interpolation.shortened({u.x / step, u.y / step});
  return interpolation.shape(at, std::move(motion), longest);
}

}  // namespace tetloft::internal::between

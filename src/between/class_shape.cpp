#include "between/class_shape.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "between/class_motion.hpp"
#include "motion/distance_samples.hpp"

namespace tetloft::internal::between {

namespace {

using motion::DistanceSamples;
using motion::LatticeEdges;
using motion::LatticeWindow;

constexpr double kTangent = 1.6;
constexpr double kCapOut = 1.0;   // gaps
constexpr double kReachIn = 1.0;  // gaps
constexpr double kEnd = 0.0;      // one-sided tangent: 0 chord, 1 parabola
// Between two sections a class may grow beyond both by as much, in gaps.
constexpr double kOvergrowth = 0.5;
// In steps: samples as near to the outlines are always in the window.
constexpr double kMargin = 2;
// No value is 0: samples on the outline count as this far outside, in steps.
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
  LatticeWindow w{std::max(a.i0, b.i0), std::max(a.j0, b.j0), std::min(a.i1, b.i1),
                  std::min(a.j1, b.j1)};
  if (w.i1 < w.i0 || w.j1 < w.j0) w = {a.i0, a.j0, a.i0, a.j0};
  return w;
}

// A section's signed distances at any point; outside `cap` at most.
struct Field {
  DistanceSamples samples;
  double cap = 0;

  [[nodiscard]] double sample(std::int64_t i, std::int64_t j) const {
    const LatticeWindow& w = samples.window;
    if (i < w.i0 || i >= w.i1 || j < w.j0 || j >= w.j1) return cap;
    return std::min(*samples.at(i, j), cap);
  }
  [[nodiscard]] double at(double x, double y) const {
    const double fi = std::floor(x);
    const double fj = std::floor(y);
    const double fx = x - fi;
    const double fy = y - fj;
    const auto i = static_cast<std::int64_t>(fi);
    const auto j = static_cast<std::int64_t>(fj);
    const double a = sample(i, j);
    const double b = sample(i + 1, j);
    const double c = sample(i, j + 1);
    const double d = sample(i + 1, j + 1);
    const double low = a + fx * (b - a);
    const double high = c + fx * (d - c);
    return low + fy * (high - low);
  }
};

// The cubic through the values of the slab's sections at shares of the gap.
class Cubic {
 public:
  Cubic(double t, std::optional<double> back, std::optional<double> on)
      : t_(t), back_(back), on_(on) {
    lower_ = kTangent * (t * ((1 - t) * (1 - t)));
    upper_ = kTangent * ((1 - t) * (t * t));
    if (back) lower_ /= 1 + *back;
    if (on) upper_ /= 1 + *on;
  }

  [[nodiscard]] double at(const std::array<double, 4>& p) const {
    const double chord = p[upper] - p[lower];
    double d0 = back_ ? (p[lower] - p[behind]) / *back_ - chord : 0.0;
    double d1 = on_ ? (p[beyond] - p[upper]) / *on_ - chord : 0.0;
    const double e0 = lower_ * d0;
    const double e1 = upper_ * d1;
    const double straight = (1 - t_) * p[lower] + t_ * p[upper];
    double v = straight + (e0 - e1);
    if (!back_ && on_) v -= kEnd * kTangent * (t_ * ((1 - t_) * (1 - t_))) * d1 / (1 + *on_);
    if (!on_ && back_) v += kEnd * kTangent * ((1 - t_) * (t_ * t_)) * d0 / (1 + *back_);
    if (p[lower] < 0 && p[upper] < 0) v = std::min(v, 0.5 * std::max(p[lower], p[upper]));
    return v;
  }

 private:
  double t_;
  std::optional<double> back_, on_;
  double lower_, upper_;
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

void crop(ClassShape& shape, const LatticeWindow& to) {
  for (std::vector<double>& value : shape.value) value = part_of(value, shape.window, to);
  shape.motion = part_of(shape.motion, shape.window, to);
  shape.window = to;
}

class Interpolation {
 public:
  Interpolation(const ClassOutlines& outlines, double step) : step_(step) {
    for (std::size_t s = 0; s < 4; ++s) edges_[s] = LatticeEdges(outlines.contours[s], step);
    gap_ = *outlines.z[upper] - *outlines.z[lower];
    if (outlines.z[behind]) back_ = (*outlines.z[lower] - *outlines.z[behind]) / gap_;
    if (outlines.z[beyond]) on_ = (*outlines.z[beyond] - *outlines.z[upper]) / gap_;
    share_ = {back_ ? -*back_ : 0, 0, 1, on_ ? 1 + *on_ : 1};
    gap_ /= step;
    box_ = edges_[lower].box();
    box_.add(edges_[upper].box());
  }

  [[nodiscard]] bool fits() const {
    return std::all_of(edges_.begin(), edges_.end(),
                       [](const LatticeEdges& e) { return between::fits(e.box()); });
  }

  ClassShape run(const std::vector<double>& at, const std::optional<MotionField>& field,
                 const Point2& rigid) {
    const double longest =
        field ? field->longest() / step_ : std::max(std::abs(rigid.x), std::abs(rigid.y));
    const LatticeWindow window = window_around(box_, kOvergrowth * gap_ + longest + kMargin);
    measure(window, longest);
    ClassShape shape;
    shape.window = window;
    shape.motion.assign(window.size(), rigid);
    if (field) {
      std::size_t k = 0;
      for (std::int64_t j = window.j0; j < window.j1; ++j) {
        for (std::int64_t i = window.i0; i < window.i1; ++i, ++k) {
          const Point2 u =
              field->at({static_cast<double>(i) * step_, static_cast<double>(j) * step_});
          shape.motion[k] = {u.x / step_, u.y / step_};
        }
      }
    }
    shape.value.push_back(given(window, lower));
    for (const double t : at) shape.value.push_back(layer(window, t, shape.motion));
    shape.value.push_back(given(window, upper));
    crop(shape, inner_window(shape));
    return shape;
  }

 private:
  void measure(const LatticeWindow& window, double longest) {
    const double reach = std::max(kReachIn, kCapOut) * gap_;
    for (std::size_t s = 0; s < 4; ++s) {
      field_[s].cap = kCapOut * gap_;
      if (edges_[s].empty()) continue;
      const double far = std::max(1 - share_[s], share_[s]);
      const LatticeWindow needed =
          window.widened(static_cast<std::int64_t>(std::ceil(far * longest)) + 1);
      field_[s].samples =
          sample_distances(edges_[s], common(needed, window_around(edges_[s].box(), reach)), reach);
    }
  }

  // What is needed of the window: the samples inside, those near the given outlines, and a border.
  [[nodiscard]] LatticeWindow inner_window(const ClassShape& shape) const {
    const LatticeWindow& w = shape.window;
    LatticeWindow inner = common(window_around(box_, kMargin), w);
    for (const std::vector<double>& value : shape.value) {
      std::size_t k = 0;
      for (std::int64_t j = w.j0; j < w.j1; ++j) {
        for (std::int64_t i = w.i0; i < w.i1; ++i, ++k) {
          if (value[k] < 0) inner = inner.joined({i - 1, j - 1, i + 2, j + 2});
        }
      }
    }
    return inner;
  }

  [[nodiscard]] std::vector<double> given(const LatticeWindow& w, Around s) const {
    std::vector<double> value(w.size());
    std::size_t k = 0;
    for (std::int64_t j = w.j0; j < w.j1; ++j) {
      for (std::int64_t i = w.i0; i < w.i1; ++i, ++k) value[k] = never_zero(field_[s].sample(i, j));
    }
    return value;
  }

  [[nodiscard]] std::vector<double> layer(const LatticeWindow& w, double t,
                                          const std::vector<Point2>& motion) const {
    const Cubic cubic(t, back_, on_);
    std::vector<double> value(w.size());
    std::size_t k = 0;
    std::array<double, 4> p{};
    for (std::int64_t j = w.j0; j < w.j1; ++j) {
      for (std::int64_t i = w.i0; i < w.i1; ++i, ++k) {
        const Point2& u = motion[k];
        for (std::size_t s = 0; s < 4; ++s) {
          p[s] = u == Point2{} ? field_[s].sample(i, j)
                               : field_[s].at(static_cast<double>(i) + (share_[s] - t) * u.x,
                                              static_cast<double>(j) + (share_[s] - t) * u.y);
        }
        double v = cubic.at(p);
        if (std::min(p[lower], p[upper]) >= kOvergrowth * gap_) v = std::max(v, kOnOutline);
        value[k] = never_zero(v);
      }
    }
    return value;
  }

  double step_;
  double gap_ = 0;  // in steps
  std::optional<double> back_, on_;
  std::array<double, 4> share_{};
  std::array<LatticeEdges, 4> edges_;
  std::array<Field, 4> field_;
  Box2 box_;
};

}  // namespace

ClassShape interpolate(const ClassOutlines& outlines, double step, const std::vector<double>& at,
                       const std::optional<Point2>& rigid) {
  Interpolation interpolation(outlines, step);
  if (!interpolation.fits()) return {};
  if (rigid) return interpolation.run(at, std::nullopt, {rigid->x / step, rigid->y / step});
  return interpolation.run(at, estimate_motion(outlines), {});
}

}  // namespace tetloft::internal::between

#include "unit/between/field_slab.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include <tetloft/nesting.hpp>

namespace tetloft::testing {

using namespace internal;
using namespace internal::between;

namespace {

// Half the side of the square around the origin in which fields are sampled.
constexpr double kReach = 6;

// Appends the contours of a class and tells which they are.
std::vector<std::size_t> append(const std::vector<Contour>& contours, Section& section) {
  std::vector<std::size_t> result;
  for (const Contour& contour : contours) {
    result.push_back(section.contours.size());
    section.contours.push_back(contour);
  }
  return result;
}

std::vector<RegionId> regions_of(const std::vector<std::size_t>& contours, const Nesting& nesting) {
  std::vector<RegionId> regions;
  for (const std::size_t c : contours) regions.push_back(nesting.region[ContourId(c)]);
  std::sort(regions.begin(), regions.end());
  regions.erase(std::unique(regions.begin(), regions.end()), regions.end());
  return regions;
}

// The samples where some layer is inside, and those of the given contours.
motion::LatticeWindow window_of(const FieldClass& c, double step, std::size_t layers) {
  const auto n = static_cast<std::int64_t>(kReach / step);
  motion::LatticeWindow window{n, n, -n, -n};
  const auto add = [&](std::int64_t i, std::int64_t j) {
    window = window.joined({i, j, i + 1, j + 1});
  };
  for (std::size_t k = 1; k + 1 < layers; ++k) {
    for (std::int64_t j = -n; j <= n; ++j) {
      for (std::int64_t i = -n; i <= n; ++i) {
        if (c.field(static_cast<double>(i) * step, static_cast<double>(j) * step, k) < 0) add(i, j);
      }
    }
  }
  for (const auto* contours : {&c.lower, &c.upper}) {
    for (const Contour& contour : *contours) {
      for (const Point2& p : contour.vertices) {
        add(static_cast<std::int64_t>(std::floor(p.x / step)),
            static_cast<std::int64_t>(std::floor(p.y / step)));
        add(static_cast<std::int64_t>(std::ceil(p.x / step)),
            static_cast<std::int64_t>(std::ceil(p.y / step)));
      }
    }
  }
  return window.widened(2);
}

}  // namespace

FieldSlab::FieldSlab(const std::vector<FieldClass>& classes, double step, std::size_t between)
    : classes_(classes) {
  lower_.z = 0;
  upper_.z = 1;
  std::vector<std::vector<std::size_t>> low, high;
  for (const FieldClass& c : classes) {
    low.push_back(append(c.lower, lower_));
    high.push_back(append(c.upper, upper_));
  }
  if (!lower_.contours.empty()) lower_nesting_ = nest(lower_);
  if (!upper_.contours.empty()) upper_nesting_ = nest(upper_);
  slab_ = std::make_unique<SlabShape>(
      SlabShape{lower_, upper_, lower_nesting_, upper_nesting_, {}, step, {}});
  for (std::size_t c = 0; c < classes.size(); ++c) {
    slab_->classes.push_back(
        {regions_of(low[c], lower_nesting_), regions_of(high[c], upper_nesting_), {}});
  }
  for (std::size_t k = 1; k <= between; ++k) {
    slab_->at.push_back(static_cast<double>(k) / static_cast<double>(between + 1));
  }
}

ClassShapes FieldSlab::shapes() const {
  ClassShapes shapes;
  const double step = slab_->step;
  const std::size_t layers = slab_->at.size() + 2;
  for (const FieldClass& c : classes_) {
    ClassShape shape;
    shape.window = window_of(c, step, layers);
    shape.motion.assign(shape.window.size(), Point2{0, 0});
    shape.value.assign(layers, std::vector<double>(shape.window.size(), 1));
    for (std::size_t k = 1; k + 1 < layers; ++k) {
      for (std::int64_t j = shape.window.j0; j < shape.window.j1; ++j) {
        for (std::int64_t i = shape.window.i0; i < shape.window.i1; ++i) {
          const double x = static_cast<double>(i) * step;
          const double y = static_cast<double>(j) * step;
          const double v = c.field(x, y, k) / step;
          shape.value[k][shape.window.place(i, j)] =
              v != 0 ? v : std::numeric_limits<double>::min();
        }
      }
    }
    shapes.push_back(std::move(shape));
  }
  return shapes;
}

Contour octagon(double x, double y, double radius) {
  const double a = radius;
  const double b = radius * 0.707;
  return {{{x + a, y},
           {x + b, y + b},
           {x, y + a},
           {x - b, y + b},
           {x - a, y},
           {x - b, y - b},
           {x, y - a},
           {x + b, y - b}}};
}

Contour rectangle(double x0, double y0, double x1, double y1) {
  return {{{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}}};
}

double to_disc(double x, double y, double cx, double cy, double radius) {
  return std::sqrt((x - cx) * (x - cx) + (y - cy) * (y - cy)) - radius;
}

double to_box(double x, double y, double x0, double y0, double x1, double y1) {
  return std::max({x0 - x, x - x1, y0 - y, y - y1});
}

}  // namespace tetloft::testing

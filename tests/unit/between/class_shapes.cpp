#include "unit/between/class_shapes.hpp"

#include <cstddef>

namespace tetloft::testing {

using namespace internal::between;

Contour circle(const Point2& centre, double radius, int n) {
  Contour contour;
  for (int quarter = 0; quarter < 4; ++quarter) {
    for (int k = 0; k < n; ++k) {
      const double t = static_cast<double>(k) / n;
      Point2 p{(1 - t * t) / (1 + t * t), 2 * t / (1 + t * t)};
      for (int q = 0; q < quarter; ++q) p = {-p.y, p.x};
      contour.vertices.push_back({centre.x + radius * p.x, centre.y + radius * p.y});
    }
  }
  return contour;
}

Contour box(const Point2& low, const Point2& high) {
  return Contour{{low, {high.x, low.y}, high, {low.x, high.y}}};
}

ClassOutlines OwnedClass::outlines() const {
  ClassOutlines all;
  all.z = z;
  for (std::size_t s = 0; s < 4; ++s) {
    for (const Contour& contour : contours[s]) all.contours[s].push_back(&contour);
  }
  return all;
}

ClassShape OwnedClass::at(const std::vector<double>& shares, double step) const {
  return interpolate(outlines(), step, shares);
}

OwnedClass OwnedClass::upside_down() const {
  OwnedClass turned;
  for (std::size_t s = 0; s < 4; ++s) {
    turned.contours[s] = contours[3 - s];
    if (z[3 - s]) turned.z[s] = -*z[3 - s];
  }
  return turned;
}

OwnedClass OwnedClass::scaled(double by) const {
  OwnedClass larger = *this;
  for (std::size_t s = 0; s < 4; ++s) {
    if (z[s]) larger.z[s] = *z[s] * by;
    for (Contour& contour : larger.contours[s]) {
      for (Point2& p : contour.vertices) p = {p.x * by, p.y * by};
    }
  }
  return larger;
}

OwnedClass discs(const std::array<Point2, 4>& centre, const std::array<double, 4>& radius) {
  OwnedClass all;
  for (std::size_t s = 0; s < 4; ++s) {
    if (radius[s] > 0) all.contours[s] = {circle(centre[s], radius[s])};
    all.z[s] = 6 * static_cast<double>(s);
  }
  return all;
}

OwnedClass branching() {
  OwnedClass all;
  all.z = {-5.0, 0.0, 6.0, 13.0};
  all.contours[behind] = {circle({0.3, 0.1}, 9)};
  all.contours[lower] = {circle({1.4, 0.2}, 10), circle({2.1, 0.4}, 3.3)};
  all.contours[upper] = {circle({-5.2, 1.3}, 5.7), circle({9.1, 0.7}, 6.2)};
  all.contours[beyond] = {circle({-8.6, 2.2}, 4.5), circle({12.9, 0.9}, 5.5)};
  return all;
}

}  // namespace tetloft::testing

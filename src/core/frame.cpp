// Placing points in the space of a file.
#include <tetloft/frame.hpp>

namespace tetloft {

namespace {

// Terms of a zero factor are left out: an exchange of coordinates keeps every bit.
double sum(double a, double x, double b, double y, double c, double z, double origin) {
  double total = 0;
  bool any = false;
  const auto add = [&](double factor, double value) {
    if (factor == 0) return;
    const double term = factor == 1 ? value : factor * value;
    total = any ? total + term : term;
    any = true;
  };
  add(a, x);
  add(b, y);
  add(c, z);
  return origin == 0 ? total : total + origin;
}

bool is_signed_unit(const Point3& axis) {
  int units = 0;
  for (const double c : {axis.x, axis.y, axis.z}) {
    if (c == 0) continue;
    if (c != 1 && c != -1) return false;
    ++units;
  }
  return units == 1;
}

}  // namespace

bool is_exact(const Frame& frame) {
  for (const Point3& axis : frame.axes) {
    if (!is_signed_unit(axis)) return false;
  }
  return frame.origin == Point3{};
}

double volume_factor(const Frame& frame) {
  constexpr double kRounding = 0x1p-40;
  const auto& [a, b, c] = frame.axes;
  const auto dot = [](const Point3& p, const Point3& q) {
    return p.x * q.x + p.y * q.y + p.z * q.z;
  };
  const double determinant =
      a.x * (b.y * c.z - b.z * c.y) + a.y * (b.z * c.x - b.x * c.z) + a.z * (b.x * c.y - b.y * c.x);
  bool orthonormal = true;
  for (const double product :
       {dot(a, b), dot(b, c), dot(c, a), dot(a, a) - 1, dot(b, b) - 1, dot(c, c) - 1}) {
    orthonormal = orthonormal && product < kRounding && product > -kRounding;
  }
  return orthonormal ? 1 : determinant;
}

Point3 place(const Frame& frame, const Point3& p) {
  const auto& [a, b, c] = frame.axes;
  return {sum(a.x, p.x, b.x, p.y, c.x, p.z, frame.origin.x),
          sum(a.y, p.x, b.y, p.y, c.y, p.z, frame.origin.y),
          sum(a.z, p.x, b.z, p.y, c.z, p.z, frame.origin.z)};
}

}  // namespace tetloft

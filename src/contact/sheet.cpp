// Whatever the axes are, the residual r is measured, not derived: so the sheet holds its triangles
// even where axes are far from orthogonal, and only rounding has to be accounted for.
//
// Rounding. With u = 2^-53, w = p - o for a vertex p and the first vertex o, and axes of
// coordinates at most 1 + 12u, as of the product of two that are off by 4u: w is off by u |w|; the
// centre by 4u (|o| + sum |a|) or less; the residual, three products, three differences, by
// 6u (|w| + sum |a|); middles and reaches by u |a| each. Of two sheets the offset d of the centres
// is off by u |d|; its inner product with a normal n by another 3u |n| |d|, where |n| is the sum of
// magnitudes; those with the axes, times reaches, by 4u |n| (sum of reaches); and ten sums and
// products on the way to the bound are off by u of it each, in which the residual is |w| + sum |a|
// at most. Together that is below 40u times the magnitudes in question, and kSheetRounding is 128u.
//
// Underflow is at most 2^-1074 in each of some dozens of products, none of them multiplied by
// anything above 3 later on but those of normals with axes, which are of no account beside |n|
// above kShortest. kTinySum is above their sum. Nothing overflows within kFarthestSheet.
#include "contact/sheet.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

#include "core/vector.hpp"

namespace tetloft::internal::contact_detail {

namespace {

constexpr double kSheetRounding = 0x1p-46;
constexpr double kTinySum = 0x1p-1000;
constexpr double kShortest = 0x1p-400;
constexpr double kFarthestSheet = 0x1p+250;

using vectors::cross;
using vectors::dot;

Point3 difference(const Point3& a, const Point3& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }

Point3 plus_multiple(const Point3& a, double k, const Point3& b) {
  return {a.x + k * b.x, a.y + k * b.y, a.z + k * b.z};
}

double largest(const Point3& a) { return std::max({std::abs(a.x), std::abs(a.y), std::abs(a.z)}); }

// Zero for what has hardly any length.
Point3 unit(const Point3& a) {
  const double length = std::sqrt(dot(a, a));
  if (!(length > kShortest)) return {0, 0, 0};
  return {a.x / length, a.y / length, a.z / length};
}

Point3 longest_edge(const Triangle3& t) {
  Point3 longest = difference(t[1], t[0]);
  for (const Point3& edge : {difference(t[2], t[1]), difference(t[0], t[2])}) {
    if (dot(edge, edge) > dot(longest, longest)) longest = edge;
  }
  return longest;
}

// Edges and normals have no sense of their own.
void add_aligned(const Point3& direction, Point3& sum) {
  sum = plus_multiple(sum, dot(direction, sum) < 0 ? -1 : 1, direction);
}

}  // namespace

Sheet::Sheet(std::span<const Triangle3> triangles)
    : centre_(triangles.front().front()), slack_(std::numeric_limits<double>::infinity()) {
  Point3 along{0, 0, 0};
  Point3 across{0, 0, 0};
  for (const Triangle3& t : triangles) {
    if (!(std::max({largest(t[0]), largest(t[1]), largest(t[2])}) <= kFarthestSheet)) return;
    add_aligned(longest_edge(t), along);
    add_aligned(cross(difference(t[1], t[0]), difference(t[2], t[0])), across);
  }
  axes_[0] = unit(along);
  axes_[1] = unit(plus_multiple(across, -dot(across, axes_[0]), axes_[0]));
  axes_[2] = cross(axes_[0], axes_[1]);
  bound(triangles);
}

void Sheet::bound(std::span<const Triangle3> triangles) {
  const Point3 origin = centre_;
  std::array<double, 3> low{};
  std::array<double, 3> high{};
  double residual = 0;
  double size = largest(origin);
  for (const Triangle3& t : triangles) {
    for (const Point3& p : t) {
      const Point3 w = difference(p, origin);
      Point3 rest = w;
      for (std::size_t k = 0; k < 3; ++k) {
        const double a = dot(w, axes_[k]);
        low[k] = std::min(low[k], a);
        high[k] = std::max(high[k], a);
        rest = plus_multiple(rest, -a, axes_[k]);
      }
      residual = std::max(residual, largest(rest));
      size = std::max(size, largest(w));
    }
  }
  for (std::size_t k = 0; k < 3; ++k) {
    const double middle = low[k] / 2 + high[k] / 2;
    centre_ = plus_multiple(centre_, middle, axes_[k]);
    reach_[k] = high[k] / 2 - low[k] / 2;
    size += high[k] - low[k];
  }
  // Once for the origin, once for the differences.
  slack_ = residual + 2 * kSheetRounding * size;
}

// Inner products with the normal of what is in one sheet, and of what is in the other, differ by
// that of the offset, up to what the sheets reach.
bool Sheet::parted(const Sheet& other, const Point3& normal, const Point3& offset) const {
  const double size = std::abs(normal.x) + std::abs(normal.y) + std::abs(normal.z);
  if (!(size > kShortest)) return false;
  double reach = size * (slack_ + other.slack_ + kSheetRounding * largest(offset)) + kTinySum;
  for (std::size_t k = 0; k < 3; ++k) {
    reach += reach_[k] * std::abs(dot(normal, axes_[k]));
    reach += other.reach_[k] * std::abs(dot(normal, other.axes_[k]));
  }
  return std::abs(dot(normal, offset)) > reach;
}

bool Sheet::apart(const Sheet& other) const {
  const Point3 offset = difference(other.centre_, centre_);
  return parted(other, axes_[1], offset) || parted(other, other.axes_[1], offset) ||
         parted(other, cross(axes_[0], other.axes_[0]), offset) ||
         parted(other, axes_[2], offset) || parted(other, other.axes_[2], offset);
}

}  // namespace tetloft::internal::contact_detail

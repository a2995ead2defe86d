#include "contact/separation.hpp"

#include <algorithm>
#include <cmath>

#include "contact/narrowed.hpp"

namespace tetloft::internal::contact_detail {

namespace {

struct Form {
  double x, y, z;
  [[nodiscard]] double operator()(const Point3& p) const { return x * p.x + y * p.y + z * p.z; }
};

// Farther out, multiples of coordinates might overflow.
constexpr double kFarthest = 0x1p+900;
// Heights are scaled by 2^-60 to 2^60 at most.
constexpr int kMostBits = 60;

double magnitude(const Point3& p) {
  return std::max({std::abs(p.x), std::abs(p.y), std::abs(p.z)});
}

// The power of two by which heights of triangles are to be multiplied to be about as much as their
// widths.
int bits_of_height(std::span<const Point3> points, std::span<const TriangleVertices> triangles,
                   std::span<const std::uint32_t> members) {
  double width = 0;
  double height = 0;
  for (const std::uint32_t i : members) {
    const Point3& a = points[triangles[i][0].index()];
    const Point3& b = points[triangles[i][1].index()];
    const Point3& c = points[triangles[i][2].index()];
    width += std::abs(b.x - a.x) + std::abs(c.x - a.x) + std::abs(b.y - a.y) + std::abs(c.y - a.y);
    height += std::abs(b.z - a.z) + std::abs(c.z - a.z);
  }
  if (!(width > 0 && height > 0)) return 0;
  return std::clamp(std::ilogb(width / 2) - std::ilogb(height), -kMostBits, kMostBits);
}

// Of values, unlike std::min() and std::max(): loops over forms have no branch, and compilers do
// four at a time.
float lower(float a, float b) { return a < b ? a : b; }
float higher(float a, float b) { return a > b ? a : b; }

// Directions about as dense everywhere; of real solids they part nine pairs in ten.
template <std::size_t n>
std::array<Form, n> forms_of(int bits) {
  static_assert(n == 24);
  const double w = std::ldexp(1.0, std::max(0, -bits));
  const double h = std::ldexp(1.0, std::max(0, bits));
  return {{{1, 0, 0},      {0, 1, 0},     {0, 0, 1},      {1, 1, 0},      {1, -1, 0},
           {1, 2, 0},      {1, -2, 0},    {2, 1, 0},      {2, -1, 0},     {1, 4, 0},
           {1, -4, 0},     {4, 1, 0},     {4, -1, 0},     {w, 0, h},      {w, 0, -h},
           {0, w, h},      {0, w, -h},    {w, 0, 2 * h},  {w, 0, -2 * h}, {0, w, 2 * h},
           {0, w, -2 * h}, {2 * w, 0, h}, {2 * w, 0, -h}, {0, 2 * w, h}}};
}

}  // namespace

Separation::Separation(std::span<const Point3> points, std::span<const TriangleVertices> triangles,
                       std::span<const std::uint32_t> members) {
  const bool far = std::any_of(points.begin(), points.end(),
                               [](const Point3& p) { return !(magnitude(p) <= kFarthest); });
  if (far || members.empty()) return;
  const auto forms = forms_of<kForms>(bits_of_height(points, triangles, members));
  // Near some vertex floats are fine.
  const Point3& origin = points[triangles[members.front()].front().index()];
  std::array<double, kForms> constant{};
  for (std::size_t k = 0; k < kForms; ++k) constant[k] = forms[k](origin);
  values_.resize(points.size());
  for (std::size_t v = 0; v < points.size(); ++v) {
    for (std::size_t k = 0; k < kForms; ++k) {
      values_[v][k] = narrowed(forms[k](points[v]) - constant[k]);
    }
  }
}

bool Separation::apart(const TriangleVertices& a, const TriangleVertices& b) const {
  if (values_.empty()) return false;
  const Values& a0 = values(a[0]);
  const Values& a1 = values(a[1]);
  const Values& a2 = values(a[2]);
  const Values& b0 = values(b[0]);
  const Values& b1 = values(b[1]);
  const Values& b2 = values(b[2]);
  std::int32_t parted = 0;
  for (std::size_t k = 0; k < kForms; ++k) {
    const float a_low = lower(lower(a0[k], a1[k]), a2[k]);
    const float a_high = higher(higher(a0[k], a1[k]), a2[k]);
    const float b_low = lower(lower(b0[k], b1[k]), b2[k]);
    const float b_high = higher(higher(b0[k], b1[k]), b2[k]);
    parted |= static_cast<int>(a_high < b_low) | static_cast<int>(b_high < a_low);
  }
  return parted != 0;
}

bool Separation::meet_in_first_alone(const TriangleVertices& a, const TriangleVertices& b) const {
  if (values_.empty()) return false;
  const Values& at = values(a[0]);
  const Values& a1 = values(a[1]);
  const Values& a2 = values(a[2]);
  const Values& b1 = values(b[1]);
  const Values& b2 = values(b[2]);
  std::int32_t parted = 0;
  for (std::size_t k = 0; k < kForms; ++k) {
    const float a_low = lower(a1[k], a2[k]);
    const float a_high = higher(a1[k], a2[k]);
    const float b_low = lower(b1[k], b2[k]);
    const float b_high = higher(b1[k], b2[k]);
    parted |= static_cast<int>(a_high < at[k]) & static_cast<int>(at[k] < b_low);
    parted |= static_cast<int>(b_high < at[k]) & static_cast<int>(at[k] < a_low);
  }
  return parted != 0;
}

}  // namespace tetloft::internal::contact_detail

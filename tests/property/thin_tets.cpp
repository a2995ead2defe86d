#include "property/thin_tets.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include <tetloft/delaunay.hpp>

namespace tetloft::testing {

namespace {

constexpr double kUlps = 0x1p12;
// A vertex that was lifted as little as allowed is this near to its edge's middle.
constexpr double kNear = 0x1p-6;

using Tet = std::array<Point3, 4>;

std::array<long double, 3> cross(const Point3& a, const Point3& b, const Point3& c) {
  const long double ux = b.x - a.x, uy = b.y - a.y, uz = b.z - a.z;
  const long double vx = c.x - a.x, vy = c.y - a.y, vz = c.z - a.z;
  return {uy * vz - uz * vy, uz * vx - ux * vz, ux * vy - uy * vx};
}

// The least height over a face, in extended precision: for slivers about right.
long double thickness(const Tet& t) {
  long double largest = 0;
  for (std::size_t i = 0; i < 4; ++i) {
    const auto n = cross(t[(i + 1) % 4], t[(i + 2) % 4], t[(i + 3) % 4]);
    largest = std::max(largest, std::hypot(n[0], n[1], n[2]));
  }
  const auto n = cross(t[0], t[1], t[2]);
  const long double volume =
      n[0] * (t[3].x - t[0].x) + n[1] * (t[3].y - t[0].y) + n[2] * (t[3].z - t[0].z);
  return std::abs(volume) / largest;
}

bool is_middle(const Point3& a, const Point3& b, const Point3& place) {
  const double off = std::hypot(0.5 * (a.x + b.x) - place.x, 0.5 * (a.y + b.y) - place.y);
  return off <= kNear * std::hypot(b.x - a.x, b.y - a.y);
}

double spacing(const Tet& t) {
  double largest = 0;
  for (const Point3& p : t) {
    largest = std::max({largest, std::abs(p.x), std::abs(p.y), std::abs(p.z)});
  }
  return std::nextafter(largest, HUGE_VAL) - largest;
}

}  // namespace

bool has_thin_tet(const SectionStack& stack, std::size_t slab, const Point3& place) {
  if (slab + 1 >= stack.sections.size()) return false;
  const SectionId low(slab), high(slab + 1);
  const auto below = conform(stack.sections[low], low);
  const auto above = conform(stack.sections[high], high);
  if (!below || !above || below->vertex_count() == 0 || above->vertex_count() == 0) return false;
  const auto mesh = slab_delaunay3(below->triangulation, above->triangulation);
  if (!mesh) return false;
  const std::size_t lows = below->vertex_count();
  for (std::size_t k = 0; k < mesh->tet_slots(); ++k) {
    const TetVertices& v = mesh->vertices(TetId(k));
    Tet tet;
    for (std::size_t i = 0; i < 4; ++i) {
      const std::size_t at = v[i].index();
      tet[i] =
          at < lows ? below->point3(PlaneVertexId(at)) : above->point3(PlaneVertexId(at - lows));
    }
    bool near = false;
    for (std::size_t i = 0; i < 4; ++i) {
      near = near || tet[i] == place;
      for (std::size_t j = 0; j < i; ++j) {
        near = near || (tet[i].z == tet[j].z && is_middle(tet[i], tet[j], place));
      }
    }
    if (!near) continue;
    if (thickness(tet) <= static_cast<long double>(kUlps * spacing(tet))) return true;
  }
  return false;
}

}  // namespace tetloft::testing

#include "comparison/surface_distance.hpp"

#include <algorithm>
#include <cmath>

#include "core/prng.hpp"

namespace tetloft::bench {

using namespace internal;

namespace {

double triangle_area(const Point3& a, const Point3& b, const Point3& c) {
  const Point3 p{b.x - a.x, b.y - a.y, b.z - a.z};
  const Point3 q{c.x - a.x, c.y - a.y, c.z - a.z};
  const double x = p.y * q.z - p.z * q.y, y = p.z * q.x - p.x * q.z, z = p.x * q.y - p.y * q.x;
  return std::sqrt(x * x + y * y + z * z) / 2;
}

SurfaceDistance one_way(const std::vector<Point3>& samples, const SurfaceSearch& to) {
  SurfaceDistance result;
  for (const Point3& p : samples) {
    const double d = to.distance(p);
    result.mean += d;
    result.hausdorff = std::max(result.hausdorff, d);
  }
  result.mean /= static_cast<double>(samples.size());
  return result;
}

}  // namespace

std::vector<Point3> sample_surface(const TriangleMesh& mesh, double low, double high,
                                   std::size_t count, std::uint64_t seed) {
  const auto in_plane = [&](const TriangleVertices& t, double z) {
    return std::all_of(t.begin(), t.end(), [&](VertexId v) { return mesh.points[v].z == z; });
  };
  std::vector<double> area_up_to;
  double area = 0;
  for (const TriangleVertices& t : mesh.triangles) {
    if (!in_plane(t, low) && !in_plane(t, high)) {
      area += triangle_area(mesh.points[t[0]], mesh.points[t[1]], mesh.points[t[2]]);
    }
    area_up_to.push_back(area);
  }
  std::vector<Point3> samples;
  if (!(area > 0)) return samples;
  Prng prng(seed);
  for (std::size_t k = 0; k < count; ++k) {
    const double at = area * (static_cast<double>(k) + prng.unit()) / static_cast<double>(count);
    const auto found = std::upper_bound(area_up_to.begin(), area_up_to.end(), at);
    // Rounding may reach the end; `area` itself is first reached by a triangle with area.
    const auto i = found != area_up_to.end()
                       ? found
                       : std::lower_bound(area_up_to.begin(), area_up_to.end(), area);
    const auto& [a, b, c] = mesh.triangles[static_cast<std::size_t>(i - area_up_to.begin())];
    const Point3 &p = mesh.points[a], &q = mesh.points[b], &r = mesh.points[c];
    // Uniform in the triangle: Osada et al., Shape distributions, ACM TOG 21, 2002.
    const double s = std::sqrt(prng.unit()), t = prng.unit();
    const double u = 1 - s, v = s * (1 - t), w = s * t;
    samples.push_back(
        {u * p.x + v * q.x + w * r.x, u * p.y + v * q.y + w * r.y, u * p.z + v * q.z + w * r.z});
  }
  return samples;
}

std::optional<SurfaceDistance> surface_distance(const SampledSurface& a, const SampledSurface& b) {
  if (a.samples.empty() || b.samples.empty()) return std::nullopt;
  const SurfaceDistance there = one_way(a.samples, b.search);
  const SurfaceDistance back = one_way(b.samples, a.search);
  return SurfaceDistance{(there.mean + back.mean) / 2, std::max(there.hausdorff, back.hausdorff)};
}

}  // namespace tetloft::bench

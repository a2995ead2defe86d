// 2D Delaunay: every triangle's perturbed circle is empty, Euler's formula holds, the order of
// points plays no part; conforming triangulations contain their segments or refuse.
#include <algorithm>
#include <vector>

#include <tetloft/delaunay.hpp>
#include <tetloft/predicates.hpp>

#include "fuzz/target.hpp"

namespace tetloft::fuzz {
namespace {

std::vector<std::array<Point2, 3>> corners(const Triangulation2& t) {
  std::vector<std::array<Point2, 3>> all;
  for (const PlaneTriangleVertices& v : t.triangles) {
    std::array<Point2, 3> points{t.points[v[0]], t.points[v[1]], t.points[v[2]]};
    std::rotate(points.begin(),
                std::min_element(points.begin(), points.end(),
                                 [](auto& a, auto& b) { return canonical_less(a, b); }),
                points.end());
    all.push_back(points);
  }
  std::sort(all.begin(), all.end(), [](const auto& a, const auto& b) {
    for (std::size_t i = 0; i < 3; ++i) {
      if (a[i] != b[i]) return canonical_less(a[i], b[i]);
    }
    return false;
  });
  return all;
}

bool has_area(const std::vector<Point2>& points) {
  for (const Point2& a : points) {
    for (const Point2& b : points) {
      if (a == b) continue;
      return std::any_of(points.begin(), points.end(),
                         [&](const Point2& c) { return orient2d(a, b, c) != Sign::zero; });
    }
  }
  return false;
}

// Triangles with empty circles are pairwise without overlap; that they fill the hull is told by
// their number.
void check_triangulation(const Triangulation2& t, const std::vector<Point2>& distinct) {
  require(t.triangles.empty() == !has_area(distinct), "triangles iff not collinear");
  std::size_t hull = 0;
  for (std::size_t k = 0; k < t.triangles.size(); ++k) {
    const TriangleId id(k);
    const PlaneTriangleVertices& v = t.triangles[id];
    const Point2& a = t.points[v[0]];
    const Point2& b = t.points[v[1]];
    const Point2& c = t.points[v[2]];
    require(orient2d(a, b, c) == Sign::positive, "a triangle is not counter-clockwise");
    for (const Point2& p : distinct) {
      if (p == a || p == b || p == c) continue;
      require(incircle_perturbed(a, b, c, p) == Sign::negative, "a circle is not empty");
    }
    for (std::size_t i = 0; i < 3; ++i) {
      const TriangleId n = t.neighbours[id][i];
      if (!n.valid()) {
        ++hull;
        for (const Point2& p : distinct) {
          require(orient2d(t.points[v[(i + 1) % 3]], t.points[v[(i + 2) % 3]], p) != Sign::negative,
                  "a point lies beyond the hull");
        }
        continue;
      }
      const auto& back = t.neighbours[n];
      require(std::count(back.begin(), back.end(), id) == 1, "neighbours are not mutual");
    }
  }
  if (!t.triangles.empty()) {
    require(t.triangles.size() == 2 * distinct.size() - 2 - hull, "Euler's formula");
  }
}

void check_conforming(const std::vector<Point2>& points, Bytes& bytes) {
  std::vector<Segment> segments;
  for (std::size_t k = bytes.below(8); k > 0; --k) {
    const std::size_t a = bytes.below(points.size());
    segments.push_back({PlaneVertexId(a), PlaneVertexId(bytes.below(points.size()))});
  }
  ConformingOptions options;
  options.most_inserted = 200;
  if (bytes.below(2) == 1) options.gabriel.assign(segments.size(), true);
  const auto conforming = conforming_delaunay2(points, segments, options);
  if (!conforming) return require_clean(conforming.error());
  const Triangulation2& t = conforming->triangulation;
  for (std::size_t s = 0; s < segments.size(); ++s) {
    const auto& chain = conforming->chains[s];
    require(chain.front() == segments[s][0] && chain.back() == segments[s][1], "ends of a chain");
    for (std::size_t i = 1; i < chain.size(); ++i) {
      const auto holds = [&](const PlaneTriangleVertices& v) {
        return std::count(v.begin(), v.end(), chain[i - 1]) == 1 &&
               std::count(v.begin(), v.end(), chain[i]) == 1;
      };
      require(t.triangles.empty() || std::any_of(t.triangles.begin(), t.triangles.end(), holds),
              "a subsegment is no edge");
    }
  }
}

}  // namespace
}  // namespace tetloft::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace tetloft;
  using namespace tetloft::fuzz;
  Bytes bytes(data, size);
  Coordinates coordinates(bytes);
  std::vector<Point2> points;
  for (std::size_t n = 3 + bytes.below(18); n > 0; --n) {
    const double x = coordinates.next();
    points.push_back({x, coordinates.next()});
  }
  const auto triangulated = delaunay2(points);
  if (!triangulated) {
    require_clean(triangulated.error());
    require(false, "finite points are refused");
  }
  std::vector<Point2> distinct = points;
  std::sort(distinct.begin(), distinct.end(),
            [](const Point2& a, const Point2& b) { return canonical_less(a, b); });
  distinct.erase(std::unique(distinct.begin(), distinct.end()), distinct.end());
  check_triangulation(*triangulated, distinct);
  std::vector<Point2> turned(points.rbegin(), points.rend());
  const auto again = delaunay2(turned);
  require(again.ok() && corners(*again) == corners(*triangulated), "the order of points plays in");
  check_conforming(distinct.size() == points.size() ? points : distinct, bytes);
  return 0;
}

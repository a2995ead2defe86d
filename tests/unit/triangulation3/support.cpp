#include "support.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <stdexcept>

#include <tetloft/delaunay3.hpp>
#include <tetloft/predicates.hpp>

namespace tetloft::test {

namespace {

using Quad = std::array<std::uint32_t, 4>;

double grid(Prng& prng, std::uint64_t side) { return static_cast<double>(prng.below(side)); }

Point3 on_integer_sphere(Prng& prng) {
  // All of squared length 81.
  constexpr std::array<std::array<double, 3>, 4> kinds{
      {{9, 0, 0}, {8, 4, 1}, {7, 4, 4}, {6, 6, 3}}};
  std::array<double, 3> v = kinds[prng.below(kinds.size())];
  prng.shuffle(v);
  for (double& x : v) x = prng.chance(0.5) ? -x : x;
  return {v[0], v[1], v[2]};
}

template <std::size_t n>
std::array<std::uint32_t, n> sorted(std::array<std::uint32_t, n> v) {
  std::sort(v.begin(), v.end());
  return v;
}

template <std::size_t n>
std::array<std::uint32_t, n> indices(const std::array<DelaunayVertex, n>& v) {
  std::array<std::uint32_t, n> result;
  for (std::size_t i = 0; i < n; ++i) result[i] = v[i].index;
  return result;
}

}  // namespace

std::vector<PointSource> point_sources() {
  return {
      {"cube",
       [](Prng& r) {
         return Point3{r.unit(), r.unit(), r.unit()};
       }},
      {"lattice",
       [](Prng& r) {
         return Point3{grid(r, 4), grid(r, 4), grid(r, 3)};
       }},
      {"sphere", on_integer_sphere},
      {"plane",
       [](Prng& r) {
         return Point3{grid(r, 5), grid(r, 5), 2};
       }},
      {"tilted plane",
       [](Prng& r) {
         const double x = grid(r, 6), y = grid(r, 6);
         return Point3{x, y, x + 2 * y};
       }},
      {"line",
       [](Prng& r) {
         const double t = grid(r, 12);
         return Point3{t, 2 * t, 1 - t};
       }},
      {"plane and a few",
       [](Prng& r) {
         return Point3{grid(r, 4), grid(r, 4), r.chance(0.1) ? 1.0 + grid(r, 2) : 0};
       }},
      {"two planes",
       [](Prng& r) {
         return Point3{grid(r, 5), grid(r, 4), 3 * grid(r, 2)};
       }},
      {"one ulp apart",
       [](Prng& r) {
         const double u = 0x1p-52;
         return Point3{1 + u * grid(r, 3), 1 + u * grid(r, 3), 1 + u * grid(r, 3)};
       }},
      {"clusters of many scales",
       [](Prng& r) {
         const double s = std::ldexp(1.0, -static_cast<int>(r.below(30)) * 4);
         return Point3{s * grid(r, 4), s * grid(r, 4), s * grid(r, 4)};
       }},
      {"few places",
       [](Prng& r) {
         return Point3{grid(r, 2), grid(r, 2), grid(r, 2)};
       }},
  };
}

testing::AssertionResult equals_batch(const DelaunayTriangulation3& t) {
  const std::vector<DelaunayVertex> live = live_vertices(t);
  if (live.size() != t.vertex_count()) return testing::AssertionFailure() << "count of vertices";
  std::vector<Point3> points;
  for (const DelaunayVertex v : live) points.push_back(t.point(v));
  const Delaunay3 batch = value_of(delaunay3(points));
  if (batch.duplicates != 0) return testing::AssertionFailure() << "a point twice";
  if (batch.dimension != t.dimension()) {
    return testing::AssertionFailure()
           << "dimension " << t.dimension() << " for " << batch.dimension;
  }
  std::set<Quad> expected;
  for (std::size_t k = 0; k < batch.mesh.tet_slots(); ++k) {
    Quad quad;
    for (std::size_t i = 0; i < 4; ++i) {
      quad[i] = live[batch.mesh.vertices(TetId(k))[i].index()].index;
    }
    expected.insert(sorted(quad));
  }
  std::set<Quad> found;
  std::map<std::uint32_t, std::size_t> degree;
  for (const TetId tet : t.tets()) {
    const auto vertices = t.vertices(tet);
    found.insert(sorted(indices(vertices)));
    for (const DelaunayVertex v : vertices) ++degree[v.index];
    if (orient3d(t.point(vertices[0]), t.point(vertices[1]), t.point(vertices[2]),
                 t.point(vertices[3])) != Sign::positive) {
      return testing::AssertionFailure() << "a tet that is not positive";
    }
    for (std::uint32_t i = 0; i < 4; ++i) {
      const HalfFaceId h(4 * tet.value() + i);
      const HalfFaceId across = t.opposite(h);
      if (!across.valid()) continue;
      if (t.opposite(across) != h ||
          sorted(indices(t.vertices(h))) != sorted(indices(t.vertices(across)))) {
        return testing::AssertionFailure() << "faces that do not fit";
      }
    }
  }
  if (found != expected) {
    return testing::AssertionFailure() << found.size() << " tets for " << expected.size();
  }
  if (found.size() != t.tet_count()) return testing::AssertionFailure() << "count of tets";
  for (const DelaunayVertex v : live) {
    if (t.star(v).size() != degree[v.index]) return testing::AssertionFailure() << "a star";
  }
  return testing::AssertionSuccess();
}

testing::AssertionResult equals_flat_oracle(const DelaunayTriangulation3& t) {
  const std::vector<DelaunayVertex> live = live_vertices(t);
  std::set<std::array<std::uint32_t, 2>> edges;
  std::set<std::array<std::uint32_t, 3>> facets;
  if (t.dimension() == 1) {
    std::vector<DelaunayVertex> row = live;
    std::sort(row.begin(), row.end(), [&](DelaunayVertex a, DelaunayVertex b) {
      return canonical_less(t.point(a), t.point(b));
    });
    for (std::size_t i = 1; i < row.size(); ++i) {
      edges.insert(sorted(std::array{row[i - 1].index, row[i].index}));
    }
  } else if (t.dimension() == 2) {
    // Some point off the plane: its weight in the perturbed predicate is nil there.
    const Point3 a = t.point(live[0]);
    for (const DelaunayVertex u : live) {
      for (const DelaunayVertex v : live) {
        for (const DelaunayVertex w : live) {
          if (!(u < v && v < w)) continue;
          const Point3 p = t.point(u), q = t.point(v), r = t.point(w);
          Point3 off{};
          for (const Point3& d :
               {Point3{a.x + 1, a.y, a.z}, Point3{a.x, a.y + 1, a.z}, Point3{a.x, a.y, a.z + 1}}) {
            if (orient3d(p, q, r, d) != Sign::zero) off = d;
          }
          const Sign side = orient3d(p, q, r, off);
          if (side == Sign::zero) continue;  // in a row
          const bool empty = std::all_of(live.begin(), live.end(), [&](DelaunayVertex x) {
            if (x == u || x == v || x == w) return true;
            const Sign s = insphere_perturbed(p, q, r, off, t.point(x));
            return (side == Sign::positive ? s : -s) == Sign::negative;
          });
          if (!empty) continue;
          facets.insert({u.index, v.index, w.index});
          for (const auto& e : {std::array{u.index, v.index}, std::array{u.index, w.index},
                                std::array{v.index, w.index}}) {
            edges.insert(e);
          }
        }
      }
    }
  }
  std::set<std::array<std::uint32_t, 2>> found_edges;
  for (const auto& e : t.edges()) found_edges.insert(indices(e));
  std::set<std::array<std::uint32_t, 3>> found_facets;
  for (const auto& f : t.facets()) found_facets.insert(indices(f));
  if (found_edges != edges) {
    return testing::AssertionFailure() << found_edges.size() << " edges for " << edges.size();
  }
  if (found_facets != facets) {
    return testing::AssertionFailure() << found_facets.size() << " facets for " << facets.size();
  }
  return testing::AssertionSuccess();
}

}  // namespace tetloft::test

// The seed: what each class keeps by the internal triangles and edges of its sections.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <set>
#include <vector>

#include "support/slabs/steps.hpp"

namespace tetloft::testing {
namespace {

// Triangles of the region that contain all of these vertices of one section.
std::size_t triangles_inside(const ConformingSection& section,
                             const std::vector<PlaneVertexId>& v) {
  std::size_t inside = 0;
  for (const TriangleId t : section.triangulation.triangles.ids()) {
    const PlaneTriangleVertices& corner = section.triangulation.triangles[t];
    const bool all = std::all_of(v.begin(), v.end(), [&](PlaneVertexId u) {
      return std::find(corner.begin(), corner.end(), u) != corner.end();
    });
    if (all && section.internal[t] != 0) ++inside;
  }
  return inside;
}

// The corners of a tet whose classes the seed keeps it for, by definition.
std::set<ClassId> classes_that_keep(const SlabCase& c, TetId t) {
  std::array<std::vector<PlaneVertexId>, 2> corner;
  std::array<std::vector<ClassId>, 2> of;
  for (int i = 0; i < 4; ++i) {
    const std::size_t v = c.slab->vertex(t, i).index();
    const std::size_t lower = c.lower.vertex_count();
    const std::size_t plane = v < lower ? 0 : 1;
    corner.at(plane).push_back(PlaneVertexId(v < lower ? v : v - lower));
    of.at(plane).push_back(c.classes->of(SlabVertexId(v)));
  }
  std::set<ClassId> keep;
  for (const std::size_t plane : {std::size_t{0}, std::size_t{1}}) {
    const ConformingSection& section = plane == 0 ? c.lower : c.upper;
    const std::vector<PlaneVertexId>& v = corner.at(plane);
    const std::size_t wanted = v.size() == 3 ? 1 : v.size() == 2 ? 2 : 99;
    // Type-1 tets stand on a triangle; an edge is internal between two of the region.
    const bool type2 = corner[0].size() == 2;
    if ((v.size() == 3 || type2) && triangles_inside(section, v) == wanted) {
      keep.insert(of.at(plane).front());
    }
  }
  return keep;
}

TEST(Seed, KeepsTetsOnInternalTrianglesAndWithInternalEdgesForTheirClasses) {
  std::size_t kept = 0;
  std::size_t shared = 0;
  for (const NamedSlab& s : generated_slabs(210, 1)) {
    if (s.built->slab->vertex_count() > 150) continue;
    for (const bool lone_too : {false, true}) {
      SCOPED_TRACE(s.name + (lone_too ? ", lone classes too" : ""));
      const SlabCase& c = *s.built;
      const IdVector<ClassId, std::uint8_t> active = c.active(lone_too);
      RuleCounts rules{};
      const Complex complex = seed(*c.slab, *c.classes, active, rules);
      std::uint64_t of_two = 0;
      for (const TetId t : c.slab->tets()) {
        std::set<ClassId> keep = classes_that_keep(c, t);
        std::erase_if(keep, [&](ClassId id) { return active[id] == 0; });
        for (int i = 0; i < 4; ++i) {
          EXPECT_EQ(complex.keeps(t, i), keep.contains(c.classes->of(c.slab->vertex(t, i))));
        }
        EXPECT_EQ(complex.attached[t], 0);
        kept += keep.empty() ? 0U : 1U;
        of_two += keep.size() == 2 ? 1U : 0U;
      }
      EXPECT_EQ(fired(rules, Rule::two_class_tet), of_two);
      shared += of_two;
    }
  }
  EXPECT_GT(kept, 500U);
  EXPECT_GT(shared, 0U);
}

}  // namespace
}  // namespace tetloft::testing

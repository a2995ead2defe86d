// A solid by its components, and put together from groups.
#include "io/groups.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace tetloft {

using namespace internal;
namespace {

using io::ComponentGroup;
using io::GroupedSolid;

TetVertices tet(int a, int b, int c, int d) {
  return {VertexId(a), VertexId(b), VertexId(c), VertexId(d)};
}
TriangleVertices triangle(int a, int b, int c) { return {VertexId(a), VertexId(b), VertexId(c)}; }

// Corners of the unit cube's beginning, and one point on either side.
std::vector<Point3> some_points() {
  return {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 1, 1}, {-1, 0, 0}};
}

// Two tets with a face in common, and one with an edge; of components 1, 0 and none.
Model three_tets() {
  Model model;
  model.points = IdVector<VertexId, Point3>(some_points());
  model.tets = IdVector<TetId, TetVertices>(
      std::vector<TetVertices>{tet(0, 1, 2, 3), tet(1, 2, 3, 4), tet(0, 2, 5, 3)});
  model.component = IdVector<TetId, ComponentId>(
      std::vector<ComponentId>{ComponentId(1), ComponentId(0), ComponentId()});
  model.component_count = 2;
  return model;
}

TEST(ComponentGroups, AreByNumberWithTheFacesOfNoOtherTet) {
  Model model = three_tets();
  model.component_names = IdVector<ComponentId, std::string>(std::vector<std::string>{"", "b"});
  const std::vector<ComponentGroup> groups = io::component_groups(model);
  ASSERT_EQ(groups.size(), 3U);
  EXPECT_EQ(groups[0].tag(), 1);
  EXPECT_EQ(groups[0].name, "component 1");
  EXPECT_EQ(groups[0].tets, std::vector<TetId>{TetId(1)});
  // All but the face (1, 2, 3), which lies opposite its last vertex.
  const std::vector<TriangleVertices> of_first{triangle(2, 3, 4), triangle(1, 4, 3),
                                               triangle(1, 2, 4)};
  EXPECT_EQ(groups[0].triangles, of_first);
  EXPECT_EQ(groups[1].tag(), 2);
  EXPECT_EQ(groups[1].name, "b");
  EXPECT_EQ(groups[1].tets, std::vector<TetId>{TetId(0)});
  EXPECT_EQ(groups[1].triangles.size(), 2U);  // without (1, 2, 3) and (0, 2, 3)
  EXPECT_EQ(groups[2].tag(), 0);
  EXPECT_EQ(groups[2].tets, std::vector<TetId>{TetId(2)});
}

TEST(ComponentGroups, OfAModelWithoutComponentsAreOne) {
  Model model = three_tets();
  model.component.clear();
  model.component_count = 0;
  const std::vector<ComponentGroup> groups = io::component_groups(model);
  ASSERT_EQ(groups.size(), 1U);
  EXPECT_EQ(groups[0].tag(), 1);
  EXPECT_EQ(groups[0].tets.size(), 3U);
  EXPECT_EQ(groups[0].triangles.size(), 8U);
  EXPECT_TRUE(io::component_groups(Model()).empty());
}

TEST(ComponentGroups, OfHugeNumbersTakeNoMemoryForThoseBetween) {
  Model model = three_tets();
  model.component[TetId(0)] = ComponentId(0x7FFFFFFF);
  model.component_count = std::size_t{1} << 31;
  const std::vector<ComponentGroup> groups = io::component_groups(model);
  ASSERT_EQ(groups.size(), 3U);
  EXPECT_EQ(groups[1].tag(), std::int64_t{1} << 31);
}

TEST(GroupedSolids, BecomeModels) {
  GroupedSolid solid;
  solid.add_tet(tet(0, 1, 2, 3), 12);
  solid.add_tet(tet(0, 1, 3, 2), 11);  // negative
  solid.add_tet(tet(0, 1, 2, 3), GroupedSolid::kNoGroup);
  solid.add_tet(tet(0, 1, 2, 2), 12);  // without volume
  io::WarningList warnings("a.msh");
  const Model model =
      solid.take(IdVector<VertexId, Point3>(some_points()), {{11, "a\xFF"}, {13, "c"}}, warnings);
  const std::vector<TetVertices> tets{tet(0, 1, 2, 3), tet(0, 1, 2, 3), tet(0, 1, 2, 3),
                                      tet(0, 1, 2, 2)};
  EXPECT_EQ(model.tets.raw(), tets);
  const std::vector<ComponentId> components{ComponentId(1), ComponentId(0), ComponentId(),
                                            ComponentId(1)};
  EXPECT_EQ(model.component.raw(), components);
  EXPECT_EQ(model.component_count, 2U);
  const std::vector<std::string> names{"a\xEF\xBF\xBD", ""};
  EXPECT_EQ(model.component_names.raw(), names);
  const std::vector<Warning> told = warnings.take();
  ASSERT_EQ(told.size(), 2U);
  EXPECT_EQ(told[0].message, "1 tet is negative: it is turned over");
  EXPECT_EQ(told[1].message, "1 tet has no volume");
}

TEST(GroupedSolids, WithoutGroupsHaveNoComponents) {
  GroupedSolid solid;
  solid.add_tet(tet(0, 1, 2, 3), GroupedSolid::kNoGroup);
  io::WarningList warnings("a.msh");
  const Model model = solid.take(IdVector<VertexId, Point3>(some_points()), {{11, "a"}}, warnings);
  EXPECT_TRUE(model.component.empty());
  EXPECT_EQ(model.component_count, 0U);
  EXPECT_TRUE(model.component_names.empty());
  EXPECT_TRUE(warnings.take().empty());
}

}  // namespace
}  // namespace tetloft

// Components by name, and as models of their own.
#include <gtest/gtest.h>

#include <stdexcept>

#include <tetloft/model.hpp>

namespace tetloft {
namespace {

// Two tets with a corner each in common with none, in an order that mixes their points.
Model two_components() {
  Model model;
  const auto place = [](double x) { return Point3{x, 0.5 * x, 0}; };
  for (int i = 0; i < 8; ++i) {
    Point3 p = place(i % 2 == 0 ? 0 : 10);
    if (i / 2 > 0) (i / 2 == 1 ? p.x : i / 2 == 2 ? p.y : p.z) += 1 + i;
    model.points.push_back(p);
    model.section.push_back(SectionId(i % 3));
    model.contour.push_back(ContourId(i));
    model.origin.push_back(i < 4 ? PointOrigin::input : PointOrigin::cut);
  }
  const auto v = [](int i) { return VertexId(i); };
  model.tets.raw() = {{v(1), v(3), v(5), v(7)}, {v(0), v(2), v(4), v(6)}};
  model.component.raw() = {ComponentId(1), ComponentId(0)};
  model.slab.raw() = {SlabId(4), SlabId(2)};
  model.kind.raw() = {TetKind::ii, TetKind::prism};
  model.component_count = 2;
  RegionLink link;
  link.slab = SlabId(2);
  link.lower = link.upper = ContourId(0);
  model.links.push_back(link);
  return model;
}

TEST(ComponentName, IsItsOwnOrThatOfTheModelAndANumber) {
  Model model = two_components();
  EXPECT_EQ(component_name(model, ComponentId(0)), "component 1");
  EXPECT_EQ(component_name(model, ComponentId(1)), "component 2");
  model.about.name = "lung";
  EXPECT_EQ(component_name(model, ComponentId(1)), "lung 2");
  model.component_names.raw() = {"", "label 7"};
  EXPECT_EQ(component_name(model, ComponentId(0)), "lung 1");
  EXPECT_EQ(component_name(model, ComponentId(1)), "label 7");
  model.component_count = 1;
  EXPECT_EQ(component_name(model, ComponentId(0)), "lung");
}

TEST(ComponentOf, HoldsItsTetsAndTheirPointsWithAllThatIsKnownOfThem) {
  Model model = two_components();
  model.about = {"lung", "mm", "LPS"};
  model.frame.axes = {Point3{0, 1, 0}, Point3{0, 0, 1}, Point3{1, 0, 0}};
  double volumes = 0;
  for (int c = 0; c < 2; ++c) {
    const Model part = component_of(model, ComponentId(c));
    ASSERT_EQ(part.tets.size(), 1U);
    ASSERT_EQ(part.points.size(), 4U);
    const TetId whole(c == 1 ? 0 : 1);
    EXPECT_EQ(part.slab.raw(), std::vector<SlabId>{model.slab[whole]});
    EXPECT_EQ(part.kind.raw(), std::vector<TetKind>{model.kind[whole]});
    EXPECT_EQ(part.component.raw(), std::vector<ComponentId>{ComponentId(0)});
    for (std::size_t k = 0; k < 4; ++k) {
      const VertexId mine = part.tets[TetId(0)][k];
      const VertexId theirs = model.tets[whole][k];
      EXPECT_EQ(part.points[mine], model.points[theirs]);
      EXPECT_EQ(part.section[mine], model.section[theirs]);
      EXPECT_EQ(part.contour[mine], model.contour[theirs]);
      EXPECT_EQ(part.origin[mine], model.origin[theirs]);
    }
    EXPECT_EQ(part.component_count, 1U);
    EXPECT_EQ(component_name(part, ComponentId(0)), c == 0 ? "lung 1" : "lung 2");
    EXPECT_EQ(part.about.unit, "mm");
    EXPECT_EQ(part.frame, model.frame);
    EXPECT_TRUE(part.links.empty());
    volumes += volume(part);
  }
  EXPECT_DOUBLE_EQ(volumes, volume(model));
}

TEST(ComponentsTouch, WhereTheyShareAPoint) {
  Model model = two_components();
  EXPECT_FALSE(components_touch(model));
  model.tets[TetId(0)][2] = VertexId(4);
  EXPECT_TRUE(components_touch(model));
  model.component.raw() = {ComponentId(1), ComponentId(1)};
  EXPECT_FALSE(components_touch(model));
  model.component.raw().clear();
  EXPECT_FALSE(components_touch(model));
}

TEST(ComponentOf, RefusesWhatIsNone) {
  Model model = two_components();
  EXPECT_THROW((void)component_of(model, ComponentId(2)), std::invalid_argument);
  EXPECT_THROW((void)component_of(model, ComponentId()), std::invalid_argument);
  model.component.raw().pop_back();
  EXPECT_THROW((void)component_of(model, ComponentId(0)), std::invalid_argument);
  model.component.raw().clear();
  EXPECT_THROW((void)component_of(model, ComponentId(0)), std::invalid_argument);
}

}  // namespace
}  // namespace tetloft

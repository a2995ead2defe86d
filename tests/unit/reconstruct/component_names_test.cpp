// Components named after the labels of their contours.
#include "reconstruct/component_names.hpp"

#include <gtest/gtest.h>

#include <tetloft/reconstruct.hpp>

namespace tetloft {
namespace {

using internal::names_by_labels;

Contour square(double x) { return {{{x, 0}, {x + 1, 0}, {x + 1, 1}, {x, 1}}}; }

// Three tubes beside each other, the labels of two of them in no order.
SectionStack tubes() {
  SectionStack stack;
  for (const double z : {0.0, 1.0}) {
    Section section;
    section.z = z;
    for (const double x : {0.0, 10.0, 20.0}) section.contours.push_back(square(x));
    stack.sections.push_back(section);
  }
  return stack;
}

Label label(int section, int contour, std::uint32_t value) {
  return {SectionId(section), ContourId(contour), value};
}

// The component that the tube at this x is.
ComponentId component_at(const Model& model, double x) {
  for (const TetId t : model.tets.ids()) {
    const double at = model.points[model.tets[t][0]].x;
    if (at >= x && at <= x + 1) return model.component[t];
  }
  return {};
}

TEST(ComponentNames, AreThoseOfTheContoursLabels) {
  ReconstructOptions options;
  options.correspondence.labels = {label(1, 2, 7), label(0, 0, 12), label(0, 2, 7)};
  SectionStack stack = tubes();
  stack.about.name = "tubes";
  const auto solid = reconstruct(stack, options);
  ASSERT_TRUE(solid.ok());
  const Model& model = solid->model;
  ASSERT_EQ(model.component_names.size(), 3U);
  EXPECT_EQ(component_name(model, component_at(model, 0)), "label 12");
  EXPECT_EQ(component_name(model, component_at(model, 10)),
            "tubes " + std::to_string(component_at(model, 10).index() + 1));
  EXPECT_EQ(component_name(model, component_at(model, 20)), "label 7");
}

TEST(ComponentNames, AreNoneWithoutLabels) {
  const auto solid = reconstruct(tubes());
  ASSERT_TRUE(solid.ok());
  EXPECT_TRUE(solid->model.component_names.empty());
  EXPECT_TRUE(names_by_labels(solid->partition, 3, {}).empty());
}

}  // namespace
}  // namespace tetloft

// The list of a model's fields.
#include "model/fields.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <set>
#include <string>
#include <type_traits>

#include "model/well_formed.hpp"

namespace tetloft {

using namespace internal;
namespace {

TEST(ModelFields, AreNamedOnceAndSomeAreOnSurfaces) {
  std::set<std::string_view> names;
  std::set<std::string_view> on_surfaces;
  for_each_field([&](const auto& field) {
    EXPECT_TRUE(names.insert(field.name).second) << field.name;
    if (field.on_surfaces) on_surfaces.insert(field.name);
  });
  EXPECT_EQ(names, (std::set<std::string_view>{"component", "slab", "kind", "section", "contour",
                                               "origin"}));
  EXPECT_EQ(on_surfaces, (std::set<std::string_view>{"component", "section", "contour"}));
}

TEST(ModelFields, AreStoredWithinTheirRangeAndLoadedBack) {
  for_each_field([](const auto& field) {
    using Field = std::remove_cvref_t<decltype(field)>;
    using Stored = typename Field::Stored;
    using Type = typename Stored::Type;
    EXPECT_GE(Stored::kLeast, std::numeric_limits<Type>::min());
    EXPECT_LE(Stored::kLargest, std::numeric_limits<Type>::max());
    for (const std::int64_t value : {Stored::kLeast, std::int64_t{0}, Stored::kLargest}) {
      EXPECT_EQ(Stored::store(Stored::load(value)), value) << field.name;
      EXPECT_TRUE(Stored::legal(Stored::load(value))) << field.name;
    }
  });
  EXPECT_EQ(StoredAs<ComponentId>::store(ComponentId()), -1);
  EXPECT_FALSE(StoredAs<TetKind>::legal(static_cast<TetKind>(kTetKinds)));
  EXPECT_FALSE(StoredAs<PointOrigin>::legal(static_cast<PointOrigin>(kPointOrigins)));
}

// Two points and one tet: no size fits both.
TEST(ModelFields, AreCheckedForTheirSize) {
  for_each_field([](const auto& field) {
    using Field = std::remove_cvref_t<decltype(field)>;
    Model model;
    model.points.resize(2);
    model.tets.push_back({VertexId(0), VertexId(0), VertexId(1), VertexId(1)});
    EXPECT_TRUE(check_well_formed(model).ok());
    const std::size_t due = Field::kOfPoints ? 2 : 1;
    EXPECT_EQ(Field::due(model), due);
    (model.*field.values).resize(due, Field::Stored::load(0));
    EXPECT_TRUE(check_well_formed(model).ok()) << field.name;
    (model.*field.values).resize(3, Field::Stored::load(0));
    const auto refused = check_well_formed(model);
    ASSERT_FALSE(refused.ok()) << field.name;
    EXPECT_EQ(refused.error().message, "the model's array " + std::string(field.name) +
                                           " has 3 values where " + std::to_string(due) +
                                           " are due");
  });
}

}  // namespace
}  // namespace tetloft

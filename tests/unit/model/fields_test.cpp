// The list of a model's fields.
#include "model/fields.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <set>
#include <string>
#include <type_traits>

#include "model/tables.hpp"
#include "model/well_formed.hpp"
#include "support/same_rows.hpp"

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

TEST(ModelTables, HaveColumnsThatAreNamedOnceAfterTheirRows) {
  std::set<std::string_view> names;
  for_each_table([&](const auto& table) {
    for_each_column(table, [&](const auto& column) {
      EXPECT_TRUE(names.insert(column.name).second) << column.name;
      EXPECT_TRUE(column.name.starts_with(std::string(table.row) + '_')) << column.name;
    });
  });
  for_each_field([&](const auto& field) { EXPECT_FALSE(names.contains(field.name)); });
  EXPECT_EQ(names.size(), 11U + 5U + 12U + 6U);
}

// A row set column by column from another is that other.
template <class Table>
typename Table::Row copied(const Table& table, const typename Table::Row& row) {
  typename Table::Row copy;
  for_each_column(table, [&](const auto& column) {
    using Stored = typename std::remove_cvref_t<decltype(column)>::Stored;
    column.set(copy, Stored::load(Stored::store(column.get(row))));
  });
  return copy;
}

TEST(ModelTables, CarryWholeRows) {
  const ModelTable<RegionLink> links{"link", &Model::links};
  RegionLink link{
      SlabId(1), ContourId(2), ContourId(3), Evidence::lone, LinkFate::outruled, 0.1, 0.2,
      0.3,       0.4,          0.5};
  EXPECT_TRUE(test::same_row(copied(links, link), link));
  link.lead = std::nullopt;
  EXPECT_TRUE(test::same_row(copied(links, link), link));
  const RegionMotion motion{SlabId(4), true, ContourId(5), {0.25, -0.0}};
  EXPECT_TRUE(
      test::same_row(copied(ModelTable<RegionMotion>{"motion", &Model::motions}, motion), motion));
  link.lead = 0.5;
  VoidLink of_voids{link};
  of_voids.upper = ContourId();
  EXPECT_TRUE(
      test::same_row(copied(ModelTable<VoidLink>{"void", &Model::void_links}, of_voids), of_voids));
  const Deviation deviation{SlabId(4), true, ContourId(5), -3, 2};
  EXPECT_TRUE(test::same_row(
      copied(ModelTable<Deviation>{"deviation", &Model::deviations}, deviation), deviation));
}

TEST(ModelTables, AreCheckedRowByRow) {
  Model model;
  model.links.resize(2, {SlabId(0), ContourId(0), ContourId(0)});
  model.motions.resize(2, {SlabId(0), false, ContourId(0), {}});
  EXPECT_TRUE(check_well_formed(model).ok());
  model.links[1].lead = std::numeric_limits<double>::infinity();
  const auto refused = check_well_formed(model);
  ASSERT_FALSE(refused.ok());
  EXPECT_EQ(refused.error().message,
            "the model's link 1 has a value in link_lead that there is not");
  model.links.clear();
  model.motions[1].contour = ContourId();
  EXPECT_FALSE(check_well_formed(model).ok());
  model.motions.clear();
  model.void_links.resize(2);
  model.void_links[0].slab = model.void_links[1].slab = SlabId(0);
  EXPECT_TRUE(check_well_formed(model).ok());  // of the exteriors
  model.void_links[1].slab = SlabId();
  EXPECT_FALSE(check_well_formed(model).ok());
  model.void_links.clear();
  model.deviations.push_back({SlabId(0), false, ContourId(), 1, 2});
  EXPECT_FALSE(check_well_formed(model).ok());
}

}  // namespace
}  // namespace tetloft

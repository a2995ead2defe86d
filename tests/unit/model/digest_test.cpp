// Digests of models.
#include "model/digest.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <limits>
#include <set>
#include <type_traits>
#include <utility>

#include "model/fields.hpp"
#include "model/tables.hpp"

namespace tetloft {

using namespace internal;
namespace {

Model small_model() {
  Model model;
  for (const Point3& p : {Point3{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}) {
    model.points.push_back(p);
  }
  model.tets.push_back({VertexId(0), VertexId(1), VertexId(2), VertexId(3)});
  for_each_field([&](const auto& field) {
    using Field = std::remove_cvref_t<decltype(field)>;
    (model.*field.values).resize(Field::due(model), Field::Stored::load(0));
  });
  for_each_table([&](const auto& table) { (model.*table.rows).resize(2); });
  for (RegionLink& link : model.links) link.lead = 0;
  for (VoidLink& link : model.void_links) link.lead = 0;
  return model;
}

TEST(Digest, IsThatOfTheSameModel) {
  EXPECT_EQ(digest_of(small_model()), digest_of(small_model()));
  Model negative = small_model();
  negative.points[VertexId(0)].x = -0.0;  // which files lose where planes are exchanged
  EXPECT_EQ(digest_of(negative), digest_of(small_model()));
}

// Turned about an axis: signs of several coordinates.
TEST(Digest, IsAnotherWhereSignsChange) {
  Model turned = small_model();
  turned.points[VertexId(1)].x = -1;
  turned.points[VertexId(2)].y = -1;
  EXPECT_NE(digest_of(turned), digest_of(small_model()));
}

TEST(Digest, IsAnotherWhereAnythingDiffers) {
  std::set<std::uint64_t> seen{digest_of(small_model())};
  const auto expect_new = [&](const auto& change) {
    Model model = small_model();
    change(model);
    EXPECT_TRUE(seen.insert(digest_of(model)).second);
  };
  for (double Point3::*const x : {&Point3::x, &Point3::y, &Point3::z}) {
    expect_new([&](Model& model) {
      double& value = model.points[VertexId(3)].*x;
      value = std::nextafter(value, std::numeric_limits<double>::infinity());
    });
  }
  expect_new([](Model& model) { std::swap(model.tets[TetId(0)][0], model.tets[TetId(0)][1]); });
  expect_new([](Model& model) { model.points.push_back({}); });
  for_each_field([&](const auto& field) {
    using Field = std::remove_cvref_t<decltype(field)>;
    expect_new([&](Model& model) { (model.*field.values).raw().back() = Field::Stored::load(1); });
  });
  for_each_table([&](const auto& table) {
    expect_new([&](Model& model) { (model.*table.rows).emplace_back(); });
    for_each_column(table, [&](const auto& column) {
      using Value = typename std::remove_cvref_t<decltype(column)>::Value;
      using Stored = typename std::remove_cvref_t<decltype(column)>::Stored;
      expect_new([&](Model& model) {
        auto& row = (model.*table.rows).back();
        if constexpr (std::is_same_v<Value, bool>) {
          column.set(row, !column.get(row));
        } else if (Stored::store(column.get(row)) == Stored::store(Stored::load(1))) {
          column.set(row, Stored::load(0));
        } else {
          column.set(row, Stored::load(1));
        }
      });
    });
  });
  expect_new([](Model& model) { model.frame.origin.y = 1; });
  expect_new([](Model& model) { model.about.name = "liver"; });
  expect_new([](Model& model) { model.about.unit = "mm"; });
}

}  // namespace
}  // namespace tetloft

#include <tetloft/check.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "core/prng.hpp"

#include "support/refine/refine_model.hpp"
#include "unit/check/columns.hpp"
#include "unit/check/verdict_text.hpp"

namespace tetloft {

using namespace internal;
namespace {

using testing::Case;
using testing::vertex_at;

CheckReport checked(const Case& c, const CheckOptions& options = {}) {
  auto report = check(c.model, c.stack, options);
  EXPECT_TRUE(report.ok()) << (report.ok() ? "" : to_string(report.error()));
  return report.ok() ? *report : CheckReport{};
}

TEST(Check, PassesEachValidCase) {
  for (const Case& c : testing::all_cases()) {
    const CheckReport report = checked(c);
    EXPECT_TRUE(report.pass()) << testing::text(report);
    ASSERT_EQ(report.guarantees.size(), 5U);
    for (int g = 0; g < 5; ++g)
      EXPECT_EQ(report.guarantees[static_cast<std::size_t>(g)].number, g + 1);
  }
}

TEST(Check, PassesRandomColumnsAndCaps) {
  Prng prng(1);
  for (int trial = 0; trial < 200; ++trial) {
    std::vector<testing::Column> columns;
    for (int k = 0; k < 3; ++k) {
      const testing::Shape shape = testing::moved(testing::random_shape(prng, 8, 5), 10 * k,
                                                  static_cast<double>(prng.below(5)));
      switch (prng.below(3)) {
        case 0: columns.push_back({shape, {0, 1, 2}}); break;
        case 1: columns.push_back({shape, {0, 1, 1.25}}); break;
        default: columns.push_back({shape, {0.5, 1, 1.5}});
      }
    }
    const CheckReport report = checked(testing::extrude(columns, {0, 1, 2}));
    EXPECT_TRUE(report.pass()) << "trial " << trial << "\n" << testing::text(report);
    EXPECT_EQ(report.components, 3U);
  }
}

// Where a mesher may put a vertex: into an edge inside a section or on a contour, into a face, at
// an end or in the stack, and into a tet.
TEST(Check, PassesRefinedModels) {
  const Case plain = testing::slabs_case();
  for (const double z : {0.0, 1.0, 3.0}) {
    const auto vertex = [&](double x, double y) { return vertex_at(plain.model, x, y, z); };
    struct Inserted {
      std::vector<VertexId> into;
      Point3 at;
      std::size_t inner;
    };
    for (const auto& [into, at, inner] :
         {Inserted{{vertex(4, 0), vertex(0, 4)}, {2, 2, z}, 1},
          Inserted{{vertex(4, 0), vertex(0, 4)}, {2.5, 1.5, z}, 1},
          Inserted{{vertex(0, 0), vertex(4, 0), vertex(0, 4)}, {1, 1, z}, 1},
          // An ulp of the contour's coordinates off the contour, but inside.
          Inserted{{vertex(0, 0), vertex(4, 0), vertex(0, 4)}, {2, 0x1p-50, z}, 1},
          Inserted{{vertex(0, 0), vertex(4, 0)}, {1, 0, z}, 0},
          Inserted{{vertex(0, 0), vertex(4, 0)}, {1, 0x1p-50, z}, 0}}) {
      Case c = plain;
      ASSERT_TRUE(testing::insert_vertex(c.model, into, at));
      const CheckReport report = checked(c);
      EXPECT_TRUE(report.pass()) << z << "\n" << testing::text(report);
      EXPECT_EQ(report.inner_vertices, inner);
    }
  }
  Case c = plain;
  const TetVertices tet = plain.model.tets[TetId(0)];
  Point3 sum{0, 0, 0};
  for (const VertexId v : tet) {
    const Point3& p = c.model.points[v];
    sum = {sum.x + p.x, sum.y + p.y, sum.z + p.z};
  }
  ASSERT_TRUE(testing::insert_vertex(c.model, tet, {sum.x / 4, sum.y / 4, sum.z / 4}));
  EXPECT_TRUE(checked(c).pass()) << testing::text(checked(c));
  EXPECT_EQ(checked(c).inner_vertices, 0U);
}

TEST(Check, CountsComponentsAndGenus) {
  EXPECT_EQ(checked(testing::pair_case()).components, 2U);
  EXPECT_EQ(checked(testing::pair_case()).genus, (std::vector<long>{0, 0}));
  EXPECT_EQ(checked(testing::tube_case()).components, 1U);
  EXPECT_EQ(checked(testing::tube_case()).genus, (std::vector<long>{1}));
}

TEST(Check, AddsUpTheVolume) {
  EXPECT_DOUBLE_EQ(checked(testing::slabs_case()).volume, 48);
  EXPECT_DOUBLE_EQ(checked(testing::tube_case()).volume, 64);
}

TEST(Check, TellsTheSmallestDihedralOfACornerOfACube) {
  Case corner = testing::prism_case();
  corner.model.points =
      IdVector<VertexId, Point3>(std::vector<Point3>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}});
  corner.model.tets.clear();
  corner.model.tets.push_back({VertexId(0), VertexId(1), VertexId(2), VertexId(3)});
  EXPECT_NEAR(checked(corner).smallest_dihedral_degrees, 54.735610317245346, 1e-9);
}

TEST(Check, FindsNoOvershootInColumns) {
  for (const Case& c : testing::all_cases()) EXPECT_EQ(checked(c).overshoot, 0);
}

TEST(Check, MeasuresOvershootOfACapThatLeans) {
  Case c = testing::isolated_case();
  // The cap at z = 2 lies in the slab from 1 to 3, over the square from x = 10 to 14.
  c.model.points[testing::vertex_at(c.model, 14, 4, 2)] = {17, 4, 2};
  const CheckReport report = checked(c);
  EXPECT_TRUE(report.pass()) << testing::text(report);
  EXPECT_DOUBLE_EQ(report.overshoot, 1.5);
}

TEST(Check, MeasuresInsertedVerticesInUlps) {
  // 11/3 rounds up by half a unit, 1/3 down by almost nothing.
  const double ulps = checked(testing::split_case()).largest_split_ulps;
  EXPECT_GT(ulps, 0);
  EXPECT_LT(ulps, 1);
}

TEST(Check, PassesAnEmptyModelOfNoStack) {
  SectionStack empty;
  empty.sections.push_back({0, {}});
  EXPECT_EQ(check(Model{}, empty).error().code, ErrorCode::invalid_input);
  const CheckReport report = *check(Model{}, testing::prism_case().stack);
  EXPECT_FALSE(report.guarantees[1].pass);
  EXPECT_FALSE(report.guarantees[3].pass);
}

TEST(Check, SurvivesGarbage) {
  Prng prng(11);
  const std::vector<Case> stacks = testing::all_cases();
  for (int trial = 0; trial < 600; ++trial) {
    const Case& from = stacks[prng.below(stacks.size())];
    Model garbage = from.model;
    const auto coordinate = [&]() -> double {
      switch (prng.below(10)) {
        case 0: return std::nan("");
        case 1: return -std::numeric_limits<double>::infinity();
        case 2: return 0x1.fp1023;
        case 3: return -0x1.fp1023;
        case 4: return 0x1p-1074;
        default: return static_cast<double>(prng.below(5));
      }
    };
    const std::uint64_t changes = 1 + prng.below(20);
    for (std::uint64_t k = 0; k < changes; ++k) {
      const VertexId v(prng.below(garbage.points.size() + 1));
      if (prng.chance(0.3)) {
        garbage.points.push_back({coordinate(), coordinate(), coordinate()});
      } else if (prng.chance(0.5) && v.index() < garbage.points.size()) {
        garbage.points[v] = {coordinate(), coordinate(), static_cast<double>(prng.below(3))};
      } else {
        garbage.tets.raw()[prng.below(garbage.tets.size())][prng.below(4)] =
            prng.chance(0.1) ? VertexId() : v;
      }
    }
    // One change more that no model survives.
    garbage.tets.push_back({VertexId(0), VertexId(0), VertexId(1), VertexId(2)});
    const auto report = check(garbage, from.stack);
    ASSERT_TRUE(report.ok()) << to_string(report.error());
    EXPECT_FALSE(report->guarantees[0].pass);
  }
}

TEST(Check, LimitsThePlacesItNames) {
  Case c = testing::slabs_case();
  for (TetVertices& tet : c.model.tets) std::swap(tet[0], tet[1]);
  CheckOptions options;
  options.places = 2;
  const auto report = check(c.model, c.stack, options);
  ASSERT_EQ(report->guarantees[2].failures.size(), 1U);
  EXPECT_EQ(report->guarantees[2].failures[0].count, c.model.tets.size());
  EXPECT_EQ(report->guarantees[2].failures[0].places, (std::vector<std::string>{"tet 0", "tet 1"}));
}

TEST(Check, RefusesAnInvalidStack) {
  Case c = testing::prism_case();
  c.stack.sections[SectionId(1)].z = 0;
  const auto report = check(c.model, c.stack);
  ASSERT_FALSE(report.ok());
  EXPECT_EQ(report.error().code, ErrorCode::invalid_input);
}

TEST(Check, RefusesOptionsOutOfRange) {
  const Case c = testing::prism_case();
  CheckOptions options;
  options.split_ulps = -1;
  EXPECT_EQ(check(c.model, c.stack, options).error().code, ErrorCode::usage);
  options = {};
  options.correspondence.tau = -0.5;
  EXPECT_EQ(check(c.model, c.stack, options).error().code, ErrorCode::usage);
}

TEST(Check, RefusesLabelsOfNoContourAndTwoInOneRegion) {
  const Case c = testing::tube_case();
  CheckOptions options;
  options.correspondence.labels = {{SectionId(3), ContourId(0), 1}};
  EXPECT_EQ(check(c.model, c.stack, options).error().code, ErrorCode::invalid_input);
  options.correspondence.labels = {{SectionId(0), ContourId(0), 1},
                                   {SectionId(0), ContourId(1), 2}};
  EXPECT_EQ(check(c.model, c.stack, options).error().code, ErrorCode::invalid_input);
}

}  // namespace
}  // namespace tetloft

// The numbers of a report against what is counted and measured without its code.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include <tetloft/report_page.hpp>

#include "report/quality.hpp"
#include "unit/render/boxes.hpp"
#include "unit/report/solids.hpp"

namespace tetloft {
namespace {

using test::Measured;
using test::measured;

class BlocksReport : public ::testing::Test {
 protected:
  static const Report& report() {
    static const Report made = [] {
      auto result = render_report(model(), &stack());
      EXPECT_TRUE(result.ok()) << (result.ok() ? "" : to_string(result.error()));
      return *std::move(result);
    }();
    return made;
  }
  static const SectionStack& stack() {
    static const SectionStack blocks = test::stack_of(test::kBlocks);
    return blocks;
  }
  static const Model& model() {
    static const Model made = test::model_of(stack());
    return made;
  }
};

TEST_F(BlocksReport, MeasuresEachComponent) {
  const auto& components = report().figures.components;
  ASSERT_EQ(components.size(), 3U);
  const std::vector<std::size_t> cavities{1, 0, 0};
  const std::vector<long> genus{0, 1, 0};
  for (std::size_t c = 0; c < 3; ++c) {
    const Measured expected = measured(model(), static_cast<long>(c));
    const ReportMeasures& got = components[c].measures;
    EXPECT_NEAR(got.volume, expected.volume, 1e-9 * expected.volume) << c;
    EXPECT_NEAR(got.surface_area, expected.area, 1e-9 * expected.area) << c;
    EXPECT_EQ(got.surfaces, cavities[c] + 1) << c;
    EXPECT_EQ(got.cavities, cavities[c]) << c;
    EXPECT_EQ(got.genus, genus[c]) << c;
    // Each surface has 2 − 2 genus.
    EXPECT_EQ(2 * static_cast<long>(got.surfaces) - 2 * got.genus.value_or(0), expected.euler);
    EXPECT_EQ(got.first, SectionId(c == 2 ? 1U : 0U));
    EXPECT_EQ(got.last, SectionId(2U));
    EXPECT_EQ(got.tets, static_cast<std::size_t>(std::count(
                            model().component.begin(), model().component.end(), ComponentId(c))));
  }
}

TEST_F(BlocksReport, SumsUp) {
  const ReportFigures& figures = report().figures;
  const Measured expected = measured(model());
  EXPECT_NEAR(figures.all.volume, expected.volume, 1e-9 * expected.volume);
  EXPECT_NEAR(figures.all.surface_area, expected.area, 1e-9 * expected.area);
  EXPECT_EQ(figures.all.tets, model().tets.size());
  EXPECT_EQ(figures.all.cavities, 1U);
  EXPECT_EQ(figures.all.genus, 1);
  EXPECT_EQ(figures.boundary_triangles, expected.surface);
  EXPECT_EQ(figures.quality.edges, expected.edges);
  ASSERT_EQ(figures.kinds.size(), static_cast<std::size_t>(kTetKinds));
  for (int k = 0; k < kTetKinds; ++k) {
    EXPECT_EQ(figures.kinds[static_cast<std::size_t>(k)],
              static_cast<std::size_t>(
                  std::count(model().kind.begin(), model().kind.end(), static_cast<TetKind>(k))));
  }
}

TEST_F(BlocksReport, AgreesWithTheCheck) {
  ASSERT_TRUE(report().check.has_value());
  EXPECT_TRUE(report().pass());
  for (const ReportGuarantee& guarantee : report().guarantees) {
    EXPECT_EQ(guarantee.verdict, ReportVerdict::holds) << guarantee.name;
  }
  const CheckReport& check = *report().check;
  EXPECT_EQ(check.cavities, report().figures.all.cavities);
  EXPECT_EQ(check.volume, report().figures.all.volume);
  EXPECT_EQ(check.smallest_dihedral_degrees, report().figures.quality.dihedral.least);
  EXPECT_EQ(check.components, report().figures.components.size());
}

TEST_F(BlocksReport, EdgeLengthsAreCountedOnce) {
  const ReportQuality& quality = report().figures.quality;
  const Measured expected = measured(model());
  EXPECT_DOUBLE_EQ(quality.edge_length.least, expected.shortest);
  EXPECT_DOUBLE_EQ(quality.edge_length.most, expected.longest);
  std::size_t sum = 0;
  for (const std::size_t count : quality.edge_lengths.counts) sum += count;
  EXPECT_EQ(sum, expected.edges);
  EXPECT_EQ(quality.edge_lengths.edges.front(), quality.edge_length.least);
  EXPECT_EQ(quality.edge_lengths.edges.back(), quality.edge_length.most);
}

// By normals and the arc cosine.
TEST_F(BlocksReport, AnglesAreThoseBetweenFaces) {
  std::vector<std::size_t> counts(36, 0);
  std::vector<double> all;
  for (const TetVertices& tet : model().tets) {
    const auto at = [&](std::size_t i) { return model().points[tet[i]]; };
    for (std::size_t i = 0; i < 4; ++i) {
      for (std::size_t j = i + 1; j < 4; ++j) {
        // The parts of the two other corners that are normal to the edge.
        std::vector<Point3> sides;
        const Point3 a = at(i), b = at(j);
        const Point3 e{b.x - a.x, b.y - a.y, b.z - a.z};
        const double ee = e.x * e.x + e.y * e.y + e.z * e.z;
        for (std::size_t k = 0; k < 4; ++k) {
          if (k == i || k == j) continue;
          const Point3 d{at(k).x - a.x, at(k).y - a.y, at(k).z - a.z};
          const double part = (d.x * e.x + d.y * e.y + d.z * e.z) / ee;
          sides.push_back({d.x - part * e.x, d.y - part * e.y, d.z - part * e.z});
        }
        const auto dot = [](const Point3& p, const Point3& q) {
          return p.x * q.x + p.y * q.y + p.z * q.z;
        };
        const double cosine =
            dot(sides[0], sides[1]) / std::sqrt(dot(sides[0], sides[0]) * dot(sides[1], sides[1]));
        all.push_back(std::acos(std::clamp(cosine, -1.0, 1.0)) * 180 / std::numbers::pi);
      }
    }
  }
  const ReportQuality& quality = report().figures.quality;
  ASSERT_EQ(quality.dihedrals.counts.size(), 36U);
  // Angles on an edge of two bins may fall to either side.
  constexpr double kNear = 1e-6;
  for (std::size_t bin = 0; bin < 36; ++bin) {
    std::size_t least = 0, most = 0;
    for (const double angle : all) {
      const double low = 5.0 * static_cast<double>(bin);
      if (angle > low + kNear && angle < low + 5 - kNear) ++least;
      if (angle > low - kNear && angle < low + 5 + kNear) ++most;
    }
    EXPECT_GE(quality.dihedrals.counts[bin], least) << bin;
    EXPECT_LE(quality.dihedrals.counts[bin], most) << bin;
  }
  std::sort(all.begin(), all.end());
  EXPECT_NEAR(quality.dihedral.least, all.front(), 1e-5);
  EXPECT_NEAR(quality.dihedral.median, all[(all.size() - 1) / 2], 1e-5);
  EXPECT_NEAR(quality.dihedral.most, all.back(), 1e-5);
}

TEST_F(BlocksReport, TheSolidFillsItsSections) {
  const ReportFigures& figures = report().figures;
  ASSERT_EQ(figures.sections.size(), 3U);
  const std::vector<double> areas{64 + 60, 60 + 60 + 16, 64 + 60 + 16};
  for (std::size_t s = 0; s < 3; ++s) {
    EXPECT_DOUBLE_EQ(figures.sections[s].area, areas[s]);
    const double z = figures.sections[s].z;
    const auto at = std::find_if(figures.solid.begin(), figures.solid.end(),
                                 [&](const ReportArea& area) { return area.z == z; });
    ASSERT_NE(at, figures.solid.end());
    EXPECT_NEAR(at->area, areas[s], 1e-9) << s;
  }
  // The areas, summed up over heights, are the volume.
  double sum = 0;
  for (std::size_t k = 0; k + 1 < figures.solid.size(); ++k) {
    sum += (figures.solid[k + 1].z - figures.solid[k].z) *
           (figures.solid[k].area + figures.solid[k + 1].area) / 2;
  }
  EXPECT_NEAR(sum, figures.all.volume, 0.01 * figures.all.volume);
  EXPECT_NEAR(figures.volume_between.value_or(0), figures.all.volume, 1e-9);
}

TEST(ReportFigures, OfBoxesAreKnown) {
  const Model boxes = test::boxes(2, 3);
  const auto report = render_report(boxes, nullptr);
  ASSERT_TRUE(report.ok()) << to_string(report.error());
  const ReportFigures& figures = report->figures;
  ASSERT_EQ(figures.components.size(), 3U);
  for (const ReportComponent& component : figures.components) {
    EXPECT_DOUBLE_EQ(component.measures.volume, 24);
    EXPECT_DOUBLE_EQ(component.measures.surface_area, 2 * 4 + 4 * 12);
    EXPECT_EQ(component.measures.genus, 0);
    EXPECT_EQ(component.measures.tets, 12U);
  }
  EXPECT_EQ(figures.components[1].name, "component 2");
  for (const ReportArea& area : figures.solid) EXPECT_NEAR(area.area, 12, 1e-12) << area.z;
  EXPECT_DOUBLE_EQ(figures.quality.edge_length.least, 2);
  EXPECT_DOUBLE_EQ(figures.quality.edge_length.most, std::sqrt(17.0));
  EXPECT_FALSE(figures.volume_between.has_value());
}

TEST(ReportFigures, ScaleWithTheModel) {
  Model small = test::boxes(2);
  Model large = small;
  for (Point3& p : large.points) {
    p = {std::ldexp(p.x, 300), std::ldexp(p.y, 300), std::ldexp(p.z, 300)};
  }
  const auto a = render_report(small, nullptr);
  const auto b = render_report(large, nullptr);
  ASSERT_TRUE(a.ok() && b.ok());
  EXPECT_EQ(b->figures.all.volume, std::ldexp(a->figures.all.volume, 900));
  EXPECT_EQ(b->figures.all.surface_area, std::ldexp(a->figures.all.surface_area, 600));
  EXPECT_EQ(b->figures.quality.edge_length.median,
            std::ldexp(a->figures.quality.edge_length.median, 300));
  EXPECT_EQ(b->figures.quality.mean_ratio.median, a->figures.quality.mean_ratio.median);
  EXPECT_EQ(b->figures.quality.dihedrals.counts, a->figures.quality.dihedrals.counts);
}

// Voxels that are not cubes: the frame tells how long the axes are.
TEST(ReportFigures, AreThoseOfTheFile) {
  Model model = test::boxes(1);
  model.frame.axes = {Point3{1, 0, 0}, Point3{0, 2, 0}, Point3{0, 0, 3}};
  const auto report = render_report(model, nullptr);
  ASSERT_TRUE(report.ok());
  EXPECT_DOUBLE_EQ(report->figures.all.volume, 12 * 6);
  EXPECT_DOUBLE_EQ(report->figures.all.surface_area, 2 * (2 * 4 + 2 * 9 + 4 * 9));
  EXPECT_DOUBLE_EQ(report->figures.solid[1].area, 2 * 4);
  EXPECT_DOUBLE_EQ(report->figures.quality.edge_length.most, std::sqrt(4.0 + 16 + 81));
}

TEST(ReportFigures, ARegularTetIsTheBest) {
  Model model;
  for (const Point3& p : {Point3{1, 1, 1}, {-1, -1, 1}, {-1, 1, -1}, {1, -1, -1}}) {
    model.points.push_back(p);
  }
  model.tets.push_back({VertexId(0U), VertexId(1U), VertexId(2U), VertexId(3U)});
  const auto report = render_report(model, nullptr);
  ASSERT_TRUE(report.ok()) << to_string(report.error());
  EXPECT_NEAR(report->figures.quality.mean_ratio.least, 1, 1e-12);
  EXPECT_NEAR(report->figures.quality.dihedral.most, std::acos(1.0 / 3) * 180 / std::numbers::pi,
              1e-9);
  EXPECT_EQ(report->figures.quality.edge_lengths.counts, (std::vector<std::size_t>{6}));
  EXPECT_EQ(report->figures.components.size(), 1U);
}

TEST(Histogram, CountsEachValueOnce) {
  const auto linear = internal::report::linear_histogram({-1, 0, 0.5, 1, 1.5, 2, 3}, 0, 2, 2);
  EXPECT_EQ(linear.counts, (std::vector<std::size_t>{3, 4}));
  const auto logarithmic = internal::report::logarithmic_histogram({1, 5, 20, 100}, 2);
  EXPECT_EQ(logarithmic.counts, (std::vector<std::size_t>{2, 2}));
  EXPECT_NEAR(logarithmic.edges[1], 10, 1e-12);
  EXPECT_TRUE(internal::report::logarithmic_histogram({}, 5).counts.empty());
  EXPECT_TRUE(internal::report::logarithmic_histogram({0, 0}, 5).counts.empty());
  EXPECT_EQ(internal::report::logarithmic_histogram({7, 7}, 5).counts,
            (std::vector<std::size_t>{2}));
}

TEST(Spread, HasTheLowerMedian) {
  std::vector<double> values{4, 1, 3, 2};
  const ReportSpread spread = internal::report::spread_of(values);
  EXPECT_EQ(spread.least, 1);
  EXPECT_EQ(spread.median, 2);
  EXPECT_EQ(spread.most, 4);
}

}  // namespace
}  // namespace tetloft

// From drawings to stacks: which lines count, planes in any direction, places, labels.
#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include <tetloft/formats.hpp>

#include "io/drawing/choose_lines.hpp"
#include "io/drawing/stack_of_drawing.hpp"

namespace tetloft {

using namespace internal;
namespace {

using io::Drawing;
using io::DrawnLine;
using io::LineKind;

using Map = std::function<Point3(const Point3&)>;

Point3 unchanged(const Point3& p) { return p; }

DrawnLine line_of(std::vector<Point3> points, LineKind kind = LineKind::closed) {
  DrawnLine line;
  line.points = std::move(points);
  line.kind = kind;
  return line;
}

// A square of side 2 `half` around (x, y) at height z, taken elsewhere by `map`.
DrawnLine square(double x, double y, double half, double z, const Map& map = unchanged) {
  DrawnLine line;
  for (const Point3& p : {Point3{x - half, y - half, z}, Point3{x + half, y - half, z},
                          Point3{x + half, y + half, z}, Point3{x - half, y + half, z}}) {
    line.points.push_back(map(p));
  }
  return line;
}

Drawing one_structure(std::vector<DrawnLine> lines) {
  Drawing drawing;
  drawing.structures.push_back({1, "body", std::move(lines)});
  return drawing;
}

Drawing tower(std::size_t sections, const Map& map = unchanged) {
  std::vector<DrawnLine> lines;
  for (std::size_t s = 0; s < sections; ++s) {
    lines.push_back(square(5, 7, 2, 3 * static_cast<double>(s), map));
  }
  return one_structure(std::move(lines));
}

ReadStack made_of(Drawing drawing, const ReadOptions& options = {}) {
  Result<io::StackOfFile> made = io::stack_of_drawing(std::move(drawing), "file", options);
  if (!made) throw std::runtime_error(to_string(made.error()));
  return std::move(made->read);
}

Error refusal_of(Drawing drawing, const ReadOptions& options = {}) {
  const Result<io::StackOfFile> read = io::stack_of_drawing(std::move(drawing), "file", options);
  return read ? Error{ErrorCode::internal, "was read", {}} : read.error();
}

bool warns(const ReadStack& read, const std::string& words) {
  for (const Warning& warning : read.warnings) {
    if (warning.message.find(words) != std::string::npos) return true;
  }
  return false;
}

// Where the vertices of the stack lie in the file, in the order of the file's lines.
std::vector<Point3> placed_vertices(const SectionStack& stack) {
  std::vector<Point3> points;
  for (const Section& section : stack.sections) {
    for (const Contour& contour : section.contours) {
      for (const Point2& p : contour.vertices) {
        points.push_back(place(stack.frame, {p.x, p.y, section.z}));
      }
    }
  }
  return points;
}

std::vector<Point3> points_of(const Drawing& drawing) {
  std::vector<Point3> points;
  for (const DrawnLine& line : drawing.structures[0].lines) {
    points.insert(points.end(), line.points.begin(), line.points.end());
  }
  return points;
}

TEST(StackOfDrawing, PlanesOfConstantZStayAsTheyAre) {
  const ReadStack read = made_of(tower(3));
  EXPECT_EQ(read.stack.frame, Frame{});
  ASSERT_EQ(read.stack.sections.size(), 3U);
  EXPECT_EQ(read.stack.sections[SectionId(1)].z, 3);
  EXPECT_EQ(placed_vertices(read.stack), points_of(tower(3)));
  EXPECT_TRUE(read.warnings.empty());
}

TEST(StackOfDrawing, PlanesAcrossOtherAxesAreTurnedWithoutLosingABit) {
  const Map sagittal = [](const Point3& p) { return Point3{p.z + 0.1, p.x / 3, p.y}; };
  const Map coronal = [](const Point3& p) { return Point3{p.x / 3, p.z + 0.1, -p.y}; };
  for (const Map& map : {sagittal, coronal}) {
    const ReadStack read = made_of(tower(3, map));
    EXPECT_TRUE(is_exact(read.stack.frame));
    EXPECT_NE(read.stack.frame, Frame{});
    EXPECT_EQ(placed_vertices(read.stack), points_of(tower(3, map)));
  }
}

// By 30 degrees about one axis, then 20 about another.
Point3 tilted(const Point3& p) {
  const double c = std::sqrt(3.0) / 2;
  const double s = 0.5;
  const Point3 q{c * p.x - s * p.z, p.y, s * p.x + c * p.z};
  const double d = 0.9396926207859084;
  const double t = 0.3420201433256687;
  return {q.x, d * q.y - t * q.z, t * q.y + d * q.z};
}

TEST(StackOfDrawing, ObliquePlanesAreTurnedAndPlacedBack) {
  const ReadStack read = made_of(tower(4, tilted));
  ASSERT_EQ(read.stack.sections.size(), 4U);
  for (std::size_t s = 1; s < 4; ++s) {
    EXPECT_NEAR(read.stack.sections[SectionId(s)].z - read.stack.sections[SectionId(s - 1)].z, 3,
                1e-12);
  }
  const std::vector<Point3> due = points_of(tower(4, tilted));
  const std::vector<Point3> got = placed_vertices(read.stack);
  ASSERT_EQ(got.size(), due.size());
  for (std::size_t i = 0; i < due.size(); ++i) {
    EXPECT_NEAR(got[i].x, due[i].x, 1e-7);
    EXPECT_NEAR(got[i].y, due[i].y, 1e-7);
    EXPECT_NEAR(got[i].z, due[i].z, 1e-7);
  }
}

TEST(StackOfDrawing, ContoursThatAreNotParallelAreNamed) {
  Drawing drawing = tower(3);
  drawing.structures[0].lines.push_back(square(0, 0, 2, 12, tilted));
  drawing.structures[0].lines.back().line = 77;
  const Error error = refusal_of(std::move(drawing));
  EXPECT_EQ(error.code, ErrorCode::invalid_input);
  EXPECT_EQ(error.where.line, 77U);
  EXPECT_NE(error.message.find("parallel"), std::string::npos) << error.message;
}

TEST(StackOfDrawing, HeightsWithinTheToleranceAreOnePlane) {
  Drawing drawing = one_structure({square(0, 0, 1, 0), square(5, 0, 1, 0.01), square(9, 0, 1, 0),
                                   square(0, 0, 1, 3), square(0, 0, 1, 6.001)});
  ReadStack read = made_of(drawing);
  ASSERT_EQ(read.stack.sections.size(), 3U);
  EXPECT_EQ(read.stack.sections[SectionId(0)].z, 0);  // that of most
  EXPECT_EQ(read.stack.sections[SectionId(0)].contours.size(), 3U);
  EXPECT_TRUE(warns(read, "put into the planes"));
  ReadOptions narrow;
  narrow.plane_tolerance = 1e-3;
  EXPECT_EQ(made_of(drawing, narrow).stack.sections.size(), 4U);
}

TEST(StackOfDrawing, MissingPlanesAndUnevenGapsAreTold) {
  std::vector<DrawnLine> lines;
  for (const double z : {0.0, 2.0, 4.0, 10.0, 12.0}) lines.push_back(square(0, 0, 1, z));
  EXPECT_TRUE(warns(made_of(one_structure(lines)), "2 planes seem to be missing"));
  lines.push_back(square(0, 0, 1, 12.7));
  EXPECT_TRUE(warns(made_of(one_structure(lines)), "uneven"));
}

TEST(StackOfDrawing, OpenLinesAreRefusedOrLeftOut) {
  Drawing drawing = tower(2);
  drawing.structures[0].lines[1].kind = LineKind::open;
  drawing.structures[0].lines[1].line = 9;
  const Error error = refusal_of(drawing);
  EXPECT_EQ(error.where.line, 9U);
  EXPECT_NE(error.message.find("--close-on-frame"), std::string::npos);
  drawing.leaves_out_open = true;
  drawing.structures[0].lines[1].type = "OPEN_PLANAR";
  const ReadStack read = made_of(drawing);
  EXPECT_EQ(read.stack.contour_count(), 1U);
  EXPECT_TRUE(warns(read, "OPEN_PLANAR"));
}

TEST(StackOfDrawing, RepeatedPointsAndShortContoursAreDropped) {
  Drawing drawing = tower(2);
  std::vector<Point3>& points = drawing.structures[0].lines[0].points;
  points.insert(points.begin() + 1, points[1]);
  points.push_back(points[0]);
  drawing.structures[0].lines.push_back(line_of({{1, 1, 0}, {2, 1, 0}}));
  const ReadStack read = made_of(drawing);
  EXPECT_EQ(read.stack.vertex_count(), 8U);
  EXPECT_TRUE(warns(read, "1 contour of one or two points"));
  EXPECT_EQ(refusal_of(one_structure({line_of({{1, 1, 0}})})).code, ErrorCode::invalid_input);
}

Drawing two_structures() {
  Drawing drawing = tower(2);
  drawing.apart = true;
  drawing.structures.push_back({7, "Lung", {square(1, 1, 1, 0), square(1, 1, 1, 1)}});
  return drawing;
}

TEST(StackOfDrawing, AStructureIsChosenByNameOrNumber) {
  const auto with = [](const std::string& structure) {
    ReadOptions options;
    options.structure = structure;
    return options;
  };
  const Error error = refusal_of(two_structures());
  EXPECT_EQ(error.code, ErrorCode::usage);
  EXPECT_NE(error.message.find("7 'Lung'"), std::string::npos) << error.message;
  for (const char* name : {"Lung", "lung", "7"}) {
    EXPECT_EQ(made_of(two_structures(), with(name)).stack.about.name, "Lung") << name;
  }
  EXPECT_EQ(refusal_of(two_structures(), with("Lunge")).code, ErrorCode::usage);
  Drawing twins = two_structures();
  twins.structures[0].name = "Lung";
  const Error several = refusal_of(twins, with("Lung"));
  EXPECT_EQ(several.code, ErrorCode::usage);
  EXPECT_NE(several.message.find("#1, #7"), std::string::npos) << several.message;
  EXPECT_EQ(made_of(twins, with("#7")).stack.vertex_count(), 8U);
  EXPECT_NE(refusal_of(two_structures(), with("Lunge")).message.find("Lung"), std::string::npos);
}

TEST(StackOfDrawing, TheOnlyStructureWithContoursNeedsNoChoice) {
  Drawing drawing = two_structures();
  drawing.structures[0].lines.clear();
  EXPECT_EQ(made_of(drawing).stack.about.name, "Lung");
}

TEST(FindStructure, PrefersNamesToNumbersAndTakesNoSideInDoubt) {
  const std::vector<std::pair<double, std::string>> known{{1, "2"}, {2, "a"}, {3, "A"}, {4, "b"}};
  EXPECT_EQ(io::find_structure("2", known), 0U);
  EXPECT_EQ(io::find_structure("#2", known), 1U);
  EXPECT_EQ(io::find_structure("a", known), 1U);
  EXPECT_EQ(io::find_structure("B", known), 3U);
  EXPECT_EQ(io::find_structure("4", known), 3U);
  EXPECT_EQ(io::find_structure("c", known), std::nullopt);
  const std::vector<std::pair<double, std::string>> twins{{1, "x"}, {2, "x"}};
  EXPECT_EQ(io::find_structure("x", twins), std::nullopt);
  EXPECT_EQ(io::find_structure("X", twins), std::nullopt);
}

TEST(StackOfDrawing, LabelsOfLinesBecomeThoseOfOuterContours) {
  Drawing drawing = one_structure({square(0, 0, 4, 0), square(0, 0, 2, 0), square(9, 0, 2, 0),
                                   square(0, 0, 4, 1), square(9, 0, 2, 1)});
  drawing.labelled = true;
  const std::vector<std::int64_t> labels{1, 1, 2, 1, 2};
  for (std::size_t i = 0; i < labels.size(); ++i) drawing.structures[0].lines[i].label = labels[i];
  const ReadStack read = made_of(drawing);
  ASSERT_EQ(read.labels.labels.size(), 4U);  // not the hole's
  EXPECT_EQ(read.labels.labels[1].contour, ContourId(2));
  EXPECT_EQ(read.labels.labels[1].label, 2U);
  ReadOptions options;
  options.structure = "2";
  EXPECT_EQ(made_of(drawing, options).stack.contour_count(), 2U);
}

TEST(StackOfDrawing, AdjacencyBecomesLabels) {
  // Two bodies in section 0, of which one goes on; a hole each in what goes on.
  Drawing drawing = one_structure({square(0, 0, 4, 0), square(0, 0, 1, 0), square(20, 0, 2, 0),
                                   square(0, 0, 4, 1), square(0, 0, 1, 1)});
  drawing.joins = {{0, 3}, {1, 4}, {2, 4}};  // the last one joins a body to a hole
  const Labels labels = made_of(drawing).labels;
  ASSERT_EQ(labels.labels.size(), 3U);
  ASSERT_EQ(labels.hole_labels.size(), 2U);
  EXPECT_EQ(labels.labels[0].label, labels.labels[2].label);
  EXPECT_NE(labels.labels[0].label, labels.labels[1].label);
  EXPECT_EQ(labels.hole_labels[0].label, labels.hole_labels[1].label);
}

TEST(StackOfDrawing, WhatMayTouchIsRepaired) {
  // A hole cut to the outline along a doubled edge.
  DrawnLine keyhole;
  for (const Point3& p : std::vector<Point3>{{0, 0, 0},
                                             {9, 0, 0},
                                             {9, 9, 0},
                                             {0, 9, 0},
                                             {0, 4, 0},
                                             {3, 4, 0},
                                             {3, 6, 0},
                                             {6, 6, 0},
                                             {6, 3, 0},
                                             {3, 3, 0},
                                             {3, 4, 0},
                                             {0, 4, 0}}) {
    keyhole.points.push_back(p);
  }
  Drawing drawing = one_structure({keyhole});
  EXPECT_EQ(refusal_of(drawing).code, ErrorCode::invalid_input);
  EXPECT_NE(refusal_of(drawing).message.find("contour 0"), std::string::npos);
  drawing.may_touch = true;
  const ReadStack read = made_of(drawing);
  EXPECT_EQ(read.stack.contour_count(), 2U);
  EXPECT_TRUE(warns(read, "repaired"));
}

TEST(SummaryOfDrawing, CountsWhatStandsInTheFile) {
  Drawing drawing = two_structures();
  drawing.structures[0].lines[0].type = "CLOSED_PLANAR";
  drawing.structures[0].lines.push_back(line_of({{1, 2, 30}}, LineKind::points));
  const FileSummary summary = io::summary_of_drawing(drawing);
  ASSERT_EQ(summary.structures.size(), 2U);
  const StructureSummary& body = summary.structures[0];
  EXPECT_EQ(body.contours, 3U);
  EXPECT_EQ(body.points, 9U);
  EXPECT_EQ(body.planes, 2U);
  const std::vector<std::pair<std::string, std::size_t>> types{
      {"CLOSED_PLANAR", 1}, {"closed", 1}, {"points", 1}};
  EXPECT_EQ(body.types, types);
  ASSERT_TRUE(summary.lines);
  EXPECT_EQ(summary.lines->contours, 5U);
  EXPECT_EQ(summary.lines->planes, 3U);
}

}  // namespace
}  // namespace tetloft

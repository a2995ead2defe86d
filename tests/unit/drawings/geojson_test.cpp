// GeoJSON: geometries of every kind, where heights come from, bands, lines in pieces; and what
// writers make is read back.
#include <gtest/gtest.h>

#include <map>
#include <string>

#include "unit/drawings/stack_support.hpp"

namespace tetloft {
namespace {

using test::as_format;
using test::heights_of;
using test::says;

const std::string kSquare = "[[0,0],[4,0],[4,4],[0,4],[0,0]]";
const std::string kInner = "[[1,1],[2,1],[2,2],[1,2],[1,1]]";

std::string feature(const std::string& properties, const std::string& type,
                    const std::string& coordinates) {
  return R"({"type":"Feature","properties":{)" + properties + R"(},"geometry":{"type":")" + type +
         R"(","coordinates":)" + coordinates + "}}";
}

std::string collection(const std::vector<std::string>& features) {
  std::string text = R"({"type":"FeatureCollection","features":[)";
  for (std::size_t i = 0; i < features.size(); ++i) text += (i > 0 ? ",\n" : "") + features[i];
  return text + "]}";
}

ReadOptions by(const std::string& property) {
  ReadOptions options;
  options.property = property;
  return options;
}

ReadStack read(const std::string& text, const ReadOptions& options = {}) {
  Result<ReadStack> stack = parse_stack(text, "a.geojson", options);
  if (!stack) {
    ADD_FAILURE() << to_string(stack.error()) << '\n' << text;
    return {};
  }
  return *std::move(stack);
}

std::string refusal(const std::string& text, const ReadOptions& options = {}) {
  return test::refusal_of(text, options, "a.geojson");
}

TEST(GeoJson, ReadsEveryGeometryOfLines) {
  const std::vector<std::pair<std::string, std::string>> shapes{
      {"LineString", kSquare},
      {"MultiLineString", '[' + kSquare + ']'},
      {"Polygon", '[' + kSquare + ',' + kInner + ']'},
      {"MultiPolygon", "[[" + kSquare + "],[" + kInner + "]]"}};
  for (const auto& [type, coordinates] : shapes) {
    const std::string text = collection({feature("\"elev\":1", type, coordinates),
                                         feature("\"elev\":2", "Polygon", '[' + kSquare + ']')});
    const ReadStack stack = read(text);
    EXPECT_EQ(heights_of(stack.stack), (std::vector<double>{1, 2})) << type;
    EXPECT_EQ(stack.stack.vertex_count(),
              type == "LineString" || type == "MultiLineString" ? 8U : 12U);
  }
}

TEST(GeoJson, MembersMayStandInAnyOrder) {
  const ReadStack stack =
      read(R"({"features":[{"geometry":{"coordinates":)" + kSquare +
           R"(,"type":"LineString"},"properties":{"a":{"x":[1,{}]},"ELEV":7},"type":"Feature"}],)"
           R"("type":"FeatureCollection"})");
  EXPECT_EQ(heights_of(stack.stack), std::vector<double>{7});
}

TEST(GeoJson, ReadsCollectionsWithForeignMembersAndBareGeometries) {
  const ReadStack stack =
      read(R"({"type":"GeometryCollection","geometries":[)"
           R"({"type":"MultiPolygon","value":300,"coordinates":[[)" +
           kSquare + R"(]]},{"type":"Polygon","value":350,"coordinates":[)" + kInner + "]}]}");
  EXPECT_EQ(heights_of(stack.stack), (std::vector<double>{300, 350}));
  const ReadStack bare = read(R"({"type":"Polygon","coordinates":[[[0,0,5],[1,0,5],[0,1,5]]]})");
  EXPECT_EQ(heights_of(bare.stack), std::vector<double>{5});
}

TEST(GeoJson, ReadsSequences) {
  const std::string one = feature("\"z\":1", "LineString", kSquare);
  const std::string two = feature("\"z\":2", "LineString", kSquare);
  for (const std::string& text : {one + '\n' + two + '\n', "\x1E" + one + "\n\x1E" + two + "\n"}) {
    EXPECT_EQ(read(text).stack.sections.size(), 2U);
  }
}

TEST(GeoJson, LeavesOutPointsAndNothing) {
  const std::string text =
      collection({feature("\"z\":1", "LineString", kSquare), feature("\"z\":1", "Point", "[1,2]"),
                  feature("\"z\":1", "MultiPoint", "[[1,2],[3,4]]"),
                  R"({"type":"Feature","properties":null,"geometry":null})",
                  feature("", "MultiLineString", "[]")});
  const ReadStack stack = read(text);
  EXPECT_EQ(stack.stack.contour_count(), 1U);
  EXPECT_TRUE(says(stack.warnings, "left out: 3 points"));
  EXPECT_TRUE(says(stack.warnings, "left out: 1 feature without geometry"));
  EXPECT_TRUE(says(stack.warnings, "left out: 1 geometry without coordinates"));
}

TEST(GeoJson, FindsTheHeightAmongDecoys) {
  const std::vector<std::pair<std::string, double>> known{
      {"\"id\":9,\"stroke-width\":3,\"elevation\":7", 7},
      {"\"ID\":9,\"Height\":\"7.5\"", 7.5},
      {"\"OBJECTID\":9,\"Contour\":7,\"Shape_Length\":12.5", 7},
      {"\"elev_m\":7,\"road_id\":4", 7},
      {"\"value\":7,\"fill-opacity\":0.5", 7},
      {"\"pressure\":7,\"fill-opacity\":0.5,\"fid\":3", 7},
      {"\"elev\":7,\"z\":7,\"level\":3", 7}};
  for (const auto& [properties, height] : known) {
    const ReadStack stack = read(collection({feature(properties, "LineString", kSquare)}));
    EXPECT_EQ(heights_of(stack.stack), std::vector<double>{height}) << properties;
  }
}

TEST(GeoJson, AsksWhereSeveralPropertiesMayBeTheHeight) {
  const std::string text = collection({feature("\"t\":1,\"p\":5", "LineString", kSquare),
                                       feature("\"t\":2,\"p\":9", "LineString", kSquare)});
  const Result<ReadStack> stack = parse_stack(text, "a.geojson");
  ASSERT_FALSE(stack.ok());
  EXPECT_EQ(stack.error().code, ErrorCode::usage);
  EXPECT_NE(stack.error().message.find("'t' or 'p'"), std::string::npos) << stack.error().message;
  EXPECT_NE(stack.error().message.find("--property NAME"), std::string::npos);
  EXPECT_EQ(heights_of(read(text, by("p")).stack), (std::vector<double>{5, 9}));
  EXPECT_EQ(heights_of(read(text, by("T")).stack), (std::vector<double>{1, 2}));
  EXPECT_NE(refusal(text, by("q")).find("no property 'q'"), std::string::npos);
}

TEST(GeoJson, RefusesLinesWithoutHeights) {
  const std::string text = collection(
      {feature("\"ID\":1", "LineString", kSquare), feature("\"ID\":2", "LineString", kInner)});
  EXPECT_NE(refusal(text).find("nothing tells the heights"), std::string::npos);
  EXPECT_EQ(heights_of(read(text, by("ID")).stack), (std::vector<double>{1, 2}));
  // They can be counted.
  const Result<FileSummary> summary = inspect_bytes(text, "a.geojson");
  ASSERT_TRUE(summary.ok());
  EXPECT_EQ(summary->lines->contours, 2U);
  EXPECT_EQ(summary->lines->planes, 0U);
}

TEST(GeoJson, TakesThirdCoordinatesWhereNoNameMeansAHeight) {
  const auto line = [](const std::string& z) {
    return "[[0,0," + z + "],[4,0," + z + "],[4,4," + z + "],[0,0," + z + "]]";
  };
  const std::string text = collection({feature("\"population\":1", "LineString", line("10")),
                                       feature("\"population\":8", "LineString", line("20"))});
  EXPECT_EQ(heights_of(read(text).stack), (std::vector<double>{10, 20}));
  const std::string named = collection({feature("\"elev\":11", "LineString", line("10"))});
  const ReadStack stack = read(named);
  EXPECT_EQ(heights_of(stack.stack), std::vector<double>{11});
  EXPECT_TRUE(says(stack.warnings, "third coordinates, which differ"));
}

TEST(GeoJson, LeavesOutLinesWithoutTheProperty) {
  const ReadStack stack = read(collection({feature("\"pressure\":1", "LineString", kSquare),
                                           feature("\"stroke\":\"red\"", "LineString", kInner)}));
  EXPECT_EQ(stack.stack.contour_count(), 1U);
  EXPECT_TRUE(says(stack.warnings, "left out: 1 line without the property 'pressure'"));
}

// Three columns of a height field: bands 0-10, 10-20, 20-30 from left to right.
std::vector<std::string> columns(const std::vector<std::string>& properties) {
  const std::vector<std::string> rings{"[[[0,0],[1,0],[1,3],[0,3],[0,0]]]",
                                       "[[[1,0],[2,0],[2,3],[1,3],[1,0]]]",
                                       "[[[2,0],[3,0],[3,3],[2,3],[2,0]]]"};
  std::vector<std::string> features;
  for (std::size_t i = 0; i < 3; ++i)
    features.push_back(feature(properties[i], "Polygon", rings[i]));
  return features;
}

TEST(GeoJson, UnitesBandsWithThoseAbove) {
  const std::vector<std::vector<std::string>> forms{
      {"\"ELEV_MIN\":0,\"ELEV_MAX\":10", "\"ELEV_MIN\":10,\"ELEV_MAX\":20",
       "\"ELEV_MIN\":20,\"ELEV_MAX\":30"},
      {"\"people\":\"0-10\"", "\"people\":\"10 - 20\"", "\"people\":\"20..30\""},
      {"\"amin\":0,\"amax\":10", "\"amin\":10,\"amax\":20", "\"amin\":20,\"amax\":30"}};
  for (const auto& form : forms) {
    const ReadStack stack = read(collection(columns(form)));
    ASSERT_EQ(heights_of(stack.stack), (std::vector<double>{0, 10, 20})) << form[0];
    for (const SectionId s : stack.stack.sections.ids()) {
      const double area = 9.0 - 3.0 * static_cast<double>(s.index());
      EXPECT_NEAR(test::region_area(stack.stack.sections[s]), area, 1e-12);
    }
  }
}

TEST(GeoJson, TakesNoLevelForWhereTheLowestBandBeginsToCount) {
  const ReadStack stack = read(
      collection(columns({"\"ELEV_MIN\":0,\"ELEV_MAX\":350", "\"ELEV_MIN\":350,\"ELEV_MAX\":400",
                          "\"ELEV_MIN\":400,\"ELEV_MAX\":450"})));
  EXPECT_EQ(heights_of(stack.stack), (std::vector<double>{350, 400}));
  EXPECT_TRUE(says(stack.warnings, "the lowest band begins at 0"));
}

TEST(GeoJson, JoinsLinesInPieces) {
  const std::string text =
      collection({feature("\"z\":1", "LineString", "[[0,0],[4,0]]"),
                  feature("\"z\":1", "MultiLineString", "[[[4,4],[4,0]],[[4,4],[0,4],[0,0]]]"),
                  feature("\"z\":2", "LineString", kSquare)});
  const ReadStack stack = read(text);
  EXPECT_EQ(stack.stack.contour_count(), 2U);
  EXPECT_EQ(stack.stack.sections[SectionId(0)].contours[ContourId(0)].vertices.size(), 4U);
  EXPECT_TRUE(says(stack.warnings, "2 open lines joined"));
  EXPECT_NE(refusal(collection({feature("\"z\":1", "LineString", "[[0,0],[4,0],[4,4]]"),
                                feature("\"z\":2", "LineString", kSquare)}))
                .find("an open line"),
            std::string::npos);
}

TEST(GeoJson, ClosesLinesAlongTheFrameOnRequest) {
  ReadOptions options;
  options.close_on_frame = true;
  const std::string text =
      collection({feature("\"z\":0.5", "LineString", "[[1,8],[0,7]]"),
                  feature("\"z\":1", "MultiLineString", "[[[2,0],[2,3]],[[2,8],[2,3]]]"),
                  feature("\"z\":2", "LineString", "[[4,8],[4,0]]"),
                  feature("\"z\":3", "LineString", "[[7,8],[8,7]]"),
                  feature("\"z\":3", "LineString", "[[5,1],[6,1],[6,2],[5,1]]")});
  const ReadStack stack = read(text, options);
  ASSERT_EQ(heights_of(stack.stack), (std::vector<double>{0.5, 1, 2, 3}));
  const std::vector<double> areas{63.5, 48, 32, 1};
  for (const SectionId s : stack.stack.sections.ids()) {
    EXPECT_NEAR(test::region_area(stack.stack.sections[s]), areas[s.index()], 1e-12);
  }
  EXPECT_TRUE(
      says(stack.warnings, "4 open lines closed along the rectangle from (0, 0) to (8, 8)"));
  const std::string inside = collection({feature("\"z\":1", "LineString", "[[2,0],[3,4]]"),
                                         feature("\"z\":2", "LineString", "[[4,8],[4,0]]")});
  EXPECT_NE(refusal(inside, options).find("a.geojson:1: section 0, contour 0"), std::string::npos)
      << refusal(inside, options);
}

// Bands and level lines of the same terrain, made by one program each in its own way.
TEST(GeoJson, ClosedLinesAndUnitedBandsOfATerrainAgree) {
  std::map<std::string, std::map<double, double>> areas;
  for (const auto& file : test::reference_files("geojson")) {
    const std::string name = file.filename().string();
    if (name != "gdal_elev_lonlat.geojson" && name != "gdal_polygons_minmax.geojson") continue;
    ReadOptions options;
    options.close_on_frame = true;
    const Result<ReadStack> stack = read_stack(file.string(), options);
    ASSERT_TRUE(stack.ok()) << to_string(stack.error());
    for (const Section& section : stack->stack.sections) {
      areas[name][section.z] = test::region_area(section);
    }
  }
  if (areas.size() < 2) GTEST_SKIP() << "no files of reference";
  const auto& bands = areas["gdal_polygons_minmax.geojson"];
  EXPECT_EQ(bands.size(), 13U);
  for (const auto& [height, area] : bands) {
    EXPECT_NEAR(areas["gdal_elev_lonlat.geojson"][height], area, 1e-10) << height;
  }
}

TEST(GeoJson, TellsOfCoordinateSystems) {
  const std::string crs = R"("crs":{"type":"name","properties":{"name":"urn:ogc:def:crs:EPSG::)";
  const auto with = [&](const std::string& code) {
    return R"({"type":"FeatureCollection",)" + crs + code + R"("}},"features":[)" +
           feature("\"z\":1", "LineString", kSquare) + "]}";
  };
  EXPECT_TRUE(says(read(with("4269")).warnings, "degrees"));
  EXPECT_TRUE(says(read(with("4269")).warnings, "EPSG::4269"));
  EXPECT_FALSE(says(read(with("26916")).warnings, "degrees"));
}

TEST(GeoJson, RefusesWhatIsNone) {
  const std::vector<std::pair<std::string, std::string>> wrong{
      {R"({"type":"Topology"})", "TopoJSON"},
      {R"({"type":"Feature","geometry":{"coordinates":[]}})", "no type"},
      {R"({"type":"LineString","coordinates":[[[0,0]]]})", "not those of a LineString"},
      {R"({"type":"LineString","coordinates":[[0]]})", "two numbers or more"},
      {R"({"type":"LineString","coordinates":[[0,"a"]]})", "two numbers or more"},
      {R"({"type":"LineString","coordinates":[[0,1e999]]})", "too large"},
      {R"({"type":"LineString","coordinates":[[[[[0,1]]]]]})", "arrays of positions"},
      {R"({"type":"LineString","coordinates":[],"coordinates":[]})", "twice"},
      {R"({"type":"FeatureCollection","features":[1]})", "an object is due"},
      {R"({"type":"FeatureCollection","features":[)", "ends inside"},
      {R"({"type":7})", "no text"}};
  for (const auto& [text, reason] : wrong) {
    EXPECT_NE(refusal(text).find(reason), std::string::npos) << text << '\n' << refusal(text);
  }
}

TEST(GeoJson, ReadsBackWhatIsWritten) {
  const std::string text = collection(
      {feature("\"z\":0.1", "Polygon", "[[[0,0],[0,9.1],[9,9],[9,0],[0,0]]," + kSquare + ']'),
       feature("\"z\":0.1", "Polygon", '[' + kInner + ']'),
       feature("\"z\":0.30000000000000004", "Polygon", "[[[0,0],[1e22,5e-324],[0.1,7],[0,0]]]")});
  const ReadStack first = read(text);
  const Result<Formatted> written = format_stack(first.stack, {.format = "geojson"});
  ASSERT_TRUE(written.ok()) << to_string(written.error());
  const ReadStack again = read(written->bytes);
  ASSERT_EQ(heights_of(again.stack), heights_of(first.stack));
  ASSERT_EQ(again.stack.vertex_count(), first.stack.vertex_count());
  for (const SectionId s : first.stack.sections.ids()) {
    const auto& a = first.stack.sections[s].contours;
    const auto& b = again.stack.sections[s].contours;
    ASSERT_EQ(a.size(), b.size());
    for (const ContourId c : a.ids()) {
      std::vector<Point2> turned = b[c].vertices;
      if (area_sign(a[c]) != area_sign(b[c])) std::reverse(turned.begin() + 1, turned.end());
      EXPECT_EQ(a[c].vertices, turned);
    }
  }
  EXPECT_EQ(format_stack(again.stack, {.format = "geojson"})->bytes, written->bytes);
}

TEST(GeoJson, WarnsOfSectionsThatItCannotWrite) {
  SectionStack stack;
  stack.sections.push_back({0, {}});
  stack.sections.push_back({1, {}});
  stack.sections[SectionId(1)].contours.push_back({{{0, 0}, {1, 0}, {0, 1}}});
  const Result<Formatted> written = format_stack(stack, {.format = "geojson"});
  ASSERT_TRUE(written.ok());
  EXPECT_TRUE(says(written->warnings, "1 section without contours"));
  stack.frame.axes = {Point3{0, 1, 0}, Point3{0, 0, 1}, Point3{1, 0, 0}};
  const Result<Formatted> turned = format_stack(stack, {.format = "geojson"});
  ASSERT_TRUE(turned.ok());
  EXPECT_TRUE(says(turned->warnings, "other directions"));
  stack.sections[SectionId(1)].contours[ContourId(0)].vertices.pop_back();
  EXPECT_FALSE(format_stack(stack, {.format = "geojson"}).ok());
}

TEST(GeoJson, CountsAsIndependentReadersDo) {
  const auto files = test::reference_files("geojson");
  if (files.empty()) GTEST_SKIP() << "no files of reference";
  for (const auto& file : files) {
    const Result<FileSummary> summary = inspect(file.string());
    ASSERT_TRUE(summary.ok()) << to_string(summary.error());
    const auto truth = [&](const std::string& key) {
      return static_cast<std::size_t>(test::truth_number(file, key));
    };
    EXPECT_EQ(summary->lines->points, truth("points")) << file;
    EXPECT_EQ(summary->lines->open, truth("open_lines")) << file;
    EXPECT_EQ(summary->lines->closed, truth("closed_lines") + truth("polygon_rings")) << file;
  }
}

}  // namespace
}  // namespace tetloft

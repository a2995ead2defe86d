// What readers of level lines, tables and points take of memory, over files made to take much.
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include <tetloft/formats.hpp>
#include <tetloft/inspect.hpp>

#include "support/counted_memory.hpp"

namespace tetloft {

using namespace test;
namespace {

constexpr std::size_t kSize = 400'000;
static_assert(kSize > kReaderBytes / kReaderMultiple * 10);

struct Family {
  const char* name;
  std::string bytes;
};

void expect_bounded(const char* format, const std::vector<Family>& families) {
  for (const Family& family : families) {
    std::size_t bytes = 0;
    const auto count = [&](auto&& work) { bytes = std::max(bytes, peak_of(work)); };
    ReadOptions options{.format = format};
    for (const FormatInfo& info : formats()) {
      if (info.name != format) continue;
      if (info.reads.has(Contents::points)) {
        count([&] { static_cast<void>(parse_points(family.bytes, "a", options)); });
      }
      if (!info.reads.has(Contents::stack)) continue;
      count([&] { static_cast<void>(inspect_bytes(family.bytes, "a", options)); });
      options.validity = Validity::unchecked;
      count([&] { static_cast<void>(parse_stack(family.bytes, "a", options)); });
      options.close_on_frame = true;
      count([&] { static_cast<void>(parse_stack(family.bytes, "a", options)); });
    }
    const std::size_t size = family.bytes.size();
    EXPECT_LE(bytes + size, kReaderMultiple * size + kReaderBytes)
        << format << ", " << family.name << ": " << bytes / size << " times its " << size
        << " bytes";
  }
}

std::string many(const std::string& piece, const std::string& head = "",
                 const std::string& tail = "") {
  return repeated(piece, kSize, head, tail);
}

std::string line_feature(const std::string& properties, const std::string& coordinates) {
  return R"({"type":"Feature","properties":{)" + properties +
         R"(},"geometry":{"type":"LineString","coordinates":)" + coordinates + "}}\n";
}

TEST(TextMemory, OfGeoJsonIsBounded) {
  const std::string lines = R"({"type":"MultiLineString","z":1,"coordinates":[)";
  const std::string rings = R"({"type":"Polygon","z":1,"coordinates":[)";
  std::string names;
  for (int i = 0; names.size() < kSize; ++i) names += "\"" + std::to_string(i) + "\":1,";
  // Bands of which each lies apart from the others.
  std::string bands;
  for (int i = 0; bands.size() < kSize; ++i) {
    const std::string x = std::to_string(2 * i);
    bands += line_feature(
        "\"min\":" + std::to_string(i) + ",\"max\":" + std::to_string(i + 1),
        "[[" + x + ",0],[" + x + ",1],[" + std::to_string(2 * i + 1) + ",0],[" + x + ",0]]");
  }
  expect_bounded(
      "geojson",
      {{"brackets", many("[", R"({"a":)")},
       {"objects", many(R"({"geometry":)")},
       {"collections", many(R"({"geometries":[)")},
       {"features", many(R"({"type":"Feature"})", "", "")},
       {"lines of a point", many("[[0,0]],", lines, "[[0,0]]]}")},
       {"lines of two", many("[[0,0],[1,0]],", lines, "[[0,0]]]}")},
       {"triangles", many("[[0,0],[1,0],[0,1]],", rings, "[[0,0]]]}")},
       {"one line", many("[0,1],", R"({"type":"LineString","z":1,"coordinates":[)", "[0,0]]}")},
       {"points", many("[0,1],", R"({"type":"MultiPoint","z":1,"coordinates":[)", "[0,0]]}")},
       {"empty lines", many("[],", lines, "[]]}")},
       {"small features", many(line_feature("\"z\":1", "[[0,0],[1,0]]"))},
       {"names", line_feature(names + "\"z\":1", "[[0,0],[1,0],[0,1],[0,0]]")},
       {"properties", line_feature(many("\"a\":1,") + "\"z\":1", "[[0,0],[1,0],[0,1],[0,0]]")},
       {"bands", bands},
       {"long text", "{\"" + std::string(kSize, 'a') + "\":1}"},
       {"escapes", many("\\u0041", "{\"", "\":1}")}});
}

TEST(TextMemory, OfSvgIsBounded) {
  const std::string head = "<svg><g z=\"1\">";
  const std::string tail = "</g></svg>";
  expect_bounded(
      "svg", {{"groups", many("<g>", "<svg>")},
              {"layers", many("<g z=\"1\"/>", "<svg>", "</svg>")},
              {"lines", many("<line/>", head, tail)},
              {"rectangles", many("<rect width=\"1\" height=\"1\"/>", head, tail)},
              {"circles", many("<circle r=\"1\"/>", head, tail)},
              {"points", head + many("1 0 ", "<polygon points=\"", "\"/>") + tail},
              {"subpaths", head + many("M0 0H1", "<path d=\"", "\"/>") + tail},
              {"closed subpaths", head + many("M0 0H1V1z", "<path d=\"", "\"/>") + tail},
              {"curves", head + many("c1 3 2 3 3 0", "<path d=\"M0 0", "\"/>") + tail},
              {"curves that follow", head + many("T1 2", "<path d=\"M0 0Q1 1 2 0", "\"/>") + tail},
              {"paths", many("<path d=\"M0 0H1V1\"/>", head, tail)},
              {"transforms", many("scale(1)", "<svg><g transform=\"", "\"></g></svg>")}});
}

TEST(TextMemory, OfDxfIsBounded) {
  const std::string head = "0\nSECTION\n2\nENTITIES\n";
  const std::string tail = "0\nENDSEC\n0\nEOF\n";
  const std::string light = head + "0\nLWPOLYLINE\n70\n1\n";
  expect_bounded(
      "dxf", {{"entities", many("0\nA\n", head, tail)},
              {"lines", many("0\nLINE\n", head, tail)},
              {"circles", many("0\nCIRCLE\n40\n1\n", head, tail)},
              {"polylines", many("0\nLWPOLYLINE\n10\n1\n", head, tail)},
              {"vertices", many("10\n1\n", light, tail)},
              {"arcs", many("10\n1\n42\n1\n", light, tail)},
              {"old vertices", many("0\nVERTEX\n", head + "0\nPOLYLINE\n", "0\nSEQEND\n" + tail)},
              {"old polylines", many("0\nPOLYLINE\n0\nVERTEX\n0\nSEQEND\n", head, tail)},
              {"comments", many("999\n\n")}});
}

TEST(TextMemory, OfVtpIsBounded) {
  const std::string root = "<VTKFile type=\"PolyData\"><PolyData>";
  const std::string end = "</PolyData></VTKFile>";
  const auto array = [](const char* name, const std::string& text) {
    return "<DataArray type=\"Int8\" NumberOfComponents=\"3\" Name=\"" + std::string(name) + "\">" +
           text + "</DataArray>";
  };
  // Lines of two points each.
  std::string offsets;
  std::size_t lines = 0;
  while (offsets.size() < kSize) offsets += std::to_string(2 * ++lines) + ' ';
  const std::string cells = "<Lines>" + array("connectivity", many("0 1 ").substr(0, 4 * lines)) +
                            array("offsets", offsets) + "</Lines>";
  const std::string two = "<Points>" + array("P", "0 0 0 1 0 0") + "</Points>";
  expect_bounded(
      "vtp", {{"pieces", many("<Piece/>", root, end)},
              {"groups", many("<Points/>", root + "<Piece>", "</Piece>" + end)},
              {"points", root + "<Piece NumberOfPoints=\"" + std::to_string(kSize / 6) +
                             "\"><Points>" + array("P", many("0 0 0 ").substr(0, kSize / 6 * 6)) +
                             "</Points></Piece>" + end},
              {"lines", root + "<Piece NumberOfPoints=\"2\" NumberOfLines=\"" +
                            std::to_string(lines) + "\">" + two + cells + "</Piece>" + end},
              {"huge counts", many("<Piece NumberOfPoints=\"9223372036854775807\" "
                                   "NumberOfLines=\"9223372036854775807\"/>",
                                   root, end)}});
}

TEST(TextMemory, OfTablesIsBounded) {
  std::string structures = "x,y,z,name\n";
  std::string contours = "x,y,z,id\n";
  for (int i = 0; structures.size() < kSize; ++i) {
    structures += "0,0,0," + std::to_string(i) + '\n';
    contours += "0,0,0," + std::to_string(i) + "\n0,1,0," + std::to_string(i) + '\n';
  }
  expect_bounded("csv", {{"rows", many("0 0 0\n")},
                         {"contours of a point", many("0,0,0\n\n")},
                         {"heights", many("0,0,0\n0,0,1\n")},
                         {"structures", structures},
                         {"contours", contours},
                         {"fields", many(",")},
                         {"blanks", many("a ")},
                         {"comments", many("#\n")},
                         {"quotes", many("\"")}});
  expect_bounded("xyz", {{"rows", many("0 0 0\n")}, {"fields", many(";")}});
  expect_bounded("node", {{"rows", many("0 0 0 0\n", "99999999 3\n")}, {"fields", many("1 ")}});
  const std::string ply = "ply\nformat ascii 1.0\n";
  const std::string xyz = "property char x\nproperty char y\nproperty char z\nend_header\n";
  expect_bounded("ply", {{"elements", many("element a 0\n", ply)},
                         {"properties", many("property char a\n", ply + "element a 0\n")},
                         {"points", many("0 0 0 ", ply + "element vertex 99999999\n" + xyz)},
                         {"lists", ply + "element a 99999999\nproperty list char char b\n" +
                                       "element vertex 1\n" + xyz + many("0 ")}});
}

}  // namespace
}  // namespace tetloft

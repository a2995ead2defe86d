// Surfaces as .stl, .obj, .ply, .off and .vtp by whichever writer.
#include <gtest/gtest.h>

#include <bit>
#include <string>
#include <vector>

#include <tetloft/formats.hpp>

#include "core/little_endian.hpp"

namespace tetloft {

using namespace internal;

namespace {

ReadTriangles read(const std::string& bytes, const std::string& name = "a") {
  Result<ReadTriangles> result = parse_triangles(bytes, name);
  if (!result) {
    ADD_FAILURE() << to_string(result.error()) << '\n' << bytes;
    return {};
  }
  return *std::move(result);
}

std::string refusal(const std::string& bytes, const std::string& name) {
  const Result<ReadTriangles> result = parse_triangles(bytes, name);
  if (result) return "accepted";
  EXPECT_EQ(result.error().code, ErrorCode::invalid_input);
  return to_string(result.error());
}

void expect_says(const std::string& text, const std::string& part) {
  EXPECT_NE(text.find(part), std::string::npos) << text;
}

using Triangles = std::vector<std::array<std::uint32_t, 3>>;

// Two triangles; 80 bytes of head.
std::string binary_stl(std::string head, std::uint32_t announced = 2) {
  head.resize(80, ' ');
  append_little(head, announced);
  for (int t = 0; t < 2; ++t) {
    for (int i = 0; i < 12; ++i) append_little(head, static_cast<float>(12 * t + i));
    append_little(head, std::uint16_t{0});
  }
  return head;
}

TEST(Stl, IsBinaryWhereItsSizeSaysSo) {
  for (const char* head : {"made by hand", "solid of a CAD program", "solid\n"}) {
    const ReadTriangles stl = read(binary_stl(head));
    EXPECT_EQ(stl.mesh.triangles, (Triangles{{0, 1, 2}, {3, 4, 5}})) << head;
    EXPECT_EQ(stl.mesh.points[1], (Point3{6, 7, 8}));
    EXPECT_EQ(stl.mesh.points[5], (Point3{21, 22, 23}));
    EXPECT_TRUE(stl.warnings.empty());
  }
  EXPECT_EQ(read(binary_stl("solid", 2) + "more", "a.stl").warnings.size(), 1U);
  expect_says(refusal(binary_stl("solid", 3), "a.stl"), "234 bytes are announced, here are 184");
  expect_says(refusal(binary_stl("", 0xFFFFFFFF), "a.stl"), "are announced");
  expect_says(refusal(std::string("abc"), "a.stl"), "no STL");
  std::string wrong = binary_stl("");
  const float nan = std::bit_cast<float>(0x7FC00000U);
  std::string bytes;
  append_little(bytes, nan);
  wrong.replace(84 + 50 + 12 + 4, 4, bytes);
  expect_says(refusal(wrong, "a.stl"), "byte 146: corner 0 of triangle 1 is not finite");
}

const std::string kFacet =
    "facet normal 0 0 1\n outer loop\n vertex 0 0 0\n vertex 1e-1 0 0\n vertex 0 1 0\n endloop\n"
    "endfacet\n";

TEST(Stl, ReadsText) {
  const ReadTriangles one = read("solid a b c\r\n" + kFacet + "endsolid a b c\n");
  EXPECT_EQ(one.mesh.triangles, (Triangles{{0, 1, 2}}));
  EXPECT_EQ(one.mesh.points[1], (Point3{0.1, 0, 0}));
  EXPECT_TRUE(one.warnings.empty());
  // Several solids; letters in either case; normals that are none.
  EXPECT_EQ(read("solid\n" + kFacet + "endsolid\nsolid b\n" + kFacet + kFacet + "endsolid")
                .mesh.triangles.size(),
            3U);
  EXPECT_EQ(read("SOLID\nFACET NORMAL nan nan nan\nOUTER LOOP\nVERTEX 1 2 3\nVERTEX 1 2 4\n"
                 "VERTEX 1 3 4\nENDLOOP\nENDFACET\nENDSOLID",
                 "a.stl")
                .mesh.triangles.size(),
            1U);
  EXPECT_EQ(read("solid\n" + kFacet).warnings.size(), 1U);
  expect_says(refusal("solid\nfacet normal 0 0 1\nouter loop\nvertex 0 0 x\n", "a.stl"),
              "a.stl:4: 'x' is not a number");
  expect_says(
      refusal("solid\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nendloop\nendfacet", "a.stl"),
      "three vertices, here are 1");
  expect_says(refusal("solid\nfacet normal 0 0 1\nouter loop\n", "a.stl"), "inside of a facet");
  expect_says(refusal("solid\nbanana\n", "a.stl"), "a.stl:2: unexpected 'banana'");
  expect_says(refusal("solid\nendsolid\n", "a.stl"), "no triangles");
}

TEST(Obj, ReadsFacesOfEveryForm) {
  const ReadTriangles obj = read(
      "# made by hand\nmtllib a.mtl\no thing\nv 0 0 0\nv 1 0 0 1.0\nvn 0 0 1\nvt 0 0\n"
      "v 1 1 0 0.5 0.5 0.5\nv 0 1 0\nusemtl x\ns off\nf 1/1/1 2/1/1 3/1/1 4/1/1\nf -4//1 -3//1 "
      "-1//1\nl 1 2\nf 1/1 2/1 \\\n 3/1 # comment\nf 1 2\n");
  EXPECT_EQ(obj.mesh.triangles, (Triangles{{0, 1, 2}, {0, 2, 3}, {0, 1, 3}, {0, 1, 2}}));
  EXPECT_EQ(obj.mesh.points[2], (Point3{1, 1, 0}));
  ASSERT_EQ(obj.warnings.size(), 1U);
  expect_says(obj.warnings[0].message, "1 face of fewer than three corners");
  // Vertices that follow later.
  EXPECT_EQ(read("f 1 2 3\nv 0 0 0\nv 1 0 0\nv 0 1 0\n", "a.obj").mesh.triangles.size(), 1U);
  const std::string points = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
  expect_says(refusal(points + "f 1 2 3\nf 1 2 4\n", "a.obj"),
              "a.obj:5: a face refers to vertex 4 of 3");
  expect_says(refusal(points + "f 0 1 2\n", "a.obj"), "'0' is no vertex");
  expect_says(refusal(points + "f -4 1 2\n", "a.obj"), "'-4' is no vertex");
  expect_says(refusal(points + "f 1 2 x/1\n", "a.obj"), "'x/1' is no vertex");
  expect_says(refusal("v 0 0\n", "a.obj"), "a.obj:1: a vertex has x, y and z");
  expect_says(refusal("v 0 0 inf\n", "a.obj"), "a.obj:1");
  expect_says(refusal(points, "a.obj"), "no triangles");
}

const std::string kPlyHead =
    "element vertex 3\nproperty float x\nproperty float y\nproperty float z\n";

TEST(Ply, ReadsFacesOfEveryEncoding) {
  for (const char* list : {"vertex_indices", "vertex_index"}) {
    const ReadTriangles ply =
        read("ply\nformat ascii 1.0\n" + kPlyHead +
             "element face 2\nproperty uchar red\nproperty list " + "uchar int " + list +
             "\nend_header\n0 0 0\n1 0 0\n0 1 0\n9 3 0 1 2\n9 4 0 1 2 1\n");
    EXPECT_EQ(ply.mesh.triangles, (Triangles{{0, 1, 2}, {0, 1, 2}, {0, 2, 1}}));
    EXPECT_EQ(ply.mesh.points[1], (Point3{1, 0, 0}));
  }
  for (const bool big : {false, true}) {
    std::string bytes = "ply\nformat binary_" + std::string(big ? "big" : "little") +
                        "_endian 1.0\nelement face 1\nproperty list uchar ushort vertex_index\n" +
                        kPlyHead + "end_header\n";
    const auto add = [&](auto value) {
      std::string one;
      append_little(one, value);
      bytes += big ? std::string(one.rbegin(), one.rend()) : one;
    };
    add(std::uint8_t{3});
    for (const int v : {2, 0, 1}) add(static_cast<std::uint16_t>(v));
    for (int i = 0; i < 9; ++i) add(static_cast<float>(i) / 2);
    const ReadTriangles ply = read(bytes);
    EXPECT_EQ(ply.mesh.triangles, (Triangles{{2, 0, 1}})) << big;
    EXPECT_EQ(ply.mesh.points[2], (Point3{3, 3.5, 4})) << big;
    expect_says(refusal(bytes.substr(0, bytes.size() - 1), "a.ply"), "cut off");
  }
  const std::string head = "ply\nformat ascii 1.0\n" + kPlyHead +
                           "element face 1\nproperty list uchar double vertex_index\nend_header\n"
                           "0 0 0\n1 0 0\n0 1 0\n";
  expect_says(refusal(head + "3 0 1 3\n", "a.ply"), "face 0 refers to vertex 3 of 3");
  expect_says(refusal(head + "3 0 1 -1\n", "a.ply"), "-1 is no number of a vertex");
  expect_says(refusal(head + "3 0 1 0.5\n", "a.ply"), "0.5 is no number of a vertex");
  expect_says(refusal(head + "3 0 1\n", "a.ply"), "cut off");
  expect_says(
      refusal("ply\nformat ascii 1.0\n" + kPlyHead + "end_header\n0 0 0\n1 0 0\n0 1 0\n", "a.ply"),
      "no element 'face'");
}

TEST(Off, ReadsEveryKindOfHead) {
  const std::string rest = "0 0 0\n1 0 0 # corner\n\n0 1 0\n3 0 1 2\n";
  for (const char* head : {"OFF\n3 1 0\n", "OFF 3 1 3\n", "OFF3 1 0\n",
                           "# first\nOFF # kind\n3 1\n", "\xEF\xBB\xBFOFF\r\n3 1 0\r\n"}) {
    EXPECT_EQ(read(head + rest).mesh.triangles, (Triangles{{0, 1, 2}})) << head;
  }
  EXPECT_EQ(read("3 1 0\n" + rest, "a.off").mesh.triangles.size(), 1U);
  const ReadTriangles coloured = read(
      "COFF\n4 1 0\n0 0 0 255 0 0 255\n1 0 0 0 0 0 1\n1 1 0 1 1 1 1\n0 1 0 0 0 0 0\n4 0 1 2 3 0.5 "
      "0.5 0.5\n");
  EXPECT_EQ(coloured.mesh.triangles, (Triangles{{0, 1, 2}, {0, 2, 3}}));
  EXPECT_EQ(read("STCNOFF\n3 1 0\n" + rest).mesh.points.size(), 3U);
  expect_says(refusal("4OFF\n3 1 0\n" + rest, "a.off"), "three dimensions");
  expect_says(refusal("OFF BINARY\n", "a.off"), "save it as text");
  expect_says(refusal("OFF\n4 1 0\n" + rest, "a.off"), "faces: 1 are announced");
  expect_says(refusal("OFF\n3 2 0\n" + rest, "a.off"),
              "faces: 2 are announced, the file ends after 1");
  expect_says(refusal("OFF\n3 1 0\n" + rest + "3 0 1 2\n", "a.off"), "a.off:8: something follows");
  expect_says(refusal("OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 3\n", "a.off"),
              "'3' is none of the 3 vertices");
  expect_says(refusal("OFF\n3 1 0\n0 0 0\n1 0 x\n", "a.off"), "a.off:4: 'x' is not a number");
  expect_says(refusal("OFF\n-3 1 0\n", "a.off"), "'-3' is no count");
}

TEST(Vtp, ReadsPolygonsOfSeveralPieces) {
  const auto piece = [](const std::string& points) {
    return "<Piece NumberOfPoints=\"4\" NumberOfPolys=\"1\"><Points><DataArray type=\"Float64\" "
           "NumberOfComponents=\"3\" format=\"ascii\">" +
           points +
           "</DataArray></Points><Polys><DataArray type=\"Int64\" Name=\"connectivity\" "
           "format=\"ascii\">0 1 2 3</DataArray><DataArray type=\"Int64\" Name=\"offsets\" "
           "format=\"ascii\">4</DataArray></Polys></Piece>";
  };
  const ReadTriangles vtp =
      read("<VTKFile type=\"PolyData\" version=\"1.0\" byte_order=\"LittleEndian\"><PolyData>" +
           piece("0 0 0 1 0 0 1 1 0 0 1 0") + piece("0 0 5 1 0 5 1 1 5 0 1 5") +
           "</PolyData></VTKFile>");
  EXPECT_EQ(vtp.mesh.triangles, (Triangles{{0, 1, 2}, {0, 2, 3}, {4, 5, 6}, {4, 6, 7}}));
  EXPECT_EQ(vtp.mesh.points[7], (Point3{0, 1, 5}));
}

TEST(Triangles, AreReadByNameContentsOrExtension) {
  ReadOptions options;
  options.format = "off";
  EXPECT_TRUE(parse_triangles("OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n", "a.txt", options).ok());
  options.format = "cnt";
  const auto wrong = parse_triangles("", "a", options);
  ASSERT_FALSE(wrong.ok());
  EXPECT_EQ(wrong.error().code, ErrorCode::usage);
  EXPECT_EQ(read_triangles("/no/such/folder/a.stl").error().code, ErrorCode::io);
  EXPECT_EQ(parse_triangles("S 1\nv 3 z 0\n{ 0 0 1 0 0 1 }\n", "a").error().code,
            ErrorCode::invalid_input);
}

}  // namespace
}  // namespace tetloft

// Boundary surfaces in formats of triangles, parsed back by small readers of the tests' own.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <set>
#include <sstream>

#include <tetloft/formats.hpp>
#include <tetloft/io.hpp>

#include "core/little_endian.hpp"
#include "support/box_models.hpp"
#include "support/surface_meshes.hpp"
#include "unit/io/io_support.hpp"

namespace tetloft {

using namespace internal;
namespace {

using test::TempFolder;
using Triangle = std::array<std::size_t, 3>;

// Two tets on the face 1 2 3, of points shifted by `shift`; point 0 is in no tet.
Model two_tets(double scale = 1, double shift = 0) {
  Model model;
  for (const Point3& p :
       std::vector<Point3>{{9, 9, 9}, {1, 0, 0}, {0, 1, 0}, {0, 0, 0.1}, {0, 0, -1}, {1, 1, 1}}) {
    model.points.push_back({scale * p.x + shift, scale * p.y + shift, scale * p.z + shift});
  }
  const auto tet = [](int a, int b, int c, int d) {
    return TetVertices{VertexId(a), VertexId(b), VertexId(c), VertexId(d)};
  };
  model.tets.push_back(tet(1, 2, 3, 5));
  model.tets.push_back(tet(2, 1, 3, 4));
  model.component.assign(2, ComponentId(0));
  model.section.assign(6, SectionId(3));
  model.contour.assign(6, ContourId());
  return model;
}

struct Soup {
  std::vector<Point3> points;
  std::vector<Triangle> triangles;
};

// Closed and outward: every directed edge once, its reverse too, and a positive volume.
void expect_closed(const Soup& soup) {
  std::set<std::pair<std::size_t, std::size_t>> edges;
  double volume = 0;
  for (const Triangle& t : soup.triangles) {
    for (std::size_t i = 0; i < 3; ++i) {
      ASSERT_LT(t[i], soup.points.size());
      EXPECT_TRUE(edges.insert({t[i], t[(i + 1) % 3]}).second);
    }
    const Point3& a = soup.points[t[0]];
    const Point3& b = soup.points[t[1]];
    const Point3& c = soup.points[t[2]];
    volume += a.x * (b.y * c.z - b.z * c.y) + a.y * (b.z * c.x - b.x * c.z) +
              a.z * (b.x * c.y - b.y * c.x);
  }
  for (const auto& [from, to] : edges) EXPECT_TRUE(edges.count({to, from}) == 1);
  EXPECT_GT(volume, 0);
}

void expect_two_tets(const Soup& soup) {
  const Model model = two_tets();
  ASSERT_EQ(soup.points.size(), 5U);
  for (std::size_t i = 0; i < 5; ++i) {
    EXPECT_TRUE(test::same_bits(soup.points[i], model.points[VertexId(i + 1)])) << i;
  }
  EXPECT_EQ(soup.triangles.size(), 6U);
  expect_closed(soup);
}

std::string surface_bytes(const char* name, const Model& model, Encoding encoding) {
  TempFolder folder;
  const auto written = write_surface(folder.file(name), model, encoding);
  EXPECT_TRUE(written.ok()) << to_string(written.error());
  EXPECT_TRUE(written->empty());
  return test::get(folder.file(name));
}

Soup parse_obj(const std::string& bytes) {
  Soup soup;
  std::istringstream text(bytes);
  for (std::string word; text >> word;) {
    if (word == "v") {
      std::array<std::string, 3> xyz;
      text >> xyz[0] >> xyz[1] >> xyz[2];
      soup.points.push_back({std::stod(xyz[0]), std::stod(xyz[1]), std::stod(xyz[2])});
    } else if (word == "f") {
      Triangle t{};
      text >> t[0] >> t[1] >> t[2];
      soup.triangles.push_back({t[0] - 1, t[1] - 1, t[2] - 1});
    } else {
      ADD_FAILURE() << word;
    }
  }
  return soup;
}

Soup parse_ply(const std::string& bytes) {
  Soup soup;
  const std::size_t end = bytes.find("end_header\n");
  EXPECT_NE(bytes.substr(0, end).find("element vertex 5\n"), std::string::npos);
  EXPECT_NE(bytes.substr(0, end).find("element face 6\n"), std::string::npos);
  if (bytes.find("format ascii 1.0\n") != std::string::npos) {
    std::istringstream text(bytes.substr(end + 11));
    for (int i = 0; i < 5; ++i) {
      std::array<std::string, 3> xyz;
      text >> xyz[0] >> xyz[1] >> xyz[2];
      soup.points.push_back({std::stod(xyz[0]), std::stod(xyz[1]), std::stod(xyz[2])});
    }
    for (int i = 0; i < 6; ++i) {
      int corners = 0;
      Triangle t{};
      text >> corners >> t[0] >> t[1] >> t[2];
      EXPECT_EQ(corners, 3);
      soup.triangles.push_back(t);
    }
    return soup;
  }
  EXPECT_NE(bytes.find("format binary_little_endian 1.0\n"), std::string::npos);
  const char* at = bytes.data() + end + 11;
  EXPECT_EQ(bytes.size(), end + 11 + 5 * 24 + 6 * 13);
  for (int i = 0; i < 5; ++i, at += 24) {
    soup.points.push_back(
        {load_little<double>(at), load_little<double>(at + 8), load_little<double>(at + 16)});
  }
  for (int i = 0; i < 6; ++i, at += 13) {
    EXPECT_EQ(*at, 3);
    soup.triangles.push_back({static_cast<std::size_t>(load_little<std::int32_t>(at + 1)),
                              static_cast<std::size_t>(load_little<std::int32_t>(at + 5)),
                              static_cast<std::size_t>(load_little<std::int32_t>(at + 9))});
  }
  return soup;
}

TEST(WriteSurface, WritesObj) {
  expect_two_tets(parse_obj(surface_bytes("s.obj", two_tets(), Encoding::binary)));
}

TEST(WriteSurface, WritesPly) {
  expect_two_tets(parse_ply(surface_bytes("s.PLY", two_tets(), Encoding::binary)));
  expect_two_tets(parse_ply(surface_bytes("s.ply", two_tets(), Encoding::ascii)));
}

TEST(WriteSurface, WritesVtp) {
  const std::string ascii = surface_bytes("s.vtp", two_tets(), Encoding::ascii);
  EXPECT_NE(ascii.find("NumberOfPoints=\"5\""), std::string::npos);
  EXPECT_NE(ascii.find("NumberOfPolys=\"6\""), std::string::npos);
  const auto values_of = [&](const std::string& name) {
    const std::size_t tag = ascii.find("Name=\"" + name + '"');
    const std::size_t from = ascii.find('>', tag) + 1;
    return ascii.substr(from, ascii.find('<', from) - from);
  };
  Soup soup;
  std::istringstream points(values_of("Points"));
  for (std::string x, y, z; points >> x >> y >> z;) {
    soup.points.push_back({std::stod(x), std::stod(y), std::stod(z)});
  }
  std::istringstream corners(values_of("connectivity"));
  for (Triangle t{}; corners >> t[0] >> t[1] >> t[2];) soup.triangles.push_back(t);
  expect_two_tets(soup);
  EXPECT_NE(values_of("component").find("0 0 0 0 0 0"), std::string::npos);
  EXPECT_NE(values_of("section").find("3 3 3 3 3"), std::string::npos);
  // The same head but for the encoding, and 8 bytes of count before each array.
  const std::string binary = surface_bytes("s.vtp", two_tets(), Encoding::binary);
  EXPECT_NE(binary.find("offset=\"" + std::to_string(3 * 8 + 5 * 4 + 5 * 4 + 6 * 4) + '"'),
            std::string::npos);
}

std::vector<std::array<float, 12>> parse_stl(const std::string& bytes) {
  EXPECT_NE(bytes.substr(0, 5), "solid");
  const auto count = load_little<std::uint32_t>(bytes.data() + 80);
  EXPECT_EQ(bytes.size(), 84 + 50 * std::size_t{count});
  std::vector<std::array<float, 12>> facets(count);
  for (std::size_t i = 0; i < count; ++i) {
    for (std::size_t k = 0; k < 12; ++k) {
      facets[i][k] = load_little<float>(bytes.data() + 84 + 50 * i + 4 * k);
    }
  }
  return facets;
}

TEST(WriteSurface, WritesStlWithOutwardUnitNormals) {
  const auto facets = parse_stl(surface_bytes("s.stl", two_tets(), Encoding::binary));
  ASSERT_EQ(facets.size(), 6U);
  for (const auto& f : facets) {
    const auto side = [&](std::size_t corner, std::size_t axis) {
      return static_cast<double>(f[3 * corner + axis]) - static_cast<double>(f[3 + axis]);
    };
    const std::array<double, 3> n{side(2, 1) * side(3, 2) - side(2, 2) * side(3, 1),
                                  side(2, 2) * side(3, 0) - side(2, 0) * side(3, 2),
                                  side(2, 0) * side(3, 1) - side(2, 1) * side(3, 0)};
    const double length = std::hypot(n[0], n[1], n[2]);
    for (std::size_t k = 0; k < 3; ++k) {
      EXPECT_NEAR(static_cast<double>(f[k]), n[k] / length, 1e-6);
    }
  }
}

TEST(WriteSurface, WritesAsciiStl) {
  const std::string bytes = surface_bytes("s.stl", two_tets(), Encoding::ascii);
  EXPECT_EQ(bytes.rfind("solid", 0), 0U);
  std::size_t vertices = 0;
  for (std::size_t at = 0; (at = bytes.find("vertex ", at)) != std::string::npos; ++at) {
    ++vertices;
  }
  EXPECT_EQ(vertices, 18U);
  EXPECT_NE(bytes.find("vertex 0 0 0.1\n"), std::string::npos);
}

std::vector<Warning> stl_warnings(const Model& model) {
  TempFolder folder;
  const auto written = write_surface(folder.file("s.stl"), model);
  EXPECT_TRUE(written.ok()) << to_string(written.error());
  EXPECT_EQ(folder.names().size(), 1U);
  return *written;
}

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

// What kHardNames are in one line.
const std::string kTitle = testing::kHardNames[0];
const std::string kLesion = testing::kHardNames[1];
const std::string kTwoLines = "two\\x0alines\\x09\\x01 #1, 100%";

TEST(WriteSurface, ObjHasObjectsAndGroups) {
  const std::string bytes = surface_bytes("s.obj", testing::boxes_in_a_patient(), Encoding::binary);
  const std::vector<std::string> lines = lines_of(bytes);
  // A backslash at the end would join the next line.
  const std::string title = kTitle.substr(0, kTitle.size() - 1) + '/';
  EXPECT_EQ(lines[0], "# name: " + title);
  EXPECT_EQ(lines[1], "# unit: mm");
  EXPECT_EQ(lines[2], "# orientation: LPS");
  std::vector<std::string> heads;
  std::vector<std::size_t> faces;
  for (const std::string& line : lines) {
    if (line[0] == 'o') faces.push_back(0);
    if (line[0] == 'o' || line[0] == 'g') heads.push_back(line);
    if (line[0] == 'f') ++faces.back();
  }
  EXPECT_EQ(faces, (std::vector<std::size_t>{12, 12, 12}));
  const std::string fourth = "left \"lung\" & <b>'x'</b> \\ 4";
  EXPECT_EQ(heads, (std::vector<std::string>{"o " + kLesion, "g L\xC3\xA4sion_\xE8\x82\x9D",
                                             "o " + kTwoLines, "g two\\x0alines\\x09\\x01_#1,_100%",
                                             "o " + fourth, "g left_\"lung\"_&_<b>'x'</b>_\\_4"}));
}

TEST(WriteSurface, CommentsTellComponents) {
  const std::vector<std::string> expected{"name: " + kTitle,
                                          "unit: mm",
                                          "orientation: LPS",
                                          "component 1: 12 faces, " + kLesion,
                                          "component 2: 12 faces, " + kTwoLines,
                                          "component 4: 12 faces, " + kTitle + " 4"};
  for (const auto& [name, mark] :
       std::vector<std::pair<const char*, std::string>>{{"s.ply", "comment "}, {"s.off", "# "}}) {
    for (const Encoding encoding : {Encoding::binary, Encoding::ascii}) {
      const std::string bytes = surface_bytes(name, testing::boxes_in_a_patient(), encoding);
      std::vector<std::string> comments;
      for (const std::string& line : lines_of(bytes)) {
        if (line.starts_with(mark)) comments.push_back(line.substr(mark.size()));
      }
      EXPECT_EQ(comments, expected) << name;
    }
  }
}

TEST(WriteSurface, AsciiStlHasASolidForEachComponent) {
  std::vector<std::string> heads;
  std::size_t facets = 0;
  for (const std::string& line :
       lines_of(surface_bytes("s.stl", testing::boxes_in_a_patient(), Encoding::ascii))) {
    if (line.starts_with("facet")) ++facets;
    if (line.find("solid") < 4) heads.push_back(line + ' ' + std::to_string(facets));
  }
  EXPECT_EQ(heads, (std::vector<std::string>{
                       "solid " + kLesion + " 0", "endsolid " + kLesion + " 12",
                       "solid " + kTwoLines + " 12", "endsolid " + kTwoLines + " 24",
                       "solid " + kTitle + " 4 24", "endsolid " + kTitle + " 4 36"}));
}

TEST(WriteSurface, BinaryStlHasTheNameInItsHead) {
  Model model = two_tets();
  const auto head = [&] { return surface_bytes("s.stl", model, Encoding::binary).substr(0, 80); };
  EXPECT_EQ(head(), "binary STL by tetloft" + std::string(59, ' '));
  model.about = {"solid \n", "mm", ""};
  EXPECT_EQ(head(), "binary STL by tetloft: solid \\x0a, in mm" + std::string(40, ' '));
  // Cut between characters.
  model.about.name = std::string(56, 'x') + "\xE8\x82\x9D";
  EXPECT_EQ(head(), "binary STL by tetloft: " + std::string(56, 'x') + ' ');
}

// What was written is read back, whatever its names.
TEST(WriteSurface, IsReadBackWithNames) {
  const Model model = testing::boxes_in_a_patient();
  for (const char* format : {"obj", "ply", "off", "stl", "vtp"}) {
    for (const Encoding encoding : {Encoding::binary, Encoding::ascii}) {
      const auto read = parse_triangles(
          surface_bytes((std::string("s.") + format).c_str(), model, encoding), "a");
      ASSERT_TRUE(read.ok()) << format << to_string(read.error());
      EXPECT_TRUE(read->warnings.empty()) << format;
      EXPECT_EQ(read->mesh.triangles.size(), 36U) << format;
      EXPECT_NEAR(testing::volume_of(read->mesh), 30.125, 0.01) << format;
    }
  }
}

TEST(WriteSurface, WarnsWhereFloat32MergesVertices) {
  // At 2^24 floats are two apart: 1, 0 and 0.1 fall together.
  const auto warnings = stl_warnings(two_tets(1, 0x1p25));
  ASSERT_EQ(warnings.size(), 2U);
  EXPECT_NE(warnings[0].message.find("merges"), std::string::npos);
  EXPECT_NE(warnings[1].message.find("flattens 6 triangles"), std::string::npos);
  EXPECT_TRUE(warnings[0].where.point.has_value());
}

TEST(WriteSurface, WarnsWhereFloat32ChangesTheVolume) {
  // At 2^22 floats are half apart: a corner of 3.2 is moved to 3.
  Model model;
  for (const Point3& p : std::vector<Point3>{{0, 0, 0}, {3.2, 0, 0}, {0, 3, 0}, {0, 0, 3}}) {
    model.points.push_back({p.x + 0x1p22, p.y, p.z});
  }
  model.tets.push_back({VertexId(0), VertexId(2), VertexId(1), VertexId(3)});
  if (volume(model) < 0) std::swap(model.tets[TetId(0)][0], model.tets[TetId(0)][1]);
  const auto warnings = stl_warnings(model);
  ASSERT_EQ(warnings.size(), 1U);
  EXPECT_NE(warnings[0].message.find("changes the volume by 6.3 %"), std::string::npos)
      << warnings[0].message;
  for (Point3& p : model.points) p.x -= 0x1p22;
  EXPECT_TRUE(stl_warnings(model).empty());
}

TEST(WriteSurface, WarnsWhereFloat32FlattensTriangles) {
  // Corner 2 leaves the line from 1 to 3 by half an ulp of float32.
  Model model;
  for (const Point3& p :
       std::vector<Point3>{{0, 0, 0}, {1, 1 + 0x1p-25, 0}, {2, 2, 0}, {0, 0, 1}}) {
    model.points.push_back(p);
  }
  model.tets.push_back({VertexId(1), VertexId(0), VertexId(2), VertexId(3)});
  const auto warnings = stl_warnings(model);
  ASSERT_EQ(warnings.size(), 1U);
  EXPECT_NE(warnings[0].message.find("flattens 1 triangle;"), std::string::npos);
  // By a whole ulp it stays a triangle, at any size.
  for (const double scale : {1.0, 0x1p-100, 0x1p100}) {
    for (VertexId v(0); v < model.points.end_id(); v = VertexId(v.index() + 1)) {
      model.points[v] = {scale * static_cast<double>(v.index() % 3),
                         scale * static_cast<double>(v.index() % 3), v.index() == 3 ? scale : 0};
    }
    model.points[VertexId(1)].y = scale * (1 + 0x1p-23);
    EXPECT_TRUE(stl_warnings(model).empty()) << scale;
  }
}

TEST(WriteSurface, RefusesStlBeyondFloat32) {
  TempFolder folder;
  const auto written = write_surface(folder.file("s.stl"), two_tets(1e39));
  EXPECT_EQ(written.error().code, ErrorCode::invalid_input);
  EXPECT_TRUE(written.error().where.point.has_value());
  EXPECT_TRUE(folder.names().empty());
}

TEST(WriteSurface, RefusesOtherExtensions) {
  TempFolder folder;
  for (const char* name : {"s", "s.vtk", "s.obj.gz"}) {
    EXPECT_EQ(write_surface(folder.file(name), two_tets()).error().code, ErrorCode::usage);
  }
  EXPECT_EQ(write_surface(folder.file("none/s.ply"), two_tets()).error().code, ErrorCode::io);
  EXPECT_TRUE(folder.names().empty());
}

TEST(WriteSurface, WritesTheEmptyModel) {
  for (const char* name : {"s.obj", "s.ply", "s.vtp", "s.stl", "s.off", "s.3mf", "s.glb"}) {
    TempFolder folder;
    EXPECT_TRUE(write_surface(folder.file(name), Model()).ok()) << name;
  }
}

}  // namespace
}  // namespace tetloft

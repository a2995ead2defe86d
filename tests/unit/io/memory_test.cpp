// What readers take of memory, over files made to take much: counted by this program's own
// allocation functions.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include <tetloft/formats.hpp>
#include <tetloft/inspect.hpp>

#include "core/little_endian.hpp"
#include "io/bytes/deflate.hpp"
#include "io/files.hpp"
#include "support/counted_memory.hpp"
#include "unit/io/io_support.hpp"

namespace tetloft {

using namespace internal;
using test::peak_of;
using test::repeated;
namespace {

struct Family {
  std::string name;
  std::string bytes;
};

constexpr std::size_t kSize = 400'000;
// Small enough that what every reader may take does not hide what a file makes it take.
static_assert(kSize > kReaderBytes / kReaderMultiple * 10);

std::vector<Family> stacks() {
  std::vector<Family> families;
  const std::string head = "S 1\nv 3 z 0\n";
  for (const char* piece :
       {"{}", "{ }", "{0}", "{0 0}", "{0 0 0}", "{0 0 0 0}", "{0 0 1 0 0 1}", "{1 0 0}", "{",
        "{0 0 0 0 0 0}", "{0 1 1 0 0 0 1 0 0}", "0 ", "#\n", "# {{{{{{ v v v\n", "{,}", "v "}) {
    families.push_back({piece, repeated(piece, kSize, head)});
  }
  for (const char* piece : {"v0 z0\n", "v 1 z 0\n", "v1 z0{}", "v3 z0{0 0 1 0 0 1}"}) {
    families.push_back({piece, repeated(piece, kSize, "S 1\n")});
  }
  // Valid, with as little text for each vertex and each contour as can be.
  std::string triangles = "S 1\nv 0 z 0\n";
  for (int i = 0; triangles.size() < kSize; ++i) {
    const std::string y = std::to_string(2 * i);
    const std::string above = std::to_string(2 * i + 1);
    triangles += "{0 " + y + " 1 " + y + " 0 " + above + "}";
  }
  families.push_back({"triangles", triangles});
  std::string heights = "S 0\n";
  for (int i = 0; heights.size() < kSize; ++i) heights += "v1 z" + std::to_string(i) + "{}";
  families.push_back({"heights", heights});
  families.push_back({"long contour", repeated("0 1 ", kSize, head + "{", "}")});
  families.push_back({"triples", repeated("1 2 0 ", kSize, head + "{", "}")});
  families.push_back({"long token", head + "{ " + std::string(kSize, '7') + " 0}"});
  families.push_back({"long word", std::string(kSize, 'S')});
  families.push_back({"huge counts", "S 1e300\n" + repeated("v 1e300 z 0\n", kSize)});
  families.push_back({"line feeds", std::string(kSize, '\n')});
  families.push_back({"zeros", std::string(kSize, '\0')});
  return families;
}

std::string grid(const std::string& inside) {
  return "<VTKFile type=\"UnstructuredGrid\"><UnstructuredGrid>" + inside +
         "</UnstructuredGrid></VTKFile>";
}

std::string piece(std::size_t points, std::size_t cells, const std::string& inside) {
  return "<Piece NumberOfPoints=\"" + std::to_string(points) + "\" NumberOfCells=\"" +
         std::to_string(cells) + "\">" + inside + "</Piece>";
}

std::string array(const std::string& name, const std::string& type, const std::string& text) {
  return "<DataArray Name=\"" + name + "\" type=\"" + type + "\" NumberOfComponents=\"" +
         (name == "P" ? "3" : "1") + "\">" + text + "</DataArray>";
}

// Text of n numbers.
std::string numbers(std::size_t n, const std::string& number) {
  return repeated(number + ' ', n * (number.size() + 1));
}

std::string cells(std::size_t n) {
  std::string offsets;
  for (std::size_t i = 1; i <= n; ++i) offsets += std::to_string(4 * i) + ' ';
  return "<Cells>" + array("connectivity", "Int8", numbers(4 * n, "0")) +
         array("offsets", "Int64", offsets) + array("types", "Int8", numbers(n, "10")) + "</Cells>";
}

std::vector<Family> grids() {
  std::vector<Family> families;
  const auto add = [&](const char* name, const std::string& bytes) {
    families.push_back({name, bytes});
  };
  add("empty pieces", grid(repeated(piece(0, 0, ""), kSize)));
  const std::string empty = piece(0, 0, "<Points><DataArray type=\"Int8\"/></Points>");
  add("pieces of an empty array", grid(repeated(empty, kSize)));
  const std::string one =
      piece(1, 1, "<Points>" + array("P", "Int8", "0 0 0") + "</Points>" + cells(1));
  add("small pieces", grid(repeated(one, kSize)));
  add("unnamed arrays",
      grid(piece(0, 0,
                 "<CellData>" + repeated("<DataArray type=\"Int8\"/>", kSize) + "</CellData>")));
  std::string named;
  for (int i = 0; named.size() < kSize; ++i) {
    named += "<DataArray Name=\"" + std::to_string(i) + "\"/>";
  }
  add("named arrays", grid(piece(0, 0, "<CellData>" + named + "</CellData>")));
  add("deep", repeated("<a>", kSize, "<VTKFile type=\"UnstructuredGrid\">"));
  std::string attributes = "<VTKFile type=\"UnstructuredGrid\"";
  for (int i = 0; attributes.size() < kSize; ++i) attributes += " a" + std::to_string(i) + "=''";
  add("attributes", attributes + ">");
  add("long name", '<' + std::string(kSize, 'a') + '>');
  add("long attribute", "<VTKFile type=\"" + std::string(kSize, '&') + "\">");
  add("long compressor", "<VTKFile type=\"UnstructuredGrid\" compressor=\"" +
                             std::string(kSize, 'a') + "\"><UnstructuredGrid>" +
                             piece(1, 0,
                                   "<Points><DataArray type=\"Int8\" format=\"binary\">AAAA"
                                   "</DataArray></Points>") +
                             "</UnstructuredGrid></VTKFile>");
  add("comments", repeated("<!---->", kSize));
  add("points alone",
      grid(piece(kSize / 6, 0,
                 "<Points>" + array("P", "Int8", numbers(kSize / 6 * 3, "0")) + "</Points>")));
  add("cells alone",
      grid(piece(1, kSize / 20,
                 "<Points>" + array("P", "Int8", "0 0 0") + "</Points>" + cells(kSize / 20))));
  const std::size_t n = kSize / 40;
  std::string labels;
  for (const char* name : {"component", "slab", "kind"}) {
    labels += array(name, "Int8", numbers(n, "0"));
  }
  add("labels", grid(piece(1, n,
                           "<Points>" + array("P", "Int8", "0 0 0") + "</Points>" + cells(n) +
                               "<CellData>" + labels + "</CellData>")));
  std::string links, most_links;
  for (const char* name : {"slab", "lower", "upper", "evidence", "fate", "has_lead"}) {
    links += array("link_" + std::string(name), "Int8", numbers(n, "0"));
  }
  for (const char* name : {"ratio", "moved", "distance", "margin", "lead"}) {
    most_links = links;
    links += array("link_" + std::string(name), "Float32", numbers(n, "0"));
  }
  add("links", grid("<FieldData>" + links + "</FieldData>" + piece(0, 0, "")));
  add("most of links", grid("<FieldData>" + most_links + "</FieldData>" + piece(0, 0, "")));
  std::string motions;
  for (const char* name : {"slab", "upper", "contour", "x", "y"}) {
    motions += array("motion_" + std::string(name),
                     *name == 'x' || *name == 'y' ? "Float32" : "Int8", numbers(2 * n, "0"));
  }
  add("motions", grid("<FieldData>" + motions + "</FieldData>" + piece(0, 0, "")));
  std::string voids, deviations;
  for (const char* name : {"slab", "lower", "upper", "evidence", "fate", "has_lead"}) {
    voids += array("void_" + std::string(name), "Int8", numbers(n, "0"));
  }
  for (const char* name : {"ratio", "moved", "distance", "margin", "lead"}) {
    voids += array("void_" + std::string(name), "Float32", numbers(n, "0"));
  }
  add("links of voids", grid("<FieldData>" + voids + "</FieldData>" + piece(0, 0, "")));
  for (const char* name : {"slab", "upper", "contour", "expected", "got"}) {
    deviations += array("deviation_" + std::string(name), "Int8", numbers(2 * n, "0"));
  }
  add("deviations", grid("<FieldData>" + deviations + "</FieldData>" + piece(0, 0, "")));
  add("long token",
      grid(piece(1, 0, "<Points>" + array("P", "Int8", std::string(kSize, '1')) + "</Points>")));
  add("huge counts", grid(repeated("<Piece NumberOfPoints=\"9223372036854775807\" "
                                   "NumberOfCells=\"9223372036854775807\"/>",
                                   kSize)));
  return families;
}

// Pieces that take the same appended blocks, or overlapping ones, of `count` points.
std::string shared_blocks(std::size_t count, std::size_t shift) {
  std::string text = "<VTKFile type=\"UnstructuredGrid\" header_type=\"UInt64\"><UnstructuredGrid>";
  for (std::size_t p = 0; text.size() < kSize / 2; ++p) {
    text += piece(count, 0,
                  "<Points><DataArray type=\"Int8\" NumberOfComponents=\"3\" "
                  "format=\"appended\" offset=\"" +
                      std::to_string(p * shift) + "\"/></Points>");
  }
  text += "</UnstructuredGrid><AppendedData encoding=\"raw\">_";
  while (text.size() < kSize) {
    // Every eighth byte begins a count of the same size.
    for (std::size_t i = 0; i < 8; ++i) text += static_cast<char>(3 * count >> (8 * i));
    if (shift == 0) text += std::string(3 * count, '\0');
  }
  return text + "</AppendedData></VTKFile>";
}

// Grids of kSize bytes that unpack to as much as is taken: arrays of the same bytes all over, or of
// numbers in order, but for what must fill the file up.
class PackedGrid {
 public:
  PackedGrid(std::size_t points, std::size_t cells) : points_(points), cells_(cells) {}

  PackedGrid& add(const std::string& group, const std::string& name, const std::string& type,
                  const std::string& bytes, const std::string& more = "") {
    std::string& text = groups_[group];
    text += "<DataArray Name=\"" + name + "\" type=\"" + type + "\" " + more +
            " format=\"appended\" offset=\"" + std::to_string(data_.size()) + "\"/>";
    const std::string packed = io::zlib_compressed(bytes);
    for (const std::size_t word : {std::size_t{1}, bytes.size(), std::size_t{0}, packed.size()}) {
      append_little(data_, std::uint64_t{word});
    }
    data_ += packed;
    return *this;
  }
  [[nodiscard]] std::string file() const {
    std::string inside, of_all;
    for (const auto& [group, arrays] : groups_) {
      (group == "FieldData" ? of_all : inside) += '<' + group + '>' + arrays + "</" + group + '>';
    }
    return "<VTKFile type=\"UnstructuredGrid\" header_type=\"UInt64\" "
           "compressor=\"vtkZLibDataCompressor\"><UnstructuredGrid>" +
           of_all + piece(points_, cells_, inside) +
           "</UnstructuredGrid><AppendedData encoding=\"raw\">_" + data_ +
           std::string(kSize - std::min(kSize, data_.size()), '\0') + "</AppendedData></VTKFile>";
  }

 private:
  std::size_t points_, cells_;
  std::map<std::string, std::string> groups_;
  std::string data_;
};

std::vector<Family> packed_grids() {
  constexpr std::size_t kCost = 32 * kSize;
  const std::string three = "NumberOfComponents=\"3\"";
  const auto zeros = [](std::size_t n) { return std::string(n, '\0'); };
  std::vector<Family> families;
  const std::size_t floats = kCost / 36;
  families.push_back(
      {"packed floats",
       PackedGrid(floats, 0).add("Points", "P", "Float32", zeros(12 * floats), three).file()});
  const std::size_t bytes = kCost / (27 + 27);
  families.push_back({"packed bytes", PackedGrid(bytes, 0)
                                          .add("Points", "P", "Int8", zeros(3 * bytes), three)
                                          .add("PointData", "section", "Int8", zeros(bytes))
                                          .add("PointData", "contour", "Int8", zeros(bytes))
                                          .add("PointData", "origin", "UInt8", zeros(bytes))
                                          .file()});
  // Cells, each of a component of its own, which has a name.
  const std::size_t cells = kCost / (36 + 16 + 9 + 12 + 18 + 9);
  std::string offsets, components;
  for (std::size_t i = 0; i < cells; ++i) {
    append_little(offsets, std::uint64_t{4 * (i + 1)});
    append_little(components, static_cast<std::uint32_t>(i));
  }
  families.push_back(
      {"packed cells", PackedGrid(1, cells)
                           .add("Points", "P", "Int8", zeros(3), three)
                           .add("Cells", "connectivity", "Int8", zeros(4 * cells))
                           .add("Cells", "offsets", "Int64", offsets)
                           .add("Cells", "types", "Int8", std::string(cells, '\x0A'))
                           .add("CellData", "component", "Int32", components)
                           .add("CellData", "slab", "Int8", zeros(cells))
                           .add("CellData", "kind", "Int8", zeros(cells))
                           .add("FieldData", "component_names", "UInt8", zeros(cells - 1))
                           .file()});
  const std::size_t name = kCost / 9;
  families.push_back(
      {"packed name",
       PackedGrid(0, 0).add("FieldData", "name", "UInt8", std::string(name, 'a')).file()});
  return families;
}

// Solids in other programs' formats, in as few bytes as can be.
std::vector<Family> solids() {
  std::vector<Family> families;
  const std::string vtk = "# vtk DataFile Version 3.0\n\nASCII\nDATASET UNSTRUCTURED_GRID\n";
  const std::string none = vtk + "POINTS 0 int\nCELLS 0 0\nCELL_TYPES 0\n";
  const auto count = [](std::size_t n) { return std::to_string(n) + ' '; };
  const std::size_t points = kSize / 6;
  families.push_back({"points of vtk", vtk + "POINTS " + count(points) + "int\n" +
                                           numbers(3 * points, "0") +
                                           "CELLS 0 0\nCELL_TYPES 0\nPOINT_DATA 0\n"});
  const std::size_t empty = kSize / 4;
  families.push_back({"empty cells of vtk", vtk + "POINTS 0 int\nCELLS " + count(empty) +
                                                count(empty) + '\n' + numbers(empty, "0") +
                                                "CELL_TYPES " + count(empty) + '\n' +
                                                numbers(empty, "0")});
  const std::size_t tets = kSize / 19;
  std::string text = vtk + "POINTS 1 int\n0 0 0\nCELLS " + count(tets) + count(5 * tets) + '\n' +
                     repeated("4 0 0 0 0\n", 10 * tets) + "CELL_TYPES " + count(tets) + '\n' +
                     numbers(tets, "10");
  families.push_back({"tets of vtk", text});
  text += "CELL_DATA " + count(tets) + "\n";
  for (const char* name : {"component", "slab", "kind"}) {
    text += "SCALARS " + std::string(name) + " int\n" + numbers(tets, "0");
  }
  families.push_back({"fields of vtk", text});
  families.push_back({"names of vtk", none + "FIELD f 1\nx 1 " + count(kSize / 2) +
                                          "unsigned_char\n" + numbers(kSize / 2, "7")});
  families.push_back(
      {"arrays of vtk", repeated("x 1 0 int\n", kSize, none + "FIELD f 99999999\n")});
  families.push_back({"long words", none + std::string(kSize, 'x')});

  const std::string msh2 = "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n";
  const std::string msh4 = "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n";
  std::string nodes, names, elements, entities;
  std::size_t n = 0;
  for (; nodes.size() < kSize; ++n) nodes += count(n) + "0 0 0\n";
  families.push_back({"nodes of msh", msh2 + "$Nodes\n" + count(n) + '\n' + nodes +
                                          "$EndNodes\n$Elements\n0\n$EndElements\n"});
  // Each tet of a group of its own, which has a name.
  for (n = 1; elements.size() + names.size() < kSize; ++n) {
    names += "3 " + count(n) + "\"a\"\n";
    elements += "1 4 1 " + count(n) + "1 1 1 1\n";
  }
  const std::string one = "$Nodes\n1\n1 0 0 0\n$EndNodes\n";
  families.push_back({"groups of msh", msh2 + "$PhysicalNames\n" + count(n - 1) + '\n' + names +
                                           "$EndPhysicalNames\n" + one + "$Elements\n" +
                                           count(n - 1) + '\n' + elements + "$EndElements\n"});
  families.push_back({"tets of msh", repeated("1 4 0 1 1 1 1\n", kSize,
                                              msh2 + one + "$Elements\n" + count(kSize / 14) + '\n',
                                              "$EndElements\n")});
  for (n = 1; entities.size() < kSize; ++n) entities += count(n) + "0 0 0 0 0 0 1 1 0\n";
  families.push_back({"entities of msh", msh4 + "$Entities\n0 0 0 " + count(n - 1) + '\n' +
                                             entities + "$EndEntities\n"});
  families.push_back({"sections of msh", repeated("$a\n$Enda\n", kSize, msh4)});
  families.push_back({"long name of msh", msh4 + '$' + std::string(kSize, 'a')});
  return families;
}

template <class Parse>
void expect_bounded(const std::vector<Family>& families, Parse&& parse,
                    std::size_t multiple = kReaderMultiple) {
  for (const Family& family : families) {
    const std::size_t bytes = peak_of([&] { parse(family.bytes); });
    const std::size_t size = family.bytes.size();
    EXPECT_LE(bytes + size, multiple * size + kReaderBytes)
        << family.name << ": " << bytes / size << " times its " << size << " bytes";
  }
}

TEST(Memory, OfStacksIsBounded) {
  for (const Validity validity : {Validity::required, Validity::unchecked}) {
    expect_bounded(stacks(), [&](const std::string& bytes) {
      static_cast<void>(parse_cnt(bytes, "a.cnt", validity));
    });
  }
}

TEST(Memory, OfGridsIsBounded) {
  std::vector<Family> families = grids();
  families.push_back({"shared", shared_blocks(20'000, 0)});
  families.push_back({"overlapping", shared_blocks(20'000, 8)});
  expect_bounded(families,
                 [](const std::string& bytes) { static_cast<void>(parse_vtu(bytes, "a.vtu")); });
}

TEST(Memory, OfSolidsIsBounded) {
  expect_bounded(solids(),
                 [](const std::string& bytes) { static_cast<void>(parse_model(bytes, "a")); });
}

TEST(Memory, OfPackedGridsIsBounded) {
  expect_bounded(packed_grids(), [](const std::string& bytes) {
    EXPECT_TRUE(parse_vtu(bytes, "a.vtu").ok());  // it is as large as can be, but not larger
  });
}

TEST(Memory, OfLabelsAndPointsIsBounded) {
  const std::vector<Family> families{
      {"rows", repeated("0 0 0\n", kSize)},    {"decisions", repeated("join 0 0 0\n", kSize)},
      {"comments", repeated("#\n", kSize)},    {"long line", repeated("0 ", kSize)},
      {"long token", std::string(kSize, '0')}, {"zeros", std::string(kSize / 24 * 24, '\0')}};
  expect_bounded(families, [](const std::string& bytes) {
    static_cast<void>(parse_labels(bytes, "a.txt"));
    static_cast<void>(parse_points(bytes, "a.txt"));
    static_cast<void>(parse_points(bytes, "a.bin"));
  });
}

std::vector<Family> medit_meshes() {
  const std::string head = "MeshVersionFormatted 2 Dimension 3 ";
  const std::string of_tets = head + "Vertices 1 0 0 0 0 Tetrahedra ";
  std::string components, names = head;
  int tets = 0;
  while (components.size() < kSize) components += "\n1 1 1 1 " + std::to_string(++tets);
  for (int i = 1; names.size() < kSize; ++i) names += "#component " + std::to_string(i) + ":\n";
  const std::string count = std::to_string(kSize / 8);
  return {
      {"points", repeated("0 0 0 0\n", kSize, head + "Vertices " + count + '\n')},
      {"tets", of_tets + std::to_string(kSize / 10) + '\n' + test::repeated("1 1 1 1 1\n", kSize)},
      {"components", of_tets + std::to_string(tets) + components},
      {"names", names},
      {"name after name", repeated("#component 1:" + std::string(40, 'a') + '\n', kSize)},
      {"comments", repeated("#\n", kSize, head)},
      {"long comment", head + '#' + std::string(kSize, 'a')},
      {"long token", head + "Vertices " + std::string(kSize, '1')},
      {"keywords", repeated("A ", kSize, head)},
      {"numbers", repeated("0 ", kSize, head + "Ridges ")},
      {"huge counts", repeated("Tetrahedra 99999999999 ", kSize, head)}};
}

TEST(Memory, OfMeditIsBounded) {
  std::size_t read = 0;
  expect_bounded(medit_meshes(), [&](const std::string& bytes) {
    read += parse_model(bytes, "a.mesh").ok() ? 1U : 0U;
  });
  EXPECT_GE(read, 2U);
}

TEST(Memory, OfTetgenIsBounded) {
  test::TempFolder folder;
  test::put(folder.file("a.node"), "1 3\n1 0 0 0\n");
  const auto read = [&](const std::string& bytes) {
    test::put(folder.file("a.ele"), bytes);
    EXPECT_TRUE(read_model(folder.file("a.ele")).ok());
  };
  std::string regions;
  int tets = 0;
  for (; regions.size() < kSize; ++tets) {
    regions += '\n' + std::to_string(tets + 1) + " 1 1 1 1 " + std::to_string(tets);
  }
  expect_bounded({{"regions", std::to_string(tets) + " 4 1" + regions},
                  {"comments", repeated("#\n", kSize, "0 4\n")},
                  {"one comment", "0 4 #" + std::string(kSize, 'a')}},
                 read);
  // Many points, few tets.
  const std::string ele = "1 4\n1 1 1 1 1\n";
  test::put(folder.file("a.ele"), ele);
  std::string nodes;
  int points = 0;
  for (; nodes.size() < kSize; ++points) nodes += '\n' + std::to_string(points + 1) + " 0 0 0";
  test::put(folder.file("a.node"), std::to_string(points) + " 3" + nodes);
  const std::size_t peak = peak_of([&] { EXPECT_TRUE(read_model(folder.file("a.ele")).ok()); });
  EXPECT_LE(peak, kReaderMultiple * nodes.size() + kReaderBytes);
}

std::vector<Family> volumes() {
  std::vector<Family> families;
  const std::string side = std::to_string(kSize / 400);
  const std::string nrrd = "NRRD0004\ntype: uchar\ndimension: 3\nsizes: 20 20 " + side + "\n";
  const std::string raw = nrrd + "encoding: raw\n\n";
  families.push_back({"boards", repeated(std::string("\0\1", 2), kSize, raw)});
  families.push_back({"ones", repeated("\1", kSize, raw)});
  std::string noise = raw;
  for (std::size_t i = 0; i < kSize; ++i) noise += static_cast<char>(i * i * 2654435761U >> 13);
  families.push_back({"noise", noise});
  families.push_back({"lone pixels", repeated(std::string("\0\1", 2), kSize,
                                              "NRRD0004\ntype: uchar\ndimension: 3\nsizes: 633 631 "
                                              "1\nencoding: raw\n\n")});
  families.push_back({"doubles", repeated("00000000", kSize,
                                          "NRRD0004\ntype: double\ndimension: 3\nsizes: 20 20 100\n"
                                          "endian: big\nencoding: raw\n\n")});
  families.push_back({"text", repeated("0 1 ", kSize,
                                       "NRRD0004\ntype: int\ndimension: 3\nsizes: 20 20 500\n"
                                       "encoding: ascii\n\n")});
  std::string keys = nrrd;
  for (int i = 0; keys.size() < kSize; ++i) keys += std::to_string(i) + ":=\n";
  families.push_back({"keys", keys});
  std::string segments = nrrd;
  for (int i = 0; segments.size() < kSize; ++i) {
    segments += "Segment" + std::to_string(i) + "_Name:=\n";
  }
  families.push_back({"segments", segments + "encoding: raw\n\n"});
  families.push_back({"names", repeated("a\n", kSize, nrrd + "encoding: raw\ndata file: LIST\n")});
  families.push_back({"long line", nrrd + std::string(kSize, 'a')});
  std::string fields = "NDims = 3\n";
  for (int i = 0; fields.size() < kSize; ++i) fields += std::to_string(i) + "=\n";
  families.push_back({"fields", fields});
  return families;
}

TEST(Memory, OfVolumesIsBounded) {
  for (const int axis : {0, 2}) {
    for (const auto way : {VolumeContours::sub_pixel, VolumeContours::lattice}) {
      expect_bounded(
          volumes(),
          [&](const std::string& bytes) {
            ReadOptions options;
            options.axis = axis;
            options.contours = way;
            options.structure = "1";
            static_cast<void>(parse_stack(bytes, "a.nrrd", options));
            options.structure = {};
            options.iso = 48;
            static_cast<void>(parse_stack(bytes, "a.nrrd", options));
          },
          kVolumeMultiple);
    }
  }
  expect_bounded(volumes(), [](const std::string& bytes) {
    static_cast<void>(inspect_bytes(bytes, "a.nrrd"));
  });
}

// Whatever a small file unpacks to, a slice is in memory, and what contours there are.
TEST(Memory, OfPackedVolumesIsThatOfASlice) {
  const std::string zeros = io::zlib_compressed(std::string(std::size_t{64} << 20, '\0'));
  const auto header = [](const char* sizes) {
    return "NDims = 3\nDimSize = " + std::string(sizes) +
           "\nElementType = MET_UCHAR\nCompressedData = True\nElementDataFile = LOCAL\n";
  };
  for (const char* sizes : {"256 256 1024", "16 16 262144"}) {
    const std::string bytes = header(sizes) + zeros;
    const std::size_t peak = peak_of([&] {
      const auto summary = inspect_bytes(bytes, "a.mha");
      ASSERT_TRUE(summary.ok());
      EXPECT_EQ(summary->volume->labels.at(0).voxels, std::size_t{64} << 20);
      EXPECT_FALSE(parse_stack(bytes, "a.mha").ok());
    });
    EXPECT_LE(peak, kReaderBytes) << sizes;
  }
  // A large slice is announced, and not there.
  const std::string cut = header("8192 8192 1") + zeros.substr(0, zeros.size() - 1000);
  const std::size_t peak = peak_of([&] { EXPECT_FALSE(parse_stack(cut, "a.mha").ok()); });
  EXPECT_LE(peak, std::size_t{4} * 8192 * 8192);
}

TEST(Memory, OfAVolumeInAFileIsThatOfASlice) {
  test::TempFolder folder;
  std::string bytes = "NRRD0004\ntype: uchar\ndimension: 3\nsizes: 200 200 500\nencoding: raw\n\n";
  bytes.resize(bytes.size() + 200 * 200 * 500);
  bytes[bytes.size() - 100'000] = 1;
  test::put(folder.file("a.nrrd"), bytes);
  const std::size_t peak = peak_of([&] { EXPECT_TRUE(read_stack(folder.file("a.nrrd")).ok()); });
  EXPECT_LE(peak, kReaderBytes);
}

TEST(Memory, OfAWholeFileIsItsSize) {
  test::TempFolder folder;
  test::put(folder.file("a"), std::string(5'000'000, 'x'));
  const std::size_t bytes = peak_of([&] { EXPECT_TRUE(io::read_file(folder.file("a")).ok()); });
  EXPECT_LE(bytes, 5'100'000U);
}

TEST(Memory, OfAStreamEndsAtItsLimit) {
  const io::ReadLimits limits{1U << 20, 1U << 20};
  const std::size_t bytes = peak_of([&] {
    const auto read = io::read_file("/dev/zero", limits);
    ASSERT_FALSE(read.ok());
    EXPECT_EQ(read.error().code, ErrorCode::io);
    EXPECT_NE(read.error().message.find("1 MiB"), std::string::npos) << read.error().message;
  });
  EXPECT_LE(bytes, (std::size_t{3} << 20) + 16384);
}

}  // namespace
}  // namespace tetloft

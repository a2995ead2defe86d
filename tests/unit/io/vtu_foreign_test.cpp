// Unstructured grids as other writers lay them out, put together here by hand.
#include <gtest/gtest.h>

#include <tetloft/io.hpp>

#include "core/little_endian.hpp"
#include "unit/io/io_support.hpp"

namespace tetloft {

using namespace internal;
namespace {

using test::TempFolder;

std::string base64(const std::string& bytes) {
  static const std::string kAlphabet =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    const auto byte = [&](std::size_t k) {
      return i + k < bytes.size() ? static_cast<unsigned char>(bytes[i + k]) : 0U;
    };
    const unsigned group = byte(0) << 16 | byte(1) << 8 | byte(2);
    for (std::size_t k = 0; k < 4; ++k) {
      text += i + k > bytes.size() ? '=' : kAlphabet[group >> (18 - 6 * k) & 63U];
    }
  }
  return text;
}

template <class T>
std::string packed(const std::vector<double>& values) {
  std::string bytes;
  for (const double value : values) append_little(bytes, static_cast<T>(value));
  return bytes;
}

template <class Header>
std::string with_count(const std::string& bytes) {
  return packed<Header>({static_cast<double>(bytes.size())}) + bytes;
}

// The unit tet.
const std::vector<double> kPoints{0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1};
const std::vector<double> kCorners{0, 1, 2, 3};
const std::vector<double> kOffsets{4};
const std::vector<double> kTypes{10};

struct ArrayText {
  std::string points, corners, offsets, types;
};

// A file around four complete DataArray elements.
std::string file_of(const std::string& root_attributes, const ArrayText& arrays,
                    const std::string& tail = "") {
  return "<?xml version='1.0'?>\n<!-- made <by> hand -->\n<VTKFile type=\"UnstructuredGrid\" " +
         root_attributes +
         ">\n<UnstructuredGrid>\n<FieldData><DataArray type=\"String\" Name=\"s\" "
         "format=\"ascii\">65 0</DataArray></FieldData>\n"
         "<Piece NumberOfPoints = '4'\n NumberOfCells='1'>\n<PointData Scalars='a'></PointData>"
         "<CellData/>\n<Points>" +
         arrays.points + "</Points>\n<Cells>" + arrays.corners + arrays.offsets + arrays.types +
         "</Cells></Piece></UnstructuredGrid>" + tail + "\n</VTKFile>\n";
}

std::string array(const std::string& type, const std::string& name, const std::string& rest,
                  const std::string& text = "") {
  return "<DataArray type=\"" + type + "\" Name=\"" + name + "\" " + rest + ">" + text +
         "</DataArray>\n";
}

ArrayText ascii_arrays() {
  return {array("Float64", "Points", "NumberOfComponents=\"3\" format=\"ascii\"",
                "0 0 0 1 0 0\r\n0 1 0 0 0 1e0\n<InformationKey name=\"L2_NORM_RANGE\">\n1 2\n"
                "</InformationKey>\n"),
          array("Int32", "connectivity", "format=\"ascii\"", "\n0 1 2 3\n"),
          array("Int32", "offsets", "format=\"ascii\"", "4"),
          array("UInt8", "types", "format=\"ascii\"", "10")};
}

void expect_unit_tet(const std::string& bytes) {
  TempFolder folder;
  test::put(folder.file("m.vtu"), bytes);
  const auto read = read_vtu(folder.file("m.vtu"));
  ASSERT_TRUE(read.ok()) << to_string(read.error()) << '\n' << bytes;
  const std::vector<Point3> points{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  EXPECT_EQ(read->points.raw(), points);
  ASSERT_EQ(read->tets.size(), 1U);
  const TetVertices tet{VertexId(0), VertexId(1), VertexId(2), VertexId(3)};
  EXPECT_EQ(read->tets[TetId(0)], tet);
}

void expect_error(const std::string& bytes, const std::string& word) {
  TempFolder folder;
  test::put(folder.file("m.vtu"), bytes);
  const auto read = read_vtu(folder.file("m.vtu"));
  ASSERT_FALSE(read.ok()) << bytes;
  EXPECT_EQ(read.error().code, ErrorCode::invalid_input);
  EXPECT_TRUE(read.error().where.line.has_value());
  EXPECT_NE(read.error().message.find(word), std::string::npos) << read.error().message;
}

TEST(ReadVtu, TakesAsciiArrays) { expect_unit_tet(file_of("version='0.1'", ascii_arrays())); }

// Inline base64, with either width of byte counts and the types in use.
template <class Header, class Real, class Index>
void expect_inline_base64(const std::string& header, const std::string& real,
                          const std::string& index) {
  const auto text = [](const std::string& bytes) {
    return "\n   " + base64(with_count<Header>(bytes)) + "\n   ";
  };
  expect_unit_tet(
      file_of("byte_order=\"LittleEndian\"" + header,
              {array(real, "Points", "NumberOfComponents=\"3\" format=\"binary\"",
                     text(packed<Real>(kPoints))),
               array(index, "connectivity", "format=\"binary\"", text(packed<Index>(kCorners))),
               array(index, "offsets", "format=\"binary\"", text(packed<Index>(kOffsets))),
               array("UInt8", "types", "format=\"binary\"", text(packed<std::uint8_t>(kTypes)))}));
}

TEST(ReadVtu, TakesInlineBase64) {
  const std::string wide = " header_type=\"UInt64\"";
  expect_inline_base64<std::uint32_t, float, std::int32_t>("", "Float32", "Int32");
  expect_inline_base64<std::uint32_t, double, std::int64_t>(" header_type=\"UInt32\"", "Float64",
                                                            "Int64");
  expect_inline_base64<std::uint64_t, float, std::uint64_t>(wide, "Float32", "UInt64");
  expect_inline_base64<std::uint64_t, double, std::uint16_t>(wide, "Float64", "UInt16");
}

// Some writers encode the byte count apart from the data.
TEST(ReadVtu, TakesBase64WithACountOfItsOwn) {
  const auto text = [](const std::string& bytes) {
    return base64(packed<std::uint32_t>({static_cast<double>(bytes.size())})) + base64(bytes);
  };
  expect_unit_tet(file_of(
      "",
      {array("Float64", "Points", "NumberOfComponents=\"3\" format=\"binary\"",
             text(packed<double>(kPoints))),
       array("Int32", "connectivity", "format=\"binary\"", text(packed<std::int32_t>(kCorners))),
       array("Int32", "offsets", "format=\"binary\"", text(packed<std::int32_t>(kOffsets))),
       array("UInt8", "types", "format=\"binary\"", text(packed<std::uint8_t>(kTypes)))}));
}

template <class Header>
std::string appended_file(const std::string& header, bool as_base64) {
  std::string data;
  const auto add = [&](const std::string& type, const std::string& name, const std::string& bytes) {
    const std::string rest = "NumberOfComponents=\"" + std::string(name == "Points" ? "3" : "1") +
                             "\" format=\"appended\" offset=\"" + std::to_string(data.size()) + '"';
    const std::string counted = with_count<Header>(bytes);
    data += as_base64 ? base64(counted) : counted;
    return array(type, name, rest);
  };
  // Not in the order in which the file names them.
  ArrayText arrays;
  arrays.types = add("UInt8", "types", packed<std::uint8_t>(kTypes));
  arrays.offsets = add("Int64", "offsets", packed<std::int64_t>(kOffsets));
  arrays.points = add("Float32", "Points", packed<float>(kPoints));
  arrays.corners = add("Int64", "connectivity", packed<std::int64_t>(kCorners));
  return file_of(header, arrays,
                 "<AppendedData encoding=\"" + std::string(as_base64 ? "base64" : "raw") +
                     "\">\n   _" + data + "\n  </AppendedData>");
}

TEST(ReadVtu, TakesAppendedData) {
  const std::string wide = "header_type=\"UInt64\"";
  expect_unit_tet(appended_file<std::uint32_t>("", false));
  expect_unit_tet(appended_file<std::uint32_t>("", true));
  expect_unit_tet(appended_file<std::uint64_t>(wide, false));
  expect_unit_tet(appended_file<std::uint64_t>(wide, true));
}

TEST(ReadVtu, JoinsPieces) {
  std::string text = file_of("", ascii_arrays());
  const std::size_t from = text.find("<Piece");
  const std::size_t to = text.find("</Piece>") + 8;
  text.insert(to, text.substr(from, to - from));
  TempFolder folder;
  test::put(folder.file("m.vtu"), text);
  const auto read = read_vtu(folder.file("m.vtu"));
  ASSERT_TRUE(read.ok()) << to_string(read.error());
  EXPECT_EQ(read->points.size(), 8U);
  const TetVertices second{VertexId(4), VertexId(5), VertexId(6), VertexId(7)};
  EXPECT_EQ(read->tets[TetId(1)], second);
}

TEST(ReadVtu, IgnoresArraysThatOnlyShareAName) {
  std::string text = file_of("", ascii_arrays());
  text.replace(text.find("<CellData/>"), 11,
               "<CellData>" + array("Float32", "component", "format=\"ascii\"", "0.5") +
                   array("Int32", "slab", "NumberOfComponents=\"3\" format=\"ascii\"", "1 2 3") +
                   array("Int32", "kind", "format=\"ascii\"", "99") +
                   array("String", "names", "format=\"ascii\"", "65 66 0") + "</CellData>");
  expect_unit_tet(text);
  text.replace(text.find("\"Float32\" Name=\"component\""), 9, "\"Int16\"");
  expect_error(text, "component");
}

TEST(ReadVtu, RefusesWhatItCannotRead) {
  ArrayText arrays = ascii_arrays();
  expect_error(
      file_of("compressor=\"vtkLZ4DataCompressor\"",
              {array("Float32", "Points", "NumberOfComponents=\"3\" format=\"binary\"", "AQAAAA=="),
               arrays.corners, arrays.offsets, arrays.types}),
      "compressed");
  std::string big = appended_file<std::uint32_t>("byte_order=\"BigEndian\"", false);
  expect_error(big, "big-endian");
  expect_error("<VTKFile type=\"PolyData\"><PolyData></PolyData></VTKFile>", "PolyData");
  arrays.types = array("UInt8", "types", "format=\"ascii\"", "12");
  expect_error(file_of("", arrays), "12");
}

TEST(ReadVtu, RefusesContradictions) {
  const ArrayText good = ascii_arrays();
  const auto with = [&](const std::string ArrayText::*which, const std::string& text) {
    ArrayText arrays = good;
    const_cast<std::string&>(arrays.*which) = text;
    return file_of("", arrays);
  };
  const std::string three = "NumberOfComponents=\"3\" format=\"ascii\"";
  expect_error(with(&ArrayText::points, ""), "Points");
  expect_error(with(&ArrayText::points, array("Float64", "Points", three, "0 0 0")), "4 points");
  expect_error(with(&ArrayText::points,
                    array("Float64", "Points", "format=\"ascii\"", "0 0 0 1 0 0 0 1 0 0 0 1")),
               "Points");
  expect_error(
      with(&ArrayText::points, array("Float64", "Points", three, "0 0 0 1 0 0 0 1 0 0 0 nan")),
      "nan");
  expect_error(
      with(&ArrayText::points, array("Float32", "Points", three, "0 0 0 1 0 0 0 1 0 0 0 1e99")),
      "finite");
  const std::string plain = "format=\"ascii\"";
  expect_error(with(&ArrayText::corners, ""), "connectivity");
  expect_error(with(&ArrayText::corners, array("Int32", "connectivity", plain, "0 1 2")), "3");
  expect_error(with(&ArrayText::corners, array("Int32", "connectivity", plain, "0 1 2 4")), "4");
  expect_error(with(&ArrayText::corners, array("Int32", "connectivity", plain, "0 1 -1 3")), "-1");
  expect_error(with(&ArrayText::corners, array("Float32", "connectivity", plain, "0 1 2 3")),
               "integers");
  expect_error(with(&ArrayText::corners, array("Int32", "connectivity", plain, "0 1 2 x")), "x");
  expect_error(with(&ArrayText::offsets, array("Int32", "offsets", plain, "3")), "corners");
  expect_error(with(&ArrayText::offsets, array("Int32", "offsets", plain, "4 8")), "offsets");
  expect_error(with(&ArrayText::types, array("Quaternion", "types", plain, "10")), "type");
  expect_error(with(&ArrayText::types, array("UInt8", "types", "format=\"cuneiform\"", "10")),
               "format");
  expect_error(with(&ArrayText::types, array("UInt8", "types", "format=\"binary\"", "A*==")),
               "base64");
  expect_error(with(&ArrayText::types, array("UInt8", "types", "format=\"appended\" offset=\"0\"")),
               "appended");
}

}  // namespace
}  // namespace tetloft

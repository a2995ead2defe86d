// VTK poly data, read: every way that data can stand in a file, closedness, pieces, and stacks
// that were written.
#include <gtest/gtest.h>

#include <cstdint>
#include <string>

#include "core/little_endian.hpp"
#include "io/base64.hpp"
#include "unit/drawings/stack_support.hpp"

namespace tetloft {

using namespace internal;
namespace {

using internal::io::encode_base64;
using test::heights_of;

struct Packing {
  bool packed = false;
  bool wide = false;  // UInt64 headers
  enum class Where { text, inside, appended_raw, appended_base64 } where = Where::text;
};

// zlib of stored blocks, which need no compressor.
std::string zlib_of(const std::string& bytes) {
  std::string out = "\x78\x01\x01";
  append_little(out, static_cast<std::uint16_t>(bytes.size()));
  append_little(out, static_cast<std::uint16_t>(~bytes.size()));
  out += bytes;
  std::uint32_t a = 1;
  std::uint32_t b = 0;
  for (const char c : bytes) {
    a = (a + static_cast<unsigned char>(c)) % 65521;
    b = (b + a) % 65521;
  }
  for (const std::uint32_t part : {b >> 8, b, a >> 8, a}) out += static_cast<char>(part & 255U);
  return out;
}

class VtpMaker {
 public:
  explicit VtpMaker(Packing packing) : packing_(packing) {}

  template <class T>
  std::string array(const std::string& name, const std::string& type, std::size_t components,
                    const std::vector<T>& values) {
    std::string tag = "<DataArray type=\"" + type + "\" Name=\"" + name +
                      "\" NumberOfComponents=\"" + std::to_string(components) + "\" format=\"";
    if (packing_.where == Packing::Where::text) {
      std::string text;
      for (const T& value : values) text += std::to_string(value) + ' ';
      return tag + "ascii\">" + text + "</DataArray>\n";
    }
    std::string bytes;
    for (const T& value : values) append_little(bytes, value);
    const auto [header, data] = encoded(bytes);
    if (packing_.where == Packing::Where::inside) {
      return tag + "binary\">\n " + text_of(header, data) + "\n</DataArray>\n";
    }
    tag += "appended\" offset=\"" + std::to_string(appended_.size()) + "\"/>\n";
    appended_ +=
        packing_.where == Packing::Where::appended_raw ? header + data : text_of(header, data);
    return tag;
  }

  std::string file(const std::string& inside) const {
    std::string text =
        "<?xml version=\"1.0\"?>\n<VTKFile type=\"PolyData\" version=\"1.0\" "
        "byte_order=\"LittleEndian\"";
    if (packing_.wide) text += " header_type=\"UInt64\"";
    if (packing_.packed) text += " compressor=\"vtkZLibDataCompressor\"";
    text += ">\n<PolyData>\n" + inside + "</PolyData>\n";
    if (packing_.where == Packing::Where::appended_raw) {
      text += "<AppendedData encoding=\"raw\">\n_" + appended_ + "\n</AppendedData>\n";
    }
    if (packing_.where == Packing::Where::appended_base64) {
      text += "<AppendedData encoding=\"base64\">\n_" + appended_ + "\n</AppendedData>\n";
    }
    return text + "</VTKFile>\n";
  }

 private:
  void word(std::string& bytes, std::size_t value) const {
    if (packing_.wide) {
      append_little(bytes, static_cast<std::uint64_t>(value));
    } else {
      append_little(bytes, static_cast<std::uint32_t>(value));
    }
  }

  // The header and the data behind it.
  std::pair<std::string, std::string> encoded(const std::string& bytes) const {
    std::string header;
    if (!packing_.packed) {
      word(header, bytes.size());
      return {header, bytes};
    }
    // Blocks of 16 bytes, of which the last is shorter.
    constexpr std::size_t kBlock = 16;
    const std::size_t blocks = (bytes.size() + kBlock - 1) / kBlock;
    word(header, blocks);
    word(header, kBlock);
    word(header, bytes.size() % kBlock);
    std::string data;
    for (std::size_t i = 0; i < blocks; ++i) {
      const std::string block = zlib_of(bytes.substr(i * kBlock, kBlock));
      word(header, block.size());
      data += block;
    }
    return {header, data};
  }

  std::string text_of(const std::string& header, const std::string& data) const {
    return packing_.packed ? encode_base64(header) + encode_base64(data)
                           : encode_base64(header + data);
  }

  Packing packing_;
  std::string appended_;
};

std::vector<Packing> all_packings() {
  std::vector<Packing> all;
  for (const auto where : {Packing::Where::text, Packing::Where::inside,
                           Packing::Where::appended_raw, Packing::Where::appended_base64}) {
    for (const bool packed : {false, true}) {
      for (const bool wide : {false, true}) all.push_back({packed, wide, where});
    }
  }
  return all;
}

// Two squares at z = 1 and 2, closed by a repeated id; between them other elements.
template <class Real, class Index>
std::string two_squares(Packing packing, const std::string& real, const std::string& index) {
  VtpMaker maker(packing);
  std::string piece =
      "<Piece NumberOfPoints=\"8\" NumberOfVerts=\"0\" NumberOfLines=\"2\" NumberOfStrips=\"0\" "
      "NumberOfPolys=\"1\">\n<Points>\n";
  piece += maker.array<Real>(
      "Points", real, 3, {0, 0, 1, 4, 0, 1, 4, 4, 1, 0, 4, 1, 0, 0, 2, 4, 0, 2, 4, 4, 2, 0, 4, 2});
  piece += "</Points>\n<Lines>\n" +
           maker.array<Index>("connectivity", index, 1, {0, 1, 2, 3, 0, 4, 5, 6, 7, 4}) +
           maker.array<Index>("offsets", index, 1, {5, 10}) + "</Lines>\n<Polys>\n" +
           maker.array<Index>("connectivity", index, 1, {0, 1, 6}) +
           maker.array<Index>("offsets", index, 1, {3}) + "</Polys>\n</Piece>\n";
  return maker.file(piece);
}

TEST(ReadVtp, TakesDataInEveryForm) {
  for (const Packing& packing : all_packings()) {
    for (const std::string& text :
         {two_squares<double, std::int64_t>(packing, "Float64", "Int64"),
          two_squares<float, std::int32_t>(packing, "Float32", "Int32")}) {
      const Result<ReadStack> read = parse_stack(text, "a.vtp");
      ASSERT_TRUE(read.ok()) << to_string(read.error()) << text;
      EXPECT_EQ(heights_of(read->stack), (std::vector<double>{1, 2}));
      EXPECT_EQ(read->stack.vertex_count(), 8U);
      EXPECT_TRUE(test::says(read->warnings, "1 polygons and strips"));
      const Result<ReadPoints> points = parse_points(text, "a.vtp");
      ASSERT_TRUE(points.ok());
      EXPECT_EQ(points->points.size(), 8U);
      EXPECT_EQ(points->points[6], (Point3{4, 4, 2}));
    }
  }
}

std::string pieces(const std::string& lines, const std::string& count, const std::string& group) {
  VtpMaker maker({});
  const std::string one =
      "<Piece NumberOfPoints=\"4\" NumberOf" + group + "=\"" + count + "\"><Points>" +
      maker.array<double>("P", "Float64", 3, {0, 0, 1, 4, 0, 1, 4, 4, 1, 0, 4, 1}) + "</Points><" +
      group + ">" + lines + "</" + group + "></Piece>";
  return maker.file(one);
}
std::string arrays(const std::string& ids, const std::string& ends) {
  return "<DataArray type=\"Int32\" Name=\"connectivity\">" + ids +
         "</DataArray><DataArray type=\"Int32\" Name=\"offsets\">" + ends + "</DataArray>";
}

TEST(ReadVtp, TakesPolygonsWhereThereAreNoLines) {
  const Result<ReadStack> read = parse_stack(pieces(arrays("0 1 2 3", "4"), "1", "Polys"), "a.vtp");
  ASSERT_TRUE(read.ok()) << to_string(read.error());
  EXPECT_EQ(read->stack.vertex_count(), 4U);
}

TEST(ReadVtp, JoinsSegmentsAndRefusesOpenLines) {
  const Result<ReadStack> read =
      parse_stack(pieces(arrays("0 1 2 1 2 3 0 3", "2 4 6 8"), "4", "Lines"), "a.vtp");
  ASSERT_TRUE(read.ok()) << to_string(read.error());
  EXPECT_EQ(read->stack.vertex_count(), 4U);
  EXPECT_NE(test::refusal_of(pieces(arrays("0 1 2 3", "4"), "1", "Lines"), {}).find("an open line"),
            std::string::npos);
}

TEST(ReadVtp, RefusesWhatContradictsItself) {
  const std::vector<std::pair<std::string, std::string>> wrong{
      {pieces(arrays("0 1 2 4", "4"), "1", "Lines"), "refers to point 4 of 4"},
      {pieces(arrays("0 1 -1", "3"), "1", "Lines"), "refers to point -1"},
      {pieces(arrays("0 1 2", "4"), "1", "Lines"), "do not increase within"},
      {pieces(arrays("0 1 2 0", "2 1"), "2", "Lines"), "do not increase"},
      {pieces(arrays("0 1 2", "3"), "2", "Lines"), "offsets has 1 values where 2"},
      {pieces("", "1", "Lines"), "lacks the array"},
      {pieces(arrays("0", "1") + arrays("0", "1"), "1", "Lines"), "two arrays 'connectivity'"},
      {pieces(arrays("0 1 2", "3"), "-1", "Lines"), "a count that is none"},
      {pieces("", "0", "Lines"), "neither lines nor polygons"},
      {"<VTKFile type=\"PolyData\"><PolyData>", "its end is missing"},
      {"<VTKFile type=\"PolyData\"></VTKFile><a/>", "follows the end"}};
  for (const auto& [text, reason] : wrong) {
    const std::string refusal = test::refusal_of(text, test::as_format("vtp"));
    EXPECT_NE(refusal.find(reason), std::string::npos) << text << '\n' << refusal;
  }
}

TEST(ReadVtp, BoundsWhatPackedDataUnpackTo) {
  // Blocks that announce 16 MiB each, of a few bytes.
  std::string header;
  for (const std::uint32_t word : {2U, 1U << 24, 0U, 11U, 11U}) append_little(header, word);
  const std::string text =
      "<VTKFile type=\"PolyData\" compressor=\"vtkZLibDataCompressor\"><PolyData><Piece "
      "NumberOfPoints=\"9\"><Points><DataArray type=\"Float64\" NumberOfComponents=\"3\" "
      "format=\"binary\">" +
      encode_base64(header) + encode_base64(zlib_of("") + zlib_of("")) +
      "</DataArray></Points></Piece></PolyData></VTKFile>";
  const Result<ReadPoints> read = parse_points(text, "a.vtp");
  ASSERT_FALSE(read.ok());
  EXPECT_NE(read.error().message.find("more than 16 times its size"), std::string::npos)
      << read.error().message;
}

TEST(ReadVtp, RefusesPackedDataThatAreWrong) {
  const std::string whole = two_squares<double, std::int64_t>(
      {true, false, Packing::Where::appended_raw}, "Float64", "Int64");
  const std::size_t data = whole.find("\n_") + 2;
  std::size_t refused = 0;
  for (std::size_t at = data; at < whole.size() - 40; ++at) {
    std::string wrong = whole;
    wrong[at] = static_cast<char>(wrong[at] ^ 0x10);
    const Result<ReadStack> read = parse_stack(wrong, "a.vtp");
    if (!read) ++refused;
  }
  // Checksums tell of every byte, but for those of arrays that are not read.
  EXPECT_GT(refused, (whole.size() - data) * 3 / 4);
}

SectionStack near_planes() {
  SectionStack stack;
  for (const double z : {-1.0 / 3, 0.1, 0.1000001, 7e5}) {
    Section section{z, {}};
    section.contours.push_back({{{0.1, 0}, {1e22, 5e-324}, {1.0 / 3, 7}}});
    section.contours.push_back({{{-5, -5}, {-4, -4.5}, {-4.25, -5.0 / 3}}});
    stack.sections.push_back(section);
  }
  return stack;
}

TEST(WriteVtpStack, IsReadBackBitForBit) {
  const SectionStack stack = near_planes();
  for (const Encoding encoding : {Encoding::binary, Encoding::ascii}) {
    const Result<Formatted> written = format_stack(stack, {encoding, "vtp"});
    ASSERT_TRUE(written.ok()) << to_string(written.error());
    const Result<ReadStack> again = parse_stack(written->bytes, "a.vtp");
    ASSERT_TRUE(again.ok()) << to_string(again.error());
    ASSERT_EQ(heights_of(again->stack), heights_of(stack));
    for (const SectionId s : stack.sections.ids()) {
      const auto& contours = stack.sections[s].contours;
      ASSERT_EQ(again->stack.sections[s].contours.size(), contours.size());
      for (const ContourId c : contours.ids()) {
        EXPECT_EQ(again->stack.sections[s].contours[c].vertices, contours[c].vertices);
      }
    }
  }
}

TEST(WriteVtpStack, LiesWhereItsFrameSays) {
  SectionStack stack = near_planes();
  stack.frame.axes = {Point3{0, 1, 0}, Point3{0, 0, 1}, Point3{1, 0, 0}};
  const Result<Formatted> written = format_stack(stack, {.format = "vtp"});
  ASSERT_TRUE(written.ok());
  const Result<ReadPoints> points = parse_points(written->bytes, "a.vtp");
  ASSERT_TRUE(points.ok());
  EXPECT_EQ(points->points[0], (Point3{-1.0 / 3, 0.1, 0}));
}

TEST(ReadVtp, CountsAsVtkDoes) {
  const auto files = test::reference_files("vtp");
  if (files.empty()) GTEST_SKIP() << "no files of reference";
  for (const auto& file : files) {
    const Result<FileSummary> summary = inspect(file.string());
    ASSERT_TRUE(summary.ok()) << to_string(summary.error());
    EXPECT_EQ(summary->lines->points, test::truth_number(file, "points")) << file;
    EXPECT_EQ(summary->lines->contours, test::truth_number(file, "polylines"));
    EXPECT_EQ(summary->lines->closed,
              test::truth_number(file, "closed_polylines_first_id_repeated"));
  }
}

TEST(ReadVtu, TakesPackedData) {
  const auto files = test::reference_files("mesh-output");
  if (files.empty()) GTEST_SKIP() << "no files of reference";
  std::size_t grids = 0;
  for (const auto& file : files) {
    if (file.extension() != ".vtu") continue;
    ++grids;
    const Result<ReadModel> read = read_model(file.string());
    ASSERT_TRUE(read.ok()) << to_string(read.error());
    EXPECT_EQ(read->model.points.size(), 81U);
    EXPECT_EQ(read->model.tets.size(), 206U);
  }
  EXPECT_EQ(grids, 3U);
}

}  // namespace
}  // namespace tetloft

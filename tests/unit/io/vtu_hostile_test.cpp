// Grids that lie about their sizes, end early, or are damaged: an error each, never a crash
// (the sanitizers watch) and never memory beyond the size of the file.
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include <tetloft/io.hpp>

#include "core/prng.hpp"
#include "unit/io/io_support.hpp"

namespace tetloft {

using namespace internal;
namespace {

using test::TempFolder;

std::string written(Encoding encoding) {
  TempFolder folder;
  EXPECT_TRUE(write_vtu(folder.file("m.vtu"), test::hard_model(), encoding).ok());
  return test::get(folder.file("m.vtu"));
}

void expect_invalid(const std::string& bytes) {
  const auto read = parse_vtu(bytes, "m.vtu");
  ASSERT_FALSE(read.ok()) << bytes.size();
  EXPECT_EQ(read.error().code, ErrorCode::invalid_input) << to_string(read.error());
  EXPECT_FALSE(read.error().message.empty());
}

// Cut anywhere, but for white space at its end.
void expect_refused_when_cut(const std::string& whole) {
  ASSERT_TRUE(parse_vtu(whole, "m.vtu").ok());
  const std::size_t end = whole.find_last_not_of(" \n") + 1;
  for (std::size_t size = 0; size < end; ++size) expect_invalid(whole.substr(0, size));
  EXPECT_TRUE(parse_vtu(whole.substr(0, end), "m.vtu").ok());
}

TEST(ReadVtu, RefusesEveryTruncatedFile) {
  expect_refused_when_cut(written(Encoding::binary));
  expect_refused_when_cut(written(Encoding::ascii));
}

// A grid of one tet a piece, its arrays appended: how many pieces, and where each array of each
// piece finds its block, of five written one after the other (points, then connectivity, offsets
// and types, and component).
std::string appended_grid(std::size_t pieces, const std::vector<std::size_t>& offsets,
                          const std::string& between = "") {
  std::string text =
      "<VTKFile type=\"UnstructuredGrid\" byte_order=\"LittleEndian\" "
      "header_type=\"UInt32\"><UnstructuredGrid>";
  std::size_t next = 0;
  const auto array = [&](const char* name, const char* type) {
    return std::string("<DataArray Name=\"") + name + "\" type=\"" + type +
           "\" NumberOfComponents=\"" + (*name == 'P' ? "3" : "1") +
           "\" format=\"appended\" offset=\"" + std::to_string(offsets[next++ % offsets.size()]) +
           "\"/>";
  };
  for (std::size_t p = 0; p < pieces; ++p) {
    // One after the other: operands of + have no order.
    text += "<Piece NumberOfPoints=\"4\" NumberOfCells=\"1\"><Points>";
    text += array("P", "Int8");
    text += "</Points><Cells>";
    for (const char* name : {"connectivity", "offsets", "types"}) text += array(name, "Int8");
    text += "</Cells><CellData>";
    text += array("component", "Int8");
    text += "</CellData></Piece>";
  }
  text += "</UnstructuredGrid>" + between + "<AppendedData encoding=\"raw\">_";
  const std::vector<std::string> blocks{std::string("\0\0\0\1\0\0\0\1\0\0\0\1", 12),
                                        std::string("\0\1\2\3", 4), "\4", "\12",
                                        std::string(1, '\0')};
  for (std::size_t p = 0; p < pieces; ++p) {
    for (const std::string& block : blocks) {
      text += static_cast<char>(block.size());
      text += std::string(3, '\0') + block;
    }
  }
  return text + "</AppendedData></VTKFile>";
}

constexpr std::size_t kPieceBytes = 5 * 4 + 12 + 4 + 1 + 1 + 1;

std::vector<std::size_t> right_offsets(std::size_t pieces) {
  std::vector<std::size_t> offsets;
  for (std::size_t p = 0; p < pieces; ++p) {
    for (const std::size_t o : {0U, 16U, 24U, 29U, 34U}) offsets.push_back(p * kPieceBytes + o);
  }
  return offsets;
}

TEST(ReadVtu, ReadsPiecesOfWhichEachHasItsBlocks) {
  for (const std::size_t pieces : {1U, 2U, 300U}) {
    const auto read = parse_vtu(appended_grid(pieces, right_offsets(pieces)), "m.vtu");
    ASSERT_TRUE(read.ok()) << to_string(read.error());
    EXPECT_EQ(read->tets.size(), pieces);
    EXPECT_EQ(read->component.size(), pieces);
  }
}

TEST(ReadVtu, RefusesArraysThatShareAppendedData) {
  // All pieces take the blocks of the first; one takes those of another; one array does.
  expect_invalid(appended_grid(2, right_offsets(1)));
  expect_invalid(appended_grid(1000, right_offsets(1)));
  for (std::size_t a = 0; a < 10; ++a) {
    std::vector<std::size_t> offsets = right_offsets(2);
    offsets[a] = offsets[(a + 5) % 10];
    expect_invalid(appended_grid(2, offsets));
  }
}

TEST(ReadVtu, RefusesWhatStandsTwice) {
  const std::string whole = written(Encoding::ascii);
  std::size_t tried = 0;
  // Every array, every group and the whole piece, given again right behind.
  for (const char* element :
       {"DataArray", "Points", "Cells", "PointData", "CellData", "FieldData"}) {
    const std::string open = '<' + std::string(element);
    const std::string close = "</" + std::string(element) + '>';
    for (std::size_t from = whole.find(open); from != std::string::npos;
         from = whole.find(open, from + 1)) {
      const std::size_t end = whole.find(close, from) + close.size();
      std::string bytes = whole;
      bytes.insert(end, whole.substr(from, end - from));
      expect_invalid(bytes);
      ++tried;
    }
  }
  EXPECT_EQ(tried, 26U + 5U + 12U + 6U);
  for (const char* word : {"type=\"Float64\"", "NumberOfPoints", "version=\"1.0\""}) {
    std::string bytes = whole;
    const std::size_t at = bytes.rfind(word);
    const std::size_t end = bytes.find('"', bytes.find('"', at) + 1) + 1;
    bytes.insert(end, ' ' + bytes.substr(at, end - at));
    expect_invalid(bytes);
  }
  expect_invalid(whole + whole);
  expect_invalid(appended_grid(1, right_offsets(1), "<AppendedData encoding=\"raw\"/>"));
}

TEST(ReadVtu, RefusesTagsThatDoNotMatch) {
  const std::string whole = written(Encoding::ascii);
  for (std::size_t at = whole.find("</"); at != std::string::npos; at = whole.find("</", at + 1)) {
    const std::size_t end = whole.find('>', at) + 1;
    expect_invalid(whole.substr(0, at) + whole.substr(end));  // missing
    expect_invalid(whole.substr(0, end) + whole.substr(at, end - at) + whole.substr(end));  // twice
  }
}

TEST(ReadVtu, DoesNotTrustSizes) {
  const std::string whole = written(Encoding::ascii);
  for (const char* attribute : {"NumberOfPoints=\"", "NumberOfCells=\""}) {
    for (const char* number : {"0", "1", "1000000000", "1073741823", "4294967296",
                               "9223372036854775807", "18446744073709551615", "-1", "1e9", ""}) {
      std::string bytes = whole;
      const std::size_t from = bytes.find(attribute) + std::string(attribute).size();
      bytes.replace(from, bytes.find('"', from) - from, number);
      expect_invalid(bytes);
    }
  }
}

TEST(ReadVtu, DoesNotTrustOffsetsAndByteCounts) {
  const std::string whole = written(Encoding::binary);
  for (const char* number : {"1000000000", "9223372036854775807", "18446744073709551615", "-8"}) {
    std::string bytes = whole;
    const std::size_t from = bytes.rfind("offset=\"") + 8;
    bytes.replace(from, bytes.find('"', from) - from, number);
    expect_invalid(bytes);
  }
  for (const std::uint64_t count :
       {std::uint64_t{1}, std::uint64_t{1} << 40, ~std::uint64_t{0}, std::uint64_t{1} << 63}) {
    std::string bytes = whole;
    const std::size_t at = bytes.find("\n_", bytes.find("<AppendedData")) + 2;
    for (std::size_t i = 0; i < 8; ++i) bytes[at + i] = static_cast<char>(count >> (8 * i));
    expect_invalid(bytes);
  }
}

TEST(ReadVtu, SurvivesDamage) {
  Prng prng(4);
  for (const Encoding encoding : {Encoding::binary, Encoding::ascii}) {
    const std::string whole = written(encoding);
    std::size_t accepted = 0;
    constexpr std::size_t kTrials = 1500;
    for (std::size_t trial = 0; trial < kTrials; ++trial) {
      std::string bytes = whole;
      for (std::uint64_t n = prng.below(4) + 1; n > 0; --n) {
        const auto at = static_cast<std::size_t>(prng.below(bytes.size()));
        switch (prng.below(3)) {
          case 0: bytes[at] = static_cast<char>(prng.below(256)); break;
          case 1: bytes.erase(at, static_cast<std::size_t>(prng.below(20))); break;
          default: bytes.insert(at, 1, "<>\"/ =_0"[prng.below(8)]); break;
        }
      }
      const auto read = parse_vtu(bytes, "m.vtu");
      if (read.ok()) {
        ++accepted;
        for (const TetVertices& tet : read->tets) {
          for (const VertexId v : tet) ASSERT_LT(v.index(), read->points.size());
        }
      } else {
        ASSERT_EQ(read.error().code, ErrorCode::invalid_input) << to_string(read.error());
      }
    }
    // Damage to coordinates is not seen, damage elsewhere is.
    EXPECT_GT(accepted, kTrials / 100);
    EXPECT_LT(accepted, kTrials * 9 / 10);
  }
}

}  // namespace
}  // namespace tetloft

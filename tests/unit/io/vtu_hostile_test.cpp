// Grids that lie about their sizes, end early, or are damaged: an error each, never a crash
// (the sanitizers watch) and never memory beyond the size of the file.
#include <gtest/gtest.h>

#include <tetloft/io.hpp>

#include "core/prng.hpp"
#include "unit/io/io_support.hpp"

namespace tetloft {
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

TEST(ReadVtu, RefusesEveryTruncatedBinaryFile) {
  const std::string whole = written(Encoding::binary);
  const std::size_t data_end = whole.find("\n</AppendedData>");
  ASSERT_NE(data_end, std::string::npos);
  for (std::size_t size = 0; size < data_end; ++size) {
    expect_invalid(whole.substr(0, size));
  }
}

TEST(ReadVtu, RefusesTruncatedAsciiFiles) {
  const std::string whole = written(Encoding::ascii);
  // Up to where the last array's last value is complete.
  const std::size_t data_end = whole.rfind("10\n</DataArray>") + 1;
  for (std::size_t size = 0; size <= data_end; size += 7) {
    expect_invalid(whole.substr(0, size));
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

// Which file a stack was read from: all of it, and samples of large ones.
#include "pieces/plan_source.hpp"

#include <gtest/gtest.h>

#include <fstream>
#include <string>

#include "core/prng.hpp"
#include "unit/pieces/pieces_support.hpp"

namespace tetloft::testing {

using namespace internal;
namespace {

std::uint64_t sampled(const std::string& path, const std::string& bytes) {
  std::ofstream(path, std::ios::binary) << bytes;
  const auto checksum = pieces::sampled_checksum(path, bytes.size());
  EXPECT_TRUE(checksum.ok());
  return checksum ? *checksum : 0;
}

TEST(PlanSources, TellsFilesApartByAllOfTheirBytes) {
  const Folder folder;
  Prng prng(61);
  for (const std::size_t size : {0U, 1U, 100U, 70'000U, 4'200'000U}) {
    std::string bytes(size, ' ');
    for (char& c : bytes) c = static_cast<char>('a' + prng.below(26));
    std::ofstream(folder / "stack", std::ios::binary) << bytes;
    const auto source = plan_source(folder / "stack");
    ASSERT_TRUE(source.ok());
    EXPECT_EQ(source->name, "stack");
    EXPECT_EQ(source->bytes, size);
    EXPECT_EQ(source->sampled, *pieces::sampled_checksum(folder / "stack", size));
    if (size == 0) continue;
    bytes[size / 3] = '!';
    std::ofstream(folder / "other", std::ios::binary) << bytes;
    EXPECT_NE(plan_source(folder / "other")->checksum, source->checksum) << size;
  }
}

// Of what is larger than all samples, 4 MiB, both ends count and what is all over the file.
TEST(PlanSources, SamplesLieAllOverALargeFile) {
  const Folder folder;
  std::string bytes(6'000'001, '\0');
  for (std::size_t k = 0; k < bytes.size(); ++k) bytes[k] = static_cast<char>('a' + k % 23);
  const std::uint64_t as_it_is = sampled(folder / "stack", bytes);
  EXPECT_EQ(sampled(folder / "again", bytes), as_it_is);
  for (const std::size_t at : {std::size_t{0}, bytes.size() - 1}) {
    std::string changed = bytes;
    changed[at] = '!';
    EXPECT_NE(sampled(folder / "changed", changed), as_it_is) << at;
  }
  // As a line that is longer by one shifts what comes behind it, somewhere in the middle.
  std::string shifted = bytes;
  shifted.insert(3'500'000, "!").pop_back();
  EXPECT_NE(sampled(folder / "changed", shifted), as_it_is);
}

TEST(PlanSources, OfAFileThatIsShorterThanToldThereAreNone) {
  const Folder folder;
  std::ofstream(folder / "stack") << "short";
  const auto checksum = pieces::sampled_checksum(folder / "stack", 100);
  ASSERT_FALSE(checksum.ok());
  EXPECT_EQ(checksum.error().code, ErrorCode::io);
  EXPECT_FALSE(plan_source(folder / "none").ok());
}

}  // namespace
}  // namespace tetloft::testing

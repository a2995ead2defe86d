// Numbers in scratch files, and what is left of them where the disk is full.
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/resource.h>
#include <unistd.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "io/scratch_column.hpp"
#include "unit/io/io_support.hpp"

namespace tetloft::internal::io {
namespace {

TEST(ScratchSequence, IsWhatWasAppendedToAllColumns) {
  const test::TempFolder folder;
  ScratchColumn<double> below(folder.file("a"));
  ScratchColumn<double> above(folder.file("a"));
  constexpr std::size_t kEach = 20'000;  // longer than a buffer
  for (std::size_t i = 0; i < kEach; ++i) below.push_back(static_cast<double>(i));
  for (std::size_t i = 0; i < kEach; ++i) above.push_back(static_cast<double>(kEach + i));
  above.push_back(-1);
  above.cut(kEach);
  ScratchSequence<double> all({&below, &above});
  ASSERT_EQ(all.size(), 2 * kEach);
  for (std::size_t i = 0; i < all.size(); ++i) ASSERT_EQ(all.at(i), static_cast<double>(i));
  EXPECT_EQ(all.at(3), 3);
  EXPECT_FALSE(below.failure() || above.failure());
  EXPECT_TRUE(folder.names().empty());
}

// Beside which there is no folder with room.
TEST(ScratchSequence, IsThereForPipesAndDevices) {
  for (const char* const path : {"/dev/full", "/dev/null"}) {
    ScratchColumn<double> column(path);
    for (std::size_t i = 0; i < 20'000; ++i) column.push_back(static_cast<double>(i));
    ScratchSequence<double> all({&column});
    EXPECT_EQ(all.at(19'999), 19'999);
    EXPECT_FALSE(column.failure());
  }
  std::array<int, 2> ends{};
  ASSERT_EQ(pipe(ends.data()), 0);
  ScratchColumn<double> column("/dev/fd/" + std::to_string(ends[1]));
  column.push_back(7);
  EXPECT_FALSE(column.failure()) << to_string(*column.failure());
  close(ends[0]);
  close(ends[1]);
}

// The disk turns out to be full when the sequence is read already.
TEST(ScratchSequence, IsOfZerosWhereTheDiskIsFull) {
  const test::TempFolder folder;
  ScratchColumn<std::uint8_t> column(folder.file("a"));
  constexpr std::size_t kValues = 50'000;  // fewer than a buffer has, more than a stretch
  for (std::size_t i = 0; i < kValues; ++i) column.push_back(7);
  ScratchSequence<std::uint8_t> sequence({&column});
  rlimit before{};
  ASSERT_EQ(getrlimit(RLIMIT_FSIZE, &before), 0);
  const auto handler = signal(SIGXFSZ, SIG_IGN);
  const rlimit tight{1 << 12, before.rlim_max};
  ASSERT_EQ(setrlimit(RLIMIT_FSIZE, &tight), 0);
  std::size_t zeros = 0;
  for (std::size_t i = 0; i < kValues; ++i) zeros += sequence.at(i) == 0 ? 1U : 0U;
  setrlimit(RLIMIT_FSIZE, &before);
  signal(SIGXFSZ, handler);
  EXPECT_EQ(zeros, kValues);
  EXPECT_EQ(column.size(), kValues);
  ASSERT_TRUE(column.failure().has_value());
  EXPECT_EQ(column.failure()->code, ErrorCode::io);
}

}  // namespace
}  // namespace tetloft::internal::io

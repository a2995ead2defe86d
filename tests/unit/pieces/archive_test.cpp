// Archives: records read back one by one, and what is not whole is refused.
#include "pieces/archive.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include "core/record.hpp"

namespace tetloft::testing {

using namespace internal;
using pieces::ArchiveReader;
using pieces::ArchiveWriter;
namespace {

constexpr RecordKind kTest{"test", 1, "a test"};

std::string record_of(std::uint64_t value) {
  RecordWriter out(kTest);
  out.put(value);
  return out.take();
}

struct Archive {
  std::string bytes;
  std::uint64_t identity = 0;
};

Archive archive_of(const std::vector<std::uint64_t>& values) {
  io::StringSink sink;
  ArchiveWriter writer(sink);
  for (const std::uint64_t value : values) writer.append(record_of(value));
  Archive archive;
  archive.identity = writer.finish();
  archive.bytes = sink.take();
  return archive;
}

std::string written(const std::string& bytes) {
  const std::string path = ::testing::TempDir() + "tetloft_archive_" +
                           ::testing::UnitTest::GetInstance()->current_test_info()->name();
  std::ofstream(path, std::ios::binary) << bytes;
  return path;
}

TEST(Archive, RecordsReadBackInAnyOrder) {
  const Archive archive = archive_of({3, 1, 4, 1, 5});
  const auto reader = ArchiveReader::open(written(archive.bytes));
  ASSERT_TRUE(reader.ok()) << to_string(reader.error());
  EXPECT_EQ(reader->identity(), archive.identity);
  ASSERT_EQ(reader->size(), 5U);
  for (const std::size_t k : std::vector<std::size_t>{4, 0, 2, 3, 1}) {
    const std::string bytes = reader->record(k).value();
    RecordReader in(bytes, kTest, "name");
    EXPECT_EQ(in.get<std::uint64_t>(), (std::vector<std::uint64_t>{3, 1, 4, 1, 5}[k]));
    EXPECT_TRUE(in.end().ok());
  }
}

TEST(Archive, OthersHaveAnotherIdentity) {
  const std::uint64_t identity = archive_of({1, 2, 3}).identity;
  EXPECT_EQ(archive_of({1, 2, 3}).identity, identity);
  EXPECT_NE(archive_of({1, 2, 4}).identity, identity);
  EXPECT_NE(archive_of({2, 1, 3}).identity, identity);
  EXPECT_NE(archive_of({1, 2}).identity, identity);
  EXPECT_NE(archive_of({}).identity, identity);
}

TEST(Archive, WhatIsCutOffOrNoneIsRefused) {
  const std::string bytes = archive_of({1, 2, 3}).bytes;
  for (std::size_t size = 0; size < bytes.size(); ++size) {
    const auto reader = ArchiveReader::open(written(bytes.substr(0, size)));
    ASSERT_FALSE(reader.ok()) << size;
    EXPECT_EQ(reader.error().code, ErrorCode::invalid_input);
  }
  EXPECT_FALSE(ArchiveReader::open(written(bytes + "x")).ok());
  EXPECT_FALSE(ArchiveReader::open(written("x" + bytes)).ok());
  const auto none = ArchiveReader::open(::testing::TempDir() + "tetloft_no_such_archive");
  ASSERT_FALSE(none.ok());
  EXPECT_EQ(none.error().code, ErrorCode::io);
}

TEST(Archive, ADamagedTableIsRefused) {
  const Archive archive = archive_of({1, 2, 3});
  const std::size_t records = 3 * record_of(1).size();
  for (std::size_t at = records; at < archive.bytes.size(); ++at) {
    std::string damaged = archive.bytes;
    damaged[at] = static_cast<char>(damaged[at] ^ 1);
    EXPECT_FALSE(ArchiveReader::open(written(damaged)).ok()) << at;
  }
}

}  // namespace
}  // namespace tetloft::testing

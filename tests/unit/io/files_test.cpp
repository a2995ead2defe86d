// Files that appear complete or not at all.
#include "io/files.hpp"

#include <gtest/gtest.h>
#include <signal.h>
#include <sys/resource.h>
#include <unistd.h>

#include <filesystem>

#include <tetloft/io.hpp>

#include "io/pending_file.hpp"
#include "io/stage.hpp"
#include "unit/io/io_support.hpp"

namespace tetloft::io {
namespace {

namespace fs = std::filesystem;
using test::TempFolder;

TEST(WriteFile, ReplacesWhatWasThere) {
  TempFolder folder;
  const std::string path = folder.file("a");
  ASSERT_TRUE(write_file(path, "old and longer").ok());
  ASSERT_TRUE(write_file(path, std::string("new\0\r\n", 6)).ok());
  EXPECT_EQ(test::get(path), std::string("new\0\r\n", 6));
  EXPECT_EQ(folder.names().size(), 1U);
}

TEST(WriteFile, TellsWhatCannotBeWritten) {
  TempFolder folder;
  test::put(folder.file("plain"), "x");
  fs::create_directory(folder.file("folder"));
  for (const std::string& path :
       {folder.file("none/a"), folder.file("plain/a"), folder.file("folder"), std::string()}) {
    const auto written = write_file(path, "text");
    ASSERT_FALSE(written.ok()) << path;
    EXPECT_EQ(written.error().code, ErrorCode::io) << path;
    EXPECT_EQ(written.error().where.file, path);
    EXPECT_FALSE(written.error().message.empty());
  }
  EXPECT_EQ(folder.names().size(), 2U);
  EXPECT_EQ(test::get(folder.file("plain")), "x");
}

TEST(WriteFile, RespectsAFolderThatTakesNoFiles) {
  if (geteuid() == 0) GTEST_SKIP() << "root may write anywhere";
  TempFolder folder;
  fs::create_directory(folder.file("closed"));
  fs::permissions(folder.file("closed"), fs::perms::owner_read | fs::perms::owner_exec);
  EXPECT_EQ(write_file(folder.file("closed/a"), "x").error().code, ErrorCode::io);
  fs::permissions(folder.file("closed"), fs::perms::owner_all);
}

class Waits : public ::testing::TestWithParam<Waiting> {};

INSTANTIATE_TEST_SUITE_P(PendingFile, Waits, ::testing::Values(Waiting::unnamed, Waiting::named));

TEST_P(Waits, ReplacesAFileAndMakesANewOne) {
  TempFolder folder;
  test::put(folder.file("a"), "old");
  for (const char* name : {"a", "b"}) {
    PendingFile file(folder.file(name), nullptr, GetParam());
    file.append("new");
    ASSERT_TRUE(file.finish().ok());
    EXPECT_EQ(test::get(folder.file("a")), name[0] == 'a' ? "old" : "new");
    ASSERT_TRUE(file.commit().ok());
    EXPECT_EQ(test::get(folder.file(name)), "new");
  }
  EXPECT_EQ(folder.names(), (std::vector<std::string>{"a", "b"}));
}

TEST(PendingFile, LeavesTheOldFileWholeWhenTheRenameFails) {
  TempFolder folder;
  const std::string path = folder.file("a");
  test::put(path, "old");
  PendingFile file(path, nullptr, Waiting::named);
  file.append("new");
  for (const std::string& name : folder.names()) {
    if (name != "a") fs::remove(folder.file(name));
  }
  EXPECT_EQ(file.commit().error().code, ErrorCode::io);
  EXPECT_EQ(test::get(path), "old");
  EXPECT_EQ(folder.names().size(), 1U);
}

TEST_P(Waits, LeavesNothingWhereAFolderHasTakenThePlace) {
  TempFolder folder;
  PendingFile file(folder.file("a"), nullptr, GetParam());
  file.append("new");
  fs::create_directory(folder.file("a"));
  EXPECT_EQ(file.commit().error().code, ErrorCode::io);
  EXPECT_EQ(folder.names().size(), 1U);
}

TEST(PendingFile, LeavesNothingWithoutCommit) {
  TempFolder folder;
  {
    PendingFile file(folder.file("a"));
    file.append("new");
  }
  EXPECT_TRUE(folder.names().empty());
}

TEST(PendingFile, DoesNotTouchATemporaryOfAnother) {
  TempFolder folder;
  const std::string path = folder.file("a");
  PendingFile first(path);
  PendingFile second(path);
  first.append("first");
  second.append("second");
  ASSERT_TRUE(first.commit().ok());
  EXPECT_EQ(test::get(path), "first");
  ASSERT_TRUE(second.commit().ok());
  EXPECT_EQ(test::get(path), "second");
  EXPECT_EQ(folder.names().size(), 1U);
}

TEST(PendingFile, LeavesTheOldFileWholeWhenTheDiskIsFull) {
  TempFolder folder;
  const std::string path = folder.file("a");
  test::put(path, "old");
  // A limit on the size of files stands for a full disk.
  rlimit before{};
  ASSERT_EQ(getrlimit(RLIMIT_FSIZE, &before), 0);
  const auto handler = signal(SIGXFSZ, SIG_IGN);
  const rlimit tight{1 << 16, before.rlim_max};
  ASSERT_EQ(setrlimit(RLIMIT_FSIZE, &tight), 0);
  const auto written = write_file(path, std::string(std::size_t{1} << 20, 'x'));
  setrlimit(RLIMIT_FSIZE, &before);
  signal(SIGXFSZ, handler);
  EXPECT_EQ(written.error().code, ErrorCode::io);
  EXPECT_EQ(test::get(path), "old");
  EXPECT_EQ(folder.names().size(), 1U);
}

TEST(PendingFile, FollowsSymbolicLinks) {
  TempFolder folder;
  test::put(folder.file("target"), "old");
  fs::create_symlink("target", folder.file("link"));
  ASSERT_TRUE(write_file(folder.file("link"), "new").ok());
  EXPECT_TRUE(fs::is_symlink(folder.file("link")));
  EXPECT_EQ(test::get(folder.file("target")), "new");
}

TEST(ReadFile, ReadsAllBytes) {
  TempFolder folder;
  std::string bytes;
  for (unsigned i = 0; i < 3'000'000; ++i) bytes += static_cast<char>(i * i & 0xFFU);
  test::put(folder.file("a"), bytes);
  EXPECT_EQ(*read_file(folder.file("a")), bytes);
  test::put(folder.file("b"), "");
  EXPECT_EQ(*read_file(folder.file("b")), "");
}

TEST(ReadFile, TellsThatAFolderIsNoFile) {
  TempFolder folder;
  EXPECT_EQ(read_file(folder.file("")).error().code, ErrorCode::io);
}

TEST(ExtensionOf, IsLowerCaseAndOfTheLastPart) {
  EXPECT_EQ(extension_of("a.b/c.VTU"), ".vtu");
  EXPECT_EQ(extension_of("a.b/c"), "");
  EXPECT_EQ(extension_of("a.tar.stl"), ".stl");
  EXPECT_EQ(extension_of(""), "");
}

}  // namespace
}  // namespace tetloft::io

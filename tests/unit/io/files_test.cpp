// Files that appear complete or not at all.
#include "io/files.hpp"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

#include <filesystem>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include <tetloft/io.hpp>

#include "io/pending_file.hpp"
#include "io/stage.hpp"
#include "unit/io/io_support.hpp"

namespace tetloft::internal::io {
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

TEST(PendingFile, WritesThroughSymbolicLinksDanglingOnesToo) {
  for (const bool dangling : {false, true}) {
    for (const int links : {1, 2, 5, 39}) {
      TempFolder folder;
      fs::create_directory(folder.file("deep"));
      fs::create_directory_symlink("deep", folder.file("turn"));
      // Relative and absolute ones in turn, through a linked folder and up again.
      std::string target = "turn/../deep/target";
      for (int i = 0; i < links; ++i) {
        const std::string name = "link" + std::to_string(i);
        fs::create_symlink(target, folder.file(name));
        target = i % 2 == 0 ? folder.file(name) : name;
      }
      if (!dangling) test::put(folder.file("deep/target"), "old");
      const std::string last = folder.file("link" + std::to_string(links - 1));
      ASSERT_TRUE(write_file(last, "new").ok());
      EXPECT_TRUE(fs::is_symlink(last));
      EXPECT_TRUE(fs::is_regular_file(fs::symlink_status(folder.file("deep/target"))));
      EXPECT_EQ(test::get(folder.file("deep/target")), "new");
      EXPECT_EQ(folder.names().size(), 2U + static_cast<std::size_t>(links));
    }
  }
}

TEST(PendingFile, RefusesLinksThatLeadNowhere) {
  TempFolder folder;
  fs::create_symlink("b", folder.file("a"));
  fs::create_symlink("a", folder.file("b"));
  fs::create_symlink("self", folder.file("self"));
  fs::create_symlink("none/target", folder.file("astray"));
  const auto before = folder.names();
  for (const char* name : {"a", "b", "self", "astray"}) {
    const auto written = write_file(folder.file(name), "new");
    ASSERT_FALSE(written.ok()) << name;
    EXPECT_EQ(written.error().code, ErrorCode::io);
    EXPECT_EQ(written.error().where.file, folder.file(name));
    EXPECT_TRUE(fs::is_symlink(fs::symlink_status(folder.file(name))));
  }
  EXPECT_EQ(folder.names(), before);
}

TEST_P(Waits, KeepsThePermissionsOfTheEarlierFile) {
  const mode_t mask = umask(022);
  for (const unsigned mode : {0600U, 0640U, 0755U, 0666U, 0200U}) {
    TempFolder folder;
    const std::string path = folder.file("a");
    test::put(path, "old");
    fs::permissions(path, fs::perms{mode});
    PendingFile file(path, nullptr, GetParam());
    file.append("new");
    ASSERT_TRUE(file.commit().ok());
    EXPECT_EQ(fs::status(path).permissions(), fs::perms{mode});
    PendingFile fresh(folder.file("b"), nullptr, GetParam());
    ASSERT_TRUE(fresh.commit().ok());
    EXPECT_EQ(fs::status(folder.file("b")).permissions(), fs::perms{0644U});
  }
  umask(mask);
}

TEST(PendingFile, RespectsAFileThatMayNotBeWritten) {
  if (geteuid() == 0) GTEST_SKIP() << "root may write anything";
  TempFolder folder;
  test::put(folder.file("a"), "old");
  fs::permissions(folder.file("a"), fs::perms{0444U});
  EXPECT_EQ(write_file(folder.file("a"), "new").error().code, ErrorCode::io);
  EXPECT_EQ(test::get(folder.file("a")), "old");
}

TEST(PendingFile, WritesDevicesAndPipesDirectly) {
  TempFolder folder;
  EXPECT_TRUE(write_file("/dev/null", "gone").ok());
  EXPECT_FALSE(fs::is_regular_file("/dev/null"));
  fs::create_symlink("/dev/null", folder.file("link"));
  EXPECT_TRUE(write_file(folder.file("link"), "gone").ok());
  const auto full = write_file("/dev/full", "gone");
  ASSERT_FALSE(full.ok());
  EXPECT_EQ(full.error().code, ErrorCode::io);

  const std::string pipe = folder.file("pipe");
  ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
  const std::string bytes(300'000, 'x');
  std::thread writer([&] { EXPECT_TRUE(write_file(pipe, bytes).ok()); });
  EXPECT_EQ(test::get(pipe), bytes);
  writer.join();
  EXPECT_TRUE(fs::is_fifo(pipe));
  EXPECT_EQ(folder.names(), (std::vector<std::string>{"link", "pipe"}));
}

TEST(PendingFile, WritesWhatAnOpenFileStandsFor) {
  TempFolder folder;
  const std::string path = folder.file("a");
  const int open_file = open(path.c_str(), O_WRONLY | O_CREAT, 0600);
  ASSERT_GE(open_file, 0);
  ASSERT_EQ(write(open_file, "before ", 7), 7);
  ASSERT_TRUE(write_file("/dev/fd/" + std::to_string(open_file), "after").ok());
  close(open_file);
  EXPECT_EQ(test::get(path), "before after");
  EXPECT_EQ(folder.names().size(), 1U);
}

TEST(CommitAll, ShowsAllFilesOrNone) {
  for (std::size_t full = 0; full <= 3; ++full) {  // the file that cannot be written; 3: none
    TempFolder folder;
    test::put(folder.file("a"), "old");
    std::vector<PendingFile> files;
    const char* const names[] = {"a", "b", "c"};
    for (std::size_t i = 0; i < 3; ++i) {
      files.emplace_back(i == full ? "/dev/full" : folder.file(names[i]));
      files.back().append("new");
    }
    EXPECT_EQ(commit_all(files).ok(), full == 3);
    EXPECT_EQ(folder.names().size(), full == 3 ? 3U : 1U);
    EXPECT_EQ(test::get(folder.file("a")), full == 3 ? "new" : "old");
  }
}

TEST(CommitAll, RemovesWhatAppearedWhenALaterOneCannot) {
  TempFolder folder;
  std::vector<PendingFile> files;
  files.emplace_back(folder.file("a"));
  files.emplace_back(folder.file("b"));
  fs::create_directory(folder.file("b"));
  EXPECT_FALSE(commit_all(files).ok());
  EXPECT_EQ(folder.names(), std::vector<std::string>{"b"});
}

TEST(StagedWriters, ShowNothingBeforeTheyAreCommitted) {
  TempFolder folder;
  const Model model = test::hard_model();
  const LineSet lines{{{{{0, 0, 0}, {1, 0, 0}}}}, {}};
  std::vector<PendingFile> files;
  const auto keep = [&files](Result<Staged> staged) {
    ASSERT_TRUE(staged.ok());
    files.push_back(std::move(staged->files.front()));
  };
  keep(stage_model(folder.file("a.vtu"), model, {}));
  keep(stage_lines(folder.file("c.vtp"), lines, {}));
  keep(stage_file(folder.file("d"), "text"));
  keep(stage_surface(folder.file("e.ply"), model, {}));
  EXPECT_TRUE(folder.names().empty());
  ASSERT_TRUE(commit_all(files).ok());
  EXPECT_EQ(folder.names().size(), 4U);
  ASSERT_TRUE(write_vtu(folder.file("direct.vtu"), model).ok());
  EXPECT_EQ(test::get(folder.file("a.vtu")), test::get(folder.file("direct.vtu")));
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
}  // namespace tetloft::internal::io

// The collection of deliberately invalid stacks through the command line, where it is there.
#include <gtest/gtest.h>

#include <set>

#include "cli/runner.hpp"

namespace tetloft {
namespace {

using test::Outcome;
using test::run;
using test::TempFolder;

const std::set<std::string> kMended{"consecutive_dup", "repeated_last", "wrong_S_less",
                                    "wrong_S_more",    "wrong_v",       "huge_S",
                                    "huge_v"};

TEST(InvalidStacks, AreMendedWithAWarningOrRefusedWithoutOutput) {
  const std::filesystem::path data = std::filesystem::path(TETLOFT_SHARED_DATA_DIR) / "invalid";
  if (!std::filesystem::is_directory(data)) GTEST_SKIP() << "no collection of invalid stacks";
  for (const auto& entry : std::filesystem::directory_iterator(data)) {
    if (entry.path().extension() != ".cnt") continue;
    const std::string path = entry.path().string();
    TempFolder folder;
    const std::string out = folder.file("o.vtu");
    const Outcome outcome = run({"reconstruct", path, "-o", out});
    if (kMended.count(entry.path().stem().string()) == 1) {
      EXPECT_EQ(outcome.code, 0) << path << outcome.err;
      EXPECT_NE(outcome.err.find("warning: " + path + ':'), std::string::npos) << outcome.err;
      EXPECT_EQ(folder.names().size(), 1U) << path;
    } else {
      EXPECT_EQ(outcome.code, 3) << path << outcome.err;
      EXPECT_NE(outcome.err.find("error: " + path + ':'), std::string::npos) << outcome.err;
      EXPECT_TRUE(folder.names().empty()) << path;
    }
  }
}

}  // namespace
}  // namespace tetloft

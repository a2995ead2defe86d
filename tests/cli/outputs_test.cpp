// Results that do not reach their reader, files that cannot be written, names of all bytes.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <vector>

#include "cli/runner.hpp"

namespace tetloft {
namespace {

using test::run;
using test::run_json;

class Outputs : public ::testing::Test {
 protected:
  Outputs() {
    test::put(in_, test::kFork);
    test::put(points_, "0 0 0\n1 0 0\n0 1 0\n0 0 1\n");
    EXPECT_EQ(run({"reconstruct", in_, "-o", model_, "--quiet"}).code, 0);
    EXPECT_EQ(run({"plan", in_, "-o", plan_, "--quiet"}).code, 0);
    EXPECT_EQ(run(with({"-o", piece_, "--quiet"})).code, 0);
  }

  // A piece that is all of the stack.
  [[nodiscard]] std::vector<std::string> with(const std::vector<std::string>& more) const {
    std::vector<std::string> words{"reconstruct", in_, "--plan", plan_, "--slabs", "0:1"};
    words.insert(words.end(), more.begin(), more.end());
    return words;
  }

  // Every command that writes files, with the files it writes.
  struct Writer {
    std::vector<std::string> words, files;
  };
  std::vector<Writer> writers() {
    const std::string solid = folder_.file("o.vtu"), surface = folder_.file("s.ply");
    const std::string lines = folder_.file("o.vtp"), page = folder_.file("o.html");
    return {{{"reconstruct", in_, "-o", solid}, {solid}},
            {{"reconstruct", in_, "--surface", surface}, {surface}},
            {{"reconstruct", in_, "-o", solid, "--surface", surface}, {solid, surface}},
            {{"reconstruct", in_, "-o", solid, "--surface", surface, "--method", "geiger"},
             {solid, surface}},
            {{"delaunay", points_, "-o", solid}, {solid}},
            {{"links", in_, "-o", folder_.file("o.labels")}, {folder_.file("o.labels")}},
            {{"between", in_, "-o", folder_.file("o.cnt")}, {folder_.file("o.cnt")}},
            {{"between", in_, "-o", folder_.file("o.cnt"), "--labels-out", folder_.file("o.txt")},
             {folder_.file("o.cnt"), folder_.file("o.txt")}},
            {{"plan", in_, "-o", folder_.file("o.plan")}, {folder_.file("o.plan")}},
            {with({"-o", solid}), {solid}},
            {{"join", piece_, "-o", solid, "--surface", surface}, {solid, surface}},
            {{"skeleton", in_, "-o", lines}, {lines}},
            {{"render", model_, "-o", page}, {page}}};
  }

  // The exit code, with these redirections of the shell.
  static int run_redirected(const std::vector<std::string>& words, const std::string& how) {
    std::string command = std::string("'") + TETLOFT_EXECUTABLE + '\'';
    for (const std::string& word : words) command += " '" + word + '\'';
    const int status = std::system((command + ' ' + how).c_str());
    return status / 256;
  }

  test::TempFolder folder_;
  std::string in_ = folder_.file("in.cnt");
  std::string points_ = folder_.file("points.txt");
  std::string model_ = folder_.file("model.vtu");
  std::string plan_ = folder_.file("in.plan");
  std::string piece_ = folder_.file("piece.vtu");
};

TEST_F(Outputs, AppearOnlyWhereTheResultReachedItsReader) {
  for (const Writer& writer : writers()) {
    for (const std::string old : {"", "old"}) {
      for (const char* how : {">/dev/full 2>/dev/null", ">&- 2>/dev/null", ">&- 2>&-"}) {
        for (const std::string& file : writer.files) {
          std::filesystem::remove(file);
          if (!old.empty()) test::put(file, old);
        }
        const std::size_t before = folder_.names().size();
        std::vector<std::string> words = writer.words;
        if (old.empty()) words.emplace_back("--json");
        EXPECT_EQ(run_redirected(words, how), 4) << words.front() << ' ' << how;
        EXPECT_EQ(folder_.names().size(), before) << words.front() << ' ' << how;
        for (const std::string& file : writer.files) {
          EXPECT_EQ(std::filesystem::exists(file) ? test::get(file) : "", old);
        }
      }
    }
  }
}

TEST_F(Outputs, AppearWholeWhereOnlyMessagesAreLost) {
  for (const Writer& writer : writers()) {
    EXPECT_EQ(run(writer.words).code, 0);
    std::vector<std::string> expected;
    for (const std::string& file : writer.files) expected.push_back(test::get(file));
    for (const char* how : {">/dev/null 2>&-", ">/dev/null 2>/dev/full", "--quiet >&- 2>&- <&-",
                            "--quiet >/dev/full"}) {
      for (const std::string& file : writer.files) std::filesystem::remove(file);
      EXPECT_EQ(run_redirected(writer.words, how), 0) << writer.words.front() << ' ' << how;
      for (std::size_t i = 0; i < expected.size(); ++i) {
        EXPECT_EQ(test::get(writer.files[i]), expected[i]) << how;
      }
    }
  }
}

TEST_F(Outputs, OfOneCommandAppearTogether) {
  // The folder of the second takes no new file; it is the solid, then the surface.
  const std::string here = folder_.file("o.vtu"), surface = folder_.file("s.ply");
  std::filesystem::create_directory(folder_.file("loop"));
  const std::string lost = folder_.file("loop/s.ply"), lost_solid = folder_.file("loop/o.vtu");
  std::filesystem::create_symlink(folder_.file("none/s.ply"), lost);
  std::filesystem::create_symlink(folder_.file("none/o.vtu"), lost_solid);
  for (const char* method : {"nonato", "geiger"}) {
    EXPECT_EQ(run({"reconstruct", in_, "-o", here, "--surface", lost, "--method", method}).code, 4);
    EXPECT_FALSE(std::filesystem::exists(here));
    EXPECT_EQ(
        run({"reconstruct", in_, "-o", lost_solid, "--surface", surface, "--method", method}).code,
        4);
    EXPECT_FALSE(std::filesystem::exists(surface));
  }
}

bool is_plain(const std::string& text) {
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    if ((byte < 0x20 && c != '\n') || byte >= 0x7F) return false;
  }
  return true;
}

TEST_F(Outputs, ShowNoByteOfANameThatCouldLeadATerminalAstray) {
  constexpr int kBytes = 16;  // to a name: all 255 in few runs
  for (int first = 0; first < 256; first += kBytes) {
    std::string bytes = "a\x1b[31m";
    for (int byte = first; byte < first + kBytes; ++byte) {
      if (byte != 0 && byte != '/') bytes += static_cast<char>(byte);
    }
    const std::string name = folder_.file(bytes);
    const test::Outcome missing = run({"info", name + ".cnt"});
    EXPECT_EQ(missing.code, 4) << first;
    EXPECT_TRUE(is_plain(missing.err)) << first;
    EXPECT_EQ(missing.err.find('\n') + 1, missing.err.size()) << first;
    const test::Outcome made = run({"delaunay", points_, "-o", name + ".vtu"});
    EXPECT_EQ(made.code, 0) << first;
    EXPECT_TRUE(is_plain(made.out)) << first;
    EXPECT_EQ(std::count(made.out.begin(), made.out.end(), '\n'), 2) << first;
    const test::Outcome json = run({"info", name, "--json"});
    EXPECT_TRUE(is_plain(json.out)) << first;
    EXPECT_TRUE(test::parse_json(json.out).has_value()) << json.out;
  }
}

TEST_F(Outputs, OfAnyTitleAreValidPages) {
  for (int byte = 0x80; byte < 256; byte += 16) {
    const std::string page = folder_.file("p.html");
    const std::string title = std::string("a") + static_cast<char>(byte) + "\x01z";
    ASSERT_EQ(run({"render", model_, "-o", page, "--title", title, "--quiet"}).code, 0);
    const std::string text = test::get(page);
    EXPECT_NE(text.find("<title>a\xEF\xBF\xBD\xEF\xBF\xBDz</title>"), std::string::npos) << byte;
    EXPECT_EQ(text.find(title), std::string::npos);
  }
}

TEST_F(Outputs, SumUpWarningsOfAKind) {
  std::string stack = "S 2\n";
  for (const char* z : {"0", "1"}) {
    stack += std::string("v 1000 z ") + z + "\n";  // a wrong count: another kind
    for (int c = 0; c < 20; ++c) {
      const std::string x = std::to_string(3 * c), y = std::to_string(3 * c + 1);
      stack += "{ " + x + " 0 " + y + " 0 " + y + " 1 " + x + " 1 " + x + " 0 }\n";
    }
  }
  test::put(in_, stack);
  const test::Outcome plain = run({"info", in_});
  EXPECT_EQ(plain.code, 0);
  const std::string repeated = "first vertex repeated at the end removed";
  std::size_t told = 0;
  for (std::size_t at = plain.err.find(repeated); at != std::string::npos;
       at = plain.err.find(repeated, at + 1)) {
    ++told;
  }
  EXPECT_EQ(told, 4U) << plain.err;
  EXPECT_NE(plain.err.find("… and 37 more of this kind"), std::string::npos) << plain.err;
  EXPECT_NE(plain.err.find("announces 1000 vertices"), std::string::npos) << plain.err;
  EXPECT_EQ(run_json({"info", in_}).at("warnings").array.size(), 42U);
}

}  // namespace
}  // namespace tetloft

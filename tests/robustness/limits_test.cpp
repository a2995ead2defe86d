// The program within limits of the system: little address space, little stack. It ends with a
// result or an error that the README knows, never by a signal.
#include <gtest/gtest.h>
#include <sys/wait.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <string>
#include <vector>

#include <tetloft/tetloft.hpp>

#include "robustness/inputs.hpp"
#include "unit/io/io_support.hpp"

namespace tetloft::test {
namespace {

// The exit code of tetloft under `limit`, a word of the shell's ulimit; −1 after a signal.
int run_within(const std::string& limit, const std::string& words) {
  const std::string line =
      "ulimit " + limit + "; exec '" TETLOFT_PROGRAM "' " + words + " --quiet > /dev/null 2>&1";
  const int status = std::system(line.c_str());
  return WIFEXITED(status) && WEXITSTATUS(status) < 126 ? WEXITSTATUS(status) : -1;
}

TEST(Limits, OfAddressSpaceAreErrorsAtWorst) {
  const TempFolder folder;
  const std::string model = folder.file("bifurcation.vtu");
  int least = 0;
  for (const unsigned threads : {1U, 16U}) {
    for (const int kilobytes : {17'000, 30'000, 100'000, 400'000}) {
      std::remove(model.c_str());
      const int code = run_within("-v " + std::to_string(kilobytes),
                                  "reconstruct '" TETLOFT_DATA_DIR "/bifurcation.cnt' -o '" +
                                      model + "' --threads " + std::to_string(threads));
      EXPECT_TRUE(code == 0 || code == 71) << code << " with " << kilobytes << " kB";
      // Enough for one thread is enough for as many as are asked for.
      if (kilobytes >= 100'000) {
        EXPECT_EQ(code, 0) << threads << " threads, " << kilobytes << " kB";
      }
      EXPECT_EQ(folder.names().empty(), code != 0) << kilobytes;
      least += code == 0 ? 1 : 0;
    }
  }
  EXPECT_GT(least, 0);
  ASSERT_EQ(run_within("-v unlimited",
                       "reconstruct '" TETLOFT_DATA_DIR "/bifurcation.cnt' -o '" + model + "'"),
            0);
  for (const int kilobytes : {16'000, 26'000}) {
    const std::string limit = "-v " + std::to_string(kilobytes);
    for (const std::string& words :
         {"check '" + model + "' '" TETLOFT_DATA_DIR "/bifurcation.cnt'",
          "render '" + model + "' -o '" + folder.file("a.png") + "' --size 200x200"}) {
      const int code = run_within(limit, words);
      EXPECT_TRUE(code == 0 || code == 71 || code == 4) << code << ": " << limit << ' ' << words;
    }
  }
}

std::vector<Point2> spiral(std::size_t turns) {
  std::vector<Point2> out, in;
  for (std::size_t i = 0; i < 30 * turns; ++i) {
    const double angle = 0.2 * static_cast<double>(i);
    out.push_back({(angle + 2) * std::cos(angle), (angle + 2) * std::sin(angle)});
    in.push_back({angle * std::cos(angle) + 1e-3, angle * std::sin(angle)});
  }
  std::reverse(in.begin(), in.end());
  out.insert(out.end(), in.begin(), in.end());
  return out;
}

void put_stack(const std::string& path, const std::vector<Contour>& contours, int sections) {
  SectionStack stack;
  for (int s = 0; s < sections; ++s) {
    stack.sections.push_back({static_cast<double>(s), IdVector<ContourId, Contour>(contours)});
  }
  ASSERT_TRUE(write_cnt(path, stack));
}

// No recursion may go as deep as the input does.
TEST(Limits, OfTheStackAreNotReachedByDeepInput) {
  const TempFolder folder;
  std::vector<Contour> nested;
  for (int k = 10'000; k > 0; --k) {
    const double r = k;
    nested.push_back({{{-r, -r}, {r, -r}, {r, r}, {-r, r}}});
  }
  const std::string deep = folder.file("deep.cnt");
  put_stack(deep, nested, 1);
  nested.erase(nested.begin(), nested.end() - 300);
  const std::string less_deep = folder.file("less_deep.cnt");
  put_stack(less_deep, nested, 2);
  const std::string winding = folder.file("winding.cnt");
  put_stack(winding, {{spiral(12)}}, 2);
  const std::string xml = folder.file("xml.vtu");
  {
    std::ofstream file(xml);
    file << "<VTKFile type=\"UnstructuredGrid\">";
    for (int k = 0; k < 100'000; ++k) file << "<a>";
  }
  const std::string limit = "-s 256";
  const std::string out = folder.file("out.vtu");
  const std::string page = folder.file("out.html");
  EXPECT_EQ(run_within(limit, "info '" + deep + "'"), 0);
  EXPECT_EQ(run_within(limit, "check '" + xml + "' '" + deep + "'"), 3);
  for (const std::string& stack : {less_deep, winding}) {
    EXPECT_EQ(run_within(limit, "reconstruct '" + stack + "' -o '" + out + "' --threads 1"), 0);
    EXPECT_EQ(run_within(limit, "check '" + out + "' '" + stack + "'"), 0);
    EXPECT_EQ(run_within(limit, "render '" + out + "' -o '" + page + "'"), 0);
  }
}

}  // namespace
}  // namespace tetloft::test

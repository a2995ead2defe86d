// Plans and pieces made by the executable.
#pragma once

#include <gtest/gtest.h>

#include <cstddef>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include <tetloft/tetloft.hpp>

#include "cli/runner.hpp"

namespace tetloft::test {

using Words = std::vector<std::string>;
using Cuts = std::vector<std::size_t>;  // where pieces begin, and the end

inline std::string data(const std::string& name) {
  return std::string(TETLOFT_DATA_DIR) + '/' + name;
}

inline Words with(Words words, const Words& more) {
  words.insert(words.end(), more.begin(), more.end());
  return words;
}

class PiecesCommand : public ::testing::Test {
 protected:
  void make_plan(const std::string& stack, const Words& options = {}) {
    stack_ = stack;
    options_ = options;
    const Outcome made = run(with({"plan", stack, "-o", plan_, "--quiet"}, options));
    ASSERT_EQ(made.code, 0) << made.err;
  }

  [[nodiscard]] std::string piece(std::size_t k) const {
    return folder_.file("piece" + std::to_string(k) + ".vtu");
  }

  // The pieces, the last one first.
  Words make_pieces(const Cuts& cuts, const Words& options = {}) {
    Words paths;
    for (std::size_t k = 0; k + 1 < cuts.size(); ++k) {
      const std::string slabs = std::to_string(cuts[k]) + ':' + std::to_string(cuts[k + 1]);
      const Outcome made = run(with(
          {"reconstruct", stack_, "--plan", plan_, "--slabs", slabs, "-o", piece(k), "--quiet"},
          options));
      EXPECT_EQ(made.code, 0) << slabs << ' ' << made.err;
      paths.insert(paths.begin(), piece(k));
    }
    return paths;
  }

  void expect_joined(const Cuts& cuts, const std::string& extension, const Words& how = {},
                     const Words& of_pieces = {}) {
    const std::string whole = folder_.file("whole." + extension);
    const std::string joined = folder_.file("joined." + extension);
    ASSERT_EQ(run(with(with({"reconstruct", stack_, "-o", whole, "--quiet"}, options_), how)).code,
              0);
    const Outcome made = run(with(with({"join", "-o", joined, "--plan", plan_, "--quiet"}, how),
                                  make_pieces(cuts, of_pieces)));
    ASSERT_EQ(made.code, 0) << made.err;
    EXPECT_TRUE(get(whole) == get(joined)) << stack_ << ' ' << extension;
    std::filesystem::remove(joined);
  }

  TempFolder folder_;
  std::string stack_;
  std::string plan_ = folder_.file("stack.plan");
  Words options_;
};

// Slabs of it need finer contours in sections that they share with others.
class OpenSlabs : public PiecesCommand {
 protected:
  OpenSlabs() {
    const auto slab = read_stack(data("cases/shielded.cnt"));
    SectionStack stack;
    const auto add = [&](double z, Section section) {
      section.z = z;
      stack.sections.push_back(std::move(section));
    };
    Section plate;
    plate.contours.push_back({{{-1000, 0}, {-800, 0}, {-800, 100}, {-1000, 100}}});
    for (double z = -4; z < 0; ++z) add(z, plate);
    add(0, slab->stack.sections[SectionId(0)]);
    add(1, slab->stack.sections[SectionId(1)]);
    for (double z = 2; z < 6; ++z) add(z, plate);
    EXPECT_TRUE(write_stack(folder_.file("open.cnt"), stack).ok());
    put(folder_.file("open.labels"), "4 0 1\n4 1 3\n5 0 1\n5 1 2\n");
    make_plan(folder_.file("open.cnt"), {"--no-divide", "--correspondence", "overlap", "--labels",
                                         folder_.file("open.labels")});
  }
};

}  // namespace tetloft::test

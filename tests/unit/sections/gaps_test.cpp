// Planes suspiciously near to each other.
#include <gtest/gtest.h>

#include <vector>

#include <tetloft/sections.hpp>

namespace tetloft {
namespace {

SectionStack at(const std::vector<double>& heights, std::size_t empty = 1000) {
  SectionStack stack;
  for (const double z : heights) {
    Section section{z, {}};
    if (stack.sections.size() != empty) {
      section.contours.push_back({{{0, 0}, {1, 0}, {0, 1}}});
    }
    stack.sections.push_back(std::move(section));
  }
  return stack;
}

// The upper sections that are named.
std::vector<std::size_t> told(const SectionStack& stack) {
  std::vector<std::size_t> sections;
  for (const Warning& warning : suspicious_gaps(stack)) {
    EXPECT_NE(warning.message.find("one slice written as two planes"), std::string::npos);
    EXPECT_TRUE(is_of_gap(warning));
    EXPECT_FALSE(is_of_gap({warning.message + '.', {}}));
    sections.push_back(*warning.where.section);
  }
  return sections;
}

using Sections = std::vector<std::size_t>;

TEST(SuspiciousGaps, AreToldWhereverTheyLie) {
  for (std::size_t split = 0; split < 6; ++split) {
    for (const double gap : {1e-3, 1e-6, 1e-300}) {
      std::vector<double> heights{0, 1, 2, 3, 4, 5};
      // At zero, where a double that near exists.
      for (double& z : heights) z -= static_cast<double>(split);
      heights.insert(heights.begin() + static_cast<std::ptrdiff_t>(split) + 1, gap * 0.99);
      EXPECT_EQ(told(at(heights)), Sections{split + 1}) << split << ' ' << gap;
    }
  }
}

TEST(SuspiciousGaps, AreToldWhereAllSlicesAreDoubled) {
  std::vector<double> heights;
  Sections upper;
  for (int i = 0; i < 5; ++i) {
    heights.push_back(i);
    heights.push_back(i + 1e-4);
    upper.push_back(heights.size() - 1);
  }
  EXPECT_EQ(told(at(heights)), upper);
}

TEST(SuspiciousGaps, AreToldWhereASliceIsThreePlanes) {
  EXPECT_EQ(told(at({0, 1, 1.0001, 1.0002, 2})), (Sections{2, 3}));
}

TEST(SuspiciousGaps, AreNoneInHonestStacks) {
  EXPECT_TRUE(told(at({})).empty());
  EXPECT_TRUE(told(at({0})).empty());
  EXPECT_TRUE(told(at({0, 1e-9})).empty());
  EXPECT_TRUE(told(at({0, 1, 1.002, 2})).empty());
  EXPECT_TRUE(told(at({0, 0.001, 0.002, 0.003, 10, 20})).empty());  // a finer sampling
  EXPECT_TRUE(told(at({0, 1, 3, 9, 27, 81, 243, 729})).empty());
  EXPECT_TRUE(told(at({0, 1, 1.0001, 2}, 2)).empty());  // a cap
  EXPECT_TRUE(told(at({0, 1, 1.0001, 2}, 1)).empty());
  EXPECT_TRUE(told(at({0, 1, 1, 2})).empty());  // for validate()
  EXPECT_TRUE(told(at({0, 3, 2, 1})).empty());
}

}  // namespace
}  // namespace tetloft

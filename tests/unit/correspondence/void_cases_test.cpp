// Small stacks about voids, and larger ones where they are at hand: how many cavities are due.
#include <gtest/gtest.h>

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include <tetloft/io.hpp>

#include "support/slabs/cases.hpp"
#include "void_links_of.hpp"

namespace tetloft::testing {

namespace {

void expect_evidence(const std::string& name, Evidence evidence, std::size_t count) {
  std::size_t found = 0;
  for (const VoidLink& link : found_links(sample("cases/voids/" + name)).void_links) {
    if (link.fate == LinkFate::made && link.evidence == evidence) ++found;
  }
  EXPECT_EQ(found, count) << name;
}

TEST(VoidCases, HaveTheCavitiesDue) {
  for (const auto& [name, cavities] :
       std::vector<std::pair<const char*, std::size_t>>{{"bars", 0},
                                                        {"foreign_island", 0},
                                                        {"hole_at_border", 1},
                                                        {"holes_edge", 2},
                                                        {"holes_leak_30", 1},
                                                        {"holes_wm4_20", 2},
                                                        {"label_island_1", 0},
                                                        {"label_island_4", 0},
                                                        {"lid", 0},
                                                        {"oblique_tunnel", 0},
                                                        {"oblique_tunnel_touch", 0},
                                                        {"one_two", 2},
                                                        {"parallel_slits", 2},
                                                        {"rings_unlinked", 0},
                                                        {"slit_over_two", 1},
                                                        {"two_over_two", 1},
                                                        {"weak_holes", 1}}) {
    EXPECT_EQ(cavities_of(sample("cases/voids/" + std::string(name) + ".cnt")), cavities) << name;
  }
}

TEST(VoidCases, RestOnTheEvidenceDue) {
  expect_evidence("hole_at_border.cnt", Evidence::rim, 2);
  expect_evidence("oblique_tunnel.cnt", Evidence::chain, 6);
  expect_evidence("oblique_tunnel_touch.cnt", Evidence::chain, 6);
  expect_evidence("weak_holes.cnt", Evidence::overlap, 1);
  expect_evidence("two_over_two.cnt", Evidence::overlap, 4);
  expect_evidence("holes_edge.cnt", Evidence::overlap, 0);
}

TEST(VoidCases, SharedOnesToo) {
  const std::filesystem::path folder = std::filesystem::path(TETLOFT_SHARED_DATA_DIR) / "reported";
  if (!std::filesystem::exists(folder)) GTEST_SKIP() << "no shared data";
  // Blocks of 30 pores; tiny holes of which a third are pits.
  for (const auto& [name, cavities] :
       std::vector<std::pair<const char*, std::size_t>>{{"holes_pores_3_1", 30},
                                                        {"holes_pores_7_2", 30},
                                                        {"holes_specks", 180},
                                                        {"holes_wormhole", 2}}) {
    const auto read = read_cnt((folder / (std::string(name) + ".cnt")).string());
    ASSERT_TRUE(read.ok()) << to_string(read.error());
    EXPECT_EQ(cavities_of(read->stack), cavities) << name;
  }
}

}  // namespace
}  // namespace tetloft::testing

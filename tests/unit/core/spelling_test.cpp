// What was probably meant.
#include "core/spelling.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "core/prng.hpp"

namespace tetloft {

using namespace internal;
namespace {

const std::vector<std::string_view> kWords{"reconstruct", "check",  "delaunay",
                                           "skeleton",    "render", "info"};

TEST(EditDistance, OfKnownPairs) {
  EXPECT_EQ(edit_distance("", ""), 0U);
  EXPECT_EQ(edit_distance("", "abc"), 3U);
  EXPECT_EQ(edit_distance("kitten", "sitting"), 3U);
  EXPECT_EQ(edit_distance("redner", "render"), 1U);
  EXPECT_EQ(edit_distance("ca", "abc"), 3U);
}

TEST(EditDistance, IsSymmetricAndBoundedByTheEditsMade) {
  Prng prng(7);
  for (int k = 0; k < 2000; ++k) {
    std::string word;
    for (std::size_t i = 0; i < 8; ++i) word += static_cast<char>('a' + prng.below(4));
    std::string changed = word;
    const std::size_t edits = prng.below(4);
    for (std::size_t e = 0; e < edits; ++e) {
      const std::size_t at = prng.below(changed.size());
      switch (prng.below(3)) {
        case 0: changed.erase(at, 1); break;
        case 1: changed.insert(at, 1, 'x'); break;
        default: changed[at] = 'y';
      }
    }
    ASSERT_LE(edit_distance(word, changed), edits);
    ASSERT_EQ(edit_distance(word, changed), edit_distance(changed, word));
    ASSERT_EQ(edit_distance(word, changed) == 0, word == changed);
  }
}

// Every single slip in every word of five letters and more is seen through.
TEST(Closest, FindsAWordBehindOneSlip) {
  for (const std::string_view word : kWords) {
    if (word.size() < 5) continue;
    for (std::size_t i = 0; i < word.size(); ++i) {
      std::string dropped(word), doubled(word), wrong(word), swapped(word);
      dropped.erase(i, 1);
      doubled.insert(i, 1, word[i]);
      wrong[i] = 'q';
      if (i > 0) std::swap(swapped[i - 1], swapped[i]);
      for (const std::string& slip : {dropped, doubled, wrong, swapped}) {
        EXPECT_EQ(closest(slip, kWords), word) << slip;
      }
    }
  }
}

TEST(Closest, FindsBeginningsAndOtherCase) {
  EXPECT_EQ(closest("rec", kWords), "reconstruct");
  EXPECT_EQ(closest("Delaunay", kWords), "delaunay");
  EXPECT_EQ(closest("-surface", {"--snap", "--surface"}), "--surface");
  EXPECT_EQ(closest("--thread", {"--threads", "--thickness"}), "--threads");
}

TEST(Closest, KeepsSilentWhereNothingIsClose) {
  for (const char* word : {"", "-", "--", "frobnicate", "x", "c", "mesh", "in.cnt", "psychic"}) {
    EXPECT_EQ(closest(word, kWords), "") << word;
  }
  EXPECT_EQ(closest(std::string(100'000, 'r'), kWords), "");
  EXPECT_EQ(closest("--frobnicate", {"--ascii", "--repair"}), "");
  EXPECT_EQ(did_you_mean("frobnicate", kWords), "");
  EXPECT_EQ(did_you_mean("chek", kWords), " (did you mean check?)");
  EXPECT_EQ(list_of({"a", "b", "c"}), "a, b or c");
}

}  // namespace
}  // namespace tetloft

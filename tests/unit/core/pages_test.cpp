// Memory handed back and made page by page: what is around it stays, and it may be used again.
#include "core/pages.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace tetloft {

using namespace internal;
namespace {

constexpr std::size_t kItems = std::size_t{1} << 18;

std::vector<std::uint32_t> numbered() {
  std::vector<std::uint32_t> items(kItems);
  for (std::size_t i = 0; i < kItems; ++i) items[i] = static_cast<std::uint32_t>(i + 1);
  return items;
}

// From anywhere to anywhere, most of them in the middle of a page; and of less than a page.
TEST(Pages, GivenBackLeaveWhatIsAroundThem) {
  for (const std::size_t first : {std::size_t{0}, std::size_t{1}, std::size_t{16384}, kItems - 9}) {
    for (const std::size_t end : {first, first + 5, kItems / 2 + 77, kItems}) {
      if (end < first) continue;
      std::vector<std::uint32_t> items = numbered();
      core::give_back_pages(std::span(items).subspan(first, end - first));
      for (std::size_t i = 0; i < kItems; ++i) {
        const bool given = first <= i && i < end;
        ASSERT_TRUE(items[i] == i + 1 || (given && items[i] == 0)) << first << " " << end;
      }
      std::fill(items.begin(), items.end(), 7U);
      EXPECT_EQ(std::count(items.begin(), items.end(), 7U), std::ptrdiff_t{kItems});
    }
  }
}

TEST(Pages, MadeHoldWhatTheyHeld) {
  std::vector<std::uint32_t> items = numbered();
  core::make_pages(items.data() + 3, kItems - 5);
  EXPECT_EQ(items, numbered());
}

TEST(Pages, OfAReleasedVectorAreGone) {
  std::vector<std::uint32_t> items = numbered();
  core::release(items);
  EXPECT_EQ(items.capacity(), 0U);
}

}  // namespace
}  // namespace tetloft

// When sections are released: after the last of their slabs, whatever the order.
#include "reconstruct/section_uses.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <vector>

#include "core/parallel.hpp"

namespace tetloft::testing {

using namespace internal;
namespace {

TEST(SectionUses, EndWithTheLastSlabBeside) {
  SectionUses uses(6, {SlabId(3), SlabId(0), SlabId(2)});
  std::vector<SectionId> released;
  const auto release = [&](SectionId s) { released.push_back(s); };
  uses.done(SlabId(2), release);
  EXPECT_EQ(released, (std::vector<SectionId>{SectionId(2)}));
  uses.done(SlabId(0), release);
  EXPECT_EQ(released, (std::vector<SectionId>{SectionId(2), SectionId(0), SectionId(1)}));
  uses.done(SlabId(3), release);
  EXPECT_EQ(released, (std::vector<SectionId>{SectionId(2), SectionId(0), SectionId(1),
                                              SectionId(3), SectionId(4)}));
}

TEST(SectionUses, EndOnceWhereSlabsEndAtTheSameTime) {
  constexpr std::size_t kSlabs = 2000;
  std::vector<SlabId> slabs;
  for (std::size_t k = 0; k < kSlabs; ++k) slabs.emplace_back(k);
  SectionUses uses(kSlabs + 1, slabs);
  std::vector<std::atomic<int>> released(kSlabs + 1);
  parallel_for(kSlabs, 2, [&](std::size_t k) {
    uses.done(slabs[k], [&](SectionId s) { ++released[s.index()]; });
  });
  for (const std::atomic<int>& times : released) EXPECT_EQ(times, 1);
}

}  // namespace
}  // namespace tetloft::testing

// See shared_sort.hpp.
#include "delaunay3/shared_sort.hpp"

#include <algorithm>
#include <bit>
#include <utility>
#include <vector>

#include "core/parallel.hpp"
#include "delaunay3/stretches.hpp"

namespace tetloft::internal::delaunay3_detail {

namespace {

// Fewer are sorted before a second thread has started.
constexpr std::size_t kFewEntries = std::size_t{1} << 15;
constexpr std::size_t kEntriesOfStretch = std::size_t{1} << 14;
constexpr std::size_t kMostEntryStretches = 64;
// Ranges of keys. Most keys lie in few of them, as doubles in [0, 1) do by their bits.
constexpr unsigned kRangeBits = 12;
constexpr std::size_t kRanges = std::size_t{1} << kRangeBits;

struct KeyBounds {
  std::uint64_t least = ~std::uint64_t{0};
  std::uint64_t most = 0;
};

KeyBounds bounds_of(std::span<const Keyed> entries) {
  KeyBounds bounds;
  for (const Keyed& entry : entries) {
    bounds.least = std::min(bounds.least, entry.key);
    bounds.most = std::max(bounds.most, entry.key);
  }
  return bounds;
}

}  // namespace

void sort_by_key_shared(std::span<Keyed> entries, unsigned threads) {
  if (thread_count(threads) == 1 || entries.size() < kFewEntries) return sort_by_key(entries);
  const KeyBounds bounds = bounds_of(entries);
  const auto bits = static_cast<int>(std::bit_width(bounds.most - bounds.least));
  const int shift = std::max(bits - static_cast<int>(kRangeBits), 0);
  const auto range = [&](const Keyed& entry) { return (entry.key - bounds.least) >> shift; };
  const Stretches all = Stretches::of(entries.size(), kEntriesOfStretch, kMostEntryStretches);
  // [stretch * kRanges + range]: how many there are, then where the next goes.
  std::vector<std::uint32_t> place(all.count * kRanges);
  parallel_for(all.count, threads, [&](std::size_t k) {
    for (std::size_t i = all.begin(k); i < all.end(k); ++i)
      ++place[k * kRanges + range(entries[i])];
  });
  std::vector<std::uint32_t> begin(kRanges + 1);
  std::uint32_t sum = 0;
  for (std::size_t r = 0; r < kRanges; ++r) {
    begin[r] = sum;
    for (std::size_t k = 0; k < all.count; ++k) sum += std::exchange(place[k * kRanges + r], sum);
  }
  begin[kRanges] = sum;
  std::vector<Keyed> dealt(entries.size());
  parallel_for(all.count, threads, [&](std::size_t k) {
    for (std::size_t i = all.begin(k); i < all.end(k); ++i) {
      dealt[place[k * kRanges + range(entries[i])]++] = entries[i];
    }
  });
  // Ranges one after the other, about as many entries to each thread at a time.
  const Stretches bundles = Stretches::of(kRanges, 16, kRanges);
  parallel_for(bundles.count, threads, [&](std::size_t k) {
    for (std::size_t r = bundles.begin(k); r < bundles.end(k); ++r) {
      const std::span<Keyed> own = std::span(dealt).subspan(begin[r], begin[r + 1] - begin[r]);
      sort_by_key(own);
      std::copy(own.begin(), own.end(), entries.begin() + begin[r]);
    }
  });
}

}  // namespace tetloft::internal::delaunay3_detail

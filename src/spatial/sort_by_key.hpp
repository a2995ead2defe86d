// Sorting by 64-bit keys.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace tetloft::internal {

/// What is sorted: a key and what it stands for.
struct Keyed {
  std::uint64_t key;
  std::uint32_t place;
};

/// Sorts by key, then by place. Requires places in increasing order where keys are equal.
/// Few entries are compared; many are dealt out digit by digit, from the lowest (stable).
inline void sort_by_key(std::span<Keyed> entries) {
  constexpr std::size_t kFew = 2000;
  if (entries.size() < kFew) {
    std::sort(entries.begin(), entries.end(), [](const Keyed& a, const Keyed& b) {
      return a.key != b.key ? a.key < b.key : a.place < b.place;
    });
    return;
  }
  constexpr unsigned kBits = 11;
  constexpr unsigned kDigits = (64 + kBits - 1) / kBits;
  constexpr std::uint64_t kMask = (1U << kBits) - 1;
  std::vector<std::array<std::uint32_t, kMask + 1>> end(kDigits);
  for (const Keyed& entry : entries) {
    for (unsigned d = 0; d < kDigits; ++d) ++end[d][(entry.key >> (d * kBits)) & kMask];
  }
  std::vector<Keyed> buffer(entries.size());
  std::span<Keyed> from = entries;
  std::span<Keyed> to = buffer;
  for (unsigned d = 0; d < kDigits; ++d) {
    const auto digit = [&](const Keyed& entry) { return (entry.key >> (d * kBits)) & kMask; };
    if (end[d][digit(from.front())] == entries.size()) continue;  // all have the same
    std::uint32_t sum = 0;
    for (std::uint32_t& e : end[d]) {
      const std::uint32_t begin = sum;
      sum += e;
      e = begin;
    }
    for (const Keyed& entry : from) to[end[d][digit(entry)]++] = entry;
    std::swap(from, to);
  }
  if (from.data() != entries.data()) std::copy(from.begin(), from.end(), entries.begin());
}

}  // namespace tetloft::internal

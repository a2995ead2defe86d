// Sorting by 64-bit keys, and of points.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include <tetloft/point.hpp>

namespace tetloft::internal {

/// What is sorted: a key and what it stands for.
struct Keyed {
  std::uint64_t key;
  std::uint32_t place;
};

namespace sort_detail {

// So few are inserted one after the other.
inline constexpr std::size_t kFew = 16;
// As many buckets as entries, but no more than the nearest cache holds the counters of.
inline constexpr std::size_t kMostBuckets = 4096;

/// Inserts the entries of `from` into `to`, by key; may be the same.
inline void insert_sorted(std::span<const Keyed> from, std::span<Keyed> to) {
  for (std::size_t i = 0; i < from.size(); ++i) {
    const Keyed moved = from[i];
    std::size_t k = i;
    for (; k > 0 && moved.key < to[k - 1].key; --k) to[k] = to[k - 1];
    to[k] = moved;
  }
}

/// Deals the entries out to buckets over the range of their keys, and these in turn. Of more than
/// kFew, at least five bits of the 64 that keys may differ in are settled by each level, so there
/// are 14 at most.
inline void deal(std::span<Keyed> entries, std::span<Keyed> buffer) {
  std::uint64_t low = entries.front().key;
  std::uint64_t high = low;
  for (const Keyed& entry : entries) {
    low = std::min(low, entry.key);
    high = std::max(high, entry.key);
  }
  if (low == high) return;
  const auto bits = static_cast<int>(std::bit_width(std::min(entries.size(), kMostBuckets) - 1));
  const int shift = std::max(static_cast<int>(std::bit_width(high - low)) - bits, 0);
  const auto bucket = [&](const Keyed& entry) { return (entry.key - low) >> shift; };
  std::array<std::uint32_t, kMostBuckets> end;
  const auto ends = std::span(end).first(bucket({high, 0}) + 1);
  std::fill(ends.begin(), ends.end(), 0U);
  for (const Keyed& entry : entries) ++ends[bucket(entry)];
  std::uint32_t sum = 0;
  std::uint32_t most = 0;
  for (std::uint32_t& e : ends) {
    const std::uint32_t begin = sum;
    most = std::max(most, e);
    sum += e;
    e = begin;
  }
  for (const Keyed& entry : entries) buffer[ends[bucket(entry)]++] = entry;
  if (most <= kFew) {
    insert_sorted(buffer, entries);
    return;
  }
  std::uint32_t begin = 0;
  for (const std::uint32_t e : ends) {
    const std::span<Keyed> dealt = buffer.subspan(begin, e - begin);
    const std::span<Keyed> sorted = entries.subspan(begin, e - begin);
    begin = e;
    if (dealt.size() <= kFew) {
      insert_sorted(dealt, sorted);
    } else {
      std::copy(dealt.begin(), dealt.end(), sorted.begin());
      deal(sorted, dealt);
    }
  }
}

}  // namespace sort_detail

/// Sorts by key, and leaves entries of equal keys in their order. Linear, whatever the keys.
inline void sort_by_key(std::span<Keyed> entries) {
  if (entries.size() <= sort_detail::kFew) {
    sort_detail::insert_sorted(entries, entries);
    return;
  }
  std::vector<Keyed> buffer(entries.size());
  sort_detail::deal(entries, buffer);
}

/// The runs of equal keys in what is sorted by them, of `at_least` entries.
inline std::vector<std::span<Keyed>> equal_runs(std::span<Keyed> sorted, std::size_t at_least = 2) {
  std::vector<std::span<Keyed>> runs;
  for (std::size_t begin = 0, end = 0; begin < sorted.size(); begin = end) {
    while (end < sorted.size() && sorted[end].key == sorted[begin].key) ++end;
    if (end - begin >= at_least) runs.push_back(sorted.subspan(begin, end - begin));
  }
  return runs;
}

/// A key that orders doubles as they are ordered; the two zeros are one. Requires no NaN.
inline std::uint64_t key_of(double value) {
  const auto bits = std::bit_cast<std::uint64_t>(value + 0.0);
  constexpr std::uint64_t sign = std::uint64_t{1} << 63;
  return (bits & sign) != 0 ? ~bits : bits | sign;
}

/// Sorts canonically, by x and then y, the points point_of(place); leaves equal ones in their
/// order.
template <class PointOf>
void sort_canonically(std::span<Keyed> entries, const PointOf& point_of) {
  for (Keyed& entry : entries) entry.key = key_of(point_of(entry.place).x);
  sort_by_key(entries);
  for (const std::span<Keyed> run : equal_runs(entries)) {
    for (Keyed& entry : run) entry.key = key_of(point_of(entry.place).y);
    sort_by_key(run);
  }
}

}  // namespace tetloft::internal

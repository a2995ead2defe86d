// See canonical_names.hpp.
#include "delaunay3/canonical_names.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <functional>
#include <tuple>
#include <utility>

#include "core/pages.hpp"
#include "core/parallel.hpp"
#include "core/prefetch.hpp"
#include "core/sort_few.hpp"

namespace tetloft::internal::delaunay3_detail {

namespace {

// Long enough for threads to be worth starting, short enough to stay in cache while its slots are
// sorted by name.
constexpr std::size_t kSlotsOfStretch = std::size_t{1} << 15;
constexpr std::size_t kMostStretches = 1024;
// Of a group of ranks: the tets of one are sorted within cache.
constexpr std::size_t kTetsOfGroup = 4096;
constexpr std::size_t kMostGroups = 2048;
// Fewer are sorted by insertion: in a uniform set a vertex is the lowest of seven tets.
constexpr std::size_t kFewTets = 24;

// By the engine's places of the vertices of lowest, second, third and highest rank, two bits each
// from the lowest on: the canonical place of the engine's vertex k, at bits 2 k and 2 k + 1; and at
// bit 8, whether the last two ranks are swapped in canonical order, as the increasing order is an
// odd permutation of the engine's, whose tets are positive.
constexpr unsigned kSwapped = 1U << 8;

constexpr std::array<std::uint16_t, 256> canonical_places() {
  std::array<std::uint16_t, 256> result{};
  std::array<unsigned, 4> order{0, 1, 2, 3};
  do {
    unsigned code = 0;
    bool odd = false;
    for (unsigned i = 0; i < 4; ++i) {
      code |= order[i] << (2 * i);
      for (unsigned j = 0; j < i; ++j) odd = odd != (order[i] < order[j]);
    }
    unsigned places = odd ? kSwapped : 0;
    for (unsigned i = 0; i < 4; ++i) places |= (odd && i > 1 ? 5 - i : i) << (2 * order[i]);
    result[code] = static_cast<std::uint16_t>(places);
  } while (std::next_permutation(order.begin(), order.end()));
  return result;
}
constexpr std::array<std::uint16_t, 256> kCanonicalPlaces = canonical_places();

// Puts ranks into canonical order, and above them the places.
void order_vertices(TetVertices& tet, std::span<const std::uint32_t> rank_of) {
  // Rank and engine's place: sorts by rank, as ranks are distinct.
  std::array<std::uint32_t, 4> entry;
  for (std::uint32_t k = 0; k < 4; ++k) entry[k] = (rank_of[tet[k].index()] << 2) | k;
  const auto order = [&](std::size_t i, std::size_t j) {
    const std::uint32_t low = std::min(entry[i], entry[j]);
    entry[j] = std::max(entry[i], entry[j]);
    entry[i] = low;
  };
  // The optimal sorting network of four.
  order(0, 1);
  order(2, 3);
  order(0, 2);
  order(1, 3);
  order(1, 2);
  const std::uint32_t places = kCanonicalPlaces[(entry[0] & 3U) | (entry[1] & 3U) << 2 |
                                                (entry[2] & 3U) << 4 | (entry[3] & 3U) << 6];
  const bool swapped = (places & kSwapped) != 0;
  const auto put = [&](unsigned k, std::uint32_t ranked) {
    tet[k] = VertexId((ranked >> 2) | ((places >> (2 * k)) & 3U) << renamed::kRankBits);
  };
  put(0, entry[0]);
  put(1, entry[1]);
  put(2, swapped ? entry[3] : entry[2]);
  put(3, swapped ? entry[2] : entry[3]);
}

// A tet among those of one lowest rank: its other ranks, increasing.
struct UpperRanks {
  std::uint64_t second_and_third;
  std::uint32_t fourth;
  std::uint32_t slot;

  friend bool operator<(const UpperRanks& a, const UpperRanks& b) {
    return a.second_and_third != b.second_and_third ? a.second_and_third < b.second_and_third
                                                    : a.fourth < b.fourth;
  }
};

UpperRanks upper_ranks(const TetSlot& slot, std::uint32_t number) {
  const std::uint32_t third = renamed::rank(slot, 2);
  const std::uint32_t fourth = renamed::rank(slot, 3);
  return {(std::uint64_t{renamed::rank(slot, 1)} << 32) | std::min(third, fourth),
          std::max(third, fourth), number};
}

// Names the tets, group after group: group g has those whose lowest rank is g << shift_ or more.
class Naming {
 public:
  Naming(std::span<TetSlot> built, std::span<const std::uint32_t> rank_of, unsigned threads)
      : built_(built),
        rank_of_(rank_of),
        threads_(threads),
        stretches_(stretches_of(built)),
        begin_(rank_of.size() + 1) {
    const std::size_t wanted = std::clamp<std::size_t>(built.size() / kTetsOfGroup, 1, kMostGroups);
    while ((rank_of.size() >> shift_) >= wanted) ++shift_;
    groups_ = (rank_of.size() >> shift_) + 1;
    places_.resize(stretches_.count * groups_);
  }

  std::vector<std::uint32_t> run() {
    parallel_for(stretches_.count, threads_, [&](std::size_t k) { order_stretch(k); });
    place_groups();
    parallel_for(stretches_.count, threads_, [&](std::size_t k) { collect_stretch(k); });
    const Stretches bundles = Stretches::of(groups_, 8, groups_);
    parallel_for(bundles.count, threads_, [&](std::size_t k) {
      Scratch scratch;
      for (std::size_t g = bundles.begin(k); g < bundles.end(k); ++g) name_group(g, scratch);
    });
    begin_.back() = static_cast<std::uint32_t>(slots_.size());
    core::release(slots_);
    return std::move(begin_);
  }

 private:
  // Of one group, used again for the next.
  struct Scratch {
    std::vector<std::uint32_t> lowest;
    std::vector<UpperRanks> collected;
    std::vector<UpperRanks> sorted;
  };

  // Orders the vertices of each tet, and counts the tets of each group.
  void order_stretch(std::size_t k) {
    std::uint32_t* count = &places_[k * groups_];
    for (std::size_t t = stretches_.begin(k); t < stretches_.end(k); ++t) {
      TetVertices& tet = built_[t].vertices;
      if (t + kSlotsAhead < stretches_.end(k)) {
        for (const VertexId v : built_[t + kSlotsAhead].vertices)
          core::prefetch(rank_of_.data() + v.index());
      }
      if (tet[0].index() >= rank_of_.size()) continue;
      order_vertices(tet, rank_of_);
      ++count[(tet[0].value() & renamed::kRankMask) >> shift_];
    }
  }

  // From counts to where each stretch puts its tets: group after group.
  void place_groups() {
    std::uint32_t sum = 0;
    group_begin_.reserve(groups_ + 1);
    for (std::size_t g = 0; g < groups_; ++g) {
      group_begin_.push_back(sum);
      for (std::size_t k = 0; k < stretches_.count; ++k) {
        sum += std::exchange(places_[k * groups_ + g], sum);
      }
    }
    group_begin_.push_back(sum);
    slots_.resize(sum);
  }

  void collect_stretch(std::size_t k) {
    std::uint32_t* place = &places_[k * groups_];
    for (std::size_t t = stretches_.begin(k); t < stretches_.end(k); ++t) {
      if (!renamed::is_finite(built_[t])) continue;
      slots_[place[renamed::rank(built_[t], 0) >> shift_]++] = static_cast<std::uint32_t>(t);
    }
  }

  // Sorts the tets of a group by lowest rank, then those of each by the others.
  void name_group(std::size_t g, Scratch& scratch) {
    const std::uint32_t first = group_begin_[g];
    const std::size_t count = group_begin_[g + 1] - first;
    const std::size_t low = g << shift_;
    const std::size_t high = std::min(low + (std::size_t{1} << shift_), rank_of_.size());
    const auto slots = std::span<const std::uint32_t>(slots_).subspan(first, count);
    scratch.lowest.resize(count);
    scratch.collected.resize(count);
    scratch.sorted.resize(count);
    for (std::size_t i = 0; i < count; ++i) {
      if (i + kSlotsAhead < count) core::prefetch(&built_[slots[i + kSlotsAhead]]);
      const TetSlot& slot = built_[slots[i]];
      scratch.lowest[i] = renamed::rank(slot, 0);
      scratch.collected[i] = upper_ranks(slot, slots[i]);
      ++begin_[scratch.lowest[i]];
    }
    std::uint32_t sum = first;
    for (std::size_t r = low; r < high; ++r) sum = begin_[r] += sum;
    // Filling from the ends leaves every begin_[r] at its begin.
    for (std::size_t i = 0; i < count; ++i) {
      scratch.sorted[--begin_[scratch.lowest[i]] - first] = scratch.collected[i];
    }
    for (std::size_t r = low; r < high; ++r) {
      const std::uint32_t begin = begin_[r] - first;
      const std::uint32_t end =
          r + 1 < high ? begin_[r + 1] - first : static_cast<std::uint32_t>(count);
      sort_few(std::span(scratch.sorted).subspan(begin, end - begin), std::less<>(), kFewTets);
    }
    for (std::size_t i = 0; i < count; ++i) {
      VertexId& lowest = built_[scratch.sorted[i].slot].vertices[0];
      lowest = VertexId((lowest.value() & ~renamed::kRankMask) |
                        (first + static_cast<std::uint32_t>(i)));
    }
  }

  std::span<TetSlot> built_;
  std::span<const std::uint32_t> rank_of_;
  unsigned threads_;
  Stretches stretches_;
  unsigned shift_ = 0;
  std::size_t groups_ = 0;
  // [stretch k * groups_ + g]: how many tets of group g stretch k has, then where the next goes.
  std::vector<std::uint32_t> places_;
  std::vector<std::uint32_t> group_begin_;
  // The finite slots, by group.
  std::vector<std::uint32_t> slots_;
  std::vector<std::uint32_t> begin_;
};

}  // namespace

Stretches stretches_of(std::span<const TetSlot> built) {
  return Stretches::of(built.size(), kSlotsOfStretch, kMostStretches);
}

std::vector<std::uint32_t> name_tets(std::span<TetSlot> built,
                                     std::span<const std::uint32_t> rank_of, unsigned threads) {
  return Naming(built, rank_of, threads).run();
}

}  // namespace tetloft::internal::delaunay3_detail

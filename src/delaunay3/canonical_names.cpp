// See canonical_names.hpp.
//
// Tets are named vertex by vertex: each belongs to its vertex of lowest rank, in a list. The tets
// of a vertex are near each other in the engine's order, and so are those of the engine's next
// vertex, while those of the next rank are far away.
#include "delaunay3/canonical_names.hpp"

#include <algorithm>
#include <array>
#include <atomic>
#include <cstddef>
#include <utility>

#include "core/parallel.hpp"
#include "core/prefetch.hpp"
#include "delaunay3/stretches.hpp"

namespace tetloft::internal::delaunay3_detail {

namespace {

// Long enough for threads to be worth starting.
constexpr std::size_t kSlotsOrdered = std::size_t{1} << 15;
// So few that what is collected of their tets stays in cache.
constexpr std::size_t kVerticesNamed = 1024;
// So many slots before one is worked on it is fetched, or what it leads to.
constexpr std::size_t kNamedAhead = 16;
// Tets that are ordered before the first of them joins its list.
constexpr std::size_t kOrderedAtATime = 32;
// Fewer are sorted by counting: in a uniform set a vertex is the lowest of seven tets.
constexpr std::size_t kFewTets = 24;

// By which of the engine's vertices i < j come in order of rank, a bit each for the pairs 01, 02,
// 03, 12, 13, 23: CanonicalNames::places. These are in order of rank, but for the last two, swapped
// where that order is an odd permutation of the engine's, whose tets are positive.
constexpr std::array<std::uint8_t, 64> canonical_places() {
  std::array<std::uint8_t, 64> result{};
  std::array<unsigned, 4> place{0, 1, 2, 3};
  do {
    unsigned code = 0;
    unsigned pair = 0;
    bool odd = false;
    for (unsigned i = 0; i < 4; ++i) {
      for (unsigned j = i + 1; j < 4; ++j, ++pair) {
        code |= (place[i] < place[j] ? 1U : 0U) << pair;
        odd = odd != (place[i] > place[j]);
      }
    }
    unsigned places = 0;
    for (unsigned k = 0; k < 4; ++k) {
      places |= (odd && place[k] > 1 ? 5 - place[k] : place[k]) << (2 * k);
    }
    result[code] = static_cast<std::uint8_t>(places);
  } while (std::next_permutation(place.begin(), place.end()));
  return result;
}
constexpr std::array<std::uint8_t, 64> kCanonicalPlaces = canonical_places();

// Without a branch: which rank is the lower nobody can guess.
std::uint8_t places_of(const std::array<std::uint32_t, 4>& rank) {
  std::uint32_t code = 0;
  std::uint32_t pair = 0;
  for (std::size_t i = 0; i < 4; ++i) {
    for (std::size_t j = i + 1; j < 4; ++j) code |= std::uint32_t{rank[i] < rank[j]} << pair++;
  }
  return kCanonicalPlaces[code];
}

// A tet among those of one lowest rank: its other ranks, increasing.
struct UpperRanks {
  std::uint64_t second_and_third;
  std::uint32_t fourth;
  std::uint32_t slot;

  // Without a branch.
  friend bool operator<(const UpperRanks& a, const UpperRanks& b) {
    const std::uint32_t less{a.second_and_third < b.second_and_third};
    const std::uint32_t same{a.second_and_third == b.second_and_third};
    return (less | (same & std::uint32_t{a.fourth < b.fourth})) != 0;
  }
};

UpperRanks upper_ranks(const TetVertices& ranks, std::uint32_t slot) {
  const std::uint32_t third = ranks[2].value();
  const std::uint32_t fourth = ranks[3].value();
  return {(std::uint64_t{ranks[1].value()} << 32) | std::min(third, fourth),
          std::max(third, fourth), slot};
}

class Naming {
 public:
  Naming(std::span<TetSlot> built, std::span<const std::uint32_t> rank_of, unsigned threads)
      : built_(built), rank_of_(rank_of), threads_(threads), alone_(thread_count(threads) == 1) {
    names_.name.resize(built.size());
    names_.places.resize(built.size());
    names_.begin.resize(rank_of.size() + 1);
    latest_.resize(rank_of.size(), CanonicalNames::kNone);
  }

  CanonicalNames run() {
    const Stretches slots = Stretches::of(built_.size(), kSlotsOrdered, built_.size());
    parallel_for(slots.count, threads_,
                 [&](std::size_t k) { order_tets(slots.begin(k), slots.end(k)); });
    std::uint32_t sum = 0;
    for (std::uint32_t& begin : names_.begin) sum += std::exchange(begin, sum);
    const Stretches vertices = Stretches::of(rank_of_.size(), kVerticesNamed, rank_of_.size());
    parallel_for(vertices.count, threads_,
                 [&](std::size_t k) { name_tets_of(vertices.begin(k), vertices.end(k)); });
    return std::move(names_);
  }

 private:
  // The vertex of lowest rank of a tet.
  struct Lowest {
    std::uint32_t slot;
    std::uint32_t vertex;
    std::uint32_t rank;
  };

  // Orders some tets, and puts each into the list of its lowest vertex. Which list that is, and
  // where its tets are counted, is known long enough before for both to be fetched.
  void order_tets(std::size_t first, std::size_t end) {
    std::array<Lowest, kOrderedAtATime> lowest;
    for (std::size_t t = first; t < end;) {
      std::size_t count = 0;
      for (; t < end && count < lowest.size(); ++t) {
        if (t + kNamedAhead < end) fetch_ranks(built_[t + kNamedAhead].vertices);
        names_.name[t] = CanonicalNames::kNone;
        if (built_[t].vertices[0].index() >= rank_of_.size()) continue;
        lowest[count++] = ordered(t);
      }
      for (const Lowest& one : std::span(lowest).first(count)) {
        add(names_.begin[one.rank]);
        names_.name[one.slot] = put_first(latest_[one.vertex], one.slot);
      }
    }
  }

  void fetch_ranks(const TetVertices& tet) const {
    for (const VertexId v : tet) core::prefetch(rank_of_.data() + v.index());
  }

  // Puts the ranks of a tet's vertices into canonical order.
  Lowest ordered(std::size_t t) {
    TetVertices& tet = built_[t].vertices;
    std::array<std::uint32_t, 4> rank;
    for (std::size_t k = 0; k < 4; ++k) rank[k] = rank_of_[tet[k].index()];
    const std::uint32_t places = places_of(rank);
    names_.places[t] = static_cast<std::uint8_t>(places);
    TetVertices vertex;
    TetVertices ranks;
    for (std::size_t k = 0; k < 4; ++k) {
      const std::size_t place = (places >> (2 * k)) & 3U;
      vertex[place] = tet[k];
      ranks[place] = VertexId(rank[k]);
    }
    tet = ranks;
    core::prefetch(&names_.begin[ranks[0].index()]);
    core::prefetch(&latest_[vertex[0].index()]);
    return {static_cast<std::uint32_t>(t), vertex[0].value(), ranks[0].value()};
  }

  // Another thread may do the same to the same items: the lists' order does not matter.
  void add(std::uint32_t& number) const {
    if (alone_) {
      ++number;
    } else {
      std::atomic_ref(number).fetch_add(1, std::memory_order_relaxed);
    }
  }
  std::uint32_t put_first(std::uint32_t& latest, std::uint32_t slot) const {
    if (alone_) return std::exchange(latest, slot);
    return std::atomic_ref(latest).exchange(slot, std::memory_order_relaxed);
  }

  // The tets of a vertex: their first name, and where they begin among those collected.
  struct Own {
    std::uint32_t name;
    std::uint32_t begin;
  };

  // Of some vertices.
  void name_tets_of(std::size_t first, std::size_t end) {
    const std::vector<Own> own = own_of(first, end);
    const std::vector<std::uint32_t> slots = collected(first, own);
    std::vector<UpperRanks> tets(slots.size());
    for (std::size_t i = 0; i < slots.size(); ++i) {
      tets[i] = upper_ranks(built_[slots[i]].vertices, slots[i]);
    }
    for (std::size_t i = 0; i + 1 < own.size(); ++i) {
      give_names(std::span(tets).subspan(own[i].begin, own[i + 1].begin - own[i].begin),
                 own[i].name);
    }
  }

  // And their end.
  [[nodiscard]] std::vector<Own> own_of(std::size_t first, std::size_t end) const {
    std::vector<Own> own;
    own.reserve(end - first + 1);
    std::uint32_t sum = 0;
    for (std::size_t v = first; v < end; ++v) {
      if (v + kNamedAhead < end) core::prefetch(&names_.begin[rank_of_[v + kNamedAhead]]);
      const std::uint32_t* const begin = &names_.begin[rank_of_[v]];
      own.push_back({begin[0], sum});
      sum += begin[1] - begin[0];
    }
    own.push_back({0, sum});
    return own;
  }

  // The slots of their lists, vertex after vertex. All lists are followed at a time: where one goes
  // on is known only when memory has answered.
  [[nodiscard]] std::vector<std::uint32_t> collected(std::size_t first,
                                                     std::span<const Own> own) const {
    struct Following {
      std::uint32_t slot;
      std::uint32_t place;
    };
    std::vector<Following> lists;
    lists.reserve(own.size());
    for (std::size_t i = 0; i + 1 < own.size(); ++i) {
      if (own[i].begin < own[i + 1].begin) lists.push_back({latest_[first + i], own[i].begin});
    }
    std::vector<std::uint32_t> slots(own.back().begin);
    for (std::size_t count = lists.size(); count > 0;) {
      const std::size_t followed = std::exchange(count, 0);
      for (std::size_t i = 0; i < followed; ++i) {
        const Following at = lists[i];
        slots[at.place] = at.slot;
        core::prefetch(&built_[at.slot]);
        const std::uint32_t next = names_.name[at.slot];
        core::prefetch(names_.name.data() + next);
        lists[count] = {next, at.place + 1};
        count += next != CanonicalNames::kNone ? 1U : 0U;
      }
    }
    return slots;
  }

  // To the tets of one vertex.
  void give_names(std::span<UpperRanks> tets, std::uint32_t first) {
    if (tets.size() > kFewTets) {
      std::sort(tets.begin(), tets.end());
      for (const UpperRanks& tet : tets) names_.name[tet.slot] = first++;
      return;
    }
    // By how many are less: that compares all pairs, but nothing depends on a guess.
    std::array<std::uint32_t, kFewTets> place{};
    for (std::size_t i = 1; i < tets.size(); ++i) {
      for (std::size_t k = 0; k < i; ++k) {
        const std::uint32_t before{tets[k] < tets[i]};
        place[i] += before;
        place[k] += 1 - before;
      }
    }
    for (std::size_t i = 0; i < tets.size(); ++i) names_.name[tets[i].slot] = first + place[i];
  }

  std::span<TetSlot> built_;
  std::span<const std::uint32_t> rank_of_;
  unsigned threads_;
  bool alone_;
  // The tets of lowest vertex v: slot latest_[v], and after slot t slot names_.name[t], where it
  // has no name yet.
  std::vector<std::uint32_t> latest_;
  CanonicalNames names_;
};

}  // namespace

CanonicalNames name_tets(std::span<TetSlot> built, std::span<const std::uint32_t> rank_of,
                         unsigned threads) {
  return Naming(built, rank_of, threads).run();
}

}  // namespace tetloft::internal::delaunay3_detail

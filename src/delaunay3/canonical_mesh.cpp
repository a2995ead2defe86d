// See canonical_mesh.hpp.
//
// Tets that are neighbours are near each other in the engine's order, and far apart in the
// canonical one. So names and adjacency are worked out in the engine's order, in its slots; these
// are then sorted by name within each stretch, and the stretches merged, part by part, into the
// mesh.
#include "delaunay3/canonical_mesh.hpp"

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

#include "core/pages.hpp"
#include "core/parallel.hpp"
#include "core/prefetch.hpp"
#include "delaunay3/canonical_names.hpp"

namespace tetloft::internal::delaunay3_detail {

namespace {

// A part of the mesh, so many tets one after the other: small enough to be filled within cache.
constexpr std::size_t kTetsOfPart = std::size_t{1} << 13;
// Parts that the mesh grows by at a time, after which the slots they were read from are given back.
constexpr std::size_t kPartsOfRound = 32;

// Fewer slots than this are renumbered before a second thread has started.
constexpr std::size_t kSlotsForThreads = std::size_t{1} << 16;

class Renumbering {
 public:
  Renumbering(std::span<TetSlot> built, const VertexNames& names, unsigned threads)
      : built_(built),
        names_(names),
        threads_(built.size() < kSlotsForThreads ? 1 : threads),
        stretches_(stretches_of(built)) {}

  TetMesh run() {
    begin_ = name_tets(built_, names_.rank_of, threads_);
    parts_ = (tets() + kTetsOfPart - 1) / kTetsOfPart;
    part_begin_.resize(stretches_.count * (parts_ + 1));
    parallel_for(stretches_.count, threads_, [&](std::size_t k) { rename_opposites(k); });
    parallel_for(stretches_.count, threads_, [&](std::size_t k) { sort_stretch(k); });
    fill_mesh();
    return TetMesh::from_adjacency(names_.input_count, std::move(tets_), std::move(opposite_));
  }

 private:
  [[nodiscard]] std::size_t tets() const { return begin_.back(); }
  // The part of a slot's tet; after all parts for those that have none.
  [[nodiscard]] std::size_t part_of(const TetSlot& slot) const {
    return renamed::is_finite(slot) ? renamed::name(slot) / kTetsOfPart : parts_;
  }

  // Puts the opposites of the tets of a stretch into canonical order, by their new names. Of other
  // tets it reads what no one writes meanwhile.
  void rename_opposites(std::size_t k) {
    std::uint32_t* begin = &part_begin_[k * (parts_ + 1)];
    for (std::size_t t = stretches_.begin(k); t < stretches_.end(k); ++t) {
      TetSlot& slot = built_[t];
      ++begin[part_of(slot)];
      if (t + kSlotsAhead < stretches_.end(k)) {
        for (const HalfFaceId across : built_[t + kSlotsAhead].opposite) {
          core::prefetch(&built_[0] + (across.index() >> 2));
        }
      }
      if (!renamed::is_finite(slot)) continue;
      std::array<HalfFaceId, 4> opposite;
      for (std::size_t face = 0; face < 4; ++face) {
        const HalfFaceId across = slot.opposite[face];
        if (!across.valid()) continue;
        const TetSlot& neighbour = built_[across.index() >> 2];
        if (!renamed::is_finite(neighbour)) continue;  // a ghost: the face is on the hull
        opposite[renamed::place(slot, face)] = HalfFaceId(
            4 * renamed::name(neighbour) + renamed::place(neighbour, across.index() & 3U));
      }
      slot.opposite = opposite;
    }
  }

  // Sorts the slots of a stretch by part, each part from part_begin_ on, in place: every slot that
  // is not in its part changes places with the first of its part that is not known to be (McIlroy,
  // Bostic and McIlroy, "Engineering radix sort", Computing Systems 6, 1993).
  void sort_stretch(std::size_t k) {
    std::uint32_t* begin = &part_begin_[k * (parts_ + 1)];
    std::uint32_t sum = static_cast<std::uint32_t>(stretches_.begin(k));
    for (std::size_t p = 0; p <= parts_; ++p) sum += std::exchange(begin[p], sum);
    std::vector<std::uint32_t> next(begin, begin + parts_ + 1);
    for (std::size_t p = 0; p < parts_; ++p) {
      for (const std::uint32_t end = begin[p + 1]; next[p] < end;) {
        const TetSlot moving = built_[next[p]];
        const std::size_t part = part_of(moving);
        built_[next[p]] = built_[next[part]];
        built_[next[part]++] = moving;
      }
    }
  }

  void fill_mesh() {
    tets_.reserve(tets());
    opposite_.reserve(4 * tets());
    for (std::size_t part = 0; part < std::min(kPartsOfRound, parts_); ++part) make_room(part);
    for (std::size_t first = 0; first < parts_; first += kPartsOfRound) {
      const std::size_t end = std::min(first + kPartsOfRound, parts_);
      const std::size_t filled = std::min(end * kTetsOfPart, tets());
      tets_.resize(filled);
      opposite_.resize(4 * filled);
      parallel_for(end - first, threads_, [&](std::size_t i) {
        fill_part(first + i);
        if (end + i < parts_) make_room(end + i);
        for (std::size_t k = i; k < stretches_.count; k += end - first) give_back(k, first);
      });
    }
  }

  // The slots of a stretch whose tets are in the parts before `end`.
  void give_back(std::size_t k, std::size_t end) {
    const std::size_t begin = stretches_.begin(k);
    core::give_back_pages(built_.subspan(begin, part_begin_[k * (parts_ + 1) + end] - begin));
  }

  // Of a part that the mesh has not grown to: its pages are made by several threads, before one
  // makes its elements.
  void make_room(std::size_t part) {
    const std::size_t first = part * kTetsOfPart;
    const std::size_t count = std::min(tets() - first, kTetsOfPart);
    core::make_pages(tets_.data() + first, count);
    core::make_pages(opposite_.data() + 4 * first, 4 * count);
  }

  void fill_part(std::size_t part) {
    const std::array<std::uint32_t, kTetsOfPart> lowest = lowest_ranks(part);
    for (std::size_t k = 0; k < stretches_.count; ++k) {
      const std::uint32_t* begin = &part_begin_[k * (parts_ + 1) + part];
      for (const TetSlot& slot : built_.subspan(begin[0], begin[1] - begin[0])) {
        const std::uint32_t name = renamed::name(slot);
        tets_[name] = {
            names_.input_of[lowest[name % kTetsOfPart]], names_.input_of[renamed::rank(slot, 1)],
            names_.input_of[renamed::rank(slot, 2)], names_.input_of[renamed::rank(slot, 3)]};
        std::copy(slot.opposite.begin(), slot.opposite.end(),
                  opposite_.begin() + std::ptrdiff_t{4} * name);
      }
    }
  }

  // Of the tets of a part: their lowest ranks, whose place their names have taken.
  [[nodiscard]] std::array<std::uint32_t, kTetsOfPart> lowest_ranks(std::size_t part) const {
    std::array<std::uint32_t, kTetsOfPart> lowest;
    const std::size_t first = part * kTetsOfPart;
    const std::size_t end = std::min(first + kTetsOfPart, tets());
    const auto after = std::upper_bound(begin_.begin(), begin_.end(), first);
    auto r = static_cast<std::uint32_t>(after - begin_.begin() - 1);
    for (std::size_t name = first; name < end; ++name) {
      while (begin_[r + 1] <= name) ++r;
      lowest[name - first] = r;
    }
    return lowest;
  }

  std::span<TetSlot> built_;
  const VertexNames& names_;
  unsigned threads_;
  Stretches stretches_;
  std::size_t parts_ = 0;
  // The tets of lowest rank r are begin_[r] to begin_[r + 1].
  std::vector<std::uint32_t> begin_;
  // [stretch k * (parts_ + 1) + p]: where the slots of part p begin in stretch k; first their
  // number. After all parts come the slots without a tet.
  std::vector<std::uint32_t> part_begin_;
  std::vector<TetVertices> tets_;
  std::vector<HalfFaceId> opposite_;
};

}  // namespace

TetMesh canonical_mesh(std::span<TetSlot> built, const VertexNames& names, unsigned threads) {
  return Renumbering(built, names, threads).run();
}

}  // namespace tetloft::internal::delaunay3_detail

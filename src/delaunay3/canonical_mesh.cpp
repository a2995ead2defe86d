// See canonical_mesh.hpp.
//
// Tets that are neighbours are near each other in the engine's order, and far apart in the
// canonical one. So names and adjacency are worked out in the engine's order, in which the slots
// are dealt out, within each stretch, to the parts of the mesh that their names are in. Then the
// mesh is filled part by part from all stretches.
#include "delaunay3/canonical_mesh.hpp"

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

#include "core/pages.hpp"
#include "core/parallel.hpp"
#include "core/prefetch.hpp"
#include "delaunay3/canonical_names.hpp"
#include "delaunay3/stretches.hpp"

namespace tetloft::internal::delaunay3_detail {

namespace {

// A part of the mesh, so many tets one after the other: small enough to be filled within cache.
constexpr std::size_t kTetsOfPart = std::size_t{1} << 13;
// Parts that the mesh grows by at a time, after which the slots they were read from are given back.
constexpr std::size_t kPartsOfRound = 32;

// Short enough for its slots to stay in cache while they are dealt out, long enough for what is
// left of a page where they are given back not to matter.
constexpr std::size_t kSlotsOfStretch = std::size_t{1} << 15;
constexpr std::size_t kMostStretches = 1024;
// So many slots before one is renumbered what is asked of its neighbours is fetched.
constexpr std::size_t kSlotsAhead = 16;

// Fewer slots than this are renumbered before a second thread has started.
constexpr std::size_t kSlotsForThreads = std::size_t{1} << 16;

class Renumbering {
 public:
  Renumbering(std::span<TetSlot> built, const VertexNames& names, unsigned threads)
      : built_(built),
        names_(names),
        threads_(built.size() < kSlotsForThreads ? 1 : threads),
        stretches_(Stretches::of(built.size(), kSlotsOfStretch, kMostStretches)) {}

  TetMesh run() {
    canonical_ = name_tets(built_, names_.rank_of, threads_);
    parts_ = (tets() + kTetsOfPart - 1) / kTetsOfPart;
    part_begin_.resize(stretches_.count * (parts_ + 1));
    parallel_for(stretches_.count, threads_, [&](std::size_t k) { renumber_stretch(k); });
    core::release(canonical_.name);
    core::release(canonical_.places);
    fill_mesh();
    return TetMesh::from_adjacency(names_.input_count, std::move(tets_), std::move(opposite_));
  }

 private:
  [[nodiscard]] std::size_t tets() const { return canonical_.tets(); }

  // Renames the tets of a stretch, and deals them out to parts, each from part_begin_ on. Nothing
  // is read of other stretches' slots.
  void renumber_stretch(std::size_t k) {
    const std::size_t first = stretches_.begin(k);
    const std::size_t end = stretches_.end(k);
    std::vector<std::uint32_t> next(parts_ + 1);
    for (std::size_t t = first; t < end; ++t) ++next[part_of(canonical_.name[t])];
    std::uint32_t sum = 0;
    for (std::uint32_t& part : next) sum += std::exchange(part, sum);
    std::transform(next.begin(), next.end(), &part_begin_[k * (parts_ + 1)],
                   [&](std::uint32_t place) { return static_cast<std::uint32_t>(first) + place; });
    std::vector<TetSlot> sorted(next.back());
    for (std::size_t t = first; t < end; ++t) {
      if (t + kSlotsAhead < end) fetch_neighbours(built_[t + kSlotsAhead]);
      const std::uint32_t name = canonical_.name[t];
      if (name != CanonicalNames::kNone) sorted[next[name / kTetsOfPart]++] = renumbered(t, name);
    }
    std::copy(sorted.begin(), sorted.end(), built_.begin() + static_cast<std::ptrdiff_t>(first));
  }

  // After all parts for slots without a tet.
  [[nodiscard]] std::size_t part_of(std::uint32_t name) const {
    return name == CanonicalNames::kNone ? parts_ : name / kTetsOfPart;
  }

  void fetch_neighbours(const TetSlot& slot) const {
    for (const HalfFaceId across : slot.opposite) {
      core::prefetch(canonical_.name.data() + (across.index() >> 2));
      core::prefetch(canonical_.places.data() + (across.index() >> 2));
    }
  }

  // The tet with its name for its lowest rank, and its opposites by their names and places.
  [[nodiscard]] TetSlot renumbered(std::size_t t, std::uint32_t name) const {
    const TetSlot& slot = built_[t];
    TetSlot result;
    result.vertices = {VertexId(name), slot.vertices[1], slot.vertices[2], slot.vertices[3]};
    for (std::size_t face = 0; face < 4; ++face) {
      const HalfFaceId across = slot.opposite[face];
      if (!across.valid()) continue;
      const std::size_t neighbour = across.index() >> 2;
      if (canonical_.name[neighbour] == CanonicalNames::kNone) continue;  // the face is on the hull
      result.opposite[canonical_.place(t, face)] = HalfFaceId(
          4 * canonical_.name[neighbour] + canonical_.place(neighbour, across.index() & 3U));
    }
    return result;
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
        const std::uint32_t name = slot.vertices[0].value();
        tets_[name] = {
            names_.input_of[lowest[name % kTetsOfPart]], names_.input_of[slot.vertices[1].index()],
            names_.input_of[slot.vertices[2].index()], names_.input_of[slot.vertices[3].index()]};
        std::copy(slot.opposite.begin(), slot.opposite.end(),
                  opposite_.begin() + std::ptrdiff_t{4} * name);
      }
    }
  }

  // Of the tets of a part: their lowest ranks, whose place their names have taken.
  [[nodiscard]] std::array<std::uint32_t, kTetsOfPart> lowest_ranks(std::size_t part) const {
    const std::vector<std::uint32_t>& begin = canonical_.begin;
    std::array<std::uint32_t, kTetsOfPart> lowest;
    const std::size_t first = part * kTetsOfPart;
    const std::size_t end = std::min(first + kTetsOfPart, tets());
    const auto after = std::upper_bound(begin.begin(), begin.end(), first);
    auto r = static_cast<std::uint32_t>(after - begin.begin() - 1);
    for (std::size_t name = first; name < end; ++name) {
      while (begin[r + 1] <= name) ++r;
      lowest[name - first] = r;
    }
    return lowest;
  }

  std::span<TetSlot> built_;
  const VertexNames& names_;
  unsigned threads_;
  Stretches stretches_;
  std::size_t parts_ = 0;
  CanonicalNames canonical_;
  // [stretch k * (parts_ + 1) + p]: where the slots of part p begin in stretch k.
  // After all parts come the slots without a tet.
  std::vector<std::uint32_t> part_begin_;
  std::vector<TetVertices> tets_;
  std::vector<HalfFaceId> opposite_;
};

}  // namespace

TetMesh canonical_mesh(std::span<TetSlot> built, const VertexNames& names, unsigned threads) {
  return Renumbering(built, names, threads).run();
}

}  // namespace tetloft::internal::delaunay3_detail

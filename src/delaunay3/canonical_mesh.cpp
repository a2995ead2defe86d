// See canonical_mesh.hpp.
#include "delaunay3/canonical_mesh.hpp"

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

namespace tetloft::internal::delaunay3_detail {

namespace {

using Ranks = std::array<std::uint32_t, 4>;
// Local vertex numbers in some order, two bits each: number k at bits 2 k and 2 k + 1.
using Permutation = std::uint8_t;

constexpr std::size_t kCorners = 4;

// A tet with its vertices named by rank and put into canonical order.
struct NamedTet {
  Ranks increasing{};
  bool odd = false;          // increasing order is an odd permutation of the engine's
  Permutation position = 0;  // number k: canonical place of the engine's vertex k
};

Permutation with_number(Permutation p, std::size_t k, std::size_t number) {
  return static_cast<Permutation>(p | (number << (2 * k)));
}

int number_of(Permutation p, int k) { return (p >> (2 * k)) & 3; }

NamedTet name_tet(const TetVertices& tet, std::span<const std::uint32_t> rank_of) {
  // Rank and engine's place: sorts by rank, as ranks are distinct.
  std::array<std::uint64_t, kCorners> entry;
  for (std::size_t k = 0; k < kCorners; ++k) {
    entry[k] = (std::uint64_t{rank_of[tet[k].index()]} << 2) | k;
  }
  NamedTet named;
  const auto order = [&](std::size_t i, std::size_t j) {
    const bool swapped = entry[j] < entry[i];
    const std::uint64_t low = std::min(entry[i], entry[j]);
    entry[j] = std::max(entry[i], entry[j]);
    entry[i] = low;
    named.odd = named.odd != swapped;
  };
  // The optimal sorting network of four.
  order(0, 1);
  order(2, 3);
  order(0, 2);
  order(1, 3);
  order(1, 2);
  for (std::size_t i = 0; i < kCorners; ++i) {
    named.increasing[i] = static_cast<std::uint32_t>(entry[i] >> 2);
  }
  // The engine's tets are positive: an odd order is made even by swapping the last two.
  if (named.odd) std::swap(entry[2], entry[3]);
  for (std::size_t i = 0; i < kCorners; ++i) {
    named.position = with_number(named.position, entry[i] & 3U, i);
  }
  return named;
}

// A finite tet on its way into canonical order; its lowest rank is that of its bucket.
struct Entry {
  std::array<std::uint32_t, 3> upper;  // the other ranks, increasing
  std::uint32_t slot : 31;             // the engine's; 31 bits hold it, there are below 2^30
  std::uint32_t odd : 1;               // whether the last two vertices are to be swapped
};

// Where the engine's tets went.
struct Renaming {
  IdVector<TetId, TetId> name;            // invalid for ghosts and dead slots
  IdVector<TetId, Permutation> position;  // of the vertices

  // The new name of half-face `face` of slot t, which is finite.
  [[nodiscard]] HalfFaceId half_face(TetId t, int face) const {
    return TetMesh::half_face(name[t], number_of(position[t], face));
  }
};

// Collects the finite tets in buckets of equal lowest rank, bucket r from bucket[r] to
// bucket[r + 1], and sorts each. Fills renaming.position.
std::vector<Entry> sort_tets(std::span<const TetSlot> built, std::span<const std::uint32_t> rank_of,
                             std::vector<std::size_t>& bucket, Renaming& renaming) {
  const auto for_each_finite = [&](const auto& visit) {
    for (std::size_t k = 0; k < built.size(); ++k) {
      if (built[k].vertices[0].index() < rank_of.size()) visit(TetId(k), built[k].vertices);
    }
  };
  bucket.assign(rank_of.size() + 1, 0);
  for_each_finite([&](TetId, const TetVertices& tet) {
    ++bucket[std::min(std::min(rank_of[tet[0].index()], rank_of[tet[1].index()]),
                      std::min(rank_of[tet[2].index()], rank_of[tet[3].index()]))];
  });
  std::size_t total = 0;
  for (std::size_t& end : bucket) end = total += end;

  std::vector<Entry> entries(total);
  renaming.position = IdVector<TetId, Permutation>(built.size());
  // Filling from the ends leaves every bucket[r] at the start of its bucket.
  for_each_finite([&](TetId t, const TetVertices& tet) {
    const NamedTet named = name_tet(tet, rank_of);
    const auto& [r0, r1, r2, r3] = named.increasing;
    renaming.position[t] = named.position;
    entries[--bucket[r0]] = {{r1, r2, r3}, t.value() & 0x7FFFFFFFU, named.odd ? 1U : 0U};
  });
  for (std::size_t r = 0; r + 1 < bucket.size(); ++r) {
    const auto at = [&](std::size_t i) {
      return entries.begin() + static_cast<std::ptrdiff_t>(bucket[i]);
    };
    std::sort(at(r), at(r + 1), [](const Entry& a, const Entry& b) { return a.upper < b.upper; });
  }
  return entries;
}

// The tets in canonical order. Fills `renaming`.
std::vector<TetVertices> canonical_tets(std::span<const TetSlot> built, const VertexNames& names,
                                        Renaming& renaming) {
  std::vector<std::size_t> bucket;
  const std::vector<Entry> entries = sort_tets(built, names.rank_of, bucket, renaming);
  std::vector<TetVertices> tets(entries.size());
  renaming.name = IdVector<TetId, TetId>(built.size());
  for (std::size_t r = 0; r + 1 < bucket.size(); ++r) {
    for (std::size_t i = bucket[r]; i < bucket[r + 1]; ++i) {
      const Entry& entry = entries[i];
      renaming.name[TetId(std::uint32_t{entry.slot})] = TetId(i);
      tets[i] = {names.input_of[r], names.input_of[entry.upper[0]], names.input_of[entry.upper[1]],
                 names.input_of[entry.upper[2]]};
      if (entry.odd != 0) std::swap(tets[i][2], tets[i][3]);
    }
  }
  return tets;
}

}  // namespace

TetMesh canonical_mesh(std::span<const TetSlot> built, const VertexNames& names) {
  Renaming renaming;
  std::vector<TetVertices> tets = canonical_tets(built, names, renaming);
  // In the engine's order, in which neighbours are near each other in memory.
  std::vector<HalfFaceId> opposite(4 * tets.size());
  for (TetId t(0U); t.index() < built.size(); t = TetId(t.value() + 1)) {
    if (!renaming.name[t].valid()) continue;
    for (int face = 0; face < 4; ++face) {
      const HalfFaceId across = built[t.index()].opposite[static_cast<std::size_t>(face)];
      if (!across.valid()) continue;
      const TetId neighbour = TetMesh::tet_of(across);
      if (!renaming.name[neighbour].valid()) continue;  // a ghost: the face is on the hull
      opposite[renaming.half_face(t, face).index()] =
          renaming.half_face(neighbour, TetMesh::face_of(across));
    }
  }
  return TetMesh::from_adjacency(names.input_count, std::move(tets), std::move(opposite));
}

}  // namespace tetloft::internal::delaunay3_detail

// See canonical_mesh.hpp.
#include "delaunay3/canonical_mesh.hpp"

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

namespace tetloft::delaunay3_detail {

namespace {

using Ranks = std::array<std::uint32_t, 4>;
// Local vertex numbers in some order, two bits each: number k at bits 2 k and 2 k + 1.
using Permutation = std::uint8_t;

constexpr std::size_t kSlots = 4;

// A tet with its vertices named by rank and put into canonical order.
struct NamedTet {
  Ranks increasing{};
  bool odd = false;          // increasing order is an odd permutation of the engine's
  Permutation position = 0;  // number k: canonical place of the engine's vertex k
};

Permutation with_number(Permutation p, std::size_t k, std::size_t number) {
  return static_cast<Permutation>(p | (number << (2 * k)));
}

std::size_t number_of(Permutation p, std::size_t k) { return (p >> (2 * k)) & 3U; }

NamedTet name_tet(const TetVertices& tet, std::span<const std::uint32_t> rank_of) {
  std::array<std::pair<std::uint32_t, std::uint32_t>, kSlots> entry;  // rank, engine's place
  for (std::uint32_t k = 0; k < kSlots; ++k) entry[k] = {rank_of[tet[k].index()], k};
  NamedTet named;
  const auto order = [&](std::size_t i, std::size_t j) {
    if (entry[i].first < entry[j].first) return;
    std::swap(entry[i], entry[j]);
    named.odd = !named.odd;
  };
  // The optimal sorting network of four.
  order(0, 1);
  order(2, 3);
  order(0, 2);
  order(1, 3);
  order(1, 2);
  for (std::size_t i = 0; i < kSlots; ++i) named.increasing[i] = entry[i].first;
  // The engine's tets are positive: an odd order is made even by swapping the last two.
  if (named.odd) std::swap(entry[2], entry[3]);
  for (std::size_t i = 0; i < kSlots; ++i) {
    named.position = with_number(named.position, entry[i].second, i);
  }
  return named;
}

// The engine's slots of the finite tets in canonical order.
struct TetOrder {
  struct Entry {
    std::array<std::uint32_t, 3> upper;  // ranks of the tet but the lowest
    TetId slot;
  };
  std::vector<Entry> entries;
  std::vector<std::size_t> bucket;  // entries of lowest rank r: from bucket[r] to bucket[r + 1]
};

TetOrder sort_tets(const Delaunay3Builder& built, std::span<const std::uint32_t> rank_of) {
  TetOrder order;
  order.bucket.assign(rank_of.size() + 1, 0);
  const auto lowest_rank = [&](TetId t) {
    const TetVertices& tet = built.vertices(t);
    return std::min(std::min(rank_of[tet[0].index()], rank_of[tet[1].index()]),
                    std::min(rank_of[tet[2].index()], rank_of[tet[3].index()]));
  };
  for (TetId t(0); t.index() < built.tet_slots(); t = TetId(t.value() + 1)) {
    if (built.is_finite(t)) ++order.bucket[lowest_rank(t)];
  }
  std::size_t total = 0;
  for (std::size_t& end : order.bucket) end = total += end;
  order.entries.resize(total);
  // Filling from the ends leaves every bucket[r] at the start of its bucket.
  for (TetId t(0); t.index() < built.tet_slots(); t = TetId(t.value() + 1)) {
    if (!built.is_finite(t)) continue;
    const Ranks ranks = name_tet(built.vertices(t), rank_of).increasing;
    order.entries[--order.bucket[ranks[0]]] = {{ranks[1], ranks[2], ranks[3]}, t};
  }
  for (std::size_t r = 0; r + 1 < order.bucket.size(); ++r) {
    const auto at = [&](std::size_t i) {
      return order.entries.begin() + static_cast<std::ptrdiff_t>(order.bucket[i]);
    };
    std::sort(at(r), at(r + 1), [](const auto& a, const auto& b) { return a.upper < b.upper; });
  }
  return order;
}

}  // namespace

TetMesh canonical_mesh(const Delaunay3Builder& built, const VertexNames& names) {
  const TetOrder order = sort_tets(built, names.rank_of);
  const std::size_t count = order.entries.size();

  // name[t] of the engine's slot t, invalid if not finite, and where its vertices went.
  IdVector<TetId, TetId> name(built.tet_slots());
  IdVector<TetId, Permutation> position(built.tet_slots());
  std::vector<TetVertices> tets(count);
  for (std::size_t i = 0; i < count; ++i) {
    const TetId slot = order.entries[i].slot;
    const TetVertices& tet = built.vertices(slot);
    name[slot] = TetId(i);
    position[slot] = name_tet(tet, names.rank_of).position;
    for (std::size_t k = 0; k < kSlots; ++k) {
      tets[i][number_of(position[slot], k)] = names.input_of[names.rank_of[tet[k].index()]];
    }
  }

  std::vector<HalfFaceId> opposite(4 * count);
  const auto renamed = [&](TetId slot, int face) {
    return TetMesh::half_face(
        name[slot], static_cast<int>(number_of(position[slot], static_cast<std::size_t>(face))));
  };
  for (const TetOrder::Entry& entry : order.entries) {
    for (int face = 0; face < 4; ++face) {
      const HalfFaceId across = built.opposite(TetMesh::half_face(entry.slot, face));
      const TetId neighbour = TetMesh::tet_of(across);
      if (!name[neighbour].valid()) continue;  // a ghost: the face is on the hull
      opposite[renamed(entry.slot, face).index()] = renamed(neighbour, TetMesh::face_of(across));
    }
  }
  return TetMesh::from_adjacency(names.input_count, std::move(tets), std::move(opposite));
}

}  // namespace tetloft::delaunay3_detail

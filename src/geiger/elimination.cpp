#include "geiger/elimination.hpp"

#include <bit>

#include "core/union_find.hpp"

namespace tetloft::internal::geiger {

namespace {

bool is_external(TetKind kind) {
  return kind == TetKind::t1_external || kind == TetKind::ie || kind == TetKind::ee ||
         kind == TetKind::ec;
}

}  // namespace

Elimination eliminate(const Slab& slab) {
  const TetMesh& mesh = slab.mesh();
  const std::size_t n = mesh.tet_slots();
  Elimination result{IdVector<TetId, std::uint8_t>(n, 0)};
  UnionFind parts(n);
  for (std::size_t k = 0; k < n; ++k) {
    const TetId t(k);
    if (is_external(slab.kind(t))) {
      ++result.external;
      continue;
    }
    result.stays[t] = 1;
    for (int i = 0; i < 4; ++i) {
      const TetId across = mesh.neighbour(t, i);
      if (across.valid() && !is_external(slab.kind(across))) parts.unite(k, across.index());
    }
  }
  // Bit 0: the part has a triangle in the lower plane; bit 1: in the upper.
  std::vector<std::uint8_t> planes(n, 0);
  for (std::size_t k = 0; k < n; ++k) {
    if (slab.kind(TetId(k)) != TetKind::t1_internal) continue;
    const bool above = std::popcount(slab.upper_corners(TetId(k))) == 3;
    std::uint8_t& bits = planes[parts.find(k)];
    bits = static_cast<std::uint8_t>(bits | (above ? 2 : 1));
  }
  for (std::size_t k = 0; k < n; ++k) {
    if (result.stays[TetId(k)] == 0 || planes[parts.find(k)] == 3) continue;
    result.stays[TetId(k)] = 0;
    ++result.singular;
  }
  return result;
}

}  // namespace tetloft::internal::geiger

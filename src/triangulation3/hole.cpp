// See hole.hpp.
#include "triangulation3/hole.hpp"

#include <algorithm>
#include <numeric>
#include <span>

#include <tetloft/predicates.hpp>

#include "core/guard.hpp"
#include "delaunay3/batch.hpp"
#include "delaunay3/canonical_order.hpp"

namespace tetloft::internal::triangulation3 {

namespace {

using delaunay3_detail::facet_of;
using delaunay3_detail::GrowingTets;
using delaunay3_detail::half_face;
using delaunay3_detail::index_of;
using delaunay3_detail::Inserter;
using delaunay3_detail::kGhost;

// Vertices of larger links are inserted in an order of their own; of smaller ones in that of the
// star, whose neighbours are near each other.
constexpr std::size_t kLargeLink = 100;

std::uint64_t edge_key(std::uint32_t from, std::uint32_t to) {
  return std::uint64_t{from} << 32 | to;
}

}  // namespace

void Hole::open(GrowingTets& tets, VertexId v, TetId of_v) {
  removed_ = v;
  star_.clear();
  link_.clear();
  facets_.clear();
  if (number_of_.size() < tets.vertex_count()) number_of_.resize(tets.vertex_count());
  star_.push_back(of_v);
  tets.mark(of_v) = GrowingTets::Mark::outside;
  const auto unmark = [&] {
    for (const TetId t : star_) tets.mark(t) = GrowingTets::Mark::unvisited;
  };
  try {
    for (std::size_t next = 0; next < star_.size(); ++next) {
      const TetId t = star_[next];
      const TetVertices& tet = tets.tet(t);
      const std::size_t at = index_of(tet, v);
      const TriangleVertices facet = facet_of(tet, at);
      facets_.push_back({tets.opposite(half_face(t, at)),
                         {number(facet[0]), number(facet[1]), number(facet[2])}});
      for (std::size_t i = 0; i < 4; ++i) {
        if (i == at) continue;
        const TetId neighbour = TetMesh::tet_of(tets.opposite(half_face(t, i)));
        if (tets.mark(neighbour) != GrowingTets::Mark::unvisited) continue;
        star_.push_back(neighbour);
        tets.mark(neighbour) = GrowingTets::Mark::outside;
      }
    }
  } catch (...) {
    unmark();
    throw;
  }
  unmark();
}

Hole::Number Hole::number(VertexId v) {
  if (v == kGhost) return kGhostNumber;
  Number& known = number_of_[v.index()];
  if (known < link_.size() && link_[known] == v) return known;
  known = static_cast<Number>(link_.size());
  link_.push_back(v);
  return known;
}

void Hole::fill(GrowingTets& tets, Inserter& inserter, IdVector<VertexId, TetId>& tet_of) {
  try {
    triangulate_link(tets);
    find_zone(tets);
    list_edges();
    slot_of_.resize(std::max(slot_of_.size(), small_.taken()));
    tets.reserve(inserter_.zone().size());
    inserter.reserve_free(star_.size());
    filling_.clear();
    filling_.reserve(inserter_.zone().size());
  } catch (...) {
    small_.unmark_all();
    throw;
  }
  // From here on nothing needs memory.
  place_zone(tets, inserter, tet_of);
  inserter_.leave_zone();
}

void Hole::triangulate_link(const GrowingTets& tets) {
  small_.start_again(tets.filter());
  inserter_.start_again();
  std::vector<Point3> points;
  points.reserve(link_.size());
  for (const VertexId v : link_) {
    points.push_back(tets.point(v));
    small_.add_vertex(points.back());
  }
  const TetVertices first = first_tet(tets);
  inserter_.start_with(first);
  const auto insert = [&](VertexId v) {
    if (v != first[0] && v != first[1] && v != first[2] && v != first[3]) {
      (void)inserter_.insert(v, delaunay3_detail::kMostTetSlots);
    }
  };
  if (link_.size() < kLargeLink) {
    for (std::size_t k = 0; k < link_.size(); ++k) insert(VertexId(k));
    return;
  }
  const std::vector<std::uint32_t> canonical = delaunay3_detail::canonical_order(points);
  const std::vector<Point3> ranked = delaunay3_detail::picked<Point3>(points, canonical, 1);
  for (const std::uint32_t place : delaunay3_detail::batch_order(ranked, 1).places) {
    insert(VertexId(canonical[place]));
  }
}

// Four vertices of the small triangulation that are not in a plane: three of a facet of the link,
// and one off its plane, of the link if it has one.
TetVertices Hole::first_tet(const GrowingTets& tets) {
  const auto finite = [](const Facet& facet) {
    return std::find(facet.corners.begin(), facet.corners.end(), kGhostNumber) ==
           facet.corners.end();
  };
  const auto facet = std::find_if(facets_.begin(), facets_.end(), finite);
  TETLOFT_CHECK(facet != facets_.end());
  TetVertices first{
      VertexId(facet->corners[0]), VertexId(facet->corners[1]), VertexId(facet->corners[2]), {}};
  const auto is_off = [&](const Point3& p) {
    return orient3d(small_.point(first[0]), small_.point(first[1]), small_.point(first[2]), p) !=
           Sign::zero;
  };
  for (std::size_t k = 0; k < link_.size(); ++k) {
    if (!is_off(small_.point(VertexId(k)))) continue;
    first[3] = VertexId(k);
    return first;
  }
  for (const Facet& across : facets_) {
    const TetVertices& tet = tets.tet(TetMesh::tet_of(across.outer));
    const VertexId apex = tet[across.outer.index() & 3];
    if (apex == kGhost || tet[0] == kGhost || !is_off(tets.point(apex))) continue;
    first[3] = small_.add_vertex(tets.point(apex));
    return first;
  }
  TETLOFT_CHECK(false);
  return first;
}

void Hole::find_zone(const GrowingTets& tets) {
  const VertexId v = small_.add_vertex(tets.point(removed_));
  inserter_.find_zone(v, inserter_.locate(small_.point(v)));
}

void Hole::list_edges() {
  edges_.clear();
  for (const Facet& facet : facets_) {
    for (std::size_t i = 0; i < 3; ++i) {
      edges_.push_back({edge_key(facet.corners[i], facet.corners[(i + 1) % 3]), facet.outer});
    }
  }
  std::sort(edges_.begin(), edges_.end(),
            [](const EdgeFacet& a, const EdgeFacet& b) { return a.edge < b.edge; });
}

HalfFaceId Hole::outer_of(Number from, Number to) const {
  const auto found =
      std::lower_bound(edges_.begin(), edges_.end(), edge_key(from, to),
                       [](const EdgeFacet& facet, std::uint64_t key) { return facet.edge < key; });
  TETLOFT_CHECK(found != edges_.end() && found->edge == edge_key(from, to));
  return found->outer;
}

void Hole::place_zone(GrowingTets& tets, Inserter& inserter, IdVector<VertexId, TetId>& tet_of) {
  // Of a vertex that no tet of the filling has, all tets are outside.
  for (const Facet& facet : facets_) {
    for (const Number n : facet.corners) {
      if (n != kGhostNumber) tet_of[link_[n]] = TetMesh::tet_of(facet.outer);
    }
  }
  for (const TetId t : star_) {
    tets.slot(t).vertices[0] = VertexId();
    inserter.free_slot(t);
  }
  tet_of[removed_] = TetId();
  for (const TetId t : inserter_.zone()) {
    filling_.push_back(inserter.take_slot());
    slot_of_[t.index()] = filling_.back();
  }
  const auto named = [&](VertexId v) { return v == kGhost ? v : link_[v.index()]; };
  for (const TetId t : inserter_.zone()) {
    const TetVertices& small = small_.tet(t);
    const TetId slot = slot_of_[t.index()];
    tets.slot(slot).vertices = {named(small[0]), named(small[1]), named(small[2]), named(small[3])};
    for (std::size_t i = 0; i < 4; ++i) {
      const HalfFaceId across = small_.opposite(half_face(t, i));
      if (inserter_.is_in_zone(TetMesh::tet_of(across))) {
        tets.opposite(half_face(slot, i)) =
            half_face(slot_of_[TetMesh::tet_of(across).index()], across.index() & 3);
      } else {
        const TriangleVertices facet = facet_of(small, i);
        tets.glue(half_face(slot, i),
                  outer_of(number_of_small(facet[0]), number_of_small(facet[1])));
      }
    }
    for (const VertexId v : tets.tet(slot)) {
      if (v != kGhost) tet_of[v] = slot;
    }
  }
}

}  // namespace tetloft::internal::triangulation3

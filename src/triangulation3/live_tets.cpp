// See live_tets.hpp.
#include "triangulation3/live_tets.hpp"

#include <algorithm>
#include <array>
#include <stdexcept>

#include <tetloft/predicates.hpp>

#include "core/guard.hpp"
#include "delaunay3/affine_basis.hpp"
#include "delaunay3/batch.hpp"
#include "delaunay3/walk.hpp"
#include "triangulation3/auxiliary.hpp"

namespace tetloft::internal::triangulation3 {

namespace {

// As many as are affinely independent.
std::vector<Point3> spanning_points(std::span<const Point3> points) {
  const delaunay3_detail::AffineBasis basis = delaunay3_detail::affine_basis(points);
  std::vector<Point3> result;
  for (std::size_t k = 0; k < static_cast<std::size_t>(basis.dimension + 1); ++k) {
    result.push_back(points[basis.place[k]]);
  }
  return result;
}

// Gives the vertices of slots their names, and each of them one of its tets. Returns the slots
// without a tet.
std::vector<TetId> rename_vertices(std::span<TetSlot> slots, std::span<const VertexId> names,
                                   IdVector<VertexId, TetId>& tet_of) {
  std::vector<TetId> dead;
  for (std::size_t k = 0; k < slots.size(); ++k) {
    if (!slots[k].vertices[0].valid()) {
      dead.emplace_back(k);
      continue;
    }
    for (VertexId& v : slots[k].vertices) {
      if (v == kGhost) continue;
      v = names[v.index()];
      tet_of[v] = TetId(k);
    }
  }
  return dead;
}

struct AllTets {
  [[nodiscard]] static bool owns(const GrowingTets& /*tets*/, TetId /*t*/) { return true; }
};

}  // namespace

LiveTets::LiveTets() : inserter_(tets_), tet_of_(kAuxiliaries) {
  while (tets_.vertex_count() < kAuxiliaries) tets_.add_vertex({});
}

LiveTets::LiveTets(const LiveTets& other)
    : tets_(other.tets_),
      inserter_(tets_, other.inserter_),
      starts_(other.starts_),
      tet_of_(other.tet_of_),
      vertex_count_(other.vertex_count_),
      finite_tets_(other.finite_tets_),
      dimension_(other.dimension_) {}

void LiveTets::reserve(std::size_t vertices) {
  tet_of_.reserve(vertices + kAuxiliaries);
  tets_.reserve_vertices(vertices + kAuxiliaries);
}

void LiveTets::provide(VertexId place, const Point3& point) {
  if (place.index() < tet_of_.size()) {
    TETLOFT_CHECK(!tet_of_[place].valid());
    tets_.replace_vertex(place, point);
    return;
  }
  tet_of_.push_back(TetId());
  try {
    tets_.add_vertex(point);
  } catch (...) {
    tet_of_.resize(tet_of_.size() - 1);
    throw;
  }
}

VertexId LiveTets::insert(VertexId v, VertexId near) {
  const Point3 p = point(v);
  if (dimension_ < 3 && (vertex_count_ == 0 || !spans(p))) {
    std::vector<VertexId> all = live_points();
    all.push_back(v);
    build(all, {.threads = 1});
    return v;
  }
  inserter_.start_at(start(p, near));
  try {
    const TetId t = inserter_.locate(p);
    for (const VertexId u : tets_.tet(t)) {
      if (u != kGhost && point(u) == p) return u;
    }
    if (!inserter_.insert_at(v, t, delaunay3_detail::kMostTetSlots))
      throw std::length_error("2^30 tets or more");
  } catch (...) {
    tets_.unmark_all();
    throw;
  }
  note_inserted(v);
  return v;
}

void LiveTets::note_inserted(VertexId v) {
  for (const TetId t : inserter_.zone()) {
    finite_tets_ -= tets_.is_ghost(t) ? 0U : 1U;
    tets_.slot(t).vertices[0] = VertexId();
  }
  for (const Inserter::HorizonFacet& facet : inserter_.horizon()) {
    finite_tets_ += tets_.is_ghost(facet.filler) ? 0U : 1U;
    for (const VertexId u : tets_.tet(facet.filler)) {
      if (u != kGhost) tet_of_[u] = facet.filler;
    }
  }
  ++vertex_count_;
  if (starts_.is_outgrown(vertex_count_)) renew_starts();
  starts_.add(point(v), v);
}

// Without memory for it the old grid serves on.
void LiveTets::renew_starts() {
  try {
    StartGrid starts;
    starts.start_again({tets_.filter().low(), tets_.filter().high()}, vertex_count_);
    for (std::size_t k = kAuxiliaries; k < tet_of_.size(); ++k) {
      if (tet_of_[VertexId(k)].valid()) starts.add(point(VertexId(k)), VertexId(k));
    }
    starts_ = std::move(starts);
  } catch (const std::bad_alloc&) {
  }
}

std::vector<VertexId> LiveTets::live_points() const {
  std::vector<VertexId> result;
  result.reserve(vertex_count_ + 1);
  for (std::size_t k = kAuxiliaries; k < tet_of_.size(); ++k) {
    if (tet_of_[VertexId(k)].valid()) result.emplace_back(k);
  }
  return result;
}

void LiveTets::remove(VertexId v) {
  hole_.open(tets_, v, tet_of_[v]);
  if (keeps_dimension_without_open()) {
    const std::size_t before = count_finite(hole_.star());
    hole_.fill(tets_, inserter_, tet_of_);
    finite_tets_ = finite_tets_ - before + count_finite(hole_.filling());
    --vertex_count_;
    return;
  }
  std::vector<VertexId> others = live_points();
  others.erase(std::find(others.begin(), others.end(), v));
  build(others, {.threads = 1});
}

// A point that is no neighbour of the vertex has tets without it, which span what all did.
bool LiveTets::keeps_dimension_without_open() const {
  const auto is_neighbour = [](VertexId u) { return is_point(u); };
  const auto count = std::count_if(hole_.link().begin(), hole_.link().end(), is_neighbour);
  if (static_cast<std::size_t>(count) + 1 < vertex_count_) return true;
  std::vector<Point3> neighbours;
  for (const VertexId u : hole_.link()) {
    if (is_neighbour(u)) neighbours.push_back(point(u));
  }
  return delaunay3_detail::affine_basis(neighbours).dimension == dimension_;
}

std::size_t LiveTets::count_finite(std::span<const TetId> tets) const {
  return static_cast<std::size_t>(
      std::count_if(tets.begin(), tets.end(), [&](TetId t) { return !tets_.is_ghost(t); }));
}

// Where memory ends all tets are looked at, which needs none: the vertex must not be lost.
void LiveTets::rename(VertexId w, VertexId v) {
  const auto rename_in = [&](TetId t) {
    TetVertices& tet = tets_.slot(t).vertices;
    std::replace(tet.begin(), tet.end(), w, v);
  };
  try {
    hole_.open(tets_, w, tet_of_[w]);
    for (const TetId t : hole_.star()) rename_in(t);
  } catch (const std::bad_alloc&) {
    for (std::size_t k = 0; k < tets_.taken(); ++k) {
      if (is_live(TetId(k))) rename_in(TetId(k));
    }
  }
  tets_.replace_vertex(v, point(w));
  tet_of_[v] = tet_of_[w];
  tet_of_[w] = TetId();
  starts_.add(point(v), v);
}

void LiveTets::build(std::span<const VertexId> points, const Execution& execution) {
  // Those to be built of, by place: points first.
  std::vector<VertexId> vertices(points.begin(), points.end());
  std::vector<Point3> built_of;
  built_of.reserve(points.size() + kAuxiliaries);
  for (const VertexId v : points) built_of.push_back(point(v));
  const std::vector<Point3> spanning = spanning_points(built_of);
  const int dimension = static_cast<int>(spanning.size()) - 1;
  std::vector<Point3> auxiliaries;
  if (!points.empty() && dimension < 3) auxiliaries = auxiliary_points(spanning);
  for (const Point3& p : auxiliaries) {
    vertices.emplace_back(vertices.size() - points.size());
    built_of.push_back(p);
  }
  StartGrid starts;
  if (!points.empty()) {
    const predicates::SetFilter box(built_of);
    starts.start_again({box.low(), box.high()}, points.size());
  }
  for (const VertexId v : points) starts.add(point(v), v);
  delaunay3_detail::OwnedSlots slots;
  if (!points.empty()) slots = delaunay3_detail::batch_tets(std::move(built_of), execution);
  IdVector<VertexId, TetId> tet_of(tet_of_.size());
  std::vector<TetId> dead = rename_vertices(slots.all(), vertices, tet_of);
  const auto is_finite_slot = [](const TetSlot& slot) {
    return slot.vertices[0].valid() && slot.vertices[0] != kGhost;
  };
  const auto finite_count = static_cast<std::size_t>(
      std::count_if(slots.all().begin(), slots.all().end(), is_finite_slot));

  tets_.take_over(std::move(slots), filter_of_all(auxiliaries));
  // From here on nothing can fail.
  for (std::size_t k = 0; k < auxiliaries.size(); ++k) {
    tets_.replace_vertex(VertexId(k), auxiliaries[k]);
  }
  inserter_.start_again(std::move(dead));
  starts_ = std::move(starts);
  tet_of_ = std::move(tet_of);
  vertex_count_ = points.size();
  finite_tets_ = finite_count;
  dimension_ = dimension;
}

// Of what was provided and is yet to come too.
predicates::SetFilter LiveTets::filter_of_all(std::span<const Point3> auxiliaries) const {
  const std::size_t count = vertex_slots() - kAuxiliaries;
  return predicates::SetFilter(count + auxiliaries.size(), [&](std::size_t k) -> const Point3& {
    return k < count ? point(VertexId(k + kAuxiliaries)) : auxiliaries[k - count];
  });
}

TetId LiveTets::start(const Point3& p, VertexId near) const {
  const auto is_live_vertex = [&](VertexId v) { return is_live(v); };
  VertexId v = near.valid() && is_live(near) ? near : starts_.near(p, is_live_vertex);
  // Every grid's coarsest cell has the vertex that came last, which may be gone.
  for (std::size_t k = kAuxiliaries; !v.valid(); ++k) {
    TETLOFT_CHECK(k < tet_of_.size());
    if (tet_of_[VertexId(k)].valid()) v = VertexId(k);
  }
  return finite(tet_of_[v]);
}

TetId LiveTets::locate(const Point3& p, VertexId near) const {
  const predicates::SetFilter filter = tets_.filter().with(p);
  const auto is_beyond = [&](const TetVertices& tet, std::size_t i) {
    const TriangleVertices f = delaunay3_detail::facet_of(tet, i);
    const int s = filter.orient3d(point(f[0]), point(f[1]), point(f[2]), p);
    if (s != 0) return s > 0;
    return orient3d(point(f[0]), point(f[1]), point(f[2]), p) == Sign::positive;
  };
  std::uint32_t state = 1;
  return delaunay3_detail::walk(tets_, start(p, near), state, AllTets(), is_beyond);
}

// A tet has dimension + 1 points, affinely independent.
bool LiveTets::spans(const Point3& p) const {
  if (dimension_ == 3) return true;
  if (dimension_ < 0) return false;
  std::vector<Point3> basis;
  for (const VertexId v : tets_.tet(start(p, {}))) {
    if (is_point(v)) basis.push_back(point(v));
  }
  basis.push_back(p);
  return delaunay3_detail::affine_basis(basis).dimension == dimension_;
}

}  // namespace tetloft::internal::triangulation3

// The API boundary: handles to ids and back, checks at entry.
#include <tetloft/delaunay_triangulation3.hpp>

#include <algorithm>
#include <array>
#include <iterator>
#include <stdexcept>
#include <utility>

#include <tetloft/predicates.hpp>

#include "core/finite_points.hpp"
#include "core/guard.hpp"
#include "core/parallel.hpp"
#include "triangulation3/handles3.hpp"
#include "triangulation3/questions3.hpp"
#include "triangulation3/stars.hpp"

namespace tetloft {

using namespace internal;
using triangulation3::LiveTets;

const DelaunayTriangulation3::Impl& DelaunayTriangulation3::get() const {
  if (impl_) return *impl_;
  static const Impl empty;
  return empty;
}
DelaunayTriangulation3::Impl& DelaunayTriangulation3::own() {
  if (!impl_) impl_ = std::make_unique<Impl>();
  return *impl_;
}

DelaunayTriangulation3::DelaunayTriangulation3() = default;
DelaunayTriangulation3::DelaunayTriangulation3(const DelaunayTriangulation3& other)
    : impl_(other.impl_ ? std::make_unique<Impl>(*other.impl_) : nullptr) {}
DelaunayTriangulation3::DelaunayTriangulation3(DelaunayTriangulation3&& other) noexcept = default;
DelaunayTriangulation3& DelaunayTriangulation3::operator=(const DelaunayTriangulation3& other) {
  if (this != &other) *this = DelaunayTriangulation3(other);
  return *this;
}
DelaunayTriangulation3& DelaunayTriangulation3::operator=(DelaunayTriangulation3&& other) noexcept =
    default;
DelaunayTriangulation3::~DelaunayTriangulation3() = default;
void swap(DelaunayTriangulation3& a, DelaunayTriangulation3& b) noexcept {
  std::swap(a.impl_, b.impl_);
}

Result<DelaunayTriangulation3> DelaunayTriangulation3::of(std::span<const Point3> points,
                                                          const Execution& execution) {
  return guard_threads(execution, [&](const Execution& own) -> Result<DelaunayTriangulation3> {
    if (Result<void> fit = fp_self_check(); !fit) return fit.error();
    if (Result<void> fine = triangulation3::check_points(points); !fine) return fine.error();
    DelaunayTriangulation3 result;
    if (!points.empty()) (void)result.own().take_all(points, own);
    return result;
  });
}

Result<DelaunayTriangulation3::Insertion> DelaunayTriangulation3::insert(const Point3& point,
                                                                         DelaunayVertex near) {
  return guard_internal([&]() -> Result<Insertion> {
    if (Result<void> fine = check_finite(point); !fine) return fine.error();
    Impl& impl = own();
    return impl.insert(point, impl.hint(near));
  });
}

// Along the order of many at once: near ones follow each other, and each search starts at the last.
Result<std::vector<DelaunayVertex>> DelaunayTriangulation3::insert(std::span<const Point3> points,
                                                                   const Execution& execution) {
  return guard_threads(execution, [&](const Execution& own) -> Result<std::vector<DelaunayVertex>> {
    if (Result<void> fine = triangulation3::check_points(points); !fine) return fine.error();
    if (vertex_slots() != 0) return impl_->insert_all(points, own);
    auto made = std::make_unique<Impl>();
    std::vector<DelaunayVertex> result;
    for (const VertexId v : made->take_all(points, own)) result.push_back(made->handle(v));
    impl_ = std::move(made);
    return result;
  });
}

Result<void> DelaunayTriangulation3::remove(DelaunayVertex v) {
  return guard_internal([&]() -> Result<void> {
    if (!is_live(v)) return no_such_vertex(v);
    impl_->remove(impl_->id(v));
    return {};
  });
}

// The vertex is inserted at its new place under another name, which it loses again.
Result<void> DelaunayTriangulation3::move(DelaunayVertex v, const Point3& to) {
  return guard_internal([&]() -> Result<void> {
    if (!is_live(v)) return no_such_vertex(v);
    if (Result<void> fine = check_finite(to); !fine) return fine.error();
    const VertexId id = impl_->id(v);
    if (impl_->tets.point(id) == to) return {};
    const VertexId moved = impl_->provide(to);
    const VertexId found = impl_->tets.insert(moved, id);
    if (found != moved) {
      Error error{ErrorCode::invalid_input, "there is another vertex", {}};
      error.where.vertex = impl_->handle(found).index;
      error.where.point = to;
      return error;
    }
    // A vertex until it is removed again: its place is free then, and finds its room.
    impl_->places.take();
    try {
      impl_->tets.remove(id);
    } catch (...) {
      impl_->tets.remove(moved);
      impl_->give_back({&moved, 1});
      throw;
    }
    impl_->tets.rename(moved, id);
    impl_->give_back({&moved, 1});
    return {};
  });
}

void DelaunayTriangulation3::clear() { impl_.reset(); }

int DelaunayTriangulation3::dimension() const { return get().tets.dimension(); }
std::size_t DelaunayTriangulation3::vertex_count() const { return get().tets.vertex_count(); }
std::size_t DelaunayTriangulation3::vertex_slots() const { return get().places.size(); }
std::size_t DelaunayTriangulation3::tet_count() const { return get().tets.tet_count(); }
std::size_t DelaunayTriangulation3::tet_slots() const {
  return dimension() < 3 ? 0 : get().tets.tet_slots();
}
bool DelaunayTriangulation3::is_live(DelaunayVertex v) const { return get().is_live(v); }
bool DelaunayTriangulation3::is_live(TetId t) const {
  return dimension() == 3 && get().tets.is_finite(t);
}

DelaunayVertex DelaunayTriangulation3::vertex_at(std::size_t index) const {
  const Impl& impl = get();
  if (index >= impl.places.size()) throw std::out_of_range("no such place of a vertex");
  const VertexId v = triangulation3::id_of_place(index);
  return impl.tets.is_live(v) ? impl.handle(v) : DelaunayVertex();
}

TetId DelaunayTriangulation3::tet_at(std::size_t slot) const {
  if (slot >= tet_slots()) throw std::out_of_range("no such place of a tet");
  return get().tets.is_finite(TetId(slot)) ? TetId(slot) : TetId();
}

const Point3& DelaunayTriangulation3::point(DelaunayVertex v) const {
  return get().tets.point(get().id(v));
}

std::array<DelaunayVertex, 4> DelaunayTriangulation3::vertices(TetId t) const {
  const Impl& impl = get();
  const TetVertices& tet = impl.tet(t);
  return {impl.handle(tet[0]), impl.handle(tet[1]), impl.handle(tet[2]), impl.handle(tet[3])};
}

std::array<DelaunayVertex, 3> DelaunayTriangulation3::vertices(HalfFaceId h) const {
  const Impl& impl = get();
  const TriangleVertices facet =
      delaunay3_detail::facet_of(impl.tet(TetMesh::tet_of(h)), h.index() & 3);
  return {impl.handle(facet[0]), impl.handle(facet[1]), impl.handle(facet[2])};
}

HalfFaceId DelaunayTriangulation3::opposite(HalfFaceId h) const {
  const Impl& impl = get();
  (void)impl.tet(TetMesh::tet_of(h));
  const HalfFaceId across = impl.tets.tets().opposite(h);
  return impl.tets.tets().is_ghost(TetMesh::tet_of(across)) ? HalfFaceId() : across;
}

LiveRange<DelaunayTriangulation3, DelaunayVertex> DelaunayTriangulation3::vertices() const {
  return LiveRange<DelaunayTriangulation3, DelaunayVertex>(*this);
}
LiveRange<DelaunayTriangulation3, TetId> DelaunayTriangulation3::tets() const {
  return LiveRange<DelaunayTriangulation3, TetId>(*this);
}

std::vector<HalfFaceId> DelaunayTriangulation3::hull() const {
  std::vector<HalfFaceId> result;
  for (const TetId t : tets()) {
    for (std::size_t i = 0; i < 4; ++i) {
      const HalfFaceId h = triangulation3::half_face(t, i);
      if (!opposite(h).valid()) result.push_back(h);
    }
  }
  return result;
}

std::vector<TetId> DelaunayTriangulation3::star(DelaunayVertex v) const {
  const Impl& impl = get();
  const VertexId id = impl.id(v);
  std::vector<TetId> result;
  if (dimension() < 3) return result;
  for (const TetId t : triangulation3::star_of(impl.tets, id)) {
    if (impl.tets.is_finite(t)) result.push_back(t);
  }
  std::sort(result.begin(), result.end());
  return result;
}

std::vector<DelaunayVertex> DelaunayTriangulation3::neighbours(DelaunayVertex v) const {
  const Impl& impl = get();
  std::vector<DelaunayVertex> result;
  for (const VertexId u : triangulation3::neighbours_of(impl.tets, impl.id(v))) {
    result.push_back(impl.handle(u));
  }
  std::sort(result.begin(), result.end());
  return result;
}

bool DelaunayTriangulation3::is_on_hull(DelaunayVertex v) const {
  const Impl& impl = get();
  const VertexId id = impl.id(v);
  if (dimension() < 3) return true;
  const std::vector<TetId> star = triangulation3::star_of(impl.tets, id);
  return std::any_of(star.begin(), star.end(),
                     [&](TetId t) { return impl.tets.tets().is_ghost(t); });
}

EdgeRing DelaunayTriangulation3::ring(DelaunayVertex u, DelaunayVertex v) const {
  const Impl& impl = get();
  const VertexId from = impl.id(u);
  const VertexId to = impl.id(v);
  EdgeRing result;
  if (dimension() < 3 || from == to) return result;
  std::vector<TetId> ring = triangulation3::ring_of(impl.tets, from, to);
  // The ghosts follow each other: what comes behind them is first.
  const auto is_ghost = [&](TetId t) { return impl.tets.tets().is_ghost(t); };
  const auto ghost = std::find_if(ring.begin(), ring.end(), is_ghost);
  result.closed = ghost == ring.end() && !ring.empty();
  std::rotate(ring.begin(), ghost == ring.end() ? ring.begin() : ghost, ring.end());
  std::copy_if(ring.begin(), ring.end(), std::back_inserter(result.tets),
               [&](TetId t) { return !is_ghost(t); });
  return result;
}

// Each edge by its lower end.
std::vector<std::array<DelaunayVertex, 2>> DelaunayTriangulation3::edges() const {
  std::vector<std::array<DelaunayVertex, 2>> result;
  for (const DelaunayVertex v : vertices()) {
    for (const DelaunayVertex u : neighbours(v)) {
      if (v < u) result.push_back({v, u});
    }
  }
  return result;
}

// Of the tets, auxiliary vertices left out.
std::vector<std::array<DelaunayVertex, 3>> DelaunayTriangulation3::facets() const {
  const Impl& impl = get();
  std::vector<std::array<DelaunayVertex, 3>> result;
  const auto add = [&](const TriangleVertices& facet) {
    if (!std::all_of(facet.begin(), facet.end(), LiveTets::is_point)) return;
    std::array<DelaunayVertex, 3> handles{impl.handle(facet[0]), impl.handle(facet[1]),
                                          impl.handle(facet[2])};
    std::sort(handles.begin(), handles.end());
    result.push_back(handles);
  };
  for (std::size_t k = 0; k < impl.tets.tet_slots(); ++k) {
    const TetId t(k);
    if (!impl.tets.is_finite(t)) continue;
    for (std::size_t i = 0; i < 4; ++i) {
      const HalfFaceId h = triangulation3::half_face(t, i);
      const HalfFaceId across = impl.tets.tets().opposite(h);
      // Once: on the hull, or from the lower side.
      if (!impl.tets.tets().is_ghost(TetMesh::tet_of(across)) && across < h) continue;
      add(delaunay3_detail::facet_of(impl.tets.tets().tet(t), i));
    }
  }
  std::sort(result.begin(), result.end());
  return result;
}

}  // namespace tetloft

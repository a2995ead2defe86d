// The API boundary: handles to places and back, checks at entry.
#include <tetloft/delaunay_triangulation2.hpp>

#include <algorithm>
#include <array>
#include <stdexcept>
#include <utility>

#include <tetloft/predicates.hpp>

#include "core/finite_points.hpp"
#include "core/guard.hpp"
#include "core/parallel.hpp"
#include "core/watched_work.hpp"
#include "delaunay2/spatial_order.hpp"
#include "triangulation2/edges_of_plane.hpp"
#include "triangulation2/handles2.hpp"

namespace tetloft {

using namespace internal;
using triangulation2::HalfEdgeId;
using triangulation2::Incremental2;
using triangulation2::SiteId;

namespace {

// So many points between two looks at the stop token.
constexpr std::size_t kPointsOfLook2 = 4096;

// Around the ghost the hull is met clockwise, as the plane is seen from outside.
template <class Use>
void for_each_on_hull(const Incremental2& plane, Use&& use) {
  const HalfEdgeId first = plane.out(Incremental2::kGhost);
  HalfEdgeId h = first;
  do {
    use(plane.destination(h));
    h = plane.rotate_back(h);
  } while (h != first);
}

}  // namespace

const DelaunayTriangulation2::Impl& DelaunayTriangulation2::get() const {
  if (impl_) return *impl_;
  static const Impl empty;
  return empty;
}
DelaunayTriangulation2::Impl& DelaunayTriangulation2::own() {
  if (!impl_) impl_ = std::make_unique<Impl>();
  return *impl_;
}

DelaunayTriangulation2::DelaunayTriangulation2() = default;
DelaunayTriangulation2::DelaunayTriangulation2(const DelaunayTriangulation2& other)
    : impl_(other.impl_ ? std::make_unique<Impl>(*other.impl_) : nullptr) {}
DelaunayTriangulation2::DelaunayTriangulation2(DelaunayTriangulation2&& other) noexcept = default;
DelaunayTriangulation2& DelaunayTriangulation2::operator=(const DelaunayTriangulation2& other) {
  if (this != &other) *this = DelaunayTriangulation2(other);
  return *this;
}
DelaunayTriangulation2& DelaunayTriangulation2::operator=(DelaunayTriangulation2&& other) noexcept =
    default;
DelaunayTriangulation2::~DelaunayTriangulation2() = default;
void swap(DelaunayTriangulation2& a, DelaunayTriangulation2& b) noexcept {
  std::swap(a.impl_, b.impl_);
}

Result<DelaunayTriangulation2> DelaunayTriangulation2::of(std::span<const Point2> points,
                                                          const Execution& execution) {
  return guard_threads(execution, [&](const Execution& own) -> Result<DelaunayTriangulation2> {
    if (Result<void> fit = fp_self_check(); !fit) return fit.error();
    if (Result<void> fine = triangulation2::check_points(points); !fine) return fine.error();
    DelaunayTriangulation2 result;
    if (!points.empty()) (void)result.own().take_all(points, own);
    return result;
  });
}

Result<DelaunayTriangulation2::Insertion> DelaunayTriangulation2::insert(const Point2& point,
                                                                         DelaunayVertex near) {
  return guard_internal([&]() -> Result<Insertion> {
    if (Result<void> fine = check_finite(point); !fine) return fine.error();
    Impl& impl = own();
    return impl.insert(point, impl.hint(near));
  });
}

Result<std::vector<DelaunayVertex>> DelaunayTriangulation2::insert(std::span<const Point2> points,
                                                                   const Execution& execution) {
  return guard_internal([&]() -> Result<std::vector<DelaunayVertex>> {
    if (Result<void> fine = triangulation2::check_points(points); !fine) return fine.error();
    if (constraint_count() != 0) {
      // What was divided is not joined again: a copy can be let go.
      auto copy = std::make_unique<Impl>(*impl_);
      std::vector<DelaunayVertex> handles = copy->insert_all(points, execution);
      impl_ = std::move(copy);
      return handles;
    }
    if (vertex_slots() != 0) return impl_->insert_all(points, execution);
    auto made = std::make_unique<Impl>();
    std::vector<DelaunayVertex> result;
    for (const VertexId v : made->take_all(points, execution)) result.push_back(made->handle(v));
    impl_ = std::move(made);
    return result;
  });
}

std::vector<DelaunayVertex> DelaunayTriangulation2::Impl::insert_all(std::span<const Point2> points,
                                                                     const Execution& execution) {
  WatchedWork work(execution, points.size() / kPointsOfLook2 + 1);
  work.go_on();
  std::vector<DelaunayVertex> handles(points.size());
  std::vector<VertexId> inserted;
  inserted.reserve(points.size());
  provide_room(places.free, points.size());
  try {
    VertexId last;
    std::size_t done = 0;
    for (const std::uint32_t i : delaunay2_detail::insertion_order(points)) {
      const Insertion made = insert(points[i], last);
      handles[i] = made.vertex;
      last = VertexId(made.vertex.index);
      if (made.is_new) inserted.push_back(last);
      if (++done % kPointsOfLook2 == 0) work.step_done_go_on();
    }
  } catch (...) {
    // Nobody has seen these handles: their generations do not grow.
    for (std::size_t k = inserted.size(); k-- > 0;) {
      plane.remove(inserted[k]);
      places.give_back(inserted[k].index());
    }
    throw;
  }
  work.step_done();
  return handles;
}

Result<void> DelaunayTriangulation2::remove(DelaunayVertex v) {
  return guard_internal([&]() -> Result<void> {
    if (!is_live(v)) return no_such_vertex(v);
    if (Result<void> free = impl_->check_free(impl_->id(v)); !free) return free;
    impl_->remove(impl_->id(v));
    return {};
  });
}

// The vertex is inserted at its new place under another name, which it loses again.
Result<void> DelaunayTriangulation2::move(DelaunayVertex v, const Point2& to) {
  return guard_internal([&]() -> Result<void> {
    if (!is_live(v)) return no_such_vertex(v);
    if (Result<void> fine = check_finite(to); !fine) return fine.error();
    const VertexId id = impl_->id(v);
    if (impl_->plane.point(id) == to) return {};
    if (Result<void> free = impl_->check_free(id); !free) return free;
    const VertexId moved = impl_->provide(to);
    const VertexId found = impl_->plane.insert(moved, id);
    if (found != moved) {
      Error error{ErrorCode::invalid_input, "there is another vertex", {}};
      error.where.vertex = impl_->handle(found).index;
      error.where.point = Point3{to.x, to.y, 0};
      return error;
    }
    // A vertex until it is removed again: its place is free then, and finds its room.
    impl_->places.take();
    try {
      impl_->plane.remove(id);
    } catch (...) {
      if (impl_->plane.wall_of(moved) == nullptr) {
        impl_->plane.remove(moved);
        impl_->places.give_back(moved.index());
      }
      throw;
    }
    impl_->plane.rename(moved, id);
    impl_->places.give_back(moved.index());
    return {};
  });
}

void DelaunayTriangulation2::clear() { impl_.reset(); }

int DelaunayTriangulation2::dimension() const { return get().plane.dimension(); }
std::size_t DelaunayTriangulation2::vertex_count() const { return get().plane.vertex_count(); }
std::size_t DelaunayTriangulation2::vertex_slots() const { return get().places.size(); }
std::size_t DelaunayTriangulation2::triangle_slots() const {
  return dimension() < 2 ? 0 : get().plane.triangles().triangle_count();
}
bool DelaunayTriangulation2::is_live(DelaunayVertex v) const { return get().is_live(v); }
bool DelaunayTriangulation2::is_live(TriangleId t) const { return get().is_live(t); }

// The other ones are one ghost for each edge of the hull.
std::size_t DelaunayTriangulation2::triangle_count() const {
  std::size_t count = triangle_slots();
  if (count != 0) for_each_on_hull(get().plane.triangles(), [&](SiteId) { --count; });
  return count;
}

DelaunayVertex DelaunayTriangulation2::vertex_at(std::size_t index) const {
  const Impl& impl = get();
  if (index >= impl.places.size()) throw std::out_of_range("no such place of a vertex");
  return impl.plane.is_live(VertexId(index)) ? impl.handle(VertexId(index)) : DelaunayVertex();
}

TriangleId DelaunayTriangulation2::triangle_at(std::size_t slot) const {
  if (slot >= triangle_slots()) throw std::out_of_range("no such place of a triangle");
  return is_live(TriangleId(slot)) ? TriangleId(slot) : TriangleId();
}

const Point2& DelaunayTriangulation2::point(DelaunayVertex v) const {
  return get().plane.point(get().id(v));
}

std::array<DelaunayVertex, 3> DelaunayTriangulation2::vertices(TriangleId t) const {
  const Impl& impl = get();
  impl.check(t);
  const std::array<SiteId, 3>& v = impl.plane.triangles().vertices(t);
  return {impl.handle(v[0]), impl.handle(v[1]), impl.handle(v[2])};
}

std::array<TriangleId, 3> DelaunayTriangulation2::neighbours(TriangleId t) const {
  const Impl& impl = get();
  impl.check(t);
  std::array<TriangleId, 3> result;
  for (std::uint32_t i = 0; i < 3; ++i) {
    const TriangleId across =
        Incremental2::triangle(impl.plane.triangles().opposite(Incremental2::half_edge(t, i)));
    if (!impl.plane.triangles().is_ghost(across)) result[i] = across;
  }
  return result;
}

LiveRange<DelaunayTriangulation2, DelaunayVertex> DelaunayTriangulation2::vertices() const {
  return LiveRange<DelaunayTriangulation2, DelaunayVertex>(*this);
}
LiveRange<DelaunayTriangulation2, TriangleId> DelaunayTriangulation2::triangles() const {
  return LiveRange<DelaunayTriangulation2, TriangleId>(*this);
}

std::vector<DelaunayVertex> DelaunayTriangulation2::hull() const {
  const Impl& impl = get();
  std::vector<DelaunayVertex> result;
  if (dimension() < 2) {
    for (const VertexId v : impl.plane.row()) result.push_back(impl.handle(v));
    return result;
  }
  for_each_on_hull(impl.plane.triangles(), [&](SiteId s) { result.push_back(impl.handle(s)); });
  std::rotate(result.begin(), std::min_element(result.begin(), result.end()), result.end());
  return result;
}

std::vector<TriangleId> DelaunayTriangulation2::star(DelaunayVertex v) const {
  const Impl& impl = get();
  const VertexId id = impl.id(v);
  std::vector<TriangleId> result;
  if (dimension() < 2) return result;
  const Incremental2& plane = impl.plane.triangles();
  const HalfEdgeId first = plane.out(impl.plane.site(id));
  HalfEdgeId h = first;
  do {
    const TriangleId t = Incremental2::triangle(h);
    if (!plane.is_ghost(t)) result.push_back(t);
    h = plane.rotate(h);
  } while (h != first);
  std::sort(result.begin(), result.end());
  return result;
}

std::vector<DelaunayVertex> DelaunayTriangulation2::neighbours(DelaunayVertex v) const {
  const Impl& impl = get();
  std::vector<DelaunayVertex> result;
  triangulation2::EdgesOfPlane(impl.plane).for_each_neighbour(impl.id(v), [&](VertexId u) {
    result.push_back(impl.handle(u));
    return true;
  });
  std::sort(result.begin(), result.end());
  return result;
}

std::array<TriangleId, 2> DelaunayTriangulation2::triangles(DelaunayVertex u,
                                                            DelaunayVertex v) const {
  const Impl& impl = get();
  const VertexId from = impl.id(u), to = impl.id(v);
  if (dimension() < 2) return {};
  const Incremental2& plane = impl.plane.triangles();
  const HalfEdgeId h = plane.find_edge(impl.plane.site(from), impl.plane.site(to));
  if (!h.valid()) return {};
  std::array<TriangleId, 2> sides{Incremental2::triangle(h),
                                  Incremental2::triangle(plane.opposite(h))};
  for (TriangleId& t : sides) t = plane.is_ghost(t) ? TriangleId() : t;
  return sides;
}

bool DelaunayTriangulation2::is_on_hull(DelaunayVertex v) const {
  const Impl& impl = get();
  const VertexId id = impl.id(v);
  if (dimension() < 2) return true;
  const Incremental2& plane = impl.plane.triangles();
  const HalfEdgeId first = plane.out(impl.plane.site(id));
  HalfEdgeId h = first;
  do {
    if (plane.destination(h) == Incremental2::kGhost) return true;
    h = plane.rotate(h);
  } while (h != first);
  return false;
}

// Each edge by its lower end.
std::vector<std::array<DelaunayVertex, 2>> DelaunayTriangulation2::edges() const {
  std::vector<std::array<DelaunayVertex, 2>> result;
  for (const DelaunayVertex v : vertices()) {
    for (const DelaunayVertex u : neighbours(v)) {
      if (v < u) result.push_back({v, u});
    }
  }
  return result;
}

}  // namespace tetloft

#include "triangulation2/live_plane.hpp"

#include <algorithm>
#include <array>
#include <limits>
#include <new>
#include <stdexcept>
#include <utility>

#include <tetloft/predicates.hpp>

#include "core/guard.hpp"
#include "core/pages.hpp"
#include "core/provide_room.hpp"
#include "core/watched_work.hpp"
#include "delaunay2/start.hpp"
#include "spatial/sort_by_key.hpp"
#include "triangulation2/edges_of_plane.hpp"

namespace tetloft::internal::triangulation2 {

namespace {

// Who goes over a wall is known by its edge.
constexpr delaunay2_detail::LabelId kWall{0};

Point3 in_space(const Point2& p) { return {p.x, p.y, 0}; }

std::array<Point3, 2> box_of(std::span<const Point2> points) {
  constexpr double inf = std::numeric_limits<double>::infinity();
  std::array<Point3, 2> box{Point3{inf, inf, 0}, Point3{-inf, -inf, 0}};
  for (const Point2& p : points) {
    box[0] = {std::min(box[0].x, p.x), std::min(box[0].y, p.y), 0};
    box[1] = {std::max(box[1].x, p.x), std::max(box[1].y, p.y), 0};
  }
  return box;
}

}  // namespace

int LivePlane::dimension() const {
  if (plane_) return 2;
  return static_cast<int>(std::min<std::size_t>(row_.size(), 2)) - 1;
}

void LivePlane::provide(VertexId place, const Point2& point) {
  if (place.index() < points_.size()) {
    TETLOFT_CHECK(!site_of_[place].valid());
    points_[place] = point;
    return;
  }
  provide_room(points_.raw(), 1);
  provide_room(site_of_.raw(), 1);
  points_.push_back(point);
  site_of_.push_back(SiteId());
}

VertexId LivePlane::insert(VertexId v, VertexId near) {
  const Point2 p = point(v);
  if (!plane_) return insert_into_row(v);
  if (vertex_of_.size() <= plane_->vertex_count()) {
    provide_room(vertex_of_.raw(), 1);
    vertex_of_.push_back({});
  }
  if (plane_->vertex_count() >= Incremental2::kMostVertices) throw std::length_error("2^29 points");
  const SiteId from = start(p, near);
  Walls::Division division;
  if (!walls_.empty()) division = division_of(from, v);
  const SiteId site = plane_->insert(p, from);
  if (vertex_of_[site].valid()) return vertex_of_[site];
  walls_.divide(division);
  vertex_of_[site] = v;
  site_of_[v] = site;
  ++vertex_count_;
  note_start(v);
  return v;
}

// Prepared, for afterwards there may be no memory.
Walls::Division LivePlane::division_of(SiteId near, VertexId v) {
  const HalfEdgeId wall = plane_->wall_at(point(v), plane_->locate(point(v), near));
  if (!wall.valid()) return {};
  return walls_.prepare(vertex_of_[plane_->origin(wall)], vertex_of_[plane_->destination(wall)], v);
}

std::size_t LivePlane::place_in_row(const Point2& p) const {
  const auto at = std::lower_bound(row_.begin(), row_.end(), p, [&](VertexId u, const Point2& q) {
    return canonical_less(point(u), q);
  });
  return static_cast<std::size_t>(at - row_.begin());
}

bool LivePlane::is_in_row(const Point2& p) const {
  return row_.size() < 2 || orient2d(point(row_.front()), point(row_.back()), p) == Sign::zero;
}

VertexId LivePlane::insert_into_row(VertexId v) {
  const Point2 p = point(v);
  const std::size_t at = place_in_row(p);
  if (at < row_.size() && point(row_[at]) == p) return row_[at];
  if (is_in_row(p)) {
    Walls::Division division;
    if (at > 0 && at < row_.size() && walls_.find(row_[at - 1], row_[at]) != nullptr) {
      division = walls_.prepare(row_[at - 1], row_[at], v);
    }
    row_.insert(row_.begin() + static_cast<std::ptrdiff_t>(at), v);
    site_of_[v] = Incremental2::kGhost;
    ++vertex_count_;
    walls_.divide(division);
    return v;
  }
  std::vector<VertexId> all = row_;
  all.push_back(v);
  (void)build(all, {.threads = 1});
  return v;
}

void LivePlane::remove(VertexId v) {
  if (!plane_) {
    row_.erase(row_.begin() + static_cast<std::ptrdiff_t>(place_in_row(point(v))));
  } else if (spans_plane_without(v)) {
    const SiteId site = site_of_[v];
    plane_->remove(site);
    vertex_of_[site] = VertexId();
  } else {
    std::vector<VertexId> others = live_vertices();
    others.erase(std::find(others.begin(), others.end(), v));
    (void)build(others, {.threads = 1});
    return;
  }
  site_of_[v] = SiteId();
  --vertex_count_;
}

// A point that is no neighbour of v has a triangle without v.
bool LivePlane::spans_plane_without(VertexId v) const {
  const EdgesOfPlane edges(*this);
  std::size_t neighbours = 0;
  edges.for_each_neighbour(v, [&](VertexId /*u*/) { return ++neighbours != 0; });
  if (neighbours + 1 < vertex_count_) return true;
  std::vector<Point2> basis;
  bool spans = false;
  edges.for_each_neighbour(v, [&](VertexId u) {
    if (basis.size() < 2) {
      basis.push_back(point(u));
    } else {
      spans = orient2d(basis[0], basis[1], point(u)) != Sign::zero;
    }
    return !spans;
  });
  return spans;
}

std::vector<VertexId> LivePlane::live_vertices() const {
  std::vector<VertexId> result;
  for (const VertexId v : site_of_.ids()) {
    if (site_of_[v].valid()) result.push_back(v);
  }
  return result;
}

void LivePlane::rename(VertexId w, VertexId v) {
  EdgesOfPlane(*this).for_each_neighbour(w, [&](VertexId u) {
    walls_.rename(w, v, u);
    return true;
  });
  points_[v] = points_[w];
  site_of_[v] = site_of_[w];
  site_of_[w] = SiteId();
  if (plane_) {
    vertex_of_[site_of_[v]] = v;
    starts_.add(in_space(point(v)), v);
  } else {
    row_[place_in_row(point(v))] = v;
  }
}

std::vector<VertexId> LivePlane::build(std::span<const VertexId> points,
                                       const Execution& execution) {
  std::vector<Point2> built_of;
  built_of.reserve(points.size());
  for (const VertexId v : points) built_of.push_back(point(v));
  WatchedWork work(execution, delaunay2_detail::steps_of(built_of) + 1);
  delaunay2_detail::Start start = delaunay2_detail::triangulate(built_of, work);
  std::vector<VertexId> vertex_of_point(points.begin(), points.end());
  std::vector<VertexId> row;
  IdVector<SiteId, VertexId> vertex_of;
  IdVector<VertexId, SiteId> site_of(site_of_.size());
  StartGrid starts;
  std::size_t count = 0;
  if (start.plane) {
    vertex_of.resize(start.plane->vertex_count());
    starts.start_again(box_of(built_of), start.plane->vertex_count());
    for (std::size_t i = 0; i < points.size(); ++i) {
      const SiteId site = start.site_of[PlaneVertexId(i)];
      const VertexId v = points[start.input_of[site].index()];
      vertex_of_point[i] = v;
      if (v != points[i]) continue;
      vertex_of[site] = v;
      site_of[v] = site;
      starts.add(in_space(built_of[i]), v);
      ++count;
    }
  } else {
    std::vector<Keyed> order(points.size());
    for (std::uint32_t i = 0; i < points.size(); ++i) order[i].place = i;
    sort_canonically(order, [&](std::uint32_t i) { return built_of[i]; });
    for (const Keyed& k : order) {
      if (row.empty() || point(row.back()) != built_of[k.place]) row.push_back(points[k.place]);
      vertex_of_point[k.place] = row.back();
      site_of[row.back()] = Incremental2::kGhost;
    }
    count = row.size();
  }
  if (start.plane) {
    start.plane->respect_labels();
    // Of what was a row: all its edges are there.
    for (const PlaneWall& wall : walls_.all()) {
      start.plane->make_wall(site_of[wall.edge()[0]], site_of[wall.edge()[1]], kWall);
    }
  }
  work.step_done();
  // From here on nothing can fail.
  plane_ = std::move(start.plane);
  vertex_of_ = std::move(vertex_of);
  site_of_ = std::move(site_of);
  row_ = std::move(row);
  starts_ = std::move(starts);
  vertex_count_ = count;
  return vertex_of_point;
}

const PlaneWall* LivePlane::wall_of(VertexId v) const {
  const PlaneWall* result = nullptr;
  if (walls_.empty()) return result;
  EdgesOfPlane(*this).for_each_neighbour(v, [&](VertexId u) {
    result = walls_.find(v, u);
    return result == nullptr;
  });
  return result;
}

LivePlane::Step LivePlane::step(VertexId a, VertexId b) const {
  if (!plane_) {
    const std::size_t at = place_in_row(point(a));
    return {canonical_less(point(a), point(b)) ? row_[at + 1] : row_[at - 1], {}};
  }
  const Incremental2::Passage passage = plane_->passage(site_of_[a], site_of_[b]);
  Step result{vertex_of_[passage.reached], {}};
  if (passage.wall.valid()) {
    result.crossed = {vertex_of_[plane_->origin(passage.wall)],
                      vertex_of_[plane_->destination(passage.wall)]};
  }
  return result;
}

void LivePlane::add_to_edge(VertexId a, VertexId b, std::span<const ConstraintId> over) {
  const bool is_new = walls_.find(a, b) == nullptr;
  walls_.add(a, b, over);
  if (!plane_ || !is_new) return;
  try {
    plane_->make_wall(site_of_[a], site_of_[b], kWall);
  } catch (...) {
    walls_.remove(a, b);
    throw;
  }
}

void LivePlane::take_from_edge(VertexId a, VertexId b, ConstraintId c) {
  if (walls_.take(a, b, c) && plane_) plane_->remove_wall(site_of_[a], site_of_[b]);
}

std::vector<ConstraintId> LivePlane::open_edge(VertexId a, VertexId b) {
  std::vector<ConstraintId> over = walls_.find(a, b)->constraints();
  walls_.remove(a, b);
  if (plane_) plane_->remove_wall(site_of_[a], site_of_[b]);
  return over;
}

// Without memory for a finer grid the old one serves on.
void LivePlane::note_start(VertexId v) {
  if (starts_.is_outgrown(vertex_count_)) {
    try {
      std::vector<Point2> live;
      const std::vector<VertexId> vertices = live_vertices();
      for (const VertexId u : vertices) live.push_back(point(u));
      StartGrid starts;
      starts.start_again(box_of(live), vertices.size());
      core::release(live);
      for (const VertexId u : vertices) starts.add(in_space(point(u)), u);
      starts_ = std::move(starts);
    } catch (const std::bad_alloc&) {
    }
  }
  starts_.add(in_space(point(v)), v);
}

SiteId LivePlane::start(const Point2& p, VertexId near) const {
  const auto is_live_vertex = [&](VertexId v) { return is_live(v); };
  VertexId v = near.valid() && is_live(near) ? near : starts_.near(in_space(p), is_live_vertex);
  if (v.valid()) return site_of_[v];
  // The coarsest cell has the vertex that came last, which is gone: any that the ghost meets.
  return plane_->destination(plane_->out(Incremental2::kGhost));
}

}  // namespace tetloft::internal::triangulation2

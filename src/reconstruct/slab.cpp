#include "reconstruct/slab.hpp"

#include <algorithm>
#include <string>

#include "core/check.hpp"
#include "reconstruct/work_limit.hpp"

namespace tetloft {

namespace {

// The section that shows best why there are so many tets has the most vertices; its first one
// is the place.
Error too_much_work(SlabId id, const ConformingSection& lower, const ConformingSection& upper,
                    std::size_t most_tets) {
  Place place;
  place.slab = id.index();
  const bool below = lower.vertex_count() >= upper.vertex_count();
  place.point = (below ? lower : upper).point3(VertexId(0));
  return {ErrorCode::work_limit,
          "the Delaunay triangulation of " +
              std::to_string(lower.vertex_count() + upper.vertex_count()) +
              " vertices takes more than " + std::to_string(most_tets) +
              " tets, the work limit, as it does where round contours of many vertices lie about "
              "different centres: take fewer vertices to a contour, or raise the limit",
          place};
}

Result<TetMesh> delaunay_of(const ConformingSection& lower, const ConformingSection& upper,
                            DelaunayEngine engine, std::size_t most_tets) {
  if (engine != DelaunayEngine::incremental) {
    return slab_delaunay3(lower.triangulation, upper.triangulation, most_tets);
  }
  std::vector<Point3> points;
  points.reserve(lower.vertex_count() + upper.vertex_count());
  for (std::size_t i = 0; i < lower.vertex_count(); ++i)
    points.push_back(lower.point3(VertexId(i)));
  for (std::size_t i = 0; i < upper.vertex_count(); ++i)
    points.push_back(upper.point3(VertexId(i)));
  Result<Delaunay3> d = delaunay3(points, {.engine = engine, .most_tets = most_tets});
  if (!d) return d.error();
  TETLOFT_CHECK(d->dimension == 3 && d->duplicates == 0);
  return std::move(d->mesh);
}

}  // namespace

Result<TetMesh> slab_delaunay(SlabId id, const ConformingSection& lower,
                              const ConformingSection& upper, DelaunayEngine engine,
                              double work_limit) {
  const std::size_t most_tets = most_work(work_limit, lower.vertex_count() + upper.vertex_count());
  Result<TetMesh> d = delaunay_of(lower, upper, engine, most_tets);
  if (d || d.error().code != ErrorCode::work_limit) return d;
  return too_much_work(id, lower, upper, most_tets);
}

Slab::Slab(const ConformingSection& lower, const ConformingSection& upper, TetMesh mesh)
    : lower_(&lower), upper_(&upper), lower_count_(lower.vertex_count()), mesh_(std::move(mesh)) {
  classify_tets();
  collect_stars();
}

EdgeKind Slab::edge_kind(VertexId u, VertexId v) const {
  const ConformingSection& section = section_of(u);
  const EdgeId e = section.find_edge(in_section(u), in_section(v));
  TETLOFT_CHECK(e.valid());
  return section.edges[e].kind;
}

namespace {

// The kind of a type-2 tet by its in-plane edges below and above.
TetKind type2_kind(EdgeKind below, EdgeKind above) {
  const auto has = [&](EdgeKind k) { return below == k || above == k; };
  if (has(EdgeKind::internal)) {
    if (below == above) return TetKind::ii;
    return has(EdgeKind::external) ? TetKind::ie : TetKind::ic;
  }
  if (has(EdgeKind::external)) return below == above ? TetKind::ee : TetKind::ec;
  return TetKind::cc;
}

}  // namespace

void Slab::classify_tets() {
  const std::size_t n = mesh_.tet_slots();
  kind_.resize(n);
  upper_corners_.resize(n);
  tet_on_lower_.resize(lower_->triangulation.triangles.size());
  tet_on_upper_.resize(upper_->triangulation.triangles.size());
  for (std::size_t k = 0; k < n; ++k) {
    const TetId t(k);
    std::array<VertexId, 4> below;
    std::array<VertexId, 4> above;
    std::size_t lows = 0;
    std::size_t highs = 0;
    std::uint8_t mask = 0;
    for (int i = 0; i < 4; ++i) {
      const VertexId v = mesh_.vertex(t, i);
      if (is_upper(v)) {
        mask = static_cast<std::uint8_t>(mask | (1U << i));
        above[highs++] = in_section(v);
      } else {
        below[lows++] = v;
      }
    }
    upper_corners_[t] = mask;
    if (lows == 2) {
      const EdgeId e = lower_->find_edge(below[0], below[1]);
      const EdgeId f = upper_->find_edge(above[0], above[1]);
      TETLOFT_CHECK(e.valid() && f.valid());
      kind_[t] = type2_kind(lower_->edges[e].kind, upper_->edges[f].kind);
      continue;
    }
    TETLOFT_CHECK(lows == 1 || lows == 3);
    const ConformingSection& section = lows == 3 ? *lower_ : *upper_;
    const std::array<VertexId, 4>& corner = lows == 3 ? below : above;
    const TriangleId triangle = section.find_triangle(corner[0], corner[1], corner[2]);
    TETLOFT_CHECK(triangle.valid());
    kind_[t] = section.internal[triangle] != 0 ? TetKind::t1_internal : TetKind::t1_external;
    TetId& slot = (lows == 3 ? tet_on_lower_ : tet_on_upper_)[triangle];
    TETLOFT_CHECK(!slot.valid());
    slot = t;
  }
  // The 2D triangulations are the hull facets of D in their planes, triangle by triangle.
  for (const TetId t : tet_on_lower_) TETLOFT_CHECK(t.valid());
  for (const TetId t : tet_on_upper_) TETLOFT_CHECK(t.valid());
}

void Slab::collect_stars() {
  first_star_.assign(vertex_count() + 1, 0);
  const std::size_t n = mesh_.tet_slots();
  for (std::size_t k = 0; k < n; ++k) {
    for (const VertexId v : mesh_.vertices(TetId(k))) ++first_star_[v.index() + 1];
  }
  for (std::size_t v = 0; v < vertex_count(); ++v) first_star_[v + 1] += first_star_[v];
  star_.resize(4 * n);
  std::vector<std::uint32_t> cursor(first_star_.begin(), first_star_.end() - 1);
  for (std::size_t k = 0; k < n; ++k) {
    for (int i = 0; i < 4; ++i) {
      const VertexId v = mesh_.vertex(TetId(k), i);
      star_[cursor[v.index()]++] = {TetId(k), i};
    }
  }
}

TetId Slab::tet_at_edge(bool in_upper, EdgeId e) const {
  const ConformingSection::Edge& edge = (in_upper ? upper_ : lower_)->edges[e];
  const TriangleId triangle = edge.left.valid() ? edge.left : edge.right;
  return (in_upper ? tet_on_upper_ : tet_on_lower_)[triangle];
}

bool Slab::ring(TetId t, VertexId p, VertexId q, std::vector<TetId>& ring) const {
  ring.clear();
  std::array<int, 2> other{};  // corners of t off the edge
  int found = 0;
  for (int i = 0; i < 4; ++i) {
    const VertexId v = mesh_.vertex(t, i);
    if (v != p && v != q) other[static_cast<std::size_t>(found++)] = i;
  }
  // Appends the tets that follow `t` when leaving through the face opposite corner `out`;
  // the vertex kept in the face (`pivot`) is the one to turn about next.
  const auto walk = [&](int out, int pivot) {
    TetId current = t;
    VertexId hinge = mesh_.vertex(t, pivot);
    for (;;) {
      const HalfFaceId h = mesh_.opposite(TetMesh::half_face(current, out));
      if (!h.valid()) return false;
      current = TetMesh::tet_of(h);
      if (current == t) return true;
      ring.push_back(current);
      const VertexId fresh = mesh_.vertex(current, TetMesh::face_of(h));
      out = mesh_.index_in(current, hinge);
      hinge = fresh;
    }
  };
  ring.push_back(t);
  if (walk(other[0], other[1])) return true;
  std::reverse(ring.begin(), ring.end());
  walk(other[1], other[0]);
  return false;
}

}  // namespace tetloft

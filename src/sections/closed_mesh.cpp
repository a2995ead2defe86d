// Corners of equal coordinates are one vertex; then triangles in canonical form, copies and pairs
// of them left out; then half-edges, sorted by their edges and paired.
#include "sections/closed_mesh.hpp"

#include <algorithm>
#include <cstdio>
#include <limits>
#include <numeric>
#include <string>
#include <utility>

namespace tetloft::internal::sections {

namespace {

using Triangle = std::array<std::uint32_t, 3>;

void weld(ClosedMesh& mesh) {
  for (Point3& p : mesh.points) p = {p.x + 0.0, p.y + 0.0, p.z + 0.0};
  std::vector<bool> used(mesh.points.size(), false);
  for (const Triangle& t : mesh.triangles) {
    for (const std::uint32_t v : t) used[v] = true;
  }
  std::vector<std::uint32_t> order;
  for (std::uint32_t v = 0; v < mesh.points.size(); ++v) {
    if (used[v]) order.push_back(v);
  }
  std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
    return canonical_less(mesh.points[a], mesh.points[b]);
  });
  std::vector<Point3> distinct;
  std::vector<std::uint32_t> number(mesh.points.size(), 0);
  for (const std::uint32_t v : order) {
    if (distinct.empty() || distinct.back() != mesh.points[v]) distinct.push_back(mesh.points[v]);
    number[v] = static_cast<std::uint32_t>(distinct.size() - 1);
  }
  mesh.points = std::move(distinct);
  for (Triangle& t : mesh.triangles) {
    for (std::uint32_t& v : t) v = number[v];
    std::rotate(t.begin(), std::min_element(t.begin(), t.end()), t.end());
  }
}

Triangle turned(const Triangle& t) { return {t[0], t[2], t[1]}; }

// How many were left out of one kind, and a corner of the first.
struct LeftOut {
  std::size_t count = 0;
  Point3 first;
  void add(std::size_t more, const Point3& p) {
    if (count == 0) first = p;
    count += more;
  }
};

void tell(const LeftOut& left_out, const std::string& which, const Frame& frame, ClosedMesh& mesh) {
  if (left_out.count == 0) return;
  Warning warning{"left out: " + std::to_string(left_out.count) +
                      (left_out.count == 1 ? " triangle " : " triangles ") + which,
                  {}};
  warning.where.point = place(frame, left_out.first);
  mesh.warnings.push_back(std::move(warning));
}

void leave_out(ClosedMesh& mesh, const Frame& frame) {
  std::vector<Triangle>& all = mesh.triangles;
  // Both ways round a triangle side by side.
  std::sort(all.begin(), all.end(), [](const Triangle& a, const Triangle& b) {
    const auto key = [](const Triangle& t) { return std::min(t, turned(t)); };
    return std::pair(key(a), a) < std::pair(key(b), b);
  });
  LeftOut flat;
  LeftOut copies;
  LeftOut walls;
  std::vector<Triangle> kept;
  for (std::size_t i = 0; i < all.size();) {
    const Triangle t = all[i];
    const Point3& corner = mesh.points[t[0]];
    std::size_t same = i;
    while (same < all.size() && all[same] == t) ++same;
    std::size_t end = same;
    while (end < all.size() && all[end] == turned(t)) ++end;
    if (t[0] == t[1] || t[0] == t[2] || t[1] == t[2]) {
      // (a, a, b) and (a, b, a) are no two ways round anything.
      flat.add(same - i, corner);
      i = same;
      continue;
    }
    const std::size_t ways = end > same ? 2 : 1;
    copies.add(end - i - ways, corner);
    if (ways == 2) walls.add(2, corner);
    if (ways == 1) kept.push_back(t);
    i = end;
  }
  all = std::move(kept);
  std::sort(all.begin(), all.end());
  tell(flat, "with equal corners", frame, mesh);
  tell(copies, "repeating others", frame, mesh);
  tell(walls, "in pairs, the two ways round", frame, mesh);
}

std::string text_of(const Point3& p) {
  char text[96];
  std::snprintf(text, sizeof text, "(%.17g, %.17g, %.17g)", p.x, p.y, p.z);
  return text;
}

// Edges with an odd number of triangles.
struct OpenEdges {
  std::size_t edges = 0;
  std::uint32_t first = 0;    // a half-edge of the first of them
  std::size_t triangles = 0;  // at that one
};

Error not_closed(const ClosedMesh& mesh, const OpenEdges& open, const Frame& frame) {
  const Point3 a = place(frame, mesh.points[mesh.from(open.first)]);
  const Point3 b = place(frame, mesh.points[mesh.to(open.first)]);
  Error error{ErrorCode::invalid_input,
              "the mesh is not closed: the edge from " + text_of(a) + " to " + text_of(b) +
                  " has " + std::to_string(open.triangles) +
                  (open.triangles == 1 ? " triangle" : " triangles"),
              {}};
  if (open.edges > 1) {
    error.message += "; " + std::to_string(open.edges) + " edges have an odd number of them";
  }
  error.where.point = a;
  return error;
}

// Of one edge those in either direction are paired in their order, then what is left of one.
void pair_up(const std::uint32_t* begin, const std::uint32_t* end, ClosedMesh& mesh) {
  std::vector<std::uint32_t> up;
  std::vector<std::uint32_t> down;
  for (const std::uint32_t* h = begin; h != end; ++h) {
    (mesh.from(*h) < mesh.to(*h) ? up : down).push_back(*h);
  }
  const auto join = [&](std::uint32_t a, std::uint32_t b) {
    mesh.mate[a] = b;
    mesh.mate[b] = a;
  };
  const std::size_t both = std::min(up.size(), down.size());
  for (std::size_t i = 0; i < both; ++i) join(up[i], down[i]);
  const std::vector<std::uint32_t>& rest = up.size() > both ? up : down;
  for (std::size_t i = both; i < rest.size(); i += 2) join(rest[i], rest[i + 1]);
}

Result<void> pair_half_edges(ClosedMesh& mesh, const Frame& frame) {
  using Edge = std::pair<std::uint32_t, std::uint32_t>;
  const auto edge_of = [&](std::uint32_t h) {
    const std::uint32_t a = mesh.from(h);
    const std::uint32_t b = mesh.to(h);
    return a < b ? Edge(a, b) : Edge(b, a);
  };
  std::vector<std::uint32_t> order(3 * mesh.triangles.size());
  std::iota(order.begin(), order.end(), 0U);
  std::sort(order.begin(), order.end(), [&](std::uint32_t g, std::uint32_t h) {
    const Edge a = edge_of(g);
    const Edge b = edge_of(h);
    return a != b ? a < b : g < h;
  });
  mesh.mate.assign(order.size(), 0);
  OpenEdges open;
  for (std::size_t i = 0; i < order.size();) {
    std::size_t end = i;
    while (end < order.size() && edge_of(order[end]) == edge_of(order[i])) ++end;
    if ((end - i) % 2 == 0) {
      pair_up(order.data() + i, order.data() + end, mesh);
    } else if (open.edges++ == 0) {
      open.first = order[i];
      open.triangles = end - i;
    }
    i = end;
  }
  if (open.edges > 0) return not_closed(mesh, open, frame);
  return {};
}

}  // namespace

Result<ClosedMesh> close_mesh(std::vector<Point3> points, std::vector<Triangle> triangles,
                              const Frame& frame) {
  ClosedMesh mesh;
  mesh.points = std::move(points);
  mesh.triangles = std::move(triangles);
  weld(mesh);
  leave_out(mesh, frame);
  if (Result<void> closed = pair_half_edges(mesh, frame); !closed) return closed.error();
  return mesh;
}

}  // namespace tetloft::internal::sections

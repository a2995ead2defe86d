#include "io/surface.hpp"

#include <algorithm>
#include <numeric>
#include <utility>

#include "core/text.hpp"
#include "io/description_texts.hpp"
#include "io/groups.hpp"

namespace tetloft::internal::io {

SurfaceMesh surface_mesh(const Model& model) {
  Surface surface = boundary_surface(model);
  SurfaceMesh mesh;
  mesh.tet = std::move(surface.tet);
  // New number of each model vertex; 0 of those that are not on the surface.
  IdVector<VertexId, std::uint32_t> number(model.points.size(), 0);
  for (const TriangleVertices& triangle : surface.triangles) {
    for (const VertexId v : triangle) number[v] = 1;
  }
  for (const VertexId v : model.points.ids()) {
    if (number[v] == 0) continue;
    number[v] = static_cast<std::uint32_t>(mesh.vertex.size());
    mesh.vertex.push_back(v);
    mesh.points.push_back(place(model.frame, model.points[v]));
  }
  mesh.triangles.reserve(surface.triangles.size());
  for (const TriangleVertices& t : surface.triangles) {
    mesh.triangles.push_back({number[t[0]], number[t[1]], number[t[2]]});
  }
  return mesh;
}

std::vector<SurfacePart> surface_parts(const SurfaceMesh& mesh, const Model& model) {
  const auto component = [&](std::uint32_t triangle) {
    return component_at(model, mesh.tet[triangle]);
  };
  std::vector<std::uint32_t> order(mesh.triangles.size());
  std::iota(order.begin(), order.end(), 0U);
  std::stable_sort(order.begin(), order.end(), [&](std::uint32_t i, std::uint32_t j) {
    return component(i) < component(j);  // an invalid id is the largest
  });
  std::vector<SurfacePart> parts;
  for (const std::uint32_t triangle : order) {
    const ComponentId of = component(triangle);
    if (parts.empty() || parts.back().component != of) {
      parts.push_back({of, group_name(model, of), {}});
    }
    parts.back().triangles.push_back(triangle);
  }
  return parts;
}

bool is_nameless(const Model& model, const std::vector<SurfacePart>& parts) {
  const auto& names = model.component_names;
  return parts.size() <= 1 && model.about == Description() &&
         std::all_of(names.begin(), names.end(), [](const auto& name) { return name.empty(); });
}

std::size_t unmatched_edges(const SurfaceMesh& mesh, const SurfacePart& part) {
  // Ends of each edge, the lower first; and whether it runs that way.
  using Edge = std::array<std::uint32_t, 3>;
  std::vector<Edge> edges;
  edges.reserve(3 * part.triangles.size());
  for (const std::uint32_t triangle : part.triangles) {
    const auto& corners = mesh.triangles[triangle];
    for (std::size_t i = 0; i < 3; ++i) {
      const std::uint32_t from = corners[i];
      const std::uint32_t to = corners[(i + 1) % 3];
      edges.push_back({std::min(from, to), std::max(from, to), from < to ? 1U : 0U});
    }
  }
  std::sort(edges.begin(), edges.end());
  std::size_t unmatched = 0;
  for (std::size_t first = 0, end = 0; first < edges.size(); first = end) {
    while (end < edges.size() && edges[end][0] == edges[first][0] &&
           edges[end][1] == edges[first][1]) {
      ++end;
    }
    const bool matched = end - first == 2 && edges[first][2] != edges[first + 1][2];
    if (!matched) ++unmatched;
  }
  return unmatched;
}

std::vector<std::uint32_t> by_part(const std::vector<SurfacePart>& parts) {
  std::vector<std::uint32_t> triangles;
  for (const SurfacePart& part : parts) {
    triangles.insert(triangles.end(), part.triangles.begin(), part.triangles.end());
  }
  return triangles;
}

std::vector<std::string> surface_comments(const Model& model,
                                          const std::vector<SurfacePart>& parts) {
  std::vector<std::string> lines = description_lines(model.about);
  if (is_nameless(model, parts)) return lines;
  for (const SurfacePart& part : parts) {
    const std::size_t faces = part.triangles.size();
    lines.push_back("component " + std::to_string(component_tag(part.component)) + ": " +
                    std::to_string(faces) + " faces, " + printable(part.name));
  }
  return lines;
}

PartMesh part_mesh(const SurfaceMesh& mesh, const SurfacePart& part) {
  PartMesh own;
  for (const std::uint32_t triangle : part.triangles) {
    const auto& corners = mesh.triangles[triangle];
    own.vertex.insert(own.vertex.end(), corners.begin(), corners.end());
  }
  std::sort(own.vertex.begin(), own.vertex.end());
  own.vertex.erase(std::unique(own.vertex.begin(), own.vertex.end()), own.vertex.end());
  own.triangles.reserve(part.triangles.size());
  for (const std::uint32_t triangle : part.triangles) {
    std::array<std::uint32_t, 3> corners = mesh.triangles[triangle];
    for (std::uint32_t& v : corners) {
      v = static_cast<std::uint32_t>(std::lower_bound(own.vertex.begin(), own.vertex.end(), v) -
                                     own.vertex.begin());
    }
    own.triangles.push_back(corners);
  }
  return own;
}

}  // namespace tetloft::internal::io

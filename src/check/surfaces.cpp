#include "check/surfaces.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include "core/sort_distinct.hpp"

namespace tetloft::internal::checking {

namespace {

constexpr std::uint32_t kNoPatch = 0xFFFFFFFFU;

std::uint64_t face_in_whole(const ModelView& view, HalfFaceId face) {
  return std::uint64_t{4} * view.id[face.index() / 4].index() + face.index() % 4;
}

TriangleVertices numbers_of(const ModelView& view, const TriangleVertices& face) {
  return {view.number(face[0]), view.number(face[1]), view.number(face[2])};
}

}  // namespace

std::uint32_t SurfacePatches::add(Patch patch) {
  patches_.push_back(patch);
  return static_cast<std::uint32_t>(sets_.add());
}

std::uint32_t SurfacePatches::add(const ModelView& view, const SurfaceComponents& surface) {
  const auto base = static_cast<std::uint32_t>(patches_.size());
  std::vector<std::uint8_t> seen(surface.topology.size(), 0);
  for (std::size_t k = 0; k < view.boundary.size(); ++k) {
    const std::uint32_t c = surface.component[k];
    if (seen[c] != 0) continue;
    seen[c] = 1;  // components are numbered by their first triangle
    add({surface.topology[c], face_in_whole(view, view.boundary_face[k]),
         numbers_of(view, view.boundary[k])});
  }
  note_pinches(view, surface, base);
  return base;
}

// Vertices of several patches that may turn out to be one surface; those in seams are not judged
// here.
void SurfacePatches::note_pinches(const ModelView& view, const SurfaceComponents& surface,
                                  std::uint32_t base) {
  std::vector<std::uint32_t> first(view.points.size(), kNoPatch);
  Corners pinched;
  for (std::size_t k = 0; k < view.boundary.size(); ++k) {
    const std::uint32_t patch = base + surface.component[k];
    for (const VertexId v : view.boundary[k]) {
      std::uint32_t& of_vertex = first[v.index()];
      if (of_vertex == kNoPatch) of_vertex = patch;
      if (of_vertex == patch || !view.judges(v)) continue;
      pinched.emplace_back(v.value(), of_vertex);
      pinched.emplace_back(v.value(), patch);
    }
  }
  share(std::move(pinched));
}

void SurfacePatches::share(Corners corners) {
  sort_distinct(corners);
  for (std::size_t i = 0; i < corners.size();) {
    std::vector<std::uint32_t> sharing;
    const std::uint32_t v = corners[i].first;
    for (; i < corners.size() && corners[i].first == v; ++i) sharing.push_back(corners[i].second);
    if (sharing.size() > 1) ++shared_vertices_[std::move(sharing)];
  }
}

std::uint32_t SurfacePatches::add(const ModelView& view, std::size_t k) {
  return add(
      {{3, 3, 1}, face_in_whole(view, view.boundary_face[k]), numbers_of(view, view.boundary[k])});
}

void SurfacePatches::grow_together(const ModelView& view, std::span<const std::uint32_t> patch) {
  using Edge = std::array<std::uint32_t, 3>;  // its ends, and a patch that has it
  std::vector<Edge> edges;
  Corners corners;
  for (std::size_t k = 0; k < view.boundary.size(); ++k) {
    const TriangleVertices& triangle = view.boundary[k];
    for (std::size_t i = 0; i < 3; ++i) {
      const VertexId a = triangle[i];
      const VertexId b = triangle[(i + 1) % 3];
      if (view.in_seam(a)) corners.emplace_back(a.value(), patch[k]);
      if (view.in_seam(a) && view.in_seam(b)) {
        edges.push_back({std::min(a, b).value(), std::max(a, b).value(), patch[k]});
      }
    }
  }
  sort_distinct(edges);
  for (std::size_t i = 1; i < edges.size(); ++i) {
    if (edges[i][0] != edges[i - 1][0] || edges[i][1] != edges[i - 1][1]) continue;
    sets_.unite(edges[i][2], edges[i - 1][2]);
    --patches_[edges[i][2]].topology.edges;
  }
  share(std::move(corners));
}

void SurfacePatches::meet(const ModelView& view, const OnContours& on,
                          std::span<const std::uint32_t> patch,
                          std::span<const std::size_t> bounded) {
  const auto met = on.bounds_met(view.boundary, patch, bounded);
  bounds_.insert(bounds_.end(), met.begin(), met.end());
}

std::vector<BoundarySurface> SurfacePatches::all() const {
  // By first triangle: patches of a surface are in the order in which they came, not in this one.
  std::vector<std::uint64_t> first(patches_.size(), UINT64_MAX);
  for (std::size_t p = 0; p < patches_.size(); ++p) {
    std::uint64_t& of_set = first[sets_.find(p)];
    of_set = std::min(of_set, patches_[p].first_face);
  }
  std::vector<std::size_t> order;
  for (std::size_t p = 0; p < patches_.size(); ++p) {
    if (sets_.find(p) == p) order.push_back(p);
  }
  std::sort(order.begin(), order.end(),
            [&](std::size_t a, std::size_t b) { return first[a] < first[b]; });
  std::vector<std::uint32_t> surface(patches_.size(), kNoPatch);
  for (std::size_t k = 0; k < order.size(); ++k) surface[order[k]] = static_cast<std::uint32_t>(k);
  const auto surface_of = [&](std::size_t p) { return surface[sets_.find(p)]; };

  std::vector<BoundarySurface> all(order.size());
  for (std::size_t p = 0; p < patches_.size(); ++p) {
    BoundarySurface& sum = all[surface_of(p)];
    const Patch& patch = patches_[p];
    sum.topology.vertices += patch.topology.vertices;
    sum.topology.edges += patch.topology.edges;
    sum.topology.triangles += patch.topology.triangles;
    if (patch.first_face == first[sets_.find(p)]) sum.first = patch.first;
  }
  for (const auto& [sharing, vertices] : shared_vertices_) {
    std::vector<std::uint32_t> of;
    for (const std::uint32_t p : sharing) of.push_back(surface_of(p));
    std::sort(of.begin(), of.end());
    for (std::size_t i = 1; i < of.size(); ++i) {
      if (of[i] == of[i - 1]) all[of[i]].topology.vertices -= vertices;
    }
  }
  for (const auto& [p, bound] : bounds_) all[surface_of(p)].bounds.push_back(bound);
  for (BoundarySurface& one : all) sort_distinct(one.bounds);
  return all;
}

}  // namespace tetloft::internal::checking

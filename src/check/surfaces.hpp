// The boundary surfaces of a solid that is shown as a whole, or segment by segment.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <span>
#include <utility>
#include <vector>

#include <tetloft/tet_mesh.hpp>

#include "check/resampling.hpp"
#include "check/view.hpp"
#include "core/union_find.hpp"

namespace tetloft::internal::checking {

struct BoundarySurface {
  SurfaceTopology topology;
  TriangleVertices first;           ///< its first triangle, by numbers of the whole
  std::vector<std::size_t> bounds;  ///< what the contours that it meets bound, sorted
};

/// What is one surface in a segment, or a triangle in a seam, is a patch; patches grow together
/// over seams. Vertices and edges that several of them have are counted once in a surface.
class SurfacePatches {
 public:
  /// Those of a whole or a segment; returns the number of the first.
  std::uint32_t add(const ModelView& view, const SurfaceComponents& surface);
  /// A triangle of the boundary that lies in a seam.
  std::uint32_t add(const ModelView& view, std::size_t boundary_triangle);
  /// Of the view of a seam, and by triangle of its boundary the patch.
  void grow_together(const ModelView& view, std::span<const std::uint32_t> patch);
  /// The contours of `on` that triangles of these patches meet; by contour what it bounds.
  void meet(const ModelView& view, const OnContours& on, std::span<const std::uint32_t> patch,
            std::span<const std::size_t> bounded);

  [[nodiscard]] const UnionFind& sets() const { return sets_; }
  [[nodiscard]] const TriangleVertices& first_triangle(std::size_t patch) const {
    return patches_[patch].first;
  }
  /// By first triangle.
  [[nodiscard]] std::vector<BoundarySurface> all() const;

 private:
  struct Patch {
    SurfaceTopology topology;
    std::uint64_t first_face = 0;  // of the whole: 4 t + i
    TriangleVertices first;
  };
  using Corners = std::vector<std::pair<std::uint32_t, std::uint32_t>>;  // a vertex, and a patch
  std::uint32_t add(Patch patch);
  void note_pinches(const ModelView& view, const SurfaceComponents& surface, std::uint32_t base);
  void share(Corners corners);

  std::vector<Patch> patches_;
  UnionFind sets_{0};
  // Of vertices of several patches: how many each list of patches shares.
  std::map<std::vector<std::uint32_t>, std::size_t> shared_vertices_;
  std::vector<std::pair<std::uint32_t, std::size_t>> bounds_;  // by patch
};

}  // namespace tetloft::internal::checking

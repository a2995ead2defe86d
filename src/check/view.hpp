// A model as the checks look at it: the tets that can be looked at, with their adjacency
// and components, whatever else is wrong with the model.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include <tetloft/model.hpp>
#include <tetloft/section_stack.hpp>
#include <tetloft/tet_mesh.hpp>

namespace tetloft::internal::checking {

/// A level tells where a vertex lies between the planes: 2 i on plane i (z equal to z_i),
/// 2 i − 1 strictly between planes i − 1 and i, −1 below the first and 2 n − 1 above the
/// last of n planes.
using Level = std::int64_t;
[[nodiscard]] constexpr bool on_plane(Level level) { return level >= 0 && level % 2 == 0; }

struct ModelView {
  std::span<const Point3> points;         ///< of the model, also those that are not finite
  std::span<const RegionLink> links;      ///< as the model says
  std::span<const RegionMotion> motions;  ///< as the model says
  std::span<const VoidLink> void_links;   ///< as the model says
  std::span<const Deviation> deviations;  ///< as the model says

  /// The sound tets: four distinct vertices in range, all coordinates finite.
  std::vector<TetVertices> tets;
  std::vector<TetId> id;  ///< their ids in the model
  /// opposite[4 t + i], t a sound tet; invalid unless the face has exactly two tets, on
  /// opposite sides.
  std::vector<HalfFaceId> opposite;
  /// Face-connected components, by first sound tet. All tets of a face are connected, also
  /// where there are more than two.
  std::vector<std::uint32_t> component;
  std::size_t component_count = 0;
  /// The faces of one tet only, outward, by half-face.
  std::vector<TriangleVertices> boundary;

  // Defects found on the way.
  std::vector<TetId> malformed;                 ///< a vertex out of range or repeated
  std::vector<VertexId> not_finite;             ///< a coordinate is not finite
  std::vector<TriangleVertices> crowded_faces;  ///< faces of more than two tets
  std::vector<TriangleVertices> doubled_faces;  ///< faces of two tets on the same side

  /// used[v]: v is in a sound tet.
  std::vector<std::uint8_t> used;
  /// level[v]; −1 for points that are not finite, which no sound tet uses.
  std::vector<Level> level;

  [[nodiscard]] Point2 xy(VertexId v) const { return {points[v.index()].x, points[v.index()].y}; }
};

/// Near-linear. Requires a valid stack and fewer than 2^30 tets; of the model, nothing.
[[nodiscard]] ModelView look_at(const Model& model, const SectionStack& stack);

// Places in words.
[[nodiscard]] std::string vertex_text(const ModelView& view, VertexId v);
[[nodiscard]] std::string tet_text(TetId t);
[[nodiscard]] std::string face_text(const TriangleVertices& face);
[[nodiscard]] std::string contour_text(std::size_t section, std::size_t contour);

}  // namespace tetloft::internal::checking

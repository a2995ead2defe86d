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

/// The sections first … end − 1 of a stack.
struct SectionRange {
  std::size_t first = 0;
  std::size_t end = 0;
  [[nodiscard]] bool holds(std::size_t s) const { return s >= first && s < end; }
  /// Is it the level of one of their planes?
  [[nodiscard]] bool holds_plane(Level level) const {
    return on_plane(level) && holds(static_cast<std::size_t>(level / 2));
  }
};

/// What a view shows. A segment, slabs next to each other, shares with the one below, and with the
/// one above, the vertices in a section plane, its seams; it has all tets of each of its faces but
/// of those that lie in a seam. A seam is shown with the tets of both sides that have a vertex in
/// it: of the faces that have, all tets.
enum class Scope : std::uint8_t { whole, segment, seam };

/// Where a model that is shown stands in a whole.
struct PartOfWhole {
  Scope scope = Scope::whole;
  /// Which seam a vertex lies in, by number, the same for all of it; 0: none. Empty of the whole.
  std::vector<std::uint8_t> seam = {};
  std::vector<VertexId> vertex = {};  ///< what the whole calls it; empty: as here
  std::vector<TetId> tet = {};        ///< likewise
};

/// All coordinates?
[[nodiscard]] bool is_finite(const Point3& p);

struct ModelView {
  std::span<const Point3> points;  ///< of the model, also those that are not finite
  PartOfWhole part;

  /// The sound tets: four distinct vertices in range, all coordinates finite.
  std::vector<TetVertices> tets;
  std::vector<TetId> id;  ///< their ids in the whole
  /// opposite[4 t + i], t a sound tet; invalid unless the face has exactly two tets, on
  /// opposite sides; and where not all its tets are shown.
  std::vector<HalfFaceId> opposite;
  /// Face-connected components, by first sound tet. All tets of a face are connected, also
  /// where there are more than two.
  std::vector<std::uint32_t> component;
  std::size_t component_count = 0;
  /// The faces of one tet only, outward, by half-face; without those of which not all tets are
  /// shown.
  std::vector<TriangleVertices> boundary;
  std::vector<HalfFaceId> boundary_face;

  // Defects found on the way; of faces of a seam in the view of it alone.
  std::vector<TetId> malformed;                 ///< a vertex out of range or repeated
  std::vector<VertexId> not_finite;             ///< a coordinate is not finite
  std::vector<TriangleVertices> crowded_faces;  ///< faces of more than two tets
  std::vector<TriangleVertices> doubled_faces;  ///< faces of two tets on the same side

  /// used[v]: v is in a sound tet.
  std::vector<std::uint8_t> used;
  /// level[v]; −1 for points that are not finite, which no sound tet uses.
  std::vector<Level> level;

  [[nodiscard]] Point2 xy(VertexId v) const { return {points[v.index()].x, points[v.index()].y}; }
  /// Its number in the whole.
  [[nodiscard]] VertexId number(VertexId v) const {
    return v.index() < part.vertex.size() ? part.vertex[v.index()] : v;
  }
  [[nodiscard]] bool in_seam(VertexId v) const {
    return !part.seam.empty() && part.seam[v.index()] != 0;
  }
  /// With all its vertices in one seam?
  [[nodiscard]] bool in_seam(const TriangleVertices& face) const {
    return in_seam(face[0]) && part.seam[face[0].index()] == part.seam[face[1].index()] &&
           part.seam[face[0].index()] == part.seam[face[2].index()];
  }
  /// Is this vertex this view's to judge: are all its tets shown, and in no other view?
  [[nodiscard]] bool judges(VertexId v) const { return in_seam(v) == (part.scope == Scope::seam); }
};

/// Near-linear. Requires a valid stack; of the model, nothing. Throws Failed (invalid_input) at
/// kMostModelTets or more.
[[nodiscard]] ModelView look_at(const Model& model, const SectionStack& stack,
                                PartOfWhole part = {});

// Places in words.
[[nodiscard]] std::string vertex_text(const ModelView& view, VertexId v);
[[nodiscard]] std::string tet_text(TetId t);
[[nodiscard]] std::string edge_text(const ModelView& view, VertexId a, VertexId b);
[[nodiscard]] std::string face_text(const ModelView& view, const TriangleVertices& face);
[[nodiscard]] std::string contour_text(std::size_t section, std::size_t contour);

}  // namespace tetloft::internal::checking

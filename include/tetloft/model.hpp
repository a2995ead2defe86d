// The result as values: points, tets, and where everything comes from.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include <tetloft/correspondence.hpp>
#include <tetloft/description.hpp>
#include <tetloft/export.hpp>
#include <tetloft/frame.hpp>
#include <tetloft/ids.hpp>
#include <tetloft/point.hpp>
#include <tetloft/result.hpp>
#include <tetloft/tet_mesh.hpp>
#include <tetloft/voids.hpp>

namespace tetloft {

/// What a tet was cut from: the type of the Delaunay tet (Nonato et al. 2000, section 3.1,
/// and ALGORITHM section 0), or an end cap. The values are stored in files.
enum class TetKind : std::uint8_t {
  t1_internal = 0,  ///< type 1 on an internal triangle
  t1_external = 1,
  ii = 2,  ///< reverse: an internal edge in each plane
  ie = 3,  ///< reverse: internal, external
  ic = 4,
  ee = 5,
  ec = 6,
  cc = 7,
  prism = 8,  ///< end of a component: extruded region
};
inline constexpr int kTetKinds = 9;
[[nodiscard]] TETLOFT_API const char* name_of(TetKind kind);

/// How a vertex came to be. The values are stored in files.
enum class PointOrigin : std::uint8_t {
  input = 0,          ///< a vertex of the input, bit for bit
  contour_split = 1,  ///< on a contour edge, inserted to make the section conforming
  lifted = 2,         ///< midpoint of an external edge (or interior of a triangular hole)
  cut = 3,            ///< on an edge that leaves a component
  cap = 4,            ///< of the far side of an end prism
  projected = 5,      ///< inside a region: of a neighbour's external skeleton (geiger.hpp)
  inserted = 6,       ///< of a section put between two given ones (between.hpp)
};
inline constexpr int kPointOrigins = 7;
[[nodiscard]] TETLOFT_API const char* name_of(PointOrigin origin);

struct Model {
  /// In the coordinates of the stack.
  IdVector<VertexId, Point3> points;
  /// Positive tets.
  IdVector<TetId, TetVertices> tets;

  // Per tet.
  IdVector<TetId, ComponentId> component;
  /// The slab; an end below the first section counts to slab 0, above the last to the last.
  IdVector<TetId, SlabId> slab;
  IdVector<TetId, TetKind> kind;

  // Per point.
  IdVector<VertexId, SectionId> section;  ///< invalid between sections
  IdVector<VertexId, ContourId> contour;  ///< invalid off the contours
  IdVector<VertexId, PointOrigin> origin;

  std::size_t component_count = 0;

  /// What was decided to belong together, and what nearly was: as StackLinks::links.
  std::vector<RegionLink> links;
  /// By correspondence `moved`: as StackLinks::motions.
  std::vector<RegionMotion> motions;
  /// Of voids, likewise; without any where nothing was decided about them (VoidRule::free).
  std::vector<VoidLink> void_links;
  /// Where guarantee 5 cannot be had, by (slab, upper, contour).
  std::vector<Deviation> deviations;

  /// As SectionStack::frame. Files hold the points as they lie there; .vtu also those of the stack,
  /// where placing them rounds.
  Frame frame = {};
  /// That of the stack.
  Description about = {};
  /// Of those that labels name; empty, or one for each component, which may be empty.
  IdVector<ComponentId, std::string> component_names = {};
};

/// What files and pictures call a component: its name; without one, the model's, or "component",
/// and its number counted from 1; the model's alone if it has that one only.
[[nodiscard]] TETLOFT_API std::string component_name(const Model& model, ComponentId component);

/// One component as a model of its own: its tets and their points, in the order of the model, with
/// all that is known of each; named as component_name() says. Links, motions and deviations, which
/// speak of the whole, stay behind. Requires a model that is well formed, as write_vtu() asks, and
/// a component of it; throws std::invalid_argument otherwise.
[[nodiscard]] TETLOFT_API Model component_of(const Model& model, ComponentId component);

/// Whether two components have a point in common: those of other programs may, those that
/// reconstruct() makes do not. False for a model that tells no components. Requires a well formed
/// one.
[[nodiscard]] TETLOFT_API bool components_touch(const Model& model);

/// Adjacency, stars and links of a model's tets; vertex and tet ids are the model's. Made anew by
/// each call, in near-linear time: keep it. Refused as TetMesh::from_tets().
[[nodiscard]] TETLOFT_API Result<TetMesh> half_faces(const Model& model);

/// The boundary surface: outward oriented triangles over the model's vertices, by half-face.
struct Surface {
  std::vector<TriangleVertices> triangles;
  std::vector<TetId> tet;  ///< the tet behind each triangle
};

/// The faces that belong to one tet only. Tets with a vertex that the model lacks count for
/// nothing, here and in volume(). Requires that no face belongs to more than two; throws
/// std::invalid_argument for 2^30 tets or more.
[[nodiscard]] TETLOFT_API Surface boundary_surface(const Model& model);

/// Sum of the tets' volumes where the model lies (volume_factor() of its frame), in a fixed order.
[[nodiscard]] TETLOFT_API double volume(const Model& model);

}  // namespace tetloft

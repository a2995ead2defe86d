// Stacks of surface meshes: the closed surface of a solid, cut by parallel planes.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include <tetloft/execution.hpp>
#include <tetloft/export.hpp>
#include <tetloft/point.hpp>
#include <tetloft/repair.hpp>
#include <tetloft/result.hpp>
#include <tetloft/section_stack.hpp>

namespace tetloft {

/// Triangles in space, as files of surfaces have them. Points of equal coordinates may stand
/// several times: they mean the same vertex.
struct TriangleMesh {
  std::vector<Point3> points;
  std::vector<std::array<std::uint32_t, 3>> triangles;  ///< by position in `points`
};

/// The most planes of one stack, and the most crossings of triangles with planes.
inline constexpr std::size_t kMostSlicePlanes = std::size_t{1} << 20;
inline constexpr std::size_t kMostSliceCrossings = std::size_t{1} << 28;

struct SliceOptions {
  int axis = 2;  ///< 0, 1, 2: planes of constant x, y, z
  /// One of the two. So many planes, evenly: plane k lies at low + (k + 1/2) · (high - low) /
  /// planes of the mesh's extent along the axis.
  std::size_t planes = 0;
  /// Planes at low + (k + 1/2) · step below `high`; above 0.
  std::optional<double> step = {};
  /// What is inside, where loops of a plane overlap (repair.hpp). `odd` takes valid sections as
  /// they are; the others pass every section through repair(), and `winding` asks for triangles
  /// that turn counter-clockwise as seen from outside.
  FillRule fill = FillRule::odd;
  Execution execution = {};  ///< threads share validation and repair
};

struct Sliced {
  /// Valid. Its frame exchanges coordinates, so that it lies where the mesh lies. A plane that
  /// meets nothing, between two bodies, is a section without contours.
  SectionStack stack;
  std::vector<Warning> warnings;
  std::size_t vertices = 0;   ///< distinct points of the mesh that are used
  std::size_t triangles = 0;  ///< of the mesh, less those left out
  std::size_t repaired = 0;   ///< changes by repair, each of them a warning
};

/// Cuts a closed mesh by planes.
///
/// A vertex exactly in a plane counts as above it: so a plane crosses an edge or does not, and
/// crosses no or two edges of each triangle. From edge to edge over the triangles these close to
/// loops by construction; a section is the limit of those from below, and a face that lies in its
/// plane takes no part. Where a plane crosses an edge there is one point, whichever triangle asks:
/// the exact crossing, each coordinate rounded once.
///
/// Left out with a warning: triangles with two equal corners; copies of a triangle (the same
/// corners the same way round), and pairs of triangles with the same corners the two ways round, as
/// a wall between bodies is. At an edge with four triangles or more, those of opposite directions
/// are paired in canonical order. Repeated vertices of a loop are removed, loops without area left
/// out with a warning. Loops may touch: of bodies that do, or by rounding. Where the stack is not
/// valid it is repaired (repair()), with a warning.
///
/// Refused (usage): options that make no sense, more planes than kMostSlicePlanes, a step that
/// leaves none. Refused (invalid_input): coordinates that are not finite or reach
/// kLargestCoordinate; triangles that refer to no point; a mesh that is not closed, naming an edge
/// with an odd number of triangles; more than kMostSliceCrossings; planes nearer together than
/// doubles are; a mesh without extent, or of which repair leaves nothing.
[[nodiscard]] TETLOFT_API Result<Sliced> slice(const TriangleMesh& mesh,
                                               const SliceOptions& options);

}  // namespace tetloft

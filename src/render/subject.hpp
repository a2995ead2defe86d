// A model made ready to be drawn: tets by slab, the faces that may be seen, with normals, and the
// contours. What still pictures and the viewer have in common.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include <tetloft/model.hpp>
#include <tetloft/render.hpp>

#include "render/palette.hpp"

namespace tetloft::internal::render {

/// A piece of a contour, between two slabs or at an end.
struct ContourPiece {
  Point3 a, b;
  std::uint32_t slab_below = 0;  ///< the same as slab_above at an end
  std::uint32_t slab_above = 0;
};

/// Of tets that no link holds.
inline constexpr std::uint8_t kNoEvidence = kEvidences;

struct Subject {
  /// Coordinates are the model's times 2^−exponent, exactly: of any scale the same picture.
  int exponent = 0;
  std::vector<Point3> points;     ///< z stretched
  std::vector<TetVertices> tets;  ///< by slab, in the model's order within each
  std::vector<std::uint32_t> component;
  std::vector<std::uint32_t> component_number;  ///< by component: that of the model
  std::vector<std::uint32_t> slab;              ///< ascending
  std::vector<std::uint32_t> slab_number;       ///< by slab: that of the model
  std::vector<TetKind> kind;                    ///< empty where the model has none
  std::vector<std::uint8_t>
      evidence;  ///< Evidence or kNoEvidence; empty where the model tells none
  std::array<std::size_t, kEvidences> links{};  ///< how many were made, by evidence
  std::vector<float> dihedral;                  ///< the smallest, in degrees
  std::vector<HalfFaceId> boundary;             ///< faces of one tet only
  std::vector<HalfFaceId> walls;  ///< faces between tets of different slabs, once from each side
  /// normals[k][i]: unit normal of boundary[k] at its corner i: over faces that meet smoothly.
  std::vector<std::array<Point3, 3>> normals;
  std::vector<ContourPiece> contours;
  std::vector<double> sections;  ///< z of the sections, stretched, ascending
  std::size_t component_count = 0;
  std::size_t slab_count = 0;
  Point3 low, high;     ///< the box of the points in use
  double mean_gap = 0;  ///< mean height of a slab

  [[nodiscard]] std::array<Point3, 3> corners(HalfFaceId h) const {
    const auto& local = kFaceVertex[h.value() & 3U];
    const TetVertices& v = tets[h.value() >> 2];
    const auto at = [&](int i) { return points[v[static_cast<std::size_t>(i)].index()]; };
    return {at(local[0]), at(local[1]), at(local[2])};
  }
  [[nodiscard]] Rgb colour(std::size_t tet, ColourBy by) const;
};

/// Errors as render_png().
[[nodiscard]] Result<Subject> subject_of(const Model& model, const SectionStack* contours,
                                         const RenderOptions& options);

}  // namespace tetloft::internal::render

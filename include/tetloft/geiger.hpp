// The baseline: solids from sections by Geiger's algorithm (B. Geiger, Three-dimensional modeling
// of human organs and its application to diagnosis and surgical planning, INRIA RR-2105, 1993),
// as Nonato et al. (2000) compare their method with it. See src/geiger/README.md.
#pragma once

#include <cstddef>

#include <tetloft/execution.hpp>
#include <tetloft/export.hpp>
#include <tetloft/model.hpp>
#include <tetloft/result.hpp>
#include <tetloft/section_stack.hpp>

namespace tetloft {

struct GeigerOptions {
  /// Adds feet of obtuse corners to contours (step 1) and projected skeleton vertices to regions
  /// (step 2).
  bool refine = true;
  /// The most tets of a slab's Delaunay triangulation, as ReconstructOptions has it.
  double work_limit = kDefaultWorkLimit;
  Execution execution = {};  ///< threads share the sections and slabs
};

struct GeigerReport {
  std::size_t input_vertices = 0;
  std::size_t split_vertices = 0;      ///< inserted on contours to make the sections conforming
  std::size_t foot_vertices = 0;       ///< inserted on contours below obtuse corners
  std::size_t projected_vertices = 0;  ///< of the neighbours' external skeletons, inside regions
  std::size_t external_tets = 0;       ///< eliminated for an external edge
  std::size_t singular_tets = 0;       ///< eliminated with a connection by points and edges alone
  std::size_t lost_contours = 0;       ///< contours without a tet
};

struct GeigerModel {
  /// Vertices inserted inside regions have origin `projected` and no contour.
  Model model;
  GeigerReport report;
};

/// The solid by Geiger's algorithm. Its tets are positive and do not overlap, being tets of
/// Delaunay triangulations. Nothing else is promised: vertices may be singular, contours lost,
/// sections not met; check() says how. Refused: invalid_input for an invalid stack or fewer than
/// two sections, unrepresentable where a section cannot be made conforming, work_limit where that
/// is exceeded, usage for one that is not positive, cancelled if it was stopped.
[[nodiscard]] TETLOFT_API Result<GeigerModel> reconstruct_geiger(const SectionStack& stack,
                                                                 const GeigerOptions& options = {});

}  // namespace tetloft

// Building a ConformingSection's triangulation and edge table in canonical numbering.
#pragma once

#include <array>
#include <vector>

#include <tetloft/conforming_section.hpp>

#include "delaunay2/conforming.hpp"

namespace tetloft::internal::sections {

/// Numbers vertices and triangles canonically, and fills triangulation, edges (kinds left external)
/// and first_edge of `section`. Returns the new id of every point.
IdVector<PlaneVertexId, PlaneVertexId> adopt(const delaunay2_detail::ConformedPlane& plane,
                                             ConformingSection& section);
/// The same of a triangulation whose neighbours do not matter: renumbers the vertices of
/// `triangulation` in canonical order and its triangles canonically, and fills triangulation, edges
/// (kinds left external) and first_edge of `section`. Returns the new id of every old vertex.
IdVector<PlaneVertexId, PlaneVertexId> adopt(const Triangulation2& triangulation,
                                             ConformingSection& section);

/// conform() of a section with its nesting at hand.
[[nodiscard]] Result<ConformingSection> conform_nested(const Section& section, SectionId id,
                                                       const Nesting& nesting,
                                                       const ConformOptions& options);

/// By triangle: the edges opposite its vertices. Linear.
[[nodiscard]] IdVector<TriangleId, std::array<EdgeId, 3>> edges_of_sides(
    const ConformingSection& section);

/// The contours without what was inserted: the section as it was given, but for where contours
/// start and which way they run.
[[nodiscard]] Section given_section(const ConformingSection& section);

/// The kinds of all edges, from `internal` and `next`.
void classify_edges(ConformingSection& section);
/// Throws std::invalid_argument unless all ids and sizes are those of one section.
void require_consistent(const ConformingSection& section);

}  // namespace tetloft::internal::sections

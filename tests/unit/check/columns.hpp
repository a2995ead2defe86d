// Small valid models to check and to corrupt: columns, each a plane triangulation extruded
// through some heights, with the stack whose solid they are.
#pragma once

#include <cstddef>
#include <vector>

#include <tetloft/model.hpp>
#include <tetloft/sections.hpp>

#include "core/prng.hpp"

namespace tetloft::testing {

using namespace internal;

/// A region with a triangulation that has no vertices but those of its contours.
struct Shape {
  std::vector<Contour> contours;
  /// The contours' vertices in sequence, by index.
  std::vector<Point2> points;
  std::vector<std::array<std::size_t, 3>> triangles;  ///< counter-clockwise
};

[[nodiscard]] Shape triangle_shape();                ///< (0, 0), (4, 0), (1, 3)
[[nodiscard]] Shape square_shape();                  ///< side 4, corner (0, 0)
[[nodiscard]] Shape frame_shape();                   ///< square of side 6 with a hole of side 2
[[nodiscard]] Shape polygon_shape(Contour polygon);  ///< a simple polygon, by ear clipping
/// A random simple polygon of 3 to `most` lattice points within [0, size]².
[[nodiscard]] Shape random_shape(Prng& prng, std::size_t most, int size);
[[nodiscard]] Shape moved(Shape shape, double dx, double dy);

struct Column {
  Shape shape;
  std::vector<double> heights;  ///< increasing; those that are section planes, and caps
};

struct Case {
  SectionStack stack;
  Model model;  ///< points and tets only
};

/// The model of all columns over the section planes z, and its stack. Vertices at each
/// height in the order of the shape's points, column after column.
[[nodiscard]] Case extrude(const std::vector<Column>& columns, const std::vector<double>& z);

// The models of the tests.
[[nodiscard]] Case prism_case();      ///< a triangle over z = 0, 1
[[nodiscard]] Case slabs_case();      ///< a square over z = 0, 1, 3
[[nodiscard]] Case pair_case();       ///< two squares apart over z = 0, 1, 2
[[nodiscard]] Case tube_case();       ///< a frame over z = 0, 1, 2
[[nodiscard]] Case isolated_case();   ///< slabs_case and a square at z = 1 with caps
[[nodiscard]] Case half_ends_case();  ///< a triangle over z = 0, 1 with caps at both ends
[[nodiscard]] Case single_case();     ///< a triangle at z = 0, thick
[[nodiscard]] Case split_case();      ///< a triangle with edges split by inserted vertices
[[nodiscard]] std::vector<Case> all_cases();

/// The first vertex with these coordinates, or invalid.
[[nodiscard]] VertexId vertex_at(const Model& model, double x, double y, double z);

}  // namespace tetloft::testing

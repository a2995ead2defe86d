// Prisms between equal triangles are cut into three tets by diagonals from the lower
// vertex number, which neighbours agree on.
#include "unit/check/columns.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include <tetloft/predicates.hpp>

namespace tetloft::testing {

namespace {

void add_points(Shape& shape) {
  shape.points.clear();
  for (const Contour& contour : shape.contours) {
    shape.points.insert(shape.points.end(), contour.vertices.begin(), contour.vertices.end());
  }
}

bool in_closed_triangle(const Point2& a, const Point2& b, const Point2& c, const Point2& p) {
  return orient2d(a, b, p) != Sign::negative && orient2d(b, c, p) != Sign::negative &&
         orient2d(c, a, p) != Sign::negative;
}

bool properly_simple(const std::vector<Point2>& points) {
  SectionStack stack;
  stack.sections.push_back({0, IdVector<ContourId, Contour>(std::vector<Contour>{{points}})});
  return validate(stack).ok();
}

}  // namespace

Shape polygon_shape(Contour polygon) {
  if (area_sign(polygon) == Sign::negative) {
    std::reverse(polygon.vertices.begin(), polygon.vertices.end());
  }
  Shape shape;
  shape.contours = {std::move(polygon)};
  add_points(shape);
  const std::vector<Point2>& p = shape.points;
  std::vector<std::size_t> rest;
  for (std::size_t i = 0; i < p.size(); ++i) rest.push_back(i);
  while (rest.size() > 2) {
    const std::size_t n = rest.size();
    for (std::size_t i = 0; i < n; ++i) {
      const std::size_t a = rest[(i + n - 1) % n];
      const std::size_t b = rest[i];
      const std::size_t c = rest[(i + 1) % n];
      if (orient2d(p[a], p[b], p[c]) != Sign::positive) continue;
      const bool ear = std::none_of(rest.begin(), rest.end(), [&](std::size_t q) {
        return q != a && q != b && q != c && in_closed_triangle(p[a], p[b], p[c], p[q]);
      });
      if (!ear) continue;
      shape.triangles.push_back({a, b, c});
      rest.erase(rest.begin() + static_cast<std::ptrdiff_t>(i));
      break;
    }
    if (rest.size() == n) return {};  // only collinear vertices are left
  }
  return shape;
}

Shape triangle_shape() { return polygon_shape({{{0, 0}, {4, 0}, {1, 3}}}); }

Shape square_shape() { return polygon_shape({{{0, 0}, {4, 0}, {4, 4}, {0, 4}}}); }

Shape frame_shape() {
  Shape shape;
  shape.contours = {{{{0, 0}, {6, 0}, {6, 6}, {0, 6}}}, {{{2, 2}, {4, 2}, {4, 4}, {2, 4}}}};
  add_points(shape);
  for (std::size_t i = 0; i < 4; ++i) {
    const std::size_t j = (i + 1) % 4;
    shape.triangles.push_back({i, j, 4 + j});
    shape.triangles.push_back({i, 4 + j, 4 + i});
  }
  return shape;
}

Shape random_shape(Prng& prng, std::size_t most, int size) {
  const auto side = static_cast<std::uint64_t>(size + 1);
  for (;;) {
    const std::size_t n = 3 + prng.below(most - 2);
    std::vector<Point2> points;
    for (std::size_t i = 0; i < n; ++i) {
      points.push_back(
          {static_cast<double>(prng.below(side)), static_cast<double>(prng.below(side))});
    }
    // Most orders of many points cross themselves; a few shuffles find one that does not.
    for (int attempt = 0; attempt < 20; ++attempt) {
      if (properly_simple(points)) {
        Shape shape = polygon_shape({points});
        if (!shape.triangles.empty()) return shape;
      }
      prng.shuffle(points);
    }
  }
}

Shape moved(Shape shape, double dx, double dy) {
  for (Contour& contour : shape.contours) {
    for (Point2& p : contour.vertices) p = {p.x + dx, p.y + dy};
  }
  add_points(shape);
  return shape;
}

Case extrude(const std::vector<Column>& columns, const std::vector<double>& z) {
  Case made;
  for (const double height : z) {
    Section section;
    section.z = height;
    for (const Column& column : columns) {
      if (std::count(column.heights.begin(), column.heights.end(), height) == 0) continue;
      for (const Contour& contour : column.shape.contours) section.contours.push_back(contour);
    }
    made.stack.sections.push_back(section);
  }
  for (const Column& column : columns) {
    const std::size_t first = made.model.points.size();
    const std::size_t n = column.shape.points.size();
    for (const double height : column.heights) {
      for (const Point2& p : column.shape.points) made.model.points.push_back({p.x, p.y, height});
    }
    for (std::size_t h = 0; h + 1 < column.heights.size(); ++h) {
      for (std::array<std::size_t, 3> t : column.shape.triangles) {
        // Rotated so that the lowest is first: then b, c tell the third diagonal's ends.
        while (t[0] > t[1] || t[0] > t[2]) std::rotate(t.begin(), t.begin() + 1, t.end());
        std::array<VertexId, 3> low;
        std::array<VertexId, 3> high;
        for (std::size_t k = 0; k < 3; ++k) {
          low[k] = VertexId(first + h * n + t[k]);
          high[k] = VertexId(first + (h + 1) * n + t[k]);
        }
        // Diagonals rise from the lower number: low[0]–high[1], low[0]–high[2], and
        // low[1]–high[2] or low[2]–high[1].
        made.model.tets.push_back({low[0], high[2], high[1], high[0]});
        if (t[1] < t[2]) {
          made.model.tets.push_back({low[0], low[1], low[2], high[2]});
          made.model.tets.push_back({low[0], high[2], low[1], high[1]});
        } else {
          made.model.tets.push_back({low[0], low[1], low[2], high[1]});
          made.model.tets.push_back({low[0], low[2], high[2], high[1]});
        }
      }
    }
  }
  for (TetVertices& tet : made.model.tets) {
    const auto point = [&](std::size_t i) { return made.model.points[tet[i]]; };
    if (orient3d(point(0), point(1), point(2), point(3)) == Sign::negative) {
      std::swap(tet[2], tet[3]);
    }
  }
  return made;
}

Case prism_case() { return extrude({{triangle_shape(), {0, 1}}}, {0, 1}); }

Case slabs_case() { return extrude({{square_shape(), {0, 1, 3}}}, {0, 1, 3}); }

Case pair_case() {
  return extrude({{square_shape(), {0, 1, 2}}, {moved(square_shape(), 10, 1), {0, 1, 2}}},
                 {0, 1, 2});
}

Case tube_case() { return extrude({{frame_shape(), {0, 1, 2}}}, {0, 1, 2}); }

Case isolated_case() {
  return extrude({{square_shape(), {0, 1, 3}}, {moved(square_shape(), 10, 0), {0.5, 1, 2}}},
                 {0, 1, 3});
}

Case half_ends_case() { return extrude({{triangle_shape(), {-0.5, 0, 1, 1.5}}}, {0, 1}); }

Case single_case() { return extrude({{triangle_shape(), {-0.25, 0, 0.25}}}, {0}); }

Case split_case() {
  // Midpoints of (0, 0)–(4, 0), exactly on it, and of the two oblique edges, thirds of
  // one of them rounded.
  const Shape refined = polygon_shape(
      {{{0, 0}, {2, 0}, {4, 0}, {4 - 1.0 / 3, 1.0 / 3}, {2.5, 1.5}, {1, 3}, {0.5, 1.5}}});
  Case made = extrude({{refined, {0, 1, 2}}}, {0, 1, 2});
  for (Section& section : made.stack.sections) {
    section.contours[ContourId(0)] = triangle_shape().contours[0];
  }
  return made;
}

std::vector<Case> all_cases() {
  return {prism_case(),    slabs_case(),     pair_case(),   tube_case(),
          isolated_case(), half_ends_case(), single_case(), split_case()};
}

VertexId vertex_at(const Model& model, double x, double y, double z) {
  for (std::size_t v = 0; v < model.points.size(); ++v) {
    if (model.points[VertexId(v)] == Point3{x, y, z}) return VertexId(v);
  }
  return {};
}

}  // namespace tetloft::testing

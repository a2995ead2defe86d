// The parts of the guarantee oracle (guarantee_oracle.hpp), a file for each.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "support/guarantee_oracle.hpp"
#include "support/rational_geometry.hpp"

namespace tetloft::oracle {

using Face = std::array<std::size_t, 3>;
using Edge = std::array<std::size_t, 2>;

template <std::size_t N>
std::array<std::size_t, N> sorted(std::array<std::size_t, N> ids) {
  std::sort(ids.begin(), ids.end());
  return ids;
}

inline Polygon input_polygon(const Contour& contour) {
  Polygon polygon;
  for (const Point2& p : contour.vertices) polygon.push_back(exactly(p));
  return polygon;
}

class Oracle {
 public:
  Oracle(const Model& model, const SectionStack& stack, const CheckOptions& options)
      : model_(model), stack_(stack), options_(options) {}

  GuaranteeVerdicts run();

 private:
  struct Use {
    std::size_t tet;
    Face outward;
  };

  void violate(std::size_t guarantee, const std::string& reason) {
    verdict_.holds[guarantee - 1] = false;
    verdict_.reasons += std::to_string(guarantee) + ": " + reason + "\n";
  }

  [[nodiscard]] std::array<Face, 4> faces(std::size_t t) const {
    const auto& [a, b, c, d] = tets_[t];
    return {{{b, c, d}, {a, d, c}, {a, b, d}, {a, c, b}}};
  }
  [[nodiscard]] double z(std::size_t s) const { return stack_.sections[SectionId(s)].z; }
  [[nodiscard]] double height(std::size_t v) const { return model_.points[VertexId(v)].z; }
  [[nodiscard]] Point2Q below(std::size_t v) const { return {points_[v].x, points_[v].y}; }

  // Guarantee 1, in guarantee_oracle.cpp.
  void manifold();
  [[nodiscard]] bool has_regular_link(std::size_t v) const;

  // Guarantee 2, in guarantee_oracle_sections.cpp.
  void crossing();
  void resample(std::size_t s);
  // Of the region that contours bound, each counted by its depth, which has to be as in the input.
  [[nodiscard]] Rational twice_region_area(std::size_t s, const std::vector<Polygon>& contours);
  void triangles_in_region(const std::vector<Polygon>& corners,
                           const std::vector<Polygon>& contours);
  // Edges of one triangle are those of the contours, and no others.
  void boundary_edges(const std::map<Edge, int>& triangle_edges,
                      const std::vector<std::vector<std::size_t>>& ids);
  // The contours of a section with the vertices inserted into each edge, and the model's
  // vertices along them. `inserted`: the vertices in the plane that have to be on an edge if they
  // are not input. Empty where they are not.
  std::vector<Polygon> refined_contours(std::size_t s, const std::set<std::size_t>& inserted,
                                        std::vector<std::vector<std::size_t>>& ids);
  // Vertices in the plane off the contours: corners of faces there, inside the region.
  void inner_vertices(std::size_t s, const std::map<Edge, int>& triangle_edges,
                      const std::vector<Polygon>& contours,
                      const std::vector<std::vector<std::size_t>>& ids);

  // Guarantee 3, in guarantee_oracle.cpp.
  void embedded();
  [[nodiscard]] bool in_contact(const Face& a, const Face& b) const;

  [[nodiscard]] std::vector<Vector3<std::int64_t>> small_points() const;
  template <class Number>
  void find_overlaps(const std::vector<Vector3<Number>>& points);
  [[nodiscard]] bool have_coincident(const Face& a, const Face& b) const;
  template <class Number, std::size_t N>
  [[nodiscard]] static std::array<Vector3<Number>, N> corners(
      const std::vector<Vector3<Number>>& points, const std::array<std::size_t, N>& ids) {
    std::array<Vector3<Number>, N> result;
    for (std::size_t i = 0; i < N; ++i) result[i] = points[ids[i]];
    return result;
  }
  template <std::size_t N>
  [[nodiscard]] bool boxes_meet(const std::array<std::size_t, N>& a,
                                const std::array<std::size_t, N>& b) const {
    for (const auto coordinate : {&Point3::x, &Point3::y, &Point3::z}) {
      const auto less = [&](std::size_t v, std::size_t w) {
        return model_.points[VertexId(v)].*coordinate < model_.points[VertexId(w)].*coordinate;
      };
      const auto [low_a, high_a] = std::minmax_element(a.begin(), a.end(), less);
      const auto [low_b, high_b] = std::minmax_element(b.begin(), b.end(), less);
      if (less(*high_a, *low_b) || less(*high_b, *low_a)) return false;
    }
    return true;
  }

  // Guarantee 4, in guarantee_oracle_components.cpp.
  void components();

  const Model& model_;
  const SectionStack& stack_;
  const CheckOptions& options_;
  std::vector<Point3Q> points_;
  std::vector<std::array<std::size_t, 4>> tets_;
  std::map<std::size_t, std::vector<std::size_t>> star_;
  std::map<Face, std::vector<Use>> uses_;
  GuaranteeVerdicts verdict_{{true, true, true, true}, {}};
};

}  // namespace tetloft::oracle

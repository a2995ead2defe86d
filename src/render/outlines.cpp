#include "render/outlines.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <map>
#include <vector>

#include <tetloft/tet_mesh.hpp>

namespace tetloft::internal::render {

namespace {

// The two slabs that meet in each section: of tets that have the plane above or below them.
struct Planes {
  std::vector<double> z;
  std::vector<std::uint32_t> below, above;
};

Planes planes_of(const Subject& subject, const std::vector<double>& heights) {
  const double none = std::numeric_limits<double>::infinity();
  std::vector<double> low(subject.slab_count, none), high(subject.slab_count, -none);
  for (std::size_t t = 0; t < subject.tets.size(); ++t) {
    for (const VertexId v : subject.tets[t]) {
      const double z = subject.points[v.index()].z;
      low[subject.slab[t]] = std::min(low[subject.slab[t]], z);
      high[subject.slab[t]] = std::max(high[subject.slab[t]], z);
    }
  }
  Planes planes{heights, {}, {}};
  for (const double z : heights) {
    std::uint32_t below = 0;
    auto above = static_cast<std::uint32_t>(subject.slab_count - 1);
    while (below + 1 < subject.slab_count && high[below] < z) ++below;
    while (above > 0 && low[above] > z) --above;
    planes.below.push_back(std::min(below, above));
    planes.above.push_back(std::max(below, above));
  }
  return planes;
}

// The edges of the section regions of the model: in-plane edges of an odd number of in-plane
// triangles.
std::map<SectionId, std::vector<std::array<VertexId, 2>>> outlines_of(const Model& model) {
  std::map<SectionId, std::vector<TriangleVertices>> triangles;
  for (const TetVertices& tet : model.tets) {
    for (const auto& face : kFaceVertex) {
      TriangleVertices v;
      for (std::size_t i = 0; i < 3; ++i) v[i] = tet[static_cast<std::size_t>(face[i])];
      const SectionId s = model.section[v[0]];
      if (!s.valid() || model.section[v[1]] != s || model.section[v[2]] != s) continue;
      std::sort(v.begin(), v.end());
      triangles[s].push_back(v);
    }
  }
  std::map<SectionId, std::vector<std::array<VertexId, 2>>> outlines;
  for (auto& [section, all] : triangles) {
    std::sort(all.begin(), all.end());
    all.erase(std::unique(all.begin(), all.end()), all.end());
    std::vector<std::array<VertexId, 2>> edges;
    for (const TriangleVertices& v : all) {
      edges.push_back({v[0], v[1]});
      edges.push_back({v[0], v[2]});
      edges.push_back({v[1], v[2]});
    }
    std::sort(edges.begin(), edges.end());
    for (auto at = edges.begin(); at != edges.end();) {
      const auto end = std::upper_bound(at, edges.end(), *at);
      if ((end - at) % 2 != 0) outlines[section].push_back(*at);
      at = end;
    }
  }
  return outlines;
}

void add_given_contours(const SectionStack& stack, double stretch, Subject& subject) {
  const auto scaled = [&](double value) { return std::ldexp(value, -subject.exponent); };
  for (const Section& section : stack.sections) {
    subject.sections.push_back(stretch * scaled(section.z));
  }
  const Planes planes = planes_of(subject, subject.sections);
  for (std::size_t s = 0; s < stack.sections.size(); ++s) {
    for (const Contour& contour : stack.sections[SectionId(s)].contours) {
      const auto& v = contour.vertices;
      for (std::size_t i = 0; i < v.size(); ++i) {
        const Point2& p = v[i];
        const Point2& q = v[(i + 1) % v.size()];
        subject.contours.push_back({{scaled(p.x), scaled(p.y), planes.z[s]},
                                    {scaled(q.x), scaled(q.y), planes.z[s]},
                                    planes.below[s],
                                    planes.above[s]});
      }
    }
  }
}

void add_own_contours(const Model& model, Subject& subject) {
  if (model.section.size() != model.points.size()) return;
  const auto outlines = outlines_of(model);
  for (const auto& [section, edges] : outlines) {
    subject.sections.push_back(subject.points[edges.front()[0].index()].z);
  }
  const Planes planes = planes_of(subject, subject.sections);
  std::size_t s = 0;
  for (const auto& [section, edges] : outlines) {
    for (const auto& [a, b] : edges) {
      subject.contours.push_back(
          {subject.points[a.index()], subject.points[b.index()], planes.below[s], planes.above[s]});
    }
    ++s;
  }
}

}  // namespace

void add_contours(const Model& model, const SectionStack* given, double stretch, Subject& subject) {
  if (given != nullptr) {
    add_given_contours(*given, stretch, subject);
  } else {
    add_own_contours(model, subject);
  }
}

}  // namespace tetloft::internal::render

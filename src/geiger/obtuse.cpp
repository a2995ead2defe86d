#include "geiger/obtuse.hpp"

#include <map>
#include <utility>
#include <vector>

#include "core/guard.hpp"

namespace tetloft::internal::geiger {

namespace {

constexpr int kRounds = 4;

// Where the corner c of triangle (a, b, c) is obtuse: its foot on edge a–b. Roughly: which
// corners are taken is a matter of shape only.
bool foot_of(const Point2& a, const Point2& b, const Point2& c, Point2& foot) {
  const double ax = a.x - c.x, ay = a.y - c.y;
  const double bx = b.x - c.x, by = b.y - c.y;
  if (ax * bx + ay * by >= 0) return false;
  const double dx = b.x - a.x, dy = b.y - a.y;
  const double t = -(ax * dx + ay * dy) / (dx * dx + dy * dy);
  foot = {a.x + t * dx, a.y + t * dy};
  return foot != a && foot != b && t > 0 && t < 1;
}

// Contour edges below obtuse corners, from their first vertex along the contour, with the foot.
std::map<PlaneVertexId, Point2> feet_of(const ConformingSection& section) {
  std::map<PlaneVertexId, Point2> feet;
  const auto& triangles = section.triangulation.triangles;
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    if (section.internal[TriangleId(t)] == 0) continue;
    const PlaneTriangleVertices& v = triangles[TriangleId(t)];
    for (std::size_t i = 0; i < 3; ++i) {
      const PlaneVertexId a = v[(i + 1) % 3];
      const PlaneVertexId b = v[(i + 2) % 3];
      // Triangles inside are to the left of their contour edges.
      if (section.next[a] != b) continue;
      Point2 foot;
      if (foot_of(section.point(a), section.point(b), section.point(v[i]), foot)) feet[a] = foot;
    }
  }
  return feet;
}

Section rebuilt(const Section& section, const ConformingSection& conforming,
                const std::map<PlaneVertexId, Point2>& feet) {
  Section result;
  result.z = section.z;
  result.contours.resize(section.contours.size());
  std::vector<bool> done(section.contours.size(), false);
  for (std::size_t v = 0; v < conforming.vertex_count(); ++v) {
    const PlaneVertexId start(v);
    const ContourId c = conforming.contour[start];
    if (done[c.index()]) continue;
    done[c.index()] = true;
    PlaneVertexId at = start;
    do {
      result.contours[c].vertices.push_back(conforming.point(at));
      if (const auto foot = feet.find(at); foot != feet.end()) {
        result.contours[c].vertices.push_back(foot->second);
      }
      at = conforming.next[at];
    } while (at != start);
  }
  return result;
}

}  // namespace

Result<Section> with_feet(const Section& section, SectionId id, std::size_t& feet) {
  Section current = section;
  for (int round = 0; round < kRounds; ++round) {
    Result<ConformingSection> conforming = conform(current, id);
    if (!accepted(conforming)) {
      if (round == 0) return conforming.error();
      break;
    }
    const std::map<PlaneVertexId, Point2> found = feet_of(*conforming);
    if (found.empty()) break;
    SectionStack next;
    next.sections.push_back(rebuilt(current, *conforming, found));
    if (!accepted(validate(next))) break;
    current = std::move(next.sections[SectionId(0)]);
    feet += found.size();
  }
  return current;
}

}  // namespace tetloft::internal::geiger

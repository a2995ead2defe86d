#include "comparison/section_cut.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

namespace tetloft::bench {

namespace {

enum Side : unsigned { input, above, below };

// Where lines along x enter or leave a set.
struct Crossing {
  double x = 0;
  Side side = input;
};

class Lines {
 public:
  Lines(double low, double high, std::size_t count)
      : low_(low), pitch_((high - low) / static_cast<double>(count)), lines_(count) {}

  void add(Point2 a, Point2 b, Side side) {
    if (a.y > b.y) std::swap(a, b);
    const double first = std::ceil((a.y - low_) / pitch_ - 0.5) - 1;
    for (auto k = static_cast<std::size_t>(std::max(first, 0.0)); k < lines_.size(); ++k) {
      const double y = low_ + (static_cast<double>(k) + 0.5) * pitch_;
      if (y < a.y) continue;
      if (y >= b.y) break;
      lines_[k].push_back({a.x + (y - a.y) / (b.y - a.y) * (b.x - a.x), side});
    }
  }

  // Areas of the region, and of its symmetric difference with the cut.
  [[nodiscard]] std::pair<double, double> areas() {
    double region = 0, difference = 0;
    for (auto& line : lines_) {
      std::sort(line.begin(), line.end(), [](const Crossing& a, const Crossing& b) {
        return std::pair{a.x, a.side} < std::pair{b.x, b.side};
      });
      std::array<bool, 3> within{};
      for (std::size_t i = 0; i < line.size(); ++i) {
        within[line[i].side] = !within[line[i].side];
        if (i + 1 == line.size()) break;
        const double length = line[i + 1].x - line[i].x;
        if (within[input]) region += length;
        if (within[input] != (within[above] || within[below])) difference += length;
      }
    }
    return {region * pitch_, difference * pitch_};
  }

 private:
  double low_, pitch_;
  std::vector<std::vector<Crossing>> lines_;
};

// The segment that a triangle leaves just above (below) the plane, its vertices there counting as
// below (above) it.
void cut_triangle(const std::array<Point3, 3>& triangle, double z, Side side, Lines& lines) {
  const auto over = [&](const Point3& p) { return side == above ? p.z > z : p.z >= z; };
  std::array<Point2, 3> found;
  std::size_t n = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    Point3 a = triangle[k], b = triangle[(k + 1) % 3];
    if (over(a) == over(b)) continue;
    if (canonical_less(b, a)) std::swap(a, b);  // the same from both triangles of an edge
    const double t = (z - a.z) / (b.z - a.z);
    found[n++] = t == 1 ? Point2{b.x, b.y} : Point2{a.x + t * (b.x - a.x), a.y + t * (b.y - a.y)};
  }
  if (n == 2) lines.add(found[0], found[1], side);
}

// By section, the triangles that touch its plane.
std::vector<std::vector<std::size_t>> triangles_by_section(const TriangleMesh& surface,
                                                           const SectionStack& stack) {
  std::vector<double> z;
  for (const Section& section : stack.sections) z.push_back(section.z);
  std::vector<std::vector<std::size_t>> result(z.size());
  for (std::size_t i = 0; i < surface.triangles.size(); ++i) {
    const auto& [a, b, c] = surface.triangles[i];
    const auto [low, high] =
        std::minmax({surface.points[a].z, surface.points[b].z, surface.points[c].z});
    const auto first = std::lower_bound(z.begin(), z.end(), low);
    for (auto at = first; at != z.end() && *at <= high; ++at) {
      result[static_cast<std::size_t>(at - z.begin())].push_back(i);
    }
  }
  return result;
}

}  // namespace

double section_deviation(const TriangleMesh& surface, const SectionStack& stack,
                         std::size_t lines) {
  const auto by_section = triangles_by_section(surface, stack);
  double region = 0, difference = 0;
  for (std::size_t s = 0; s < stack.sections.size(); ++s) {
    const Section& section = stack.sections[SectionId(s)];
    Box3 box;
    for (const Contour& contour : section.contours) {
      for (const Point2& p : contour.vertices) box.extend({p.x, p.y, section.z});
    }
    for (const std::size_t i : by_section[s]) {
      for (const VertexId v : surface.triangles[i]) box.extend(surface.points[v]);
    }
    if (box.low.y >= box.high.y) continue;
    Lines rows(box.low.y, box.high.y, lines);
    for (const Contour& contour : section.contours) {
      const auto& v = contour.vertices;
      for (std::size_t i = 0; i < v.size(); ++i) rows.add(v[i], v[(i + 1) % v.size()], input);
    }
    for (const std::size_t i : by_section[s]) {
      const auto& [a, b, c] = surface.triangles[i];
      const std::array<Point3, 3> t{surface.points[a], surface.points[b], surface.points[c]};
      cut_triangle(t, section.z, above, rows);
      cut_triangle(t, section.z, below, rows);
    }
    const auto [of_region, of_difference] = rows.areas();
    region += of_region;
    difference += of_difference;
  }
  return region > 0 ? difference / region : 0;
}

std::size_t lost_contours(const SurfaceSearch& surface, const SectionStack& stack,
                          double tolerance) {
  std::size_t lost = 0;
  for (const Section& section : stack.sections) {
    for (const Contour& contour : section.contours) {
      const bool kept =
          std::any_of(contour.vertices.begin(), contour.vertices.end(), [&](const Point2& p) {
            return surface.distance({p.x, p.y, section.z}) <= tolerance;
          });
      lost += kept ? 0U : 1U;
    }
  }
  return lost;
}

}  // namespace tetloft::bench

#include "sections/copies.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <optional>

#include "sections/point_segment.hpp"
#include "spatial/box_tree.hpp"

namespace tetloft::internal::sections {

namespace {

/// The share of the smaller area that a strip along both contours may have.
constexpr double kCopyShare = 0x1p-8;

// A contour from its lowest vertex on, in the direction of the lower neighbour.
struct NormalContour {
  std::vector<Point2> vertices;
  double area = 0;
  double perimeter = 0;
  BoxTree2 edges{{}};

  [[nodiscard]] const Point2& at(std::size_t k) const { return vertices[k % vertices.size()]; }
};

bool vertices_less(const std::vector<Point2>& a, const std::vector<Point2>& b) {
  return std::lexicographical_compare(
      a.begin(), a.end(), b.begin(), b.end(),
      [](const Point2& p, const Point2& q) { return canonical_less(p, q); });
}

// Of a contour that passes twice through its lowest vertex, the lesser of the ways to begin.
std::vector<Point2> normal_vertices(const std::vector<Point2>& given) {
  const Point2 low =
      *std::min_element(given.begin(), given.end(),
                        [](const Point2& p, const Point2& q) { return canonical_less(p, q); });
  std::vector<Point2> best;
  for (std::size_t k = 0; k < given.size(); ++k) {
    if (!(given[k] == low)) continue;
    std::vector<Point2> turned(given);
    std::rotate(turned.begin(), turned.begin() + static_cast<std::ptrdiff_t>(k), turned.end());
    for (int way = 0; way < 2; ++way) {
      if (best.empty() || vertices_less(turned, best)) best = turned;
      std::reverse(turned.begin() + 1, turned.end());
    }
  }
  return best;
}

NormalContour normal(const Contour& contour) {
  NormalContour result;
  result.vertices = normal_vertices(contour.vertices);
  std::vector<Box2> boxes;
  double twice = 0;
  const Point2& o = result.vertices.front();
  for (std::size_t k = 0; k < result.vertices.size(); ++k) {
    const Point2& a = result.at(k);
    const Point2& b = result.at(k + 1);
    twice += (a.x - o.x) * (b.y - o.y) - (a.y - o.y) * (b.x - o.x);
    result.perimeter += std::sqrt(square_distance(a, b));
    boxes.push_back(box_of(a, b));
  }
  result.area = std::abs(twice) / 2;
  result.edges = BoxTree2(boxes);
  return result;
}

// How far the vertices of a lie from b at most; nothing where that is more than `most`.
std::optional<double> apart(const NormalContour& a, const NormalContour& b, double most) {
  double farthest = 0;
  for (const Point2& p : a.vertices) {
    double nearest = INFINITY;
    b.edges.query({p.x - most, p.y - most, p.x + most, p.y + most}, [&](std::size_t k) {
      nearest = std::min(nearest, square_distance(p, b.at(k), b.at(k + 1)));
    });
    if (nearest > most * most) return std::nullopt;
    farthest = std::max(farthest, nearest);
  }
  return std::sqrt(farthest);
}

// How far apart two contours are that are copies of each other.
std::optional<double> copies_apart(const NormalContour& a, const NormalContour& b) {
  if (a.vertices == b.vertices) return 0;
  const double most = kCopyShare * std::min(a.area, b.area) / (a.perimeter + b.perimeter);
  if (!(most > 0) || std::abs(a.area - b.area) > kCopyShare * std::min(a.area, b.area)) return {};
  const auto there = apart(a, b, most);
  if (!there) return {};
  const auto back = apart(b, a, most);
  if (!back) return {};
  return std::max(*there, *back);
}

}  // namespace

std::vector<Copy> find_copies(const Section& section,
                              const std::vector<std::pair<ContourId, ContourId>>& touching) {
  std::map<ContourId, NormalContour> contours;
  std::map<ContourId, std::vector<ContourId>> others;
  for (const auto& [c, d] : touching) {
    for (const ContourId one : {c, d}) {
      if (contours.count(one) == 0) contours.emplace(one, normal(section.contours[one]));
    }
    others[c].push_back(d);
    others[d].push_back(c);
  }
  // The largest first; equal ones by their vertices, then by number.
  std::vector<ContourId> order;
  for (const auto& [c, contour] : contours) order.push_back(c);
  std::stable_sort(order.begin(), order.end(), [&](ContourId c, ContourId d) {
    const NormalContour& a = contours.at(c);
    const NormalContour& b = contours.at(d);
    return a.area != b.area ? a.area > b.area : vertices_less(a.vertices, b.vertices);
  });
  std::vector<Copy> copies;
  std::map<ContourId, bool> kept;
  for (const ContourId c : order) {
    std::optional<Copy> copy;
    for (const ContourId d : others[c]) {
      if (!kept[d]) continue;
      const auto apart = copies_apart(contours.at(c), contours.at(d));
      if (apart && (!copy || *apart < copy->apart)) copy = Copy{c, d, *apart};
    }
    if (copy) {
      copies.push_back(*copy);
    } else {
      kept[c] = true;
    }
  }
  std::sort(copies.begin(), copies.end(),
            [](const Copy& a, const Copy& b) { return a.contour < b.contour; });
  return copies;
}

}  // namespace tetloft::internal::sections

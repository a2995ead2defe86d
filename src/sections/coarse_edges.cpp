#include "sections/coarse_edges.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>

#include <tetloft/predicates.hpp>

#include "sections/equal_parts.hpp"
#include "sections/local_width.hpp"
#include "spatial/box_tree.hpp"

namespace tetloft::internal::sections {

namespace {

// Contours from images have 18 vertices or more in the median over vertices, of sliced meshes 23.
constexpr std::size_t kFewVertices = 12;
// Of the perimeter: between an edge of a regular 12-gon and one of a 13-gon.
constexpr double kLongShare = 0.08;
// Times the usual edge of contours that are not coarse. Small contours of images have edges of once
// or twice that; of solids of plane faces, sliced, some have 30 times, and their stacks gain
// nothing.
constexpr double kTimesInCoarse = 4;
constexpr double kTimesInDense = 32;
// Of the width; a fifth takes a quarter more vertices and is no better.
constexpr double kPiece = 0.25;
constexpr double kMostParts = 16;

struct Edge {
  Point2 low, high;
  double length = 0;
};

Edge edge_between(const Point2& a, const Point2& b) {
  const bool forward = canonical_less(a, b);
  const Point2& low = forward ? a : b;
  const Point2& high = forward ? b : a;
  const double dx = high.x - low.x;
  const double dy = high.y - low.y;
  return {low, high, std::sqrt(dx * dx + dy * dy)};
}

std::vector<Edge> edges_of(const Contour& contour) {
  std::vector<Edge> edges;
  const std::size_t n = contour.vertices.size();
  edges.reserve(n);
  for (std::size_t k = 0; k < n; ++k) {
    edges.push_back(edge_between(contour.vertices[k], contour.vertices[(k + 1) % n]));
  }
  return edges;
}

// The same wherever a contour starts.
double sum_of_sorted(const std::vector<double>& lengths) {
  double sum = 0;
  for (const double length : lengths) sum += length;
  return sum;
}

double perimeter_of(const std::vector<Edge>& edges) {
  std::vector<double> lengths;
  lengths.reserve(edges.size());
  for (const Edge& edge : edges) lengths.push_back(edge.length);
  std::sort(lengths.begin(), lengths.end());
  return sum_of_sorted(lengths);
}

bool is_coarse(const Contour& contour) { return contour.vertices.size() <= kFewVertices; }

// Half of the length of all lies in ones of at most this.
double usual(const EdgeTally::Increasing& lengths) {
  double all = 0;
  lengths([&](double length) {
    all += length;
    return true;
  });
  double sum = 0;
  double found = 0;
  lengths([&](double length) {
    sum += length;
    found = length;
    return 2 * sum < all;
  });
  return found;
}

// The contours of a section, to ask what lies on them.
class Contours {
 public:
  explicit Contours(const Section& section) : edges_(all_edges(section)), tree_(boxes(edges_)) {}

  // Does all of an edge lie on them?
  [[nodiscard]] bool hold(const Edge& edge) const {
    std::vector<std::pair<Point2, Point2>> along;
    tree_.query(box_of(edge.low, edge.high), [&](std::size_t k) {
      const Edge& other = edges_[k];
      if (orient2d(edge.low, edge.high, other.low) == Sign::zero &&
          orient2d(edge.low, edge.high, other.high) == Sign::zero) {
        along.emplace_back(other.low, other.high);
      }
    });
    std::sort(along.begin(), along.end(),
              [](const auto& a, const auto& b) { return canonical_less(a.first, b.first); });
    Point2 reached = edge.low;
    for (const auto& [low, high] : along) {
      if (canonical_less(reached, low)) return false;
      if (canonical_less(reached, high)) reached = high;
    }
    return !canonical_less(reached, edge.high);
  }

 private:
  static std::vector<Edge> all_edges(const Section& section) {
    std::vector<Edge> edges;
    for (const Contour& contour : section.contours) {
      for (const Edge& edge : edges_of(contour)) edges.push_back(edge);
    }
    return edges;
  }
  static std::vector<Box2> boxes(const std::vector<Edge>& edges) {
    std::vector<Box2> boxes;
    boxes.reserve(edges.size());
    for (const Edge& edge : edges) boxes.push_back(box_of(edge.low, edge.high));
    return boxes;
  }

  std::vector<Edge> edges_;
  BoxTree2 tree_;
};

// What decides about the edges of a section.
class Around {
 public:
  Around(const Section& section, std::span<const Section* const> neighbours) : width_(section) {
    for (const Section* neighbour : neighbours) {
      if (!neighbour->contours.empty()) beside_.emplace_back(*neighbour);
    }
  }

  // Does it lie on contours of each neighbour that has any, as where these go straight up?
  [[nodiscard]] bool goes_on(const Edge& edge) const {
    return std::all_of(beside_.begin(), beside_.end(),
                       [&](const Contours& contours) { return contours.hold(edge); });
  }
  // By the width at the edge; the edge where that is longer.
  [[nodiscard]] double piece(const Edge& edge) const {
    return kPiece * width_.at_middle(edge.low, edge.high, edge.length / kPiece);
  }

 private:
  std::vector<Contours> beside_;
  LocalWidth width_;
};

// Divides some of a contour's edges, and those beside them on it.
void append_divisions(ContourId contour, const std::vector<Edge>& edges,
                      const std::vector<std::uint8_t>& to_divide, const Around& around,
                      std::vector<EdgeDivision>& divisions) {
  const std::size_t n = edges.size();
  std::vector<double> piece;
  piece.reserve(n);
  for (const Edge& edge : edges) piece.push_back(around.piece(edge));
  for (std::size_t k = 0; k < n; ++k) {
    const std::size_t before = (k + n - 1) % n;
    const std::size_t after = (k + 1) % n;
    if (to_divide[k] == 0 && to_divide[before] == 0 && to_divide[after] == 0) continue;
    double least = piece[k];
    if (to_divide[before] != 0) least = std::min(least, piece[before]);
    if (to_divide[after] != 0) least = std::min(least, piece[after]);
    // The nearest number: a square's sides, turned, have four parts each whatever rounding does.
    const double parts = std::min(kMostParts, std::floor(edges[k].length / least + 0.5));
    if (parts > 1) divisions.push_back({contour, k, static_cast<std::uint32_t>(parts)});
  }
}

// The edges of a coarse contour that are long; empty where none is.
std::vector<std::uint8_t> long_edges(const std::vector<Edge>& edges, double least_long) {
  const double least = kLongShare * perimeter_of(edges);
  std::vector<std::uint8_t> is_long;
  bool any = false;
  for (const Edge& edge : edges) {
    is_long.push_back(edge.length >= least && edge.length > least_long ? 1 : 0);
    any = any || is_long.back() != 0;
  }
  if (!any) is_long.clear();
  return is_long;
}

}  // namespace

CoarseShare coarse_vertices(const Section& section) {
  CoarseShare share;
  for (const Contour& contour : section.contours) {
    share.all += contour.vertices.size();
    if (is_coarse(contour)) share.coarse += contour.vertices.size();
  }
  return share;
}

void EdgeTally::add(const Section& section, const std::function<void(double)>& keep) {
  if (section.contours.empty()) return;
  const CoarseShare here = coarse_vertices(section);
  vertices_.add(here);
  sections_.coarse += here.is_half() ? 1U : 0U;
  ++sections_.all;
  for (const Contour& contour : section.contours) {
    if (is_coarse(contour)) continue;
    const std::vector<Edge> edges = edges_of(contour);
    const double perimeter = perimeter_of(edges);
    for (const Edge& edge : edges) {
      if (edge.length < kLongShare * perimeter) keep(edge.length);
    }
  }
}

// Coarse is a stack where half of all vertices lie on coarse contours, or in half of its sections
// half of them.
double EdgeTally::least_long(const Increasing& lengths) const {
  const bool coarse = vertices_.is_half() || sections_.is_half();
  return (coarse ? kTimesInCoarse : kTimesInDense) * usual(lengths);
}

double least_long_edge(const SectionStack& stack) {
  EdgeTally tally;
  std::vector<double> lengths;
  for (const Section& section : stack.sections) {
    tally.add(section, [&](double length) { lengths.push_back(length); });
  }
  std::sort(lengths.begin(), lengths.end());
  return tally.least_long([&](const std::function<bool(double)>& visit) {
    for (const double length : lengths) {
      if (!visit(length)) return;
    }
  });
}

std::vector<EdgeDivision> divide_coarse_edges(const Section& section,
                                              std::span<const Section* const> neighbours,
                                              double least_long) {
  std::vector<EdgeDivision> divisions;
  std::optional<Around> around;  // made where there may be something to divide
  for (const ContourId c : section.contours.ids()) {
    if (!is_coarse(section.contours[c])) continue;
    const std::vector<Edge> edges = edges_of(section.contours[c]);
    std::vector<std::uint8_t> to_divide = long_edges(edges, least_long);
    if (to_divide.empty()) continue;
    if (!around) around.emplace(section, neighbours);
    for (std::size_t k = 0; k < edges.size(); ++k) {
      if (to_divide[k] != 0 && around->goes_on(edges[k])) to_divide[k] = 0;
    }
    if (std::find(to_divide.begin(), to_divide.end(), 1) == to_divide.end()) continue;
    append_divisions(c, edges, to_divide, *around, divisions);
  }
  return divisions;
}

Section divided(const Section& section, std::span<const EdgeDivision> divisions) {
  Section result = section;
  for (Contour& contour : result.contours) contour.vertices.clear();
  auto division = divisions.begin();
  for (const ContourId c : section.contours.ids()) {
    const std::vector<Point2>& vertices = section.contours[c].vertices;
    for (std::size_t v = 0; v < vertices.size(); ++v) {
      const bool here =
          division != divisions.end() && division->contour == c && division->edge == v;
      append_parts(vertices[v], vertices[(v + 1) % vertices.size()], here ? (division++)->parts : 1,
                   result.contours[c].vertices);
    }
  }
  return result;
}

}  // namespace tetloft::internal::sections

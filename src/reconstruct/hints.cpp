#include "reconstruct/hints.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <string>
#include <vector>

#include <tetloft/overlap.hpp>
#include <tetloft/predicates.hpp>

#include "core/unit_of_length.hpp"
#include "spatial/box_tree.hpp"

namespace tetloft::internal {

namespace {

// Choices, all but the last: with them no stack from images and no sliced mesh at hand is coarse.
constexpr std::size_t kFewVertices = 12;  // of a contour that may be coarse
constexpr double kLongEdge = 1.0 / 12;    // of the perimeter
constexpr double kCoarsePart = 0.5;       // of the length of all contours, in edges to be divided
// Pieces of a quarter of the width are enough, of an eighth near the best; area over perimeter is a
// quarter of the width of a square, and half of that of a long strip.
constexpr double kPiece = 0.5;

// Sections as they are cut have 4 to 7 tets to a vertex, coarse ones up to 13.
constexpr std::size_t kManyTets = 24;
constexpr std::size_t kTetsThatMatter = 4096;  // a slab of fewer takes no time

std::string digits(double value, int precision) {
  char text[32];
  return {
      text,
      std::to_chars(text, text + sizeof text, value, std::chars_format::general, precision).ptr};
}

double distance(const Point2& a, const Point2& b) {
  const double dx = b.x - a.x;
  const double dy = b.y - a.y;
  return std::sqrt(dx * dx + dy * dy);
}

double median(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

struct Edge {
  Point2 a, b;
};

std::vector<Edge> edges_of(const Contour& contour) {
  std::vector<Edge> edges;
  const auto& vertices = contour.vertices;
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    edges.push_back({vertices[i], vertices[(i + 1) % vertices.size()]});
  }
  return edges;
}

// The edges of a section, to ask what lies on one of them.
class SectionEdges {
 public:
  explicit SectionEdges(const Section& section)
      : edges_(all_edges(section)), tree_(boxes_of(edges_)) {}

  [[nodiscard]] bool empty() const { return edges_.empty(); }
  // As a whole, on one edge.
  [[nodiscard]] bool cover(const Edge& edge) const {
    bool covered = false;
    const Box2 box = box_of(edge.a, edge.b);
    tree_.query(box, [&](std::size_t k) {
      const Edge& other = edges_[k];
      const Box2 around = box_of(other.a, other.b);
      covered =
          covered || (around.x0 <= box.x0 && box.x1 <= around.x1 && around.y0 <= box.y0 &&
                      box.y1 <= around.y1 && orient2d(other.a, other.b, edge.a) == Sign::zero &&
                      orient2d(other.a, other.b, edge.b) == Sign::zero);
    });
    return covered;
  }

 private:
  static std::vector<Edge> all_edges(const Section& section) {
    std::vector<Edge> edges;
    for (const Contour& contour : section.contours) {
      for (const Edge& edge : edges_of(contour)) edges.push_back(edge);
    }
    return edges;
  }
  static std::vector<Box2> boxes_of(const std::vector<Edge>& edges) {
    std::vector<Box2> boxes;
    for (const Edge& edge : edges) boxes.push_back(box_of(edge.a, edge.b));
    return boxes;
  }

  std::vector<Edge> edges_;
  BoxTree2 tree_;
};

// Do half of all vertices lie on contours of few?
bool has_few_vertices(const SectionStack& stack) {
  std::size_t on_coarse = 0;
  for (const Section& section : stack.sections) {
    for (const Contour& contour : section.contours) {
      if (contour.vertices.size() <= kFewVertices) on_coarse += contour.vertices.size();
    }
  }
  return 2 * on_coarse >= stack.vertex_count();
}

// How much of a stack's contours is edges that the neighbouring sections do not continue.
struct Coarseness {
  double length = 0;
  double divided = 0;           // of the length
  std::vector<double> quarter;  // area over perimeter, of each contour with such edges
};

Coarseness coarseness(const SectionStack& stack) {
  IdVector<SectionId, SectionEdges> edges;
  for (const Section& section : stack.sections) edges.push_back(SectionEdges(section));
  Coarseness result;
  for (const SectionId s : stack.sections.ids()) {
    std::vector<const SectionEdges*> neighbours;
    if (s.index() > 0) neighbours.push_back(&edges[SectionId(s.index() - 1)]);
    if (s.index() + 1 < edges.size()) neighbours.push_back(&edges[SectionId(s.index() + 1)]);
    std::erase_if(neighbours, [](const SectionEdges* other) { return other->empty(); });
    for (const Contour& contour : stack.sections[s].contours) {
      double perimeter = 0;
      for (const Edge& edge : edges_of(contour)) perimeter += distance(edge.a, edge.b);
      double divided = 0;
      for (const Edge& edge : edges_of(contour)) {
        const double length = distance(edge.a, edge.b);
        const bool goes_on = std::all_of(neighbours.begin(), neighbours.end(),
                                         [&](const auto* other) { return other->cover(edge); });
        if (length >= kLongEdge * perimeter && !goes_on) divided += length;
      }
      result.length += perimeter;
      result.divided += divided;
      if (divided > 0) result.quarter.push_back(std::abs(twice_area(contour)) / 2 / perimeter);
    }
  }
  return result;
}

}  // namespace

std::optional<Warning> hint_of_coarse_contours(const PreparedStack& prepared) {
  if (!has_few_vertices(prepared.stack)) return std::nullopt;
  const Coarseness coarse = coarseness(prepared.stack);
  if (!(coarse.divided > kCoarsePart * coarse.length)) return std::nullopt;
  const double piece = scaled(kPiece * median(coarse.quarter), -prepared.exponent);
  return Warning{
      "contours have few vertices and change from section to section: what lies between "
      "is coarse; edges divided to at most " +
          digits(piece, 2) + " (--refine) come nearer to what is meant",
      {}};
}

namespace {

struct Partners {
  std::size_t regions = 0;  // that have a neighbouring section that is not empty
  std::size_t without = 0;
};

Partners count_partners(const PreparedStack& prepared, const StackCandidates& candidates) {
  IdVector<SectionId, IdVector<RegionId, std::uint8_t>> has;
  for (const Nesting& nesting : prepared.nestings) {
    has.push_back(IdVector<RegionId, std::uint8_t>(nesting.outer.size()));
  }
  for (const SlabCandidates& of_slab : candidates) {
    for (const LinkCandidate& candidate : of_slab) {
      if (candidate.evidence == Evidence::lone || candidate.fate == LinkFate::too_weak ||
          candidate.fate == LinkFate::outruled) {
        continue;
      }
      has[lower_section(candidate.link.slab)][candidate.link.lower] = 1;
      has[upper_section(candidate.link.slab)][candidate.link.upper] = 1;
    }
  }
  Partners result;
  for (const SectionId s : has.ids()) {
    const bool below = s.index() > 0 && !has[SectionId(s.index() - 1)].empty();
    const bool above = s.index() + 1 < has.size() && !has[SectionId(s.index() + 1)].empty();
    if (!below && !above) continue;
    result.regions += has[s].size();
    result.without += static_cast<std::size_t>(std::count(has[s].begin(), has[s].end(), 0));
  }
  return result;
}

// Of all regions, holes left out: the side of a square of the same area, in the middle.
double typical_size(const PreparedStack& prepared) {
  std::vector<double> sizes;
  for (const SectionId s : prepared.nestings.ids()) {
    const Section& section = prepared.stack.sections[s];
    const Nesting& nesting = prepared.nestings[s];
    for (const RegionId r : nesting.outer.ids()) {
      sizes.push_back(std::sqrt(area(outline(section, nesting, r))));
    }
  }
  return median(std::move(sizes));
}

double typical_gap(const SectionStack& stack) {
  std::vector<double> gaps;
  for (std::size_t s = 1; s < stack.sections.size(); ++s) {
    gaps.push_back(stack.sections[SectionId(s)].z - stack.sections[SectionId(s - 1)].z);
  }
  return median(std::move(gaps));
}

}  // namespace

std::optional<Warning> hint_of_missing_partners(const PreparedStack& prepared,
                                                const StackCandidates& candidates) {
  const Partners partners = count_partners(prepared, candidates);
  if (2 * partners.without <= partners.regions) return std::nullopt;
  const double size = typical_size(prepared);
  const double gap = typical_gap(prepared.stack);
  return Warning{std::to_string(partners.without) + " of " + std::to_string(partners.regions) +
                     " regions meet none of a neighbouring section, as they lie or as they move: "
                     "the gap, " +
                     digits(scaled(gap, -prepared.exponent), 3) + ", over the size of a region, " +
                     digits(scaled(size, -prepared.exponent), 3) + ", is " + digits(gap / size, 2) +
                     "; sections are too far apart, or z has another unit than x and y",
                 {}};
}

std::optional<Warning> hint_of_many_tets(const PreparedStack& prepared, const Model& model) {
  if (prepared.section_count() < 2) return std::nullopt;
  IdVector<SlabId, std::size_t> tets(prepared.slab_count());
  for (const SlabId slab : model.slab) ++tets[slab];
  const SlabId most(std::max_element(tets.begin(), tets.end()) - tets.begin());
  const std::size_t vertices = prepared.sections[lower_section(most)].vertex_count() +
                               prepared.sections[upper_section(most)].vertex_count();
  if (tets[most] < kTetsThatMatter || tets[most] <= kManyTets * vertices) return std::nullopt;
  Place place;
  place.slab = most.index();
  return Warning{
      std::to_string(tets[most]) + " tets of " + std::to_string(vertices) +
          " vertices, as where round contours of many vertices lie about nearly the same "
          "centre; coordinates rounded to 16 bits, or fewer (--snap 16), make far fewer",
      place};
}

}  // namespace tetloft::internal

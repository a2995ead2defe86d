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

// The edges of a section, to ask what shares one of them.
class SectionEdges {
 public:
  explicit SectionEdges(const Section& section)
      : edges_(all_edges(section)), tree_(boxes_of(edges_)) {}

  [[nodiscard]] bool empty() const { return edges_.empty(); }
  // Does half of it lie on one of them, as where a contour goes straight up?
  [[nodiscard]] bool continue_half_of(const Edge& edge) const {
    bool continued = false;
    const Box2 box = box_of(edge.a, edge.b);
    tree_.query(box, [&](std::size_t k) {
      const Edge& other = edges_[k];
      const Box2 around = box_of(other.a, other.b);
      const double along_x = std::min(box.x1, around.x1) - std::max(box.x0, around.x0);
      const double along_y = std::min(box.y1, around.y1) - std::max(box.y0, around.y0);
      continued = continued || (2 * along_x >= box.x1 - box.x0 && 2 * along_y >= box.y1 - box.y0 &&
                                orient2d(other.a, other.b, edge.a) == Sign::zero &&
                                orient2d(other.a, other.b, edge.b) == Sign::zero);
    });
    return continued;
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

using RegionFlags = IdVector<SectionId, IdVector<RegionId, std::uint8_t>>;

RegionFlags no_regions(const PreparedStack& prepared) {
  RegionFlags flags;
  for (const Nesting& nesting : prepared.nestings) {
    flags.push_back(IdVector<RegionId, std::uint8_t>(nesting.outer.size()));
  }
  return flags;
}

void mark(RegionFlags& flags, const Link& link) {
  flags[lower_section(link.slab)][link.lower] = 1;
  flags[upper_section(link.slab)][link.upper] = 1;
}

// Of the sections beside one, those that are not empty.
std::vector<const SectionEdges*> beside(SectionId s,
                                        const IdVector<SectionId, SectionEdges>& edges) {
  std::vector<const SectionEdges*> neighbours;
  if (s.index() > 0) neighbours.push_back(&edges[SectionId(s.index() - 1)]);
  if (s.index() + 1 < edges.size()) neighbours.push_back(&edges[SectionId(s.index() + 1)]);
  std::erase_if(neighbours, [](const SectionEdges* other) { return other->empty(); });
  return neighbours;
}

Coarseness coarseness(const PreparedStack& prepared, const RegionFlags& linked) {
  IdVector<SectionId, SectionEdges> edges;
  for (const Section& section : prepared.stack.sections) edges.push_back(SectionEdges(section));
  Coarseness result;
  for (const SectionId s : edges.ids()) {
    const std::vector<const SectionEdges*> neighbours = beside(s, edges);
    const Section& section = prepared.stack.sections[s];
    for (const ContourId c : section.contours.ids()) {
      const std::vector<Edge> of_contour = edges_of(section.contours[c]);
      double perimeter = 0;
      for (const Edge& edge : of_contour) perimeter += distance(edge.a, edge.b);
      result.length += perimeter;
      if (linked[s][prepared.nestings[s].region[c]] == 0) continue;
      double divided = 0;
      for (const Edge& edge : of_contour) {
        const double length = distance(edge.a, edge.b);
        const bool goes_on =
            std::all_of(neighbours.begin(), neighbours.end(),
                        [&](const auto* other) { return other->continue_half_of(edge); });
        if (length >= kLongEdge * perimeter && !goes_on) divided += length;
      }
      if (divided == 0) continue;
      result.divided += divided;
      result.quarter.push_back(std::abs(twice_area(section.contours[c])) / 2 / perimeter);
    }
  }
  return result;
}

}  // namespace

std::optional<Warning> hint_of_coarse_contours(const PreparedStack& prepared,
                                               const Correspondence& decided) {
  if (!has_few_vertices(prepared.stack)) return std::nullopt;
  RegionFlags linked = no_regions(prepared);
  for (const auto& of_slab : decided.links) {
    for (const Link& link : of_slab) mark(linked, link);
  }
  const Coarseness coarse = coarseness(prepared, linked);
  if (!(coarse.divided > kCoarsePart * coarse.length)) return std::nullopt;
  const double piece = scaled(kPiece * median(coarse.quarter), -prepared.exponent);
  return Warning{
      "contours have few vertices and change from section to section: what lies between "
      "is coarse; edges divided to at most " +
          digits(piece, 2) + " (--refine) come nearer to what is meant",
      {}};
}

namespace {

struct PartnerCounts {
  std::size_t regions = 0;  // that have a neighbouring section that is not empty
  std::size_t without = 0;
};

PartnerCounts count_partners(const PreparedStack& prepared, const StackCandidates& candidates) {
  RegionFlags has = no_regions(prepared);
  for (const SlabCandidates& of_slab : candidates) {
    for (const LinkCandidate& candidate : of_slab) {
      if (candidate.evidence == Evidence::lone || candidate.fate == LinkFate::too_weak ||
          candidate.fate == LinkFate::outruled) {
        continue;
      }
      mark(has, candidate.link);
    }
  }
  PartnerCounts result;
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
  const PartnerCounts partners = count_partners(prepared, candidates);
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

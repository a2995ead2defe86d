#include "reconstruct/hints.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <string>
#include <vector>

#include <tetloft/overlap.hpp>
#include <tetloft/predicates.hpp>

#include "core/unit_of_length.hpp"
#include "sections/coarse_edges.hpp"
#include "spatial/box_tree.hpp"

namespace tetloft::internal {

namespace {

// Choices, all but the last: with them no stack from images and no sliced mesh at hand is coarse.
constexpr double kLongEdge = 1.0 / 12;  // of the perimeter
constexpr double kCoarsePart = 0.5;     // of the length of all contours, in edges to be divided
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
std::vector<SectionEdges> edges_beside(const PreparedStack& window, SectionId s) {
  std::vector<SectionEdges> neighbours;
  for (const Section* neighbour : window.neighbours(s)) {
    if (!neighbour->contours.empty()) neighbours.emplace_back(*neighbour);
  }
  return neighbours;
}

}  // namespace

void add_coarseness(const PreparedStack& window, const IdVector<SlabId, std::vector<Link>>& links,
                    SectionId first, SectionId end, Coarseness& sum) {
  RegionFlags linked = no_regions(window);
  for (const auto& of_slab : links) {
    for (const Link& link : of_slab) mark(linked, link);
  }
  for (SectionId s = first; s < end; s = SectionId(s.index() + 1)) {
    const std::vector<SectionEdges> neighbours = edges_beside(window, s);
    const Section& section = window.stack.sections[s];
    for (const ContourId c : section.contours.ids()) {
      const std::vector<Edge> of_contour = edges_of(section.contours[c]);
      double perimeter = 0;
      for (const Edge& edge : of_contour) perimeter += distance(edge.a, edge.b);
      sum.length += perimeter;
      if (linked[s][window.nestings[s].region[c]] == 0) continue;
      double divided = 0;
      for (const Edge& edge : of_contour) {
        const double length = distance(edge.a, edge.b);
        const bool goes_on =
            std::all_of(neighbours.begin(), neighbours.end(),
                        [&](const auto& other) { return other.continue_half_of(edge); });
        if (length >= kLongEdge * perimeter && !goes_on) divided += length;
      }
      if (divided == 0) continue;
      sum.divided += divided;
      sum.quarter.push_back(std::abs(twice_area(section.contours[c])) / 2 / perimeter);
    }
  }
}

std::optional<Warning> hint_of(const Coarseness& whole, int exponent) {
  if (!(whole.divided > kCoarsePart * whole.length)) return std::nullopt;
  const double piece = scaled(kPiece * median(whole.quarter), -exponent);
  return Warning{
      "contours have few vertices and change from section to section: what lies between "
      "is coarse; edges divided to at most " +
          digits(piece, 2) + " (--refine) come nearer to what is meant",
      {}};
}

std::optional<Warning> hint_of_coarse_contours(const PreparedStack& prepared,
                                               const Correspondence& decided) {
  sections::CoarseShare vertices;
  for (const Section& section : prepared.stack.sections) {
    vertices.add(sections::coarse_vertices(section));
  }
  if (!vertices.is_half()) return std::nullopt;
  Coarseness whole;
  add_coarseness(prepared, decided.links, SectionId(0), SectionId(prepared.section_count()), whole);
  return hint_of(whole, prepared.exponent);
}

void add_partners(const PreparedStack& window, const StackCandidates& candidates, SectionId first,
                  SectionId end, PartnerCounts& sum) {
  RegionFlags has = no_regions(window);
  for (const SlabCandidates& of_slab : candidates) {
    for (const LinkCandidate& candidate : of_slab) {
      if (candidate.evidence == Evidence::lone || candidate.fate == LinkFate::too_weak ||
          candidate.fate == LinkFate::outruled) {
        continue;
      }
      mark(has, candidate.link);
    }
  }
  for (SectionId s = first; s < end; s = SectionId(s.index() + 1)) {
    const bool below = s.index() > 0 && !has[SectionId(s.index() - 1)].empty();
    const bool above = s.index() + 1 < has.size() && !has[SectionId(s.index() + 1)].empty();
    if (!below && !above) continue;
    sum.regions += has[s].size();
    sum.without += static_cast<std::size_t>(std::count(has[s].begin(), has[s].end(), 0));
  }
}

bool misses_partners(const PartnerCounts& whole) { return 2 * whole.without > whole.regions; }

void append_sizes(const Section& section, const Nesting& nesting, std::vector<double>& sizes) {
  for (const RegionId r : nesting.outer.ids()) {
    sizes.push_back(std::sqrt(area(outline(section, nesting, r))));
  }
}

Warning hint_of(const PartnerCounts& whole, std::vector<double> gaps, std::vector<double> sizes,
                int exponent) {
  const double size = median(std::move(sizes));
  const double gap = median(std::move(gaps));
  return {std::to_string(whole.without) + " of " + std::to_string(whole.regions) +
              " regions meet none of a neighbouring section, as they lie or as they move: "
              "the gap, " +
              digits(scaled(gap, -exponent), 3) + ", over the size of a region, " +
              digits(scaled(size, -exponent), 3) + ", is " + digits(gap / size, 2) +
              "; sections are too far apart, or z has another unit than x and y",
          {}};
}

std::optional<Warning> hint_of_missing_partners(const PreparedStack& prepared,
                                                const StackCandidates& candidates) {
  PartnerCounts whole;
  add_partners(prepared, candidates, SectionId(0), SectionId(prepared.section_count()), whole);
  if (!misses_partners(whole)) return std::nullopt;
  const IdVector<SectionId, Section>& sections = prepared.stack.sections;
  std::vector<double> gaps;
  for (std::size_t s = 1; s < sections.size(); ++s) {
    gaps.push_back(sections[SectionId(s)].z - sections[SectionId(s - 1)].z);
  }
  std::vector<double> sizes;
  for (const SectionId s : sections.ids()) {
    append_sizes(sections[s], prepared.nestings[s], sizes);
  }
  return hint_of(whole, std::move(gaps), std::move(sizes), prepared.exponent);
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

#include "between/sections_between.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/sort_distinct.hpp"
#include "core/union_find.hpp"
#include "slab/numbering.hpp"
#include "spatial/box_tree.hpp"

namespace tetloft::internal {

namespace {

using between::Around;
using between::ClassOutlines;
using between::SlabClass;

// No slab gets more by itself.
constexpr double kMostByItself = 5;
// Sections are this many contour edges apart, at least.
constexpr double kEdgesPerLayer = 2;
// Steps of the lattice: half a contour edge, or a quarter of the width if that is less; of which
// the larger side of the sections has so many at least, and at most.
constexpr double kLeastSteps = 64;
constexpr double kMostSteps = 512;
// Distances matter as far as a gap: one much larger than the sections takes a coarser lattice.
constexpr double kMostStepsPerGap = 64;
// Of all classes and layers of a slab; windows of classes may lie over each other, hundreds deep.
constexpr double kMostSamples = 0x1p24;
// So often the step that contours ask for is doubled for that; beyond, it tells little.
constexpr int kMostCoarsenings = 2;
constexpr double kWindowMargin = 8;  // of a window, in steps
// A class of fewer steps along its larger side has no shape on the lattice, but that of a sample.
constexpr double kFewestSteps = 4;

// A contour from its lowest vertex on, towards the lower of that one's neighbours.
struct CanonicalContour {
  std::vector<Point2> vertices;
  bool hole = false;
  friend bool operator==(const CanonicalContour&, const CanonicalContour&) = default;
};

// The contours of a section as a set, by their lowest vertices.
std::vector<CanonicalContour> canonical_contours(const LinkedStack& stacked, SectionId s) {
  std::vector<CanonicalContour> contours;
  const auto& depth = stacked.nestings[s].depth;
  for (const ContourId c : depth.ids()) {
    std::vector<Point2> vertices = stacked.stack.sections[s].contours[c].vertices;
    std::rotate(
        vertices.begin(),
        std::min_element(vertices.begin(), vertices.end(),
                         [](const Point2& a, const Point2& b) { return canonical_less(a, b); }),
        vertices.end());
    if (canonical_less(vertices.back(), vertices[1])) {
      std::reverse(vertices.begin() + 1, vertices.end());
    }
    contours.push_back({std::move(vertices), depth[c] % 2 != 0});
  }
  std::sort(contours.begin(), contours.end(), [](const auto& a, const auto& b) {
    return canonical_less(a.vertices.front(), b.vertices.front());
  });
  return contours;
}

/// The contour edges of a section, or two, and what they bound.
struct Edges {
  double length = 0;
  double area = 0;
  std::size_t count = 0;
  Box2 box;

  [[nodiscard]] double mean() const { return length / static_cast<double>(count); }
  [[nodiscard]] double side() const { return std::max(box.x1 - box.x0, box.y1 - box.y0); }
  /// Of long strips of this area, and these edges around them, the width.
  [[nodiscard]] double width() const { return 2 * area / length; }
};

Edges edges_of(const std::vector<CanonicalContour>& contours) {
  Edges edges;
  for (const CanonicalContour& contour : contours) {
    const Point2& first = contour.vertices.front();
    Point2 last = contour.vertices.back();
    double twice_area = 0;
    for (const Point2& p : contour.vertices) {
      const double dx = p.x - last.x;
      const double dy = p.y - last.y;
      edges.length += std::sqrt(dx * dx + dy * dy);
      twice_area += (last.x - first.x) * dy - (last.y - first.y) * dx;
      edges.box.add(p);
      last = p;
    }
    edges.area += (contour.hole ? -0.5 : 0.5) * std::abs(twice_area);
    edges.count += contour.vertices.size();
  }
  return edges;
}

Edges joined(const Edges& a, const Edges& b) {
  Edges both{a.length + b.length, a.area + b.area, a.count + b.count, a.box};
  both.box.add(b.box);
  return both;
}

// A slab's two sections, as far as they decide how finely it is looked at.
struct SlabEdges {
  Edges edges;
  double gap = 0;
  bool prismatic = false;  ///< both have the same contours
};

SlabEdges slab_edges(const LinkedStack& stacked, SlabId slab) {
  const auto below = canonical_contours(stacked, lower_section(slab));
  const auto above = canonical_contours(stacked, upper_section(slab));
  const auto& sections = stacked.stack.sections;
  return {joined(edges_of(below), edges_of(above)),
          sections[upper_section(slab)].z - sections[lower_section(slab)].z, below == above};
}

// As many as contour edges go into the gap, about: what shows is sections much farther apart than
// vertices. None where they are not, nor where both sections are the same.
std::size_t automatic_count(const SlabEdges& slab) {
  if (slab.prismatic) return 0;
  const double count = slab.gap / (kEdgesPerLayer * slab.edges.mean());
  return static_cast<std::size_t>(std::clamp(count, 0.0, kMostByItself));
}

double step_of(const Edges& edges, double gap) {
  const double fine = std::min({edges.mean() / 2, edges.width() / 4, edges.side() / kLeastSteps});
  const double step = std::max(fine, edges.side() / kMostSteps);
  return std::max(step, gap / kMostStepsPerGap);
}

// Classes of a slab and their outlines in the sections around it.
class Classes {
 public:
  Classes(const LinkedStack& stacked, SlabId slab)
      : stacked_(stacked),
        slab_(slab),
        regions_(region_count(lower_section(slab)), region_count(upper_section(slab))) {}

  IdVector<ClassId, SlabClass> make() {
    UnionFind sets(regions_.size());
    for (const Link& link : stacked_.links[slab_]) {
      sets.unite(regions_.in_slab(false, link.lower).index(),
                 regions_.in_slab(true, link.upper).index());
    }
    IdVector<ClassId, SlabClass> classes;
    IdVector<SlabRegionId, ClassId> class_of(regions_.size());
    for (const SlabRegionId r : class_of.ids()) {
      const SlabRegionId leader(sets.find(r.index()));
      class_of[r] = leader == r ? classes.push_back({}) : class_of[leader];
      SlabClass& c = classes[class_of[r]];
      (regions_.is_upper(r) ? c.upper : c.lower).push_back(regions_.in_section(r));
    }
    for (SlabClass& c : classes) add_outlines(c);
    return classes;
  }

 private:
  [[nodiscard]] std::size_t region_count(SectionId s) const {
    return stacked_.nestings[s].outer.size();
  }

  void add_outlines(SlabClass& c) const {
    add(lower_section(slab_), c.lower, Around::lower, c.outlines);
    add(upper_section(slab_), c.upper, Around::upper, c.outlines);
    if (slab_.index() > 0) {
      const SlabId below(slab_.value() - 1);
      add(lower_section(below), linked_with(below, true, c.lower), Around::behind, c.outlines);
    }
    const SlabId above(slab_.value() + 1);
    if (above.index() < stacked_.links.size()) {
      add(upper_section(above), linked_with(above, false, c.upper), Around::beyond, c.outlines);
    }
  }

  // What links of a slab join with these regions of its upper section, or lower one.
  [[nodiscard]] std::vector<RegionId> linked_with(SlabId slab, bool upper,
                                                  const std::vector<RegionId>& regions) const {
    std::vector<RegionId> linked;
    for (const Link& link : stacked_.links[slab]) {
      if (std::binary_search(regions.begin(), regions.end(), upper ? link.upper : link.lower)) {
        linked.push_back(upper ? link.lower : link.upper);
      }
    }
    sort_distinct(linked);
    return linked;
  }

  void add(SectionId s, const std::vector<RegionId>& regions, Around where,
           ClassOutlines& outlines) const {
    const Section& section = stacked_.stack.sections[s];
    const Nesting& nesting = stacked_.nestings[s];
    outlines.z[where] = section.z;
    for (const ContourId c : nesting.region.ids()) {
      if (std::binary_search(regions.begin(), regions.end(), nesting.region[c])) {
        outlines.contours[where].push_back(&section.contours[c]);
      }
    }
  }

  const LinkedStack& stacked_;
  SlabId slab_;
  SlabRegions regions_;
};

Box2 class_box(const SlabClass& c) {
  Box2 box;
  for (const Around where : {Around::lower, Around::upper}) {
    for (const Contour* contour : c.outlines.contours[where]) {
      for (const Point2& p : contour->vertices) box.add(p);
    }
  }
  return box;
}

double samples_of(const SlabClass& c, double step, double around) {
  const Box2 box = class_box(c);
  return ((box.x1 - box.x0 + around) / step + kWindowMargin) *
         ((box.y1 - box.y0 + around) / step + kWindowMargin);
}

// Makes the lattice coarser until the windows of all classes, each in all layers, have few enough
// samples. False where it would tell nothing any more.
bool fit_lattice(between::SlabShape& shape, double gap) {
  for (int coarsenings = 0; coarsenings <= kMostCoarsenings; ++coarsenings, shape.step *= 2) {
    double samples = 0;
    for (const SlabClass& c : shape.classes) samples += samples_of(c, shape.step, gap);
    if (samples * static_cast<double>(shape.at.size() + 2) <= kMostSamples) return true;
  }
  return false;
}

// Whether the lattice shows each class. One is as fine as the gap allows: where a gap is much
// larger than what lies in it, or the units of heights are others, nothing can be said in between.
bool shows_classes(const between::SlabShape& shape) {
  return std::all_of(shape.classes.begin(), shape.classes.end(), [&](const SlabClass& c) {
    const Box2 box = class_box(c);
    return std::max(box.x1 - box.x0, box.y1 - box.y0) >= kFewestSteps * shape.step;
  });
}

}  // namespace

between::InnerSections sections_between(const LinkedStack& stacked, SlabId slab,
                                        std::optional<std::size_t> count) {
  const SlabEdges edges = slab_edges(stacked, slab);
  const std::size_t layers = count ? *count : automatic_count(edges);
  if (layers == 0 || edges.edges.count == 0) return {};
  const SectionId below = lower_section(slab);
  const SectionId above = upper_section(slab);
  between::SlabShape shape{stacked.stack.sections[below],
                           stacked.stack.sections[above],
                           stacked.nestings[below],
                           stacked.nestings[above],
                           Classes(stacked, slab).make(),
                           step_of(edges.edges, edges.gap),
                           {}};
  for (std::size_t k = 1; k <= layers; ++k) {
    shape.at.push_back(static_cast<double>(k) / static_cast<double>(layers + 1));
  }
  between::InnerSections inner;
  if (fit_lattice(shape, edges.gap) && shows_classes(shape)) inner = between::trace_between(shape);
  inner.wanted = layers;
  return inner;
}

}  // namespace tetloft::internal

#include "between/traced_layer.hpp"

#include <algorithm>
#include <cstdint>
#include <utility>

#include "between/marching.hpp"
#include "between/simplify.hpp"

namespace tetloft::internal::between {

namespace {

// How far simplified contours may leave the traced ones, in steps: an eighth of the mean edge of
// the given contours, of which a step is about half.
constexpr double kTolerance = 0.25;
// Nor are they longer, in steps: chords as long as a side would tell D too little (src/sections,
// divided contours).
constexpr double kLongest = 12;

// Whose a contour is.
struct Owner {
  ClassId of;
  std::uint32_t node = 0;
};

}  // namespace

std::optional<TracedLayer> trace_layer(const ClassShapes& shapes,
                                       const IdVector<ClassId, LayerGraph>& solids,
                                       std::size_t layer, double z, double step) {
  std::vector<std::pair<Contour, Owner>> traced;
  for (const ClassId c : shapes.ids()) {
    for (TracedContour& t : trace_contours(shapes[c].window, shapes[c].value[layer], step)) {
      const std::uint32_t node = solids[c].layers[layer].node_at(t.sample);
      traced.emplace_back(std::move(t.contour), Owner{c, node});
    }
  }
  std::sort(traced.begin(), traced.end(), [](const auto& a, const auto& b) {
    return canonical_less(a.first.vertices.front(), b.first.vertices.front());
  });
  Section section{z, {}};
  IdVector<ContourId, Owner> owners;
  for (auto& [contour, owner] : traced) {
    section.contours.push_back(std::move(contour));
    owners.push_back(owner);
  }
  std::optional<SimplifiedSection> simplified =
      simplify(section, kTolerance * step, kLongest * step);
  if (!simplified) return std::nullopt;
  TracedLayer result;
  result.inner.section = std::move(simplified->section);
  result.inner.nesting = std::move(simplified->nesting);
  for (const ClassId c : shapes.ids()) {
    result.region_of.push_back(std::vector<RegionId>(solids[c].layers[layer].size.size()));
  }
  const Nesting& nesting = result.inner.nesting;
  for (const ContourId outer : nesting.outer) result.inner.class_of.push_back(owners[outer].of);
  for (const ContourId c : owners.ids()) {
    const Owner& owner = owners[c];
    const Owner& outer = owners[nesting.outer[nesting.region[c]]];
    // Rounding may have turned contours around each other.
    if (owner.of != outer.of || owner.node != outer.node) return std::nullopt;
    result.region_of[owner.of][owner.node] = nesting.region[c];
  }
  return result;
}

}  // namespace tetloft::internal::between

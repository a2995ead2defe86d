// Guarantee 2: model ∩ plane = region of the section, for every section plane.
#include "check/resampling.hpp"

#include <algorithm>
#include <string>
#include <utility>

#include <tetloft/nesting.hpp>

#include "check/contour_chains.hpp"
#include "check/in_plane.hpp"
#include "core/guard.hpp"

namespace tetloft::internal::checking {

namespace {

void check_crossing(const ModelView& view, Findings& findings) {
  for (std::size_t t = 0; t < view.tets.size(); ++t) {
    Level low = view.level[view.tets[t][0].index()];
    Level high = low;
    for (const VertexId v : view.tets[t]) {
      low = std::min(low, view.level[v.index()]);
      high = std::max(high, view.level[v.index()]);
    }
    // The lowest plane strictly above `low` is at level low + 2 or, between planes, low + 1.
    const Level plane_above = on_plane(low) ? low + 2 : low + 1;
    if (plane_above < high) {
      findings.fail(1,
                    "a tet crosses a section plane (not as reconstruct makes it; what it cuts out "
                    "cannot be checked)",
                    [&] { return tet_text(view.id[t]); });
    }
  }
}

void check_triangles(const ModelView& view, const InPlaneComplex& complex, std::size_t planes,
                     Findings& findings) {
  for (const InPlaneTriangle& triangle : complex.triangles) {
    const auto place = [&] {
      return "section " + std::to_string(triangle.plane) + ", " +
             face_text(view, triangle.vertices);
    };
    if (triangle.flat) {
      findings.fail(4, "the vertices of an in-plane face are collinear", place);
    }
    if (triangle.below > 1 || triangle.above > 1 || triangle.within > 0) {
      findings.fail(5, "an in-plane face has more than one tet on one side, or one in the plane",
                    place);
    }
    const bool needs_below = triangle.plane > 0;
    const bool needs_above = triangle.plane + 1 < planes;
    if ((needs_below && triangle.below == 0) || (needs_above && triangle.above == 0) ||
        triangle.below + triangle.above == 0) {
      findings.fail(6, "an in-plane face has no tet on a side where the stack goes on", place);
    }
  }
}

void check_edges(const ModelView& view, const InPlaneComplex& complex, Findings& findings) {
  for (const InPlaneComplex::Edge& edge : complex.edges) {
    if (edge.left <= 1 && edge.right <= 1) continue;
    findings.fail(7, "an in-plane edge has more than one in-plane face on one side", [&] {
      return edge_text(view, edge.low, edge.high) + ", " + vertex_text(view, edge.low);
    });
  }
}

void check_no_other_edges(const ModelView& view, const InPlaneComplex& complex,
                          const SectionRange& sections, Findings& findings) {
  for (std::size_t t = 0; t < view.tets.size(); ++t) {
    for (const auto& [i, j] : kEdgeVertex) {
      const VertexId a = view.tets[t][static_cast<std::size_t>(i)];
      const VertexId b = view.tets[t][static_cast<std::size_t>(j)];
      if (view.level[a.index()] != view.level[b.index()] ||
          !sections.holds_plane(view.level[a.index()]) || complex.has_edge(a, b)) {
        continue;
      }
      findings.fail(14, "a tet has an edge in a section plane that is in no in-plane face",
                    [&] { return tet_text(view.id[t]) + ", " + edge_text(view, a, b); });
    }
  }
}

void refine(const ModelView& view, const ContourNumbers& numbers, const SectionRange& sections,
            const OnContours& on, SectionStack& refined) {
  for (std::size_t s = sections.first; s < sections.end; ++s) {
    Section& section = refined.sections[SectionId(s)];
    for (std::size_t c = 0; c < section.contours.size(); ++c) {
      const std::vector<VertexId>& chain =
          on.chain[numbers.of(s, c) - numbers.of(sections.first, 0)];
      std::vector<Point2>& vertices = section.contours[ContourId(c)].vertices;
      if (chain.size() <= vertices.size()) continue;
      vertices.clear();
      for (const VertexId v : chain) vertices.push_back(view.xy(v));
    }
  }
}

// Inserted vertices bend their contours by rounding. Where that made contours touch, or
// moved one across another, the boundary of the triangles would not bound the region.
// Sections where that is so go back to the input.
void check_refined(const SectionStack& stack, const SectionRange& sections, SectionStack& refined,
                   Findings& findings) {
  constexpr const char* kWhat = "inserted vertices make contours touch or change their nesting";
  for (std::size_t s = sections.first; s < sections.end; ++s) {
    const Section& before = stack.sections[SectionId(s)];
    Section& after = refined.sections[SectionId(s)];
    bool changed = false;
    for (std::size_t c = 0; c < before.contours.size(); ++c) {
      changed = changed || before.contours[ContourId(c)].vertices.size() !=
                               after.contours[ContourId(c)].vertices.size();
    }
    if (!changed) continue;
    SectionStack alone;
    alone.sections.push_back(after);
    if (const Result<void> valid = validate(alone); !accepted(valid)) {
      findings.fail(13, kWhat, [&] {
        return "section " + std::to_string(s) + ": " + to_string(valid.error());
      });
      after = before;
      continue;
    }
    const Nesting nested_before = nest(before);
    const Nesting nested_after = nest(after);
    for (std::size_t c = 0; c < before.contours.size(); ++c) {
      // A refined contour is listed with the region on its left.
      const bool hole = nested_before.depth[ContourId(c)] % 2 == 1;
      const bool refined_contour = before.contours[ContourId(c)].vertices.size() !=
                                   after.contours[ContourId(c)].vertices.size();
      if (nested_before.parent[ContourId(c)] != nested_after.parent[ContourId(c)] ||
          (refined_contour &&
           area_sign(after.contours[ContourId(c)]) != (hole ? Sign::negative : Sign::positive))) {
        findings.fail(13, kWhat, [&] { return contour_text(s, c); });
      }
    }
  }
}

}  // namespace

ContourNumbers::ContourNumbers(const SectionStack& stack) {
  std::size_t contours = 0;
  for (const Section& section : stack.sections) {
    first_.push_back(contours);
    contours += section.contours.size();
  }
  first_.push_back(contours);
}

std::string ContourNumbers::text(std::size_t contour) const {
  const auto behind = std::upper_bound(first_.begin(), first_.end(), contour);
  const auto s = static_cast<std::size_t>(behind - first_.begin()) - 1;
  return contour_text(s, contour - first_[s]);
}

Resampling check_resampling(const ModelView& view, const SectionStack& stack,
                            const ContourNumbers& numbers, const SectionRange& sections,
                            const CheckOptions& options, SectionStack& refined) {
  Findings findings(2, "re-sampling", options.places);
  // Of tets at a seam the segments beside it tell.
  if (view.part.scope != Scope::seam) check_crossing(view, findings);
  const InPlaneComplex complex = in_plane_complex(view, sections);
  check_triangles(view, complex, stack.sections.size(), findings);
  check_edges(view, complex, findings);
  OnContours on_contours =
      follow_contours(view, stack, numbers, sections, complex, options, findings);
  refine(view, numbers, sections, on_contours, refined);
  check_refined(stack, sections, refined, findings);
  check_no_other_edges(view, complex, sections, findings);
  return {std::move(findings), std::move(on_contours)};
}

}  // namespace tetloft::internal::checking

#include "reconstruct/report_of.hpp"

#include <algorithm>

#include "model/volume.hpp"

namespace tetloft::internal {

namespace {

// The triangles in a section that slabs share, which is one that has a slab on both sides.
void count_gluing(const PreparedStack& prepared, ReconstructReport& report) {
  for (std::size_t s = prepared.beyond_below ? 0 : 1; s + 1 < prepared.section_count(); ++s) {
    const auto& inside = prepared.sections[SectionId(s)].internal;
    count(report.rules, Rule::gluing,
          static_cast<std::uint64_t>(std::count(inside.begin(), inside.end(), std::uint8_t{1})));
  }
}

}  // namespace

ReconstructReport report_of_parts(const BuiltStack& built) {
  ReconstructReport report;
  for (const Part& part : built.parts) {
    for (std::size_t r = 0; r < kRules; ++r) report.rules[r] += part.solid.rules[r];
    for (std::size_t s = 0; s < kSteps; ++s) report.seconds[s] += part.solid.seconds[s];
    report.work += part.solid.work;
    report.sections_between += part.solid.sections_between;
    report.sections_given_up += part.solid.sections_given_up;
    report.smallest_lift = std::min(report.smallest_lift, part.solid.smallest_lift);
  }
  for (std::size_t s = 0; s < kSteps; ++s) report.seconds[s] += built.seconds[s];
  count(report.rules, Rule::gabriel_refinement, built.refinements);
  for (const std::vector<EdgeDivision>& section : built.plan.divided) {
    for (const EdgeDivision& edge : section) report.dividing_vertices += edge.parts - 1;
  }
  count_gluing(built.prepared, report);
  return report;
}

void add_up(const ReconstructReport& part, ReconstructReport& sum) {
  for (std::size_t r = 0; r < kRules; ++r) sum.rules[r] += part.rules[r];
  for (std::size_t s = 0; s < kSteps; ++s) sum.seconds[s] += part.seconds[s];
  sum.work += part.work;
  sum.sections_between += part.sections_between;
  sum.sections_given_up += part.sections_given_up;
  sum.dividing_vertices += part.dividing_vertices;
  sum.smallest_lift = std::min(sum.smallest_lift, part.smallest_lift);
}

void describe(const Model& model, unsigned threads, ReconstructReport& report) {
  report.vertices = model.points.size();
  report.tets = model.tets.size();
  report.components = model.component_count;
  report.volume = volume_of(model, threads);
  report.split_vertices = static_cast<std::size_t>(
      std::count(model.origin.begin(), model.origin.end(), PointOrigin::contour_split));
  report.work += report.split_vertices;
}

}  // namespace tetloft::internal

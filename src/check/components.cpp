// Guarantee 4: the partition of contours by the model's components is the partition
// recomputed from the input and the options, and from what the model says of motions and of links
// that were dropped, as far as that may be.
#include "check/components.hpp"

#include <string>
#include <utility>
#include <vector>

#include "check/partition.hpp"
#include "core/guard.hpp"
#include "core/sort_distinct.hpp"

namespace tetloft::internal::checking {

namespace {

constexpr std::uint32_t kNone = 0xFFFFFFFFU;

// Where a contour of the one sequence is, in words.
std::string numbered_contour_text(const OnContours& on, std::size_t contour) {
  std::size_t s = 0;
  while (on.first[s + 1] <= contour) ++s;
  return contour_text(s, contour - on.first[s]);
}

// The component of each contour, kNone if no tet touches it. Reports contours of several.
std::vector<std::uint32_t> components_of_contours(const ModelView& view, const OnContours& on,
                                                  Findings& findings) {
  std::vector<std::uint32_t> component(on.chain.size(), kNone);
  std::vector<std::uint8_t> reported(on.chain.size(), 0);
  std::vector<std::uint8_t> has_contour(view.component_count, 0);
  for (std::size_t t = 0; t < view.tets.size(); ++t) {
    for (const VertexId v : view.tets[t]) {
      const std::uint32_t contour = on.contour[v.index()];
      if (contour == OnContours::kNone) continue;
      has_contour[view.component[t]] = 1;
      if (component[contour] == kNone) component[contour] = view.component[t];
      if (component[contour] == view.component[t] || reported[contour] != 0) continue;
      reported[contour] = 1;
      findings.fail(2, "a contour lies on no component, or on several",
                    [&] { return numbered_contour_text(on, contour); });
    }
  }
  for (std::size_t t = 0; t < view.tets.size(); ++t) {
    std::uint8_t& seen = has_contour[view.component[t]];
    if (seen != 0) continue;
    seen = 1;
    findings.fail(1, "a component contains no contour",
                  [&] { return "component of " + tet_text(view.id[t]); });
  }
  for (std::size_t c = 0; c < component.size(); ++c) {
    if (component[c] != kNone) continue;
    findings.fail(2, "a contour lies on no component, or on several",
                  [&] { return numbered_contour_text(on, c); });
  }
  return component;
}

// Calls report(first, c) for each contour c whose group differs from that of the first
// contour of its class.
template <class Group, class Report>
void compare_within_classes(const std::vector<std::size_t>& set, std::size_t set_count,
                            Group&& group, Report&& report) {
  std::vector<std::size_t> first(set_count, set.size());
  for (std::size_t c = 0; c < set.size(); ++c) {
    if (group(c) == kNone) continue;
    std::size_t& leader = first[set[c]];
    if (leader == set.size()) leader = c;
    if (group(leader) != group(c)) report(leader, c);
  }
}

void report_claims(const ExpectedPartition& partition, Findings& findings) {
  const auto report = [&](int condition, const char* what, const std::vector<std::string>& places) {
    for (const std::string& place : places) {
      findings.fail(condition, what, [&] { return place; });
    }
  };
  report(6, "the rule has no such motion", partition.wrong_motions);
  report(7, "a link cannot have been dropped", partition.wrong_dropped);
  report(8, "a motion is not the one estimated anew", partition.other_motions);
}

}  // namespace

Result<Components> check_components(const ModelView& view, const SectionStack& stack,
                                    const Resampling& resampling, const CheckOptions& options) {
  Components result{Findings(4, "components", options.places)};
  Findings& findings = result.findings;
  const OnContours& on = resampling.on_contours;
  const std::vector<std::uint32_t> component = components_of_contours(view, on, findings);

  auto partition = expected_partition(stack, resampling.refined, options.correspondence,
                                      {view.links, view.motions}, options.recompute_motions);
  if (!accepted(partition)) {
    // What conform() makes of a contour that the model bends badly is the model's fault.
    if (partition.error().code == ErrorCode::invalid_input) return partition.error();
    findings.fail(5, "the correspondence cannot be recomputed",
                  [&] { return to_string(partition.error()); });
    return result;
  }
  if (partition->unrealised.has_value()) {
    findings.fail(5, "the correspondence cannot be recomputed", [&] {
      return "label " + std::to_string(*partition->unrealised) + " cannot be realised";
    });
  }
  std::vector<std::size_t> sets = partition->set;
  sort_distinct(sets);
  result.expected = {std::move(partition->links), sets.size()};
  report_claims(*partition, findings);
  result.dropped_links = partition->dropped;
  const auto pair_text = [&](std::size_t a, std::size_t b) {
    return numbered_contour_text(on, a) + " and " + numbered_contour_text(on, b);
  };
  compare_within_classes(
      partition->set, partition->set.size(), [&](std::size_t c) { return component[c]; },
      [&](std::size_t a, std::size_t b) {
        findings.fail(3, "contours that correspond lie in different components",
                      [&] { return pair_text(a, b); });
      });
  // The other way round, over contours that lie in some component.
  std::vector<std::size_t> by_component(component.begin(), component.end());
  for (std::size_t& c : by_component) {
    if (c == kNone) c = view.component_count;
  }
  compare_within_classes(
      by_component, view.component_count + 1,
      [&](std::size_t c) {
        return component[c] == kNone ? kNone : static_cast<std::uint32_t>(partition->set[c]);
      },
      [&](std::size_t a, std::size_t b) {
        findings.fail(4, "contours that do not correspond lie in one component",
                      [&] { return pair_text(a, b); });
      });
  return result;
}

}  // namespace tetloft::internal::checking

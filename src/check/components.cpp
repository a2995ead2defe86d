// Guarantee 4: the partition of contours by the model's components is the partition
// recomputed from the input and the options, and from what the model says of motions and of links
// that were dropped, as far as that may be.
#include "check/components.hpp"

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "check/partition.hpp"
#include "core/guard.hpp"
#include "core/sort_distinct.hpp"

namespace tetloft::internal::checking {

namespace {

constexpr std::uint32_t kNone = 0xFFFFFFFFU;

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

SolidComponents::SolidComponents(const ContourNumbers& numbers)
    : numbers_(numbers), first_(numbers.size(), kNone) {}

std::uint32_t SolidComponents::add(const ModelView& view) {
  const auto base = static_cast<std::uint32_t>(sets_.size());
  for (std::size_t t = 0; t < view.tets.size(); ++t) {
    // They are numbered by their first tet.
    if (base + view.component[t] < sets_.size()) continue;
    sets_.add();
    first_tet_.push_back(view.id[t]);
    has_contour_.push_back(0);
  }
  return base;
}

void SolidComponents::meet(const ModelView& view, const OnContours& on,
                           std::span<const std::uint32_t> component) {
  std::vector<std::pair<std::uint32_t, std::uint32_t>> more;
  on.for_each_corner(view.tets, [&](std::size_t t, std::uint32_t contour) {
    has_contour_[component[t]] = 1;
    std::uint32_t& first = first_[contour];
    if (first == kNone) first = component[t];
    if (first != component[t]) more.emplace_back(contour, component[t]);
  });
  sort_distinct(more);
  more_.insert(more_.end(), more.begin(), more.end());
}

std::size_t SolidComponents::count() const {
  std::size_t count = 0;
  for (std::size_t c = 0; c < sets_.size(); ++c) {
    if (sets_.find(c) == c) ++count;
  }
  return count;
}

std::vector<std::uint32_t> SolidComponents::of_contours(Findings& findings) const {
  constexpr const char* kWhat = "a contour lies on no component, or on several";
  std::vector<std::uint32_t> component(first_.size(), kNone);
  for (std::size_t c = 0; c < first_.size(); ++c) {
    if (first_[c] == kNone) continue;
    component[c] = static_cast<std::uint32_t>(sets_.find(first_[c]));
  }
  std::vector<std::uint32_t> several;
  for (const auto& [contour, other] : more_) {
    if (sets_.find(other) != component[contour]) several.push_back(contour);
  }
  for (std::uint32_t c = 0; c < component.size(); ++c) {
    if (component[c] == kNone) several.push_back(c);
  }
  sort_distinct(several);
  for (const std::uint32_t c : several) {
    findings.fail(2, kWhat, [&] { return numbers_.text(c); });
  }
  std::vector<std::uint8_t> has_contour(sets_.size(), 0);
  for (std::size_t c = 0; c < sets_.size(); ++c) {
    if (has_contour_[c] != 0) has_contour[sets_.find(c)] = 1;
  }
  for (std::size_t c = 0; c < sets_.size(); ++c) {
    if (sets_.find(c) != c || has_contour[c] != 0) continue;
    findings.fail(1, "a component contains no contour",
                  [&] { return "component of " + tet_text(first_tet_[c]); });
  }
  return component;
}

Result<Components> check_components(const SolidComponents& components, const SectionStack& stack,
                                    const SectionStack& refined, const Claims& claims,
                                    const CheckOptions& options) {
  Components result{Findings(4, "components", options.places)};
  Findings& findings = result.findings;
  const ContourNumbers& numbers = components.numbers();
  const std::vector<std::uint32_t> component = components.of_contours(findings);

  auto partition =
      expected_partition(stack, refined, options.correspondence, claims, options.recompute_motions);
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
    return numbers.text(a) + " and " + numbers.text(b);
  };
  compare_within_classes(
      partition->set, partition->set.size(), [&](std::size_t c) { return component[c]; },
      [&](std::size_t a, std::size_t b) {
        findings.fail(3, "contours that correspond lie in different components",
                      [&] { return pair_text(a, b); });
      });
  // The other way round, over contours that lie in some component.
  std::vector<std::size_t> by_component(component.begin(), component.end());
  std::size_t none = 0;  // a number that no component has
  for (const std::uint32_t c : component) {
    if (c != kNone) none = std::max(none, std::size_t{c} + 1);
  }
  std::replace(by_component.begin(), by_component.end(), std::size_t{kNone}, none);
  compare_within_classes(
      by_component, none + 1,
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

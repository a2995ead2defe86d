// Which contours form one component, recomputed by the rule in
// tetloft/correspondence.hpp. Written for `check` alone: it must not share a line with the
// reconstruction's own.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include <tetloft/correspondence.hpp>
#include <tetloft/nesting.hpp>
#include <tetloft/result.hpp>

namespace tetloft::internal::checking {

/// Regions of all sections in one sequence, by (section, region).
struct Regions {
  std::vector<Nesting> nesting;      ///< per section
  std::vector<std::size_t> first;    ///< per section; the number of regions at the end
  std::vector<std::size_t> section;  ///< per region

  [[nodiscard]] std::size_t size() const { return section.size(); }
  [[nodiscard]] std::size_t of(std::size_t s, std::size_t contour) const {
    return first[s] + nesting[s].region[ContourId(contour)].index();
  }
  [[nodiscard]] RegionId local(std::size_t region) const {
    return RegionId(region - first[section[region]]);
  }
};

/// Two regions of neighbouring sections; the slab follows from the lower one. The order is
/// that of rule 3: (slab, lower region, upper region).
struct Link {
  std::size_t lower = 0;
  std::size_t upper = 0;
  friend auto operator<=>(const Link&, const Link&) = default;
};

[[nodiscard]] Regions number_regions(const SectionStack& stack);

/// Rule 1: the candidates by overlap, sorted.
[[nodiscard]] std::vector<Link> overlap_links(const SectionStack& stack, const Regions& regions,
                                              double tau);

/// Rule 1: the further candidates by drift (drift_links.cpp), sorted. overlap: the candidates
/// by overlap.
[[nodiscard]] std::vector<Link> drift_links(const SectionStack& stack, const Regions& regions,
                                            const std::vector<Link>& overlap, double drift);

/// Rule 1: the candidates by reverse tetrahedra (reverse_links.cpp), sorted. `refined` is
/// the stack with the model's inserted vertices.
[[nodiscard]] Result<std::vector<Link>> reverse_links(const SectionStack& refined,
                                                      const Regions& regions);

/// Rules 2 to 4 (label_links.cpp): sets of regions, by a number for each region that is the
/// same within a set. label[r]: the label of region r. `unrealised` is the first label that
/// cannot be made one set, if any.
struct RegionSets {
  std::vector<std::size_t> set;
  std::optional<std::uint32_t> unrealised;
};
[[nodiscard]] RegionSets unite_regions(const SectionStack& stack, const Regions& regions,
                                       const std::vector<Link>& candidates,
                                       const std::vector<std::optional<std::uint32_t>>& label);

/// The label of each region. Refused (invalid_input) where a label names no contour or a
/// region has two labels.
[[nodiscard]] Result<std::vector<std::optional<std::uint32_t>>> label_regions(
    const Regions& regions, const std::vector<Label>& labels);

struct ExpectedPartition {
  std::vector<std::size_t> set;             ///< per contour, all sections in one sequence
  std::optional<std::uint32_t> unrealised;  ///< a label that cannot be realised
};

/// The whole rule. Requires a valid stack.
[[nodiscard]] Result<ExpectedPartition> expected_partition(const SectionStack& stack,
                                                           const SectionStack& refined,
                                                           const CorrespondenceOptions& options);

}  // namespace tetloft::internal::checking

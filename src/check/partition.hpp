// Which contours form one component, recomputed by the rule in
// tetloft/correspondence.hpp. Written for `check` alone: it must not share a line with the
// reconstruction's own.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <vector>

#include <tetloft/correspondence.hpp>
#include <tetloft/result.hpp>

#include "check/motions.hpp"
#include "check/regions.hpp"

namespace tetloft::internal::checking {

/// A pair that rules 1 to 4 make.
struct Candidate {
  Link link;
  double s = 0;         ///< of a chain with the ratio of the region moved on
  bool joined = false;  ///< by a decision
};

/// Rule 1: the candidates by overlap (overlap_links.cpp), sorted.
[[nodiscard]] std::vector<Link> overlap_links(const Regions& regions, double tau);

/// Rule 1: the candidates by moved overlap (moved_links.cpp), sorted.
[[nodiscard]] std::vector<Link> moved_links(const Regions& regions, const MovedRatios& m,
                                            double tau);

/// Rule 1: the candidates by reverse tetrahedra (reverse_links.cpp), sorted. `refined` is
/// the stack with the model's inserted vertices.
[[nodiscard]] Result<std::vector<Link>> reverse_links(const SectionStack& refined,
                                                      const Regions& regions);

/// Rule 2 (chain_links.cpp), sorted, from the candidates of rule 1. Of voids (rule V2 of voids.hpp)
/// the first of each section is the exterior, which is no origin and never single.
struct ChainRule {
  double reach = kChainReach;
  bool exteriors = false;
};
[[nodiscard]] std::vector<Candidate> chain_links(const Regions& regions,
                                                 const std::vector<Link>& by_criterion,
                                                 const ChainRule& rule = {});

/// Rule 3 (lone_links.cpp), sorted, from the candidates of rules 1 and 2.
[[nodiscard]] std::vector<Link> lone_links(const Regions& regions, const MovedRatios& m,
                                           const std::vector<Link>& candidates);

/// Rule 4 (decisions.cpp): which pairs the user joins and parts. Refused (invalid_input) where a
/// decision names no contour or contradicts another.
struct DecidedLinks {
  std::set<Link> joined, parted;
};
[[nodiscard]] Result<DecidedLinks> decided_links(const Regions& regions,
                                                 const std::vector<LinkDecision>& decisions);

/// Rule 8 (decisions.cpp): the links that a model says were dropped. `wrong` says which of them may
/// not have been, and why; they are left out.
struct DroppedLinks {
  std::set<Link> links;
  std::vector<std::string> wrong;
};
[[nodiscard]] DroppedLinks dropped_links(const Regions& regions, std::span<const RegionLink> claims,
                                         const std::vector<Candidate>& candidates);

/// Rules 5 to 7 (label_links.cpp): sets of regions, by a number for each region that is the
/// same within a set. label[r]: the label of region r; closed: pairs that no label may use.
/// `accepted` are the links of rules 5 to 7, sorted, each once;
/// `unrealised` is the first label that cannot be made one set, if any, `contradicted` a joined
/// pair of different labels.
struct RegionSets {
  std::vector<std::size_t> set;
  std::vector<Link> accepted;
  std::optional<std::uint32_t> unrealised;
  std::optional<Link> contradicted;
};
[[nodiscard]] RegionSets unite_regions(const SectionStack& stack, const Regions& regions,
                                       std::vector<Candidate> candidates,
                                       const std::vector<std::optional<std::uint32_t>>& label,
                                       const std::set<Link>& closed);

/// The label of each region. Refused (invalid_input) where a label names no contour or a
/// region has two labels.
[[nodiscard]] Result<std::vector<std::optional<std::uint32_t>>> label_regions(
    const Regions& regions, const std::vector<Label>& labels);

/// What a model says of how it was decided.
struct Claims {
  std::span<const RegionLink> links;
  std::span<const RegionMotion> motions;
  /// A model that a mesher made of another may have lost all of it.
  [[nodiscard]] bool any() const { return !links.empty() || !motions.empty(); }
};

struct ExpectedPartition {
  std::vector<std::size_t> set;             ///< per contour, all sections in one sequence
  std::vector<Link> links;                  ///< those accepted, sorted
  std::optional<std::uint32_t> unrealised;  ///< a label that cannot be realised
  std::size_t dropped = 0;                  ///< links left out because the model says so
  // What is wrong with claims, in words.
  std::vector<std::string> wrong_motions, wrong_dropped;
  std::vector<std::string> other_motions;  ///< those that are not what is estimated anew
};

/// The whole rule. `refined`: as of reverse_links(). Motions are those of the claims, or those that
/// src/motion finds now: if there are no claims at all, or to compare (estimate_anew). Requires a
/// valid stack.
[[nodiscard]] Result<ExpectedPartition> expected_partition(const SectionStack& stack,
                                                           const SectionStack& refined,
                                                           const CorrespondenceOptions& options,
                                                           const Claims& claims = {},
                                                           bool estimate_anew = false);

}  // namespace tetloft::internal::checking

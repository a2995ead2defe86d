// A campaign: random stacks reconstructed and checked, by kind, with every rule counted.
//
// A stack is tried with all criteria of correspondence, each with one thread and with
// two. It counts as wrong if any attempt gives a model that fails a guarantee, models that
// differ by the number of threads, or an error other than an excused refusal; then it is
// shrunk to a minimal stack with the same kind of defect and written down.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include <tetloft/correspondence.hpp>
#include <tetloft/reconstruct.hpp>

#include "support/stacks/generate.hpp"

namespace tetloft::testing {

struct CampaignOptions {
  std::size_t count = 10;  ///< stacks of each kind: seeds `seed` … `seed + count − 1`
  std::uint64_t seed = 1;
  std::vector<StackKind> kinds;            ///< empty: all
  std::optional<std::size_t> between = 0;  ///< ReconstructOptions::between
  unsigned threads = 1;  ///< stacks tried at the same time; 0: as many as the machine offers
  std::string folder;    ///< for shrunk stacks; empty: not written
  std::size_t shrink_trials = 400;
  std::size_t shrink_most = 5;  ///< failures shrunk in all; the others are only named
};

/// What one attempt came to.
enum class Outcome : std::uint8_t {
  model,    ///< a model that keeps all guarantees
  refused,  ///< unrepresentable, naming a place, where there is an excuse
  wrong_manifold,
  wrong_sampling,
  wrong_embedding,
  wrong_components,
  wrong_topology,
  wrong_threads,  ///< one and two threads give different models or errors
  wrong_report,   ///< the report contradicts the model
  wrong_error,    ///< any other error, or a refusal without excuse
  wrong_check,    ///< check() itself failed
  wrong_cost,     ///< kMostWork times the work per vertex that the median of the run takes
};
[[nodiscard]] const char* name_of(Outcome outcome);

struct Attempt {
  Outcome outcome = Outcome::model;
  std::string detail;  ///< of anything but a model
  std::array<std::uint64_t, kRules> rules{};
  double work = 0;  ///< of a model: per input vertex (ReconstructReport::work)
};

/// A stack that takes so many times the work per vertex of the run's median is a finding.
inline constexpr double kMostWork = 100;

/// Why a stack may be refused as unrepresentable.
enum class Excuse : std::uint8_t {
  none,       ///< but for a tet of D, just there, thinner than 2^12 ulps (thin_tets.hpp)
  precision,  ///< features a few ulps wide
  labels,     ///< regions of one label that nothing joins, or that only slivers of a few ulps
              ///< between nearly parallel edges join (a known limit)
};
[[nodiscard]] Excuse excuse_of(StackKind kind);

/// Reconstructs by one criterion, with so many sections between two (ReconstructOptions::between),
/// and checks.
[[nodiscard]] Attempt attempt(const GeneratedStack& generated, Criterion criterion, Excuse excuse,
                              std::optional<std::size_t> between = 0);

struct KindTally {
  StackKind kind{};
  std::size_t stacks = 0;
  std::size_t models = 0;    ///< attempts
  std::size_t refusals = 0;  ///< attempts
  std::size_t wrong = 0;     ///< attempts
  double seconds = 0;
};

struct Failure {
  StackKind kind{};
  std::uint64_t seed = 0;
  Criterion criterion{};
  Attempt attempt;
  std::string file;    ///< of the shrunk stack; empty if not written
  std::string shrunk;  ///< as .cnt text; empty if not shrunk
};

struct CampaignResult {
  std::vector<KindTally> tallies;
  std::vector<Failure> failures;  ///< by kind, seed and criterion
  std::array<std::uint64_t, kRules> rules{};
  double median_work = 0;  ///< per vertex, of all models
  double most_work = 0;
};

/// The median, and whether `work` is a finding beside it.
[[nodiscard]] double median(std::vector<double> work);
[[nodiscard]] constexpr bool is_costly(double work, double median) {
  return work > kMostWork * median;
}

[[nodiscard]] CampaignResult run_campaign(const CampaignOptions& options);

/// The rules that fired fewer than `least` times, but gabriel_refinement, which few stacks
/// need.
[[nodiscard]] std::vector<Rule> rare_rules(const CampaignResult& result, std::uint64_t least);

/// Tallies by kind and rule counts, as text.
[[nodiscard]] std::string table(const CampaignResult& result);
[[nodiscard]] std::string to_string(const Failure& failure);

}  // namespace tetloft::testing

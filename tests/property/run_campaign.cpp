#include "property/run_campaign.hpp"

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <fstream>
#include <sstream>
#include <utility>

#include <tetloft/check.hpp>

#include "core/parallel.hpp"
#include "property/same_model.hpp"
#include "property/thin_tets.hpp"
#include "support/stacks/shrink.hpp"

namespace tetloft::testing {

using namespace internal;
namespace {

constexpr std::array kCriteria{Criterion::moved, Criterion::overlap, Criterion::reverse};

const char* name_of(Criterion criterion) {
  switch (criterion) {
    case Criterion::overlap: return "overlap";
    case Criterion::reverse: return "reverse";
    case Criterion::moved: return "moved";
  }
  return "none";
}

Outcome outcome_of_guarantee(int number) {
  switch (number) {
    case 1: return Outcome::wrong_manifold;
    case 2: return Outcome::wrong_sampling;
    case 3: return Outcome::wrong_embedding;
    case 4: return Outcome::wrong_components;
    default: return Outcome::wrong_topology;
  }
}

std::string describe(const GuaranteeVerdict& verdict) {
  std::string text = "guarantee " + std::to_string(verdict.number) + " (" + verdict.name + ")";
  for (const CheckFailure& failure : verdict.failures) {
    text += "; " + failure.what + " × " + std::to_string(failure.count);
    if (!failure.places.empty()) text += ", first " + failure.places.front();
  }
  return text;
}

bool names_a_place(const Place& where) {
  return where.section || where.slab || where.contour || where.vertex || where.point;
}

bool same_error(const Error& a, const Error& b) {
  return a.code == b.code && tetloft::to_string(a) == tetloft::to_string(b);
}

// What the report says against what the model holds.
std::string contradiction(const Reconstruction& made, const SectionStack& stack) {
  const ReconstructReport& report = made.report;
  if (report.vertices != made.model.points.size()) return "vertices";
  if (report.tets != made.model.tets.size()) return "tets";
  if (report.components != made.model.component_count) return "components";
  if (report.slices != stack.sections.size()) return "slices";
  if (report.contours != stack.contour_count()) return "contours";
  if (report.input_vertices != stack.vertex_count()) return "input_vertices";
  if (report.volume != volume(made.model)) return "volume";
  return {};
}

bool is_excused(const Error& error, Excuse excuse, const SectionStack& stack) {
  const Place& where = error.where;
  if (!names_a_place(where)) return false;
  // An honest refusal, but of a few hundred vertices only where features are ulps wide.
  if (error.code == ErrorCode::work_limit) return excuse == Excuse::precision;
  if (error.code != ErrorCode::unrepresentable) return false;
  switch (excuse) {
    case Excuse::none:
      return where.slab && where.point && has_thin_tet(stack, *where.slab, *where.point);
    case Excuse::precision:
    case Excuse::labels: return true;
  }
  return false;
}

Attempt error_attempt(const Error& error, Excuse excuse, const SectionStack& stack) {
  const Outcome outcome =
      is_excused(error, excuse, stack) ? Outcome::refused : Outcome::wrong_error;
  return {outcome, tetloft::to_string(error), {}};
}

// One stack of a campaign and what came of it.
struct Case {
  StackKind kind{};
  std::uint64_t seed = 0;
  std::array<Attempt, kCriteria.size()> attempts;
  double seconds = 0;
};

Case try_stack(StackKind kind, std::uint64_t seed, std::optional<std::size_t> between) {
  const auto begin = std::chrono::steady_clock::now();
  Case result{kind, seed, {}, 0};
  const GeneratedStack generated = generate(kind, seed);
  for (std::size_t i = 0; i < kCriteria.size(); ++i) {
    result.attempts[i] = attempt(generated, kCriteria[i], excuse_of(kind), between);
  }
  const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - begin;
  result.seconds = taken.count();
  return result;
}

// Attempts that took far more work than the median become findings.
void watch_work(std::vector<Case>& cases, CampaignResult& result) {
  std::vector<double> work;
  for (const Case& tried : cases) {
    for (const Attempt& attempt : tried.attempts) {
      if (attempt.outcome != Outcome::model) continue;
      work.push_back(attempt.work);
      result.most_work = std::max(result.most_work, attempt.work);
    }
  }
  result.median_work = median(std::move(work));
  for (Case& tried : cases) {
    if (has_large_triangulations(tried.kind)) continue;
    for (Attempt& attempt : tried.attempts) {
      if (attempt.outcome != Outcome::model || !is_costly(attempt.work, result.median_work)) {
        continue;
      }
      attempt.outcome = Outcome::wrong_cost;
      attempt.detail = "work " + std::to_string(attempt.work) + " per vertex, median " +
                       std::to_string(result.median_work);
    }
  }
}

bool is_wrong(Outcome outcome) { return outcome >= Outcome::wrong_manifold; }

void shrink_and_write(Failure& failure, const CampaignOptions& options) {
  const Excuse excuse = excuse_of(failure.kind);
  const auto still_fails = [&](const GeneratedStack& candidate) {
    return attempt(candidate, failure.criterion, excuse, options.between).outcome ==
           failure.attempt.outcome;
  };
  const GeneratedStack least =
      shrink(generate(failure.kind, failure.seed), still_fails, {.trials = options.shrink_trials});
  if (options.folder.empty()) return;
  const std::string name = std::string(tetloft::testing::name_of(failure.kind)) + "_" +
                           std::to_string(failure.seed) + "_" + name_of(failure.criterion);
  if (!write_stack(options.folder, name, least)) return;
  failure.file = options.folder + "/" + name + ".cnt";
  std::ifstream in(failure.file);
  std::ostringstream text;
  text << in.rdbuf();
  failure.shrunk = text.str();
}

}  // namespace

const char* name_of(Outcome outcome) {
  switch (outcome) {
    case Outcome::model: return "model";
    case Outcome::refused: return "refused";
    case Outcome::wrong_manifold: return "not manifold";
    case Outcome::wrong_sampling: return "sections not met";
    case Outcome::wrong_embedding: return "not embedded";
    case Outcome::wrong_components: return "wrong components";
    case Outcome::wrong_topology: return "wrong topology";
    case Outcome::wrong_threads: return "depends on the number of threads";
    case Outcome::wrong_report: return "report contradicts the model";
    case Outcome::wrong_error: return "error";
    case Outcome::wrong_check: return "check failed";
    case Outcome::wrong_cost: return "far more work than others";
  }
  return "?";
}

Excuse excuse_of(StackKind kind) {
  if (is_near_coincident(kind)) return Excuse::precision;
  return kind == StackKind::random_labels ? Excuse::labels : Excuse::none;
}

Attempt attempt(const GeneratedStack& generated, Criterion criterion, Excuse excuse,
                std::optional<std::size_t> between) {
  ReconstructOptions options;
  options.correspondence = generated.correspondence;
  options.correspondence.criterion = criterion;
  options.between = between;
  // Coarse contours as they are, too: they are degenerate as few others are.
  options.divide_coarse = criterion == Criterion::moved;
  options.thickness = 1;  // shrinking may leave one section
  options.execution.threads = 1;
  const Result<Reconstruction> one = reconstruct(generated.stack, options);
  options.execution.threads = 2;
  const Result<Reconstruction> two = reconstruct(generated.stack, options);

  const bool same = one.ok() && two.ok()     ? same_bits(one->model, two->model)
                    : !one.ok() && !two.ok() ? same_error(one.error(), two.error())
                                             : false;
  if (!same) return {Outcome::wrong_threads, "one and two threads differ", {}};
  if (!one) return error_attempt(one.error(), excuse, generated.stack);
  const std::string contradicted = contradiction(*one, generated.stack);
  if (!contradicted.empty()) return {Outcome::wrong_report, contradicted, {}};

  CheckOptions check_options;
  check_options.correspondence = options.correspondence;
  check_options.recompute_motions = true;
  const Result<CheckReport> checked = check(one->model, generated.stack, check_options);
  if (!checked) return {Outcome::wrong_check, tetloft::to_string(checked.error()), {}};
  for (const GuaranteeVerdict& verdict : checked->guarantees) {
    if (!verdict.pass) return {outcome_of_guarantee(verdict.number), describe(verdict), {}};
  }
  if (one->report.work != two->report.work) {
    return {Outcome::wrong_report, "work depends on the number of threads", {}};
  }
  const double work = static_cast<double>(one->report.work) /
                      static_cast<double>(std::max<std::size_t>(1, one->report.input_vertices));
  return {Outcome::model, {}, one->report.rules, work};
}

double median(std::vector<double> work) {
  if (work.empty()) return 0;
  const auto middle = work.begin() + static_cast<std::ptrdiff_t>(work.size() / 2);
  std::nth_element(work.begin(), middle, work.end());
  return *middle;
}

CampaignResult run_campaign(const CampaignOptions& options) {
  std::vector<StackKind> kinds = options.kinds;
  if (kinds.empty()) kinds.assign(all_kinds().begin(), all_kinds().end());

  std::vector<Case> cases(kinds.size() * options.count);
  parallel_for(cases.size(), options.threads, [&](std::size_t i) {
    cases[i] =
        try_stack(kinds[i / options.count], options.seed + i % options.count, options.between);
  });

  CampaignResult result;
  watch_work(cases, result);
  for (std::size_t i = 0; i < cases.size(); ++i) {
    if (i % options.count == 0) result.tallies.push_back({.kind = cases[i].kind});
    KindTally& tally = result.tallies.back();
    ++tally.stacks;
    tally.seconds += cases[i].seconds;
    for (std::size_t k = 0; k < kCriteria.size(); ++k) {
      Attempt& tried = cases[i].attempts[k];
      for (std::size_t r = 0; r < result.rules.size(); ++r) result.rules[r] += tried.rules[r];
      if (tried.outcome == Outcome::model) ++tally.models;
      if (tried.outcome == Outcome::refused) ++tally.refusals;
      if (!is_wrong(tried.outcome)) continue;
      ++tally.wrong;
      Failure failure{cases[i].kind, cases[i].seed, kCriteria[k], std::move(tried), {}, {}};
      const bool alone = failure.attempt.outcome != Outcome::wrong_cost;
      if (alone && result.failures.size() < options.shrink_most) shrink_and_write(failure, options);
      result.failures.push_back(std::move(failure));
    }
  }
  return result;
}

std::vector<Rule> rare_rules(const CampaignResult& result, std::uint64_t least) {
  std::vector<Rule> rare;
  for (int i = 0; i < kRules; ++i) {
    const Rule rule = static_cast<Rule>(i);
    if (rule == Rule::gabriel_refinement) continue;
    if (result.rules[static_cast<std::size_t>(i)] < least) rare.push_back(rule);
  }
  return rare;
}

std::string table(const CampaignResult& result) {
  std::string text;
  char line[160];
  const auto row = [&](const char* name, const KindTally& tally) {
    std::snprintf(line, sizeof line, "%-26s %8zu %8zu %8zu %8zu %9.2f\n", name, tally.stacks,
                  tally.models, tally.refusals, tally.wrong, tally.seconds);
    text += line;
  };
  std::snprintf(line, sizeof line, "%-26s %8s %8s %8s %8s %9s\n", "kind", "stacks", "models",
                "refused", "wrong", "seconds");
  text += line;
  KindTally all;
  for (const KindTally& tally : result.tallies) {
    row(name_of(tally.kind), tally);
    all.stacks += tally.stacks;
    all.models += tally.models;
    all.refusals += tally.refusals;
    all.wrong += tally.wrong;
    all.seconds += tally.seconds;
  }
  row("all", all);
  std::snprintf(line, sizeof line, "work per vertex: median %.1f, most %.1f\n", result.median_work,
                result.most_work);
  text += line;
  std::snprintf(line, sizeof line, "\n%-26s %8s\n", "rule", "fired");
  text += line;
  for (int i = 0; i < kRules; ++i) {
    std::snprintf(line, sizeof line, "%-26s %8llu\n", tetloft::name_of(static_cast<Rule>(i)),
                  static_cast<unsigned long long>(result.rules[static_cast<std::size_t>(i)]));
    text += line;
  }
  return text;
}

std::string to_string(const Failure& failure) {
  std::string text = std::string(name_of(failure.kind)) + " seed " + std::to_string(failure.seed) +
                     " (" + name_of(failure.criterion) + "): " + name_of(failure.attempt.outcome) +
                     ": " + failure.attempt.detail;
  if (!failure.file.empty()) text += "\nshrunk to " + failure.file + ":\n" + failure.shrunk;
  return text;
}

}  // namespace tetloft::testing

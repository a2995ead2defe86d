// Checks a model against the stack it claims to fill: the five guarantees and figures.
#include <tetloft/check.hpp>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include <tetloft/predicates.hpp>

#include "check/cavities.hpp"
#include "check/components.hpp"
#include "check/embedded.hpp"
#include "check/figures.hpp"
#include "check/manifold.hpp"
#include "check/resampling.hpp"
#include "check/view.hpp"
#include "core/guard.hpp"
#include "core/option_rules.hpp"
#include "core/parallel.hpp"
#include "core/watched_work.hpp"

namespace tetloft {

using namespace internal;

namespace {

// Half-faces are numbered in 32 bits.
constexpr std::size_t kMostTets = std::size_t{1} << 30;

Result<void> check_arguments(const Model& model, const SectionStack& stack,
                             const CheckOptions& options) {
  if (auto fp = fp_self_check(); !fp.ok()) return fp;
  if (!(options.split_ulps >= 0) || !std::isfinite(options.split_ulps)) {
    return Error{ErrorCode::usage, "split_ulps must be finite and not negative", {}};
  }
  const Result<void> sensible = check_correspondence_options(options.correspondence);
  if (!sensible) return sensible;
  if (model.tets.size() >= kMostTets) {
    return Error{ErrorCode::invalid_input, "2^30 tets or more", {}};
  }
  return validate(stack, untold(options.execution));
}

// The checks, each on its own of the same view: run one after the other or at the same time.
class Checks {
 public:
  Checks(const Model& model, const SectionStack& stack, const CheckOptions& options)
      : model_(model), stack_(stack), options_(options), work_(options.execution, kSteps) {}

  Result<CheckReport> run() {
    work_.step_done_go_on();
    view_ = checking::look_at(model_, stack_);
    surface_ = surface_components(view_.boundary);
    work_.step_done_go_on();
    parallel_for(kParts, options_.execution.threads, [&](std::size_t part) {
      work_.go_on();
      if (part == 0) embedded_ = checking::check_embedded(view_, surface_, options_).verdict();
      if (part == 1) check_sections();
      if (part == 2) manifold_ = checking::check_manifold(view_, options_).verdict();
      if (part == 3) measure();
      work_.step_done();
    });
    if (refused_) return *std::move(refused_);
    work_.go_on();
    GuaranteeVerdict cavities = cavities_verdict();
    work_.step_done();
    report_.guarantees = {std::move(manifold_), std::move(resampling_), std::move(embedded_),
                          std::move(components_), std::move(cavities)};
    return std::move(report_);
  }

 private:
  static constexpr std::size_t kParts = 4;
  // Arguments checked, the view made, the parts; components, and what is expected of cavities, are
  // two more; cavities.
  static constexpr std::size_t kSteps = 2 + kParts + 3;

  void check_sections() {
    checking::Resampling resampling = checking::check_resampling(view_, stack_, options_);
    resampling_ = resampling.findings.verdict();
    report_.largest_split_ulps = resampling.on_contours.largest_split_ulps;
    report_.inner_vertices = resampling.on_contours.off_contours;
    work_.step_done_go_on();
    const auto components = checking::check_components(view_, stack_, resampling, options_);
    on_contours_ = std::move(resampling.on_contours);
    if (!components.ok()) {
      refused_ = components.error();
      return;
    }
    components_ = components->findings.verdict();
    report_.dropped_links = components->dropped_links;
    work_.step_done_go_on();
    stack_voids_.emplace(stack_);
    if (components->expected.has_value()) expect_cavities(*components->expected);
  }

  void expect_cavities(const checking::Components::Expected& components) {
    const VoidOptions& voids = options_.correspondence.voids;
    if (voids.rule == VoidRule::free) return;
    auto expected = checking::expected_cavities(*stack_voids_, voids, view_, components);
    if (!expected.ok()) {
      refused_ = expected.error();
      return;
    }
    report_.expected_cavities = expected->cavities;
    report_.least_genus = expected->genus.least;
    report_.most_genus = expected->genus.most;
    report_.forced_voids = expected->voids.forced.size();
    report_.unrealisable_voids = expected->voids.unrealisable;
    expected_ = *std::move(expected);
  }

  GuaranteeVerdict cavities_verdict() {
    const checking::Findings none = checking::no_cavities_asked();
    std::optional<checking::ModelVoids> voids;
    if (manifold_.pass && resampling_.pass) {
      voids = checking::model_voids(view_, surface_, on_contours_, stack_voids_->voids());
      report_.cavities = voids->cavities;
    }
    if (options_.correspondence.voids.rule == VoidRule::free) {
      return none.not_asked("cavities and tunnels are as they come", true);
    }
    if (!voids.has_value() || !components_.pass || !expected_.has_value()) {
      return none.not_asked("it needs guarantees 1, 2 and 4", false);
    }
    return checking::check_cavities(view_, on_contours_, *stack_voids_, *voids, *expected_,
                                    options_)
        .verdict();
  }

  void measure() {
    report_.components = view_.component_count;
    report_.deviations = model_.deviations.size();
    for (const SurfaceTopology& topology : surface_.topology) {
      report_.genus.push_back(topology.genus());
    }
    Model sound;
    sound.points = model_.points;
    sound.tets = IdVector<TetId, TetVertices>(view_.tets);
    sound.frame = model_.frame;
    report_.volume = volume(sound);
    report_.overshoot = checking::overshoot(view_, stack_);
    report_.smallest_dihedral_degrees = checking::smallest_dihedral_degrees(view_);
  }

  const Model& model_;
  const SectionStack& stack_;
  const CheckOptions& options_;
  WatchedWork work_;
  checking::ModelView view_;
  SurfaceComponents surface_;
  GuaranteeVerdict manifold_, resampling_, embedded_, components_;
  checking::OnContours on_contours_;
  std::optional<checking::StackVoids> stack_voids_;
  std::optional<checking::ExpectedCavities> expected_;
  std::optional<Error> refused_;
  CheckReport report_;
};

}  // namespace

bool CheckReport::pass() const {
  return std::all_of(guarantees.begin(), guarantees.end(),
                     [](const GuaranteeVerdict& verdict) { return verdict.pass; });
}

Result<CheckReport> check(const Model& model, const SectionStack& stack,
                          const CheckOptions& given_options) {
  return guard_threads(given_options, [&](const CheckOptions& options) -> Result<CheckReport> {
    if (auto good = check_arguments(model, stack, options); !good.ok()) return good.error();
    return Checks(model, stack, options).run();
  });
}

}  // namespace tetloft

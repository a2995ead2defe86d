#include "check/conclusions.hpp"

#include <cmath>
#include <utility>

#include <tetloft/predicates.hpp>

#include "core/option_rules.hpp"
#include "core/sort_distinct.hpp"

namespace tetloft::internal::checking {

Result<void> check_arguments(const SectionStack& stack, const CheckOptions& options) {
  if (auto fp = fp_self_check(); !fp.ok()) return fp;
  if (!(options.split_ulps >= 0) || !std::isfinite(options.split_ulps)) {
    return Error{ErrorCode::usage, "split_ulps must be finite and not negative", {}};
  }
  const Result<void> sensible = check_correspondence_options(options.correspondence);
  if (!sensible) return sensible;
  return validate(stack, untold(options.execution));
}

Result<void> Conclusions::decide(const SolidComponents& components, const SectionStack& refined,
                                 const ModelTables& model, WatchedWork& work) {
  const auto decided =
      check_components(components, stack_, refined, {model.links, model.motions}, options_);
  if (!decided) return decided.error();
  components_ = decided->findings.verdict();
  report_.components = components.count();
  report_.dropped_links = decided->dropped_links;
  work.step_done_go_on();
  const Result<void> expected =
      decided->expected ? expect_cavities(*decided->expected, model) : Result<void>();
  work.step_done();
  return expected;
}

Result<void> Conclusions::expect_cavities(const Components::Expected& components,
                                          const ModelTables& model) {
  const VoidOptions& rule = options_.correspondence.voids;
  if (rule.rule == VoidRule::free) return {};
  auto expected = expected_cavities(voids_, rule, model.void_links, components);
  if (!expected) return expected.error();
  report_.expected_cavities = expected->cavities;
  report_.least_genus = expected->genus.least;
  report_.most_genus = expected->genus.most;
  report_.forced_voids = expected->voids.forced.size();
  report_.unrealisable_voids = expected->voids.unrealisable;
  expected_ = *std::move(expected);
  return {};
}

GuaranteeVerdict Conclusions::cavities(bool filled, const std::vector<BoundarySurface>& surfaces,
                                       const std::vector<SlabPart>& parts,
                                       const ModelTables& model) {
  const Findings none = no_cavities_asked();
  std::optional<ModelVoids> of_model;
  if (filled) {
    of_model = model_voids(surfaces, voids_.voids());
    report_.cavities = of_model->cavities;
  }
  if (options_.correspondence.voids.rule == VoidRule::free) {
    return none.not_asked("cavities and tunnels are as they come", true);
  }
  if (!of_model || !components_.pass || !expected_) {
    return none.not_asked("it needs guarantees 1, 2 and 4", false);
  }
  return check_cavities(parts, voids_, *of_model, *expected_, model.deviations, options_).verdict();
}

CheckReport Conclusions::report(GuaranteeVerdict manifold, GuaranteeVerdict resampling,
                                GuaranteeVerdict embedded,
                                const std::vector<BoundarySurface>& surfaces,
                                std::vector<SlabPart> parts, const ModelTables& model) {
  for (SlabPart& part : parts) sort_distinct(part.regions);
  for (const BoundarySurface& surface : surfaces) {
    report_.genus.push_back(surface.topology.genus());
  }
  report_.deviations = model.deviations.size();
  GuaranteeVerdict voids = cavities(manifold.pass && resampling.pass, surfaces, parts, model);
  report_.guarantees = {std::move(manifold), std::move(resampling), std::move(embedded),
                        std::move(components_), std::move(voids)};
  return std::move(report_);
}

}  // namespace tetloft::internal::checking

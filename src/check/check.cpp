// Checks a model against the stack it claims to fill: the four guarantees and figures.
#include <tetloft/check.hpp>

#include <algorithm>
#include <cmath>
#include <utility>

#include <tetloft/predicates.hpp>

#include "check/components.hpp"
#include "check/embedded.hpp"
#include "check/figures.hpp"
#include "check/manifold.hpp"
#include "check/resampling.hpp"
#include "check/view.hpp"
#include "core/check.hpp"

namespace tetloft {

namespace {

// Half-faces are numbered in 32 bits.
constexpr std::size_t kMostTets = std::size_t{1} << 30;

Result<void> check_arguments(const Model& model, const SectionStack& stack,
                             const CheckOptions& options) {
  if (auto fp = fp_self_check(); !fp.ok()) return fp;
  if (!(options.split_ulps >= 0) || !std::isfinite(options.split_ulps)) {
    return Error{ErrorCode::usage, "split_ulps must be finite and not negative", {}};
  }
  if (!(options.correspondence.tau >= 0) || !std::isfinite(options.correspondence.tau)) {
    return Error{ErrorCode::usage, "tau must be finite and not negative", {}};
  }
  if (const auto& drift = options.correspondence.drift) {
    if (!(*drift >= 0 && *drift < 1)) {
      return Error{ErrorCode::usage, "drift must be in [0, 1)", {}};
    }
    if (options.correspondence.criterion != Criterion::overlap) {
      return Error{ErrorCode::usage, "drift belongs to the overlap criterion", {}};
    }
  }
  if (model.tets.size() >= kMostTets) {
    return Error{ErrorCode::invalid_input, "2^30 tets or more", {}};
  }
  return validate(stack);
}

}  // namespace

bool CheckReport::pass() const {
  return std::all_of(guarantees.begin(), guarantees.end(),
                     [](const GuaranteeVerdict& verdict) { return verdict.pass; });
}

Result<CheckReport> check(const Model& model, const SectionStack& stack,
                          const CheckOptions& options) {
  return guard_internal([&]() -> Result<CheckReport> {
    if (auto good = check_arguments(model, stack, options); !good.ok()) return good.error();
    const checking::ModelView view = checking::look_at(model, stack);
    const SurfaceComponents surface = surface_components(view.boundary);

    CheckReport report;
    report.guarantees.push_back(checking::check_manifold(view, options).verdict());
    const checking::Resampling resampling = checking::check_resampling(view, stack, options);
    report.guarantees.push_back(resampling.findings.verdict());
    report.guarantees.push_back(checking::check_embedded(view, surface, options).verdict());
    const auto components = checking::check_components(view, stack, resampling, options);
    if (!components.ok()) return components.error();
    report.guarantees.push_back(components->verdict());

    report.components = view.component_count;
    for (const SurfaceTopology& topology : surface.topology) {
      report.genus.push_back(topology.genus());
    }
    Model sound;
    sound.points = model.points;
    sound.tets = IdVector<TetId, TetVertices>(view.tets);
    report.volume = volume(sound);
    report.overshoot = checking::overshoot(view, stack);
    report.smallest_dihedral_degrees = checking::smallest_dihedral_degrees(view);
    report.largest_split_ulps = resampling.on_contours.largest_split_ulps;
    report.inner_vertices = resampling.on_contours.off_contours;
    return report;
  });
}

}  // namespace tetloft

// Checks a model against the stack it claims to fill: the five guarantees and figures.
#include <tetloft/check.hpp>

#include <algorithm>
#include <optional>
#include <utility>
#include <vector>

#include "check/conclusions.hpp"
#include "check/embedded.hpp"
#include "check/figures.hpp"
#include "check/manifold.hpp"
#include "check/resampling.hpp"
#include "check/view.hpp"
#include "core/guard.hpp"
#include "core/parallel.hpp"
#include "core/watched_work.hpp"

namespace tetloft {

using namespace internal;

namespace {

// The checks, each on its own of the same view: run one after the other or at the same time.
class Checks {
 public:
  Checks(const Model& model, const SectionStack& stack, const CheckOptions& options)
      : model_(model),
        stack_(stack),
        options_(options),
        work_(options.execution, kSteps),
        tables_{model.links, model.motions, model.void_links, model.deviations} {}

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
      if (part == 3) {
        figures_ = checking::measure(model_, view_, stack_, {0, stack_.sections.size()});
      }
      work_.step_done();
    });
    if (refused_) return *std::move(refused_);
    work_.go_on();
    CheckReport report =
        conclusions_->report(std::move(manifold_), std::move(resampling_), std::move(embedded_),
                             patches_.all(), std::move(parts_), tables_);
    figures_.add(on_contours_);
    figures_.tell(report);
    work_.step_done();
    return report;
  }

 private:
  static constexpr std::size_t kParts = 4;
  // Arguments checked, the view made, the parts; what of sections' part comes before components,
  // these, and what is expected of cavities, are three more; cavities.
  static constexpr std::size_t kSteps = 2 + kParts + 4;

  void check_sections() {
    conclusions_.emplace(stack_, options_);
    SectionStack refined = stack_;
    checking::Resampling resampling = checking::check_resampling(
        view_, stack_, conclusions_->numbers(), {0, stack_.sections.size()}, options_, refined);
    resampling_ = resampling.findings.verdict();
    checking::SolidComponents components(conclusions_->numbers());
    components.add(view_);
    components.meet(view_, resampling.on_contours, view_.component);
    patches_.add(view_, surface_);
    patches_.meet(view_, resampling.on_contours, surface_.component, conclusions_->void_at());
    checking::SlabParts parts = checking::slab_parts(view_);
    checking::add_regions(view_, resampling.on_contours, parts.part_of, conclusions_->region_at(),
                          parts.parts);
    parts_ = std::move(parts.parts);
    on_contours_ = std::move(resampling.on_contours);
    work_.step_done_go_on();
    const Result<void> decided = conclusions_->decide(components, refined, tables_, work_);
    if (!decided) refused_ = decided.error();
  }

  const Model& model_;
  const SectionStack& stack_;
  const CheckOptions& options_;
  WatchedWork work_;
  checking::ModelTables tables_;
  checking::ModelView view_;
  SurfaceComponents surface_;
  GuaranteeVerdict manifold_, resampling_, embedded_;
  checking::OnContours on_contours_;
  checking::ViewFigures figures_;
  std::optional<checking::Conclusions> conclusions_;
  checking::SurfacePatches patches_;
  std::vector<checking::SlabPart> parts_;
  std::optional<Error> refused_;
};

}  // namespace

bool CheckReport::pass() const {
  return std::all_of(guarantees.begin(), guarantees.end(),
                     [](const GuaranteeVerdict& verdict) { return verdict.pass; });
}

Result<CheckReport> check(const Model& model, const SectionStack& stack,
                          const CheckOptions& given_options) {
  return guard_threads(given_options, [&](const CheckOptions& options) -> Result<CheckReport> {
    if (auto good = checking::check_arguments(stack, options); !good.ok()) return good.error();
    return Checks(model, stack, options).run();
  });
}

}  // namespace tetloft

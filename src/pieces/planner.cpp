#include "pieces/planner.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <set>
#include <utility>

#include "core/parallel.hpp"
#include "io/scratch_file.hpp"
#include "io/sorted_scratch.hpp"
#include "pieces/piece_file.hpp"
#include "pieces/plan_file.hpp"
#include "reconstruct/divide.hpp"
#include "reconstruct/ends.hpp"
#include "reconstruct/hints.hpp"
#include "reconstruct/rising_components.hpp"
#include "reconstruct/stack_errors.hpp"
#include "sections/complement.hpp"
#include "sections/scaling.hpp"
#include "slab/rules.hpp"

namespace tetloft::internal::pieces {

namespace {

class WindowPlanner {
 public:
  WindowPlanner(const SectionStore& store, Unit unit, const ReconstructOptions& options,
                const std::string& path, WatchedWork& work, const PlanningWindows& windows)
      : store_(store),
        options_(options),
        path_(path),
        work_(work),
        windows_(windows),
        exponent_(unit == Unit::of_the_stack ? store.unit().exponent() : 0),
        whole_{sections::far_outside(scaled(store.largest(), exponent_)), store.has_hole()},
        scratch_(path),
        decided_(scratch_),
        lengths_(path) {
    for (const double z : store.heights()) heights_.push_back(std::ldexp(z, exponent_));
  }

  Result<PlannedStack> plan(const PlanSource& source, io::Sink& sink) {
    StepClock clock(made_.seconds);
    Result<EndPlanes> ends = place_ends(heights_, options_.ends, 0);
    if (!ends) return ends.error();
    for (std::size_t first = 0; first < store_.size();) {
      const std::size_t end = end_of_window(first);
      if (auto error = decide(first, end)) return *error;
      first = end;
    }
    if (auto error = warn()) return *error;
    clock.end(Step::correspondence);
    head_of_whole(*ends, source);
    if (auto error = write(sink)) return *error;
    return std::move(made_);
  }

 private:
  [[nodiscard]] std::size_t end_of_window(std::size_t first) const {
    std::size_t end = first;
    for (std::size_t vertices = 0; end < store_.size() && end - first < windows_.most; ++end) {
      if (end - first >= windows_.least && vertices >= windows_.vertices) break;
      vertices += store_.vertices_of(end);
    }
    return end;
  }

  // The sections from `first` to before `end`, and the slab above each.
  std::optional<Error> decide(std::size_t first, std::size_t end) {
    const std::size_t low = first - std::min(first, kDecisionHalo);
    const std::size_t high = std::min(end + kDecisionHalo + 1, store_.size());
    BuiltStack window;
    if (auto error = load(low, high, window.prepared)) return error;
    if (auto error = decide_window(window, options_, work_)) {
      error->where = in_whole(error->where, {low, high - 1});
      return error;
    }
    std::vector<SectionPlan> plans;
    for (std::size_t s = first; s < end; ++s) {
      plans.push_back(planned_section(window, SectionId(s - low)));
    }
    const auto appended = append(decided_, plans.size(), [&](std::size_t k) -> Result<std::string> {
      work_.step_done_go_on();
      return to_record(plans[k]);
    });
    if (appended) return appended;
    count(window, SectionId(first - low), SectionId(end - low));
    return scratch_.failure() ? scratch_.failure() : lengths_.failure();
  }

  // n records in order, made on all threads, some at a time.
  template <class Make>
  std::optional<Error> append(ArchiveWriter& archive, std::size_t n, const Make& make) const {
    constexpr std::size_t kAtOnce = 64;
    for (std::size_t first = 0; first < n; first += kAtOnce) {
      std::vector<Result<std::string>> records(std::min(kAtOnce, n - first), std::string());
      parallel_for(records.size(), options_.execution.threads,
                   [&](std::size_t k) { records[k] = make(first + k); });
      for (const Result<std::string>& record : records) {
        if (!record) return record.error();
        archive.append(*record);
      }
    }
    return std::nullopt;
  }

  std::optional<Error> load(std::size_t low, std::size_t high, PreparedStack& window) const {
    window.exponent = exponent_;
    window.of_whole = whole_;
    window.first_section = low;
    window.stack.sections.resize(high - low);
    window.nestings.resize(high - low);
    window.sections.resize(high - low);
    return first_error(all_ids<SectionId>(high - low), options_.execution.threads, work_,
                       [&](SectionId s) -> std::optional<Error> {
                         Result<StoredSection> stored = store_.section(low + s.index());
                         if (!stored) return stored.error();
                         window.stack.sections[s] = sections::scaled(stored->section, exponent_);
                         window.nestings[s] = std::move(stored->nesting);
                         return std::nullopt;
                       });
  }

  // With numbers of components for the time being.
  SectionPlan planned_section(const BuiltStack& window, SectionId s) {
    SectionPlan plan = section_plan(window, s);
    const auto below = [&](const Correspondence& of) {
      return s.index() == 0 ? std::vector<Link>() : of.links[SlabId(s.index() - 1)];
    };
    plan.regions = regions_.add(window.prepared.nestings[s], below(window.plan.correspondence));
    if (plan.voids && whole_.has_hole) {
      plan.voids = voids_.add(window.complements[s], below(*window.plan.voids));
      last_voids_ = plan.voids->of_region;
      if (first_voids_.empty()) first_voids_ = last_voids_;
    }
    return plan;
  }

  void count(const BuiltStack& window, SectionId first, SectionId end) {
    const PreparedStack& prepared = window.prepared;
    const Correspondence& regions = window.plan.correspondence;
    add_partners(prepared, regions.candidates, first, end, partners_);
    if (divides_coarse(options_)) {
      for (SectionId s = first; s < end; s = SectionId(s.index() + 1)) {
        edges_.add(prepared.stack.sections[s], [&](double length) { lengths_.push_back(length); });
      }
    } else if (store_.coarse_vertices().is_half()) {
      add_coarseness(prepared, regions.links, first, end, coarseness_);
    }
  }

  std::optional<Error> warn() {
    if (misses_partners(partners_)) {
      std::vector<double> gaps;
      for (std::size_t s = 1; s < heights_.size(); ++s) {
        gaps.push_back(heights_[s] - heights_[s - 1]);
      }
      std::vector<double> sizes;
      for (std::size_t s = 0; s < store_.size(); ++s) {
        const Result<StoredSection> stored = store_.section(s);
        if (!stored) return stored.error();
        append_sizes(sections::scaled(stored->section, exponent_), stored->nesting, sizes);
      }
      made_.warnings.push_back(hint_of(partners_, std::move(gaps), std::move(sizes), exponent_));
    }
    if (!divides_coarse(options_) && store_.coarse_vertices().is_half()) {
      if (auto hint = hint_of(coarseness_, exponent_)) made_.warnings.push_back(*std::move(hint));
    }
    return std::nullopt;
  }

  void head_of_whole(const EndPlanes& ends, const PlanSource& source) {
    numbers_ = regions_.numbers();
    void_numbers_ = voids_.numbers();
    PlanHead& head = made_.head;
    head.facts = {store_.size(), count_of(numbers_), exponent_, ends, {}};
    if (divides_coarse(options_)) {
      head.facts.least_long =
          edges_.least_long([&](const auto& visit) { lengths_.for_each(visit); });
    }
    head.options = options_;
    head.source = source;
    head.contours = store_.contours();
    head.vertices = store_.vertices();
    head.cavities = closed_voids();
    head.lowest = store_.heights().front();
    head.highest = store_.heights().back();
    head.frame = store_.frame();
    head.about = store_.about();
  }

  static std::size_t count_of(const IdVector<ComponentId, ComponentId>& numbers) {
    std::size_t components = 0;
    for (const ComponentId id : numbers) components = std::max(components, id.index() + 1);
    return components;
  }

  // As cavities().
  [[nodiscard]] std::size_t closed_voids() const {
    std::set<ComponentId> open;
    for (const auto* at_end : {&first_voids_, &last_voids_}) {
      for (const ComponentId id : *at_end) open.insert(void_numbers_[id]);
    }
    return count_of(void_numbers_) - open.size();
  }

  std::optional<Error> write(io::Sink& sink) {
    decided_.finish();
    if (scratch_.failure()) return scratch_.failure();
    const Result<ArchiveReader> decided = ArchiveReader::of(std::move(scratch_), path_);
    if (!decided) return decided.error();
    ArchiveWriter archive(sink);
    archive.append(to_record(made_.head));
    auto error = append(archive, store_.size(), [&](std::size_t s) -> Result<std::string> {
      work_.go_on();
      const Result<std::string> bytes = decided->record(s);
      if (!bytes) return bytes.error();
      Result<SectionPlan> plan = section_plan_from_record(*bytes, path_);
      if (!plan) return plan.error();
      renumber(plan->regions, numbers_);
      if (plan->voids && whole_.has_hole) renumber(*plan->voids, void_numbers_);
      return to_record(*plan);
    });
    if (error) return error;
    made_.identity = archive.finish();
    return lengths_.failure();
  }

  const SectionStore& store_;
  const ReconstructOptions& options_;
  const std::string& path_;
  WatchedWork& work_;
  PlanningWindows windows_;
  int exponent_;
  OfWhole whole_;
  std::vector<double> heights_;  // in the unit of the plan
  io::ScratchFile scratch_;
  ArchiveWriter decided_;
  io::SortedScratch lengths_;
  sections::EdgeTally edges_;
  RisingComponents regions_;
  RisingComponents voids_;
  IdVector<RegionId, ComponentId> first_voids_, last_voids_;
  IdVector<ComponentId, ComponentId> numbers_, void_numbers_;
  PartnerCounts partners_;
  Coarseness coarseness_;
  PlannedStack made_;
};

Result<PlannedStack> plan_in_memory(const SectionStore& store, Unit unit,
                                    const ReconstructOptions& options, const PlanSource& source,
                                    WatchedWork& work, io::Sink& sink) {
  const Result<ValidStack> stack = store.stack();
  if (!stack) return stack.error();
  Result<BuiltStack> planned = plan_stack(unit, *stack, options, work);
  if (!planned) return planned.error();
  PlannedStack made;
  made.head = head_of(*planned, stack->stack(), options, source);
  made.identity = append_plan(sink, made.head, *planned);
  made.warnings = std::move(planned->warnings);
  made.seconds = planned->seconds;
  return made;
}

}  // namespace

Result<PlannedStack> plan_stored(const SectionStore& store, Unit unit,
                                 const ReconstructOptions& options, const PlanSource& source,
                                 const std::string& path, WatchedWork& work, io::Sink& sink,
                                 const PlanningWindows& windows) {
  if (auto error = check_options(options)) return *error;
  if (!decides_in_windows(options) || store.size() == 1) {
    return plan_in_memory(store, unit, options, source, work, sink);
  }
  return WindowPlanner(store, unit, options, path, work, windows).plan(source, sink);
}

}  // namespace tetloft::internal::pieces

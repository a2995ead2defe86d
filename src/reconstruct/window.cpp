#include "reconstruct/window.hpp"

#include <algorithm>
#include <string>
#include <utility>

#include "core/guard.hpp"
#include "reconstruct/hints.hpp"
#include "sections/complement.hpp"
#include "sections/scaling.hpp"
#include "sections/validation.hpp"

namespace tetloft::internal {

namespace {

SectionComponents components_of(const Correspondence& correspondence, SectionId s) {
  return {correspondence.component[s], correspondence.partition[s]};
}

SlabDecision decision_of(const Correspondence& correspondence, SlabId slab) {
  SlabDecision decision{correspondence.links[slab], correspondence.candidates[slab]};
  for (Link& link : decision.links) link.slab = SlabId(0);
  for (LinkCandidate& candidate : decision.candidates) candidate.link.slab = SlabId(0);
  return decision;
}

void add(SectionComponents components, Correspondence& correspondence) {
  correspondence.component.push_back(std::move(components.of_region));
  correspondence.partition.push_back(std::move(components.of_contour));
}

void add(SlabDecision decision, SlabId slab, Correspondence& correspondence) {
  for (Link& link : decision.links) link.slab = slab;
  for (LinkCandidate& candidate : decision.candidates) candidate.link.slab = slab;
  correspondence.links.push_back(std::move(decision.links));
  correspondence.candidates.push_back(std::move(decision.candidates));
}

// Puts a window together, refusing what does not fit.
class WindowMaker {
 public:
  WindowMaker(const StackFacts& facts, const SlabRange& slabs)
      : slabs_(slabs), components_(facts.components) {
    PreparedStack& prepared = window_.prepared;
    prepared.exponent = window_.plan.exponent = facts.exponent;
    prepared.least_long = facts.least_long;
    prepared.first_section = slabs.first;
    if (slabs.first == 0) window_.plan.ends.below = facts.ends.below;
    if (slabs.end + 1 == facts.sections) window_.plan.ends.above = facts.ends.above;
  }

  Result<BuiltStack> make(std::vector<SectionPlan> plans, std::optional<SectionPlan> below,
                          std::optional<SectionPlan> above) {
    if (plans.size() != slabs_.end - slabs_.first + 1) {
      return no_fit(slabs_.first, "has fewer or more beside it than the slabs take");
    }
    if (plans.front().voids) window_.plan.voids.emplace();
    for (std::size_t k = 0; k < plans.size(); ++k) {
      if (auto error = add_section(slabs_.first + k, plans[k])) return *error;
    }
    if (auto error = check_ends()) return *error;
    for (std::size_t k = 0; k + 1 < plans.size(); ++k) {
      if (auto error = add_slab(SlabId(k), plans[k])) return *error;
    }
    if (below) {
      if (auto error = add_below(*std::move(below))) return *error;
    }
    if (above) {
      if (auto error = add_above(*std::move(above), std::move(plans.back().region_links))) {
        return *error;
      }
    }
    window_.prepared.sections.resize(window_.prepared.section_count());
    return std::move(window_);
  }

 private:
  [[nodiscard]] std::optional<Error> check_ends() const {
    const EndPlanes& ends = window_.plan.ends;
    const auto& sections = window_.prepared.stack.sections.raw();
    if (ends.below && !(*ends.below < sections.front().z)) {
      return no_fit(slabs_.first, "is not above the end below it");
    }
    if (ends.above && !(*ends.above > sections.back().z)) {
      return no_fit(slabs_.end, "is not below the end above it");
    }
    return std::nullopt;
  }

  // A section of the whole that is valid, of the regions that its plan tells of.
  [[nodiscard]] Result<Nesting> nesting_of(std::size_t s, const SectionPlan& plan) const {
    auto error = sections::height_error({plan.section.z}, 0);
    Result<Nesting> valid = sections::nest_section_if_valid(plan.section, s);
    if (!error && !valid) error = valid.error();
    if (error) return no_fit(s, "is not valid: " + error->message);
    const Nesting& nesting = *valid;
    if (plan.regions.of_region.size() != nesting.outer.size()) {
      return no_fit(s, "has other regions than its plan");
    }
    if (!has_components(plan.regions.of_region) || !has_components(plan.regions.of_contour)) {
      return no_fit(s, "is of a component that there is not");
    }
    return valid;
  }

  static Error not_above(std::size_t s) { return no_fit(s, "is not above the one below"); }

  std::optional<Error> add_section(std::size_t s, SectionPlan& plan) {
    PreparedStack& prepared = window_.prepared;
    if (s > slabs_.first && !(plan.section.z > prepared.stack.sections.raw().back().z)) {
      return not_above(s);
    }
    Result<Nesting> nested = nesting_of(s, plan);
    if (!nested) return nested.error();
    Nesting& nesting = *nested;
    if (plan.voids.has_value() != window_.plan.voids.has_value()) {
      return no_fit(s, "has voids decided, or none, unlike those beside it");
    }
    if (plan.voids) {
      // How far out the frame is makes no difference to what lies in what.
      Nesting complement =
          sections::complement_of(plan.section, nesting,
                                  sections::far_outside(sections::largest_magnitude(plan.section)))
              .nesting;
      if (plan.voids->of_region.size() != complement.outer.size() &&
          plan.voids->of_region.size() != 1) {
        return no_fit(s, "has other voids than its plan");
      }
      window_.complements.push_back(std::move(complement));
      add(std::move(*plan.voids), *window_.plan.voids);
    }
    prepared.stack.sections.push_back(std::move(plan.section));
    prepared.nestings.push_back(std::move(nesting));
    add(std::move(plan.regions), window_.plan.correspondence);
    return std::nullopt;
  }

  std::optional<Error> add_slab(SlabId slab, SectionPlan& plan) {
    Plan& whole = window_.plan;
    const IdVector<SectionId, Nesting>& nestings = window_.prepared.nestings;
    const auto& below = whole.correspondence.component[lower_section(slab)];
    const auto& above = whole.correspondence.component[upper_section(slab)];
    const std::size_t in_whole = slabs_.first + slab.index();
    if (!has_ends(plan.region_links, below.size(), above.size())) return no_region(in_whole);
    for (RegionMotion& motion : plan.motions) {
      motion.slab = slab;
      const SectionId s = section_of(slab, motion.upper);
      if (motion.contour.index() >= nestings[s].region.size()) {
        return no_fit(in_whole, "moves a contour that there is not");
      }
      whole.motions.push_back(motion);
    }
    add(std::move(plan.region_links), slab, whole.correspondence);
    if (whole.voids) {
      if (!has_ends(plan.void_links, whole.voids->component[lower_section(slab)].size(),
                    whole.voids->component[upper_section(slab)].size())) {
        return no_fit(in_whole, "links a void that there is not");
      }
      add(std::move(plan.void_links), slab, *whole.voids);
    }
    return std::nullopt;
  }

  std::optional<Error> add_below(SectionPlan plan) {
    const std::size_t s = slabs_.first - 1;
    const PreparedStack& prepared = window_.prepared;
    Result<Nesting> nesting = nesting_of(s, plan);
    if (!nesting) return nesting.error();
    if (!(plan.section.z < prepared.stack.sections.raw().front().z)) return not_above(s + 1);
    if (!has_ends(plan.region_links, nesting->outer.size(),
                  prepared.nestings.raw().front().outer.size())) {
      return no_region(s);
    }
    window_.prepared.beyond_below = {std::move(plan.section), *std::move(nesting),
                                     std::move(plan.region_links.links)};
    return std::nullopt;
  }

  // `decision`: of the slab between.
  std::optional<Error> add_above(SectionPlan plan, SlabDecision decision) {
    const std::size_t s = slabs_.end + 1;
    const PreparedStack& prepared = window_.prepared;
    Result<Nesting> nesting = nesting_of(s, plan);
    if (!nesting) return nesting.error();
    if (!(plan.section.z > prepared.stack.sections.raw().back().z)) return not_above(s);
    if (!has_ends(decision, prepared.nestings.raw().back().outer.size(), nesting->outer.size())) {
      return no_region(s - 1);
    }
    window_.prepared.beyond_above = {std::move(plan.section), *std::move(nesting),
                                     std::move(decision.links)};
    return std::nullopt;
  }

  // Models are as large as their components' numbers.
  template <class Id>
  [[nodiscard]] bool has_components(const IdVector<Id, ComponentId>& of) const {
    return std::all_of(of.begin(), of.end(),
                       [&](ComponentId c) { return c.index() < components_; });
  }

  static bool has_ends(const SlabDecision& decision, std::size_t below, std::size_t above) {
    const auto has = [&](const Link& link) {
      return link.lower.index() < below && link.upper.index() < above;
    };
    return std::all_of(decision.links.begin(), decision.links.end(), has) &&
           std::all_of(decision.candidates.begin(), decision.candidates.end(),
                       [&](const LinkCandidate& candidate) { return has(candidate.link); });
  }

  // Of a section of the whole.
  static Error no_fit(std::size_t s, const std::string& why) {
    Error error{ErrorCode::invalid_input, "the plan does not fit: the section " + why, {}};
    error.where.section = s;
    return error;
  }
  static Error no_region(std::size_t s) { return no_fit(s, "links a region that there is not"); }

  SlabRange slabs_;
  std::size_t components_;
  BuiltStack window_;
};

}  // namespace

StackFacts facts_of(const BuiltStack& planned) {
  StackFacts facts{planned.prepared.section_count(), 0, planned.plan.exponent, planned.plan.ends,
                   planned.prepared.least_long};
  for (const auto& section : planned.plan.correspondence.component) {
    for (const ComponentId c : section)
      facts.components = std::max(facts.components, c.index() + 1);
  }
  return facts;
}

SectionPlan section_plan(const BuiltStack& planned, SectionId s) {
  const Plan& plan = planned.plan;
  SectionPlan of_section;
  of_section.section = planned.prepared.stack.sections[s];
  of_section.regions = components_of(plan.correspondence, s);
  if (plan.voids) of_section.voids = components_of(*plan.voids, s);
  if (s.index() == planned.prepared.slab_count()) return of_section;
  const SlabId slab(s.index());
  of_section.region_links = decision_of(plan.correspondence, slab);
  if (plan.voids) of_section.void_links = decision_of(*plan.voids, slab);
  const auto in_order = [](const RegionMotion& a, const RegionMotion& b) {
    return a.slab < b.slab;
  };
  const auto [first, end] = std::equal_range(plan.motions.begin(), plan.motions.end(),
                                             RegionMotion{slab, false, {}, {}}, in_order);
  of_section.motions.assign(first, end);
  for (RegionMotion& motion : of_section.motions) motion.slab = SlabId(0);
  return of_section;
}

Result<BuiltStack> window_of(const StackFacts& facts, const SlabRange& slabs,
                             std::vector<SectionPlan> plans, std::optional<SectionPlan> below,
                             std::optional<SectionPlan> above) {
  return guard_internal([&] {
    WindowMaker maker(facts, slabs);
    return maker.make(std::move(plans), std::move(below), std::move(above));
  });
}

namespace {

void number_as_whole(Model& model, const SlabRange& slabs) {
  const auto moved = [&](auto& id) {
    if (id.valid()) id = std::remove_cvref_t<decltype(id)>(id.index() + slabs.first);
  };
  for (SlabId& slab : model.slab) moved(slab);
  for (SectionId& section : model.section) moved(section);
  for (auto& link : model.links) moved(link.slab);
  for (auto& motion : model.motions) moved(motion.slab);
  for (auto& link : model.void_links) moved(link.slab);
  for (auto& deviation : model.deviations) moved(deviation.slab);
}

ClusterSpan span_of(const std::vector<SlabId>& slabs, const Beyond& beyond, std::size_t first) {
  return {{first + slabs.front().index(), first + slabs.back().index() + 1}, beyond};
}

}  // namespace

std::optional<BuiltRange> take_range(const StackFacts& facts, const SlabRange& slabs,
                                     BuiltStack& window, unsigned threads) {
  BuiltRange built;
  built.slabs = slabs;
  for (const OpenCluster& open : window.open) {
    built.clusters.push_back(span_of(open.slabs, open.beyond, slabs.first));
  }
  for (const std::vector<SlabId>& mended : window.mended) {
    built.clusters.push_back(span_of(mended, {}, slabs.first));
  }
  std::optional<Model> model = take_model(window, threads);
  if (!model) return std::nullopt;
  if (auto hint = hint_of_many_tets(window.prepared, *model)) {
    window.warnings.push_back(*std::move(hint));
  }
  built.model = std::move(*model);
  number_as_whole(built.model, slabs);
  built.model.component_count = facts.components;
  return built;
}

Place in_whole(Place place, const SlabRange& slabs) {
  if (place.section) *place.section += slabs.first;
  if (place.slab) *place.slab += slabs.first;
  return place;
}

}  // namespace tetloft::internal

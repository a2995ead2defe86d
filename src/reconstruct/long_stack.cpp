#include "reconstruct/long_stack.hpp"

#include <algorithm>
#include <utility>

#include "core/guard.hpp"
#include "reconstruct/decide.hpp"
#include "reconstruct/decide_voids.hpp"
#include "reconstruct/inner_links.hpp"
#include "reconstruct/layered_voids.hpp"
#include "reconstruct/stack_errors.hpp"
#include "sections/complement.hpp"
#include "slab/classes.hpp"

namespace tetloft::internal {

namespace {

class LongStackOf {
 public:
  explicit LongStackOf(const BuiltStack& built) : built_(built) {
    if (built.plan.voids) layers_.voids.emplace();
  }

  LongLayers make() {
    const IdVector<SlabId, std::uint32_t> taken = built_.sections_between();
    add_given(SectionId(0));
    for (const SlabId slab : taken.ids()) {
      if (taken[slab] > 0) {
        add_inserted(slab);
      } else {
        add_links(built_.plan.correspondence.links[slab],
                  built_.plan.voids ? &built_.plan.voids->links[slab] : nullptr);
      }
      add_given(upper_section(slab));
    }
    return std::move(layers_);
  }

 private:
  void add(const Section& section, const Nesting& nesting, const SectionSource& source,
           const IdVector<RegionId, ComponentId>& component) {
    layers_.prepared.stack.sections.push_back(section);
    layers_.prepared.nestings.push_back(nesting);
    layers_.source.push_back(source);
    IdVector<ContourId, ComponentId> of_contours;
    for (const RegionId r : nesting.region) of_contours.push_back(component[r]);
    layers_.component.push_back(std::move(of_contours));
  }

  void add_given(SectionId s) {
    add(built_.prepared.stack.sections[s], built_.prepared.nestings[s], {false, s, SlabId()},
        built_.plan.correspondence.component[s]);
  }

  void add_inserted(SlabId slab) {
    const between::InnerSections& inner = built_.plan.between[slab];
    const IdVector<SlabId, std::vector<Link>> regions = layer_region_links(inner);
    std::optional<IdVector<SlabId, std::vector<Link>>> voids;
    if (built_.plan.voids) {
      const Layers layers =
          layers_of(given(lower_section(slab)), given(upper_section(slab)), inner);
      voids = LayeredVoids(layers, built_.plan.voids->links[slab]).decide(regions);
      TETLOFT_CHECK(voids.has_value());  // the solid was built by them
    }
    const IdVector<ClassId, ComponentId> component = components_of(slab);
    for (const SlabId k : regions.ids()) {
      add_links(regions[k], voids ? &(*voids)[k] : nullptr);
      if (k.index() == inner.sections.size()) break;
      const between::InnerSection& mid = inner.sections[k.index()];
      IdVector<RegionId, ComponentId> of_regions;
      for (const ClassId c : mid.class_of) of_regions.push_back(component[c]);
      add(mid.section, mid.nesting, {true, SectionId(), slab}, of_regions);
    }
  }

  [[nodiscard]] NestedSection given(SectionId s) const {
    return {built_.prepared.stack.sections[s], built_.prepared.nestings[s]};
  }

  // By class of the slab.
  [[nodiscard]] IdVector<ClassId, ComponentId> components_of(SlabId slab) const {
    const SectionId below = lower_section(slab);
    const SlabClasses classes(built_.prepared.sections[below],
                              built_.prepared.sections[upper_section(slab)],
                              built_.plan.correspondence.links[slab]);
    IdVector<ClassId, ComponentId> components;
    for (const ClassId c : IdRange<ClassId>(classes.class_count())) {
      if (c == classes.exterior()) continue;
      const SlabRegionId r = classes.regions(c).front();
      const SectionId s = section_of(slab, classes.regions().is_upper(r));
      components.push_back(
          built_.plan.correspondence.component[s][classes.regions().in_section(r)]);
    }
    return components;
  }

  // Those of the next slab.
  void add_links(const std::vector<Link>& regions, const std::vector<Link>* voids) {
    const SlabId slab(layers_.regions.size());
    layers_.regions.push_back(in_slab(slab, regions));
    if (voids != nullptr) layers_.voids->push_back(in_slab(slab, *voids));
  }

  static std::vector<Link> in_slab(SlabId slab, std::vector<Link> links) {
    for (Link& link : links) link.slab = slab;
    return links;
  }

  const BuiltStack& built_;
  LongLayers layers_;
};

// A decision on each pair that is linked, would be by the rule, or overlaps; regions, or voids, are
// named by `outer`, and those that it does not name, exteriors, are not decided about.
template <class Outer>
std::vector<LinkDecision> decisions(const IdVector<SlabId, std::vector<Link>>& links,
                                    const StackCandidates& candidates, const Outer& outer) {
  std::vector<LinkDecision> result;
  const auto decide = [&](const Link& link, bool join) {
    const ContourId lower = outer(lower_section(link.slab), link.lower);
    const ContourId upper = outer(upper_section(link.slab), link.upper);
    if (lower.valid() || upper.valid()) result.push_back({link.slab, lower, upper, join});
  };
  for (const SlabId slab : links.ids()) {
    std::vector<std::pair<Link, bool>> decided;
    for (const Link& link : links[slab]) decided.emplace_back(link, true);
    for (const LinkCandidate& candidate : candidates[slab]) {
      if (!candidate.made() && !(candidate.ratio > 0)) continue;
      if (std::binary_search(links[slab].begin(), links[slab].end(), candidate.link)) continue;
      decided.emplace_back(candidate.link, false);
    }
    std::sort(decided.begin(), decided.end());
    for (const auto& [link, join] : decided) decide(link, join);
  }
  return result;
}

}  // namespace

LongLayers long_layers(const BuiltStack& built) { return LongStackOf(built).make(); }

Result<CorrespondenceOptions> settled(const LongLayers& layers, const Execution& execution) {
  ReconstructOptions options;
  options.execution = untold(execution);
  CorrespondenceOptions& rule = options.correspondence;
  rule.criterion = Criterion::overlap;
  rule.chain = false;
  rule.lone = false;
  if (!layers.voids) rule.voids.rule = VoidRule::free;
  const PreparedStack& stack = layers.prepared;
  const WatchedWork work(options.execution, 0);
  const Result<Correspondence> of_regions =
      Decision(stack, options).make(all_ids<SlabId>(stack.slab_count()), work);
  if (!of_regions) return of_regions.error();
  VoidDecision void_decision(stack, options);
  const Result<std::optional<Correspondence>> of_voids = void_decision.make(layers.regions, work);
  if (!of_voids) return of_voids.error();
  CorrespondenceOptions result = rule;
  result.decisions = decisions(layers.regions, of_regions->candidates,
                               [&](SectionId s, RegionId r) { return stack.nestings[s].outer[r]; });
  // Without complements no section has a hole.
  if (layers.voids && !void_decision.complements().empty()) {
    result.voids.decisions =
        decisions(*layers.voids, (*of_voids)->candidates, [&](SectionId s, RegionId of_void) {
          return of_void == sections::kExterior ? ContourId()
                                                : void_decision.complements()[s].outer[of_void];
        });
  }
  return result;
}

}  // namespace tetloft::internal

#include "reconstruct/decide_voids.hpp"

#include <algorithm>
#include <cstdint>
#include <utility>

#include "correspondence/asked_of_voids.hpp"
#include "correspondence/chain_links.hpp"
#include "correspondence/link_report.hpp"
#include "correspondence/void_links.hpp"
#include "reconstruct/section_uses.hpp"
#include "reconstruct/stack_errors.hpp"
#include "sections/complement.hpp"
#include "sections/face_overlay.hpp"

namespace tetloft::internal {

namespace {

OfWhole of_whole_stack(const PreparedStack& prepared) {
  return {sections::far_outside(prepared.stack),
          std::any_of(prepared.nestings.begin(), prepared.nestings.end(), has_hole)};
}

// Of a stack without holes.
Correspondence exteriors_alone(const PreparedStack& prepared) {
  Correspondence result;
  result.links.resize(prepared.slab_count());
  result.candidates.resize(prepared.slab_count());
  for (const SlabId slab : result.links.ids()) {
    result.links[slab].push_back({slab, sections::kExterior, sections::kExterior});
  }
  for (const Nesting& nesting : prepared.nestings) {
    result.component.push_back(IdVector<RegionId, ComponentId>(1, ComponentId(0)));
    result.partition.push_back(
        IdVector<ContourId, ComponentId>(nesting.region.size() + 1, ComponentId(0)));
  }
  return result;
}

}  // namespace

bool has_hole(const Nesting& nesting) {
  return std::any_of(nesting.depth.begin(), nesting.depth.end(),
                     [](std::uint32_t depth) { return depth % 2 != 0; });
}

VoidDecision::VoidDecision(const PreparedStack& prepared, const ReconstructOptions& options)
    : prepared_(prepared), options_(options) {
  if (options.correspondence.voids.rule == VoidRule::free) return;
  const OfWhole whole = prepared.of_whole ? *prepared.of_whole : of_whole_stack(prepared);
  if (!whole.has_hole) return;
  for (const SectionId s : prepared.nestings.ids()) {
    sections::Complement complement = sections::complement_of(
        prepared.stack.sections[s], prepared.nestings[s], whole.far_outside);
    stack_.sections.push_back(std::move(complement.section));
    nestings_.push_back(std::move(complement.nesting));
  }
  sections_.reserve(nestings_.size());
  for (const SectionId s : nestings_.ids()) {
    sections_.push_back(SectionRegions(stack_.sections[s], nestings_[s]));
  }
}

Result<std::optional<Correspondence>> VoidDecision::make(
    const IdVector<SlabId, std::vector<Link>>& of_regions, const WatchedWork& work) {
  // Names that are none are refused, whatever there is to decide.
  const Result<Asked> asked = asked_of_voids(prepared_.nestings, options_.correspondence.voids);
  if (!asked) return asked.error();
  if (options_.correspondence.voids.rule == VoidRule::free) {
    return std::optional<Correspondence>();
  }
  if (stack_.sections.empty()) return std::optional(exteriors_alone(prepared_));
  StackCandidates candidates(prepared_.slab_count());
  if (auto error = find(of_regions, work, candidates)) return *error;
  Result<Correspondence> decided =
      decide_correspondence(stack_, nestings_, sections_, std::move(candidates), *asked);
  if (!decided) return decided.error();
  return std::optional(std::move(*decided));
}

// V0 to V3.
std::optional<Error> VoidDecision::find(const IdVector<SlabId, std::vector<Link>>& of_regions,
                                        const WatchedWork& work, StackCandidates& candidates) {
  const auto around = [&](SectionId s) {
    IdVector<RegionId, RegionId> regions(nestings_[s].outer.size());
    for (const RegionId v : regions.ids()) {
      if (v == sections::kExterior) continue;
      regions[v] = prepared_.nestings[s].region[nestings_[s].outer[v]];
    }
    return regions;
  };
  const std::vector<SlabId> slabs = all_ids<SlabId>(candidates.size());
  const auto in_each_slab = [&](const auto& body) {
    return first_error(slabs, options_.execution.threads, work,
                       [&](SlabId slab) -> std::optional<Error> {
                         const SectionId below = lower_section(slab);
                         const SectionId above = upper_section(slab);
                         // One void is the exterior.
                         if (sections_[below].size() + sections_[above].size() > 2) {
                           body(slab, below, above);
                         }
                         return std::nullopt;
                       });
  };
  overlays_.assign(candidates.size(), {});
  auto error = in_each_slab([&](SlabId slab, SectionId below, SectionId above) {
    sections::FaceOverlay& overlay =
        overlays_[slab].emplace(prepared_.stack.sections[below], prepared_.nestings[below],
                                prepared_.stack.sections[above], prepared_.nestings[above]);
    candidates[slab] = overlapping_voids(slab, sections_[below], sections_[above], overlay,
                                         {of_regions[slab], around(below), around(above)});
    overlay.forget_plane();
  });
  if (error) return error;
  const StackCandidates overlapping = candidates;
  error = in_each_slab([&](SlabId slab, SectionId, SectionId) {
    for (const LinkCandidate& link : chain_links(slab, sections_, overlapping, kVoidChains)) {
      add_candidate(candidates[slab], link);
    }
  });
  if (error) return error;
  SectionUses uses(sections_.size(), slabs);
  return in_each_slab([&](SlabId slab, SectionId below, SectionId above) {
    SlabCandidates& of_slab = candidates[slab];
    const SlabCandidates rims =
        rim_links(slab, sections_[below], sections_[above], of_slab, options_.correspondence.voids);
    for (const LinkCandidate& link : rims) {
      // What nearly was may be there, with what was measured of it.
      if (link.made() || find_candidate(of_slab, link.link) == nullptr) {
        add_candidate(of_slab, link);
      }
    }
    uses.done(slab, [&](SectionId s) { sections_[s].forget_edges(); });
  });
}

std::vector<VoidLink> VoidDecision::links(const Correspondence& correspondence) const {
  if (stack_.sections.empty()) return {};
  return void_links(correspondence.candidates, nestings_);
}

std::size_t cavities(const Correspondence& of_voids) {
  std::size_t components = 0;
  for (const auto& section : of_voids.component) {
    for (const ComponentId id : section) components = std::max(components, id.index() + 1);
  }
  IdVector<ComponentId, std::uint8_t> open(components, 0);
  const SectionId last(of_voids.component.size() - 1);
  for (const SectionId s : {SectionId(0), last}) {
    for (const ComponentId id : of_voids.component[s]) open[id] = 1;
  }
  return static_cast<std::size_t>(std::count(open.begin(), open.end(), 0));
}

}  // namespace tetloft::internal

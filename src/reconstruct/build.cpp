#include "reconstruct/build.hpp"

#include <algorithm>
#include <iterator>
#include <numeric>
#include <string>
#include <utility>

#include "core/guard.hpp"
#include "core/sort_distinct.hpp"
#include "reconstruct/decide_between.hpp"
#include "reconstruct/decide_voids.hpp"
#include "reconstruct/divide.hpp"
#include "reconstruct/layered_slab.hpp"
#include "reconstruct/section_uses.hpp"
#include "reconstruct/stack_errors.hpp"

namespace tetloft::internal {

SlabBuilds::SlabBuilds(PreparedStack& prepared, Decision* decision, Plan& plan,
                       const ReconstructOptions& options, WatchedWork& work)
    : prepared_(prepared),
      decision_(decision),
      plan_(plan),
      options_(options),
      work_(work),
      outcome_(prepared.slab_count()),
      clusters_(prepared.slab_count()),
      refinements_(prepared.slab_count()) {
  plan.between.resize(prepared.slab_count());
  // What links rest on must not change for what they imply.
  plan.may_ask.assign(prepared.slab_count(), depends_on_triangulations() ? 0 : 1);
}

std::optional<Error> SlabBuilds::run() {
  std::vector<SlabId> to_build = all_ids<SlabId>(outcome_.size());
  for (;;) {
    if (auto error = triangulate_again(to_build)) return error;
    if (auto error = build(to_build)) return error;
    to_build.clear();
    while (to_build.empty()) {
      const SlabId stuck = lowest_stuck();
      if (!stuck.valid()) return std::nullopt;
      Result<Mended> mended = mend(stuck);
      if (!mended) return mended.error();
      sort_distinct(mended->touched);
      if (clusters_.unite(stuck, mended->touched, mended->beyond)) {
        leave_open(stuck);
      } else {
        to_build = std::move(mended->touched);
      }
    }
  }
}

SlabId SlabBuilds::lowest_stuck() const {
  for (const SlabId slab : outcome_.ids()) {
    if (!std::holds_alternative<SlabSolid>(outcome_[slab]) && !clusters_.is_open(slab)) return slab;
  }
  return {};
}

void SlabBuilds::leave_open(SlabId of_cluster) {
  for (const SlabId slab : clusters_.restore(of_cluster, plan_)) {
    outcome_[slab] = RefineHere{};
    plan_.may_ask[slab] = depends_on_triangulations() ? 0 : 1;
    refinements_[slab] = 0;
    for (const SectionId s : {lower_section(slab), upper_section(slab)}) {
      const bool used_below = s.index() > 0 && !clusters_.is_open(SlabId(s.index() - 1));
      const bool used_above = s.index() < outcome_.size() && !clusters_.is_open(SlabId(s.index()));
      if (!used_below && !used_above) prepared_.sections[s] = ConformingSection();
    }
    // What a warning tells of was not done.
    std::erase_if(warnings_, [&](const Warning& warning) {
      return warning.where.section == lower_section(slab).index() ||
             warning.where.section == upper_section(slab).index();
    });
  }
}

std::uint64_t SlabBuilds::refinements() const {
  return std::accumulate(refinements_.begin(), refinements_.end(), std::uint64_t{0});
}

Result<SlabBuilds::Mended> SlabBuilds::mend(SlabId slab) {
  const SlabOutcome outcome = outcome_[slab];
  if (const auto* refused = std::get_if<Unrepresentable>(&outcome)) return undivide(slab, *refused);
  if (const auto* apart = std::get_if<Unconnectable>(&outcome)) return drop(slab, *apart);
  return refine(slab, std::get<RefineHere>(outcome));
}

std::optional<Error> SlabBuilds::build(const std::vector<SlabId>& slabs) {
  const bool first_round = built_ == 0;
  built_ += slabs.size();
  SectionUses uses(prepared_.section_count(), slabs);
  return first_error(
      slabs, options_.execution.threads, work_, [&](SlabId slab) -> std::optional<Error> {
        Result<SlabOutcome> outcome = build_slab_between(
            slab, prepared_.sections[lower_section(slab)], prepared_.sections[upper_section(slab)],
            {plan_.correspondence.links[slab], plan_.voids ? &plan_.voids->links[slab] : nullptr},
            plan_.between[slab],
            {options_.delaunay, options_.work_limit, plan_.may_ask[slab] != 0});
        if (outcome) {
          outcome_[slab] = std::move(*outcome);
        } else if (is_refusal(outcome.error().code)) {
          outcome_[slab] = Unrepresentable{outcome.error()};
        } else {
          return outcome.error();
        }
        // Few are touched again, and these may be several times.
        if (first_round) uses.done(slab, [&](SectionId s) { release_if_done(s); });
        const auto* refused = std::get_if<Unrepresentable>(&outcome_[slab]);
        if (refused != nullptr && !is_divided(slab)) return refused->error;
        if (first_round) work_.step_done();  // each slab counts once
        return std::nullopt;
      });
}

// Ends stand on the triangles of the first and the last section; decisions, on those of all.
void SlabBuilds::release_if_done(SectionId s) {
  const bool has_end =
      (plan_.ends.below && s.index() == 0) || (plan_.ends.above && s.index() == outcome_.size());
  if (!has_end && !depends_on_triangulations()) prepared_.release_triangulation(s);
}

std::optional<Error> SlabBuilds::triangulate_again(const std::vector<SlabId>& slabs) {
  for (const SlabId slab : slabs) {
    for (const SectionId s : {lower_section(slab), upper_section(slab)}) {
      if (prepared_.is_triangulated(s)) continue;
      auto error = prepared_.conform_section(s, plan_.gabriel[s], plan_.apart[s], plan_.divided[s]);
      if (error) return error;
    }
  }
  return std::nullopt;
}

bool SlabBuilds::is_divided(SlabId slab) const {
  return !plan_.divided[lower_section(slab)].empty() || !plan_.divided[upper_section(slab)].empty();
}

void SlabBuilds::touch(SectionId s, Mended& mended) const {
  if (s.index() > 0) {
    mended.touched.emplace_back(s.value() - 1);
  } else if (prepared_.beyond_below) {
    mended.beyond.below = true;
  }
  if (s.index() < outcome_.size()) {
    mended.touched.emplace_back(s.value());
  } else if (prepared_.beyond_above) {
    mended.beyond.above = true;
  }
}

std::optional<Error> SlabBuilds::undivide(SectionId s, const std::string& reason, Mended& mended) {
  if (auto error = prepared_.conform_section(s, plan_.gabriel[s], plan_.apart[s])) return error;
  clusters_.keep(s, plan_);
  plan_.divided[s].clear();
  warnings_.push_back(not_divided(s, reason));
  touch(s, mended);
  return std::nullopt;
}

Result<SlabBuilds::Mended> SlabBuilds::undivide(SlabId slab, const Unrepresentable& refused) {
  Mended mended;
  for (const bool upper : {false, true}) {
    const SectionId s = section_of(slab, upper);
    if (plan_.divided[s].empty()) continue;
    if (auto error = undivide(s, refused.error.message, mended)) return *error;
  }
  return mended;
}

// Contours refined to Gabriel edges: regions that overlap then have an own–own edge of D between
// them.
Result<SlabBuilds::Mended> SlabBuilds::refine(SlabId slab, const RefineHere& wanted) {
  Mended mended;
  if (depends_on_triangulations() && decision_ == nullptr) {
    mended.beyond.decides = true;
    return mended;
  }
  ++refinements_[slab];
  for (const bool upper : {false, true}) {
    const SectionId s = section_of(slab, upper);
    IdVector<ContourId, bool> gabriel = plan_.gabriel[s];
    if (gabriel.empty()) gabriel.assign(prepared_.nestings[s].region.size(), false);
    for (const ContourId c : wanted.contours[upper ? 1 : 0]) gabriel[c] = true;
    if (std::find(gabriel.begin(), gabriel.end(), true) == gabriel.end()) gabriel.clear();
    std::vector<Point2> apart = plan_.apart[s];
    for (const Point2& p : wanted.apart) {
      if (std::find(apart.begin(), apart.end(), p) == apart.end()) apart.push_back(p);
    }
    if (gabriel == plan_.gabriel[s] && apart == plan_.apart[s]) continue;
    auto error = prepared_.conform_section(s, gabriel, apart, plan_.divided[s]);
    if (error && wanted.optional && is_refusal(error->code)) {
      plan_.may_ask[slab] = 0;
      continue;
    }
    const bool undivided = error && is_refusal(error->code) && !plan_.divided[s].empty();
    if (error && !undivided) return *error;
    clusters_.keep(s, plan_);
    plan_.gabriel[s] = std::move(gabriel);
    plan_.apart[s] = std::move(apart);
    if (undivided) {
      if (auto failed = undivide(s, error->message, mended)) return *failed;
      continue;
    }
    touch(s, mended);
  }
  std::vector<SlabId>& touched = mended.touched;
  if (wanted.optional && touched.empty()) plan_.may_ask[slab] = 0;
  touched.push_back(slab);
  if (depends_on_triangulations()) {
    sort_distinct(touched);
    if (auto error = adopt(decision_->make(touched, work_), touched)) return *error;
  }
  return mended;
}

// Rule 8 of correspondence: of the links of the class that nobody asked for and whose regions lie
// apart (others always have an edge by now), the one of least score.
Result<SlabBuilds::Mended> SlabBuilds::drop(SlabId slab, const Unconnectable& apart) {
  const SlabRegions regions(prepared_.nestings[lower_section(slab)].outer.size(),
                            prepared_.nestings[upper_section(slab)].outer.size());
  const auto of_class = [&](bool upper, RegionId r) {
    return std::find(apart.regions.begin(), apart.regions.end(), regions.in_slab(upper, r)) !=
           apart.regions.end();
  };
  const LinkCandidate* least = nullptr;
  for (const LinkCandidate& candidate : plan_.correspondence.candidates[slab]) {
    if (!candidate.made() || candidate.distance == 0) continue;
    if (candidate.evidence == Evidence::label || candidate.evidence == Evidence::decision) continue;
    if (!of_class(false, candidate.link.lower) || !of_class(true, candidate.link.upper)) continue;
    if (least == nullptr || candidate.score() < least->score()) least = &candidate;
  }
  if (least == nullptr) return cannot_connect(slab, apart);
  Mended mended;
  if (decision_ == nullptr) {
    mended.beyond.decides = true;
    return mended;
  }
  const Link link = least->link;
  if (auto error = adopt(decision_->make_without(link), mended.touched)) return *error;
  return mended;
}

std::optional<Error> SlabBuilds::adopt(Result<Correspondence> anew, std::vector<SlabId>& touched) {
  if (!anew) return anew.error();
  std::vector<SlabId> around;  // what is put between depends on the links of three slabs
  for (const SlabId k : outcome_.ids()) {
    if (anew->links[k] == plan_.correspondence.links[k]) continue;
    touched.push_back(k);
    for (const std::size_t beside : {k.index() - 1, k.index(), k.index() + 1}) {
      if (beside < outcome_.size()) around.emplace_back(beside);
    }
  }
  plan_.correspondence = std::move(*anew);
  sort_distinct(around);
  if (auto error = decide_between(prepared_, options_, around, work_, plan_)) return error;
  if (options_.between != 0) touched.insert(touched.end(), around.begin(), around.end());
  if (!plan_.voids) return std::nullopt;
  // Where a wall belongs depends on links of regions.
  Result<std::optional<Correspondence>> voids =
      VoidDecision(prepared_, options_).make(plan_.correspondence.links, work_);
  if (!voids) return voids.error();
  for (const SlabId k : outcome_.ids()) {
    if ((*voids)->links[k] != plan_.voids->links[k]) touched.push_back(k);
  }
  plan_.voids = std::move(*voids);
  return std::nullopt;
}

Error SlabBuilds::cannot_connect(SlabId slab, const Unconnectable& apart) const {
  const SlabRegions regions(prepared_.nestings[lower_section(slab)].outer.size(),
                            prepared_.nestings[upper_section(slab)].outer.size());
  std::string names;
  for (const SlabRegionId r : apart.regions) {
    const SectionId s = section_of(slab, regions.is_upper(r));
    const ContourId outer = prepared_.nestings[s].outer[regions.in_section(r)];
    if (!names.empty()) names += ", ";
    names += "section " + std::to_string(prepared_.first_section + s.index()) + " contour " +
             std::to_string(outer.index());
  }
  Place place;
  place.slab = slab.index();
  return {ErrorCode::unrepresentable,
          "regions to be united have no Delaunay edge between them: " + names, place};
}

std::vector<Part> SlabBuilds::take_parts() {
  const auto& sections = prepared_.sections;
  const SectionId first(0);
  const SectionId last(sections.size() - 1);
  std::vector<Part> parts;
  parts.reserve(outcome_.size() + 2);
  const bool has_slabs = !outcome_.empty();
  if (plan_.ends.below && !(has_slabs && clusters_.is_open(SlabId(0)))) {
    parts.push_back({SlabId(0), SectionId(), first, build_end(sections[first], *plan_.ends.below)});
  }
  for (const SlabId slab : outcome_.ids()) {
    if (clusters_.is_open(slab)) continue;
    parts.push_back({slab, lower_section(slab), upper_section(slab),
                     std::get<SlabSolid>(std::move(outcome_[slab]))});
  }
  const SlabId last_slab(has_slabs ? outcome_.size() - 1 : 0);
  if (plan_.ends.above && !(has_slabs && clusters_.is_open(last_slab))) {
    parts.push_back({last_slab, last, SectionId(), build_end(sections[last], *plan_.ends.above)});
  }
  return parts;
}

}  // namespace tetloft::internal

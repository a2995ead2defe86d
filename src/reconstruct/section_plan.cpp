#include "reconstruct/section_plan.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/enums.hpp"
#include "core/guard.hpp"
#include "core/record.hpp"
#include "reconstruct/section_record.hpp"

namespace tetloft::internal {

namespace {

constexpr RecordKind kSectionPlan{"sect", 2, "a section of a plan"};

constexpr std::size_t kLink = 2 * sizeof(std::uint32_t);
constexpr std::size_t kCandidate = kLink + 3 + 5 * sizeof(double);
constexpr std::size_t kMotion = 1 + sizeof(std::uint32_t) + 2 * sizeof(double);

void put_components(const SectionComponents& components, RecordWriter& out) {
  out.put_all(components.of_region);
  out.put_all(components.of_contour);
}

SectionComponents get_components(RecordReader& in) {
  SectionComponents components;
  components.of_region.raw() = in.get_all<ComponentId>();
  components.of_contour.raw() = in.get_all<ComponentId>();
  const auto valid = [](ComponentId id) { return id.valid(); };
  in.require(std::all_of(components.of_region.begin(), components.of_region.end(), valid) &&
                 std::all_of(components.of_contour.begin(), components.of_contour.end(), valid),
             "has a region of no component");
  return components;
}

void put_link(const Link& link, RecordWriter& out) {
  out.put(link.lower);
  out.put(link.upper);
}

Link get_link(RecordReader& in) {
  Link link;
  link.slab = SlabId(0);
  link.lower = in.get<RegionId>();
  link.upper = in.get<RegionId>();
  return link;
}

void put_candidate(const LinkCandidate& candidate, RecordWriter& out) {
  put_link(candidate.link, out);
  out.put(static_cast<std::uint8_t>(candidate.evidence));
  out.put(static_cast<std::uint8_t>(candidate.fate));
  out.put(static_cast<std::uint8_t>(candidate.lead ? 1 : 0));
  for (const double value : {candidate.ratio, candidate.moved, candidate.distance, candidate.margin,
                             candidate.lead.value_or(0)}) {
    out.put(value);
  }
}

LinkCandidate get_candidate(RecordReader& in) {
  LinkCandidate candidate;
  candidate.link = get_link(in);
  candidate.evidence = static_cast<Evidence>(in.get<std::uint8_t>());
  candidate.fate = static_cast<LinkFate>(in.get<std::uint8_t>());
  in.require(is_enumerator(candidate.evidence, Evidence::rim) &&
                 is_enumerator(candidate.fate, LinkFate::forced),
             "has a link of no evidence or fate");
  const bool leads = in.get<std::uint8_t>() != 0;
  double lead = 0;
  for (double* const value :
       {&candidate.ratio, &candidate.moved, &candidate.distance, &candidate.margin, &lead}) {
    *value = in.get<double>();
    in.require(std::isfinite(*value), "has a link with a number that is not finite");
  }
  if (leads) candidate.lead = lead;
  return candidate;
}

void put_decision(const SlabDecision& decision, RecordWriter& out) {
  out.put_count(decision.links.size());
  for (const Link& link : decision.links) put_link(link, out);
  out.put_count(decision.candidates.size());
  for (const LinkCandidate& candidate : decision.candidates) put_candidate(candidate, out);
}

SlabDecision get_decision(RecordReader& in) {
  SlabDecision decision;
  decision.links.resize(in.get_count(kLink));
  for (Link& link : decision.links) link = get_link(in);
  decision.candidates.resize(in.get_count(kCandidate));
  for (LinkCandidate& candidate : decision.candidates) candidate = get_candidate(in);
  in.require(std::is_sorted(decision.links.begin(), decision.links.end()),
             "has links that are not sorted");
  return decision;
}

void put_motions(const std::vector<RegionMotion>& motions, RecordWriter& out) {
  out.put_count(motions.size());
  for (const RegionMotion& motion : motions) {
    out.put(static_cast<std::uint8_t>(motion.upper ? 1 : 0));
    out.put(motion.contour);
    out.put(motion.by.x);
    out.put(motion.by.y);
  }
}

std::vector<RegionMotion> get_motions(RecordReader& in) {
  std::vector<RegionMotion> motions(in.get_count(kMotion));
  for (RegionMotion& motion : motions) {
    motion.slab = SlabId(0);
    motion.upper = in.get<std::uint8_t>() != 0;
    motion.contour = in.get<ContourId>();
    motion.by.x = in.get<double>();
    motion.by.y = in.get<double>();
    in.require(std::isfinite(motion.by.x) && std::isfinite(motion.by.y),
               "has a motion that is not finite");
  }
  return motions;
}

}  // namespace

std::string to_record(const SectionPlan& plan) {
  RecordWriter out(kSectionPlan);
  put_section(plan.section, out);
  put_components(plan.regions, out);
  out.put(static_cast<std::uint8_t>(plan.voids ? 1 : 0));
  if (plan.voids) put_components(*plan.voids, out);
  put_decision(plan.region_links, out);
  put_decision(plan.void_links, out);
  put_motions(plan.motions, out);
  return out.take();
}

Result<SectionPlan> section_plan_from_record(std::string_view bytes, const std::string& name) {
  return guard_internal([&]() -> Result<SectionPlan> {
    RecordReader in(bytes, kSectionPlan, name);
    SectionPlan plan;
    plan.section = get_section(in);
    plan.regions = get_components(in);
    if (in.get<std::uint8_t>() != 0) plan.voids = get_components(in);
    plan.region_links = get_decision(in);
    plan.void_links = get_decision(in);
    plan.motions = get_motions(in);
    in.require(plan.regions.of_contour.size() == plan.section.contours.size(),
               "tells the components of some of its contours");
    in.require(!plan.voids || (plan.voids->of_contour.size() == plan.section.contours.size() + 1 &&
                               !plan.voids->of_region.empty()),
               "has other voids than regions");
    if (Result<void> read = in.end(); !read) return read.error();
    return plan;
  });
}

}  // namespace tetloft::internal

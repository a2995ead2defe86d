#include "reconstruct/records.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/enums.hpp"
#include "core/guard.hpp"
#include "core/record.hpp"
#include "reconstruct/inner_record.hpp"

namespace tetloft::internal {

namespace {

constexpr RecordKind kPlan{"plan", 4, "a plan"};
constexpr RecordKind kSolid{"slab", 3, "the solid of a slab"};

// The least that a vector of a vector takes: its count.
constexpr std::size_t kVector = sizeof(std::uint64_t);
constexpr std::size_t kLink = 2 * sizeof(std::uint32_t);
constexpr std::size_t kCandidate = kLink + 3 + 5 * sizeof(double);
constexpr std::size_t kMotion = 2 * sizeof(std::uint32_t) + 1 + 2 * sizeof(double);
constexpr std::size_t kDivision = 2 * sizeof(std::uint32_t) + sizeof(std::uint64_t);
constexpr std::size_t kPieceBytes = 5 * sizeof(std::uint32_t) + 1;

void put_gabriel(const Plan& plan, RecordWriter& out) {
  out.put_count(plan.gabriel.size());
  for (const auto& section : plan.gabriel) {
    out.put_count(section.size());
    for (const ContourId c : section.ids()) {
      out.put(static_cast<std::uint8_t>(section[c] ? 1 : 0));
    }
  }
}

void get_gabriel(RecordReader& in, Plan& plan) {
  plan.gabriel.resize(in.get_count(kVector));
  for (auto& section : plan.gabriel) {
    section.resize(in.get_count(1));
    for (const ContourId c : section.ids()) section[c] = in.get<std::uint8_t>() != 0;
  }
}

void put_apart(const Plan& plan, RecordWriter& out) {
  out.put_count(plan.apart.size());
  for (const std::vector<Point2>& section : plan.apart) {
    out.put_count(section.size());
    for (const Point2& p : section) {
      out.put(p.x);
      out.put(p.y);
    }
  }
}

void get_apart(RecordReader& in, Plan& plan) {
  plan.apart.resize(in.get_count(kVector));
  for (auto& section : plan.apart) {
    section.resize(in.get_count(2 * sizeof(double)));
    for (Point2& p : section) {
      p.x = in.get<double>();
      p.y = in.get<double>();
      in.require(std::isfinite(p.x) && std::isfinite(p.y), "has a point that is not finite");
    }
  }
}

void put_divided(const Plan& plan, RecordWriter& out) {
  out.put_count(plan.divided.size());
  for (const std::vector<EdgeDivision>& section : plan.divided) {
    out.put_count(section.size());
    for (const EdgeDivision& division : section) {
      out.put(division.contour);
      out.put(static_cast<std::uint64_t>(division.edge));
      out.put(division.parts);
    }
  }
}

void get_divided(RecordReader& in, Plan& plan) {
  plan.divided.resize(in.get_count(kVector));
  for (auto& section : plan.divided) {
    section.resize(in.get_count(kDivision));
    for (EdgeDivision& division : section) {
      division.contour = in.get<ContourId>();
      division.edge = in.get<std::uint64_t>();
      division.parts = in.get<std::uint32_t>();
    }
  }
}

void put_candidates(const StackCandidates& candidates, RecordWriter& out) {
  out.put_count(candidates.size());
  for (const SlabCandidates& slab : candidates) {
    out.put_count(slab.size());
    for (const LinkCandidate& candidate : slab) {
      out.put(candidate.link.lower);
      out.put(candidate.link.upper);
      out.put(static_cast<std::uint8_t>(candidate.evidence));
      out.put(static_cast<std::uint8_t>(candidate.fate));
      out.put(static_cast<std::uint8_t>(candidate.lead ? 1 : 0));
      for (const double value : {candidate.ratio, candidate.moved, candidate.distance,
                                 candidate.margin, candidate.lead.value_or(0)}) {
        out.put(value);
      }
    }
  }
}

LinkCandidate get_candidate(RecordReader& in, SlabId slab) {
  LinkCandidate candidate;
  candidate.link.slab = slab;
  candidate.link.lower = in.get<RegionId>();
  candidate.link.upper = in.get<RegionId>();
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

void get_candidates(RecordReader& in, StackCandidates& candidates) {
  candidates.resize(in.get_count(kVector));
  for (const SlabId slab : candidates.ids()) {
    const std::size_t count = in.get_count(kCandidate);
    candidates[slab].reserve(count);
    for (std::size_t k = 0; k < count; ++k) candidates[slab].push_back(get_candidate(in, slab));
  }
}

void put_motions(const std::vector<RegionMotion>& motions, RecordWriter& out) {
  out.put_count(motions.size());
  for (const RegionMotion& motion : motions) {
    out.put(motion.slab);
    out.put(static_cast<std::uint8_t>(motion.upper ? 1 : 0));
    out.put(motion.contour);
    out.put(motion.by.x);
    out.put(motion.by.y);
  }
}

void get_motions(RecordReader& in, std::vector<RegionMotion>& motions) {
  motions.resize(in.get_count(kMotion));
  for (RegionMotion& motion : motions) {
    motion.slab = in.get<SlabId>();
    motion.upper = in.get<std::uint8_t>() != 0;
    motion.contour = in.get<ContourId>();
    motion.by.x = in.get<double>();
    motion.by.y = in.get<double>();
    in.require(std::isfinite(motion.by.x) && std::isfinite(motion.by.y),
               "has a motion that is not finite");
  }
}

void put_correspondence(const Correspondence& correspondence, RecordWriter& out) {
  out.put_count(correspondence.links.size());
  for (const std::vector<Link>& links : correspondence.links) {
    out.put_count(links.size());
    for (const Link& link : links) {
      out.put(link.lower);
      out.put(link.upper);
    }
  }
  out.put_count(correspondence.component.size());
  for (const auto& section : correspondence.component) out.put_all(section);
  out.put_count(correspondence.partition.size());
  for (const auto& section : correspondence.partition) out.put_all(section);
  put_candidates(correspondence.candidates, out);
}

void get_correspondence(RecordReader& in, Correspondence& correspondence) {
  correspondence.links.resize(in.get_count(kVector));
  for (const SlabId slab : correspondence.links.ids()) {
    std::vector<Link>& links = correspondence.links[slab];
    links.resize(in.get_count(kLink));
    for (Link& link : links) {
      link.slab = slab;
      link.lower = in.get<RegionId>();
      link.upper = in.get<RegionId>();
    }
  }
  correspondence.component.resize(in.get_count(kVector));
  for (auto& section : correspondence.component) section.raw() = in.get_all<ComponentId>();
  correspondence.partition.resize(in.get_count(kVector));
  for (auto& section : correspondence.partition) section.raw() = in.get_all<ComponentId>();
  get_candidates(in, correspondence.candidates);
}

// `what`: "region" or "void".
void check_correspondence(const Correspondence& correspondence, std::size_t sections,
                          const std::string& what, RecordReader& in) {
  const auto& [links, component, partition, candidates] = correspondence;
  in.require(sections > 0 && links.size() == sections - 1 && component.size() == sections &&
                 partition.size() == sections && candidates.size() == links.size(),
             "plans some of its sections");
  if (in.refused()) return;
  for (const SlabId slab : links.ids()) {
    for (const Link& link : links[slab]) {
      in.require(link.lower.index() < component[lower_section(slab)].size() &&
                     link.upper.index() < component[upper_section(slab)].size(),
                 "links a " + what + " it lacks");
    }
  }
  for (const SlabId slab : candidates.ids()) {
    for (const LinkCandidate& candidate : candidates[slab]) {
      in.require(candidate.link.lower.index() < component[lower_section(slab)].size() &&
                     candidate.link.upper.index() < component[upper_section(slab)].size(),
                 "tells of a " + what + " it lacks");
    }
  }
}

void check_plan(const Plan& plan, RecordReader& in) {
  const auto& partition = plan.correspondence.partition;
  check_correspondence(plan.correspondence, plan.gabriel.size(), "region", in);
  if (plan.voids) check_correspondence(*plan.voids, plan.gabriel.size(), "void", in);
  if (in.refused()) return;
  in.require(plan.apart.size() == plan.gabriel.size() &&
                 plan.divided.size() == plan.gabriel.size() &&
                 plan.may_ask.size() + 1 == plan.gabriel.size(),
             "plans some of its sections");
  if (in.refused()) return;
  for (const SectionId s : plan.gabriel.ids()) {
    in.require(plan.gabriel[s].empty() || plan.gabriel[s].size() == partition[s].size(),
               "refines some of its contours");
    for (const EdgeDivision& division : plan.divided[s]) {
      in.require(division.contour.index() < partition[s].size() && division.parts > 0,
                 "divides a contour it lacks, or into nothing");
    }
    // The frame of a complement is a contour more, and its exterior a void in every section.
    in.require(!plan.voids || (plan.voids->partition[s].size() == partition[s].size() + 1 &&
                               !plan.voids->component[s].empty()),
               "has other voids than regions");
  }
  for (const RegionMotion& motion : plan.motions) {
    in.require(motion.slab.index() < plan.correspondence.links.size() &&
                   motion.contour.index() < partition[section_of(motion.slab, motion.upper)].size(),
               "moves a contour it lacks");
  }
}

template <class Numbering>
Numbering get_numbering(RecordReader& in) {
  const auto lower = in.get<std::uint32_t>();
  const auto upper = in.get<std::uint32_t>();
  return {lower, upper};
}

template <class Numbering>
void put_numbering(const Numbering& numbering, RecordWriter& out) {
  out.put(static_cast<std::uint32_t>(numbering.lower_size()));
  out.put(static_cast<std::uint32_t>(numbering.upper_size()));
}

void get_constructed(RecordReader& in, SlabSolid& solid) {
  solid.constructed.resize(in.get_count(3 * sizeof(double) + 1));
  solid.origin.resize(solid.constructed.size());
  for (const ConstructedId k : solid.constructed.ids()) {
    Point3& p = solid.constructed[k];
    p.x = in.get<double>();
    p.y = in.get<double>();
    p.z = in.get<double>();
    in.require(std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z),
               "has a vertex that is not finite");
    solid.origin[k] = static_cast<PointOrigin>(in.get<std::uint8_t>());
    in.require(is_enumerator(solid.origin[k], PointOrigin::inserted), "has an origin that is none");
  }
}

void get_pieces(RecordReader& in, SlabSolid& solid) {
  const std::size_t nodes = solid.vertices.size() + solid.constructed.size();
  solid.pieces.resize(in.get_count(kPieceBytes));
  for (Piece& piece : solid.pieces) {
    for (NodeId& n : piece.node) {
      n = in.get<NodeId>();
      in.require(n.index() < nodes, "names a vertex it lacks");
    }
    piece.region = in.get<SlabRegionId>();
    in.require(piece.region.index() < solid.regions.size(), "names a region it lacks");
    piece.kind = static_cast<TetKind>(in.get<std::uint8_t>());
    in.require(is_enumerator(piece.kind, TetKind::prism), "has a tet of no kind");
  }
}

// Of a plan checked so far.
void get_between(RecordReader& in, Plan& plan) {
  const std::size_t slabs = in.get_count(3 * kVector);
  in.require(slabs == plan.correspondence.links.size(), "plans some of its sections");
  if (in.refused()) return;
  const auto& component = plan.correspondence.component;
  for (const SlabId slab : plan.correspondence.links.ids()) {
    plan.between.push_back(get_inner(in, component[lower_section(slab)].size(),
                                     component[upper_section(slab)].size()));
  }
}

}  // namespace

std::string to_record(const Plan& plan) {
  RecordWriter out(kPlan);
  out.put(static_cast<std::int32_t>(plan.exponent));
  out.put(static_cast<std::uint8_t>(plan.ends ? 1 : 0));
  out.put(plan.ends ? plan.ends->below : 0);
  out.put(plan.ends ? plan.ends->above : 0);
  put_gabriel(plan, out);
  put_apart(plan, out);
  put_divided(plan, out);
  out.put_all(plan.may_ask);
  put_correspondence(plan.correspondence, out);
  put_motions(plan.motions, out);
  out.put(static_cast<std::uint8_t>(plan.voids ? 1 : 0));
  if (plan.voids) put_correspondence(*plan.voids, out);
  out.put_count(plan.between.size());
  for (const between::InnerSections& inner : plan.between) put_inner(inner, out);
  return out.take();
}

Result<Plan> plan_from_record(std::string_view bytes, const std::string& name) {
  return guard_internal([&]() -> Result<Plan> {
    RecordReader in(bytes, kPlan, name);
    Plan plan;
    plan.exponent = in.get<std::int32_t>();
    const bool has_ends = in.get<std::uint8_t>() != 0;
    const double below = in.get<double>();
    const double above = in.get<double>();
    if (has_ends) plan.ends = {below, above};
    in.require(std::isfinite(below) && std::isfinite(above), "has an end that is not finite");
    get_gabriel(in, plan);
    get_apart(in, plan);
    get_divided(in, plan);
    plan.may_ask.raw() = in.get_all<std::uint8_t>();
    get_correspondence(in, plan.correspondence);
    get_motions(in, plan.motions);
    if (in.get<std::uint8_t>() != 0) get_correspondence(in, plan.voids.emplace());
    check_plan(plan, in);
    get_between(in, plan);
    if (Result<void> read = in.end(); !read) return read.error();
    return plan;
  });
}

std::string to_record(const SlabSolid& solid) {
  RecordWriter out(kSolid);
  put_numbering(solid.vertices, out);
  put_numbering(solid.regions, out);
  out.put_count(solid.constructed.size());
  for (const ConstructedId k : solid.constructed.ids()) {
    const Point3& p = solid.constructed[k];
    out.put(p.x);
    out.put(p.y);
    out.put(p.z);
    out.put(static_cast<std::uint8_t>(solid.origin[k]));
  }
  out.put_count(solid.pieces.size());
  for (const Piece& piece : solid.pieces) {
    for (const NodeId n : piece.node) out.put(n);
    out.put(piece.region);
    out.put(static_cast<std::uint8_t>(piece.kind));
  }
  out.put_all(solid.rules);
  out.put(solid.smallest_lift);
  out.put_all(solid.seconds);
  out.put(solid.work);
  out.put(solid.sections_between);
  out.put(solid.sections_given_up);
  out.put_all(solid.chi);
  out.put_count(solid.deviations.size());
  for (const SlabDeviation& deviation : solid.deviations) {
    out.put(deviation.region);
    for (const std::int32_t chi : {deviation.least, deviation.most, deviation.got}) out.put(chi);
  }
  out.put_count(solid.unrealised.size());
  for (const Link& link : solid.unrealised) {
    out.put(link.slab);
    out.put(link.lower);
    out.put(link.upper);
  }
  out.put_count(solid.united_voids.size());
  for (const auto& [a, b] : solid.united_voids) {
    out.put(a);
    out.put(b);
  }
  return out.take();
}

Result<SlabSolid> solid_from_record(std::string_view bytes, const std::string& name) {
  return guard_internal([&]() -> Result<SlabSolid> {
    RecordReader in(bytes, kSolid, name);
    SlabSolid solid;
    solid.vertices = get_numbering<SlabVertices>(in);
    solid.regions = get_numbering<SlabRegions>(in);
    get_constructed(in, solid);
    get_pieces(in, solid);
    const std::vector<std::uint64_t> rules = in.get_all<std::uint64_t>();
    solid.smallest_lift = in.get<double>();
    const std::vector<double> seconds = in.get_all<double>();
    solid.work = in.get<std::uint64_t>();
    solid.sections_between = in.get<std::uint32_t>();
    solid.sections_given_up = in.get<std::uint32_t>();
    solid.chi.raw() = in.get_all<std::int32_t>();
    solid.deviations.resize(in.get_count(4 * sizeof(std::uint32_t)));
    for (SlabDeviation& deviation : solid.deviations) {
      deviation.region = in.get<SlabRegionId>();
      in.require(deviation.region.index() < solid.regions.size(), "names a region it lacks");
      for (std::int32_t* const chi : {&deviation.least, &deviation.most, &deviation.got}) {
        *chi = in.get<std::int32_t>();
      }
    }
    solid.unrealised.resize(in.get_count(3 * sizeof(std::uint32_t)));
    for (Link& link : solid.unrealised) {
      link.slab = in.get<SlabId>();
      link.lower = in.get<RegionId>();
      link.upper = in.get<RegionId>();
    }
    solid.united_voids.resize(in.get_count(2 * sizeof(std::uint32_t)));
    for (auto& [a, b] : solid.united_voids) {
      a = in.get<SlabVoidId>();
      b = in.get<SlabVoidId>();
    }
    in.require(rules.size() == solid.rules.size() && seconds.size() == solid.seconds.size(),
               "counts rules or steps that there are not");
    if (Result<void> read = in.end(); !read) return read.error();
    std::copy(rules.begin(), rules.end(), solid.rules.begin());
    std::copy(seconds.begin(), seconds.end(), solid.seconds.begin());
    return solid;
  });
}

}  // namespace tetloft::internal

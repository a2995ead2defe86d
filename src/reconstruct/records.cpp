#include "reconstruct/records.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/enums.hpp"
#include "core/guard.hpp"
#include "core/record.hpp"

namespace tetloft::internal {

namespace {

constexpr RecordKind kPlan{"plan", 1, "a plan"};
constexpr RecordKind kSolid{"slab", 1, "the solid of a slab"};

// The least that a vector of a vector takes: its count.
constexpr std::size_t kVector = sizeof(std::uint64_t);
constexpr std::size_t kLink = 2 * sizeof(std::uint32_t);
constexpr std::size_t kPiece = 5 * sizeof(std::uint32_t) + 1;

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
}

void check_plan(const Plan& plan, RecordReader& in) {
  const auto& [links, component, partition] = plan.correspondence;
  const std::size_t sections = plan.gabriel.size();
  in.require(sections > 0 && links.size() == sections - 1 && component.size() == sections &&
                 partition.size() == sections,
             "plans some of its sections");
  if (in.refused()) return;
  for (const SectionId s : plan.gabriel.ids()) {
    in.require(plan.gabriel[s].empty() || plan.gabriel[s].size() == partition[s].size(),
               "refines some of its contours");
  }
  for (const SlabId slab : links.ids()) {
    for (const Link& link : links[slab]) {
      in.require(link.lower.index() < component[lower_section(slab)].size() &&
                     link.upper.index() < component[upper_section(slab)].size(),
                 "links a region it lacks");
    }
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
    in.require(is_enumerator(solid.origin[k], PointOrigin::projected),
               "has an origin that is none");
  }
}

void get_pieces(RecordReader& in, SlabSolid& solid) {
  const std::size_t nodes = solid.vertices.size() + solid.constructed.size();
  solid.pieces.resize(in.get_count(kPiece));
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

}  // namespace

std::string to_record(const Plan& plan) {
  RecordWriter out(kPlan);
  out.put(static_cast<std::int32_t>(plan.exponent));
  out.put(static_cast<std::uint8_t>(plan.ends ? 1 : 0));
  out.put(plan.ends ? plan.ends->below : 0);
  out.put(plan.ends ? plan.ends->above : 0);
  put_gabriel(plan, out);
  put_correspondence(plan.correspondence, out);
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
    get_correspondence(in, plan.correspondence);
    check_plan(plan, in);
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
    in.require(rules.size() == solid.rules.size() && seconds.size() == solid.seconds.size(),
               "counts rules or steps that there are not");
    if (Result<void> read = in.end(); !read) return read.error();
    std::copy(rules.begin(), rules.end(), solid.rules.begin());
    std::copy(seconds.begin(), seconds.end(), solid.seconds.begin());
    return solid;
  });
}

}  // namespace tetloft::internal

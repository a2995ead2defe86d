#include "reconstruct/slab_solid.hpp"

#include <algorithm>
#include <string>
#include <utility>

#include "completion/completion.hpp"
#include "completion/pits.hpp"
#include "core/guard.hpp"
#include "reconstruct/lattice_hint.hpp"
#include "reconstruct/topology.hpp"
#include "slab/delaunay.hpp"
#include "subdivision/embedding.hpp"
#include "subdivision/trimming.hpp"

namespace tetloft::internal {

namespace {

Error no_room(SlabId id, const Point3& at, std::string what) {
  Place place;
  place.slab = id.index();
  place.point = at;
  return {ErrorCode::unrepresentable, std::move(what), place};
}

Error too_close(SlabId id, const Point3& at, const Slab& slab) {
  std::string what =
      "doubles leave no room for a valid model here: features are too close for the coordinates' "
      "precision";
  const int bits = merging_bits(slab.lower(), slab.upper());
  what += bits == 0 ? " (snapping them to a lattice may help)"
                    : "; coordinates differ in their last bits: snapping them to a lattice of " +
                          std::to_string(bits) + " bits (--snap " + std::to_string(bits) +
                          ") merges these and nothing else";
  return no_room(id, at, std::move(what));
}

std::vector<LoneEnd> lone_ends(const SlabClasses& classes) {
  std::vector<LoneEnd> lone;
  for (const ClassId c : IdRange<ClassId>(classes.class_count())) {
    if (classes.is_lone(c)) lone.push_back({c, classes.regions(c).front(), 0});
  }
  return lone;
}

// Classes that end in a prism are not completed, nor are exterior vertices.
IdVector<ClassId, std::uint8_t> active_classes(const SlabClasses& classes,
                                               const std::vector<LoneEnd>& lone) {
  IdVector<ClassId, std::uint8_t> active(classes.class_count(), 1);
  if (classes.exterior().valid()) active[classes.exterior()] = 0;
  for (const LoneEnd& end : lone) active[end.id] = end.is_prism() ? 0 : 1;
  return active;
}

// Tets kept at an own corner and not attached there.
std::uint64_t detached_sheets(const Complex& complex) {
  std::uint64_t detached = 0;
  for (const TetId t : complex.kept.ids()) {
    if ((complex.kept[t] & ~complex.attached[t]) != 0) ++detached;
  }
  return detached;
}

// All nodes of a slab's solid lie on its boundary, and a 3-manifold has half the Euler
// characteristic of its boundary: (V − F / 2) / 2, where triangles alone bound. Vertices of regions
// are all there.
IdVector<ClassId, std::int32_t> chi_by_class(const Slab& slab, const SlabClasses& classes,
                                             const Embedding& embedding) {
  IdVector<NodeId, ClassId> of_node(embedding.points().size());
  for (const SlabVertexId v : slab.vertices()) {
    if (classes.of(v) != classes.exterior()) of_node[Nodes::of(v)] = classes.of(v);
  }
  for (const Piece& piece : embedding.pieces()) {
    const ClassId c = classes.of_region(piece.region);
    for (const NodeId n : piece.node) of_node[n] = c;
  }
  std::vector<std::int64_t> four_chi(classes.class_count(), 0);
  for (const ClassId c : of_node) {
    if (c.valid()) four_chi[c.index()] += 2;
  }
  for (const TriangleVertices& triangle : embedding.boundary()) {
    --four_chi[of_node[NodeId(triangle[0].value())].index()];
  }
  IdVector<ClassId, std::int32_t> chi;
  if (classes.exterior().valid()) four_chi.pop_back();
  for (const std::int64_t four : four_chi) {
    TETLOFT_CHECK(four % 4 == 0);
    chi.push_back(static_cast<std::int32_t>(four / 4));
  }
  return chi;
}

class SlabBuilder {
 public:
  SlabBuilder(SlabId id, const ConformingSection& lower, const ConformingSection& upper,
              const SlabLinks& links, const SlabOptions& options)
      : id_(id),
        links_(links),
        options_(options),
        vertices_(lower.vertex_count(), upper.vertex_count()),
        pits_(lower, upper),
        topology_(lower, upper, links, pits_) {}

  Result<SlabOutcome> run() {
    // Each round but the last opens a pit at least, or gives all of them up.
    for (;;) {
      Attempt built = attempt();
      if (!built) continue;
      const bool outcome = accepted(*built);
      const bool solid = outcome && std::holds_alternative<SlabSolid>(**built);
      const bool asks = outcome && std::holds_alternative<RefineHere>(**built);
      if (pits_.opened() + pits_.pairs() > 0 && !solid && !asks) {
        pits_.give_up();
        continue;
      }
      if (solid) finish(std::get<SlabSolid>(**built));
      return *std::move(built);
    }
  }

 private:
  using Attempt = std::optional<Result<SlabOutcome>>;

  // Over the sections of pits_; nothing if these changed, since a pit was sealed.
  Attempt attempt() {
    StepClock clock(seconds_);
    Result<SlabDelaunay> d =
        slab_delaunay(id_, pits_.lower(), pits_.upper(), options_.engine, options_.work_limit);
    if (!d) return d.error();
    work_ += d->mesh.tet_count();
    const Slab slab(pits_.lower(), pits_.upper(), std::move(*d));
    clock.end(Step::delaunay);

    const SlabClasses classes(slab.lower(), slab.upper(), links_.regions);
    std::vector<LoneEnd> lone = lone_ends(classes);
    // Each round completes one more lone class at least that has no room for a prism.
    for (;;) {
      RuleCounts rules{};
      const IdVector<ClassId, std::uint8_t> active = active_classes(classes, lone);
      Completion completion(slab, classes, active, seed(slab, classes, active, rules), rules);
      std::vector<LeftApart> apart = completion.run();
      work_ += completion.work();
      clock.end(Step::complex);
      if (!apart.empty()) return left_apart(slab, classes, apart.front());
      const bool sealed = pits_.open_sealed(slab, classes, completion.complex());
      clock.end(Step::complex);
      if (sealed) return std::nullopt;
      const Topology::Next next =
          topology_.make({slab, classes, active}, completion, options_.may_ask, rules);
      clock.end(Step::complex);
      if (next == Topology::Next::again) return std::nullopt;
      if (next == Topology::Next::refine) return Attempt(topology_.wanted());
      if (auto outcome = subdivided(slab, classes, completion.complex(), lone, rules, clock)) {
        return outcome;
      }
    }
  }

  [[nodiscard]] static Attempt left_apart(const Slab& slab, const SlabClasses& classes,
                                          LeftApart& apart) {
    RefineHere here;
    for (const SlabRegionId r : apart.regions) {
      const bool upper = classes.regions().is_upper(r);
      const Nesting& nesting = slab.section(upper).nesting;
      for (const ContourId c : nesting.region.ids()) {
        if (nesting.region[c] == classes.regions().in_section(r)) {
          here.contours[upper ? 1 : 0].push_back(c);
        }
      }
    }
    if (is_refined(slab, here)) return Attempt(Unconnectable{std::move(apart.regions)});
    return Attempt(std::move(here));
  }

  // Are all these contours refined already?
  [[nodiscard]] static bool is_refined(const Slab& slab, const RefineHere& here) {
    for (const bool upper : {false, true}) {
      const auto& gabriel = slab.section(upper).gabriel;
      for (const ContourId c : here.contours[upper ? 1 : 0]) {
        if (gabriel.empty() || !gabriel[c]) return false;
      }
    }
    return true;
  }

  // Nothing where a lone class gave up its prism, and is to be completed.
  Attempt subdivided(const Slab& slab, const SlabClasses& classes, const Complex& complex,
                     std::vector<LoneEnd>& lone, RuleCounts& rules, StepClock& clock) {
    count(rules, Rule::detached_sheet, detached_sheets(complex));
    const Subdivision subdivision = subdivide(slab, classes, complex, rules);
    Lifting lifting(slab, subdivision);
    if (!lifting.settle(rules)) return Attempt(Unrepresentable{too_close(id_, lifting.at(), slab)});
    Truncation truncation = truncate(slab, classes, complex, subdivision,
                                     choose_trimmed(slab, classes, complex, subdivision, lifting));
    Embedding embedding(slab, classes, complex, subdivision, lifting, truncation, lone, rules);
    const Embedding::Outcome outcome = embedding.settle();
    work_ += embedding.work();
    clock.end(Step::subdivision);
    add_seconds(seconds_, Step::subdivision, -embedding.contact_seconds());
    add_seconds(seconds_, Step::contact, embedding.contact_seconds());
    if (outcome == Embedding::Outcome::more_truncated) return std::nullopt;
    if (outcome == Embedding::Outcome::failed) {
      return Attempt(Unrepresentable{too_close(id_, embedding.at(), slab)});
    }
    for (const LoneEnd& end : lone) count(rules, Rule::prism, end.is_prism() ? 1 : 0);
    SlabSolid solid;
    solid.vertices = slab.numbering();
    solid.regions = classes.regions();
    const Nodes nodes = solid.nodes();
    // Solids of all slabs wait for the last: none takes more than it needs.
    const std::size_t constructed = embedding.points().size() - nodes.slab_vertices();
    solid.constructed.reserve(constructed);
    solid.origin.reserve(constructed);
    for (const NodeId n : embedding.points().ids()) {
      if (nodes.is_slab_vertex(n)) continue;
      solid.constructed.push_back(embedding.points()[n]);
      solid.origin.push_back(embedding.origin(n));
    }
    solid.pieces = embedding.all_pieces();
    solid.chi = chi_by_class(slab, classes, embedding);
    solid.deviations = deviations(topology_.groups(), classes, solid.chi);
    solid.smallest_lift = embedding.smallest_lift();
    solid.rules = rules;
    return Attempt(std::move(solid));
  }

  // Numbers the nodes as if the sections had no exterior vertices; what all attempts took.
  void finish(SlabSolid& solid) const {
    const IdVector<SlabVertexId, SlabVertexId> original = pits_.original_numbers();
    const Nodes before = solid.nodes();
    solid.vertices = vertices_;
    const Nodes after = solid.nodes();
    for (Piece& piece : solid.pieces) {
      for (NodeId& n : piece.node) {
        if (before.is_constructed(n)) {
          n = after.of(before.constructed(n));
        } else {
          n = Nodes::of(original[Nodes::slab_vertex(n)]);
          TETLOFT_CHECK(n.valid());
        }
      }
    }
    count(solid.rules, Rule::opened_pit, pits_.opened());
    count(solid.rules, Rule::opened_face, pits_.pairs());
    solid.united_voids = topology_.united();
    solid.unrealised = topology_.unrealised();
    solid.seconds = seconds_;
    solid.work = work_;
  }

  SlabId id_;
  const SlabLinks& links_;
  const SlabOptions& options_;
  SlabVertices vertices_;
  Pits pits_;
  Topology topology_;
  // Of all attempts.
  StepSeconds seconds_{};
  std::uint64_t work_ = 0;
};

}  // namespace

SlabSolid build_end(const ConformingSection& section, double z) {
  const bool upper = z < section.z;
  const auto triangles = triangles_by_region(section);
  const auto vertices = vertices_by_region(section);
  const auto numbering = [&](std::size_t n, auto numbers) {
    return upper ? decltype(numbers)(0, n) : decltype(numbers)(n, 0);
  };
  SlabSolid solid;
  solid.vertices = numbering(section.vertex_count(), SlabVertices());
  solid.regions = numbering(section.nesting.outer.size(), SlabRegions());
  for (const RegionId r : triangles.ids()) {
    const PrismNodes prism{solid.vertices, upper, solid.nodes(), CapId(solid.constructed.size())};
    extrude(section, triangles[r], vertices[r], solid.regions.in_slab(upper, r), prism,
            solid.pieces);
    for (const PlaneVertexId v : vertices[r]) {
      const Point2& p = section.point(v);
      solid.constructed.push_back({p.x, p.y, z});
      solid.origin.push_back(PointOrigin::cap);
    }
    count(solid.rules, Rule::prism);
    solid.chi.push_back(2 - static_cast<std::int32_t>(std::count(section.nesting.region.begin(),
                                                                 section.nesting.region.end(), r)));
  }
  return solid;
}

Result<SlabOutcome> build_slab(SlabId id, const ConformingSection& lower,
                               const ConformingSection& upper, const SlabLinks& links,
                               const SlabOptions& options) {
  const double middle = lower.z + 0.5 * (upper.z - lower.z);
  if (!(lower.z < middle && middle < upper.z)) {
    return SlabOutcome(Unrepresentable{
        no_room(id, {0, 0, lower.z}, "no double lies between the two section planes")});
  }
  const bool has_lower = lower.vertex_count() > 0;
  const bool has_upper = upper.vertex_count() > 0;
  if (has_lower && has_upper) return SlabBuilder(id, lower, upper, links, options).run();
  if (has_lower) return SlabOutcome(build_end(lower, middle));
  if (has_upper) return SlabOutcome(build_end(upper, middle));
  return SlabOutcome(SlabSolid{});
}

}  // namespace tetloft::internal

#include "reconstruct/slab_solid.hpp"

#include <algorithm>
#include <string>
#include <utility>

#include "completion/completion.hpp"
#include "completion/handles.hpp"
#include "completion/pits.hpp"
#include "core/guard.hpp"
#include "reconstruct/lattice_hint.hpp"
#include "reconstruct/slab_topology.hpp"
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
// characteristic of its boundary: (V − F / 2) / 2, where triangles alone bound.
IdVector<ClassId, std::int32_t> chi_by_class(const SlabClasses& classes,
                                             const std::vector<Piece>& pieces,
                                             const std::vector<TriangleVertices>& boundary,
                                             std::size_t nodes) {
  IdVector<NodeId, ClassId> of_node(nodes);
  for (const Piece& piece : pieces) {
    const ClassId c = classes.of_region(piece.region);
    for (const NodeId n : piece.node) of_node[n] = c;
  }
  std::vector<std::int64_t> four_chi(classes.class_count(), 0);
  for (const ClassId c : of_node) {
    if (c.valid()) four_chi[c.index()] += 2;
  }
  for (const TriangleVertices& triangle : boundary) {
    --four_chi[of_node[NodeId(triangle[0].value())].index()];
  }
  IdVector<ClassId, std::int32_t> chi;
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
        pits_(lower, upper) {}

  Result<SlabOutcome> run() {
    // Each round but the last opens a pit at least, or gives all of them up.
    for (;;) {
      Result<std::optional<SlabOutcome>> built = attempt();
      if (accepted(built) && !*built) continue;
      const bool solid = built && std::holds_alternative<SlabSolid>(**built);
      if (pits_.opened() > 0 && !solid) {
        pits_.give_up();
        continue;
      }
      if (!built) return built.error();
      if (solid) finish(std::get<SlabSolid>(**built));
      return std::move(**built);
    }
  }

 private:
  // Over the sections of pits_; nothing if these changed, since a pit was sealed.
  Result<std::optional<SlabOutcome>> attempt() {
    StepClock clock(seconds_);
    Result<TetMesh> d =
        slab_delaunay(id_, pits_.lower(), pits_.upper(), options_.engine, options_.work_limit);
    if (!d) return d.error();
    work_ += d->tet_count();
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
      if (!apart.empty()) return std::optional(left_apart(slab, classes, apart.front()));
      const bool sealed = pits_.open_sealed(slab, classes, completion.complex());
      clock.end(Step::complex);
      if (sealed) return std::optional<SlabOutcome>();
      std::optional<SlabOutcome> stuck = make_topology(slab, classes, active, completion, rules);
      clock.end(Step::complex);
      if (stuck) return stuck;
      if (auto outcome = subdivided(slab, classes, completion.complex(), lone, rules, clock)) {
        return outcome;
      }
    }
  }

  [[nodiscard]] static SlabOutcome left_apart(const Slab& slab, const SlabClasses& classes,
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
    if (is_refined(slab, here)) return Unconnectable{std::move(apart.regions)};
    return here;
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

  // Closes passages and fills handles. Nothing where that is done, or voids that nothing parts are
  // taken for one.
  [[nodiscard]] std::optional<SlabOutcome> make_topology(
      const Slab& slab, const SlabClasses& classes, const IdVector<ClassId, std::uint8_t>& active,
      Completion& completion, RuleCounts& rules) {
    united_.clear();
    groups_.clear();
    if (links_.voids == nullptr) return std::nullopt;
    SlabVoids voids(slab.lower(), slab.upper(), *links_.voids);
    if (auto stuck = close_passages(slab, classes, active, voids, completion, rules)) return stuck;
    groups_ = expected_topology(*links_.faces, slab.lower(), slab.upper(),
                                {links_.regions, *links_.voids, united_});
    count(
        rules, Rule::filled_handle,
        fill_handles(slab, classes, active, voids, chi_ranges(slab, classes, active), completion));
    return std::nullopt;
  }

  // Of active classes; what ends in a prism has the topology of its region.
  [[nodiscard]] std::vector<ChiRange> chi_ranges(
      const Slab& slab, const SlabClasses& classes,
      const IdVector<ClassId, std::uint8_t>& active) const {
    std::vector<ChiRange> ranges;
    for (const TopologyGroup& group : groups_) {
      ChiRange range{{}, group.least, group.most};
      for (const SlabRegionId r : group.regions) {
        const ClassId c = classes.of_region(r);
        if (active[c] == 0) {
          const std::int32_t chi = region_chi(slab, classes.regions(), r);
          range.least -= chi;
          range.most -= chi;
        } else if (classes.regions(c).front() == r) {
          range.classes.push_back(c);
        }
      }
      ranges.push_back(std::move(range));
    }
    return ranges;
  }

  [[nodiscard]] static std::int32_t region_chi(const Slab& slab, const SlabRegions& regions,
                                               SlabRegionId r) {
    const auto& of_contour = slab.section(regions.is_upper(r)).nesting.region;
    return 2 - static_cast<std::int32_t>(
                   std::count(of_contour.begin(), of_contour.end(), regions.in_section(r)));
  }

  [[nodiscard]] std::optional<SlabOutcome> close_passages(
      const Slab& slab, const SlabClasses& classes, const IdVector<ClassId, std::uint8_t>& active,
      SlabVoids& voids, Completion& completion, RuleCounts& rules) {
    while (voids.class_count() > 1) {
      Passages passages(slab, classes, active, voids, completion);
      const std::optional<Inseparable> stuck = passages.close();
      count(rules, Rule::closed_passage, passages.closed());
      if (!stuck) return std::nullopt;
      RefineHere here;
      for (const SlabVoidId v : *stuck) add_contours(slab, voids, v, here);
      if (!is_refined(slab, here)) return here;
      count(rules, Rule::united_voids);
      united_.push_back(*stuck);
      voids.unite((*stuck)[0], (*stuck)[1]);
    }
    return std::nullopt;
  }

  // The contours at a void; of an exterior none, they are too many.
  static void add_contours(const Slab& slab, const SlabVoids& voids, SlabVoidId v,
                           RefineHere& here) {
    const ContourId hole = voids.hole(v);
    if (!hole.valid()) return;
    const bool upper = voids.numbering().is_upper(v);
    const Nesting& nesting = slab.section(upper).nesting;
    for (const ContourId c : nesting.parent.ids()) {
      if (c == hole || nesting.parent[c] == hole) here.contours[upper ? 1 : 0].push_back(c);
    }
  }

  // Nothing where a lone class gave up its prism, and is to be completed.
  std::optional<SlabOutcome> subdivided(const Slab& slab, const SlabClasses& classes,
                                        const Complex& complex, std::vector<LoneEnd>& lone,
                                        RuleCounts& rules, StepClock& clock) {
    count(rules, Rule::detached_sheet, detached_sheets(complex));
    const Subdivision subdivision = subdivide(slab, complex, rules);
    Lifting lifting(slab, subdivision);
    if (!lifting.settle(rules)) return Unrepresentable{too_close(id_, lifting.at(), slab)};
    Truncation truncation = truncate(slab, classes, complex, subdivision,
                                     choose_trimmed(slab, classes, complex, subdivision, lifting));
    Embedding embedding(slab, classes, subdivision, lifting, truncation, lone, rules);
    const Embedding::Outcome outcome = embedding.settle();
    work_ += embedding.work();
    clock.end(Step::subdivision);
    add_seconds(seconds_, Step::subdivision, -embedding.contact_seconds());
    add_seconds(seconds_, Step::contact, embedding.contact_seconds());
    if (outcome == Embedding::Outcome::more_truncated) return std::nullopt;
    if (outcome == Embedding::Outcome::failed) {
      return Unrepresentable{too_close(id_, embedding.at(), slab)};
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
    solid.pieces = embedding.pieces();
    solid.deviations = deviations(
        classes,
        chi_by_class(classes, solid.pieces, embedding.boundary(), embedding.points().size()));
    solid.smallest_lift = embedding.smallest_lift();
    solid.rules = rules;
    return solid;
  }

  [[nodiscard]] std::vector<SlabDeviation> deviations(
      const SlabClasses& classes, const IdVector<ClassId, std::int32_t>& chi) const {
    std::vector<SlabDeviation> result;
    for (const TopologyGroup& group : groups_) {
      std::int32_t got = 0;
      for (const SlabRegionId r : group.regions) {
        const ClassId c = classes.of_region(r);
        if (classes.regions(c).front() == r) got += chi[c];
      }
      if (got < group.least || got > group.most) {
        result.push_back({group.regions.front(), group.least, group.most, got});
      }
    }
    return result;
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
    solid.united_voids = united_;
    solid.seconds = seconds_;
    solid.work = work_;
  }

  SlabId id_;
  const SlabLinks& links_;
  const SlabOptions& options_;
  SlabVertices vertices_;
  Pits pits_;
  std::vector<Inseparable> united_;
  std::vector<TopologyGroup> groups_;
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

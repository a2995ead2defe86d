#include "reconstruct/slab_solid.hpp"
#include "reconstruct/lattice_hint.hpp"

#include <algorithm>
#include <optional>
#include <string>
#include <utility>

#include "core/check.hpp"
#include "core/cpu_clock.hpp"
#include "reconstruct/embedding.hpp"
#include "reconstruct/pits.hpp"
#include "reconstruct/trimming.hpp"

namespace tetloft {

namespace {

// What the building of a slab took, with all its attempts.
struct Effort {
  std::array<double, kSteps> seconds{};
  std::uint64_t work = 0;
};

// Adds the time since the last call to a step.
class StepClock {
 public:
  explicit StepClock(std::array<double, kSteps>& seconds) : seconds_(seconds) {}
  void end(Step step) { seconds_[static_cast<std::size_t>(step)] += watch_.lap(); }

 private:
  std::array<double, kSteps>& seconds_;
  WorkStopwatch watch_;
};

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

// Extrudes every region of one section; its vertices are nodes from 0.
void extrude_all(const ConformingSection& section, double z, SlabSolid& solid) {
  const auto triangles = triangles_by_region(section);
  const auto vertices = vertices_by_region(section);
  solid.section_vertices = section.vertex_count();
  for (std::size_t k = 0; k < triangles.size(); ++k) {
    const RegionId r(k);
    extrude(section, triangles[r], vertices[r], SlabRegionId(k), 0,
            solid.section_vertices + solid.constructed.size(), z > section.z, solid.pieces);
    for (const VertexId v : vertices[r]) {
      const Point2& p = section.point(v);
      solid.constructed.push_back({p.x, p.y, z});
      solid.origin.push_back(PointOrigin::cap);
    }
    count(solid.rules, Rule::prism);
  }
}

// The solid over the sections of `pits`; none if these changed, since a pit was sealed.
Result<std::optional<SlabSolid>> build_once(SlabId id, Pits& pits, const std::vector<Link>& links,
                                            DelaunayEngine engine, double work_limit,
                                            Effort& effort) {
  const ConformingSection& lower = pits.lower();
  const ConformingSection& upper = pits.upper();
  SlabSolid solid;
  std::array<double, kSteps>& seconds = effort.seconds;
  StepClock clock(seconds);
  Result<TetMesh> d = slab_delaunay(id, lower, upper, engine, work_limit);
  if (!d) return d.error();
  effort.work += d->tet_count();
  const Slab slab(lower, upper, std::move(d.value()));
  clock.end(Step::delaunay);

  const SlabClasses classes(lower, upper, links);
  IdVector<ClassId, std::uint8_t> active(classes.class_count(), 1);
  if (classes.exterior().valid()) active[classes.exterior()] = 0;
  std::vector<LoneEnd> lone;
  for (std::size_t k = 0; k < classes.class_count(); ++k) {
    const ClassId c(k);
    if (classes.is_lone(c)) lone.push_back({c, classes.regions(c).front(), 0});
  }

  // Each round completes one more lone class at least that has no room for a prism.
  for (;;) {
    for (const LoneEnd& end : lone) active[end.id] = end.is_prism() ? 0 : 1;
    RuleCounts rules{};
    Completion completion(slab, classes, active, seed(slab, classes, active, rules), rules);
    solid.unconnectable = completion.run();
    effort.work += completion.work();
    clock.end(Step::complex);
    if (!solid.unconnectable.empty()) return std::optional(std::move(solid));

    const Complex& complex = completion.complex();
    if (pits.open_sealed(slab, classes, complex)) {
      clock.end(Step::complex);
      return std::optional<SlabSolid>();
    }
    for (std::size_t k = 0; k < complex.kept.size(); ++k) {
      // Kept at an own corner and not attached there.
      if ((complex.kept[TetId(k)] & ~complex.attached[TetId(k)]) != 0) {
        count(rules, Rule::detached_sheet);
      }
    }
    const Subdivision subdivision = subdivide(slab, complex, rules);
    Lifting lifting(slab, subdivision);
    if (!lifting.settle(rules)) return too_close(id, lifting.at(), slab);
    Truncation truncation = truncate(slab, classes, complex, subdivision,
                                     choose_trimmed(slab, classes, complex, subdivision, lifting));
    Embedding embedding(slab, classes, subdivision, lifting, truncation, lone, rules);
    const Embedding::Outcome outcome = embedding.settle();
    effort.work += embedding.work();
    clock.end(Step::subdivision);
    seconds[static_cast<std::size_t>(Step::subdivision)] -= embedding.contact_seconds();
    seconds[static_cast<std::size_t>(Step::contact)] += embedding.contact_seconds();
    if (outcome == Embedding::Outcome::more_truncated) continue;
    if (outcome == Embedding::Outcome::failed) {
      return too_close(id, embedding.at(), slab);
    }

    solid.section_vertices = slab.vertex_count();
    solid.constructed.assign(
        embedding.points().begin() + static_cast<std::ptrdiff_t>(slab.vertex_count()),
        embedding.points().end());
    for (std::size_t k = slab.vertex_count(); k < embedding.points().size(); ++k) {
      solid.origin.push_back(embedding.origin(k));
    }
    solid.pieces = embedding.pieces();
    solid.smallest_lift = embedding.smallest_lift();
    for (const LoneEnd& end : lone) count(rules, Rule::prism, end.is_prism() ? 1 : 0);
    solid.rules = rules;
    return std::optional(std::move(solid));
  }
}

// Numbers the nodes as if the sections had no exterior vertices.
void drop_exterior_vertices(const Pits& pits, SlabSolid& solid) {
  const std::vector<VertexId> original = pits.original_numbers();
  const auto exterior = static_cast<std::size_t>(
      std::count_if(original.begin(), original.end(), [](VertexId v) { return !v.valid(); }));
  solid.section_vertices -= exterior;
  for (Piece& piece : solid.pieces) {
    for (VertexId& v : piece.node) {
      v = v.index() < original.size() ? original[v.index()] : VertexId(v.index() - exterior);
      TETLOFT_CHECK(v.valid());
    }
  }
}

Result<SlabSolid> build_between(SlabId id, const ConformingSection& lower,
                                const ConformingSection& upper, const std::vector<Link>& links,
                                DelaunayEngine engine, double work_limit) {
  Pits pits(lower, upper);
  Effort effort;
  // Each round but the last opens a pit at least, or gives all of them up.
  for (;;) {
    Result<std::optional<SlabSolid>> built =
        build_once(id, pits, links, engine, work_limit, effort);
    if (accepted(built) && !*built) continue;
    if (pits.opened() > 0 && (!built || !(*built)->unconnectable.empty())) {
      pits.give_up();
      continue;
    }
    if (!built) return built.error();
    SlabSolid solid = std::move(**built);
    drop_exterior_vertices(pits, solid);
    count(solid.rules, Rule::opened_pit, pits.opened());
    solid.seconds = effort.seconds;
    solid.work = effort.work;
    return solid;
  }
}

}  // namespace

SlabSolid build_end(const ConformingSection& section, double z) {
  SlabSolid solid;
  extrude_all(section, z, solid);
  return solid;
}

Result<SlabSolid> build_slab_solid(SlabId id, const ConformingSection& lower,
                                   const ConformingSection& upper, const std::vector<Link>& links,
                                   DelaunayEngine engine, double work_limit) {
  const bool has_lower = lower.vertex_count() > 0;
  const bool has_upper = upper.vertex_count() > 0;
  const double middle = lower.z + 0.5 * (upper.z - lower.z);
  if (!(lower.z < middle && middle < upper.z)) {
    return no_room(id, {0, 0, lower.z}, "no double lies between the two section planes");
  }
  if (has_lower && has_upper) return build_between(id, lower, upper, links, engine, work_limit);
  if (has_lower) return build_end(lower, middle);
  if (has_upper) return build_end(upper, middle);
  return SlabSolid{};
}

}  // namespace tetloft

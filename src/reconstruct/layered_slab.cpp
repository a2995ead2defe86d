#include "reconstruct/layered_slab.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include "core/guard.hpp"
#include "core/union_find.hpp"
#include "reconstruct/inner_links.hpp"
#include "reconstruct/layered_voids.hpp"
#include "reconstruct/slab_topology.hpp"
#include "sections/conforming_section.hpp"
#include "sections/face_overlay.hpp"
#include "slab/classes.hpp"
#include "slab/work_limit.hpp"

namespace tetloft::internal {

namespace {

using between::InnerSections;

std::size_t vertex_count(const Section& section) {
  std::size_t vertices = 0;
  for (const Contour& contour : section.contours) vertices += contour.vertices.size();
  return vertices;
}

class LayeredSlab {
 public:
  LayeredSlab(const ConformingSection& lower, const ConformingSection& upper,
              const SlabLinks& links, const InnerSections& inner, const SlabOptions& options)
      : links_(links),
        inner_(inner),
        options_(options),
        classes_(lower, upper, links.regions),
        given_{sections::given_section(lower), sections::given_section(upper)},
        nested_(layers_of({given_[0], lower.nesting}, {given_[1], upper.nesting}, inner)),
        mids_(inner.sections.size()),
        gabriel_(inner.sections.size()),
        solids_(inner.sections.size() + 1) {
    layers_.push_back(&lower);
    for (const ConformingSection& mid : mids_) layers_.push_back(&mid);
    layers_.push_back(&upper);
    options_.may_ask = false;
  }

  /// Conforms the sections between and links them: the links of voids that get lost whatever is
  /// built. Nothing where regions hang together in another way than the links say.
  std::optional<std::size_t> prepare() {
    for (std::size_t k = 0; k < mids_.size(); ++k) {
      if (!conform_layer(k)) return std::nullopt;
    }
    if (!link_layers()) return std::nullopt;
    if (links_.voids == nullptr) return 0;
    voids_.emplace(nested_, *links_.voids);
    auto decided = voids_->decide(region_links_);
    if (!decided) return std::nullopt;
    void_links_ = std::move(*decided);
    const std::optional<RealisedVoids> at_best = voids_->realised(void_links_, {});
    if (!at_best) return std::nullopt;
    return at_best->unrealised.size();
  }

  /// Nothing where there is no solid, or voids hang together that should not.
  std::optional<SlabSolid> build() {
    if (!build_all()) return std::nullopt;
    if (!voids_) return glued();
    std::optional<RealisedVoids> realised = voids_->realised(void_links_, solids_);
    if (!realised) return std::nullopt;
    SlabSolid solid = glued();
    solid.deviations = deviations(expected(*realised), classes_, solid.chi);
    solid.unrealised = std::move(realised->unrealised);
    solid.united_voids = std::move(realised->united);
    return solid;
  }

  /// Adds what building took, whether anything came of it.
  void charge(SlabSolid& solid) const {
    solid.work += work_;
    for (std::size_t s = 0; s < kSteps; ++s) solid.seconds[s] += seconds_[s];
  }

 private:
  [[nodiscard]] const ConformingSection& layer(std::size_t k) const { return *layers_[k]; }
  [[nodiscard]] std::size_t slab_count() const { return solids_.size(); }

  // The class of the slab that a region of a layer belongs to.
  [[nodiscard]] ClassId class_of(std::size_t k, RegionId r) const {
    if (k == 0 || k == slab_count()) {
      return classes_.of_region(classes_.regions().in_slab(k != 0, r));
    }
    return inner_.sections[k - 1].class_of[r];
  }

  [[nodiscard]] bool conform_layer(std::size_t mid) {
    const Section& section = inner_.sections[mid].section;
    Result<ConformingSection> made =
        conform(section, SectionId(0),
                {.gabriel = gabriel_[mid],
                 .most_inserted = most_inserted(options_.work_limit, vertex_count(section))});
    if (!accepted(made)) return false;
    mids_[mid] = std::move(*made);
    return true;
  }

  // Links by slab between layers; false where a class is in several parts, or a region in none.
  [[nodiscard]] bool link_layers() {
    LayerNumbering regions;
    for (const ConformingSection* section : layers_) {
      regions.add_layer(section->nesting.outer.size());
    }
    UnionFind parts(regions.size());
    region_links_ = layer_region_links(inner_);
    for (const SlabId k : region_links_.ids()) {
      for (const Link& link : region_links_[k]) {
        if (class_of(k.index(), link.lower) != class_of(k.index() + 1, link.upper)) return false;
        parts.unite(regions.of(k.index(), link.lower.index()),
                    regions.of(k.index() + 1, link.upper.index()));
      }
    }
    IdVector<ClassId, std::size_t> part(classes_.class_count(), regions.size());
    for (std::size_t k = 0; k < layers_.size(); ++k) {
      for (const RegionId r : layer(k).nesting.outer.ids()) {
        const ClassId c = class_of(k, r);
        if (c.index() >= part.size()) return false;
        std::size_t& of_class = part[c];
        const std::size_t here = parts.find(regions.of(k, r.index()));
        if (of_class == regions.size()) of_class = here;
        if (of_class != here) return false;
      }
    }
    return true;
  }

  // Builds all slabs between, and again those at a section that had to be refined.
  [[nodiscard]] bool build_all() {
    for (std::size_t k = 0; k < slab_count();) {
      if (solids_[k]) {
        ++k;
        continue;
      }
      const SlabId slab(k);
      Result<SlabOutcome> outcome =
          build_slab(slab, layer(k), layer(k + 1),
                     {region_links_[slab], void_links_.empty() ? nullptr : &void_links_[slab],
                      voids_ ? voids_->faces(slab) : nullptr},
                     options_);
      if (!accepted(outcome)) return false;
      if (auto* solid = std::get_if<SlabSolid>(&*outcome)) {
        work_ += solid->work;
        for (std::size_t s = 0; s < kSteps; ++s) seconds_[s] += solid->seconds[s];
        solids_[k++] = std::move(*solid);
        continue;
      }
      const auto* const here = std::get_if<RefineHere>(&*outcome);
      if (here == nullptr || !refine(k, *here)) return false;
      if (k > 0 && !solids_[k - 1]) --k;
    }
    return true;
  }

  // False where nothing new can be refined: given sections are not.
  [[nodiscard]] bool refine(std::size_t slab, const RefineHere& wanted) {
    bool finer = false;
    for (const std::size_t upper : {0U, 1U}) {
      const std::size_t k = slab + upper;
      if (k == 0 || k == slab_count() || wanted.contours[upper].empty()) continue;
      IdVector<ContourId, bool>& gabriel = gabriel_[k - 1];
      const IdVector<ContourId, bool> before = gabriel;
      if (gabriel.empty()) gabriel.assign(layer(k).nesting.region.size(), false);
      for (const ContourId c : wanted.contours[upper]) gabriel[c] = true;
      if (gabriel == before) continue;
      if (!conform_layer(k - 1)) return false;
      solids_[k - 1].reset();
      solids_[k].reset();
      finer = true;
    }
    return finer;
  }

  [[nodiscard]] std::vector<TopologyGroup> expected(const RealisedVoids& voids) const {
    const ConformingSection& lower = layer(0);
    const ConformingSection& upper = layer(slab_count());
    const sections::FaceOverlay faces(given_[0], lower.nesting, given_[1], upper.nesting);
    return expected_topology(faces, lower, upper, {links_.regions, voids.links, voids.united});
  }

  SlabSolid glued() {
    SlabSolid all;
    all.vertices = SlabVertices(layer(0).vertex_count(), layer(slab_count()).vertex_count());
    all.regions = classes_.regions();
    all.sections_between = static_cast<std::uint32_t>(mids_.size());
    all.chi.assign(classes_.class_count(), 0);
    LayerNumbering vertices;  // of the layers between
    for (const ConformingSection& mid : mids_) {
      vertices.add_layer(mid.vertex_count());
      for (const PlaneVertexId v : mid.contour.ids()) {
        all.constructed.push_back(mid.point3(v));
        all.origin.push_back(PointOrigin::inserted);
      }
      work_ += mid.vertex_count();
    }
    for (std::size_t k = 0; k < slab_count(); ++k) {
      add(k, vertices, all);
      solids_[k] = SlabSolid();
    }
    for (std::size_t k = 1; k < slab_count(); ++k) {
      const Nesting& nesting = layer(k).nesting;
      for (const RegionId r : nesting.outer.ids()) {
        all.chi[class_of(k, r)] -= region_chi(nesting, r);
      }
    }
    charge(all);
    return all;
  }

  void add(std::size_t k, const LayerNumbering& vertices, SlabSolid& all) const {
    const SlabSolid& solid = *solids_[k];
    const Nodes in_part = solid.nodes();
    const Nodes nodes = all.nodes();
    const std::size_t first = all.constructed.size();
    const auto node_of = [&](NodeId n) {
      if (in_part.is_constructed(n)) {
        return nodes.of(ConstructedId(first + in_part.constructed(n).index()));
      }
      const SlabVertexId v = Nodes::slab_vertex(n);
      const std::size_t at = k + (solid.vertices.is_upper(v) ? 1 : 0);
      const PlaneVertexId in_layer = solid.vertices.in_section(v);
      if (at == 0 || at == slab_count()) {
        return Nodes::of(all.vertices.in_slab(at != 0, in_layer));
      }
      return nodes.of(ConstructedId(vertices.of(at - 1, in_layer.index())));
    };
    const auto class_in_slab = [&](SlabRegionId r) {
      return class_of(k + (solid.regions.is_upper(r) ? 1 : 0), solid.regions.in_section(r));
    };
    for (const Point3& p : solid.constructed) all.constructed.push_back(p);
    for (const PointOrigin origin : solid.origin) all.origin.push_back(origin);
    all.pieces.reserve(all.pieces.size() + solid.pieces.size());
    for (Piece piece : solid.pieces) {
      for (NodeId& n : piece.node) n = node_of(n);
      piece.region = classes_.regions(class_in_slab(piece.region)).front();
      all.pieces.push_back(piece);
    }
    const SlabClasses of_part(layer(k), layer(k + 1), region_links_[SlabId(k)]);
    for (const ClassId c : solid.chi.ids()) {
      all.chi[class_in_slab(of_part.regions(c).front())] += solid.chi[c];
    }
    for (std::size_t r = 0; r < kRules; ++r) all.rules[r] += solid.rules[r];
    all.smallest_lift = std::min(all.smallest_lift, solid.smallest_lift);
  }

  const SlabLinks& links_;
  const InnerSections& inner_;
  SlabOptions options_;
  SlabClasses classes_;
  std::array<Section, 2> given_;
  Layers nested_;
  std::vector<ConformingSection> mids_;
  std::vector<IdVector<ContourId, bool>> gabriel_;
  std::vector<const ConformingSection*> layers_;
  std::optional<LayeredVoids> voids_;
  IdVector<SlabId, std::vector<Link>> region_links_;
  IdVector<SlabId, std::vector<Link>> void_links_;
  std::vector<std::optional<SlabSolid>> solids_;
  // Of all slabs built.
  StepSeconds seconds_{};
  std::uint64_t work_ = 0;
};

// How far the topology is from what was decided.
std::size_t departure(const SlabSolid& solid) {
  std::size_t sum = solid.unrealised.size() + solid.united_voids.size();
  for (const SlabDeviation& d : solid.deviations) {
    sum += static_cast<std::size_t>(std::max(d.least - d.got, d.got - d.most));
  }
  return sum;
}

}  // namespace

Result<SlabOutcome> build_slab_between(SlabId id, const ConformingSection& lower,
                                       const ConformingSection& upper, const SlabLinks& links,
                                       const between::InnerSections& inner,
                                       const SlabOptions& options) {
  const auto given_up = static_cast<std::uint32_t>(std::max(inner.wanted, inner.sections.size()));
  if (inner.sections.empty()) {
    Result<SlabOutcome> plain = build_slab(id, lower, upper, links, options);
    if (plain && std::holds_alternative<SlabSolid>(*plain)) {
      std::get<SlabSolid>(*plain).sections_given_up = given_up;
    }
    return plain;
  }
  LayeredSlab layers(lower, upper, links, inner, options);
  const std::optional<std::size_t> lost = layers.prepare();
  std::optional<SlabSolid> layered;
  if (lost && *lost == 0) layered = layers.build();
  if (layered && departure(*layered) == 0) return SlabOutcome(std::move(*layered));
  Result<SlabOutcome> plain = build_slab(id, lower, upper, links, options);
  if (!plain) {
    if (layered && is_refusal(plain.error().code)) return SlabOutcome(std::move(*layered));
    return plain;
  }
  auto* const solid = std::get_if<SlabSolid>(&*plain);
  if (lost && *lost != 0 && (solid == nullptr || departure(*solid) >= *lost)) {
    layered = layers.build();
  }
  const bool unbuildable = std::holds_alternative<Unconnectable>(*plain) ||
                           std::holds_alternative<Unrepresentable>(*plain);
  if (layered && (unbuildable || (solid != nullptr && departure(*layered) <= departure(*solid)))) {
    return SlabOutcome(std::move(*layered));
  }
  if (solid != nullptr) {
    solid->sections_given_up = given_up;
    layers.charge(*solid);
  }
  return plain;
}

}  // namespace tetloft::internal

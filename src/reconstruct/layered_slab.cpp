#include "reconstruct/layered_slab.hpp"

#include <algorithm>
#include <cstdlib>
#include <utility>

#include "completion/slab_voids.hpp"
#include "core/guard.hpp"
#include "core/union_find.hpp"
#include "reconstruct/inner_links.hpp"
#include "reconstruct/slab_topology.hpp"
#include "sections/conforming_section.hpp"
#include "sections/face_overlay.hpp"
#include "slab/classes.hpp"
#include "slab/work_limit.hpp"

namespace tetloft::internal {

namespace {

using between::InnerSections;

// Items of all layers, such as regions, in one sequence.
class LayerNumbering {
 public:
  void add_layer(std::size_t items) { first_.push_back(first_.back() + items); }
  [[nodiscard]] std::size_t size() const { return first_.back(); }
  [[nodiscard]] std::size_t of(std::size_t layer, std::size_t item) const {
    return first_[layer] + item;
  }
  [[nodiscard]] std::size_t size(std::size_t layer) const {
    return first_[layer + 1] - first_[layer];
  }

 private:
  std::vector<std::size_t> first_{0};
};

std::size_t vertex_count(const Section& section) {
  std::size_t vertices = 0;
  for (const Contour& contour : section.contours) vertices += contour.vertices.size();
  return vertices;
}

std::int32_t region_chi(const Nesting& nesting, RegionId r) {
  return 2 - static_cast<std::int32_t>(std::count(nesting.region.begin(), nesting.region.end(), r));
}

class LayeredSlab {
 public:
  LayeredSlab(SlabId id, const ConformingSection& lower, const ConformingSection& upper,
              const SlabLinks& links, const InnerSections& inner, const SlabOptions& options)
      : id_(id),
        links_(links),
        inner_(inner),
        options_(options),
        classes_(lower, upper, links.regions),
        mids_(inner.sections.size()),
        gabriel_(inner.sections.size()),
        solids_(inner.sections.size() + 1) {
    layers_.push_back(&lower);
    for (const ConformingSection& mid : mids_) layers_.push_back(&mid);
    layers_.push_back(&upper);
    options_.may_ask = false;
  }

  /// Nothing where the solid is none, or hangs together in another way than the links say.
  std::optional<SlabSolid> build() {
    for (std::size_t k = 0; k < mids_.size(); ++k) {
      if (!conform_layer(k)) return std::nullopt;
    }
    if (!link_layers()) return std::nullopt;
    if (!build_all()) return std::nullopt;
    if (!voids_hang_together()) return std::nullopt;
    return glued();
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
    return decide_voids();
  }

  [[nodiscard]] bool decide_voids() {
    if (links_.voids == nullptr) return true;
    const Section lower = sections::given_section(layer(0));
    const Section upper = sections::given_section(layer(slab_count()));
    auto voids = layer_void_links({lower, layer(0).nesting}, {upper, layer(slab_count()).nesting},
                                  inner_, region_links_);
    if (!voids) return false;
    void_links_ = std::move(*voids);
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
      Result<SlabOutcome> outcome = build_slab(
          slab, layer(k), layer(k + 1),
          {region_links_[slab], void_links_.empty() ? nullptr : &void_links_[slab]}, options_);
      if (!accepted(outcome)) return false;
      if (auto* solid = std::get_if<SlabSolid>(&*outcome)) {
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

  // Do the voids of the slab's sections hang together as its links say, and none without them?
  [[nodiscard]] bool voids_hang_together() const {
    if (links_.voids == nullptr) return true;
    LayerNumbering voids;
    for (const ConformingSection* section : layers_) {
      voids.add_layer(voids_of(*section).hole.size());
    }
    UnionFind got(voids.size());
    for (std::size_t k = 0; k < slab_count(); ++k) {
      const SlabSolid& solid = *solids_[k];
      const SlabVoidNumbering numbering(voids.size(k), voids.size(k + 1));
      const auto in_all = [&](SlabVoidId v) {
        return voids.of(k + (numbering.is_upper(v) ? 1 : 0), numbering.in_section(v).index());
      };
      for (const Link& link : void_links_[SlabId(k)]) {
        if (std::find(solid.unrealised.begin(), solid.unrealised.end(), link) !=
            solid.unrealised.end()) {
          continue;
        }
        got.unite(voids.of(k, link.lower.index()), voids.of(k + 1, link.upper.index()));
      }
      got.unite(voids.of(k, 0), voids.of(k + 1, 0));
      for (const auto& [a, b] : solid.united_voids) got.unite(in_all(a), in_all(b));
    }
    return is_as_linked(voids, got);
  }

  [[nodiscard]] bool is_as_linked(const LayerNumbering& voids, const UnionFind& got) const {
    const std::size_t last = slab_count();
    UnionFind wanted(voids.size());
    wanted.unite(voids.of(0, 0), voids.of(last, 0));
    for (const Link& link : *links_.voids) {
      wanted.unite(voids.of(0, link.lower.index()), voids.of(last, link.upper.index()));
    }
    // By part of what is there, what it is by links.
    std::vector<std::size_t> linked(voids.size(), voids.size());
    std::vector<std::size_t> part(voids.size(), voids.size());
    for (const std::size_t k : {std::size_t{0}, last}) {
      for (std::size_t v = 0; v < voids.size(k); ++v) {
        const std::size_t here = got.find(voids.of(k, v));
        const std::size_t of_class = wanted.find(voids.of(k, v));
        if (linked[here] == voids.size()) linked[here] = of_class;
        if (part[of_class] == voids.size()) part[of_class] = here;
        if (linked[here] != of_class || part[of_class] != here) return false;
      }
    }
    for (std::size_t v = 0; v < voids.size(); ++v) {
      if (linked[got.find(v)] == voids.size()) return false;
    }
    return true;
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
      all.work += mid.vertex_count();
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
    for (std::size_t s = 0; s < kSteps; ++s) all.seconds[s] += solid.seconds[s];
    all.work += solid.work;
    all.smallest_lift = std::min(all.smallest_lift, solid.smallest_lift);
  }

  SlabId id_;
  const SlabLinks& links_;
  const InnerSections& inner_;
  SlabOptions options_;
  SlabClasses classes_;
  std::vector<ConformingSection> mids_;
  std::vector<IdVector<ContourId, bool>> gabriel_;
  std::vector<const ConformingSection*> layers_;  // from below, the slab's sections first and last
  IdVector<SlabId, std::vector<Link>> region_links_;
  IdVector<SlabId, std::vector<Link>> void_links_;
  std::vector<std::optional<SlabSolid>> solids_;
};

// How far the topology is from what was decided.
std::int64_t departure(const SlabSolid& solid) {
  auto sum = static_cast<std::int64_t>(solid.unrealised.size() + solid.united_voids.size());
  for (const SlabDeviation& d : solid.deviations) {
    sum += std::max(d.least - d.got, d.got - d.most);
  }
  return sum;
}

std::vector<SlabDeviation> deviations_of(const SlabSolid& solid, const ConformingSection& lower,
                                         const ConformingSection& upper, const SlabLinks& links) {
  if (links.voids == nullptr) return {};
  const sections::FaceOverlay faces(sections::given_section(lower), lower.nesting,
                                    sections::given_section(upper), upper.nesting);
  return deviations(expected_topology(faces, lower, upper, {links.regions, *links.voids, {}}),
                    SlabClasses(lower, upper, links.regions), solid.chi);
}

}  // namespace

Result<SlabOutcome> build_slab_between(SlabId id, const ConformingSection& lower,
                                       const ConformingSection& upper, const SlabLinks& links,
                                       const between::InnerSections& inner,
                                       const SlabOptions& options) {
  if (inner.sections.empty()) return build_slab(id, lower, upper, links, options);
  std::optional<SlabSolid> layered = LayeredSlab(id, lower, upper, links, inner, options).build();
  if (!layered) return build_slab(id, lower, upper, links, options);
  layered->deviations = deviations_of(*layered, lower, upper, links);
  if (departure(*layered) == 0) return SlabOutcome(std::move(*layered));
  Result<SlabOutcome> plain = build_slab(id, lower, upper, links, options);
  if (!plain || std::holds_alternative<RefineHere>(*plain)) return plain;
  const auto* const solid = std::get_if<SlabSolid>(&*plain);
  if (solid != nullptr && departure(*solid) < departure(*layered)) return plain;
  return SlabOutcome(std::move(*layered));
}

}  // namespace tetloft::internal

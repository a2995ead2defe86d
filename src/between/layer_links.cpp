#include "between/layer_links.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>

#include <tetloft/overlap.hpp>

#include "core/sort_distinct.hpp"
#include "core/union_find.hpp"
#include "spatial/box_tree.hpp"

namespace tetloft::internal::between {

namespace {

// Regions that share less, by the smaller, are not taken for connected.
constexpr double kLeastOverlap = 0.01;

// A layer, be it a given one: its regions, and the classes of those that have one.
struct LinkedLayer {
  IdVector<RegionId, RegionOutline> outline;
  IdVector<RegionId, Box2> box;
  IdVector<RegionId, ClassId> class_of;
  const IdVector<ClassId, std::vector<RegionId>>* region_of;  // by class and node

  LinkedLayer(const Section& section, const Nesting& nesting,
              const IdVector<ClassId, std::vector<RegionId>>& regions)
      : outline(outlines(section, nesting)), class_of(outline.size()), region_of(&regions) {
    for (const RegionOutline& region : outline) {
      Box2 bounds;
      for (const Point2& p : region.contours.front()->vertices) bounds.add(p);
      box.push_back(bounds);
    }
    for (const ClassId c : regions.ids()) {
      for (const RegionId r : regions[c]) class_of[r] = c;
    }
  }
};

void link_graphs(const IdVector<ClassId, LayerGraph>& solids, std::size_t k,
                 const LinkedLayer& below, const LinkedLayer& above,
                 std::vector<LayerLink>& links) {
  for (const ClassId c : solids.ids()) {
    for (const auto& [low, high] : solids[c].edges[k]) {
      links.push_back({(*below.region_of)[c][low], (*above.region_of)[c][high]});
    }
  }
  sort_distinct(links);
}

void link_overlaps(const LinkedLayer& below, const LinkedLayer& above,
                   std::vector<LayerLink>& links) {
  const std::vector<LayerLink> known = links;
  const BoxTree2 tree(above.box.raw());
  for (const RegionId low : below.outline.ids()) {
    tree.query(below.box[low], [&](std::size_t other) {
      const RegionId high(other);
      if (!below.class_of[low].valid() || below.class_of[low] != above.class_of[high]) return;
      if (std::binary_search(known.begin(), known.end(), LayerLink{low, high})) return;
      if (compare_overlap(below.outline[low], above.outline[high], kLeastOverlap) ==
          Sign::positive) {
        links.push_back({low, high});
      }
    });
  }
  sort_distinct(links);
}

// Classes whose regions the links do not all connect.
std::vector<ClassId> classes_apart(const std::vector<LinkedLayer>& layers,
                                   const std::vector<std::vector<LayerLink>>& links,
                                   std::size_t classes) {
  std::vector<std::size_t> first{0};
  for (const LinkedLayer& layer : layers) first.push_back(first.back() + layer.outline.size());
  UnionFind sets(first.back());
  for (std::size_t k = 0; k < links.size(); ++k) {
    for (const auto& [low, high] : links[k]) {
      sets.unite(first[k] + low.index(), first[k + 1] + high.index());
    }
  }
  IdVector<ClassId, std::size_t> set_of(classes, first.back());
  std::vector<ClassId> apart;
  for (std::size_t k = 0; k < layers.size(); ++k) {
    for (const RegionId r : layers[k].class_of.ids()) {
      const ClassId c = layers[k].class_of[r];
      if (!c.valid()) continue;
      const std::size_t set = sets.find(first[k] + r.index());
      if (set_of[c] == first.back()) set_of[c] = set;
      if (set_of[c] != set) apart.push_back(c);
    }
  }
  sort_distinct(apart);
  return apart;
}

}  // namespace

LinkedLayers link_layers(const SlabShape& slab, const std::vector<TracedLayer>& layers,
                         const IdVector<ClassId, LayerGraph>& solids) {
  IdVector<ClassId, std::vector<RegionId>> lower, upper;
  for (const SlabClass& c : slab.classes) {
    lower.push_back(c.lower);
    upper.push_back(c.upper);
  }
  std::vector<LinkedLayer> all;
  all.emplace_back(slab.lower, slab.lower_nesting, lower);
  for (const TracedLayer& layer : layers) {
    all.emplace_back(layer.inner.section, layer.inner.nesting, layer.region_of);
  }
  all.emplace_back(slab.upper, slab.upper_nesting, upper);
  LinkedLayers result;
  for (std::size_t k = 0; k + 1 < all.size(); ++k) {
    std::vector<LayerLink>& links = result.links.emplace_back();
    link_graphs(solids, k, all[k], all[k + 1], links);
    link_overlaps(all[k], all[k + 1], links);
  }
  result.left_apart = classes_apart(all, result.links, slab.classes.size());
  return result;
}

}  // namespace tetloft::internal::between

#include "between/reeb_rule.hpp"

#include <algorithm>
#include <cstdint>
#include <utility>

#include "between/bridges.hpp"
#include "between/given_labels.hpp"
#include "between/joins.hpp"
#include "between/layer_labels.hpp"
#include "between/void_repair.hpp"
#include "core/sort_distinct.hpp"

namespace tetloft::internal::between {

namespace {

// What one round mends another may break: a path joined may shut a void.
constexpr int kRounds = 3;

class ClassRepair {
 public:
  ClassRepair(const SlabFields& fields, ClassId c)
      : fields_(fields),
        shape_(fields.shapes[c]),
        lower_({fields.slab.lower, fields.slab.lower_nesting, fields.slab.classes[c].lower,
                fields.slab.step},
               shape_.window),
        upper_({fields.slab.upper, fields.slab.upper_nesting, fields.slab.classes[c].upper,
                fields.slab.step},
               shape_.window),
        foreign_(fields.shapes, fields.meetings, c) {}

  [[nodiscard]] LayerGraph bridged() {
    ties_ = bridge_parts(repaired(), foreign_, shape_);
    return repaired();
  }

  [[nodiscard]] LayerGraph repaired() {
    for (int round = 0; round < kRounds; ++round) {
      LayerGraph graph = anchored_solids();
      const bool joined = join(graph);
      const bool mended = (joined || encloses_voids(graph)) && repair_all_voids();
      if (!joined && !mended) return graph;
    }
    return anchored_solids();
  }

 private:
  [[nodiscard]] std::size_t last_layer() const { return shape_.value.size() - 1; }

  [[nodiscard]] LayerGraph solids() const {
    std::vector<LayerLabels> layers{lower_.solids()};
    for (std::size_t k = 1; k < last_layer(); ++k) {
      layers.push_back(label_solids(shape_.window, shape_.value[k]));
    }
    layers.push_back(upper_.solids());
    LayerGraph graph = connect_layers(NodeKind::solid, shape_, fields_.slab.at, std::move(layers));
    for (const auto& [below, place] : ties_) {
      const LayerEdge edge{graph.layers[below].node_at(place),
                           graph.layers[below + 1].node_at(place)};
      if (edge.first != kNoNode && edge.second != kNoNode) graph.edges[below].push_back(edge);
    }
    for (std::vector<LayerEdge>& edges : graph.edges) sort_distinct(edges);
    return graph;
  }

  // Without the parts that hang together with no given region.
  [[nodiscard]] LayerGraph anchored_solids() {
    LayerGraph graph = solids();
    const NodeNumbers numbers = connected(graph);
    std::vector<std::size_t> anchors = numbers.front();
    anchors.insert(anchors.end(), numbers.back().begin(), numbers.back().end());
    std::sort(anchors.begin(), anchors.end());
    bool dropped = false;
    for (std::size_t k = 1; k < last_layer(); ++k) {
      std::vector<std::uint8_t> floats;
      for (const std::size_t n : numbers[k]) {
        floats.push_back(std::binary_search(anchors.begin(), anchors.end(), n) ? 0 : 1);
      }
      if (std::find(floats.begin(), floats.end(), 1) == floats.end()) continue;
      dropped = true;
      for (const auto& [first, end, node] : graph.layers[k].runs) {
        if (floats[node] == 0) continue;
        for (std::uint32_t place = first; place < end; ++place) {
          shape_.value[k][place] = -shape_.value[k][place];
        }
      }
    }
    return dropped ? solids() : graph;
  }

  bool join(const LayerGraph& graph) {
    const NodeNumbers below = connected_below(graph);
    const NodeNumbers above = connected_above(graph);
    bool changed = false;
    for (std::size_t k = 1; k < last_layer(); ++k) {
      changed |= join_parts(doubly_connected(graph, below, above, k), foreign_, k, shape_,
                            graph.layers[k]);
    }
    return changed;
  }

  // Between the given layers, which stay as they are.
  [[nodiscard]] static bool encloses_voids(const LayerGraph& solids) {
    return std::any_of(solids.layers.begin() + 1, solids.layers.end() - 1,
                       [](const LayerLabels& layer) { return layer.enclosed > 0; });
  }

  bool repair_all_voids() {
    std::vector<LayerLabels> layers{lower_.voids()};
    for (std::size_t k = 1; k < last_layer(); ++k) {
      layers.push_back(label_voids(shape_.window, shape_.value[k]));
    }
    layers.push_back(upper_.voids());
    const VoidGraph voids = graph_of_voids(shape_, fields_.slab.at, std::move(layers));
    bool changed = false;
    for (std::size_t k = 1; k < last_layer(); ++k) {
      changed |= repair_voids(voids, foreign_, k, shape_);
    }
    return changed;
  }

  const SlabFields& fields_;
  ClassShape& shape_;
  GivenLabels lower_, upper_;
  ForeignSamples foreign_;
  std::vector<LayerTie> ties_;
};

}  // namespace

LayerGraph apply_reeb_rule(const SlabFields& fields, ClassId c, ApartParts parts) {
  ClassRepair repair(fields, c);
  return parts == ApartParts::bridged ? repair.bridged() : repair.repaired();
}

}  // namespace tetloft::internal::between

#include "between/reeb_rule.hpp"

#include <algorithm>
#include <cstdint>
#include <utility>

#include "between/given_labels.hpp"
#include "between/layer_labels.hpp"

namespace tetloft::internal::between {

namespace {

class ClassRepair {
 public:
  ClassRepair(const SlabFields& fields, ClassId c)
      : fields_(fields),
        class_(c),
        shape_(fields.shapes[c]),
        lower_(label_given({fields.slab.lower, fields.slab.lower_nesting,
                            fields.slab.classes[c].lower, fields.slab.step},
                           shape_.window)),
        upper_(label_given({fields.slab.upper, fields.slab.upper_nesting,
                            fields.slab.classes[c].upper, fields.slab.step},
                           shape_.window)) {}

  [[nodiscard]] LayerGraph repaired() { return anchored_solids(); }

 private:
  [[nodiscard]] std::size_t last_layer() const { return shape_.value.size() - 1; }

  [[nodiscard]] LayerGraph solids() const {
    std::vector<LayerLabels> layers{lower_.solids};
    for (std::size_t k = 1; k < last_layer(); ++k) {
      layers.push_back(label_solids(shape_.window, shape_.value[k]));
    }
    layers.push_back(upper_.solids);
    return connect_layers(NodeKind::solid, shape_, fields_.slab.at, std::move(layers));
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
      for (std::uint32_t place = 0; place < shape_.window.size(); ++place) {
        const std::uint32_t node = graph.layers[k].node[place];
        if (node == kNoNode) continue;
        if (std::binary_search(anchors.begin(), anchors.end(), numbers[k][node])) continue;
        shape_.value[k][place] = -shape_.value[k][place];
        dropped = true;
      }
    }
    return dropped ? solids() : graph;
  }

  const SlabFields& fields_;
  ClassId class_;
  ClassShape& shape_;
  GivenLabels lower_, upper_;
};

}  // namespace

LayerGraph apply_reeb_rule(const SlabFields& fields, ClassId c) {
  return ClassRepair(fields, c).repaired();
}

}  // namespace tetloft::internal::between

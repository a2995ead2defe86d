#include "model/touching.hpp"

namespace tetloft::internal {

bool components_touch(const Model& model) {
  if (model.component.empty()) return false;
  IdVector<VertexId, ComponentId> of_point(model.points.size());
  for (const TetId t : model.tets.ids()) {
    for (const VertexId v : model.tets[t]) {
      ComponentId& component = of_point[v];
      if (component.valid() && component != model.component[t]) return true;
      component = model.component[t];
    }
  }
  return false;
}

}  // namespace tetloft::internal

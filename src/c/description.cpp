// What stacks and models are of, and the components of models.
#include <tetloft/model.hpp>

#include "c/handles.hpp"

namespace tetloft::internal::c {

namespace {

void put_description(const Description& about, const char** name, const char** unit,
                     const char** orientation) {
  put(name, about.name.c_str());
  put(unit, about.unit.c_str());
  put(orientation, about.orientation.c_str());
}

}  // namespace

}  // namespace tetloft::internal::c

using namespace tetloft::internal::c;

tetloft_status tetloft_stack_description(const tetloft_stack* stack, const char** name,
                                         const char** unit, const char** orientation) {
  clear(name, unit, orientation);
  return answer(
      [&] { put_description(value_of_handle(stack, "stack")->about, name, unit, orientation); });
}

tetloft_status tetloft_model_description(const tetloft_model* model, const char** name,
                                         const char** unit, const char** orientation) {
  clear(name, unit, orientation);
  return answer([&] {
    put_description(value_of_handle(model, "model")->model.about, name, unit, orientation);
  });
}

tetloft_status tetloft_model_component_name(const tetloft_model* model, size_t component,
                                            tetloft_bytes** name) {
  clear(name);
  return answer([&] {
    const auto value = value_of_handle(model, "model");
    require_output(name, "name");
    require_index(component, value->model.component_count, "component");
    hand_out(name, tetloft::component_name(value->model, tetloft::ComponentId(component)));
  });
}

tetloft_status tetloft_model_component(const tetloft_model* model, size_t component,
                                       tetloft_model** part) {
  clear(part);
  return answer([&] {
    const auto value = value_of_handle(model, "model");
    require_output(part, "part");
    require_index(component, value->model.component_count, "component");
    hand_out(part,
             ModelValue{tetloft::component_of(value->model, tetloft::ComponentId(component)), {}});
  });
}

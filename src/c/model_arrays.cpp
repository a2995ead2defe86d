// What a model holds, as arrays.
#include <tetloft/model.hpp>

#include "c/arrays.hpp"
#include "c/handles.hpp"
#include "model/well_formed.hpp"

namespace tetloft::internal::c {

namespace {

// Answers with one of a model's arrays.
template <class IdType, class T>
tetloft_status array_of_model(const tetloft_model* model, IdVector<IdType, T> Model::*array,
                              const typename Flat<T>::Number** numbers, std::size_t* count) {
  clear(numbers);
  clear(count);
  return answer([&] {
    const auto value = value_of_handle(model, "model");
    put_array((value->model.*array).raw(), numbers, count);
  });
}

}  // namespace

}  // namespace tetloft::internal::c

using namespace tetloft::internal::c;

tetloft_status tetloft_model_points(const tetloft_model* model, const double** xyz,
                                    size_t* points) {
  return array_of_model(model, &tetloft::Model::points, xyz, points);
}

tetloft_status tetloft_model_tets(const tetloft_model* model, const uint32_t** tets,
                                  size_t* count) {
  return array_of_model(model, &tetloft::Model::tets, tets, count);
}

tetloft_status tetloft_model_tet_components(const tetloft_model* model, const uint32_t** component,
                                            size_t* count) {
  return array_of_model(model, &tetloft::Model::component, component, count);
}

tetloft_status tetloft_model_tet_slabs(const tetloft_model* model, const uint32_t** slab,
                                       size_t* count) {
  return array_of_model(model, &tetloft::Model::slab, slab, count);
}

tetloft_status tetloft_model_tet_kinds(const tetloft_model* model, const uint8_t** kind,
                                       size_t* count) {
  return array_of_model(model, &tetloft::Model::kind, kind, count);
}

tetloft_status tetloft_model_point_sections(const tetloft_model* model, const uint32_t** section,
                                            size_t* count) {
  return array_of_model(model, &tetloft::Model::section, section, count);
}

tetloft_status tetloft_model_point_contours(const tetloft_model* model, const uint32_t** contour,
                                            size_t* count) {
  return array_of_model(model, &tetloft::Model::contour, contour, count);
}

tetloft_status tetloft_model_point_origins(const tetloft_model* model, const uint8_t** origin,
                                           size_t* count) {
  return array_of_model(model, &tetloft::Model::origin, origin, count);
}

tetloft_status tetloft_model_component_count(const tetloft_model* model, size_t* components) {
  clear(components);
  return answer([&] {
    const auto value = value_of_handle(model, "model");
    require_output(components, "components");
    *components = value->model.component_count;
  });
}

tetloft_status tetloft_model_volume(const tetloft_model* model, double* volume) {
  clear(volume);
  return answer([&] {
    const auto value = value_of_handle(model, "model");
    require_output(volume, "volume");
    const tetloft::Model& given = value->model;
    require_success(tetloft::internal::check_tets(given.points.size(), given.tets.raw()));
    *volume = tetloft::volume(given);
  });
}

// Models: made, read, written.
#include <tetloft/formats.hpp>
#include <tetloft/model.hpp>

#include "c/arrays.hpp"
#include "c/handles.hpp"
#include "c/options.hpp"

namespace tetloft::internal::c {

namespace {

using WriteModel = Result<std::vector<Warning>> (*)(const std::string&, const Model&,
                                                    const WriteOptions&);
using FormatModel = Result<Formatted> (*)(const Model&, const WriteOptions&);

// The whole model, or its boundary.
tetloft_status write_by(WriteModel write, const tetloft_model* model, const char* path,
                        const tetloft_write_options* options, tetloft_warnings** warnings) {
  clear(warnings);
  return answer([&] {
    const auto value = value_of_handle(model, "model");
    hand_out_warnings(
        warnings, value_of(write(text_of(path, "path"), value->model, write_options_of(options))));
  });
}

tetloft_status format_by(FormatModel format, const tetloft_model* model,
                         const tetloft_write_options* options, tetloft_bytes** bytes,
                         tetloft_warnings** warnings) {
  clear(bytes);
  clear(warnings);
  return answer([&] {
    const auto value = value_of_handle(model, "model");
    require_output(bytes, "bytes");
    Formatted made = value_of(format(value->model, write_options_of(options)));
    hand_out(bytes, std::move(made.bytes), warnings, made.warnings);
  });
}

}  // namespace

}  // namespace tetloft::internal::c

using namespace tetloft::internal::c;

tetloft_status tetloft_model_create(const double* xyz, size_t point_count, const uint32_t* tets,
                                    size_t tet_count, tetloft_model** model) {
  clear(model);
  return answer([&] {
    require_output(model, "model");
    ModelValue made;
    made.model.points =
        tetloft::IdVector<tetloft::VertexId, tetloft::Point3>(space_points(xyz, point_count));
    made.model.tets =
        tetloft::IdVector<tetloft::TetId, tetloft::TetVertices>(tets_of(tets, tet_count));
    hand_out(model, std::move(made));
  });
}

tetloft_status tetloft_model_read(const char* path, const tetloft_read_options* options,
                                  tetloft_model** model, tetloft_warnings** warnings) {
  clear(model);
  clear(warnings);
  return answer([&] {
    require_output(model, "model");
    tetloft::ReadModel read =
        value_of(tetloft::read_model(text_of(path, "path"), read_options_of(options)));
    hand_out(model, ModelValue{std::move(read.model), {}}, warnings, read.warnings);
  });
}

tetloft_status tetloft_model_parse(const void* data, size_t size, const char* name,
                                   const tetloft_read_options* options, tetloft_model** model,
                                   tetloft_warnings** warnings) {
  clear(model);
  clear(warnings);
  return answer([&] {
    require_output(model, "model");
    tetloft::ReadModel read = value_of(tetloft::parse_model(
        bytes_of(data, size), text_of(name, "name"), read_options_of(options)));
    hand_out(model, ModelValue{std::move(read.model), {}}, warnings, read.warnings);
  });
}

tetloft_status tetloft_model_write(const tetloft_model* model, const char* path,
                                   const tetloft_write_options* options,
                                   tetloft_warnings** warnings) {
  return write_by(tetloft::write_model, model, path, options, warnings);
}

tetloft_status tetloft_model_format(const tetloft_model* model,
                                    const tetloft_write_options* options, tetloft_bytes** bytes,
                                    tetloft_warnings** warnings) {
  return format_by(tetloft::format_model, model, options, bytes, warnings);
}

tetloft_status tetloft_model_write_surface(const tetloft_model* model, const char* path,
                                           const tetloft_write_options* options,
                                           tetloft_warnings** warnings) {
  return write_by(tetloft::write_surface, model, path, options, warnings);
}

tetloft_status tetloft_model_format_surface(const tetloft_model* model,
                                            const tetloft_write_options* options,
                                            tetloft_bytes** bytes, tetloft_warnings** warnings) {
  return format_by(tetloft::format_surface, model, options, bytes, warnings);
}

tetloft_status tetloft_model_free(tetloft_model* model) { return free_handle(model); }

// Points from and to files.
#include <tetloft/formats.hpp>

#include "c/arrays.hpp"
#include "c/handles.hpp"
#include "c/options.hpp"

using namespace tetloft::internal::c;

tetloft_status tetloft_points_read(const char* path, const tetloft_read_options* options,
                                   tetloft_points** points, tetloft_warnings** warnings) {
  clear(points);
  clear(warnings);
  return answer([&] {
    require_output(points, "points");
    tetloft::ReadPoints read =
        value_of(tetloft::read_points(text_of(path, "path"), read_options_of(options)));
    hand_out(points, std::move(read.points), warnings, read.warnings);
  });
}

tetloft_status tetloft_points_parse(const void* data, size_t size, const char* name,
                                    const tetloft_read_options* options, tetloft_points** points,
                                    tetloft_warnings** warnings) {
  clear(points);
  clear(warnings);
  return answer([&] {
    require_output(points, "points");
    tetloft::ReadPoints read = value_of(tetloft::parse_points(
        bytes_of(data, size), text_of(name, "name"), read_options_of(options)));
    hand_out(points, std::move(read.points), warnings, read.warnings);
  });
}

tetloft_status tetloft_points_data(const tetloft_points* points, const double** xyz,
                                   size_t* count) {
  clear(xyz);
  clear(count);
  return answer([&] { put_array(*value_of_handle(points, "points"), xyz, count); });
}

tetloft_status tetloft_points_free(tetloft_points* points) { return free_handle(points); }

tetloft_status tetloft_points_write(const double* xyz, size_t point_count, const char* path,
                                    const tetloft_write_options* options,
                                    tetloft_warnings** warnings) {
  clear(warnings);
  return answer([&] {
    const tetloft::WriteOptions how = write_options_of(options);
    hand_out_warnings(warnings, value_of(tetloft::write_points(
                                    text_of(path, "path"), space_points(xyz, point_count), how)));
  });
}

tetloft_status tetloft_points_format(const double* xyz, size_t point_count,
                                     const tetloft_write_options* options, tetloft_bytes** bytes,
                                     tetloft_warnings** warnings) {
  clear(bytes);
  clear(warnings);
  return answer([&] {
    require_output(bytes, "bytes");
    const tetloft::WriteOptions how = write_options_of(options);
    tetloft::Formatted made = value_of(tetloft::format_points(space_points(xyz, point_count), how));
    hand_out(bytes, std::move(made.bytes), warnings, made.warnings);
  });
}

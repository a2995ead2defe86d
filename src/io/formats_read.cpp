// Reading files of whichever format.
#include <string>

#include <tetloft/formats.hpp>

#include "core/guard.hpp"
#include "io/arguments.hpp"
#include "io/files.hpp"
#include "io/formats.hpp"
#include "io/output_place.hpp"

namespace tetloft {

using namespace internal;

namespace {

template <class Out>
using Reader = Result<Out> (*io::Format::*)(const io::Source&, const ReadOptions&);

template <class Out>
Result<Out> parse_source(Contents contents, Reader<Out> reader, const io::Source& source,
                         const ReadOptions& options) {
  if (Result<void> known = io::check_validity(options.validity); !known) return known.error();
  const Result<const io::Format*> format =
      io::choose_reader(io::format_table(), contents, source, options.format);
  if (!format) return format.error();
  return ((*format)->*reader)(source, options);
}

template <class Out>
Result<Out> parse_bytes(Contents contents, Reader<Out> reader, std::string_view bytes,
                        const std::string& name, const ReadOptions& options) {
  return guard_internal([&] { return parse_source(contents, reader, {bytes, name, {}}, options); });
}

template <class Out>
Result<Out> read_path(Contents contents, Reader<Out> reader, const std::string& path,
                      const ReadOptions& options) {
  return guard_internal([&]() -> Result<Out> {
    const Result<std::string> bytes = io::read_file(path);
    if (!bytes) return bytes.error();
    return parse_source(contents, reader, {*bytes, path, io::folder_of(path)}, options);
  });
}

// Of the functions of io.hpp, each for one format.
ReadOptions reading(const char* format, Validity validity = Validity::required) {
  return {validity, format};
}

Result<Model> without_warnings(Result<ReadModel> read) {
  return guard_internal([&]() -> Result<Model> {
    if (!read) return read.error();
    return std::move(read->model);
  });
}

}  // namespace

Result<ReadStack> read_stack(const std::string& path, const ReadOptions& options) {
  return read_path(Contents::stack, &io::Format::read_stack, path, options);
}
Result<ReadStack> parse_stack(std::string_view bytes, const std::string& name,
                              const ReadOptions& options) {
  return parse_bytes(Contents::stack, &io::Format::read_stack, bytes, name, options);
}
Result<ReadStack> read_cnt(const std::string& path, Validity validity) {
  return read_stack(path, reading("cnt", validity));
}
Result<ReadStack> parse_cnt(std::string_view text, const std::string& name, Validity validity) {
  return parse_stack(text, name, reading("cnt", validity));
}

Result<ReadModel> read_model(const std::string& path, const ReadOptions& options) {
  return read_path(Contents::model, &io::Format::read_model, path, options);
}
Result<ReadModel> parse_model(std::string_view bytes, const std::string& name,
                              const ReadOptions& options) {
  return parse_bytes(Contents::model, &io::Format::read_model, bytes, name, options);
}
Result<Model> read_vtu(const std::string& path) {
  return without_warnings(read_model(path, reading("vtu")));
}
Result<Model> parse_vtu(std::string_view bytes, const std::string& name) {
  return without_warnings(parse_model(bytes, name, reading("vtu")));
}

Result<ReadPoints> read_points(const std::string& path, const ReadOptions& options) {
  return read_path(Contents::points, &io::Format::read_points, path, options);
}
Result<ReadPoints> parse_points(std::string_view bytes, const std::string& name,
                                const ReadOptions& options) {
  return parse_bytes(Contents::points, &io::Format::read_points, bytes, name, options);
}

Result<Labels> read_labels(const std::string& path) {
  return read_path(Contents::labels, &io::Format::read_labels, path, reading("labels"));
}
Result<Labels> parse_labels(std::string_view text, const std::string& name) {
  return parse_bytes(Contents::labels, &io::Format::read_labels, text, name, reading("labels"));
}

}  // namespace tetloft

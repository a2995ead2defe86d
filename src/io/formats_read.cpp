// Reading files of whichever format.
#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>
#include <string>

#include <tetloft/formats.hpp>
#include <tetloft/inspect.hpp>

#include "core/enums.hpp"
#include "core/guard.hpp"
#include "core/option_rules.hpp"
#include "io/arguments.hpp"
#include "io/bytes/byte_source.hpp"
#include "io/drawing/stack_of_drawing.hpp"
#include "io/files.hpp"
#include "io/formats.hpp"
#include "io/output_place.hpp"
#include "io/summary.hpp"
#include "io/volume/stack_of_volume.hpp"
#include "sections/validation.hpp"

namespace tetloft {

using namespace internal;

namespace {

/// Reads one thing by the format that was chosen.
template <class Out>
using Reader = Result<Out> (*)(const io::Format&, const io::Source&, const ReadOptions&);

Result<io::StackOfFile> file_stack_by(const io::Format& format, const io::Source& source,
                                      const ReadOptions& options) {
  if (format.read_stack != nullptr) return format.read_stack(source, options);
  if (format.read_drawing != nullptr) {
    Result<io::Drawing> drawing = format.read_drawing(source, options);
    if (!drawing) return drawing.error();
    return io::stack_of_drawing(*std::move(drawing), source.name, options);
  }
  Result<std::unique_ptr<io::Volume>> volume = format.open_volume(source, options);
  if (!volume) return volume.error();
  return io::stack_of_volume(**volume, source.name, options);
}
Result<ReadStack> stack_by(const io::Format& format, const io::Source& source,
                           const ReadOptions& options) {
  Result<io::StackOfFile> file = file_stack_by(format, source, options);
  if (!file) return file.error();
  return std::move(file->read);
}
Result<ReadValidStack> valid_stack_by(const io::Format& format, const io::Source& source,
                                      const ReadOptions& options) {
  ReadOptions required = options;
  required.validity = Validity::required;
  Result<io::StackOfFile> file = file_stack_by(format, source, required);
  if (!file) return file.error();
  ReadStack& read = file->read;
  return ReadValidStack{
      sections::ValidStackMaker::make(std::move(read.stack), std::move(file->nestings)),
      std::move(read.warnings), std::move(read.lines), std::move(read.labels)};
}
Result<FileSummary> summary_by(const io::Format& format, const io::Source& source,
                               const ReadOptions& options) {
  Result<FileSummary> summary = io::summary_of(format, source, options);
  if (summary) summary->format = format.name;
  return summary;
}
Result<ReadModel> model_by(const io::Format& format, const io::Source& source,
                           const ReadOptions& options) {
  return format.read_model(source, options);
}
Result<ReadPoints> points_by(const io::Format& format, const io::Source& source,
                             const ReadOptions& options) {
  return format.read_points(source, options);
}
Result<ReadTriangles> triangles_by(const io::Format& format, const io::Source& source,
                                   const ReadOptions& options) {
  Result<ReadTriangles> read = format.read_triangles(source, options);
  if (!read || !read->mesh.triangles.empty()) return read;
  Error error{ErrorCode::invalid_input, "the file has no triangles", {}};
  error.where.file = source.name;
  return error;
}
Result<Labels> labels_by(const io::Format& format, const io::Source& source,
                         const ReadOptions& options) {
  return format.read_labels(source, options);
}

Result<void> check_options(const ReadOptions& options) {
  const auto wrong = [](const char* what) { return Error{ErrorCode::usage, what, {}}; };
  if (Result<void> known = io::check_validity(options.validity); !known) return known;
  if (!is_enumerator(options.contours, VolumeContours::lattice)) {
    return wrong("there is no such way of contours: sub_pixel or lattice");
  }
  if (options.axis && (*options.axis < 0 || *options.axis > 2)) {
    return wrong("the axis of slices is 0, 1 or 2");
  }
  if (options.iso && !std::isfinite(*options.iso)) return wrong("the iso-value is not finite");
  if (options.plane_tolerance && !is_length(*options.plane_tolerance)) {
    return wrong("the tolerance of planes is not above 0");
  }
  return {};
}

template <class Out>
Result<Out> parse_source(Contents contents, Reader<Out> reader, io::Source source,
                         const ReadOptions& options) {
  if (Result<void> known = check_options(options); !known) return known.error();
  const Result<const io::Format*> format =
      io::choose_reader(io::format_table(), contents, source, options.format);
  if (!format) return format.error();
  const io::MemoryBytes bytes(source.bytes);
  if (source.whole == nullptr) source.whole = &bytes;
  return reader(**format, source, options);
}

template <class Out>
Result<Out> parse_bytes(Contents contents, Reader<Out> reader, std::string_view bytes,
                        const std::string& name, const ReadOptions& options) {
  return guard_internal([&] { return parse_source(contents, reader, {bytes, name, {}}, options); });
}

constexpr std::size_t kFirstBytes = std::size_t{1} << 16;

Result<std::string> beginning_of(const io::ByteSource& file) {
  std::string beginning(static_cast<std::size_t>(std::min<std::uint64_t>(kFirstBytes, file.size())),
                        '\0');
  const Result<std::size_t> got = file.read_at(0, beginning);
  if (!got) return got.error();
  beginning.resize(*got);
  return beginning;
}

// A volume is read slice by slice from its file; what its beginning tells to be anything else, as a
// whole.
template <class Out>
Result<std::optional<Out>> read_volume(Contents contents, Reader<Out> reader,
                                       const std::string& path, const ReadOptions& options) {
  const Result<std::unique_ptr<io::ByteSource>> file = io::open_bytes(path);
  if (!file) return file.error();
  if (*file == nullptr || (*file)->size() <= kFirstBytes) return std::optional<Out>();
  const Result<std::string> beginning = beginning_of(**file);
  if (!beginning) return beginning.error();
  const io::Source source{*beginning, path, io::folder_of(path), file->get()};
  const Result<const io::Format*> format =
      io::choose_reader(io::format_table(), contents, source, options.format);
  if (!format || (*format)->open_volume == nullptr) return std::optional<Out>();
  Result<Out> read = reader(**format, source, options);
  if (!read) return read.error();
  return std::optional<Out>(*std::move(read));
}

template <class Out>
Result<Out> read_path(Contents contents, Reader<Out> reader, const std::string& path,
                      const ReadOptions& options) {
  return guard_internal([&]() -> Result<Out> {
    if (Result<void> known = check_options(options); !known) return known.error();
    if (contents == Contents::stack) {
      Result<std::optional<Out>> volume = read_volume(contents, reader, path, options);
      if (!volume) return volume.error();
      if (volume->has_value()) return **std::move(volume);
    }
    const Result<std::string> bytes = io::read_file(path);
    if (!bytes) return bytes.error();
    return parse_source(contents, reader, {*bytes, path, io::folder_of(path)}, options);
  });
}

// Of a stack that was read; each section is handed over, and gone then.
class SectionsRead final : public SectionStream {
 public:
  SectionsRead(ReadStack read, std::string name) : read_(std::move(read)), name_(std::move(name)) {}

  [[nodiscard]] Result<std::optional<Section>> next() override {
    if (next_ == read_.stack.sections.size()) return std::optional<Section>();
    return std::optional(std::move(read_.stack.sections[SectionId(next_++)]));
  }
  [[nodiscard]] Frame frame() const override { return read_.stack.frame; }
  [[nodiscard]] Description about() const override { return read_.stack.about; }
  [[nodiscard]] Place located(Place where) override {
    where.file = name_;
    if (where.line || !where.section || *where.section >= read_.lines.size()) return where;
    const auto& lines = read_.lines[SectionId(*where.section)];
    if (where.contour && *where.contour < lines.size()) {
      const std::size_t line = lines[ContourId(*where.contour)];
      if (line != 0) where.line = line;
    }
    return where;
  }

 private:
  ReadStack read_;
  std::string name_;
  std::size_t next_ = 0;
};

Result<std::optional<OpenedSections>> open_file_sections(const std::string& path,
                                                         const ReadOptions& options) {
  using Opened = std::optional<OpenedSections>;
  Result<std::unique_ptr<io::ByteSource>> file = io::open_bytes(path);
  if (!file) return file.error();
  if (*file == nullptr) return Opened();
  const Result<std::string> beginning = beginning_of(**file);
  if (!beginning) return beginning.error();
  const io::Source source{*beginning, path, {}, file->get()};
  const io::Format* const format =
      io::choose_by_section(io::format_table(), source, options.format);
  return format == nullptr ? Opened() : format->open_sections(*file, path, options);
}

Result<OpenedSections> open_whole(const std::string& path, const ReadOptions& options) {
  Result<ReadStack> read = read_stack(path, options);
  if (!read) return read.error();
  OpenedSections opened;
  opened.count = read->stack.sections.size();
  opened.warnings = std::move(read->warnings);
  opened.labels = std::move(read->labels);
  opened.in_memory = true;
  opened.sections = std::make_unique<SectionsRead>(*std::move(read), path);
  return opened;
}

// Of the functions of io.hpp, each for one format.
ReadOptions reading(const char* format, Validity validity = Validity::required) {
  ReadOptions options;
  options.validity = validity;
  options.format = format;
  return options;
}

Result<Model> without_warnings(Result<ReadModel> read) {
  return guard_internal([&]() -> Result<Model> {
    if (!read) return read.error();
    return std::move(read->model);
  });
}

}  // namespace

Result<ReadStack> read_stack(const std::string& path, const ReadOptions& options) {
  return read_path(Contents::stack, stack_by, path, options);
}
Result<ReadStack> parse_stack(std::string_view bytes, const std::string& name,
                              const ReadOptions& options) {
  return parse_bytes(Contents::stack, stack_by, bytes, name, options);
}
Result<ReadValidStack> read_valid_stack(const std::string& path, const ReadOptions& options) {
  return read_path(Contents::stack, valid_stack_by, path, options);
}
Result<ReadValidStack> parse_valid_stack(std::string_view bytes, const std::string& name,
                                         const ReadOptions& options) {
  return parse_bytes(Contents::stack, valid_stack_by, bytes, name, options);
}
Result<OpenedSections> open_sections(const std::string& path, const ReadOptions& options) {
  return guard_internal([&]() -> Result<OpenedSections> {
    if (Result<void> known = check_options(options); !known) return known.error();
    Result<std::optional<OpenedSections>> opened = open_file_sections(path, options);
    if (!opened) return opened.error();
    if (opened->has_value()) return **std::move(opened);
    return open_whole(path, options);
  });
}
Result<FileSummary> inspect(const std::string& path, const ReadOptions& options) {
  return read_path(Contents::stack, summary_by, path, options);
}
Result<FileSummary> inspect_bytes(std::string_view bytes, const std::string& name,
                                  const ReadOptions& options) {
  return parse_bytes(Contents::stack, summary_by, bytes, name, options);
}
Result<ReadStack> read_cnt(const std::string& path, Validity validity) {
  return read_stack(path, reading("cnt", validity));
}
Result<ReadStack> parse_cnt(std::string_view text, const std::string& name, Validity validity) {
  return parse_stack(text, name, reading("cnt", validity));
}

Result<ReadModel> read_model(const std::string& path, const ReadOptions& options) {
  return read_path(Contents::model, model_by, path, options);
}
Result<ReadModel> parse_model(std::string_view bytes, const std::string& name,
                              const ReadOptions& options) {
  return parse_bytes(Contents::model, model_by, bytes, name, options);
}
Result<Model> read_vtu(const std::string& path) {
  return without_warnings(read_model(path, reading("vtu")));
}
Result<Model> parse_vtu(std::string_view bytes, const std::string& name) {
  return without_warnings(parse_model(bytes, name, reading("vtu")));
}

Result<ReadPoints> read_points(const std::string& path, const ReadOptions& options) {
  return read_path(Contents::points, points_by, path, options);
}
Result<ReadPoints> parse_points(std::string_view bytes, const std::string& name,
                                const ReadOptions& options) {
  return parse_bytes(Contents::points, points_by, bytes, name, options);
}

Result<ReadTriangles> read_triangles(const std::string& path, const ReadOptions& options) {
  return read_path(Contents::surface, triangles_by, path, options);
}
Result<ReadTriangles> parse_triangles(std::string_view bytes, const std::string& name,
                                      const ReadOptions& options) {
  return parse_bytes(Contents::surface, triangles_by, bytes, name, options);
}

Result<Labels> read_labels(const std::string& path) {
  return read_path(Contents::labels, labels_by, path, reading("labels"));
}
Result<Labels> parse_labels(std::string_view text, const std::string& name) {
  return parse_bytes(Contents::labels, labels_by, text, name, reading("labels"));
}

}  // namespace tetloft

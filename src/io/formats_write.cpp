// Writing files of whichever format, and their bytes.
#include <cmath>
#include <functional>
#include <string>
#include <utility>

#include <tetloft/formats.hpp>

#include "core/guard.hpp"
#include "io/arguments.hpp"
#include "io/formats.hpp"
#include "io/stage.hpp"
#include "io/vtu_piece.hpp"
#include "model/well_formed.hpp"

namespace tetloft {

using namespace internal;

namespace {

using io::Format;
using io::Sink;
using io::Target;
using io::Written;

/// Writes one value by the format that was chosen.
using Body = std::function<Written(const Format&, Sink&, const Target&)>;

// What a writer tells gets the file's name.
Written told_of(const std::string& file, Written written) {
  if (!written) return io::at_file(file, written.error());
  for (Warning& warning : *written) {
    if (warning.where.file.empty()) warning.where.file = file;
  }
  return written;
}

// The format is chosen, and the encoding checked.
Written write_to(Sink& sink, Contents contents, const Target& target, const Body& body) {
  const Result<const Format*> format =
      io::choose_writer(io::format_table(), contents, target.name, target.options.format);
  if (!format) return format.error();
  Result<void> known = io::check_encoding(target.options.encoding);
  if (!known) return known.error();
  return told_of(target.name, body(**format, sink, target));
}

Result<io::Staged> stage_as(Contents contents, const std::string& path, const WriteOptions& options,
                            io::TemporaryWatcher* watcher, const Body& body) {
  return guard_internal([&] {
    return io::stage(path, watcher, [&](Sink& sink) {
      return write_to(sink, contents, {path, options}, body);
    });
  });
}

Result<Formatted> format_as(Contents contents, const WriteOptions& options, const Body& body) {
  return guard_internal([&]() -> Result<Formatted> {
    io::StringSink sink;
    Written warnings = write_to(sink, contents, {{}, options}, body);
    if (!warnings) return warnings.error();
    return Formatted{sink.take(), *std::move(warnings)};
  });
}

Body stack_body(const SectionStack& stack) {
  return [&stack](const Format& format, Sink& sink, const Target& target) {
    return format.write_stack(sink, stack, target);
  };
}

/// Writes a model as it lies in its file.
using ModelWriter = Written (*)(Sink&, const Model&, const Target&);

Written write_placed(Sink& sink, const Model& model, const Target& target, ModelWriter write) {
  if (Result<void> formed = check_well_formed(model); !formed) return formed.error();
  if (model.frame == Frame{}) return write(sink, model, target);
  Model placed = model;
  for (Point3& p : placed.points) {
    p = place(model.frame, p);
    if (std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z)) continue;
    return Error{
        ErrorCode::unrepresentable, "the frame places a vertex where no doubles reach", {}};
  }
  Target told = target;
  told.stack_points = &model.points;
  return write(sink, placed, told);
}

bool has_companions(const Format& format) { return format.companions.front().write != nullptr; }

// Where there is but one file, there is no place for companions.
Body model_body(const Model& model) {
  return [&model](const Format& format, Sink& sink, const Target& target) -> Written {
    if (has_companions(format) && io::companion_paths(format, target.name).empty()) {
      return Error{ErrorCode::usage,
                   "a model of format " + std::string(format.name) +
                       " is several files: it needs a name that ends in " +
                       std::string(format.extensions.front()),
                   {}};
    }
    return write_placed(sink, model, target, format.write_model);
  };
}

// The files beside one that was staged, with what their writers tell.
Result<void> stage_companions(io::Staged& staged, const Model& model, const std::string& path,
                              const WriteOptions& options, io::TemporaryWatcher* watcher) {
  const Result<const Format*> format =
      io::choose_writer(io::format_table(), Contents::model, path, options.format);
  if (!format) return format.error();
  const std::vector<std::string> paths = io::companion_paths(**format, path);
  for (std::size_t k = 0; k < paths.size(); ++k) {
    Result<io::Staged> beside = io::stage(paths[k], watcher, [&](Sink& sink) {
      return told_of(
          paths[k], write_placed(sink, model, {paths[k], options}, (*format)->companions[k].write));
    });
    if (!beside) return beside.error();
    staged.files.push_back(std::move(beside->files.front()));
    staged.warnings.insert(staged.warnings.end(), beside->warnings.begin(), beside->warnings.end());
  }
  return {};
}

Body surface_body(const Model& model) {
  return [&model](const Format& format, Sink& sink, const Target& target) -> Written {
    if (Result<void> formed = check_well_formed(model); !formed) return formed.error();
    return format.write_surface(sink, io::surface_mesh(model), model, target);
  };
}

Body points_body(const std::vector<Point3>& points) {
  return [&points](const Format& format, Sink& sink, const Target& target) {
    return format.write_points(sink, points, target);
  };
}

Body labels_body(const Labels& labels) {
  return [&labels](const Format& format, Sink& sink, const Target& target) {
    return format.write_labels(sink, labels, target);
  };
}

Body lines_body(const LineSet& lines) {
  return [&lines](const Format& format, Sink& sink, const Target& target) {
    return format.write_lines(sink, lines, target);
  };
}

// Of the functions of io.hpp, each for one format: what they ask for, and what they return.
WriteOptions writing(const char* format, Encoding encoding = Encoding::binary) {
  return {encoding, format};
}

Result<void> without_warnings(const Written& written) {
  return guard_internal([&]() -> Result<void> {
    if (!written) return written.error();
    return {};
  });
}

Result<std::string> bytes_of(Result<Formatted> formatted) {
  return guard_internal([&]() -> Result<std::string> {
    if (!formatted) return formatted.error();
    return std::move(formatted->bytes);
  });
}

}  // namespace

Result<io::Staged> io::stage_stack(const std::string& path, const SectionStack& stack,
                                   const WriteOptions& options, TemporaryWatcher* watcher) {
  return stage_as(Contents::stack, path, options, watcher, stack_body(stack));
}
Result<io::Staged> io::stage_model(const std::string& path, const Model& model,
                                   const WriteOptions& options, TemporaryWatcher* watcher) {
  return guard_internal([&] {
    Result<Staged> staged = stage_as(Contents::model, path, options, watcher, model_body(model));
    if (!staged) return staged;
    Result<void> beside = stage_companions(*staged, model, path, options, watcher);
    return beside ? std::move(staged) : Result<Staged>(beside.error());
  });
}
Result<io::Staged> io::stage_piece(const std::string& path, const Model& model,
                                   std::string_view bytes, Encoding encoding,
                                   TemporaryWatcher* watcher) {
  const Body body = model_body(model);
  return stage_as(Contents::model, path, writing("vtu", encoding), watcher,
                  [&](const Format& format, Sink& sink, const Target& target) {
                    Target with_bytes = target;
                    with_bytes.piece = bytes;
                    return body(format, sink, with_bytes);
                  });
}
Result<io::Staged> io::stage_surface(const std::string& path, const Model& model,
                                     const WriteOptions& options, TemporaryWatcher* watcher) {
  return stage_as(Contents::surface, path, options, watcher, surface_body(model));
}
Result<io::Staged> io::stage_lines(const std::string& path, const LineSet& lines,
                                   const WriteOptions& options, TemporaryWatcher* watcher) {
  return stage_as(Contents::lines, path, options, watcher, lines_body(lines));
}
Result<io::Staged> io::stage_file(const std::string& path, std::string_view bytes,
                                  TemporaryWatcher* watcher) {
  return guard_internal([&] {
    return stage(path, watcher, [bytes](Sink& sink) {
      sink.append(bytes);
      return std::vector<Warning>();
    });
  });
}

Result<std::vector<Warning>> write_stack(const std::string& path, const SectionStack& stack,
                                         const WriteOptions& options) {
  return io::committed(io::stage_stack(path, stack, options));
}
Result<Formatted> format_stack(const SectionStack& stack, const WriteOptions& options) {
  return format_as(Contents::stack, options, stack_body(stack));
}
Result<void> write_cnt(const std::string& path, const SectionStack& stack) {
  return without_warnings(write_stack(path, stack, writing("cnt")));
}
Result<std::string> format_cnt(const SectionStack& stack) {
  return bytes_of(format_stack(stack, writing("cnt")));
}

Result<std::vector<Warning>> write_model(const std::string& path, const Model& model,
                                         const WriteOptions& options) {
  return io::committed(io::stage_model(path, model, options));
}
Result<Formatted> format_model(const Model& model, const WriteOptions& options) {
  return format_as(Contents::model, options, model_body(model));
}
Result<void> write_vtu(const std::string& path, const Model& model, Encoding encoding) {
  return without_warnings(write_model(path, model, writing("vtu", encoding)));
}
Result<std::string> format_vtu(const Model& model, Encoding encoding) {
  return bytes_of(format_model(model, writing("vtu", encoding)));
}

Result<std::vector<Warning>> write_surface(const std::string& path, const Model& model,
                                           const WriteOptions& options) {
  return io::committed(io::stage_surface(path, model, options));
}
Result<std::vector<Warning>> write_surface(const std::string& path, const Model& model,
                                           Encoding encoding) {
  return write_surface(path, model, WriteOptions{encoding, {}});
}
Result<Formatted> format_surface(const Model& model, const WriteOptions& options) {
  return format_as(Contents::surface, options, surface_body(model));
}

Result<std::vector<Warning>> write_points(const std::string& path,
                                          const std::vector<Point3>& points,
                                          const WriteOptions& options) {
  return io::committed(stage_as(Contents::points, path, options, nullptr, points_body(points)));
}
Result<Formatted> format_points(const std::vector<Point3>& points, const WriteOptions& options) {
  return format_as(Contents::points, options, points_body(points));
}

Result<void> write_labels(const std::string& path, const Labels& labels) {
  return without_warnings(io::committed(
      stage_as(Contents::labels, path, writing("labels"), nullptr, labels_body(labels))));
}
Result<std::string> format_labels(const Labels& labels) {
  return bytes_of(format_as(Contents::labels, writing("labels"), labels_body(labels)));
}

Result<void> write_lines(const std::string& path, const LineSet& lines, Encoding encoding) {
  return without_warnings(io::committed(io::stage_lines(path, lines, writing("vtp", encoding))));
}
Result<std::string> format_lines(const LineSet& lines, Encoding encoding) {
  return bytes_of(format_as(Contents::lines, writing("vtp", encoding), lines_body(lines)));
}

Result<void> write_file(const std::string& path, std::string_view bytes) {
  return without_warnings(io::committed(io::stage_file(path, bytes)));
}

}  // namespace tetloft

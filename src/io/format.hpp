// A format: one value, defined in a file of its own and listed in the table of formats.cpp.
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <tetloft/formats.hpp>
#include <tetloft/result.hpp>

#include "io/bytes/byte_source.hpp"
#include "io/drawing/drawing.hpp"
#include "io/sink.hpp"
#include "io/stack_of_file.hpp"
#include "io/surface.hpp"
#include "io/volume/volume.hpp"

namespace tetloft::internal::io {

/// What a reader is handed.
struct Source {
  /// All of the file; of a volume in a file, which is read slice by slice, its beginning
  /// (`whole` has the rest).
  std::string_view bytes;
  std::string name;    ///< of the file, for messages
  std::string folder;  ///< of the file, for formats whose data may stand beside it; empty: none
  /// The file, or null: then `bytes` are all there is.
  const ByteSource* whole = nullptr;
};

/// What a writer is told beside the values. The encoding is one that there is.
struct Target {
  std::string name;  ///< of the file, for messages; empty where there is none
  WriteOptions options;
  /// Of a model that lies elsewhere than its stack, whose points are handed over as they lie in
  /// its file: those of the stack. Null: the same.
  const IdVector<VertexId, Point3>* stack_points = nullptr;
  /// Of a .vtu: bytes to be kept in it (vtu_piece.hpp); empty: none.
  std::string_view piece = {};
};

using Written = Result<std::vector<Warning>>;

/// A file that a model's format has beside the one that is asked for: of its name, but with this
/// ending.
struct Companion {
  std::string_view extension;
  /// As Format::write_model. Null: none.
  Written (*write)(Sink&, const Model&, const Target&) = nullptr;
};

/// A function that is null is something that the format cannot do. Readers trust no count of a
/// file; their errors and warnings name source.name. Writers check before they append.
struct Format {
  std::string_view name;
  std::string_view summary;
  /// Lower case, with the dot, empty behind the last; several parts (".nii.gz") may be one.
  std::array<std::string_view, 4> extensions = {};
  /// Whether these bytes, a whole file, begin as its files do; looks at few of them. Null where
  /// nothing tells.
  bool (*recognise)(std::string_view bytes) = nullptr;
  /// Takes text that nothing recognises.
  bool takes_text = false;

  /// Stacks come from formats that hold just that, from drawings and from volumes: one of these.
  Result<StackOfFile> (*read_stack)(const Source&, const ReadOptions&) = nullptr;
  Result<Drawing> (*read_drawing)(const Source&, const ReadOptions&) = nullptr;
  Result<std::unique_ptr<Volume>> (*open_volume)(const Source&, const ReadOptions&) = nullptr;
  /// Beside read_stack, of a regular file with this name whose contents are recognised, or said to
  /// be of this format: its sections one after the other, and what read_stack tells of a file.
  /// Takes the file, unless it has to be read as a whole, which nothing stands for.
  Result<std::optional<OpenedSections>> (*open_sections)(std::unique_ptr<ByteSource>& file,
                                                         const std::string& name,
                                                         const ReadOptions&) = nullptr;
  Result<ReadModel> (*read_model)(const Source&, const ReadOptions&) = nullptr;
  Result<ReadPoints> (*read_points)(const Source&, const ReadOptions&) = nullptr;
  /// A surface, for slicing: finite points; corners that are points.
  Result<ReadTriangles> (*read_triangles)(const Source&, const ReadOptions&) = nullptr;
  Result<Labels> (*read_labels)(const Source&, const ReadOptions&) = nullptr;

  Written (*write_stack)(Sink&, const SectionStack&, const Target&) = nullptr;
  /// The model is well formed.
  Written (*write_model)(Sink&, const Model&, const Target&) = nullptr;
  std::array<Companion, 2> companions = {};
  /// The boundary of the model, which is well formed.
  Written (*write_surface)(Sink&, const SurfaceMesh&, const Model&, const Target&) = nullptr;
  Written (*write_points)(Sink&, const std::vector<Point3>&, const Target&) = nullptr;
  Written (*write_labels)(Sink&, const Labels&, const Target&) = nullptr;
  Written (*write_lines)(Sink&, const LineSet&, const Target&) = nullptr;
};

}  // namespace tetloft::internal::io

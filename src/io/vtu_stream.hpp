// A model written as .vtu without ever being in memory: slabs come from below, some at a time, and
// wait in scratch files, one for each array. The bytes are those of the whole model's file.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include <tetloft/formats.hpp>
#include <tetloft/model.hpp>
#include <tetloft/result.hpp>

#include "io/scratch_column.hpp"
#include "io/stage.hpp"
#include "io/vtu_grid.hpp"
#include "model/segment.hpp"
#include "model/volume.hpp"

namespace tetloft::internal::io {

class VtuStream {
 public:
  /// For a file at `path`, which is not touched.
  explicit VtuStream(const std::string& path);

  /// As JoinedModel::add(); of a model in the frame of its stack. The scratch files need room for
  /// as many bytes as the file: error io where there is none.
  [[nodiscard]] Result<void> add(const Model& model, const SlabRange& slabs);
  /// Takes back all that was added from the segment on that has this slab, or more. Returns the
  /// slab that comes next.
  std::size_t back_to(std::size_t slab);
  [[nodiscard]] std::size_t slabs() const { return numbers_.slabs(); }

  /// Count, frame, texts and tables of the whole: those of the first segment and of all. No points,
  /// no tets.
  [[nodiscard]] Model& rest() { return rest_; }

  struct Figures {
    std::size_t vertices = 0;
    std::size_t tets = 0;
    std::size_t input_vertices = 0;
    std::size_t split_vertices = 0;
    double volume = 0;  ///< volume_of() the model
  };
  /// Reads all points and corners again.
  [[nodiscard]] Result<Figures> figures();

  /// The file. Compressed arrays are in memory, packed, as ever; of others nothing is.
  [[nodiscard]] Result<Staged> stage(Encoding encoding, TemporaryWatcher* watcher = nullptr);

 private:
  using Column =
      std::variant<ScratchColumn<std::int32_t>, ScratchColumn<std::uint8_t>, ScratchColumn<double>>;
  // Points, or tets: a column for each of their fields, in the order of for_each_field().
  struct Columns {
    std::vector<Column> fields;
    void cut(std::size_t size);
  };
  struct Vertices : Columns {
    explicit Vertices(const std::string& path);
    ScratchColumn<double> points;
  };
  struct Tets : Columns {
    explicit Tets(const std::string& path);
    ScratchColumn<std::int64_t> corners;  // AddedSegment::number
  };
  // What a segment is made of, in all: its sections' vertices, with those of the seam; constructed
  // vertices; tets.
  struct Segment {
    IndexRange section_vertices, constructed, tets;
    std::size_t input_vertices = 0;
    std::size_t split_vertices = 0;
    double largest = 0;                 // coordinate of a tet's corner, without its sign
    std::array<std::size_t, 4> rows{};  // of the tables, in front of it
  };
  // The state in front of a segment.
  struct Mark {
    std::size_t segment = 0;
    SegmentNumbers numbers;
  };

  void append_vertex(const Model& model, VertexId v, Vertices& to, Segment& segment);
  void append_tet(const Model& model, TetId t, const AddedSegment& added);
  [[nodiscard]] std::array<std::size_t, 4> rows() const;
  void add_volumes(const Segment& segment, int exponent, CompensatedSum& sum);
  [[nodiscard]] std::optional<Error> failure() const;
  [[nodiscard]] VtuGrid grid();

  std::string path_;
  SegmentNumbers numbers_;
  Model rest_;
  Vertices sections_;
  Vertices constructed_;
  Tets tets_;
  std::vector<Segment> segments_;
  std::deque<Mark> marks_;  // of the first segment and the last ones
};

}  // namespace tetloft::internal::io

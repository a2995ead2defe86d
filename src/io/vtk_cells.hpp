// The cells of legacy VTK files, and their numbers.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include <tetloft/model.hpp>

#include "io/data_cursor.hpp"
#include "io/scalar_type.hpp"
#include "io/warning_list.hpp"

namespace tetloft::internal::io {

using LegacyIntegers = std::vector<std::int64_t>;

/// The type of numbers that has this name, whatever the case.
[[nodiscard]] std::optional<ScalarType> legacy_type(std::string_view name);
/// The next word as a type, and the rest of its line: behind it the numbers begin.
[[nodiscard]] ScalarType take_type(DataCursor& cursor);
[[nodiscard]] LegacyIntegers take_integers(DataCursor& cursor, std::size_t count, ScalarType type);

class LegacyCells {
 public:
  /// Behind the word CELLS; `offsets`: they are two arrays, as from version 5 on.
  void read_cells(DataCursor& cursor, bool offsets);
  /// Behind the word CELL_TYPES.
  void read_types(DataCursor& cursor);
  [[nodiscard]] bool are_there() const { return seen_ && types_.has_value(); }

  [[nodiscard]] std::size_t size() const { return ends_.size(); }
  [[nodiscard]] bool is_tet(std::size_t cell) const;
  /// Appends the tets to a model that has its points; a warning counts all others.
  void add_tets(const DataCursor& cursor, Model& model, WarningList& warnings) const;

 private:
  [[nodiscard]] std::size_t begin_of(std::size_t cell) const;
  void read_counted(DataCursor& cursor, std::size_t count, std::size_t size);
  void read_offsets(DataCursor& cursor, std::size_t count, std::size_t size);
  void check_corners(const DataCursor& cursor, std::size_t cell) const;
  [[nodiscard]] TetVertices tet_of(const DataCursor& cursor, std::size_t cell,
                                   std::size_t points) const;

  bool seen_ = false;
  bool offsets_ = false;
  LegacyIntegers corners_;         // without offsets_, how many there are before those of each cell
  std::vector<std::size_t> ends_;  // of each cell, in corners_
  std::optional<LegacyIntegers> types_;  // by cell
};

}  // namespace tetloft::internal::io

#include "io/vtk_cells.hpp"

#include <algorithm>
#include <array>
#include <string>
#include <utility>

#include "core/text.hpp"
#include "io/numbers.hpp"
#include "io/vtu_read.hpp"
#include "model/well_formed.hpp"

namespace tetloft::internal::io {

namespace {

// vtkIdType is written as int, long by the programs of systems where it has 64 bits.
constexpr std::array<ScalarName, 16> kLegacyTypes{{{"unsigned_char", ScalarType::uint8},
                                                   {"char", ScalarType::int8},
                                                   {"signed_char", ScalarType::int8},
                                                   {"unsigned_short", ScalarType::uint16},
                                                   {"short", ScalarType::int16},
                                                   {"unsigned_int", ScalarType::uint32},
                                                   {"int", ScalarType::int32},
                                                   {"vtkidtype", ScalarType::int32},
                                                   {"unsigned_long", ScalarType::uint64},
                                                   {"long", ScalarType::int64},
                                                   {"vtktypeint64", ScalarType::int64},
                                                   {"vtktypeuint64", ScalarType::uint64},
                                                   {"long_long", ScalarType::int64},
                                                   {"unsigned_long_long", ScalarType::uint64},
                                                   {"float", ScalarType::float32},
                                                   {"double", ScalarType::float64}}};

// How many corners cells of the types 0 to 14 have; −1: any number.
constexpr std::array<int, 15> kCellCorners{0, 1, -1, 2, -1, 3, -1, -1, 4, 4, 4, 8, 8, 6, 5};

LegacyIntegers offset_array(DataCursor& cursor, std::string_view keyword, std::size_t count) {
  if (lower_case(cursor.word()) != keyword) cursor.fail("CELLS lack " + std::string(keyword));
  const ScalarType type = take_type(cursor);
  if (is_float(type)) cursor.fail("the " + std::string(keyword) + " of cells are no integers");
  return take_integers(cursor, count, type);
}

}  // namespace

std::optional<ScalarType> legacy_type(std::string_view name) {
  return find_scalar(kLegacyTypes, lower_case(name));
}

ScalarType take_type(DataCursor& cursor) {
  const std::string_view name = cursor.word();
  const auto type = legacy_type(name);
  if (!type) cursor.fail(in_quotes(name) + " is no type of numbers");
  cursor.line();
  return *type;
}

LegacyIntegers take_integers(DataCursor& cursor, std::size_t count, ScalarType type) {
  cursor.require(count, type);
  LegacyIntegers values;
  values.reserve(count);
  for (std::size_t i = 0; i < count; ++i) values.push_back(cursor.integer(type));
  return values;
}

void LegacyCells::read_cells(DataCursor& cursor, bool offsets) {
  if (std::exchange(seen_, true)) cursor.fail("CELLS stand twice");
  offsets_ = offsets;
  const std::size_t count = cursor.text_count("cells");
  const std::size_t size = cursor.text_count("numbers of cells");
  cursor.line();
  offsets ? read_offsets(cursor, count, size) : read_counted(cursor, count, size);
}

// Of each cell how many corners it has, and these.
void LegacyCells::read_counted(DataCursor& cursor, std::size_t count, std::size_t size) {
  corners_ = take_integers(cursor, size, ScalarType::int32);
  for (std::size_t at = 0; at < size;) {
    const std::int64_t corners = corners_[at++];
    if (corners < 0 || static_cast<std::uint64_t>(corners) > size - at) {
      cursor.fail("cell " + std::to_string(ends_.size()) + " has " + std::to_string(corners) +
                  " corners, and the cells end before");
    }
    at += static_cast<std::size_t>(corners);
    ends_.push_back(at);
  }
  if (ends_.size() == count) return;
  cursor.fail("CELLS hold " + std::to_string(ends_.size()) + " cells where " +
              std::to_string(count) + " are announced");
}

// Of offsets there is one more than of cells, or none at all.
void LegacyCells::read_offsets(DataCursor& cursor, std::size_t count, std::size_t size) {
  const LegacyIntegers offsets = offset_array(cursor, "offsets", count);
  corners_ = offset_array(cursor, "connectivity", size);
  for (std::size_t i = 0; i < offsets.size(); ++i) {
    const std::int64_t before = i == 0 ? 0 : offsets[i - 1];
    if (offsets[i] < before || static_cast<std::uint64_t>(offsets[i]) > size) {
      cursor.fail("the offsets of cells do not increase within CONNECTIVITY");
    }
    if (i != 0) ends_.push_back(static_cast<std::size_t>(offsets[i]));
  }
  if (!offsets.empty() && offsets[0] != 0) cursor.fail("the first offset of cells is not 0");
}

void LegacyCells::read_types(DataCursor& cursor) {
  if (types_) cursor.fail("CELL_TYPES stand twice");
  const std::size_t count = cursor.text_count("types of cells");
  cursor.line();
  types_ = take_integers(cursor, count, ScalarType::int32);
}

bool LegacyCells::is_tet(std::size_t cell) const { return (*types_)[cell] == kVtkTetra; }

// Where the corners of a cell begin.
std::size_t LegacyCells::begin_of(std::size_t cell) const {
  return (cell == 0 ? 0 : ends_[cell - 1]) + (offsets_ ? 0U : 1U);
}

void LegacyCells::add_tets(const DataCursor& cursor, Model& model, WarningList& warnings) const {
  if (types_->size() != ends_.size()) {
    cursor.fail("CELL_TYPES are " + std::to_string(types_->size()) + " for " +
                std::to_string(ends_.size()) + " cells");
  }
  for (std::size_t cell = 0; cell < ends_.size(); ++cell) check_corners(cursor, cell);
  const auto tets =
      static_cast<std::size_t>(std::count(types_->begin(), types_->end(), std::int64_t{kVtkTetra}));
  const std::size_t others = types_->size() - tets;
  if (tets >= kMostModelTets) cursor.fail("the file holds too many tets");
  if (tets == 0 && others != 0) cursor.fail("none of the file's cells is a tetrahedron");
  if (others != 0) {
    warnings.add("left out: " + std::to_string(others) +
                 (others == 1 ? " cell that is" : " cells that are") + " no tetrahedron");
  }
  model.tets.reserve(tets);
  for (std::size_t cell = 0; cell < ends_.size(); ++cell) {
    if (is_tet(cell)) model.tets.push_back(tet_of(cursor, cell, model.points.size()));
  }
}

// A type that is cut off is another's, most of all.
void LegacyCells::check_corners(const DataCursor& cursor, std::size_t cell) const {
  const std::int64_t type = (*types_)[cell];
  const std::size_t corners = ends_[cell] - begin_of(cell);
  if (type < 0 || static_cast<std::size_t>(type) >= kCellCorners.size()) return;
  const int due = kCellCorners[static_cast<std::size_t>(type)];
  if (due < 0 || corners == static_cast<std::size_t>(due)) return;
  cursor.fail("cell " + std::to_string(cell) + " is of type " + std::to_string(type) + " and has " +
              std::to_string(corners) + " corners");
}

TetVertices LegacyCells::tet_of(const DataCursor& cursor, std::size_t cell,
                                std::size_t points) const {
  TetVertices tet;
  for (std::size_t k = 0; k < 4; ++k) {
    const std::int64_t corner = corners_[begin_of(cell) + k];
    if (corner < 0 || static_cast<std::uint64_t>(corner) >= points) {
      cursor.fail("cell " + std::to_string(cell) + " refers to point " + std::to_string(corner) +
                  " of " + std::to_string(points));
    }
    tet[k] = VertexId(corner);
  }
  return tet;
}

}  // namespace tetloft::internal::io

// Legacy VTK files of unstructured grids, versions 2.0 to 5.1, text and binary (VTK File Formats,
// "Simple Legacy Formats"; 5.1 by the notes of VTK 9.0).
//
// Tets are kept, with the data that tetloft writes; all else is passed over by its length, and what
// is not known how long it is ends the reading, once there are cells.
#include "io/vtk_read.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/guard.hpp"
#include "core/text.hpp"
#include "io/cursor.hpp"
#include "io/data_cursor.hpp"
#include "io/groups.hpp"
#include "io/numbers.hpp"
#include "io/vtk_text.hpp"
#include "io/vtu_read.hpp"
#include "model/fields.hpp"
#include "model/well_formed.hpp"

namespace tetloft::internal::io {

namespace {

struct LegacyType {
  std::string_view name;
  ScalarType type;
};
// vtkIdType is written as int, long by the programs of systems where it has 64 bits.
constexpr std::array<LegacyType, 16> kLegacyTypes{{{"unsigned_char", ScalarType::uint8},
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

// An attribute of points or cells that is no field: how many numbers it has for each, 0: it says.
struct LegacyAttribute {
  std::string_view keyword;
  std::size_t components;
};
constexpr std::array<LegacyAttribute, 8> kLegacyAttributes{{{"vectors", 3},
                                                            {"normals", 3},
                                                            {"tensors", 9},
                                                            {"tensors6", 6},
                                                            {"global_ids", 1},
                                                            {"pedigree_ids", 1},
                                                            {"edge_flags", 1},
                                                            {"texture_coordinates", 0}}};

class LegacyReader {
 public:
  explicit LegacyReader(const Source& source)
      : cursor_(source.bytes, source.name), warnings_(source.name) {}

  ReadModel read() {
    read_head();
    while (read_part()) {
    }
    if (!seen_points_ || !types_) cursor_.fail("the file has no POINTS, CELLS and CELL_TYPES");
    make_tets();
    for_each_field([&](const auto& field) { set_field(field); });
    for (const auto& [array, text] : texts_) set_text(model_, array, text);
    turn_positive(model_, warnings_);
    return {std::move(model_), warnings_.take()};
  }

 private:
  // Data of the whole, of points, of cells.
  enum class Part : std::uint8_t { whole, points, cells };
  // An array of integers that may be a field of the model.
  using Values = std::vector<std::int64_t>;

  void read_head() {
    constexpr std::string_view kBeginning = "# vtk DataFile Version ";
    const std::string_view first = cursor_.line();
    const std::string_view version = first.substr(std::min(first.size(), kBeginning.size()));
    if (first.substr(0, kBeginning.size()) != kBeginning || version.empty() || version[0] < '1' ||
        version[0] > '5') {
      cursor_.fail("this is no legacy VTK file of version 1 to 5");
    }
    offsets_ = version[0] == '5';
    cursor_.line();
    const std::string form = lower_case(cursor_.word());
    if (form != "ascii" && form != "binary") cursor_.fail("the file is neither ASCII nor BINARY");
    const std::string keyword = lower_case(cursor_.word());
    const std::string grid = lower_case(cursor_.word());
    if (keyword != "dataset" || grid != "unstructured_grid") {
      cursor_.fail("this VTK file is no UNSTRUCTURED_GRID but " + in_quotes(grid));
    }
    // Where binary numbers are line numbers mean nothing.
    cursor_.set_form(form == "binary" ? DataForm::big_endian : DataForm::text);
  }

  // What the next keyword announces; false at the end.
  bool read_part() {
    const std::string keyword = lower_case(cursor_.word());
    if (keyword.empty()) return false;
    if (keyword == "points") {
      read_points();
    } else if (keyword == "cells") {
      read_cells();
    } else if (keyword == "cell_types") {
      read_types();
    } else if (keyword == "point_data" || keyword == "cell_data") {
      part_ = keyword == "point_data" ? Part::points : Part::cells;
      tuples_ = cursor_.text_count("tuples");
      cursor_.line();
    } else if (keyword == "field") {
      return read_fields();
    } else if (keyword == "metadata") {
      pass_over_metadata();
    } else {
      return read_attribute(keyword);
    }
    return true;
  }

  [[nodiscard]] static std::optional<ScalarType> type_of(std::string_view name) {
    const std::string lower = lower_case(name);
    for (const LegacyType& type : kLegacyTypes) {
      if (type.name == lower) return type.type;
    }
    return std::nullopt;
  }

  // Behind the line in which the type stands the numbers begin.
  ScalarType take_type() {
    const std::string_view name = cursor_.word();
    const auto type = type_of(name);
    if (!type) cursor_.fail(in_quotes(name) + " is no type of numbers");
    cursor_.line();
    return *type;
  }

  void read_points() {
    if (std::exchange(seen_points_, true)) cursor_.fail("POINTS stand twice");
    const std::size_t count = cursor_.text_count("points");
    const ScalarType type = take_type();
    if (count >= VertexId::kInvalid) cursor_.fail("the file holds too many points");
    cursor_.require(3 * std::uint64_t{count}, type);
    model_.points.reserve(count);
    for (std::size_t i = 0; i < count; ++i) {
      const double x = cursor_.number(type);
      const double y = cursor_.number(type);
      model_.points.push_back({x, y, cursor_.number(type)});
    }
  }

  Values integers(std::size_t count, ScalarType type) {
    cursor_.require(count, type);
    Values values;
    values.reserve(count);
    for (std::size_t i = 0; i < count; ++i) values.push_back(cursor_.integer(type));
    return values;
  }

  void read_cells() {
    if (std::exchange(seen_cells_, true)) cursor_.fail("CELLS stand twice");
    const std::size_t count = cursor_.text_count("cells");
    const std::size_t size = cursor_.text_count("numbers of cells");
    cursor_.line();
    if (!offsets_) {
      corners_ = integers(size, ScalarType::int32);
      for (std::size_t at = 0; at < size;) {
        const std::int64_t corners = corners_[at++];
        if (corners < 0 || static_cast<std::uint64_t>(corners) > size - at) {
          cursor_.fail("cell " + std::to_string(ends_.size()) + " has " + std::to_string(corners) +
                       " corners, and the cells end before");
        }
        at += static_cast<std::size_t>(corners);
        ends_.push_back(at);
      }
      if (ends_.size() == count) return;
      cursor_.fail("CELLS hold " + std::to_string(ends_.size()) + " cells where " +
                   std::to_string(count) + " are announced");
    }
    // The first number is that of offsets: one more than cells, or none at all.
    const Values offsets = offset_array("offsets", count);
    corners_ = offset_array("connectivity", size);
    for (std::size_t i = 0; i < offsets.size(); ++i) {
      const std::int64_t before = i == 0 ? 0 : offsets[i - 1];
      if (offsets[i] < before || static_cast<std::uint64_t>(offsets[i]) > size) {
        cursor_.fail("the offsets of cells do not increase within CONNECTIVITY");
      }
      if (i != 0) ends_.push_back(static_cast<std::size_t>(offsets[i]));
    }
    if (!offsets.empty() && offsets[0] != 0) cursor_.fail("the first offset of cells is not 0");
  }

  Values offset_array(std::string_view keyword, std::size_t count) {
    if (lower_case(cursor_.word()) != keyword) {
      cursor_.fail("CELLS lack " + std::string(keyword));
    }
    const ScalarType type = take_type();
    if (is_float(type)) cursor_.fail("the " + std::string(keyword) + " of cells are no integers");
    return integers(count, type);
  }

  void read_types() {
    if (types_) cursor_.fail("CELL_TYPES stand twice");
    const std::size_t count = cursor_.text_count("types of cells");
    cursor_.line();
    types_ = integers(count, ScalarType::int32);
  }

  // To the next line that is empty.
  void pass_over_metadata() {
    cursor_.line();
    while (cursor_.left() != 0 && !cursor_.line().empty()) {
    }
  }

  // Whether reading goes on.
  bool read_fields() {
    static_cast<void>(cursor_.word());
    const std::size_t count = cursor_.text_count("arrays");
    cursor_.line();
    for (std::size_t i = 0; i < count; ++i) {
      std::string_view name = cursor_.word();
      while (lower_case(name) == "metadata") {
        pass_over_metadata();
        name = cursor_.word();
      }
      if (name.empty()) cursor_.fail("the file ends early");
      const std::size_t components = cursor_.text_count("components");
      const std::size_t tuples = cursor_.text_count("tuples");
      const std::string_view type = cursor_.word();
      cursor_.line();
      if (!read_array(name, type, components, tuples)) return false;
    }
    return true;
  }

  bool read_attribute(const std::string& keyword) {
    if (part_ == Part::whole) return stop_at(keyword);
    if (keyword == "scalars") return read_scalars();
    const std::string_view name = cursor_.word();
    if (keyword == "color_scalars" || keyword == "lookup_table") {
      // As text they are fractions, and as many.
      const bool table = keyword == "lookup_table";
      const std::size_t count = cursor_.text_count("colours");
      cursor_.line();
      return read_array(name, "unsigned_char", table ? 4 : count, table ? count : tuples_);
    }
    for (const LegacyAttribute& attribute : kLegacyAttributes) {
      if (attribute.keyword != keyword) continue;
      const std::size_t components =
          attribute.components == 0 ? cursor_.text_count("components") : attribute.components;
      const std::string_view type = cursor_.word();
      cursor_.line();
      return read_array(name, type, components, tuples_);
    }
    return stop_at(keyword);
  }

  // The number of components, and the table, may be missing.
  bool read_scalars() {
    const std::string_view name = cursor_.word();
    const std::string_view type = cursor_.word();
    const std::string_view number = cursor_.line();
    std::size_t components = 1;
    if (const auto given = parse_integer(trimmed(number))) {
      if (*given < 1 || *given > 4) cursor_.fail("scalars have 1 to 4 components");
      components = static_cast<std::size_t>(*given);
    }
    if (lower_case(cursor_.rest().substr(0, 12)) == "lookup_table") cursor_.line();
    return read_array(name, type, components, tuples_);
  }

  bool read_array(std::string_view name, std::string_view type_name, std::size_t components,
                  std::size_t tuples) {
    const auto type = type_of(type_name);
    const bool bits = lower_case(type_name) == "bit";
    if (!type && !bits) return stop_at(type_name);
    const std::size_t most = cursor_.left();
    if (components != 0 && tuples != 0 && (components > most || tuples > most)) {
      cursor_.fail("the array " + in_quotes(name) + " claims more data than the file holds");
    }
    const std::uint64_t count = std::uint64_t{components} * tuples;
    if (bits) {
      const bool text = cursor_.form() == DataForm::text;
      cursor_.skip(text ? count : count / 8 + (count % 8 != 0 ? 1 : 0), ScalarType::uint8);
      return true;
    }
    const bool wanted = components == 1 && !is_float(*type);
    if (wanted && part_ == Part::whole && *type == ScalarType::uint8 && is_text_array(name)) {
      take_text(name, tuples);
    } else if (wanted && is_field(name) && !arrays_.contains({part_, name})) {
      arrays_.emplace(std::pair(part_, name), integers(tuples, *type));
    } else {
      cursor_.skip(count, *type);
    }
    return true;
  }

  void take_text(std::string_view name, std::size_t count) {
    cursor_.require(count, ScalarType::uint8);
    std::string text;
    text.reserve(count);
    for (std::size_t i = 0; i < count; ++i) {
      text += static_cast<char>(static_cast<unsigned char>(cursor_.integer(ScalarType::uint8)));
    }
    texts_.emplace(name, std::move(text));
  }

  [[nodiscard]] bool is_field(std::string_view name) const {
    bool found = false;
    for_each_field([&](const auto& field) {
      found =
          found || (field.name == name && part_ == (field.kOfPoints ? Part::points : Part::cells));
    });
    return found;
  }

  // How long this is cannot be told.
  bool stop_at(std::string_view what) {
    if (!types_ || !seen_points_) cursor_.fail(in_quotes(what) + " is nothing that is read here");
    warnings_.add("left out: " + in_quotes(what) + ", and what follows it");
    return false;
  }

  [[nodiscard]] bool is_tet(std::size_t cell) const { return (*types_)[cell] == kVtkTetra; }

  // Where the corners of a cell begin.
  [[nodiscard]] std::size_t begin_of(std::size_t cell) const {
    return (cell == 0 ? 0 : ends_[cell - 1]) + (offsets_ ? 0U : 1U);
  }

  void make_tets() {
    if (types_->size() != ends_.size()) {
      cursor_.fail("CELL_TYPES are " + std::to_string(types_->size()) + " for " +
                   std::to_string(ends_.size()) + " cells");
    }
    const auto tets = static_cast<std::size_t>(
        std::count(types_->begin(), types_->end(), std::int64_t{kVtkTetra}));
    const std::size_t others = types_->size() - tets;
    if (tets >= kMostModelTets) cursor_.fail("the file holds too many tets");
    if (tets == 0 && others != 0) cursor_.fail("none of the file's cells is a tetrahedron");
    if (others != 0) {
      warnings_.add("left out: " + std::to_string(others) +
                    (others == 1 ? " cell that is" : " cells that are") + " no tetrahedron");
    }
    model_.tets.reserve(tets);
    for (std::size_t cell = 0; cell < ends_.size(); ++cell) {
      if (is_tet(cell)) model_.tets.push_back(tet_of(cell));
    }
  }

  [[nodiscard]] TetVertices tet_of(std::size_t cell) const {
    const std::size_t begin = begin_of(cell);
    if (ends_[cell] - begin != 4) {
      cursor_.fail("cell " + std::to_string(cell) + " is a tetrahedron without four corners");
    }
    TetVertices tet;
    for (std::size_t k = 0; k < 4; ++k) {
      const std::int64_t corner = corners_[begin + k];
      if (corner < 0 || static_cast<std::uint64_t>(corner) >= model_.points.size()) {
        cursor_.fail("cell " + std::to_string(cell) + " refers to point " + std::to_string(corner) +
                     " of " + std::to_string(model_.points.size()));
      }
      tet[k] = VertexId(corner);
    }
    return tet;
  }

  // Nothing where the array is another writer's: with a value out of range, or of another length.
  template <class Field>
  void set_field(const Field& field) {
    using Stored = typename Field::Stored;
    const auto found = arrays_.find({Field::kOfPoints ? Part::points : Part::cells, field.name});
    if (found == arrays_.end()) return;
    const Values& values = found->second;
    if (values.size() != (Field::kOfPoints ? model_.points.size() : ends_.size())) return;
    const auto is_value = [](std::int64_t value) {
      return value >= Stored::kLeast && value <= Stored::kLargest;
    };
    if (!std::all_of(values.begin(), values.end(), is_value)) return;
    auto& target = model_.*field.values;
    target.reserve(Field::due(model_));
    for (std::size_t i = 0; i < values.size(); ++i) {
      if (Field::kOfPoints || is_tet(i)) target.push_back(Stored::load(values[i]));
    }
    if (field.name == "component") count_components(model_);
  }

  DataCursor cursor_;
  WarningList warnings_;
  bool offsets_ = false;  // CELLS are two arrays, as from version 5 on
  Part part_ = Part::whole;
  std::size_t tuples_ = 0;  // of the attributes of this part
  bool seen_points_ = false;
  bool seen_cells_ = false;
  Values corners_;                 // without offsets_, how many there are before those of each cell
  std::vector<std::size_t> ends_;  // of each cell, in corners_
  std::optional<Values> types_;    // by cell
  std::map<std::pair<Part, std::string_view>, Values> arrays_;
  std::map<std::string_view, std::string> texts_;
  Model model_;
};

}  // namespace

Result<ReadModel> read_vtk(const Source& source, const ReadOptions& /*options*/) {
  try {
    return LegacyReader(source).read();
  } catch (const Failed& failed) {
    return failed.error();
  }
}

}  // namespace tetloft::internal::io

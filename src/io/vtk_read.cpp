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
#include "io/vtk_cells.hpp"
#include "io/vtk_text.hpp"
#include "model/fields.hpp"

namespace tetloft::internal::io {

namespace {

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
    if (!seen_points_ || !cells_.are_there()) {
      cursor_.fail("the file has no POINTS, CELLS and CELL_TYPES");
    }
    cells_.add_tets(cursor_, model_, warnings_);
    for_each_field([&](const auto& field) { set_field(field); });
    for (const auto& [array, text] : texts_) set_text(model_, array, text);
    turn_positive(model_, warnings_);
    return {std::move(model_), warnings_.take()};
  }

 private:
  // Data of the whole, of points, of cells.
  enum class Part : std::uint8_t { whole, points, cells };
  // An array of integers that may be a field of the model.
  using Values = LegacyIntegers;

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
      cells_.read_cells(cursor_, offsets_);
    } else if (keyword == "cell_types") {
      cells_.read_types(cursor_);
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

  void read_points() {
    if (std::exchange(seen_points_, true)) cursor_.fail("POINTS stand twice");
    const std::size_t count = cursor_.text_count("points");
    const ScalarType type = take_type(cursor_);
    if (count >= VertexId::kInvalid) cursor_.fail("the file holds too many points");
    cursor_.require(3 * std::uint64_t{count}, type);
    model_.points.reserve(count);
    for (std::size_t i = 0; i < count; ++i) {
      const double x = cursor_.number(type);
      const double y = cursor_.number(type);
      model_.points.push_back({x, y, cursor_.number(type)});
    }
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
    const auto type = legacy_type(type_name);
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
    const bool is_text =
        std::find(kTextArrays.begin(), kTextArrays.end(), name) != kTextArrays.end();
    if (wanted && part_ == Part::whole && *type == ScalarType::uint8 && is_text) {
      take_text(name, tuples);
    } else if (wanted && is_field(name) && !arrays_.contains({part_, name})) {
      arrays_.emplace(std::pair(part_, name), take_integers(cursor_, tuples, *type));
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
    if (!cells_.are_there() || !seen_points_)
      cursor_.fail(in_quotes(what) + " is nothing that is read here");
    warnings_.add("left out: " + in_quotes(what) + ", and what follows it");
    return false;
  }

  // Nothing where the array is another writer's: with a value out of range, or of another length.
  template <class Field>
  void set_field(const Field& field) {
    using Stored = typename Field::Stored;
    const auto found = arrays_.find({Field::kOfPoints ? Part::points : Part::cells, field.name});
    if (found == arrays_.end()) return;
    const Values& values = found->second;
    if (values.size() != (Field::kOfPoints ? model_.points.size() : cells_.size())) return;
    const auto is_value = [](std::int64_t value) {
      return value >= Stored::kLeast && value <= Stored::kLargest;
    };
    if (!std::all_of(values.begin(), values.end(), is_value)) return;
    auto& target = model_.*field.values;
    target.reserve(Field::due(model_));
    for (std::size_t i = 0; i < values.size(); ++i) {
      if (Field::kOfPoints || cells_.is_tet(i)) target.push_back(Stored::load(values[i]));
    }
    if (field.name == "component") count_components(model_);
  }

  DataCursor cursor_;
  WarningList warnings_;
  bool offsets_ = false;  // CELLS are two arrays, as from version 5 on
  Part part_ = Part::whole;
  std::size_t tuples_ = 0;  // of the attributes of this part
  bool seen_points_ = false;
  LegacyCells cells_;
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

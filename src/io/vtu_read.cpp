// VTK XML unstructured grids (.vtu) of tetrahedra, by tetloft and other writers: the arrays
// that were declared (vtu_scan.hpp) are decoded and compared with what they announce.
#include "io/vtu_read.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "io/groups.hpp"
#include "io/vtk_data.hpp"
#include "io/vtk_text.hpp"
#include "io/vtu_frame.hpp"
#include "io/vtu_piece.hpp"
#include "io/vtu_scan.hpp"
#include "io/xml.hpp"
#include "model/fields.hpp"
#include "model/tables.hpp"

namespace tetloft::internal::io {

namespace {

// Half-faces 4 t + i must fit into 32 bits (tet_mesh.hpp).
constexpr std::size_t kTetLimit = std::size_t{1} << 30;

// Nothing where there is no such array, or another writer's.
Result<std::optional<std::string>> bytes_of_column(const VtuDeclaration& grid,
                                                   const XmlScanner& scanner,
                                                   std::string_view name) {
  using Bytes = std::optional<std::string>;
  const DataArray* const array = grid.find_column(name);
  if (array == nullptr || array->type != ScalarType::uint8 || array->components != 1) {
    return Bytes();
  }
  const auto values = read_integers(*array, grid.source, scanner);
  if (!values) return values.error();
  std::string bytes;
  bytes.reserve(values->size());
  for (const std::int64_t value : *values) {
    if (value < 0 || value > 255) return Bytes();
    bytes += static_cast<char>(static_cast<unsigned char>(value));
  }
  return Bytes(std::move(bytes));
}

class GridDecoder {
 public:
  GridDecoder(const VtuDeclaration& grid, const XmlScanner& scanner)
      : grid_(grid), scanner_(scanner) {}

  Result<Model> decode() {
    if (Result<void> apart = check_apart(); !apart) return apart.error();
    std::vector<const DataArray*> arrays;
    for (const VtuArray& array : grid_.arrays) arrays.push_back(&array.data);
    for (const DataArray& array : grid_.columns) arrays.push_back(&array);
    Result<void> unpacked = check_unpacking(arrays, grid_.source, kGridUnpacked, scanner_);
    if (!unpacked) return unpacked.error();
    for (std::size_t piece = 0; piece < grid_.pieces.size(); ++piece) {
      const std::size_t first_point = model_.points.size();
      if (Result<void> points = add_points(piece); !points) return points.error();
      if (Result<void> tets = add_tets(piece, first_point); !tets) return tets.error();
    }
    if (Result<void> fields = read_fields(); !fields) return fields.error();
    Result<void> tables;
    for_each_table([&](const auto& table) {
      if (tables) tables = read_table(table);
    });
    if (!tables) return tables.error();
    if (Result<void> texts = read_texts(); !texts) return texts.error();
    if (Result<void> frame = read_frame(); !frame) return frame.error();
    return std::move(model_);
  }

 private:
  [[nodiscard]] Error complain(std::size_t position, const std::string& message) const {
    return scanner_.complain(position, message);
  }

  // Every byte of the appended data belongs to one array: one block for all would let a small
  // file become a large grid.
  Result<void> check_apart() {
    std::vector<AppendedExtent> extents;
    const auto add = [&](const DataArray& array) {
      if (const auto extent = appended_extent(array, grid_.source)) extents.push_back(*extent);
    };
    for (const VtuArray& array : grid_.arrays) add(array.data);
    for (const DataArray& array : grid_.columns) add(array);
    std::sort(extents.begin(), extents.end(),
              [](const auto& a, const auto& b) { return a.from < b.from; });
    for (std::size_t i = 1; i < extents.size(); ++i) {
      if (extents[i].from >= extents[i - 1].to) continue;
      return complain(std::max(extents[i].array->position, extents[i - 1].array->position),
                      "the array shares appended data with another");
    }
    return {};
  }

  Result<void> add_points(std::size_t p) {
    const VtuPiece& piece = grid_.pieces[p];
    const DataArray* const declared = grid_.find(p, VtuRole::points);
    if (declared == nullptr) {
      if (piece.points == 0) return {};
      return complain(piece.position, "the piece has no Points");
    }
    const DataArray& array = *declared;
    const auto values = read_doubles(array, grid_.source, scanner_);
    if (!values) return values.error();
    if (array.components != 3 || values->size() % 3 != 0 ||
        values->size() / 3 != static_cast<std::size_t>(piece.points)) {
      return complain(array.position, "Points hold " + std::to_string(values->size()) +
                                          " numbers where three each are due for " +
                                          std::to_string(piece.points) + " points");
    }
    if (model_.points.empty()) model_.points.reserve(values->size() / 3);
    for (std::size_t i = 0; i < values->size(); i += 3) {
      const Point3 point{(*values)[i], (*values)[i + 1], (*values)[i + 2]};
      if (!std::isfinite(point.x) || !std::isfinite(point.y) || !std::isfinite(point.z)) {
        Error error = complain(array.position, "a coordinate is not finite");
        error.where.vertex = model_.points.size();
        return error;
      }
      model_.points.push_back(point);
    }
    if (model_.points.size() >= VertexId::kInvalid) {
      return complain(piece.position, "the file holds too many points");
    }
    return {};
  }

  // One of the three arrays of Cells. Without cells it may be missing.
  Result<std::vector<std::int64_t>> cell_array(std::size_t p, VtuRole role, const char* name,
                                               std::size_t expected) {
    const DataArray* const array = grid_.find(p, role);
    if (array == nullptr) {
      if (expected == 0) return std::vector<std::int64_t>();
      return complain(grid_.pieces[p].position, std::string("the piece has no cell array ") + name);
    }
    auto values = read_integers(*array, grid_.source, scanner_);
    if (values && values->size() != expected) {
      return complain(array->position, std::string("the cell array ") + name + " has " +
                                           std::to_string(values->size()) + " values where " +
                                           std::to_string(expected) + " are due");
    }
    return values;
  }

  Result<void> add_tets(std::size_t p, std::size_t first_point) {
    const VtuPiece& piece = grid_.pieces[p];
    const auto cells = static_cast<std::size_t>(piece.cells);
    if (cells >= kTetLimit || model_.tets.size() + cells >= kTetLimit) {
      return complain(piece.position, "the file announces too many cells");
    }
    // Types first: in a grid of mixed cells that is what the user should hear of.
    const auto types = cell_array(p, VtuRole::types, "types", cells);
    if (!types) return types.error();
    for (std::size_t i = 0; i < cells; ++i) {
      if ((*types)[i] == kVtkTetra) continue;
      return complain(piece.position, "cell " + std::to_string(i) + " is of VTK type " +
                                          std::to_string((*types)[i]) +
                                          "; only tetrahedra (10) can be read");
    }
    const auto offsets = cell_array(p, VtuRole::offsets, "offsets", cells);
    if (!offsets) return offsets.error();
    const auto corners = cell_array(p, VtuRole::connectivity, "connectivity", 4 * cells);
    if (!corners) return corners.error();
    if (model_.tets.empty()) model_.tets.reserve(cells);
    for (std::size_t i = 0; i < cells; ++i) {
      if ((*offsets)[i] != static_cast<std::int64_t>(4 * (i + 1))) {
        return complain(piece.position,
                        "cell " + std::to_string(i) + " does not have four corners");
      }
      TetVertices tet;
      for (std::size_t k = 0; k < 4; ++k) {
        const std::int64_t corner = (*corners)[4 * i + k];
        if (corner < 0 || corner >= piece.points) {
          return complain(piece.position, "cell " + std::to_string(i) + " refers to point " +
                                              std::to_string(corner) + " of " +
                                              std::to_string(piece.points));
        }
        tet[k] = VertexId(first_point + static_cast<std::size_t>(corner));
      }
      model_.tets.push_back(tet);
    }
    return {};
  }

  Result<void> read_text(std::string_view name) {
    const auto bytes = bytes_of_column(grid_, scanner_, name);
    if (!bytes) return bytes.error();
    if (*bytes) set_text(model_, name, **bytes);
    return {};
  }

  Result<void> read_texts() {
    for (const std::string_view array : kTextArrays) {
      if (Result<void> done = read_text(array); !done) return done;
    }
    return {};
  }

  // Where the points are no longer those that were placed, the model stays as it lies.
  Result<void> read_frame() {
    const DataArray* const array = grid_.find_column(kFrameArray);
    if (array == nullptr || !is_float(array->type)) return {};
    const auto numbers = read_doubles(*array, grid_.source, scanner_);
    if (!numbers) return numbers.error();
    const auto finite = [](double x) { return std::isfinite(x); };
    if (numbers->size() != kFrameNumbers || !std::all_of(numbers->begin(), numbers->end(), finite))
      return {};
    std::vector<double> points;
    for (std::size_t p = 0; p < grid_.pieces.size(); ++p) {
      const DataArray* const found = grid_.find(p, VtuRole::stack_point);
      if (found == nullptr || !is_float(found->type) || found->components != 3) continue;
      const auto values = read_doubles(*found, grid_.source, scanner_);
      if (!values) return values.error();
      points.insert(points.end(), values->begin(), values->end());
    }
    if (!std::all_of(points.begin(), points.end(), finite)) return {};
    const Frame frame = frame_of(*numbers);
    if (take_back(frame, points, model_.points)) model_.frame = frame;
    return {};
  }

  // The values of one field over all pieces, or nothing where a piece lacks it, or where it is
  // another writer's array of that name: of floats, of vectors, or with a value out of range.
  template <class Field>
  Result<std::optional<std::vector<std::int64_t>>> field_values(const Field& field) {
    using Found = std::optional<std::vector<std::int64_t>>;
    std::vector<std::int64_t> all;
    all.reserve(Field::due(model_));
    for (std::size_t p = 0; p < grid_.pieces.size(); ++p) {
      const VtuPiece& piece = grid_.pieces[p];
      const auto count = static_cast<std::size_t>(Field::kOfPoints ? piece.points : piece.cells);
      const DataArray* const found = grid_.find(p, VtuRole::field, field.name);
      if (found == nullptr && count == 0) continue;
      if (found == nullptr) return Found();
      const DataArray& array = *found;
      if (is_float(array.type) || array.components != 1) return Found();
      const auto values = read_integers(array, grid_.source, scanner_);
      if (!values) return values.error();
      if (values->size() != count) {
        return complain(array.position, "the data array " + std::string(field.name) + " has " +
                                            std::to_string(values->size()) + " values where " +
                                            std::to_string(count) + " are due");
      }
      for (const std::int64_t value : *values) {
        if (value < Field::Stored::kLeast || value > Field::Stored::kLargest) return Found();
      }
      all.insert(all.end(), values->begin(), values->end());
    }
    return Found(std::move(all));
  }

  template <class Field>
  Result<void> read_field(const Field& field) {
    auto values = field_values(field);
    if (!values) return values.error();
    if (!values->has_value()) return {};
    auto& target = model_.*field.values;
    target.reserve((*values)->size());
    for (const std::int64_t value : **values) target.push_back(Field::Stored::load(value));
    return {};
  }

  Result<void> read_fields() {
    Result<void> done;
    for_each_field([&](const auto& field) {
      if (done) done = read_field(field);
    });
    count_components(model_);
    return done;
  }

  // Nothing where a column is missing or another writer's array of that name.
  template <class Table>
  Result<void> read_table(const Table& table) {
    bool complete = true;
    for_each_column(table, [&](const auto& column) {
      using Type = typename std::remove_cvref_t<decltype(column)>::Stored::Type;
      const DataArray* const array = grid_.find_column(column.name);
      complete = complete && array != nullptr && array->components == 1 &&
                 is_float(array->type) == std::is_floating_point_v<Type>;
    });
    if (!complete) return {};
    std::optional<std::vector<typename Table::Row>> rows;
    Result<bool> meant = true;
    for_each_column(table, [&](const auto& column) {
      if (meant && *meant) meant = read_column(*grid_.find_column(column.name), column, rows);
    });
    if (!meant) return meant.error();
    if (*meant) model_.*table.rows = *std::move(rows);
    return {};
  }

  // Whether all its values are some of this column; the first says how many rows there are.
  template <class Column, class Row>
  Result<bool> read_column(const DataArray& array, const Column& column,
                           std::optional<std::vector<Row>>& rows) {
    using Stored = typename Column::Stored;
    const auto values = [&] {
      if constexpr (std::is_floating_point_v<typename Stored::Type>) {
        return read_doubles(array, grid_.source, scanner_);
      } else {
        return read_integers(array, grid_.source, scanner_);
      }
    }();
    if (!values) return values.error();
    const std::size_t due = array.tuples.value_or(rows ? rows->size() : values->size());
    if (values->size() != due || (rows && rows->size() != due)) {
      return complain(array.position, "the data array " + std::string(column.name) + " has " +
                                          std::to_string(values->size()) + " values where " +
                                          std::to_string(rows ? rows->size() : due) + " are due");
    }
    if (!rows) rows.emplace(due);
    for (std::size_t i = 0; i < rows->size(); ++i) {
      if constexpr (std::is_floating_point_v<typename Stored::Type>) {
        if (!Stored::legal((*values)[i])) return false;
      } else {
        if ((*values)[i] < Stored::kLeast || (*values)[i] > Stored::kLargest) return false;
      }
      column.set((*rows)[i], Stored::load((*values)[i]));
    }
    return true;
  }

  const VtuDeclaration& grid_;
  const XmlScanner& scanner_;
  Model model_;
};

}  // namespace

Result<ReadModel> read_vtu_source(const Source& source, const ReadOptions& /*options*/) {
  XmlScanner scanner(source.bytes, source.name);
  const Result<VtuDeclaration> grid = scan_vtu(scanner);
  if (!grid) return grid.error();
  Result<Model> model = GridDecoder(*grid, scanner).decode();
  if (!model) return model.error();
  return ReadModel{*std::move(model), {}};
}

Result<PieceBytes> piece_bytes(std::string_view file, const std::string& name) {
  XmlScanner scanner(file, name);
  const Result<VtuDeclaration> grid = scan_vtu(scanner);
  if (!grid) return grid.error();
  std::vector<const DataArray*> arrays;
  if (const DataArray* const array = grid->find_column(kPieceArray)) arrays.push_back(array);
  Result<void> unpacked = check_unpacking(arrays, grid->source, kGridUnpacked, scanner);
  if (!unpacked) return unpacked.error();
  auto bytes = bytes_of_column(*grid, scanner, kPieceArray);
  if (!bytes) return bytes.error();
  if (!*bytes) {
    Error error{ErrorCode::invalid_input, "it is a mesh, but no piece of a planned stack", {}};
    error.where.file = name;
    return error;
  }
  PieceBytes piece{**std::move(bytes)};
  for (const VtuPiece& part : grid->pieces) {
    piece.points += static_cast<std::size_t>(part.points);
    piece.tets += static_cast<std::size_t>(part.cells);
  }
  return piece;
}

}  // namespace tetloft::internal::io

// VTK XML unstructured grids (.vtu) of tetrahedra, by tetloft and other writers: first the
// declarations are scanned, then the arrays decoded and compared with what they announce.
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <tetloft/io.hpp>

#include "core/check.hpp"
#include "io/cursor.hpp"
#include "io/files.hpp"
#include "io/numbers.hpp"
#include "io/vtk_data.hpp"
#include "io/xml.hpp"

namespace tetloft {

namespace {

using io::DataArray;
using io::DataSource;
using io::XmlScanner;
using io::XmlTag;

constexpr std::int64_t kVtkTetra = 10;

// Half-faces 4 t + i must fit into 32 bits (tet_mesh.hpp).
constexpr std::size_t kTetLimit = std::size_t{1} << 30;

struct PieceDeclaration {
  std::size_t position = 0;
  std::int64_t points = 0;
  std::int64_t cells = 0;
  std::optional<DataArray> coordinates;
  std::map<std::string, DataArray> cell_arrays;  // connectivity, offsets, types
  std::map<std::string, DataArray> point_data;
  std::map<std::string, DataArray> cell_data;
};

struct GridDeclaration {
  DataSource source;
  std::vector<PieceDeclaration> pieces;
};

// Scans the file's tags up to the appended data.
class DeclarationScanner {
 public:
  explicit DeclarationScanner(XmlScanner& scanner) : scanner_(scanner) {}

  Result<GridDeclaration> scan() {
    for (;;) {
      const Result<XmlTag> tag = scanner_.next_tag();
      if (!tag) return tag.error();
      if (tag->kind == XmlTag::Kind::end_of_file) break;
      if (!seen_root_ && tag->name != "VTKFile") {
        return scanner_.complain(tag->position, "this is no VTK XML file");
      }
      if (tag->name == "AppendedData" && tag->kind == XmlTag::Kind::open) {
        if (Result<void> taken = take_appended(*tag); !taken) return taken.error();
        break;
      }
      if (Result<void> taken = take(*tag); !taken) return taken.error();
    }
    if (!seen_root_) return scanner_.complain(0, "this is no VTK XML file");
    if (grid_.pieces.empty()) return scanner_.complain(0, "the file holds no Piece");
    return std::move(grid_);
  }

 private:
  Result<void> take(const XmlTag& tag) {
    if (tag.kind == XmlTag::Kind::close) {
      if (tag.name == group_) group_.clear();
      return {};
    }
    if (tag.name == "VTKFile") return take_root(tag);
    if (tag.name == "Piece") return take_piece(tag);
    if (tag.name == "DataArray") return take_array(tag);
    if (tag.name == "Points" || tag.name == "Cells" || tag.name == "PointData" ||
        tag.name == "CellData" || tag.name == "FieldData") {
      group_ = tag.kind == XmlTag::Kind::open ? std::string(tag.name) : std::string();
    }
    return {};
  }

  Result<void> take_root(const XmlTag& tag) {
    seen_root_ = true;
    const std::string* const type = tag.find("type");
    if (type == nullptr || *type != "UnstructuredGrid") {
      return scanner_.complain(tag.position,
                               "this VTK file is no UnstructuredGrid" +
                                   (type == nullptr ? "" : " but " + io::in_quotes(*type)));
    }
    const std::string* const order = tag.find("byte_order");
    grid_.source.little_endian = order == nullptr || *order == "LittleEndian";
    const std::string* const header = tag.find("header_type");
    if (header != nullptr && *header != "UInt32" && *header != "UInt64") {
      return scanner_.complain(tag.position, "unknown header_type " + io::in_quotes(*header));
    }
    grid_.source.header_bytes = header != nullptr && *header == "UInt64" ? 8 : 4;
    if (const std::string* compressor = tag.find("compressor")) {
      grid_.source.compressor = *compressor;
    }
    return {};
  }

  Result<void> take_piece(const XmlTag& tag) {
    PieceDeclaration piece;
    piece.position = tag.position;
    for (const auto& [key, count] :
         {std::pair{"NumberOfPoints", &piece.points}, std::pair{"NumberOfCells", &piece.cells}}) {
      const std::string* const text = tag.find(key);
      const auto value = text == nullptr ? std::nullopt : io::parse_integer(*text);
      if (!value || *value < 0) {
        return scanner_.complain(tag.position, std::string("the piece has no valid ") + key);
      }
      *count = *value;
    }
    grid_.pieces.push_back(std::move(piece));
    return {};
  }

  Result<void> take_array(const XmlTag& tag) {
    // Arrays outside of a piece, and of no group that is read, may have any type.
    if (grid_.pieces.empty() || group_.empty() || group_ == "FieldData") return {};
    const std::string* const type = tag.find("type");
    const bool data = group_ == "PointData" || group_ == "CellData";
    if (data && type != nullptr && (*type == "String" || *type == "Bit")) return {};
    Result<DataArray> array = io::declare_array(tag, scanner_);
    if (!array) return array.error();
    if (tag.kind == XmlTag::Kind::open) array->text = scanner_.take_text();
    PieceDeclaration& piece = grid_.pieces.back();
    const std::string name = array->name;
    if (group_ == "Points") {
      piece.coordinates = *std::move(array);
    } else {
      auto& arrays = group_ == "Cells"       ? piece.cell_arrays
                     : group_ == "PointData" ? piece.point_data
                                             : piece.cell_data;
      arrays[name] = *std::move(array);
    }
    return {};
  }

  Result<void> take_appended(const XmlTag& tag) {
    const std::string* const encoding = tag.find("encoding");
    if (encoding == nullptr || (*encoding != "raw" && *encoding != "base64")) {
      return scanner_.complain(tag.position, "the appended data have no known encoding");
    }
    grid_.source.appended_base64 = *encoding == "base64";
    std::string_view rest = scanner_.rest();
    while (!rest.empty() && io::is_white(rest.front())) rest.remove_prefix(1);
    if (rest.empty() || rest.front() != '_') {
      return scanner_.complain(tag.position, "the appended data do not begin with '_'");
    }
    grid_.source.appended = rest.substr(1);
    return {};
  }

  XmlScanner& scanner_;
  GridDeclaration grid_;
  bool seen_root_ = false;
  std::string group_;  // the element that holds the arrays now met; empty: none
};

class GridDecoder {
 public:
  GridDecoder(const GridDeclaration& grid, const XmlScanner& scanner)
      : grid_(grid), scanner_(scanner) {}

  Result<Model> decode() {
    for (const PieceDeclaration& piece : grid_.pieces) {
      const std::size_t first_point = model_.points.size();
      if (Result<void> points = add_points(piece); !points) return points.error();
      if (Result<void> tets = add_tets(piece, first_point); !tets) return tets.error();
    }
    if (Result<void> labels = read_labels(); !labels) return labels.error();
    return std::move(model_);
  }

 private:
  using Arrays = std::map<std::string, DataArray>;

  [[nodiscard]] Error complain(std::size_t position, const std::string& message) const {
    return scanner_.complain(position, message);
  }

  Result<void> add_points(const PieceDeclaration& piece) {
    if (!piece.coordinates) {
      if (piece.points == 0) return {};
      return complain(piece.position, "the piece has no Points");
    }
    const DataArray& array = *piece.coordinates;
    const auto values = io::read_doubles(array, grid_.source, scanner_);
    if (!values) return values.error();
    if (array.components != 3 || values->size() % 3 != 0 ||
        values->size() / 3 != static_cast<std::size_t>(piece.points)) {
      return complain(array.position, "Points hold " + std::to_string(values->size()) +
                                          " numbers where three each are due for " +
                                          std::to_string(piece.points) + " points");
    }
    for (std::size_t i = 0; i < values->size(); i += 3) {
      const Point3 p{(*values)[i], (*values)[i + 1], (*values)[i + 2]};
      if (!std::isfinite(p.x) || !std::isfinite(p.y) || !std::isfinite(p.z)) {
        Error error = complain(array.position, "a coordinate is not finite");
        error.where.vertex = model_.points.size();
        return error;
      }
      model_.points.push_back(p);
    }
    if (model_.points.size() >= VertexId::kInvalid) {
      return complain(piece.position, "the file holds too many points");
    }
    return {};
  }

  // One of the three arrays of Cells. Without cells it may be missing.
  Result<std::vector<std::int64_t>> cell_array(const PieceDeclaration& piece, const char* name,
                                               std::size_t expected) {
    const auto found = piece.cell_arrays.find(name);
    if (found == piece.cell_arrays.end()) {
      if (expected == 0) return std::vector<std::int64_t>();
      return complain(piece.position, std::string("the piece has no cell array ") + name);
    }
    auto values = io::read_integers(found->second, grid_.source, scanner_);
    if (values && values->size() != expected) {
      return complain(found->second.position, std::string("the cell array ") + name + " has " +
                                                  std::to_string(values->size()) +
                                                  " values where " + std::to_string(expected) +
                                                  " are due");
    }
    return values;
  }

  Result<void> add_tets(const PieceDeclaration& piece, std::size_t first_point) {
    const auto cells = static_cast<std::size_t>(piece.cells);
    if (cells >= kTetLimit || model_.tets.size() + cells >= kTetLimit) {
      return complain(piece.position, "the file announces too many cells");
    }
    // Types first: in a grid of mixed cells that is what the user should hear of.
    const auto types = cell_array(piece, "types", cells);
    if (!types) return types.error();
    for (std::size_t i = 0; i < cells; ++i) {
      if ((*types)[i] == kVtkTetra) continue;
      return complain(piece.position, "cell " + std::to_string(i) + " is of VTK type " +
                                          std::to_string((*types)[i]) +
                                          "; only tetrahedra (10) can be read");
    }
    const auto offsets = cell_array(piece, "offsets", cells);
    if (!offsets) return offsets.error();
    const auto corners = cell_array(piece, "connectivity", 4 * cells);
    if (!corners) return corners.error();
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

  // The values of one data array over all pieces, or nothing where a piece lacks it, or
  // where it is another writer's array of that name: of floats, of vectors, or with a value
  // outside [least, largest].
  Result<std::optional<std::vector<std::int64_t>>> data_array(Arrays PieceDeclaration::*arrays,
                                                              std::int64_t PieceDeclaration::*count,
                                                              const char* name, std::int64_t least,
                                                              std::int64_t largest) {
    using Found = std::optional<std::vector<std::int64_t>>;
    std::vector<std::int64_t> all;
    for (const PieceDeclaration& piece : grid_.pieces) {
      const auto found = (piece.*arrays).find(name);
      if (found == (piece.*arrays).end()) return Found();
      const DataArray& array = found->second;
      if (io::is_float(array.type) || array.components != 1) return Found();
      const auto values = io::read_integers(array, grid_.source, scanner_);
      if (!values) return values.error();
      if (values->size() != static_cast<std::size_t>(piece.*count)) {
        return complain(array.position, std::string("the data array ") + name + " has " +
                                            std::to_string(values->size()) + " values where " +
                                            std::to_string(piece.*count) + " are due");
      }
      for (const std::int64_t value : *values) {
        if (value < least || value > largest) return Found();
      }
      all.insert(all.end(), values->begin(), values->end());
    }
    return Found(std::move(all));
  }

  template <class IdVectorType, class Convert>
  Result<void> read_label(IdVectorType& target, bool of_points, const char* name,
                          std::int64_t least, std::int64_t largest, Convert convert) {
    auto values = data_array(
        of_points ? &PieceDeclaration::point_data : &PieceDeclaration::cell_data,
        of_points ? &PieceDeclaration::points : &PieceDeclaration::cells, name, least, largest);
    if (!values) return values.error();
    if (!values->has_value()) return {};
    target.reserve((*values)->size());
    for (const std::int64_t value : **values) target.push_back(convert(value));
    return {};
  }

  Result<void> read_labels() {
    constexpr std::int64_t kLargest = std::numeric_limits<std::int32_t>::max();
    const auto to_component = [&](std::int64_t value) {
      if (value < 0) return ComponentId();
      model_.component_count =
          std::max(model_.component_count, static_cast<std::size_t>(value) + 1);
      return ComponentId(value);
    };
    const auto to_slab = [](std::int64_t value) { return value < 0 ? SlabId() : SlabId(value); };
    const auto to_kind = [](std::int64_t value) { return static_cast<TetKind>(value); };
    const auto to_origin = [](std::int64_t value) { return static_cast<PointOrigin>(value); };
    const auto to_int = [](std::int64_t value) { return static_cast<std::int32_t>(value); };
    Result<void> done =
        read_label(model_.component, false, "component", -1, kLargest, to_component);
    if (done) done = read_label(model_.slab, false, "slab", -1, kLargest, to_slab);
    if (done) done = read_label(model_.kind, false, "kind", 0, kTetKinds - 1, to_kind);
    if (done) done = read_label(model_.section, true, "section", -1, kLargest, to_int);
    if (done) done = read_label(model_.contour, true, "contour", -1, kLargest, to_int);
    if (done) done = read_label(model_.origin, true, "origin", 0, kPointOrigins - 1, to_origin);
    return done;
  }

  const GridDeclaration& grid_;
  const XmlScanner& scanner_;
  Model model_;
};

}  // namespace

Result<Model> parse_vtu(std::string_view bytes, const std::string& name) {
  return guard_internal([&]() -> Result<Model> {
    XmlScanner scanner(bytes, name);
    const Result<GridDeclaration> grid = DeclarationScanner(scanner).scan();
    if (!grid) return grid.error();
    return GridDecoder(*grid, scanner).decode();
  });
}

Result<Model> read_vtu(const std::string& path) {
  return guard_internal([&]() -> Result<Model> {
    const Result<std::string> bytes = io::read_file(path);
    if (!bytes) return bytes.error();
    return parse_vtu(*bytes, path);
  });
}

}  // namespace tetloft

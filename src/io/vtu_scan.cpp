// Scanning the tags of unstructured grids (VTK File Formats, "XML File Formats").
#include "io/vtu_scan.hpp"

#include <algorithm>
#include <optional>
#include <set>
#include <string>
#include <type_traits>
#include <utility>

#include "io/numbers.hpp"
#include "io/vtk_text.hpp"
#include "io/vtu_frame.hpp"
#include "io/vtu_piece.hpp"
#include "model/fields.hpp"
#include "model/tables.hpp"

namespace tetloft::internal::io {

namespace {

// Grids are nested five deep; those of other writers have keys inside of arrays.
constexpr std::size_t kDeepest = 64;

// An array that is read: the group it stands in, and its name.
struct KnownArray {
  std::string_view group;
  std::string_view name;
  VtuRole role;
};

std::optional<KnownArray> known_array(std::string_view group, std::string_view name) {
  constexpr std::array<KnownArray, 3> kOfCells{{{"Cells", "connectivity", VtuRole::connectivity},
                                                {"Cells", "offsets", VtuRole::offsets},
                                                {"Cells", "types", VtuRole::types}}};
  if (group == "Points") return KnownArray{group, "Points", VtuRole::points};
  for (const KnownArray& known : kOfCells) {
    if (known.group == group && known.name == name) return known;
  }
  if (group == "PointData" && name == kStackPointArray) {
    return KnownArray{group, kStackPointArray, VtuRole::stack_point};
  }
  if (group == "FieldData" && name == kFrameArray) {
    return KnownArray{group, kFrameArray, VtuRole::column};
  }
  std::optional<KnownArray> found;
  for_each_field([&](const auto& field) {
    using Field = std::remove_cvref_t<decltype(field)>;
    if (group == (Field::kOfPoints ? "PointData" : "CellData") && name == field.name) {
      found = KnownArray{group, field.name, VtuRole::field};
    }
  });
  if (group != "FieldData") return found;
  if (name == kPieceArray) return KnownArray{group, kPieceArray, VtuRole::column};
  for (const std::string_view text : kTextArrays) {
    if (name == text) found = KnownArray{group, text, VtuRole::column};
  }
  for_each_table([&](const auto& table) {
    for_each_column(table, [&](const auto& column) {
      if (name == column.name) found = KnownArray{group, column.name, VtuRole::column};
    });
  });
  return found;
}

constexpr std::array<std::string_view, 4> kGroups{"Points", "Cells", "PointData", "CellData"};

std::string quoted_tag(std::string_view name) { return in_quotes('<' + std::string(name) + '>'); }

class VtuScanner {
 public:
  explicit VtuScanner(XmlScanner& scanner) : scanner_(scanner) {}

  Result<VtuDeclaration> scan() {
    for (;;) {
      const Result<XmlTag> tag = scanner_.next_tag();
      if (!tag) return tag.error();
      if (tag->kind == XmlTag::Kind::end_of_file) break;
      Result<void> taken = tag->kind == XmlTag::Kind::close ? close(*tag) : open(*tag);
      if (!taken) return taken.error();
    }
    if (!seen_root_) return scanner_.complain(0, "this is no VTK XML file");
    if (!open_.empty()) {
      return scanner_.complain(
          scanner_.position(),
          "the file ends inside of " + quoted_tag(open_.back()) + ": its end is missing");
    }
    if (grid_.pieces.empty()) return scanner_.complain(0, "the file holds no Piece");
    return std::move(grid_);
  }

 private:
  Result<void> open(const XmlTag& tag) {
    if (open_.empty()) {
      if (tag.name != "VTKFile") {
        return scanner_.complain(tag.position, seen_root_ ? "something follows the end of the grid"
                                                          : "this is no VTK XML file");
      }
      if (seen_root_) return scanner_.complain(tag.position, "the file holds two grids");
    }
    if (open_.size() >= kDeepest) {
      return scanner_.complain(
          tag.position, "the tags are nested more than " + std::to_string(kDeepest) + " deep");
    }
    Result<void> taken = take(tag);
    if (taken && tag.kind == XmlTag::Kind::open) open_.push_back(tag.name);
    return taken;
  }

  Result<void> close(const XmlTag& tag) {
    if (open_.empty() || open_.back() != tag.name) {
      return scanner_.complain(tag.position,
                               "the tag " + quoted_tag('/' + std::string(tag.name)) +
                                   (open_.empty() ? " closes nothing" : " does not close ") +
                                   (open_.empty() ? std::string() : quoted_tag(open_.back())));
    }
    open_.pop_back();
    return {};
  }

  // The element that holds what comes next, `up` levels above it.
  [[nodiscard]] std::string_view inside(std::size_t up = 0) const {
    return up < open_.size() ? open_[open_.size() - 1 - up] : std::string_view();
  }

  Result<void> take(const XmlTag& tag) {
    if (tag.name == "VTKFile") return take_root(tag);
    if (tag.name == "Piece") return take_piece(tag);
    if (tag.name == "AppendedData") return take_appended_data(tag, scanner_, grid_.source);
    if (inside() == "Piece") return take_group(tag);
    const bool of_whole = inside(1) == "UnstructuredGrid" && inside() == "FieldData";
    if (tag.name == "FieldData" && inside() == "UnstructuredGrid") return take_field_data(tag);
    const bool in_group = std::find(kGroups.begin(), kGroups.end(), inside()) != kGroups.end();
    if (tag.name == "DataArray" && ((in_group && inside(1) == "Piece") || of_whole)) {
      return take_array(tag);
    }
    return {};
  }

  Result<void> take_root(const XmlTag& tag) {
    if (!open_.empty()) return scanner_.complain(tag.position, "the file holds two grids");
    seen_root_ = true;
    Result<DataSource> source = declare_source(tag, "UnstructuredGrid", scanner_);
    if (!source) return source.error();
    grid_.source = *std::move(source);
    return {};
  }

  Result<void> take_piece(const XmlTag& tag) {
    if (std::find(open_.begin(), open_.end(), "Piece") != open_.end()) {
      return scanner_.complain(tag.position, "a piece stands inside of another");
    }
    VtuPiece piece;
    piece.position = tag.position;
    piece.first_array = grid_.arrays.size();
    for (const auto& [key, count] :
         {std::pair{"NumberOfPoints", &piece.points}, std::pair{"NumberOfCells", &piece.cells}}) {
      const std::string* const text = tag.find(key);
      const auto value = text == nullptr ? std::nullopt : parse_integer(*text);
      if (!value || *value < 0) {
        return scanner_.complain(tag.position, std::string("the piece has no valid ") + key);
      }
      *count = *value;
    }
    grid_.pieces.push_back(piece);
    seen_groups_ = {};
    return {};
  }

  Result<void> take_group(const XmlTag& tag) {
    const auto group = std::find(kGroups.begin(), kGroups.end(), tag.name);
    if (group == kGroups.end()) return {};
    bool& seen = seen_groups_[static_cast<std::size_t>(group - kGroups.begin())];
    if (seen) {
      return scanner_.complain(tag.position, "the piece has two elements " + in_quotes(tag.name));
    }
    seen = true;
    names_.clear();
    return {};
  }

  Result<void> take_field_data(const XmlTag& tag) {
    if (seen_field_data_) {
      return scanner_.complain(tag.position, "the grid has two elements 'FieldData'");
    }
    seen_field_data_ = true;
    names_.clear();
    return {};
  }

  Result<void> take_array(const XmlTag& tag) {
    const std::string_view group = inside();
    const std::string* const name = tag.find("Name");
    const bool is_points = group == "Points";
    // Arrays without a name are several of none. Of Points there is one, whatever its name.
    const std::string key = is_points ? "Points" : name != nullptr ? *name : std::string();
    if (!key.empty() && !names_.insert(key).second) {
      return scanner_.complain(tag.position, in_quotes(group) + " has two arrays" +
                                                 (is_points ? "" : ' ' + in_quotes(key)));
    }
    const std::optional<KnownArray> known = known_array(group, key);
    if (!known) return {};
    // Another writer's array of that name may have any type.
    const std::string* const type = tag.find("type");
    const bool text = type != nullptr && (*type == "String" || *type == "Bit");
    const bool of_grid = known->role != VtuRole::field && known->role != VtuRole::column &&
                         known->role != VtuRole::stack_point;
    if (text && !of_grid) return {};
    VtuArray array{known->role, {}};
    Result<DataArray> declared = declare_array(tag, known->name, scanner_);
    if (!declared) return declared.error();
    array.data = *declared;
    if (tag.kind == XmlTag::Kind::open) array.data.text = scanner_.take_text();
    if (array.role == VtuRole::column) {
      grid_.columns.push_back(array.data);
    } else {
      grid_.arrays.push_back(array);
    }
    return {};
  }

  XmlScanner& scanner_;
  VtuDeclaration grid_;
  bool seen_root_ = false;
  std::vector<std::string_view> open_;              // elements not closed yet, outermost first
  std::array<bool, kGroups.size()> seen_groups_{};  // in the piece
  bool seen_field_data_ = false;
  std::set<std::string> names_;  // of the arrays in the group
};

}  // namespace

const DataArray* VtuDeclaration::find(std::size_t piece, VtuRole role,
                                      std::string_view field) const {
  const std::size_t end = piece + 1 < pieces.size() ? pieces[piece + 1].first_array : arrays.size();
  for (std::size_t i = pieces[piece].first_array; i < end; ++i) {
    if (arrays[i].role != role) continue;
    if (role != VtuRole::field || arrays[i].data.name == field) return &arrays[i].data;
  }
  return nullptr;
}

const DataArray* VtuDeclaration::find_column(std::string_view name) const {
  const auto found = std::find_if(columns.begin(), columns.end(),
                                  [&](const DataArray& array) { return array.name == name; });
  return found == columns.end() ? nullptr : &*found;
}

Result<VtuDeclaration> scan_vtu(XmlScanner& scanner) { return VtuScanner(scanner).scan(); }

}  // namespace tetloft::internal::io

// What the tags of a .vtu announce, before any array is decoded.
//
// A file is well-formed as far as it is looked at: elements close in the order they opened,
// none is missing at the end, so that no part of a file passes for the whole; and what may stand
// once stands once. Only arrays that are read are kept, a few words each.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>
#include <vector>

#include <tetloft/result.hpp>

#include "io/vtk_data.hpp"
#include "io/xml.hpp"

namespace tetloft::internal::io {

enum class VtuRole : std::uint8_t {
  points,
  connectivity,
  offsets,
  types,
  field,
  stack_point,
  column
};

struct VtuArray {
  VtuRole role = VtuRole::points;
  DataArray data;  ///< its name tells which field
};

struct VtuPiece {
  std::size_t position = 0;  ///< of its tag
  std::int64_t points = 0;
  std::int64_t cells = 0;
  std::size_t first_array = 0;  ///< its arrays end where those of the next piece begin
};

struct VtuDeclaration {
  DataSource source;
  std::vector<VtuPiece> pieces;
  std::vector<VtuArray> arrays;
  std::vector<DataArray> columns;  ///< of the model's tables, and its texts: data of all

  /// The array of a piece, or null.
  [[nodiscard]] const DataArray* find(std::size_t piece, VtuRole role,
                                      std::string_view field = {}) const;
  [[nodiscard]] const DataArray* find_column(std::string_view name) const;
};

/// Scans all tags. The scanner must outlive the result.
[[nodiscard]] Result<VtuDeclaration> scan_vtu(XmlScanner& scanner);

}  // namespace tetloft::internal::io

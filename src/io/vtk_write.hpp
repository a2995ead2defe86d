// The part that all VTK XML files share: a head of DataArray elements, and their values as
// text inside them or as bytes in one appended block (raw, UInt64 byte counts).
#pragma once

#include <concepts>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <type_traits>
#include <vector>

#include <tetloft/io.hpp>

#include "io/bytes.hpp"
#include "io/numbers.hpp"
#include "io/pending_file.hpp"

namespace tetloft::io {

template <class T>
constexpr const char* vtk_type_name() {
  if constexpr (std::same_as<T, double>) return "Float64";
  if constexpr (std::same_as<T, std::int32_t>) return "Int32";
  if constexpr (std::same_as<T, std::int64_t>) return "Int64";
  if constexpr (std::same_as<T, std::uint8_t>) return "UInt8";
  return nullptr;
}

/// One array: its declaration, and how to produce its values piece by piece.
struct VtkArray {
  std::string name;
  std::string type;
  std::size_t components = 1;
  std::size_t bytes = 0;
  std::function<void(PendingFile&)> append_text;
  std::function<void(PendingFile&)> append_bytes;
};

/// An array of n values of type T; get(i) is value i. get must live as long as the array.
template <class T, class Get>
VtkArray vtk_array(std::string name, std::size_t components, std::size_t n, Get get) {
  static_assert(std::same_as<T, std::remove_cvref_t<decltype(get(std::size_t{0}))>>);
  // Pieces large enough to make the calls cheap, small beside the array.
  constexpr std::size_t kPiece = std::size_t{1} << 16;
  VtkArray array{std::move(name), vtk_type_name<T>(), components, n * sizeof(T), {}, {}};
  array.append_text = [n, components, get](PendingFile& file) {
    std::string piece;
    for (std::size_t i = 0; i < n; ++i) {
      if constexpr (sizeof(T) == 1) {
        append_number(piece, static_cast<int>(get(i)));
      } else {
        append_number(piece, get(i));
      }
      piece += (i + 1) % (components == 1 ? 16 : components) == 0 || i + 1 == n ? '\n' : ' ';
      if (piece.size() >= kPiece) {
        file.append(piece);
        piece.clear();
      }
    }
    file.append(piece);
  };
  array.append_bytes = [n, get](PendingFile& file) {
    std::string piece;
    for (std::size_t i = 0; i < n; ++i) {
      append_little<T>(piece, get(i));
      if (piece.size() >= kPiece) {
        file.append(piece);
        piece.clear();
      }
    }
    file.append(piece);
  };
  return array;
}

/// An element that holds arrays: PointData, Cells, …
struct VtkGroup {
  std::string element;
  std::vector<VtkArray> arrays;
};

/// Writes a file of one piece; `counts` are the attributes of Piece. Does not commit.
void append_vtk_file(PendingFile& file, const std::string& grid_type, const std::string& counts,
                     const std::vector<VtkGroup>& groups, Encoding encoding);

}  // namespace tetloft::io

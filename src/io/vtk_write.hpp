// The part that all VTK XML files share: a head of DataArray elements, and their values as
// text inside them or as bytes in one appended block (UInt64 byte counts): raw, as base64 where raw
// ones would mislead a reader, or packed by zlib in blocks.
#pragma once

#include <algorithm>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include <tetloft/io.hpp>

#include "core/little_endian.hpp"
#include "io/numbers.hpp"
#include "io/sink.hpp"

namespace tetloft::internal::io {

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
  std::size_t tuples = 0;
  std::size_t value_bytes = 1;  ///< of each value
  std::size_t bytes = 0;        ///< of all
  std::function<void(Sink&)> append_text;
  std::function<void(Sink&)> append_bytes;
};

/// An array of n values of type T; get(i) is value i. get must live as long as the array.
template <class T, class Get>
VtkArray vtk_array(std::string name, std::size_t components, std::size_t n, Get get) {
  static_assert(std::same_as<T, std::remove_cvref_t<decltype(get(std::size_t{0}))>>);
  VtkArray array{std::move(name), vtk_type_name<T>(), components, n / components,
                 sizeof(T),       n * sizeof(T),      {},         {}};
  array.append_text = [n, components, get](Sink& sink) {
    Pieces pieces(sink);
    std::string& piece = pieces.text();
    for (std::size_t i = 0; i < n; ++i) {
      if constexpr (sizeof(T) == 1) {
        append_number(piece, static_cast<int>(get(i)));
      } else {
        append_number(piece, get(i));
      }
      piece += (i + 1) % (components == 1 ? 16 : components) == 0 || i + 1 == n ? '\n' : ' ';
      pieces.next();
    }
    pieces.finish();
  };
  array.append_bytes = [n, get](Sink& sink) {
    constexpr std::size_t kValues = std::size_t{1} << 13;  // of a piece
    std::string piece;
    for (std::size_t first = 0; first < n; first += kValues) {
      const std::size_t count = std::min(n - first, kValues);
      piece.resize(count * sizeof(T));
      for (std::size_t k = 0; k < count; ++k) {
        store_little<T>(piece.data() + k * sizeof(T), get(first + k));
      }
      sink.append(piece);
    }
  };
  return array;
}

/// An element that holds arrays: PointData, Cells, …
struct VtkGroup {
  std::string element;
  std::vector<VtkArray> arrays;
};

/// The element Points, of n points; get(i) is a Point3.
template <class Get>
VtkGroup vtk_points(std::size_t n, Get get) {
  VtkGroup group{"Points", {}};
  group.arrays.push_back(vtk_array<double>("Points", 3, 3 * n, [get](std::size_t i) {
    const Point3& p = get(i / 3);
    return i % 3 == 0 ? p.x : i % 3 == 1 ? p.y : p.z;
  }));
  return group;
}

/// Whether a file begins as VTK XML of this grid type.
[[nodiscard]] bool is_vtk_file(std::string_view bytes, std::string_view grid_type);

/// A file of one piece.
struct VtkFile {
  std::string grid_type;
  std::string counts;                    ///< the attributes of Piece
  VtkGroup field_data{"FieldData", {}};  ///< about the whole; left out where empty
  std::vector<VtkGroup> groups;          ///< of the piece
  /// How many times the file's size the reader takes when packed data are unpacked.
  std::size_t most_unpacked = 0;
};

/// Packed data are in memory, as a whole, before the first byte is written. A file whose reader
/// would not take what it unpacks to is written plain, with a warning.
[[nodiscard]] std::vector<Warning> append_vtk_file(Sink& sink, const VtkFile& file,
                                                   Encoding encoding);

}  // namespace tetloft::internal::io

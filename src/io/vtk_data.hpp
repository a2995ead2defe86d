// The values of DataArray elements: text, base64, or appended bytes.
//
// Every size that a file claims is compared with the bytes that are there before anything
// is allocated, so what an array takes is bounded by the bytes it has in the file.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <tetloft/result.hpp>

#include "io/scalar_type.hpp"
#include "io/xml.hpp"

namespace tetloft::internal::io {

/// A DataArray as declared.
struct DataArray {
  enum class Format : std::uint8_t { ascii, binary, appended };
  std::string_view name;
  ScalarType type = ScalarType::float32;
  std::size_t components = 1;
  std::optional<std::size_t> tuples;  ///< as announced
  Format format = Format::ascii;
  std::size_t offset = 0;    ///< into the appended data
  std::string_view text;     ///< what stands between its tags
  std::size_t position = 0;  ///< of its tag, for messages
};

/// What the file says about all its arrays.
struct DataSource {
  bool little_endian = true;
  std::size_t header_bytes = 4;              ///< of the byte counts before binary data
  bool packed = false;                       ///< in blocks, by
  std::string compressor;                    ///< as the file names it
  std::optional<std::string_view> appended;  ///< behind the underscore, to the closing tag
  bool appended_base64 = false;
};

/// The declaration in a DataArray tag; `name` must outlive it.
[[nodiscard]] Result<DataArray> declare_array(const XmlTag& tag, std::string_view name,
                                              const XmlScanner& scanner);

/// What the VTKFile tag says. Error invalid_input where the file is of another type of grid.
[[nodiscard]] Result<DataSource> declare_source(const XmlTag& tag, std::string_view grid_type,
                                                const XmlScanner& scanner);
/// Passes over the data behind the AppendedData tag, to its closing one, and takes them down. Raw
/// data may hold anything, tags too: their end is that of the file's last closing tag.
[[nodiscard]] Result<void> take_appended_data(const XmlTag& tag, XmlScanner& scanner,
                                              DataSource& source);

/// Which part of the appended data an array takes, in the file's encoding.
struct AppendedExtent {
  std::size_t from = 0;
  std::size_t to = 0;
  const DataArray* array = nullptr;
};
/// Nothing for arrays without values, not appended, or beyond the data, which no one can read.
[[nodiscard]] std::optional<AppendedExtent> appended_extent(const DataArray& array,
                                                            const DataSource& source);

/// What the arrays unpack to, and their values take, is bounded by the file's size: error
/// invalid_input above kUnpackedBytes and a multiple of that. To be asked before any is read, of
/// all that are.
inline constexpr std::size_t kUnpackedBytes = std::size_t{1} << 20;
/// Of a grid, whose arrays are packed by a factor of up to twenty; its model takes less than half
/// of what is counted here.
inline constexpr std::size_t kGridUnpacked = 32;
/// Of poly data, of whose points and ids a stack may be made that takes far more.
inline constexpr std::size_t kPolyDataUnpacked = 16;
[[nodiscard]] Result<void> check_unpacking(const std::vector<const DataArray*>& arrays,
                                           const DataSource& source, std::size_t multiple,
                                           const XmlScanner& scanner);
/// What an array of so many bytes counts for, each of its values being of `value` bytes.
[[nodiscard]] constexpr std::uint64_t unpacked_cost(std::uint64_t bytes, std::size_t value) {
  return bytes + 8 * (bytes / value);
}

/// All values, converted. Integer arrays may be read as double (inexactly above 2^53);
/// floating arrays are refused as integers.
[[nodiscard]] Result<std::vector<double>> read_doubles(const DataArray& array,
                                                       const DataSource& source,
                                                       const XmlScanner& scanner);
[[nodiscard]] Result<std::vector<std::int64_t>> read_integers(const DataArray& array,
                                                              const DataSource& source,
                                                              const XmlScanner& scanner);

}  // namespace tetloft::internal::io

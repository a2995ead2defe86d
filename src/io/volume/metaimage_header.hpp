// The header of a MetaImage: its fields, and where its data are.
#pragma once

#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <map>
#include <string>
#include <vector>

#include <tetloft/result.hpp>

#include "io/format.hpp"
#include "io/volume/data_stream.hpp"
#include "io/volume/volume.hpp"

namespace tetloft::internal::io {

/// "Key = value" lines, up to that of the data.
struct MetaHeader {
  struct Field {
    std::string value;
    std::size_t line = 0;
  };
  std::string name;
  std::map<std::string, Field> fields;  ///< by key in lower case
  std::vector<std::string> listed;      ///< lines behind "ElementDataFile = LIST"
  std::uint64_t data = 0;               ///< behind the line "ElementDataFile = LOCAL"

  /// Of the first of these keys that there is; null if none is.
  [[nodiscard]] const Field* find(std::initializer_list<const char*> keys) const;
  [[nodiscard]] bool is_true(std::initializer_list<const char*> keys, bool otherwise) const;
  /// All numbers of a field, at least `count`; empty where there is no such field.
  [[nodiscard]] Result<std::vector<double>> numbers(std::initializer_list<const char*> keys,
                                                    std::size_t count) const;
  [[nodiscard]] Error complain(const Field* field, const std::string& message) const;
};

[[nodiscard]] Result<MetaHeader> read_meta_header(const ByteSource& file, const std::string& name);

/// The parts of the data, whose format and encoding are set; zlib becomes gzip where it is that.
[[nodiscard]] Result<void> find_meta_data(const MetaHeader& meta, const Source& source,
                                          const VolumeHeader& header, VoxelData& data);

}  // namespace tetloft::internal::io

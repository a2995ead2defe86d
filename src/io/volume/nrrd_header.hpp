// The header of a NRRD file: its fields, and its pairs of keys and values.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <tetloft/result.hpp>

#include "io/bytes/byte_source.hpp"

namespace tetloft::internal::io {

struct NrrdField {
  std::string value;
  std::size_t line = 0;
};

struct NrrdHeader {
  std::string name;  ///< of the file, for errors
  /// By identifier, in lower case, without blanks: "spacedirections".
  std::map<std::string, NrrdField> fields;
  std::map<std::string, std::string> keys;  ///< values without escapes
  /// Lines behind "data file: LIST".
  std::vector<std::string> listed;
  /// Behind the empty line that ends the header; nothing where the file ends before.
  std::optional<std::uint64_t> data;

  /// Null where there is no such field.
  [[nodiscard]] const NrrdField* find(const std::string& identifier) const;
  /// Its words, between blanks, those in quotes and those in parentheses whole; empty where there
  /// is no such field.
  [[nodiscard]] std::vector<std::string> words(const std::string& identifier) const;
  /// Whether names of files follow.
  [[nodiscard]] bool has_list() const;
  [[nodiscard]] Error complain(const std::string& identifier, const std::string& message) const;
};

inline constexpr std::string_view kNrrdMagic = "NRRD000";

/// Error invalid_input where the file is none, or a line is neither comment, field nor key.
[[nodiscard]] Result<NrrdHeader> read_nrrd_header(const ByteSource& file, const std::string& name);

}  // namespace tetloft::internal::io

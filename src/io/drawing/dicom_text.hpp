// Text of DICOM (PS3.3, C.12.1.1.2; PS3.5, 6.1) as UTF-8.
#pragma once

#include <string>
#include <string_view>

namespace tetloft::internal::io {

/// The value of Specific Character Set, and what it says of text.
class DicomCharacters {
 public:
  /// Where the file names none, ASCII.
  DicomCharacters() = default;
  explicit DicomCharacters(std::string_view value);

  struct Text {
    std::string text;  ///< valid UTF-8; bytes that are not understood as "\\x9c"
    std::string odd;   ///< what was not as it should be, for a warning; or empty
  };
  /// `value` without its padding. Read are ASCII, the parts of ISO 8859, ISO_IR 13 and 166, UTF-8,
  /// and escape sequences between them; of the sets of several bytes what is ASCII in them. Bytes
  /// above ASCII where none are told of are UTF-8 if they can be, else Latin-1, as readers have it.
  [[nodiscard]] Text decode(std::string_view value) const;

 private:
  std::string value_;  ///< as it stands there, without padding
  std::string first_;  ///< the first set, as letters and digits ("ISOIR100")
};

}  // namespace tetloft::internal::io

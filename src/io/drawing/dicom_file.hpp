// The outside of a DICOM file (PS3.10): preamble, meta information, and how the data set is
// encoded, told or guessed.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include <tetloft/result.hpp>

#include "io/drawing/dicom_elements.hpp"
#include "io/warning_list.hpp"

namespace tetloft::internal::io {

class DicomFile {
 public:
  /// `bytes` must outlive it. Error invalid_input where this is no DICOM, or of a transfer syntax
  /// that is not read; what is odd but understood is warned of.
  [[nodiscard]] static Result<DicomFile> open(std::string_view bytes, const std::string& name,
                                              WarningList& warnings);

  /// The SOP class that the meta information names; empty where there is none.
  [[nodiscard]] const std::string& media_class() const { return media_class_; }
  /// The elements of the data set; the file must stay.
  [[nodiscard]] DicomElements elements(std::initializer_list<DicomTag> entered) const;

 private:
  [[nodiscard]] Result<void> take_meta(std::size_t at, WarningList& warnings);
  [[nodiscard]] Result<void> take_syntax(std::size_t at, WarningList& warnings);
  [[nodiscard]] Result<void> unpack();

  std::string_view bytes_;
  std::string name_;
  std::string syntax_;  ///< transfer syntax, as the meta information tells it
  std::string media_class_;
  std::string unpacked_;  ///< of a deflated data set
  bool deflated_ = false;
  std::size_t begin_ = 0;  ///< of the data set
  DicomEncoding encoding_;
};

/// Whether bytes begin as a DICOM file does, with or without preamble and meta information.
[[nodiscard]] bool begins_as_dicom(std::string_view bytes);

}  // namespace tetloft::internal::io

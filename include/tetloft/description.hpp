// What a stack or a model is of, beside its geometry.
#pragma once

#include <string>

namespace tetloft {

/// For those who look at it, or load its files elsewhere; nothing is computed from it, and all of
/// it may be empty. UTF-8; a reader of files makes it so.
struct Description {
  std::string name = {};  ///< of the structure (ROI, object, segment, label)
  std::string unit = {};  ///< of length, as the file names it: "mm"
  /// Where x, y and z of the file's space grow towards in a body: "LPS" (left, posterior,
  /// superior), which DICOM has, or "RAS" (right, anterior, superior), which NIfTI has, or another
  /// such triple. Empty: no body.
  std::string orientation = {};
  friend bool operator==(const Description&, const Description&) = default;
};

}  // namespace tetloft

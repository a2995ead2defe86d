// The header of NIfTI-1 and NIfTI-2 files, as it stands there.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>

namespace tetloft::internal::io {

inline constexpr std::size_t kNifti1Header = 348;
inline constexpr std::size_t kNifti2Header = 540;

struct NiftiHeader {
  bool version_2 = false;
  bool big_endian = false;
  bool pair = false;     ///< the data stand in an .img beside
  bool analyze = false;  ///< no magic: the format before NIfTI
  std::array<std::int64_t, 8> dim{};
  int datatype = 0;
  std::array<double, 8> pixdim{};
  double vox_offset = 0;
  double slope = 0;
  double intercept = 0;
  int units = 0;  ///< xyzt_units
  int qform_code = 0;
  int sform_code = 0;
  std::array<double, 3> quatern{};
  std::array<double, 3> qoffset{};
  std::array<std::array<double, 4>, 3> srow{};
};

/// Of the bytes of a file, unpacked; at least as many as the header has. Nothing where they do not
/// begin with the size of one.
[[nodiscard]] std::optional<NiftiHeader> nifti_header(std::string_view bytes);

}  // namespace tetloft::internal::io

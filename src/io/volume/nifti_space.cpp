// The two transforms of NIfTI: the sform, a matrix, and the qform, a quaternion with voxel sizes.
#include "io/volume/nifti_space.hpp"

#include <algorithm>
#include <cmath>

#include "io/numbers.hpp"
#include "io/volume/placement.hpp"

namespace tetloft::internal::io {

namespace {

using Matrix = std::array<std::array<double, 4>, 4>;

// Sizes of voxels; what is no size counts as 1.
std::array<double, 3> voxel_sizes(const NiftiHeader& nifti, const std::string& name,
                                  VolumeHeader& header) {
  std::array<double, 3> sizes{};
  for (std::size_t i = 0; i < 3; ++i) {
    const double size = std::abs(nifti.pixdim[i + 1]);
    const bool fits = std::isfinite(size) && size > 0;
    sizes[i] = fits ? size : 1;
    if (fits || static_cast<std::int64_t>(i) >= nifti.dim[0]) continue;
    Warning warning{"pixdim[" + std::to_string(i + 1) + "] is no size; 1 is taken", {}};
    warning.where.file = name;
    header.warnings.push_back(std::move(warning));
  }
  return sizes;
}

// nifti1.h, method 2: R from (a, b, c, d) with a² = 1 − b² − c² − d², its columns times the sizes,
// the third negated where qfac is −1. Where rounding leaves nothing, or less, for a, the other
// three are made a unit.
Matrix qform_matrix(const NiftiHeader& nifti, const std::array<double, 3>& sizes) {
  constexpr double kRoundedAway = 1e-7;  // of the reference implementation, for floats
  auto [b, c, d] = nifti.quatern;
  double a = 1 - (b * b + c * c + d * d);
  if (a < kRoundedAway) {
    const double length = std::sqrt(b * b + c * c + d * d);
    b = b / length;
    c = c / length;
    d = d / length;
    a = 0;
  } else {
    a = std::sqrt(a);
  }
  const double k = nifti.pixdim[0] < 0 ? -sizes[2] : sizes[2];
  const auto& o = nifti.qoffset;
  Matrix m{};
  m[0] = {(a * a + b * b - c * c - d * d) * sizes[0], 2 * (b * c - a * d) * sizes[1],
          2 * (b * d + a * c) * k, o[0]};
  m[1] = {2 * (b * c + a * d) * sizes[0], (a * a + c * c - b * b - d * d) * sizes[1],
          2 * (c * d - a * b) * k, o[1]};
  m[2] = {2 * (b * d - a * c) * sizes[0], 2 * (c * d + a * b) * sizes[1],
          (a * a + d * d - c * c - b * b) * k, o[2]};
  m[3] = {0, 0, 0, 1};
  for (auto& row : m) {
    for (double& entry : row) {
      if (entry == 0) entry = 0;  // not −0
    }
  }
  return m;
}

Matrix sform_matrix(const NiftiHeader& nifti) {
  return {nifti.srow[0], nifti.srow[1], nifti.srow[2], {0, 0, 0, 1}};
}

Matrix sizes_matrix(const std::array<double, 3>& sizes) {
  Matrix m{};
  for (std::size_t i = 0; i < 3; ++i) m[i][i] = sizes[i];
  m[3][3] = 1;
  return m;
}

// How far apart two matrices put the corners of the volume, at most.
double farthest_corner(const VolumeHeader& header, const Matrix& p, const Matrix& q) {
  double farthest = 0;
  for (unsigned corner = 0; corner < 8; ++corner) {
    double square = 0;
    for (std::size_t row = 0; row < 3; ++row) {
      double difference = p[row][3] - q[row][3];
      for (std::size_t axis = 0; axis < 3; ++axis) {
        if ((corner >> axis & 1U) == 0) continue;
        difference += (p[row][axis] - q[row][axis]) * static_cast<double>(header.size[axis] - 1);
      }
      square += difference * difference;
    }
    farthest = std::max(farthest, std::sqrt(square));
  }
  return farthest;
}

std::array<double, 3> lengths_of_axes(const Matrix& m) {
  std::array<double, 3> lengths{};
  for (std::size_t i = 0; i < 3; ++i) {
    lengths[i] = std::sqrt(m[0][i] * m[0][i] + m[1][i] * m[1][i] + m[2][i] * m[2][i]);
  }
  return lengths;
}

std::string unit_of(int xyzt_units) {
  switch (xyzt_units & 7) {
    case 1: return "m";
    case 2: return "mm";
    case 3: return "um";
    default: return {};
  }
}

void warn(VolumeHeader& header, const std::string& name, std::string message) {
  Warning warning{std::move(message), {}};
  warning.where.file = name;
  header.warnings.push_back(std::move(warning));
}

// Of both forms, the one that was not taken lies elsewhere by more than a hundredth of a voxel.
void warn_of_difference(VolumeHeader& header, const std::string& name, const Matrix& qform) {
  const double apart = farthest_corner(header, header.matrix, qform);
  const double voxel = *std::min_element(header.spacing.begin(), header.spacing.end());
  if (!(apart > 0.01 * voxel)) return;
  std::string text =
      "sform and qform disagree; the sform is taken, by which a corner of the volume "
      "lies ";
  append_number(text, static_cast<float>(apart));
  warn(header, name, text + " from where the qform puts it");
}

}  // namespace

Result<void> set_nifti_space(const NiftiHeader& nifti, const std::string& name,
                             VolumeHeader& header) {
  const std::array<double, 3> sizes = voxel_sizes(nifti, name, header);
  header.space = "RAS";
  header.unit = unit_of(nifti.units);
  const Matrix qform = qform_matrix(nifti, sizes);
  if (nifti.sform_code > 0) {
    header.matrix = sform_matrix(nifti);
    header.spacing = lengths_of_axes(header.matrix);
    const Result<void> fits = check_matrix(header, "the sform (srow_x, srow_y, srow_z)", name);
    if (fits && nifti.qform_code > 0) warn_of_difference(header, name, qform);
    if (fits || nifti.qform_code <= 0) return fits;
    warn(header, name, fits.error().message + "; the qform is taken");
  }
  header.spacing = sizes;
  if (nifti.qform_code > 0) {
    header.matrix = qform;
    return check_matrix(header, "the qform (quatern, qoffset, pixdim)", name);
  }
  header.matrix = sizes_matrix(sizes);
  warn(header, name,
       "neither sform nor qform says where the volume lies: voxel sizes alone are taken, from the "
       "origin, without a flip");
  return check_matrix(header, "pixdim", name);
}

}  // namespace tetloft::internal::io

#include "between/smoother.hpp"

#include <algorithm>
#include <cmath>

namespace tetloft::internal::between {

Smoother::Smoother(double sigma, Outside outside) : outside_(outside) {
  const double reach = std::sqrt(7.0) * sigma;
  double sum = 0;
  for (double k = 0; k == 0 || k < reach; ++k) {
    const double t = k == 0 ? 0 : k / reach;
    weight_.push_back((1 - t * t) * (1 - t * t));
    sum += k == 0 ? weight_.back() : 2 * weight_.back();
  }
  for (double& w : weight_) w /= sum;
}

void Smoother::smooth(std::vector<double>& value, std::size_t nx, std::size_t ny) {
  smooth_rows(value, nx, ny);
  smooth_columns(value, nx, ny);
}

void Smoother::smooth_rows(std::vector<double>& value, std::size_t nx, std::size_t ny) {
  const std::size_t reach = weight_.size() - 1;
  line_.assign(nx + 2 * reach, 0);
  const auto before = line_.begin() + static_cast<std::ptrdiff_t>(reach);
  const auto behind = before + static_cast<std::ptrdiff_t>(nx);
  for (std::size_t y = 0; y < ny; ++y) {
    double* const row = value.data() + y * nx;
    std::copy(row, row + nx, before);
    if (outside_ == Outside::border) {
      std::fill(line_.begin(), before, row[0]);
      std::fill(behind, line_.end(), row[nx - 1]);
    }
    const double* const at = line_.data() + reach;
    for (std::size_t x = 0; x < nx; ++x) row[x] = weight_[0] * at[x];
    for (std::size_t k = 1; k <= reach; ++k) {
      const double w = weight_[k];
      const double* const left = at - k;
      const double* const right = at + k;
      for (std::size_t x = 0; x < nx; ++x) row[x] += w * (left[x] + right[x]);
    }
  }
}

void Smoother::smooth_columns(std::vector<double>& value, std::size_t nx, std::size_t ny) {
  const std::size_t reach = weight_.size() - 1;
  // The rows, with as many around them as weights reach.
  rows_.assign((ny + 2 * reach) * nx, 0);
  const auto row = [&](std::size_t y) {
    return rows_.begin() + static_cast<std::ptrdiff_t>(y * nx);
  };
  std::copy(value.begin(), value.end(), row(reach));
  if (outside_ == Outside::border) {
    for (std::size_t k = 0; k < reach; ++k) {
      std::copy(row(reach), row(reach + 1), row(k));
      std::copy(row(reach + ny - 1), row(reach + ny), row(reach + ny + k));
    }
  }
  for (std::size_t y = 0; y < ny; ++y) {
    double* const to = value.data() + y * nx;
    const double* const at = rows_.data() + (y + reach) * nx;
    for (std::size_t x = 0; x < nx; ++x) to[x] = weight_[0] * at[x];
    for (std::size_t k = 1; k <= reach; ++k) {
      const double w = weight_[k];
      const double* const low = at - k * nx;
      const double* const high = at + k * nx;
      for (std::size_t x = 0; x < nx; ++x) to[x] += w * (low[x] + high[x]);
    }
  }
}

}  // namespace tetloft::internal::between

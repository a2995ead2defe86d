// A volume that a test holds in memory, for what is made of volumes whatever their format.
#pragma once

#include <algorithm>
#include <cstddef>
#include <functional>
#include <utility>
#include <vector>

#include "io/volume/volume.hpp"

namespace tetloft::test {

class MemoryVolume : public internal::io::Volume {
 public:
  using Size = std::array<std::size_t, 3>;

  explicit MemoryVolume(const Size& size, std::size_t layers = 1)
      : values_(layers, std::vector<double>(size[0] * size[1] * size[2])) {
    header_.size = size;
    header_.layers = layers;
    header_.sizes.assign(size.begin(), size.end());
    if (layers > 1) header_.sizes.push_back(layers);
    header_.spacing = {1, 1, 1};
    for (std::size_t i = 0; i < 4; ++i) header_.matrix[i][i] = 1;
    header_.space = "RAS";
    header_.type = "float64";
  }

  internal::io::VolumeHeader& edit() { return header_; }
  double& at(std::size_t i, std::size_t j, std::size_t k, std::size_t layer = 0) {
    return values_[layer][i + header_.size[0] * (j + header_.size[1] * k)];
  }
  void fill(const std::function<double(std::size_t, std::size_t, std::size_t)>& value) {
    for (std::size_t k = 0; k < header_.size[2]; ++k) {
      for (std::size_t j = 0; j < header_.size[1]; ++j) {
        for (std::size_t i = 0; i < header_.size[0]; ++i) at(i, j, k) = value(i, j, k);
      }
    }
  }
  void set_axes(const std::array<std::array<double, 3>, 3>& columns,
                const std::array<double, 3>& origin) {
    for (std::size_t row = 0; row < 3; ++row) {
      for (std::size_t axis = 0; axis < 3; ++axis) header_.matrix[row][axis] = columns[axis][row];
      header_.matrix[row][3] = origin[row];
    }
  }
  /// Values of a piece; pieces end where they end.
  std::size_t piece = 7;
  std::size_t readings = 0;

  tetloft::Result<void> for_each_piece(std::size_t layer, const TakeValues& take) override {
    ++readings;
    const std::vector<double>& all = values_[layer];
    for (std::size_t from = 0; from < all.size(); from += piece) {
      const std::size_t count = std::min(piece, all.size() - from);
      if (auto taken = take(std::span(all).subspan(from, count)); !taken) return taken;
    }
    return {};
  }

 private:
  std::vector<std::vector<double>> values_;
};

}  // namespace tetloft::test

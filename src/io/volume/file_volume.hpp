// A volume in a file, or in several.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "io/volume/data_stream.hpp"
#include "io/volume/volume.hpp"

namespace tetloft::internal::io {

/// The product, if it is at most `most`.
[[nodiscard]] std::optional<std::uint64_t> product_up_to(std::span<const std::uint64_t> factors,
                                                         std::uint64_t most);

/// More samples than this are in no file.
inline constexpr std::uint64_t kMostSamples = std::uint64_t{1} << 48;

class FileVolume final : public Volume {
 public:
  /// Samples stand in runs of `block` voxels of a layer, then as many of the next; the layers over,
  /// of the next voxels. 1: all values of a voxel stand together; all voxels: layer after layer.
  /// The parts have as many samples as the header says in all, and were checked.
  FileVolume(VolumeHeader header, VoxelData data, std::uint64_t block);

  Result<void> for_each_piece(std::size_t layer, const TakeValues& take) override;
  [[nodiscard]] std::vector<std::string> data_files() const override;

 private:
  Result<void> take_run(SampleStream& samples, std::uint64_t count, const TakeValues& take);
  Result<void> take_mixed(std::size_t layer, const TakeValues& take);

  VoxelData data_;
  std::uint64_t block_;
};

}  // namespace tetloft::internal::io

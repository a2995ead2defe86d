// Values of a layer, from the samples of all.
#include "io/volume/file_volume.hpp"

#include <algorithm>
#include <utility>
#include <vector>

namespace tetloft::internal::io {

namespace {

constexpr std::size_t kValuesAtOnce = std::size_t{1} << 14;

}  // namespace

std::optional<std::uint64_t> product_up_to(std::span<const std::uint64_t> factors,
                                           std::uint64_t most) {
  std::uint64_t product = 1;
  for (const std::uint64_t factor : factors) {
    if (factor != 0 && product > most / factor) return std::nullopt;
    product *= factor;
  }
  return product;
}

FileVolume::FileVolume(VolumeHeader header, VoxelData data, std::uint64_t block)
    : data_(std::move(data)), block_(block) {
  header_ = std::move(header);
}

std::vector<std::string> FileVolume::data_files() const {
  std::vector<std::string> files;
  for (const DataPart& part : data_.parts) {
    const bool known = std::find(files.begin(), files.end(), part.path) != files.end();
    if (!part.path.empty() && !known) files.push_back(part.path);
  }
  return files;
}

Result<void> FileVolume::for_each_piece(std::size_t layer, const TakeValues& take) {
  if (block_ < kValuesAtOnce && header_.layers > 1) return take_mixed(layer, take);
  SampleStream samples(data_);
  const std::uint64_t others = header_.layers - 1 - layer;
  for (std::uint64_t done = 0; done < header_.voxels(); done += block_) {
    if (Result<void> skipped = samples.skip(block_ * layer); !skipped) return skipped;
    if (Result<void> taken = take_run(samples, block_, take); !taken) return taken;
    if (done + block_ == header_.voxels()) break;
    if (Result<void> skipped = samples.skip(block_ * others); !skipped) return skipped;
  }
  return {};
}

Result<void> FileVolume::take_run(SampleStream& samples, std::uint64_t count,
                                  const TakeValues& take) {
  std::vector<double> values(
      static_cast<std::size_t>(std::min<std::uint64_t>(count, kValuesAtOnce)));
  while (count > 0) {
    const auto part = static_cast<std::size_t>(std::min<std::uint64_t>(count, values.size()));
    const std::span<double> piece = std::span(values).first(part);
    if (Result<void> read = samples.read(piece); !read) return read;
    if (Result<void> taken = take(piece); !taken) return taken;
    count -= part;
  }
  return {};
}

// All samples are read, and those of the layer picked out.
Result<void> FileVolume::take_mixed(std::size_t layer, const TakeValues& take) {
  SampleStream samples(data_);
  std::vector<double> values;
  std::uint64_t in_block = 0;
  std::size_t of_layer = 0;
  return take_run(samples, header_.voxels() * header_.layers,
                  [&](std::span<const double> all) -> Result<void> {
                    values.clear();
                    for (const double value : all) {
                      if (of_layer == layer) values.push_back(value);
                      if (++in_block < block_) continue;
                      in_block = 0;
                      of_layer = of_layer + 1 == header_.layers ? 0 : of_layer + 1;
                    }
                    return values.empty() ? Result<void>() : take(values);
                  });
}

}  // namespace tetloft::internal::io

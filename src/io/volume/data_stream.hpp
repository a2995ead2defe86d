// The samples of a file of voxels, one after the other, however they are packed, and in however
// many files.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include <tetloft/result.hpp>

#include "io/bytes/byte_source.hpp"
#include "io/volume/samples.hpp"

namespace tetloft::internal::io {

enum class DataEncoding : std::uint8_t {
  raw,
  gzip,
  zlib,
  text,  ///< numbers between white space or commas
  hex,   ///< two digits a byte, white space between them passed over
};

/// A file of samples, or a part of the file that has the header.
struct DataPart {
  std::string path;          ///< empty: the file of the header
  std::uint64_t offset = 0;  ///< of the data as they are packed
  std::uint64_t skip = 0;    ///< bytes passed over after they are unpacked
  std::uint64_t samples = 0;
};

struct VoxelData {
  SampleFormat format;
  DataEncoding encoding = DataEncoding::raw;
  const ByteSource* source = nullptr;  ///< the file of the header; outlives what is read of it
  std::string name;                    ///< of that file
  std::vector<DataPart> parts;
};

/// Opens the file of a part, or hands out that of the header. Error io, or invalid_input for a
/// pipe.
struct OpenPart {
  std::unique_ptr<ByteSource> own;
  const ByteSource* bytes = nullptr;
  std::string name;
};
[[nodiscard]] Result<OpenPart> open_part(const VoxelData& data, const DataPart& part);

/// Whether each part is there, and long enough to hold its samples: of packed data, whether it may
/// be, at 1032 bytes of a byte, the most that DEFLATE gives. So what follows from announced sizes
/// is bounded by those of the files.
[[nodiscard]] Result<void> check_parts(const VoxelData& data);

/// Reads from the first sample on. `data` outlives it.
class SampleStream {
 public:
  explicit SampleStream(const VoxelData& data);
  ~SampleStream();
  SampleStream(const SampleStream&) = delete;
  SampleStream& operator=(const SampleStream&) = delete;

  /// Exactly so many, scaled; error invalid_input where there are fewer. Behind the last sample of
  /// a part checksums are compared.
  [[nodiscard]] Result<void> read(std::span<double> values);
  [[nodiscard]] Result<void> skip(std::uint64_t samples);

 private:
  class PartReader;
  [[nodiscard]] Result<void> open_next();

  const VoxelData& data_;
  std::size_t next_part_ = 0;
  std::uint64_t left_ = 0;  ///< samples of the part
  std::unique_ptr<PartReader> part_;
};

/// How many bytes the packed data of a part unpack to. Reads them all.
[[nodiscard]] Result<std::uint64_t> unpacked_size(const VoxelData& data, const DataPart& part);

}  // namespace tetloft::internal::io

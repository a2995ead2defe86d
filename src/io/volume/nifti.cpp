// NIfTI-1 and NIfTI-2: one file (.nii), or a header and its data (.hdr, .img), plain or in gzip.
// World coordinates are RAS, as the format has them.
#include <algorithm>
#include <array>
#include <cmath>

#include "io/bytes/inflate.hpp"
#include "io/format.hpp"
#include "io/numbers.hpp"
#include "io/volume/data_files.hpp"
#include "io/volume/file_volume.hpp"
#include "io/volume/nifti_header.hpp"
#include "io/volume/nifti_labels.hpp"
#include "io/volume/nifti_space.hpp"
#include "io/volume/part_bytes.hpp"
#include "io/volume/volume_error.hpp"

namespace tetloft::internal::io {

namespace {

bool is_gzip(std::string_view bytes) { return bytes.substr(0, 2) == "\x1F\x8B"; }

// As many of the first bytes as a header has, unpacked; fewer where the file is cut off.
std::string header_bytes(std::string_view beginning, const ByteSource& file, bool packed) {
  std::string bytes(kNifti2Header, '\0');
  if (!packed) return std::string(beginning.substr(0, kNifti2Header));
  // The largest header that is packed into more than it unpacks to is that of NIfTI-1, alone.
  for (const std::size_t wanted : {kNifti2Header, kNifti1Header}) {
    Inflater inflater(file, 0, Wrapping::gzip, {});
    bytes.resize(wanted);
    const Result<std::size_t> got = inflater.read(bytes);
    if (!got) continue;
    bytes.resize(*got);
    return bytes;
  }
  return {};
}

bool recognise_nifti(std::string_view bytes) {
  const MemoryBytes file(bytes);
  const auto header = nifti_header(header_bytes(bytes, file, is_gzip(bytes)));
  return header && !header->analyze;
}

Result<ScalarType> sample_type(int datatype, const std::string& name) {
  switch (datatype) {
    case 2: return ScalarType::uint8;
    case 4: return ScalarType::int16;
    case 8: return ScalarType::int32;
    case 16: return ScalarType::float32;
    case 64: return ScalarType::float64;
    case 256: return ScalarType::int8;
    case 512: return ScalarType::uint16;
    case 768: return ScalarType::uint32;
    case 1024: return ScalarType::int64;
    case 1280: return ScalarType::uint64;
    default: break;
  }
  struct Unread {
    int code;
    const char* what;
  };
  constexpr std::array<Unread, 8> kUnread{{{1, "single bits"},
                                           {32, "complex numbers"},
                                           {128, "colours (RGB)"},
                                           {1536, "float128"},
                                           {1792, "complex numbers"},
                                           {2048, "complex numbers"},
                                           {2304, "colours (RGBA)"},
                                           {0, "of unknown type"}}};
  for (const Unread& unread : kUnread) {
    if (unread.code == datatype) {
      return volume_error(name, "voxels that are " + std::string(unread.what) +
                                    " are not read: save them as integers or floats");
    }
  }
  return volume_error(name, "datatype " + std::to_string(datatype) + " is unknown");
}

Result<void> set_nifti_sizes(const NiftiHeader& nifti, const std::string& name,
                             VolumeHeader& header) {
  const std::int64_t dimensions = nifti.dim[0];
  if (dimensions < 1 || dimensions > 7) {
    return volume_error(
        name, "dim[0] is " + std::to_string(dimensions) + ", where a file has 1 to 7 dimensions");
  }
  std::vector<std::uint64_t> sizes;
  for (std::size_t i = 1; i <= static_cast<std::size_t>(dimensions); ++i) {
    if (nifti.dim[i] < 1) {
      return volume_error(name,
                          "dim[" + std::to_string(i) + "] is " + std::to_string(nifti.dim[i]));
    }
    sizes.push_back(static_cast<std::uint64_t>(nifti.dim[i]));
  }
  if (!product_up_to(sizes, kMostSamples))
    return volume_error(name, "dim announces too many voxels");
  header.sizes.assign(sizes.begin(), sizes.end());
  header.size = {1, 1, 1};
  for (std::size_t i = 0; i < sizes.size(); ++i) {
    if (i < 3) header.size[i] = static_cast<std::size_t>(sizes[i]);
    if (i >= 3) header.layers *= static_cast<std::size_t>(sizes[i]);
  }
  return {};
}

// A slope of 0 means that there is none.
void set_scale(const NiftiHeader& nifti, SampleFormat& format) {
  if (nifti.slope == 0 || !std::isfinite(nifti.slope)) return;
  format.slope = nifti.slope;
  format.intercept = std::isfinite(nifti.intercept) ? nifti.intercept : 0;
}

// Where the data begin: behind header and extensions, or in the .img.
Result<void> find_data(const NiftiHeader& nifti, const Source& source, VoxelData& data,
                       std::uint64_t samples) {
  if (!(nifti.vox_offset >= 0 && nifti.vox_offset < 0x1p48) ||
      nifti.vox_offset != std::floor(nifti.vox_offset)) {
    std::string message = "vox_offset is ";
    append_number(message, nifti.vox_offset);
    return volume_error(source.name, message);
  }
  auto offset = static_cast<std::uint64_t>(nifti.vox_offset);
  DataPart part;
  part.samples = samples;
  if (nifti.pair) {
    const Result<std::string> image = image_of_pair(source.folder, source.name);
    if (!image) return image.error();
    part.path = *image;
    const Result<OpenPart> opened = open_part(data, part);
    if (!opened) return opened.error();
    std::array<char, 2> mark{};
    const Result<std::size_t> got = opened->bytes->read_at(0, mark);
    if (!got) return got.error();
    data.encoding = is_gzip({mark.data(), *got}) ? DataEncoding::gzip : DataEncoding::raw;
  } else {
    // Four bytes behind the header tell of extensions; writers that have none forget the offset.
    const std::size_t behind = (nifti.version_2 ? kNifti2Header : kNifti1Header) + 4;
    if (offset < behind) offset = behind;
  }
  (data.encoding == DataEncoding::raw ? part.offset : part.skip) = offset;
  data.parts.push_back(std::move(part));
  return {};
}

// What stands between the header and the data of one file, of which labels are named.
std::string extensions_of(const NiftiHeader& nifti, const VoxelData& data) {
  constexpr std::uint64_t kMostRead = std::uint64_t{1} << 20;
  const std::uint64_t from = nifti.version_2 ? kNifti2Header : kNifti1Header;
  const std::uint64_t data_from = data.parts[0].offset + data.parts[0].skip;
  if (nifti.pair || data_from <= from + 4) return {};
  const OpenPart file{nullptr, data.source, data.name};
  const std::unique_ptr<PartBytes> bytes = bytes_of_part(data.encoding, file, 0);
  std::string all;
  while (all.size() < std::min(data_from, kMostRead)) {
    std::array<char, 4096> piece{};
    const auto wanted = static_cast<std::size_t>(
        std::min<std::uint64_t>(piece.size(), std::min(data_from, kMostRead) - all.size()));
    const Result<std::size_t> got = bytes->read(std::span(piece).first(wanted));
    if (!got || *got == 0) break;
    all.append(piece.data(), *got);
  }
  return all.size() > from ? all.substr(static_cast<std::size_t>(from)) : std::string();
}

Result<std::unique_ptr<Volume>> open_nifti(const Source& source, const ReadOptions& /*options*/) {
  const bool packed = is_gzip(source.bytes);
  const auto nifti = nifti_header(header_bytes(source.bytes, *source.whole, packed));
  if (!nifti) {
    return volume_error(source.name,
                        "this is no NIfTI file: it begins with no header of 348 or 540 bytes (of a "
                        "pair, read the .hdr)");
  }
  if (nifti->analyze) {
    return volume_error(source.name,
                        "this is an ANALYZE file, which does not say where its voxels lie; convert "
                        "it to NIfTI");
  }
  VolumeHeader header;
  if (Result<void> set = set_nifti_sizes(*nifti, source.name, header); !set) return set.error();
  const Result<ScalarType> type = sample_type(nifti->datatype, source.name);
  if (!type) return type.error();
  header.type = name_of(*type);
  if (Result<void> set = set_nifti_space(*nifti, source.name, header); !set) return set.error();
  VoxelData data;
  data.format = {*type, nifti->big_endian};
  set_scale(*nifti, data.format);
  data.encoding = packed ? DataEncoding::gzip : DataEncoding::raw;
  data.source = source.whole;
  data.name = source.name;
  const std::size_t voxels = header.voxels();
  if (Result<void> found = find_data(*nifti, source, data, voxels * header.layers); !found) {
    return found.error();
  }
  if (Result<void> there = check_parts(data); !there) return there.error();
  if (header.layers == 1) {
    header.segments = labels_in_extensions(extensions_of(*nifti, data), nifti->big_endian);
  }
  return std::unique_ptr<Volume>(
      std::make_unique<FileVolume>(std::move(header), std::move(data), voxels));
}

}  // namespace

extern constinit const Format nifti_format{
    .name = "nifti",
    .summary = "label volumes and images, NIfTI-1 and -2",
    .extensions = {".nii", ".nii.gz", ".hdr", ".img"},
    .recognise = recognise_nifti,
    .open_volume = open_nifti,
};

}  // namespace tetloft::internal::io

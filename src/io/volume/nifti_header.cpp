// Fields of nifti1.h and nifti2.h by their offsets.
#include "io/volume/nifti_header.hpp"

#include "io/volume/samples.hpp"

namespace tetloft::internal::io {

namespace {

class NiftiFields {
 public:
  NiftiFields(std::string_view bytes, bool big_endian) : bytes_(bytes), big_endian_(big_endian) {}
  template <class Number>
  [[nodiscard]] Number at(std::size_t offset) const {
    return number_in<Number>(bytes_.data() + offset, big_endian_);
  }
  template <class Number, class Field, std::size_t N>
  void fill(std::array<Field, N>& fields, std::size_t offset) const {
    for (std::size_t i = 0; i < N; ++i) {
      fields[i] = static_cast<Field>(at<Number>(offset + i * sizeof(Number)));
    }
  }

 private:
  std::string_view bytes_;
  bool big_endian_;
};

void read_version_1(const NiftiFields& f, std::string_view magic, NiftiHeader& header) {
  f.fill<std::int16_t>(header.dim, 40);
  header.datatype = f.at<std::int16_t>(70);
  f.fill<float>(header.pixdim, 76);
  header.vox_offset = static_cast<double>(f.at<float>(108));
  header.slope = static_cast<double>(f.at<float>(112));
  header.intercept = static_cast<double>(f.at<float>(116));
  header.units = f.at<std::uint8_t>(123);
  header.qform_code = f.at<std::int16_t>(252);
  header.sform_code = f.at<std::int16_t>(254);
  f.fill<float>(header.quatern, 256);
  f.fill<float>(header.qoffset, 268);
  for (std::size_t row = 0; row < 3; ++row) f.fill<float>(header.srow[row], 280 + 16 * row);
  header.pair = magic.substr(0, 3) == "ni1";
  header.analyze = !header.pair && magic.substr(0, 3) != "n+1";
}

void read_version_2(const NiftiFields& f, std::string_view magic, NiftiHeader& header) {
  header.datatype = f.at<std::int16_t>(12);
  f.fill<std::int64_t>(header.dim, 16);
  f.fill<double>(header.pixdim, 104);
  header.vox_offset = static_cast<double>(f.at<std::int64_t>(168));
  header.slope = f.at<double>(176);
  header.intercept = f.at<double>(184);
  header.qform_code = f.at<std::int32_t>(344);
  header.sform_code = f.at<std::int32_t>(348);
  f.fill<double>(header.quatern, 352);
  f.fill<double>(header.qoffset, 376);
  for (std::size_t row = 0; row < 3; ++row) f.fill<double>(header.srow[row], 400 + 32 * row);
  header.units = f.at<std::int32_t>(500);
  header.pair = magic.substr(0, 3) == "ni2";
}

}  // namespace

std::optional<NiftiHeader> nifti_header(std::string_view bytes) {
  for (const bool big_endian : {false, true}) {
    const NiftiFields fields(bytes, big_endian);
    NiftiHeader header;
    header.big_endian = big_endian;
    if (bytes.size() >= kNifti1Header && fields.at<std::int32_t>(0) == 348) {
      read_version_1(fields, bytes.substr(344, 4), header);
      return header;
    }
    if (bytes.size() < kNifti2Header || fields.at<std::int32_t>(0) != 540) continue;
    const std::string_view magic = bytes.substr(4, 8);
    if (magic.substr(0, 3) != "n+2" && magic.substr(0, 3) != "ni2") return std::nullopt;
    header.version_2 = true;
    read_version_2(fields, magic, header);
    return header;
  }
  return std::nullopt;
}

}  // namespace tetloft::internal::io

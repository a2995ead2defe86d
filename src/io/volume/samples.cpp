// Samples become doubles.
#include "io/volume/samples.hpp"

namespace tetloft::internal::io {

namespace {

template <class Number>
void convert_as(bool big_endian, std::span<const char> bytes, std::span<double> values) {
  const char* at = bytes.data();
  for (double& value : values) {
    value = static_cast<double>(number_in<Number>(at, big_endian));
    at += sizeof(Number);
  }
}

}  // namespace

std::string_view name_of(SampleType type) {
  switch (type) {
    case SampleType::int8: return "int8";
    case SampleType::uint8: return "uint8";
    case SampleType::int16: return "int16";
    case SampleType::uint16: return "uint16";
    case SampleType::int32: return "int32";
    case SampleType::uint32: return "uint32";
    case SampleType::int64: return "int64";
    case SampleType::uint64: return "uint64";
    case SampleType::float32: return "float32";
    case SampleType::float64: return "float64";
  }
  return "unknown";
}

std::size_t size_of(SampleType type) {
  switch (type) {
    case SampleType::int8:
    case SampleType::uint8: return 1;
    case SampleType::int16:
    case SampleType::uint16: return 2;
    case SampleType::int32:
    case SampleType::uint32:
    case SampleType::float32: return 4;
    case SampleType::int64:
    case SampleType::uint64:
    case SampleType::float64: break;
  }
  return 8;
}

void convert_samples(const SampleFormat& format, std::span<const char> bytes,
                     std::span<double> values) {
  const bool big = format.big_endian;
  switch (format.type) {
    case SampleType::int8: convert_as<std::int8_t>(big, bytes, values); break;
    case SampleType::uint8: convert_as<std::uint8_t>(big, bytes, values); break;
    case SampleType::int16: convert_as<std::int16_t>(big, bytes, values); break;
    case SampleType::uint16: convert_as<std::uint16_t>(big, bytes, values); break;
    case SampleType::int32: convert_as<std::int32_t>(big, bytes, values); break;
    case SampleType::uint32: convert_as<std::uint32_t>(big, bytes, values); break;
    case SampleType::int64: convert_as<std::int64_t>(big, bytes, values); break;
    case SampleType::uint64: convert_as<std::uint64_t>(big, bytes, values); break;
    case SampleType::float32: convert_as<float>(big, bytes, values); break;
    case SampleType::float64: convert_as<double>(big, bytes, values); break;
  }
  scale_samples(format, values);
}

void scale_samples(const SampleFormat& format, std::span<double> values) {
  if (format.slope == 1 && format.intercept == 0) return;
  for (double& value : values) value = format.slope * value + format.intercept;
}

}  // namespace tetloft::internal::io

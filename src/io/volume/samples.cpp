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

void convert_samples(const SampleFormat& format, std::span<const char> bytes,
                     std::span<double> values) {
  visit_scalar(format.type, [&](auto number) {
    convert_as<decltype(number)>(format.big_endian, bytes, values);
  });
  scale_samples(format, values);
}

void scale_samples(const SampleFormat& format, std::span<double> values) {
  if (format.slope == 1 && format.intercept == 0) return;
  for (double& value : values) value = format.slope * value + format.intercept;
}

}  // namespace tetloft::internal::io

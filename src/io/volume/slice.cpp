// Pixels of a slice.
#include "io/volume/slice.hpp"

#include <algorithm>

namespace tetloft::internal::io {

void Slice::append(std::span<const double> values) {
  for (const double value : values) {
    const bool in = rule_.holds(value);
    inside_ += in ? 1 : 0;
    marks_.push_back(in ? kInside : 0);
  }
  if (rule_.iso) values_.insert(values_.end(), values.begin(), values.end());
  if (marks_.size() % stride() != width_) return;
  marks_.push_back(0);
  if (rule_.iso) values_.push_back(0);
}

const double* Slice::value(std::size_t place) const {
  if (place >= values_.size() || place % stride() == width_) return nullptr;
  return &values_[place];
}

double Slice::share(std::size_t inner, std::size_t outer) const {
  const double* const b = value(outer);
  if (!rule_.iso || b == nullptr) return 0.5;
  const double a = *value(inner);
  const double share = (a - *rule_.iso) / (a - *b);
  // Of values that are no numbers, or too large for their difference.
  if (!(share >= 0 && share <= 1)) return 0.5;
  return std::clamp(share, kLeastShare, 1 - kLeastShare);
}

}  // namespace tetloft::internal::io

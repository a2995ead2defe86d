#include "reconstruct/lattice_hint.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace tetloft::internal {

int merging_bits(const ConformingSection& lower, const ConformingSection& upper) {
  std::vector<double> x;
  std::vector<double> y;
  for (const ConformingSection* section : {&lower, &upper}) {
    for (std::size_t k = 0; k < section->vertex_count(); ++k) {
      x.push_back(section->point(PlaneVertexId(k)).x);
      y.push_back(section->point(PlaneVertexId(k)).y);
    }
  }
  double extent = 0;
  std::vector<double> differences;
  for (std::vector<double>* values : {&x, &y}) {
    std::sort(values->begin(), values->end());
    for (std::size_t k = 0; k < values->size(); ++k) {
      extent = std::max(extent, std::abs((*values)[k]));
      if (k > 0) differences.push_back((*values)[k] - (*values)[k - 1]);
    }
  }
  int exponent = 0;
  (void)std::frexp(extent, &exponent);
  for (int bits = 40; bits >= 12; --bits) {
    const double spacing = std::ldexp(1.0, exponent - bits);
    bool merges = false;
    bool keeps = true;
    for (const double d : differences) {
      merges |= d > 0 && d <= spacing / 16;
      keeps &= d <= spacing / 16 || d >= 2 * spacing;
    }
    if (merges && keeps) return bits;
  }
  return 0;
}

}  // namespace tetloft::internal

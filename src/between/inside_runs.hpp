// Runs of samples of one sign along the rows of a window.
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "motion/lattice_window.hpp"

namespace tetloft::internal::between {

/// The first of [at, end) whose value is negative, or is not; `end` if there is none. No value may
/// be 0.
inline std::uint32_t find_sign(const std::vector<double>& value, bool negative, std::uint32_t at,
                               std::uint32_t end) {
  // Four at a time: rows are long, and signs seldom change.
  const auto bits = [&](std::uint32_t k) { return std::bit_cast<std::uint64_t>(value[k]); };
  for (; at + 4 <= end; at += 4) {
    const std::uint64_t any = bits(at) | bits(at + 1) | bits(at + 2) | bits(at + 3);
    const std::uint64_t all = bits(at) & bits(at + 1) & bits(at + 2) & bits(at + 3);
    if (((negative ? any : ~all) >> 63U) != 0) break;
  }
  while (at < end && (value[at] < 0) != negative) ++at;
  return at;
}

/// Calls visit(first place, place behind the last) for the runs of values that are negative, or of
/// those that are not, row by row.
template <class Visit>
void visit_sign_runs(const motion::LatticeWindow& window, const std::vector<double>& value,
                     bool negative, const Visit& visit) {
  const auto nx = static_cast<std::uint32_t>(window.nx());
  for (std::uint32_t row = 0; row < value.size(); row += nx) {
    const std::uint32_t end = row + nx;
    for (std::uint32_t at = find_sign(value, negative, row, end); at < end;) {
      const std::uint32_t first = at;
      at = find_sign(value, !negative, at, end);
      visit(first, at);
      at = find_sign(value, negative, at, end);
    }
  }
}

}  // namespace tetloft::internal::between

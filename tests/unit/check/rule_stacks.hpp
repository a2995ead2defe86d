// Small stacks for the rule of correspondence, and what check makes of them.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "check/partition.hpp"

namespace tetloft::testing {

using namespace internal;

inline Contour box(double x0, double y0, double x1, double y1) {
  return {{{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}}};
}

inline Contour plate() { return box(0, 0, 20, 20); }

/// Sections at z = 0, gap, 2 gap, …
inline SectionStack stack_of(const std::vector<std::vector<Contour>>& layers, double gap = 1) {
  SectionStack stack;
  for (std::size_t s = 0; s < layers.size(); ++s) {
    stack.sections.push_back(
        {gap * static_cast<double>(s), IdVector<ContourId, Contour>(layers[s])});
  }
  return stack;
}

/// Rule 1 alone, by overlap.
inline CorrespondenceOptions plain() {
  CorrespondenceOptions options;
  options.criterion = Criterion::overlap;
  options.chain = options.lone = false;
  return options;
}

/// Classes of contours, numbered by first occurrence.
using Classes = std::vector<int>;
inline Classes classes_of(const checking::ExpectedPartition& expected) {
  Classes result;
  std::vector<std::size_t> seen;
  for (const std::size_t set : expected.set) {
    const auto at = std::find(seen.begin(), seen.end(), set);
    result.push_back(static_cast<int>(at - seen.begin()));
    if (at == seen.end()) seen.push_back(set);
  }
  return result;
}

inline Classes classes(const SectionStack& stack, const CorrespondenceOptions& options = plain(),
                       const checking::Claims& claims = {}) {
  const auto expected = checking::expected_partition(stack, stack, options, claims);
  EXPECT_TRUE(expected.ok());
  if (!expected.ok()) return {};
  EXPECT_FALSE(expected->unrealised.has_value());
  return classes_of(*expected);
}

/// Labels as (section, contour, label).
inline CorrespondenceOptions labelled(const std::vector<std::array<std::uint32_t, 3>>& labels,
                                      CorrespondenceOptions options = plain()) {
  for (const auto& [s, c, l] : labels) options.labels.push_back({SectionId(s), ContourId(c), l});
  return options;
}

}  // namespace tetloft::testing

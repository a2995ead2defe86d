// Which contours form one component: the criteria of correspondence, as options and as a
// result. Decided in reconstruct/correspondence; recomputed independently by check.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include <tetloft/ids.hpp>
#include <tetloft/result.hpp>

namespace tetloft {

enum class Criterion : std::uint8_t {
  /// Regions of neighbouring sections are united when their overlap ratio r exceeds tau,
  /// unless r < 0.5 and both regions have another link of ratio ≥ 0.5 (in the same slab).
  overlap,
  /// Definition 2 of Nonato et al. (2000): united by a reverse tetrahedron.
  reverse,
};

inline constexpr double kDefaultOverlap = 0.02;
/// The guard of the overlap criterion: a link at least this strong is trusted, and
/// outrules weaker ones between two regions that both have one.
inline constexpr double kStrongOverlap = 0.5;

/// A user's label on one contour. It belongs to the whole region the contour bounds.
struct Label {
  SectionId section;
  ContourId contour;
  std::uint32_t label = 0;
};

struct CorrespondenceOptions {
  Criterion criterion = Criterion::overlap;
  double tau = kDefaultOverlap;
  /// Same label: same component; different labels: different components, whatever the
  /// geometry. Regions without label follow the criterion.
  std::vector<Label> labels;
};

/// A partition of the contours of a stack: class_of[section][contour], classes numbered in
/// order of their first contour by (section, contour).
using ContourPartition = IdVector<SectionId, IdVector<ContourId, ComponentId>>;

}  // namespace tetloft

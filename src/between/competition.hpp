// Where the shapes of several classes lie over each other, one of them has the sample.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include <tetloft/ids.hpp>

#include "between/class_shape.hpp"
#include "motion/lattice_window.hpp"
#include "slab/classes.hpp"

namespace tetloft::internal::between {

using ClassShapes = IdVector<ClassId, ClassShape>;

/// Two classes, first < second, whose windows have samples in common.
struct MeetingWindows {
  ClassId first, second;
  motion::LatticeWindow common;
};

/// In increasing order.
[[nodiscard]] std::vector<MeetingWindows> meeting_windows(const ClassShapes& shapes);

/// In every layer between: a sample inside several classes belongs to the one of the lowest value,
/// of equal ones to the first. For all others the value there is at least 1.15 times as far
/// outside, so that along no lattice edge contours of two classes touch or change places. Given
/// layers stay.
void compete(ClassShapes& shapes, const std::vector<MeetingWindows>& meetings);

/// To be called last before tracing: competes again, and brings the values of neighbouring samples
/// of two classes between −½ and −1/10, or both crossings between them might be moved to one point.
void part_contours(ClassShapes& shapes, const std::vector<MeetingWindows>& meetings);

/// The samples of a class's window that other classes have, layer by layer, each found when first
/// asked for. The others must not change meanwhile.
class ForeignSamples {
 public:
  ForeignSamples(const ClassShapes& shapes, const std::vector<MeetingWindows>& meetings, ClassId c);
  /// By place: not 0 where another class has the sample.
  [[nodiscard]] const std::vector<std::uint8_t>& in(std::size_t layer);

 private:
  const ClassShapes& shapes_;
  const std::vector<MeetingWindows>& meetings_;
  ClassId class_;
  std::vector<std::vector<std::uint8_t>> foreign_;  // by layer; empty where not asked for yet
};

}  // namespace tetloft::internal::between

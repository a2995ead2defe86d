// Slabs whose classes have fields made by hand.
#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <vector>

#include <tetloft/section_stack.hpp>

#include "between/competition.hpp"
#include "between/inner_sections.hpp"

namespace tetloft::testing {

/// The value at (x, y), in units of the stack, in a layer; negative inside.
using Field = std::function<double(double x, double y, std::size_t layer)>;

struct FieldClass {
  std::vector<Contour> lower, upper;  ///< all of its contours
  Field field;                        ///< of layers between; given ones get distances that do not
                                      ///< matter
};

/// A slab from z = 0 to 1 and its classes, with `between` layers at equal distances.
class FieldSlab {
 public:
  FieldSlab(const std::vector<FieldClass>& classes, double step, std::size_t between);
  FieldSlab(const FieldSlab&) = delete;
  FieldSlab& operator=(const FieldSlab&) = delete;

  [[nodiscard]] const internal::between::SlabShape& slab() const { return *slab_; }
  /// Fresh ones: sampled in windows around what is inside, with a border of two samples.
  [[nodiscard]] internal::between::ClassShapes shapes() const;

 private:
  std::vector<FieldClass> classes_;
  Section lower_, upper_;
  Nesting lower_nesting_, upper_nesting_;
  std::unique_ptr<internal::between::SlabShape> slab_;
};

/// An octagon about the centre, regular to three digits, from numbers that every machine has alike.
[[nodiscard]] Contour octagon(double x, double y, double radius);
[[nodiscard]] Contour rectangle(double x0, double y0, double x1, double y1);

/// Signed distances, in units of the stack.
[[nodiscard]] double to_disc(double x, double y, double cx, double cy, double radius);
[[nodiscard]] double to_box(double x, double y, double x0, double y0, double x1, double y1);

}  // namespace tetloft::testing

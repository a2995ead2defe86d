// The exact stages, entered where a filter is not certain.
#pragma once

#include <tetloft/predicates.hpp>

#include "predicates/counting.hpp"

namespace tetloft::predicates {

/// An exact sign and the stage that found it.
struct Answer {
  Sign sign;
  Stage stage;
};

[[nodiscard]] Answer exact_orient2d(const Point2& a, const Point2& b, const Point2& c);
[[nodiscard]] Answer exact_orient3d(const Point3& a, const Point3& b, const Point3& c,
                                    const Point3& d);
[[nodiscard]] Answer exact_incircle(const Point2& a, const Point2& b, const Point2& c,
                                    const Point2& d);
[[nodiscard]] Answer exact_insphere(const Point3& a, const Point3& b, const Point3& c,
                                    const Point3& d, const Point3& e);

}  // namespace tetloft::predicates

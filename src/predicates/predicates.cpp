// The four unperturbed predicates: filter, then the exact stages.
#include <tetloft/predicates.hpp>

#include "predicates/counting.hpp"
#include "predicates/exact.hpp"
#include "predicates/filter.hpp"

namespace tetloft {

using namespace internal;

using predicates::Answer;
using predicates::count_answer;
using predicates::Stages;

Sign orient2d(const Point2& a, const Point2& b, const Point2& c) {
  if (const int s = predicates::orient2d_filter(a, b, c); s != 0) {
    count_answer(&PredicateCounters::orient2d, &Stages::filter);
    return static_cast<Sign>(s);
  }
  const Answer exact = predicates::exact_orient2d(a, b, c);
  count_answer(&PredicateCounters::orient2d, exact.stage);
  return exact.sign;
}

Sign orient3d(const Point3& a, const Point3& b, const Point3& c, const Point3& d) {
  if (const int s = predicates::orient3d_filter(a, b, c, d); s != 0) {
    count_answer(&PredicateCounters::orient3d, &Stages::filter);
    return static_cast<Sign>(s);
  }
  const Answer exact = predicates::exact_orient3d(a, b, c, d);
  count_answer(&PredicateCounters::orient3d, exact.stage);
  return exact.sign;
}

Sign incircle(const Point2& a, const Point2& b, const Point2& c, const Point2& d) {
  if (const int s = predicates::incircle_filter(a, b, c, d); s != 0) {
    count_answer(&PredicateCounters::incircle, &Stages::filter);
    return static_cast<Sign>(s);
  }
  const Answer exact = predicates::exact_incircle(a, b, c, d);
  count_answer(&PredicateCounters::incircle, exact.stage);
  return exact.sign;
}

Sign insphere(const Point3& a, const Point3& b, const Point3& c, const Point3& d, const Point3& e) {
  if (const int s = predicates::insphere_filter(a, b, c, d, e); s != 0) {
    count_answer(&PredicateCounters::insphere, &Stages::filter);
    return static_cast<Sign>(s);
  }
  const Answer exact = predicates::exact_insphere(a, b, c, d, e);
  count_answer(&PredicateCounters::insphere, exact.stage);
  return exact.sign;
}

}  // namespace tetloft

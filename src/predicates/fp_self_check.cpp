// Verifies that compiled code and thread compute as the exact predicates need.
//
// What the compiler can be asked about is asserted; contraction, reassociation, flushing of
// denormals and the rounding mode leave no trace in macros, or belong to the running thread,
// and are observed. Operands are volatile, so that nothing is computed by the compiler.
#include <cfloat>
#include <limits>
#include <string>

#include <tetloft/predicates.hpp>

#ifdef __FAST_MATH__
#error "exact predicates need IEEE arithmetic: build without fast-math"
#endif
static_assert(std::numeric_limits<double>::is_iec559, "exact predicates need IEEE doubles");
static_assert(std::numeric_limits<double>::digits == 53, "exact predicates need IEEE doubles");
static_assert(FLT_EVAL_METHOD == 0, "exact predicates need results rounded to double at once");

namespace tetloft {

namespace {

/// (1 + 2^-30)² = 1 + 2^-29 + 2^-60 loses its last term by rounding; fused it survives.
bool contracts() {
  const volatile double a = 1 + 0x1p-30;
  const volatile double rounded_square = 1 + 0x1p-29;
  const double x = a;
  return x * x - rounded_square != 0;
}

/// (2^53 + 1) − 2^53 is 0 as written, by rounding to even, and 1 after reassociation; the
/// error of two_sum is 1 as written and 0 simplified.
bool reassociates() {
  const volatile double big_value = 0x1p+53;
  const volatile double one_value = 1;
  const double big = big_value;
  const double one = one_value;
  const double sum = big + one;
  const double one_virtual = sum - big;
  const double error = (big - (sum - one_virtual)) + (one - one_virtual);
  return sum - big != 0 || error != 1;
}

/// Rounding to nearest even: up and down at ties, and below and above them, both signs.
bool rounds_to_nearest_even() {
  const volatile double one = 1;
  const volatile double two = 1 + 0x1p-52;
  const volatile double tie = 0x1p-53;
  const volatile double more = 0x1p-53 + 0x1p-80;
  const volatile double less = 0x1p-53 - 0x1p-80;
  return one + tie == one && two + tie == 1 + 0x1p-51 && one + more == two && one + less == one &&
         -one - tie == -one && -two - tie == -1 - 0x1p-51 && -one - more == -two &&
         -one - less == -one;
}

/// A double rounding via a wider format would round this up: the exact sum lies just below a tie.
bool has_excess_precision() {
  const volatile double a = 1;
  const volatile double b = 0x1p-53 - 0x1p-106;
  const volatile double c = 1 + 0x1p-52;
  const volatile double d = 0x1p-53 - 0x1p-80;
  return a + b != a || (c + d) - c != 0;
}

/// Denormal results and denormal operands must survive (FTZ and DAZ).
bool flushes_denormals() {
  const volatile double least = std::numeric_limits<double>::denorm_min();
  const volatile double normal = std::numeric_limits<double>::min();
  const volatile double half = 0.5;
  const volatile double big = 0x1p+1000;
  return normal * half == 0 || least * big == 0 || least + least == least || !(least > 0) ||
         least * half != 0;
}

Error unfit(const char* what) {
  return {
      ErrorCode::unfit_arithmetic, std::string("floating-point environment unfit: ") + what, {}};
}

}  // namespace

Result<void> fp_self_check() {
  if (!rounds_to_nearest_even()) return unfit("not rounding to nearest even");
  if (contracts()) return unfit("products and sums are contracted");
  if (reassociates()) return unfit("sums are reassociated");
  if (has_excess_precision()) return unfit("excess precision");
  if (flushes_denormals()) return unfit("denormals are flushed to zero");
  return {};
}

}  // namespace tetloft

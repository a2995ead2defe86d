// The self-check passes here, and fails in every environment it is there to refuse.
#include <gtest/gtest.h>

#include <cfenv>
#include <string>

#include <tetloft/predicates.hpp>

#ifdef TETLOFT_TEST_X86
#include <xmmintrin.h>
#endif

namespace tetloft {

// Built from the same source with unfit flags (CMakeLists.txt).
Result<void> reassociated_self_check();
#ifdef TETLOFT_TEST_X86
Result<void> contracted_self_check();
#endif

namespace {

std::string complaint(const Result<void>& result) { return result ? "" : result.error().message; }

TEST(FpSelfCheck, PassesInTheDefaultEnvironment) { EXPECT_EQ(complaint(fp_self_check()), ""); }

TEST(FpSelfCheck, RefusesOtherRoundingModes) {
  for (const int mode : {FE_UPWARD, FE_DOWNWARD, FE_TOWARDZERO}) {
    std::fesetround(mode);
    const Result<void> result = fp_self_check();
    std::fesetround(FE_TONEAREST);
    EXPECT_NE(complaint(result).find("nearest"), std::string::npos) << mode;
  }
}

TEST(FpSelfCheck, RefusesReassociation) {
  EXPECT_NE(complaint(reassociated_self_check()).find("reassociated"), std::string::npos);
}

#ifdef TETLOFT_TEST_X86

TEST(FpSelfCheck, RefusesFlushedDenormals) {
  const unsigned control = _mm_getcsr();
  constexpr unsigned flush_to_zero = 0x8000;
  constexpr unsigned denormals_are_zero = 0x0040;
  for (const unsigned bit : {flush_to_zero, denormals_are_zero}) {
    _mm_setcsr(control | bit);
    const Result<void> result = fp_self_check();
    _mm_setcsr(control);
    EXPECT_NE(complaint(result).find("denormals"), std::string::npos) << bit;
  }
}

TEST(FpSelfCheck, RefusesContraction) {
  if (!__builtin_cpu_supports("fma")) GTEST_SKIP() << "no fused multiply-add here";
  EXPECT_NE(complaint(contracted_self_check()).find("contracted"), std::string::npos);
}

#endif

}  // namespace

}  // namespace tetloft

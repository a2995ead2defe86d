#include "robustness/sweep.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cstdlib>
#include <cstring>
#include <iostream>
#include <new>

#include "robustness/failing_allocator.hpp"

namespace tetloft::test {

namespace {

// FNV-1a, by 64 bits.
class Digest {
 public:
  template <class T>
  void add(T value) {
    if constexpr (std::is_same_v<T, double>) {
      mix(std::bit_cast<std::uint64_t>(value));
    } else {
      mix(static_cast<std::uint64_t>(value));
    }
  }
  [[nodiscard]] std::uint64_t value() const { return state_; }

 private:
  void mix(std::uint64_t word) { state_ = (state_ ^ word) * 0x100000001B3ULL; }
  std::uint64_t state_ = 0xCBF29CE484222325ULL;
};

bool everything() {
  const char* const asked = std::getenv("TETLOFT_SWEEP");
  return asked != nullptr && std::strcmp(asked, "all") == 0;
}

}  // namespace

std::uint64_t digest(const Model& model) {
  Digest sum;
  for (const Point3& p : model.points) {
    for (const double c : {p.x, p.y, p.z}) sum.add(c);
  }
  for (const TetVertices& tet : model.tets) {
    for (const VertexId v : tet) sum.add(v.value());
  }
  return sum.value();
}

std::uint64_t digest(const SectionStack& stack) {
  Digest sum;
  for (const Section& section : stack.sections) {
    for (const Contour& contour : section.contours) {
      sum.add(contour.vertices.size());
      for (const Point2& p : contour.vertices) {
        sum.add(p.x);
        sum.add(p.y);
      }
    }
  }
  return sum.value();
}

std::uint64_t digest(const CheckReport& report) {
  Digest sum;
  for (const GuaranteeVerdict& verdict : report.guarantees) {
    for (const CheckFailure& failure : verdict.failures) {
      for (const char c : failure.what) sum.add(c);
      sum.add(failure.count);
    }
  }
  sum.add(report.volume);
  sum.add(report.overshoot);
  return sum.value();
}

Ended ended_throwing(const std::function<void()>& call) {
  try {
    call();
  } catch (const std::bad_alloc&) {
    return {ErrorCode::out_of_memory, 0};
  }
  return {};
}

void sweep(const std::string& name, const std::function<Ended()>& call,
           const std::function<bool()>& intact, std::size_t some) {
  const Ended usual = call();  // also fills what is made once in a process
  ASSERT_TRUE(intact()) << name;
  constexpr std::size_t kNever = static_cast<std::size_t>(-1);
  arm_allocator(kNever, Failing::once);
  static_cast<void>(call());
  const std::size_t allocations = disarm_allocator();
  ASSERT_TRUE(intact()) << name;
  const std::size_t stride = everything() ? 1 : std::max<std::size_t>(1, allocations / some);
  std::size_t points = 0;
  std::size_t survived = 0;
  for (const Failing how : {Failing::once, Failing::from_there}) {
    for (std::size_t n = 1; n <= allocations; n += stride) {
      const long before = live_blocks();
      arm_allocator(n, how);
      const Ended end = call();
      const bool failed = allocator_failed();
      disarm_allocator();
      const bool is_intact = intact();
      const long after = live_blocks();
      ++points;
      if (end == usual) ++survived;
      ASSERT_TRUE(end.error == ErrorCode::out_of_memory || end == usual)
          << name << ", allocation " << n << " of " << allocations << ": ended with "
          << (end.error ? name_of(*end.error) : "another value");
      ASSERT_TRUE(failed || end == usual) << name << ", allocation " << n;
      ASSERT_EQ(after, before) << name << ", allocation " << n << " of " << allocations
                               << ": blocks not given back";
      ASSERT_TRUE(is_intact) << name << ", allocation " << n << " of " << allocations;
    }
  }
  std::cout << "[   sweep  ] " << name << ": " << allocations << " allocations, " << points
            << " failure points, " << survived << " done without\n";
}

}  // namespace tetloft::test

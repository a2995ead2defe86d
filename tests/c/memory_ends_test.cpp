// Every function of tetloft.h with memory that ends at each of its allocations: a status, nothing
// lost, and no handle left behind.
#include <gtest/gtest.h>

#include <new>

#include "c/calls/calls.hpp"
#include "c/calls/spoiled.hpp"
#include "c/sample_files.hpp"
#include "robustness/failing_allocator.hpp"
#include "robustness/sweep.hpp"

namespace tetloft::c_test {
namespace {

test::Ended ended(tetloft_status status) {
  if (status == TETLOFT_OK) return {};
  return {static_cast<ErrorCode>(status), 0};
}

TEST(MemoryEndsInC, InEveryFunction) {
  const RightHandles handles;
  const SampleFolder folder;
  const std::string path = folder.path();
  for (const Call& call : all_calls()) {
    test::sweep(call.function, [&] {
      try {
        SpoiledArguments arguments(handles, path);
        const test::Ended end = ended(call.call(arguments));
        EXPECT_TRUE(!end.error || arguments.outputs_are_clear()) << call.function;
        return end;
      } catch (const std::bad_alloc&) {  // of the arguments
        return test::Ended{ErrorCode::out_of_memory, 0};
      }
    });
    if (HasFatalFailure()) return;
  }
}

// The text of a failure that has no memory left is a fixed one; that of another takes its place
// as soon as there is some.
TEST(MemoryEndsInC, WhileAFailureIsTold) {
  const std::string path(300, 'x');
  tetloft_stack* stack = nullptr;
  const auto call = [&] { return tetloft_stack_read(path.c_str(), nullptr, &stack, nullptr); };
  ASSERT_EQ(call(), TETLOFT_IO);
  const std::string usual = tetloft_last_error();
  bool ended_once = false;
  for (std::size_t n = 1; n < 100; ++n) {
    test::arm_allocator(n, test::Failing::from_there);
    const tetloft_status status = call();
    const bool failed = test::allocator_failed();
    test::disarm_allocator();
    if (status == TETLOFT_OUT_OF_MEMORY) {
      ended_once = true;
      EXPECT_STREQ(tetloft_last_message(), "out of memory");
    } else {
      EXPECT_EQ(status, TETLOFT_IO);
      EXPECT_EQ(tetloft_last_error(), usual);
    }
    if (!failed) break;
  }
  EXPECT_TRUE(ended_once);
}

}  // namespace
}  // namespace tetloft::c_test

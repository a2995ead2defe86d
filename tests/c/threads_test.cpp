// Handles in the hands of several threads: freed by one while others use them, every call ends with
// a status, and with the right value if it succeeds.
#include <gtest/gtest.h>

#include <array>
#include <atomic>
#include <thread>

#include "c/calls/calls.hpp"
#include "c/calls/spoiled.hpp"
#include "c/owned.hpp"
#include "c/sample_files.hpp"

namespace tetloft::c_test {
namespace {

constexpr std::size_t kThreads = 4;

template <class Body>
void in_threads(Body&& body) {
  std::vector<std::thread> threads;
  for (std::size_t t = 0; t < kThreads; ++t) threads.emplace_back([&body, t] { body(t); });
  for (std::thread& thread : threads) thread.join();
}

TEST(ThreadsOfC, AHandleThatIsFreedMeanwhileIsUsedOrRefused) {
  constexpr int kRounds = 200;
  std::atomic<std::size_t> used{0};
  std::atomic<std::size_t> freed{0};
  std::atomic<std::size_t> refused{0};
  for (int round = 0; round < kRounds; ++round) {
    auto* const stack = static_cast<tetloft_stack*>(new_handle(Kind::stack));
    in_threads([&](std::size_t t) {
      for (int i = 0; i < 4; ++i) {
        if (t == 0 && i == 2) {
          EXPECT_OK(tetloft_stack_free(stack));
          ++freed;
          continue;
        }
        tetloft_write_options options;
        tetloft_write_options_defaults(&options);
        options.format = "cnt";
        Owned<tetloft_bytes> bytes;
        const tetloft_status status = tetloft_stack_format(stack, &options, bytes.out(), nullptr);
        if (status == TETLOFT_OK) {
          ++used;
          EXPECT_EQ(bytes_of(bytes).substr(0, 3), "S 2");
        } else {
          ++refused;
          EXPECT_EQ(status, TETLOFT_BAD_HANDLE);
          EXPECT_STREQ(tetloft_last_error(), "stack must be a stack, but was freed or never made");
        }
      }
    });
  }
  EXPECT_EQ(freed, static_cast<std::size_t>(kRounds));
  EXPECT_GT(used, 0U);
  EXPECT_GT(refused, 0U);
}

TEST(ThreadsOfC, OneOfThoseWhoFreeSucceeds) {
  for (int round = 0; round < 100; ++round) {
    void* const handle = new_handle(Kind::model);
    std::atomic<int> succeeded{0};
    in_threads([&](std::size_t) {
      const tetloft_status status = free_handle(Kind::model, handle);
      if (status == TETLOFT_OK) {
        ++succeeded;
      } else {
        EXPECT_EQ(status, TETLOFT_BAD_HANDLE);
      }
    });
    EXPECT_EQ(succeeded, 1);
  }
}

// All functions at once, on the same handles, with arguments right and wrong.
TEST(ThreadsOfC, EveryFunctionCanBeCalledByAll) {
  const RightHandles handles;
  const SampleFolder folder;

  const std::string path = folder.path();
  in_threads([&](std::size_t t) {
    const std::vector<Call> calls = all_calls();
    for (std::size_t i = 0; i < calls.size(); ++i) {
      const Call& call = calls[(i + t * calls.size() / kThreads) % calls.size()];
      // Neither one file written by all, nor a stop pressed that all have.
      const std::string_view name = call.function;
      if (name.find("_write") != name.npos || name == "tetloft_stop_request") continue;
      SpoiledArguments right(handles, path);
      EXPECT_EQ(call.call(right), TETLOFT_OK) << call.function << ": " << tetloft_last_error();
      if (right.requests().empty()) continue;
      SpoiledArguments spoiled(handles, path, 0, 1);
      call.call(spoiled);
    }
  });
}

TEST(ThreadsOfC, AStopIsPressedFromAnother) {
  Owned<tetloft_stop> stop;
  ASSERT_OK(tetloft_stop_create(stop.out()));
  tetloft_execution execution;
  ASSERT_OK(tetloft_execution_defaults(&execution));
  execution.stop = stop;
  execution.user = stop;
  // Another thread presses it while the call is in work.
  execution.progress = [](void* user, std::size_t, std::size_t) {
    std::thread([user] { tetloft_stop_request(static_cast<tetloft_stop*>(user)); }).join();
    return 0;
  };
  tetloft_reconstruct_options options;
  ASSERT_OK(tetloft_reconstruct_options_defaults(&options));
  options.execution = &execution;
  Owned<tetloft_stack> stack;
  *stack.out() = static_cast<tetloft_stack*>(new_handle(Kind::stack));
  Owned<tetloft_model> model;
  EXPECT_EQ(tetloft_reconstruct(stack, &options, model.out(), nullptr), TETLOFT_CANCELLED);
}

}  // namespace
}  // namespace tetloft::c_test

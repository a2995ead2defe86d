#include "core/parallel.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

namespace tetloft {

using namespace internal;
namespace {

TEST(ThreadCount, IsWhatWasAskedForOrAtLeastOne) {
  EXPECT_EQ(thread_count(3), 3U);
  EXPECT_GE(thread_count(0), 1U);
}

TEST(ParallelFor, CallsEachIndexOnce) {
  for (const unsigned threads : {0U, 1U, 2U, 7U}) {
    for (const std::size_t n :
         {std::size_t{0}, std::size_t{1}, std::size_t{2}, std::size_t{1000}}) {
      std::vector<std::atomic<int>> calls(n);
      parallel_for(n, threads, [&](std::size_t i) { ++calls.at(i); });
      for (const auto& count : calls) EXPECT_EQ(count.load(), 1);
    }
  }
}

TEST(ParallelFor, OnOneThreadRunsInOrderOnTheCallers) {
  std::vector<std::size_t> order;
  const auto caller = std::this_thread::get_id();
  parallel_for(20, 1, [&](std::size_t i) {
    order.push_back(i);
    EXPECT_EQ(std::this_thread::get_id(), caller);
  });
  for (std::size_t i = 0; i < order.size(); ++i) EXPECT_EQ(order[i], i);
  EXPECT_EQ(order.size(), 20U);
}

TEST(ParallelFor, RethrowsTheExceptionOfTheLowestIndex) {
  // Index 0 throws late, after all others that are running have thrown.
  for (const unsigned threads : {1U, 2U, 4U}) {
    try {
      parallel_for(8, threads, [](std::size_t i) {
        if (i == 0) std::this_thread::sleep_for(std::chrono::milliseconds(50));
        throw std::runtime_error(std::to_string(i));
      });
      FAIL() << "nothing thrown";
    } catch (const std::runtime_error& e) {
      EXPECT_STREQ(e.what(), "0");
    }
  }
}

TEST(ParallelFor, EndsStartedIterationsBeforeItRethrows) {
  std::atomic<int> running{0};
  EXPECT_THROW(parallel_for(64, 4,
                            [&](std::size_t i) {
                              ++running;
                              std::this_thread::sleep_for(std::chrono::milliseconds(1));
                              --running;
                              if (i == 5) throw std::runtime_error("five");
                            }),
               std::runtime_error);
  EXPECT_EQ(running.load(), 0);
}

}  // namespace
}  // namespace tetloft

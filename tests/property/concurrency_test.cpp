// Many reconstructions at once, stops from elsewhere, callbacks that throw. Run with the thread
// sanitizer too.
#include <gtest/gtest.h>

#include <atomic>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

#include <tetloft/reconstruct.hpp>

#include "property/same_model.hpp"
#include "support/stacks/generate.hpp"

namespace tetloft::testing {
namespace {

constexpr std::uint64_t kSeed = 900;

Result<Reconstruction> run(const GeneratedStack& generated, ReconstructOptions options = {}) {
  options.correspondence = generated.correspondence;
  return reconstruct(generated.stack, options);
}

bool same(const Result<Reconstruction>& a, const Result<Reconstruction>& b) {
  if (a.ok() != b.ok()) return false;
  if (!a.ok()) return to_string(a.error()) == to_string(b.error());
  return same_bits(a->model, b->model);
}

TEST(Concurrency, ManyReconstructionsAtOnceGiveWhatEachGivesAlone) {
  std::vector<GeneratedStack> stacks;
  for (const StackKind kind : all_kinds()) stacks.push_back(generate(kind, kSeed));
  std::vector<Result<Reconstruction>> alone;
  ReconstructOptions one;
  one.execution.threads = 1;
  for (const GeneratedStack& stack : stacks) alone.push_back(run(stack, one));

  std::atomic<int> differ{0};
  std::vector<std::thread> threads;
  for (std::size_t t = 0; t < 4; ++t) {
    threads.emplace_back([&, t] {
      ReconstructOptions options;
      options.execution.threads = 1 + static_cast<unsigned>(t % 3);
      for (std::size_t k = 0; k < stacks.size(); ++k) {
        const std::size_t i = (k + t * 5) % stacks.size();
        if (!same(run(stacks[i], options), alone[i])) ++differ;
      }
    });
  }
  for (std::thread& thread : threads) thread.join();
  EXPECT_EQ(differ, 0);
}

TEST(Concurrency, AStopEndsIt) {
  const GeneratedStack generated = generate(StackKind::nesting, kSeed);
  std::stop_source source;
  ReconstructOptions options;
  options.execution.stop = source.get_token();
  ASSERT_TRUE(run(generated, options).ok());
  source.request_stop();
  const auto stopped = run(generated, options);
  ASSERT_FALSE(stopped.ok());
  EXPECT_EQ(stopped.error().code, ErrorCode::cancelled);
  EXPECT_TRUE(run(generated).ok());
}

TEST(Concurrency, AStopFromAnotherThreadEndsItMidway) {
  SectionStack tall = generate(StackKind::lattice_marching_squares, kSeed).stack;
  const std::vector<Section> few = tall.sections.raw();
  while (tall.sections.size() < 60) {
    Section next = few[tall.sections.size() % few.size()];
    next.z = static_cast<double>(tall.sections.size()) + 1000;
    tall.sections.push_back(next);
  }
  std::stop_source source;
  std::atomic<bool> begun{false};
  std::thread stopper([&] {
    while (!begun) std::this_thread::yield();
    source.request_stop();
  });
  ReconstructOptions options;
  options.execution.threads = 3;
  options.execution.stop = source.get_token();
  options.execution.progress = [&](std::size_t done, std::size_t) {
    if (done < 10) return;
    begun = true;
    // Not to be overtaken by the end of the work.
    while (!source.stop_requested()) std::this_thread::yield();
  };
  const auto stopped = reconstruct(tall, options);
  stopper.join();
  ASSERT_FALSE(stopped.ok());
  EXPECT_EQ(stopped.error().code, ErrorCode::cancelled);
}

TEST(Concurrency, WhatACallbackThrowsEndsItCleanly) {
  const GeneratedStack generated = generate(StackKind::holes, kSeed);
  for (const unsigned threads : {1U, 3U}) {
    for (const bool is_standard : {true, false}) {
      ReconstructOptions options;
      options.execution.threads = threads;
      options.execution.progress = [&](std::size_t done, std::size_t) {
        if (done < 2) return;
        if (is_standard) throw std::runtime_error("enough");
        throw 42;
      };
      const auto ended = run(generated, options);
      ASSERT_FALSE(ended.ok());
      EXPECT_EQ(ended.error().code, ErrorCode::cancelled);
      EXPECT_EQ(ended.error().message.find("enough") != std::string::npos, is_standard);
    }
  }
}

}  // namespace
}  // namespace tetloft::testing

// Progress and stop tokens: the same contract for all that takes long.
#include <gtest/gtest.h>

#include <functional>
#include <map>
#include <mutex>
#include <stdexcept>
#include <stop_token>
#include <string>
#include <utility>
#include <vector>

#include <tetloft/tetloft.hpp>

#include "robustness/inputs.hpp"

namespace tetloft::test {
namespace {

using Progress = std::function<void(std::size_t, std::size_t)>;
using Watched = std::function<Result<void>(const std::stop_token&, const Progress&)>;

template <class T>
Result<void> outcome(const Result<T>& result) {
  return result ? Result<void>() : Result<void>(result.error());
}

class LongFunctions : public ::testing::Test {
 protected:
  SectionStack stack_ = tower(4);
  Model model_ = model_of(stack_);

  // By name, on one and on several threads.
  [[nodiscard]] std::vector<std::pair<std::string, Watched>> all() const {
    std::vector<std::pair<std::string, Watched>> functions;
    for (const unsigned threads : {1U, 3U}) {
      const std::string on = " on " + std::to_string(threads);
      functions.emplace_back(
          "reconstruct" + on, [this, threads](const auto& stop, const auto& progress) {
            return outcome(
                reconstruct(stack_, {.threads = threads, .stop = stop, .progress = progress}));
          });
      functions.emplace_back(
          "geiger" + on, [this, threads](const auto& stop, const auto& progress) {
            return outcome(reconstruct_geiger(
                stack_, {.threads = threads, .stop = stop, .progress = progress}));
          });
      functions.emplace_back("check" + on, [this, threads](const auto& stop, const auto& progress) {
        return outcome(
            check(model_, stack_, {.threads = threads, .stop = stop, .progress = progress}));
      });
    }
    using Render = Result<std::string> (*)(const Model&, const SectionStack*, const RenderOptions&);
    for (const auto& [name, render] : std::map<std::string, Render>{
             {"png", render_png}, {"svg", render_svg}, {"html", render_html}}) {
      functions.emplace_back(name, [this, render = render](const auto& stop, const auto& progress) {
        return outcome(render(model_, &stack_,
                              {.width = 60, .height = 40, .stop = stop, .progress = progress}));
      });
    }
    return functions;
  }
};

TEST_F(LongFunctions, TellEachStepOnceUpToTheLast) {
  for (const auto& entry : all()) {
    const std::string& name = entry.first;
    const auto& function = entry.second;
    std::mutex mutex;
    std::size_t calls = 0;
    std::size_t last = 0;
    const Progress progress = [&](std::size_t done, std::size_t steps) {
      ASSERT_TRUE(mutex.try_lock()) << name << ": two calls at a time";
      const std::scoped_lock lock(std::adopt_lock, mutex);
      EXPECT_EQ(done, ++calls) << name;
      EXPECT_LE(done, steps) << name;
      if (last != 0) {
        EXPECT_EQ(steps, last) << name;
      }
      last = steps;
    };
    ASSERT_TRUE(function({}, progress)) << name;
    EXPECT_GE(calls, 4U) << name;
    EXPECT_EQ(calls, last) << name;
  }
}

TEST_F(LongFunctions, EndCancelledWhereTheCallbackThrowsWhateverAndWhenever) {
  for (const auto& [name, function] : all()) {
    for (std::size_t when = 1; when <= 4; ++when) {
      const Result<void> failed = function({}, [&](std::size_t done, std::size_t) {
        if (done == when) throw std::runtime_error("enough");
      });
      ASSERT_FALSE(failed) << name << ", call " << when;
      EXPECT_EQ(failed.error().code, ErrorCode::cancelled) << name;
      EXPECT_NE(failed.error().message.find("enough"), std::string::npos) << name;
      const Result<void> odd = function({}, [&](std::size_t done, std::size_t) {
        if (done == when) throw 7;
      });
      ASSERT_FALSE(odd) << name << ", call " << when;
      EXPECT_EQ(odd.error().code, ErrorCode::cancelled) << name;
    }
  }
}

TEST_F(LongFunctions, EndCancelledOnceAStopIsRequested) {
  for (const auto& [name, function] : all()) {
    for (std::size_t when = 0; when <= 3; ++when) {
      std::stop_source source;
      if (when == 0) source.request_stop();
      const Result<void> stopped = function(source.get_token(), [&](std::size_t done, std::size_t) {
        if (done == when) source.request_stop();
      });
      ASSERT_FALSE(stopped) << name << ", call " << when;
      EXPECT_EQ(stopped.error().code, ErrorCode::cancelled) << name;
    }
  }
}

}  // namespace
}  // namespace tetloft::test

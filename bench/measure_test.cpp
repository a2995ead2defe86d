// Failures of a contestant are its own, and are named.
#include "measure.hpp"

#include <gtest/gtest.h>

#include <csignal>
#include <stdexcept>

#include <unistd.h>

namespace tetloft::bench {
namespace {

// Within a test, Run is a member of its base.
using Outcome = Run;

const Contestant kGood{"good",
                       [] {
                         (void)orient2d({0, 0}, {1, 0}, {0, 1});
                         return Run{0.5, 7, {{"read", 0.25}, {"write", 0.125}}};
                       },
                       true};

// The failure of a contestant that runs between two good ones, which must not suffer.
std::string failure_of(const Runner& run) {
  const auto measured = measure({kGood, {"bad", run}, kGood}, 2, 0.5);
  for (const std::size_t i : {0U, 2U}) {
    EXPECT_TRUE(measured[i].valid());
    EXPECT_EQ(measured[i].seconds.size(), 2U);
  }
  EXPECT_FALSE(measured[1].valid());
  EXPECT_EQ(measured[1].name, "bad");
  return measured[1].failure;
}

TEST(Measure, TellsWhatAContestantThrew) {
  EXPECT_EQ(failure_of([]() -> Outcome { throw std::runtime_error("no room"); }), "no room");
  EXPECT_EQ(failure_of([]() -> Outcome { throw 1; }), "threw what is no std::exception");
}

TEST(Measure, EndsAContestantAtTheLimit) {
  EXPECT_EQ(failure_of([]() -> Outcome {
              for (;;) pause();
            }),
            "beyond the limit of 0.5 s");
}

TEST(Measure, TellsACrashFromALimit) {
  EXPECT_EQ(failure_of([]() -> Outcome { _exit(3); }), "exited with code 3");
  EXPECT_EQ(failure_of([]() -> Outcome {
              raise(SIGKILL);
              return {};
            }).substr(0, 7),
            "crashed");
}

TEST(Measure, ReturnsStepsAndCounts) {
  const auto measured = measure({kGood}, 1, 10);
  EXPECT_EQ(measured[0].best(), 0.5);
  EXPECT_EQ(measured[0].simplices, 7U);
  ASSERT_EQ(measured[0].steps.size(), 2U);
  EXPECT_EQ(measured[0].steps[1], (std::pair<std::string, double>{"write", 0.125}));
  ASSERT_TRUE(measured[0].counters);
  EXPECT_EQ(measured[0].counters->orient2d.filter, 1U);
  EXPECT_GT(measured[0].peak_megabytes, 0);
}

TEST(Measure, DoesNotRunWhoIsLeftOut) {
  const auto measured =
      measure({{"big", [] { return Outcome{}; }, false, "too many points"}}, 2, 10);
  EXPECT_FALSE(measured[0].valid());
  EXPECT_TRUE(measured[0].seconds.empty());
  EXPECT_EQ(measured[0].left_out, "too many points");
}

}  // namespace
}  // namespace tetloft::bench

// Threads that the system does not give, and whose time the steps' seconds are.
#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <ctime>
#include <numeric>
#include <thread>
#include <vector>

#include <tetloft/tetloft.hpp>

#include "core/cpu_clock.hpp"
#include "core/parallel.hpp"
#include "robustness/failing_threads.hpp"
#include "robustness/inputs.hpp"

namespace tetloft::test {

using namespace internal;
namespace {

TEST(Threads, ThatCannotBeMadeAreDoneWithout) {
  const SectionStack stack = tower(12);
  const Model expected = model_of(stack);
  const Model geiger = reconstruct_geiger(stack, {.execution = {.threads = 1}}).value().model;
  std::vector<Point3> planes;
  for (const Section& section : tower(2, 40).sections) {
    for (const Contour& contour : section.contours) {
      for (const Point2& p : contour.vertices) planes.push_back({p.x, p.y, section.z});
    }
  }
  const std::size_t tets = delaunay3(planes).value().mesh.tet_count();
  const std::vector<Point3> space = many_points_in_space();
  const TetMesh in_space = delaunay3(space, {.execution = {.threads = 1}}).value().mesh;
  for (const std::size_t most : {std::size_t{0}, std::size_t{1}, std::size_t{5}}) {
    for (const unsigned threads : {2U, 16U, 1000U}) {
      const FewThreads few(most);
      const Result<Reconstruction> made = reconstruct(stack, {.execution = {.threads = threads}});
      ASSERT_TRUE(made) << to_string(made.error());
      EXPECT_EQ(made->model.points, expected.points);
      EXPECT_EQ(made->model.tets, expected.tets);
      if (threads > most + 1) {
        EXPECT_GT(FewThreads::refused(), 0U);
      }
      EXPECT_EQ(reconstruct_geiger(stack, {.execution = {.threads = threads}}).value().model.tets,
                geiger.tets);
      EXPECT_TRUE(validate(stack, {.threads = threads}));
      EXPECT_TRUE(check(expected, stack, {.execution = {.threads = threads}}).value().pass());
      EXPECT_EQ(delaunay3(planes, {.execution = {.threads = threads}}).value().mesh.tet_count(),
                tets);
      EXPECT_TRUE(std::ranges::equal(
          delaunay3(space, {.execution = {.threads = threads}}).value().mesh.tets(),
          in_space.tets()));
    }
  }
}

TEST(Threads, GiveTheSameReportOfCheckHoweverMany) {
  const SectionStack stack = tower(6);
  const Model model = model_of(tower(6, 9));  // of another stack: failures of several kinds
  const CheckReport alone = check(model, stack, {.execution = {.threads = 1}}).value();
  EXPECT_FALSE(alone.pass());
  for (const unsigned threads : {0U, 2U, 4U, 7U}) {
    const CheckReport report = check(model, stack, {.execution = {.threads = threads}}).value();
    ASSERT_EQ(report.guarantees.size(), alone.guarantees.size());
    for (std::size_t g = 0; g < alone.guarantees.size(); ++g) {
      const auto& expected = alone.guarantees[g].failures;
      const auto& failures = report.guarantees[g].failures;
      EXPECT_EQ(report.guarantees[g].number, static_cast<int>(g) + 1);
      ASSERT_EQ(failures.size(), expected.size());
      for (std::size_t f = 0; f < failures.size(); ++f) {
        EXPECT_EQ(failures[f].what, expected[f].what);
        EXPECT_EQ(failures[f].count, expected[f].count);
        EXPECT_EQ(failures[f].places, expected[f].places);
      }
    }
    EXPECT_EQ(report.volume, alone.volume);
    EXPECT_EQ(report.genus, alone.genus);
  }
}

double process_seconds() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

// Clocks tick; std::clock in microseconds at best.
constexpr double kTick = 0.011;

void spin(double seconds) {
  const WorkStopwatch watch;
  while (watch.seconds() < seconds) {
  }
}

TEST(WorkStopwatch, CountsTheWorkOfHelpersAndNoWaiting) {
  for (const unsigned threads : {1U, 2U, 8U}) {
    const WorkStopwatch watch;
    parallel_for(8, threads, [](std::size_t) {
      spin(0.005);
      std::this_thread::sleep_for(std::chrono::milliseconds(10));
    });
    EXPECT_GE(watch.seconds(), 8 * 0.005) << threads;
    EXPECT_LT(watch.seconds(), 8 * 0.010) << threads;
  }
}

TEST(WorkStopwatch, CountsHelpersOfHelpers) {
  const WorkStopwatch watch;
  parallel_for(2, 2, [](std::size_t) { parallel_for(3, 3, [](std::size_t) { spin(0.003); }); });
  EXPECT_GE(watch.seconds(), 6 * 0.003);
}

TEST(StepSeconds, AreTheProcessorsOfAllThreadsAndNotTheClocks) {
  const SectionStack stack = tower(40, 60);
  for (const unsigned threads : {1U, 4U, 16U}) {
    ReconstructOptions options;
    options.execution.threads = threads;
    options.execution.progress = [](std::size_t, std::size_t) {
      std::this_thread::sleep_for(std::chrono::milliseconds(2));
    };
    const double before = process_seconds();
    const Result<Reconstruction> made = reconstruct(stack, options);
    const double used = process_seconds() - before;
    ASSERT_TRUE(made);
    const auto& seconds = made->report.seconds;
    const double sum = std::accumulate(seconds.begin(), seconds.end(), 0.0);
    EXPECT_LE(sum, used + kTick) << threads << " threads";
    EXPECT_GE(sum, 0.7 * used - kTick) << threads << " threads";
    for (const double step : seconds) EXPECT_GE(step, 0);
    EXPECT_GE(made->report.seconds_total, 0.002 * 79);
  }
}

}  // namespace
}  // namespace tetloft::test

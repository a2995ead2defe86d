// Progress and stop tokens: the same contract for all that takes long.
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <map>
#include <mutex>
#include <span>
#include <stdexcept>
#include <stop_token>
#include <string>
#include <utility>
#include <vector>

#include <tetloft/tetloft.hpp>

#include "robustness/inputs.hpp"
#include "support/temp_files.hpp"

namespace tetloft::test {
namespace {

using Progress = std::function<void(std::size_t, std::size_t)>;
using Watched = std::function<Result<void>(const std::stop_token&, const Progress&)>;

Result<void> outcome(const Result<void>& result) { return result; }

template <class T>
Result<void> outcome(const Result<T>& result) {
  return result ? Result<void>() : Result<void>(result.error());
}

using NamedFunction = std::pair<std::string, Watched>;

// Adds what takes an Execution, on so many threads.
class FunctionsOn {
 public:
  FunctionsOn(unsigned threads, std::vector<NamedFunction>& all) : threads_(threads), all_(all) {}

  template <class Function>
  void add(const std::string& name, Function function) {
    all_.emplace_back(
        name + " on " + std::to_string(threads_),
        [threads = threads_, function](const auto& stop, const auto& progress) {
          return outcome(function({.threads = threads, .stop = stop, .progress = progress}));
        });
  }

 private:
  unsigned threads_;
  std::vector<NamedFunction>& all_;
};

// Not on two planes, nor in a row.
std::vector<Point3> scattered(std::size_t n) {
  std::vector<Point3> points;
  for (std::size_t i = 0; i < n; ++i) {
    const auto k = static_cast<double>(i);
    points.push_back({std::fmod(k * 0.6180339887, 1), std::fmod(k * 0.4142135624, 1),
                      std::fmod(k * 0.7320508076, 1)});
  }
  return points;
}

std::vector<Point2> flattened(const std::vector<Point3>& points) {
  std::vector<Point2> flat;
  for (const Point3& p : points) flat.push_back({p.x, p.y});
  return flat;
}

class LongFunctions : public ::testing::Test {
 protected:
  SectionStack stack_ = tower(4);
  SectionStack tall_ = tower(12);
  Model model_ = model_of(stack_);
  std::vector<Point3> points_ = scattered(4000);
  std::vector<Point2> flat_ = flattened(scattered(17000));
  TempFolder folder_;

  // What takes its Execution by itself, or in options with nothing else of interest.
  void add_parts(FunctionsOn& functions) const {
    functions.add("reconstruct",
                  [this](const Execution& e) { return reconstruct(stack_, {.execution = e}); });
    functions.add("geiger", [this](const Execution& e) {
      return reconstruct_geiger(stack_, {.execution = e});
    });
    functions.add("check",
                  [this](const Execution& e) { return check(model_, stack_, {.execution = e}); });
    functions.add("validate", [this](const Execution& e) { return validate(tall_, e); });
    functions.add("repair", [this](const Execution& e) { return repair(tall_, {.execution = e}); });
    functions.add("snap", [this](const Execution& e) { return snap(tall_, 20, e); });
    functions.add("refine", [this](const Execution& e) { return refine(tall_, 0.5, e); });
    functions.add("delaunay2", [this](const Execution& e) { return delaunay2(flat_, e); });
    functions.add("conforming_delaunay2", [this](const Execution& e) {
      return conforming_delaunay2(flat_, {}, {.execution = e});
    });
    functions.add("conform", [](const Execution& e) {
      Section section;
      section.contours.push_back(polygon({0, 0}, 10, 17000));
      return conform(section, SectionId(0), {.execution = e});
    });
    functions.add("delaunay3, incremental", [this](const Execution& e) {
      return delaunay3(points_, {.engine = DelaunayEngine::incremental, .execution = e});
    });
    functions.add("delaunay3, slab", [this](const Execution& e) {
      std::vector<Point3> planes = points_;
      for (std::size_t i = 0; i < planes.size(); ++i) planes[i].z = i < 2000 ? 0 : 1;
      return delaunay3(planes, {.engine = DelaunayEngine::slab, .execution = e});
    });
  }

  // What writes files, and reads them again.
  void add_pieces(FunctionsOn& functions) const {
    functions.add("write_plan", [this](const Execution& e) {
      return write_plan(folder_.file("made.plan"), tall_, {.execution = e});
    });
    functions.add("write_streamed", [this](const Execution& e) {
      return write_streamed(folder_.file("streamed.vtu"), tall_, {.execution = e});
    });
    const std::string plan = folder_.file("plan");
    const std::string piece = folder_.file("piece.vtu");
    EXPECT_TRUE(write_plan(plan, tall_));
    EXPECT_TRUE(write_piece(piece, plan, 0, tall_.sections.size() - 1));
    functions.add("write_piece", [this, plan](const Execution& e) {
      return write_piece(folder_.file("made.vtu"), plan, 0, 9, {.execution = e});
    });
    functions.add("check_pieces", [this, piece](const Execution& e) {
      return check_pieces(std::span(&piece, 1), tall_, {.execution = e});
    });
  }

  // By name, on one and on several threads.
  [[nodiscard]] std::vector<NamedFunction> all() const {
    std::vector<NamedFunction> functions;
    for (const unsigned threads : {1U, 3U}) {
      FunctionsOn on(threads, functions);
      add_parts(on);
      add_pieces(on);
    }
    using Render = Result<std::string> (*)(const Model&, const SectionStack*, const RenderOptions&);
    for (const auto& [name, render] : std::map<std::string, Render>{
             {"png", render_png}, {"svg", render_svg}, {"html", render_html}}) {
      functions.emplace_back(name, [this, render = render](const auto& stop, const auto& progress) {
        return outcome(
            render(model_, &stack_,
                   {.width = 60, .height = 40, .execution = {.stop = stop, .progress = progress}}));
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

TEST_F(LongFunctions, AreStoppedInTheirOneStepToo) {
  const Triangulation2 plane =
      conform(stack_.sections[SectionId(0)], SectionId(0)).value().triangulation;
  std::stop_source source;
  source.request_stop();
  const auto stopped = slab_delaunay3(plane, plane, 0, {.stop = source.get_token()});
  ASSERT_FALSE(stopped);
  EXPECT_EQ(stopped.error().code, ErrorCode::cancelled);
  std::size_t calls = 0;
  EXPECT_TRUE(slab_delaunay3(plane, plane, 0, {.progress = [&](std::size_t done, std::size_t all) {
                               EXPECT_EQ(done, all);
                               ++calls;
                             }}));
  EXPECT_EQ(calls, 1U);
}

}  // namespace
}  // namespace tetloft::test

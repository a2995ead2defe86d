// Fields of options that make no sense, and callbacks that stop.
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>

#include "c/owned.hpp"
#include "c/sample_files.hpp"

namespace tetloft::c_test {
namespace {

const double kNan = std::nan("");
const double kInfinity = std::numeric_limits<double>::infinity();
constexpr std::int32_t kLeast = std::numeric_limits<std::int32_t>::min();
constexpr std::int32_t kMost = std::numeric_limits<std::int32_t>::max();

// All options there are, nested as they are used.
struct Options {
  Options() {
    tetloft_execution_defaults(&execution);
    tetloft_correspondence_defaults(&correspondence);
    tetloft_reconstruct_options_defaults(&reconstruct);
    tetloft_check_options_defaults(&check);
    tetloft_render_options_defaults(&render);
    tetloft_delaunay3_options_defaults(&delaunay);
    reconstruct.correspondence = check.correspondence = &correspondence;
    reconstruct.execution = check.execution = render.execution = delaunay.execution = &execution;
  }
  tetloft_execution execution;
  tetloft_correspondence correspondence;
  tetloft_reconstruct_options reconstruct;
  tetloft_check_options check;
  tetloft_render_options render;
  tetloft_delaunay3_options delaunay;
};

// The functions that take options, on samples.
class WithOptions : public testing::Test {
 protected:
  WithOptions() {
    *stack_.out() = static_cast<tetloft_stack*>(new_handle(Kind::stack));
    *model_.out() = static_cast<tetloft_model*>(new_handle(Kind::model));
  }
  tetloft_status reconstruct() {
    Owned<tetloft_model> made;
    return tetloft_reconstruct(stack_, &options_.reconstruct, made.out(), nullptr);
  }
  tetloft_status between() {
    Owned<tetloft_stack> made;
    return tetloft_between(stack_, &options_.reconstruct, made.out(), nullptr, nullptr);
  }
  tetloft_status links() {
    Owned<tetloft_links> made;
    return tetloft_links_find(stack_, &options_.correspondence, &options_.execution, made.out(),
                              nullptr);
  }
  tetloft_status check() {
    Owned<tetloft_verdict> made;
    return tetloft_check(model_, stack_, &options_.check, made.out());
  }
  tetloft_status render() {
    return tetloft_model_render(model_, nullptr, folder_.file("a.svg").c_str(), &options_.render);
  }
  tetloft_status delaunay() {
    Owned<tetloft_mesh> made;
    return tetloft_delaunay3(kTetPoints.data(), 5, &options_.delaunay, made.out(), nullptr,
                             nullptr);
  }

  // Each of `calls` refuses `field` with each of `values`; the message names it, by `word`.
  template <class T>
  void expect_refused(T& field, const std::vector<T>& values, const char* word,
                      const std::vector<std::function<tetloft_status()>>& calls) {
    const T usual = field;
    for (const T value : values) {
      field = value;
      for (const auto& call : calls) {
        EXPECT_EQ(call(), TETLOFT_USAGE) << word << ' ' << value;
        EXPECT_NE(std::string(tetloft_last_error()).find(word), std::string::npos)
            << word << ' ' << value << ": " << tetloft_last_error();
      }
    }
    field = usual;
    for (const auto& call : calls) EXPECT_OK(call()) << word;
  }

  SampleFolder folder_;
  Owned<tetloft_stack> stack_;
  Owned<tetloft_model> model_;
  Options options_;
};

TEST_F(WithOptions, EnumeratorsThatThereAreNoneOfAreRefused) {
  const auto none_above = [](std::int32_t last) {
    return std::vector<std::int32_t>{-1, last + 1, 100, 256, 65536, kLeast, kMost};
  };
  const auto by_correspondence = std::vector<std::function<tetloft_status()>>{
      [&] { return reconstruct(); }, [&] { return between(); }, [&] { return links(); },
      [&] { return check(); }};
  expect_refused(options_.correspondence.criterion, none_above(TETLOFT_MOVED), "criterion",
                 by_correspondence);
  expect_refused(options_.correspondence.void_rule, none_above(TETLOFT_VOIDS_FREE), "void_rule",
                 by_correspondence);
  expect_refused(options_.reconstruct.ends, none_above(TETLOFT_ENDS_HALF), "ends",
                 {[&] { return reconstruct(); }});
  expect_refused(options_.reconstruct.engine, none_above(TETLOFT_ENGINE_SLAB), "engine",
                 {[&] { return reconstruct(); }});
  expect_refused(options_.delaunay.engine, none_above(TETLOFT_ENGINE_SLAB), "engine",
                 {[&] { return delaunay(); }});
  options_.render.colour = TETLOFT_COLOUR_DIHEDRAL;
  options_.render.width = options_.render.height = 40;
  expect_refused(options_.render.colour, none_above(TETLOFT_COLOUR_EVIDENCE), "colour",
                 {[&] { return render(); }});
}

TEST_F(WithOptions, NumbersOutOfRangeAreRefused) {
  const auto by_correspondence = std::vector<std::function<tetloft_status()>>{
      [&] { return reconstruct(); }, [&] { return links(); }, [&] { return check(); }};
  expect_refused(options_.correspondence.tau, {kNan, 1.0, 2.0, kInfinity}, "threshold",
                 by_correspondence);
  expect_refused(options_.correspondence.void_reach, {kNan, -1.0, kInfinity}, "reach",
                 by_correspondence);
  expect_refused(
      options_.reconstruct.between,
      {-2, 65, std::numeric_limits<std::int64_t>::min(), std::numeric_limits<std::int64_t>::max()},
      "between", {[&] { return reconstruct(); }, [&] { return between(); }});
  expect_refused(options_.reconstruct.thickness, {kNan, -1.0, kInfinity}, "thickness",
                 {[&] { return reconstruct(); }});
  expect_refused(options_.reconstruct.work_limit, {kNan, 0.0, -1.0}, "work limit",
                 {[&] { return reconstruct(); }, [&] { return between(); }});
  expect_refused(options_.check.split_ulps, {kNan, -1.0}, "split", {[&] { return check(); }});
}

TEST_F(WithOptions, PicturesThatCannotBeAreRefused) {
  tetloft_render_options& picture = options_.render;
  picture.colour = TETLOFT_COLOUR_DIHEDRAL;
  picture.width = picture.height = 40;
  const std::vector<std::function<tetloft_status()>> calls{[&] { return render(); }};
  expect_refused(picture.width, {0, -1, 8193, kLeast, kMost}, "width", calls);
  expect_refused(picture.height, {0, -1, 8193, kLeast, kMost}, "height", calls);
  expect_refused(picture.cut_axis, {-2, 3, kLeast, kMost}, "cut_axis", calls);
  for (double* const number :
       {&picture.azimuth, &picture.elevation, &picture.explode, &picture.stretch}) {
    const double usual = *number;
    for (const double value : {kNan, kInfinity}) {
      *number = value;
      EXPECT_EQ(render(), TETLOFT_USAGE);
    }
    *number = usual;
  }
  picture.cut_axis = 2;
  picture.cut_position = kNan;
  EXPECT_EQ(render(), TETLOFT_USAGE);
  picture.cut_position = 0.5;
  EXPECT_OK(render());
}

TEST_F(WithOptions, NestedStructsHaveVersionsToo) {
  options_.execution.version = 2;
  for (const tetloft_status status :
       {reconstruct(), between(), links(), check(), render(), delaunay()}) {
    EXPECT_EQ(status, TETLOFT_USAGE);
  }
  EXPECT_NE(std::string(tetloft_last_error()).find("execution"), std::string::npos);
  options_.execution.version = TETLOFT_EXECUTION_VERSION;
  options_.correspondence.version = 0;
  for (const tetloft_status status : {reconstruct(), between(), links(), check()}) {
    EXPECT_EQ(status, TETLOFT_USAGE);
  }
}

TEST_F(WithOptions, AStopThatWasPressedEndsAllThatGetIt) {
  Owned<tetloft_stop> stop;
  ASSERT_OK(tetloft_stop_create(stop.out()));
  options_.execution.stop = stop;
  options_.render.colour = TETLOFT_COLOUR_DIHEDRAL;
  EXPECT_OK(reconstruct());
  ASSERT_OK(tetloft_stop_request(stop));
  EXPECT_EQ(reconstruct(), TETLOFT_CANCELLED);
  EXPECT_EQ(between(), TETLOFT_CANCELLED);
  EXPECT_EQ(links(), TETLOFT_CANCELLED);
  EXPECT_EQ(check(), TETLOFT_CANCELLED);
  EXPECT_EQ(render(), TETLOFT_CANCELLED);
  ASSERT_OK(tetloft_stop_request(stop));
  options_.execution.stop = nullptr;
  EXPECT_OK(reconstruct());
}

struct Watched {
  std::size_t calls = 0;
  std::size_t last = 0;
  std::size_t stop_at = static_cast<std::size_t>(-1);
};

int watch(void* user, std::size_t done, std::size_t all) {
  Watched& watched = *static_cast<Watched*>(user);
  ++watched.calls;
  EXPECT_LE(done, all);
  EXPECT_GT(done, watched.last);
  watched.last = done;
  return done >= watched.stop_at ? 1 : 0;
}

TEST_F(WithOptions, ProgressIsToldAndCanStop) {
  Watched watched;
  options_.execution.progress = watch;
  options_.execution.user = &watched;
  EXPECT_OK(reconstruct());
  EXPECT_GT(watched.calls, 2U);
  watched = {.stop_at = 2};
  EXPECT_EQ(reconstruct(), TETLOFT_CANCELLED);
  EXPECT_STREQ(tetloft_last_message(), "stopped by the progress callback");
  EXPECT_EQ(watched.calls, 2U);
}

TEST_F(WithOptions, UncheckedStacksAreRead) {
  const std::string crossing =
      "S 2\nv 4 z 0\n{\n0 0\n4 4\n4 0\n0 4\n}\nv 3 z 1\n{\n0 0\n4 0\n4 4\n}\n";
  Owned<tetloft_stack> stack;
  EXPECT_EQ(
      tetloft_stack_parse(crossing.data(), crossing.size(), "a.cnt", nullptr, stack.out(), nullptr),
      TETLOFT_INVALID_INPUT);
  tetloft_read_options options;
  ASSERT_OK(tetloft_read_options_defaults(&options));
  options.unchecked = 1;
  EXPECT_OK(tetloft_stack_parse(crossing.data(), crossing.size(), "a.cnt", &options, stack.out(),
                                nullptr));
  options.format = "no such";
  EXPECT_EQ(tetloft_stack_parse(crossing.data(), crossing.size(), "a.cnt", &options, stack.out(),
                                nullptr),
            TETLOFT_USAGE);
}

}  // namespace
}  // namespace tetloft::c_test

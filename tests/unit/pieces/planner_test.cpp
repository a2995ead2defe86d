// What is decided window by window is what the whole stack decides: the same plan, byte for byte.
#include "pieces/planner.hpp"

#include <gtest/gtest.h>

#include <string>
#include <utility>
#include <vector>

#include <tetloft/pieces.hpp>

#include "core/watched_work.hpp"
#include "pieces/piece_file.hpp"
#include "pieces/plan_file.hpp"
#include "pieces_support.hpp"

namespace tetloft::testing {

using namespace internal;
namespace {

using pieces::PlannedStack;
using pieces::PlanningWindows;
using pieces::SectionStore;

struct PlanBytes {
  std::string bytes;
  std::vector<Warning> warnings;
  std::uint64_t identity = 0;
};

std::string texts(const std::vector<Warning>& warnings) {
  std::string text;
  for (const Warning& warning : warnings) text += to_string(warning) + '\n';
  return text;
}

// All of the stack in memory, decided at once.
Result<PlanBytes> at_once(const SectionStack& stack, const ReconstructOptions& options, Unit unit) {
  WatchedWork work(options.execution, 0);
  Result<BuiltStack> planned = plan_stack(unit, stack, options, work);
  if (!planned) return planned.error();
  io::StringSink sink;
  PlanBytes made;
  made.identity =
      pieces::append_plan(sink, pieces::head_of(*planned, stack, options, {}), *planned);
  made.bytes = sink.take();
  made.warnings = planned->warnings;
  return made;
}

Result<PlanBytes> by_windows(const SectionStack& stack, const ReconstructOptions& options,
                             Unit unit, const PlanningWindows& windows) {
  Folder folder;
  StackStream sections(stack);
  const Result<SectionStore> store =
      SectionStore::of({sections}, options.execution, folder / "plan");
  if (!store) return store.error();
  WatchedWork work(options.execution, 0);
  io::StringSink sink;
  Result<PlannedStack> planned =
      pieces::plan_stored(*store, unit, options, {}, folder / "plan", work, sink, windows);
  if (!planned) return planned.error();
  return PlanBytes{sink.take(), planned->warnings, planned->identity};
}

std::size_t expect_same(const SectionStack& stack, const ReconstructOptions& options) {
  std::size_t compared = 0;
  for (const Unit unit : {Unit::of_the_stack, Unit::as_given}) {
    const Result<PlanBytes> whole = at_once(stack, options, unit);
    const std::size_t own = unit == Unit::of_the_stack ? 1 : 3;
    const Result<PlanBytes> windows = by_windows(stack, options, unit, {own, own, 0});
    EXPECT_EQ(whole.ok(), windows.ok());
    if (!whole || !windows) continue;
    EXPECT_EQ(windows->identity, whole->identity);
    EXPECT_EQ(windows->bytes, whole->bytes) << own << " own sections";
    EXPECT_EQ(texts(windows->warnings), texts(whole->warnings));
    ++compared;
  }
  return compared;
}

// Sections of a stack over and over, upside down every other time.
SectionStack repeated(const SectionStack& stack, std::size_t times) {
  SectionStack result;
  const std::vector<Section>& sections = stack.sections.raw();
  for (std::size_t t = 0; t < times; ++t) {
    for (std::size_t k = t == 0 ? 0 : 1; k < sections.size(); ++k) {
      const std::size_t s = t % 2 == 0 ? k : sections.size() - 1 - k;
      const std::size_t from = t % 2 == 0 ? s - 1 : s + 1;
      const double gap = k == 0 ? 0 : std::abs(sections[s].z - sections[from].z);
      const double z = result.sections.empty() ? 0 : result.sections.raw().back().z + gap;
      result.sections.push_back({z, sections[s].contours});
    }
  }
  return result;
}

std::vector<ReconstructOptions> ways_of_deciding() {
  std::vector<ReconstructOptions> ways(4);
  for (ReconstructOptions& options : ways) options.execution.threads = 1;
  ways[1].correspondence.criterion = Criterion::overlap;
  ways[1].correspondence.chain = false;
  ways[1].divide_coarse = false;
  ways[1].ends = Ends::half;
  ways[2].correspondence.voids = {VoidRule::near, 2.0, {}, {}};
  ways[2].correspondence.lone = false;
  ways[3].correspondence.voids.rule = VoidRule::free;
  ways[3].divide_coarse = false;
  return ways;
}

TEST(Planner, DecidesInWindowsWhatTheWholeDecides) {
  std::size_t compared = 0;
  for (const StackKind kind : all_kinds()) {
    const SectionStack stack = generate(kind, 2501).stack;
    if (stack.vertex_count() > 400) continue;
    SCOPED_TRACE(name_of(kind));
    for (const ReconstructOptions& options : ways_of_deciding()) {
      compared += expect_same(stack, options);
      if (stack.vertex_count() < 100) compared += expect_same(repeated(stack, 3), options);
    }
  }
  EXPECT_GT(compared, 300U);
}

TEST(Planner, SoItIsOfSamplesWithHolesAndObliqueParts) {
  for (const char* name : {"torus.cnt", "bifurcation.cnt", "figures/fig18_drifting.cnt"}) {
    SCOPED_TRACE(name);
    for (const ReconstructOptions& options : ways_of_deciding()) {
      EXPECT_EQ(expect_same(repeated(sample(name), 3), options), 2U);
    }
  }
}

// Where the whole counts all of it is in memory, and the plan is the same.
TEST(Planner, TakesTheWholeForLabelsDecisionsAndReverseTetrahedra) {
  const SectionStack stack = repeated(sample("torus.cnt"), 2);
  ReconstructOptions labels;
  labels.correspondence.labels = {{SectionId(3), ContourId(0), 5}};
  ReconstructOptions reverse;
  reverse.correspondence.criterion = Criterion::reverse;
  ReconstructOptions decisions;
  decisions.correspondence.decisions = {{SlabId(0), ContourId(0), ContourId(0), false}};
  for (const ReconstructOptions& options : {labels, reverse, decisions}) {
    EXPECT_FALSE(decides_in_windows(options));
    EXPECT_EQ(expect_same(stack, options), 2U);
  }
}

class Counted : public SectionStream {
 public:
  explicit Counted(const SectionStack& stack, std::size_t fails_at = SIZE_MAX)
      : stack_(stack), fails_at_(fails_at) {}
  Result<std::optional<Section>> next() override {
    if (next_ == fails_at_) return Error{ErrorCode::io, "the tape is torn", {}};
    if (next_ == stack_.sections.size()) return std::optional<Section>();
    return std::optional(stack_.sections[SectionId(next_++)]);
  }
  Place located(Place where) override {
    where.file = "tape";
    where.line = where.section;
    return where;
  }

 private:
  const SectionStack& stack_;
  std::size_t fails_at_;
  std::size_t next_ = 0;
};

TEST(Planner, TakesSectionsOfAnyStream) {
  const Folder folder;
  const SectionStack stack = sample("torus.cnt");
  Counted sections(stack);
  const Result<WrittenPlan> streamed = write_plan(folder / "a.plan", sections);
  ASSERT_TRUE(streamed) << to_string(streamed.error());
  ASSERT_TRUE(write_plan(folder / "b.plan", stack));
  EXPECT_EQ(bytes_of(folder / "a.plan"), bytes_of(folder / "b.plan"));
  EXPECT_EQ(streamed->summary.sections, stack.sections.size());
}

TEST(Planner, EndsWithTheErrorOfTheStream) {
  const Folder folder;
  const SectionStack stack = sample("torus.cnt");
  Counted sections(stack, 3);
  const Result<WrittenPlan> streamed = write_plan(folder / "a.plan", sections);
  ASSERT_FALSE(streamed);
  EXPECT_EQ(streamed.error().message, "the tape is torn");
  EXPECT_FALSE(std::filesystem::exists(folder / "a.plan"));
}

// As validate() does, but for what the stream knows of the place.
TEST(Planner, RefusesWhatIsNotValid) {
  const Folder folder;
  const auto refused = [&](const SectionStack& stack) {
    const Result<void> valid = validate(stack);
    Counted sections(stack);
    const Result<WrittenPlan> plan = write_plan(folder / "a.plan", sections);
    ASSERT_FALSE(valid);
    ASSERT_FALSE(plan);
    EXPECT_EQ(plan.error().code, valid.error().code);
    EXPECT_EQ(plan.error().message, valid.error().message);
    EXPECT_EQ(plan.error().where.section, valid.error().where.section);
    EXPECT_EQ(plan.error().where.contour, valid.error().where.contour);
    EXPECT_EQ(plan.error().where.vertex, valid.error().where.vertex);
    if (plan.error().where.section) {
      EXPECT_EQ(plan.error().where.line, plan.error().where.section);
    }
  };
  const SectionStack good = repeated(sample("torus.cnt"), 8);
  refused({});
  SectionStack bad;
  bad.sections.push_back({1, {}});
  bad.sections.push_back({2, {}});
  refused(bad);
  bad = good;
  bad.sections[SectionId(70)].z = bad.sections[SectionId(69)].z;
  refused(bad);
  bad.sections[SectionId(70)].z = 0;
  refused(bad);
  bad = good;
  std::reverse(bad.sections.raw().begin(), bad.sections.raw().end());
  refused(bad);
  bad = good;
  auto& vertices = bad.sections[SectionId(66)].contours[ContourId(0)].vertices;
  std::swap(vertices[0], vertices[1]);
  bad.sections[SectionId(67)].z = 0;
  refused(bad);
}

}  // namespace
}  // namespace tetloft::testing

// Stacks built window by window, wherever they are cut, are those of the direct run.
#include "reconstruct/window.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <tetloft/reconstruct.hpp>

#include "core/prng.hpp"
#include "core/watched_work.hpp"
#include "property/same_model.hpp"
#include "reconstruct/settle.hpp"
#include "support/slabs/cases.hpp"

namespace tetloft::testing {

using namespace internal;
namespace {

IdVector<SectionId, SectionPlan> section_plans(const BuiltStack& planned) {
  IdVector<SectionId, SectionPlan> plans;
  for (std::size_t s = 0; s < planned.prepared.section_count(); ++s) {
    plans.push_back(section_plan(planned, SectionId(s)));
  }
  return plans;
}

// A planned stack as bytes: all that a machine needs that builds a part of it.
struct PlannedBytes {
  StackFacts facts;
  std::vector<std::string> sections;
};

SectionPlan read_back(const std::string& bytes) {
  Result<SectionPlan> plan = section_plan_from_record(bytes, "name");
  EXPECT_TRUE(plan) << to_string(plan.error());
  EXPECT_EQ(to_record(*plan), bytes);
  return *std::move(plan);
}

// Builds ranges of a plan, and counts.
class Builder {
 public:
  Builder(const PlannedBytes& planned, const ReconstructOptions& options)
      : planned_(planned), options_(options) {}

  Result<BuiltRange> operator()(const SlabRange& slabs) {
    ++built;
    std::vector<SectionPlan> plans;
    for (std::size_t s = slabs.first; s <= slabs.end; ++s) {
      plans.push_back(read_back(planned_.sections[s]));
    }
    const auto beyond = [&](bool is_there, std::size_t s) {
      return is_there ? std::optional(read_back(planned_.sections[s])) : std::nullopt;
    };
    Result<BuiltStack> window =
        window_of(planned_.facts, slabs, std::move(plans), beyond(slabs.first > 0, slabs.first - 1),
                  beyond(slabs.end + 1 < planned_.facts.sections, slabs.end + 1));
    if (!window) return window.error();
    WatchedWork work(options_.execution, 0);
    if (auto error = build_window(*window, options_, work)) return *error;
    std::optional<BuiltRange> made = take_range(planned_.facts, slabs, *window, 1);
    if (!made) return Error{ErrorCode::unrepresentable, "another unit", {}};
    return *std::move(made);
  }

  std::size_t built = 0;

 private:
  const PlannedBytes& planned_;
  const ReconstructOptions& options_;
};

// What the cuts went through.
struct Seen {
  std::size_t models = 0, windows = 0, open = 0, settled = 0, whole = 0, mended = 0;
};

std::optional<PlannedBytes> planned_bytes(const SectionStack& stack,
                                          const ReconstructOptions& options, Unit unit) {
  WatchedWork work(options.execution, 0);
  Result<BuiltStack> planned = plan_stack(unit, stack, options, work);
  if (!planned) return std::nullopt;
  PlannedBytes bytes;
  bytes.facts = facts_of(*planned);
  for (const SectionPlan& plan : section_plans(*planned)) bytes.sections.push_back(to_record(plan));
  return bytes;
}

// By windows of these slabs; none where the unit will not do, or nothing less than the whole.
std::optional<Model> by_windows(const PlannedBytes& planned, const ReconstructOptions& options,
                                const std::vector<SlabRange>& cuts, Seen& seen) {
  Builder build(planned, options);
  std::vector<BuiltRange> pieces;
  std::vector<ClusterSpan> clusters;
  for (const SlabRange& slabs : cuts) {
    Result<BuiltRange> piece = build(slabs);
    if (!piece) {
      EXPECT_EQ(piece.error().code, ErrorCode::unrepresentable) << to_string(piece.error());
      return std::nullopt;
    }
    ++seen.windows;
    for (const ClusterSpan& cluster : piece->clusters) {
      (cluster.beyond.any() ? seen.open : seen.mended) += 1;
    }
    clusters.insert(clusters.end(), piece->clusters.begin(), piece->clusters.end());
    pieces.push_back(std::move(*piece));
  }
  const std::size_t slabs = planned.facts.sections - 1;
  Result<Settled> settled = settle(slabs, clusters, std::ref(build));
  if (!settled || settled->whole) {
    EXPECT_TRUE(settled) << to_string(settled.error());
    ++seen.whole;
    return std::nullopt;
  }
  seen.settled += settled->ranges.size();
  // From below: of each piece what no settled range replaces.
  JoinedModel joined;
  const auto add = [&](const BuiltRange& from, const SlabRange& range) {
    const Result<void> fine = joined.add(from.model, range);
    EXPECT_TRUE(fine) << to_string(fine.error());
  };
  for (const auto& [range, from] : [&] {
         std::vector<std::pair<SlabRange, const BuiltRange*>> segments;
         for (const BuiltRange& made : settled->ranges) segments.emplace_back(made.slabs, &made);
         for (const BuiltRange& piece : pieces) {
           std::size_t at = piece.slabs.first;
           for (const BuiltRange& made : settled->ranges) {
             if (made.slabs.end <= at || made.slabs.first >= piece.slabs.end) continue;
             if (made.slabs.first > at) segments.push_back({{at, made.slabs.first}, &piece});
             at = made.slabs.end;
           }
           if (at < piece.slabs.end || slabs == 0) {
             segments.push_back({{at, piece.slabs.end}, &piece});
           }
         }
         std::sort(segments.begin(), segments.end(),
                   [](const auto& a, const auto& b) { return a.first.first < b.first.first; });
         return segments;
       }()) {
    add(*from, range);
  }
  return joined.take();
}

std::vector<SlabRange> cut(std::size_t slabs, Prng& prng, std::size_t most) {
  std::vector<SlabRange> cuts;
  for (std::size_t at = 0; at < slabs;) {
    const std::size_t end =
        std::min<std::size_t>(slabs, at + 1 + static_cast<std::size_t>(prng.below(most)));
    cuts.push_back({at, end});
    at = end;
  }
  if (cuts.empty()) cuts.push_back({0, 0});
  return cuts;
}

void expect_same_by_windows(const SectionStack& stack, const ReconstructOptions& options,
                            Prng& prng, Seen& seen) {
  const Result<Reconstruction> direct = reconstruct(stack, options);
  if (!direct) return;
  for (const std::size_t most : {std::size_t{1}, std::size_t{3}}) {
    const std::vector<SlabRange> cuts = cut(stack.sections.size() - 1, prng, most);
    const std::size_t whole = seen.whole;
    for (const Unit unit : {Unit::of_the_stack, Unit::as_given}) {
      const auto planned = planned_bytes(stack, options, unit);
      ASSERT_TRUE(planned);
      const std::optional<Model> model = by_windows(*planned, options, cuts, seen);
      if (seen.whole != whole) break;
      if (!model && unit == Unit::of_the_stack) continue;
      ASSERT_TRUE(model.has_value());
      EXPECT_TRUE(same_bits(*model, direct->model));
      ++seen.models;
      break;
    }
  }
}

TEST(Windows, WhereverAStackIsCutItIsThatOfTheDirectRun) {
  Prng prng(910);
  Seen seen;
  for (const StackKind kind : all_kinds()) {
    const SectionStack stack = generate(kind, 911).stack;
    if (stack.vertex_count() > 1500) continue;
    SCOPED_TRACE(name_of(kind));
    for (const Criterion criterion : {Criterion::overlap, Criterion::reverse, Criterion::moved}) {
      ReconstructOptions options;
      options.execution.threads = 1;
      options.correspondence.criterion = criterion;
      options.ends = seen.models % 2 == 0 ? Ends::half : Ends::flat;
      expect_same_by_windows(stack, options, prng, seen);
    }
  }
  EXPECT_GT(seen.models, 75U);
  EXPECT_GT(seen.windows, seen.models);
  EXPECT_GT(seen.open, 0U);
  EXPECT_GT(seen.settled, 0U);
}

// Their records match, since only a forger writes such a plan.
TEST(Windows, RefuseSectionsBeyondThatDoNotFit) {
  const SectionStack stack =
      stack_of_boxes({{box(0, 0, 4, 2)}, {box(1, 0, 6, 2)}, {box(2, 0, 7, 2)}, {box(3, 0, 8, 2)}});
  const ReconstructOptions options;
  WatchedWork work(options.execution, 0);
  const Result<BuiltStack> planned = plan_stack(Unit::as_given, stack, options, work);
  ASSERT_TRUE(planned) << to_string(planned.error());
  const auto window_with = [&](const auto& forge) {
    IdVector<SectionId, SectionPlan> plans = section_plans(*planned);
    forge(plans);
    return window_of(facts_of(*planned), {1, 2}, {plans[SectionId(1)], plans[SectionId(2)]},
                     plans[SectionId(0)], plans[SectionId(3)]);
  };
  using Plans = IdVector<SectionId, SectionPlan>;
  EXPECT_TRUE(window_with([](Plans&) {}));
  const std::vector<std::pair<std::size_t, std::function<void(Plans&)>>> forgeries{
      {1, [](Plans& plans) { plans[SectionId(0)].section.z = plans[SectionId(1)].section.z; }},
      {3, [](Plans& plans) { plans[SectionId(3)].section.z = plans[SectionId(2)].section.z; }},
      {0,
       [](Plans& plans) { plans[SectionId(0)].section.contours[ContourId(0)].vertices.clear(); }},
      {3, [](Plans& plans) { plans[SectionId(3)].regions.of_region.clear(); }},
      {0, [](Plans& plans) { plans[SectionId(0)].region_links.links[0].lower = RegionId(1); }},
      {2, [](Plans& plans) { plans[SectionId(2)].region_links.links[0].upper = RegionId(1); }},
  };
  for (std::size_t k = 0; k < forgeries.size(); ++k) {
    const Result<BuiltStack> window = window_with(forgeries[k].second);
    ASSERT_FALSE(window) << k;
    EXPECT_EQ(window.error().code, ErrorCode::invalid_input);
    EXPECT_EQ(window.error().where.section, forgeries[k].first) << k;
  }
}

// Likewise: slabs beyond the ends would be turned inside out.
TEST(Windows, RefuseEndsInsideTheStack) {
  const SectionStack stack = stack_of_boxes({{box(0, 0, 4, 2)}, {box(1, 0, 6, 2)}});
  ReconstructOptions options;
  options.ends = Ends::half;
  WatchedWork work(options.execution, 0);
  const Result<BuiltStack> planned = plan_stack(Unit::as_given, stack, options, work);
  ASSERT_TRUE(planned) << to_string(planned.error());
  const auto window_with = [&](const EndPlanes& ends) {
    StackFacts facts = facts_of(*planned);
    facts.ends = ends;
    const IdVector<SectionId, SectionPlan> plans = section_plans(*planned);
    return window_of(facts, {0, 1}, plans.raw(), std::nullopt, std::nullopt);
  };
  EXPECT_TRUE(window_with({-0.5, 1.5}));
  EXPECT_TRUE(window_with({}));
  const std::vector<std::pair<std::size_t, EndPlanes>> forgeries{
      {0, {0, 1.5}}, {0, {0.25, 1.5}}, {1, {-0.5, 1}}, {1, {-0.5, 0.25}}};
  for (const auto& [section, ends] : forgeries) {
    const Result<BuiltStack> window = window_with(ends);
    ASSERT_FALSE(window);
    EXPECT_EQ(window.error().code, ErrorCode::invalid_input);
    EXPECT_EQ(window.error().where.section, section);
  }
}

// Models are as large as the numbers of their components.
TEST(Windows, RefuseComponentsThatThereAreNot) {
  const SectionStack stack = stack_of_boxes({{box(0, 0, 4, 2)}, {box(1, 0, 6, 2)}});
  const ReconstructOptions options;
  WatchedWork work(options.execution, 0);
  const Result<BuiltStack> planned = plan_stack(Unit::as_given, stack, options, work);
  ASSERT_TRUE(planned) << to_string(planned.error());
  const auto window_with = [&](const std::function<void(SectionComponents&)>& forge) {
    IdVector<SectionId, SectionPlan> plans = section_plans(*planned);
    forge(plans[SectionId(1)].regions);
    return window_of(facts_of(*planned), {0, 1}, plans.raw(), std::nullopt, std::nullopt);
  };
  EXPECT_TRUE(window_with([](SectionComponents&) {}));
  for (const std::uint32_t c : {1U, 0xFFFFFFFEU}) {
    const std::function<void(SectionComponents&)> forge_region = [&](SectionComponents& of) {
      of.of_region[RegionId(0)] = ComponentId(c);
    };
    const std::function<void(SectionComponents&)> forge_contour = [&](SectionComponents& of) {
      of.of_contour[ContourId(0)] = ComponentId(c);
    };
    for (const auto& forge : {forge_region, forge_contour}) {
      const Result<BuiltStack> window = window_with(forge);
      ASSERT_FALSE(window) << c;
      EXPECT_EQ(window.error().code, ErrorCode::invalid_input);
      EXPECT_EQ(window.error().where.section, 1U);
    }
  }
}

TEST(Windows, SoIsASingleSection) {
  Prng prng(912);
  Seen seen;
  expect_same_by_windows(stack_of_boxes({{box(0, 0, 4, 2)}}), {}, prng, seen);
  EXPECT_EQ(seen.models, 2U);
}

}  // namespace
}  // namespace tetloft::testing

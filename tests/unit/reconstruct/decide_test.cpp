// The decision over a whole stack: which candidates it looks for, and where anew.
#include "reconstruct/decide.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <utility>
#include <vector>

#include "reconstruct/stack_errors.hpp"
#include "support/slabs/cases.hpp"

namespace tetloft::testing {

using namespace internal;
namespace {

struct Deciding {
  ReconstructOptions options;
  WatchedWork work{options.execution, 0};
  PreparedStack prepared;

  Deciding(const SectionStack& stack, Criterion criterion) {
    options.execution.threads = 1;
    options.correspondence.criterion = criterion;
    prepared = prepare(stack, Unit::as_given, options, work).value();
  }
  [[nodiscard]] std::vector<SlabId> all() const { return all_ids<SlabId>(prepared.slab_count()); }
};

// Four squares, each moved on by more than its side but the second.
SectionStack leaning() {
  return stack_of_boxes(
      {{box(0, 0, 4, 4)}, {box(3, 0, 7, 4)}, {box(7.5, 0, 11.5, 4)}, {box(12, 0, 16, 4)}});
}

TEST(Decision, DependsOnTriangulationsIffByReverseTets) {
  for (const Criterion criterion : {Criterion::overlap, Criterion::reverse}) {
    const Deciding d(leaning(), criterion);
    const Decision decision(d.prepared, d.options);
    EXPECT_EQ(decision.depends_on_triangulations(), criterion == Criterion::reverse);
  }
}

TEST(Decision, ByOverlapIsWhatTheBoxesShare) {
  const SectionStack stack = stack_of_boxes({{box(0, 0, 4, 4), box(10, 0, 14, 4)},
                                             {box(1, 1, 5, 5)},
                                             {},
                                             {box(0, 0, 1, 1)},
                                             {box(0, 0, 1, 1)}});
  const Deciding d(stack, Criterion::overlap);
  Decision decision(d.prepared, d.options);
  const Result<Correspondence> made = decision.make(d.all(), d.work);
  ASSERT_TRUE(made.ok());
  EXPECT_EQ(made->links[SlabId(0)], (std::vector<Link>{{SlabId(0), RegionId(0), RegionId(0)}}));
  EXPECT_TRUE(made->links[SlabId(1)].empty());
  EXPECT_TRUE(made->links[SlabId(2)].empty());
  EXPECT_EQ(made->links[SlabId(3)], (std::vector<Link>{{SlabId(3), RegionId(0), RegionId(0)}}));
  std::set<ComponentId> components;
  for (const auto& section : made->component) components.insert(section.begin(), section.end());
  EXPECT_EQ(components.size(), 3U);
}

TEST(Decision, ChainsAndLoneRegionsAddLinksUnlessTheyAreOff) {
  Deciding d(leaning(), Criterion::overlap);
  const auto links = [&](bool chain, bool lone) {
    d.options.correspondence.chain = chain;
    d.options.correspondence.lone = lone;
    Decision decision(d.prepared, d.options);
    const Result<Correspondence> made = decision.make(d.all(), d.work);
    EXPECT_TRUE(made.ok());
    std::vector<std::size_t> counts;
    for (const SlabId k : made->links.ids()) counts.push_back(made->links[k].size());
    return counts;
  };
  EXPECT_EQ(links(false, false), (std::vector<std::size_t>{1, 0, 0}));
  EXPECT_EQ(links(true, false), (std::vector<std::size_t>{1, 1, 1}));
  // A gap is 1; the third square chooses the second or the fourth, both of which lie 1/2 away.
  EXPECT_EQ(links(false, true), (std::vector<std::size_t>{1, 0, 0}));
}

TEST(Decision, MadeWithoutALinkTellsThatItWasDropped) {
  const Deciding d(leaning(), Criterion::overlap);
  Decision decision(d.prepared, d.options);
  const Result<Correspondence> all = decision.make(d.all(), d.work);
  ASSERT_TRUE(all.ok());
  const Link link{SlabId(1), RegionId(0), RegionId(0)};
  ASSERT_EQ(all->links[SlabId(1)], (std::vector<Link>{link}));
  const Result<Correspondence> less = decision.make_without(link);
  ASSERT_TRUE(less.ok());
  EXPECT_TRUE(less->links[SlabId(1)].empty());
  EXPECT_EQ(less->links[SlabId(0)], all->links[SlabId(0)]);
  EXPECT_EQ(less->candidates[SlabId(1)].at(0).fate, LinkFate::unrealisable);
}

TEST(Decision, ByReverseTetsMadeAnewAtARefinedSectionIsThatOfAllSlabs) {
  std::size_t changed = 0;
  for (const StackKind kind : all_kinds()) {
    if (is_near_coincident(kind)) continue;
    const SectionStack stack = generate(kind, 520).stack;
    if (stack.sections.size() < 3) continue;
    SCOPED_TRACE(name_of(kind));
    Deciding d(stack, Criterion::reverse);
    Decision decision(d.prepared, d.options);
    const Result<Correspondence> before = decision.make(d.all(), d.work);
    ASSERT_TRUE(before.ok());
    const SectionId refined(1);
    const std::size_t contours = stack.sections[refined].contours.size();
    if (d.prepared.conform_section(refined, IdVector<ContourId, bool>(contours, true))) continue;
    const Result<Correspondence> anew = decision.make({SlabId(0), SlabId(1)}, d.work);
    const Result<Correspondence> whole = Decision(d.prepared, d.options).make(d.all(), d.work);
    ASSERT_TRUE(anew.ok() && whole.ok());
    EXPECT_EQ(anew->links, whole->links);
    EXPECT_EQ(anew->component, whole->component);
    if (anew->links != before->links) ++changed;
  }
  EXPECT_GT(changed, 0U);
}

TEST(Decision, TheFirstSlabThatTakesTooMuchWorkIsNamed) {
  const SectionStack stack = stack_of_boxes({{}, {box(0, 0, 1, 1)}, {box(0, 0, 1, 1)}});
  Deciding d(stack, Criterion::reverse);
  d.options.work_limit = 1e-9;
  Decision decision(d.prepared, d.options);
  const Result<Correspondence> refused = decision.make(d.all(), d.work);
  ASSERT_FALSE(refused.ok());
  EXPECT_EQ(refused.error().code, ErrorCode::work_limit);
  EXPECT_EQ(refused.error().where.slab, 1U);
}

}  // namespace
}  // namespace tetloft::testing

// The decision on voids: when there is one, and that all get the same.
#include "reconstruct/decide_voids.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include <tetloft/links.hpp>

#include "core/watched_work.hpp"
#include "sections/complement.hpp"
#include "support/same_rows.hpp"
#include "support/slabs/cases.hpp"

namespace tetloft::testing {

using namespace internal;
namespace {

const Contour kOutline = box(-10, -10, 10, 10);

// Of voids, in a stack as it is prepared.
struct Decided {
  explicit Decided(const SectionStack& stack, const ReconstructOptions& given = {})
      : options(given), work(options.execution, 0) {
    prepared = prepare(stack, Unit::of_the_stack, options, work, Conform::none).value();
    decision.emplace(prepared, options);
    voids =
        decision->make(IdVector<SlabId, std::vector<Link>>(prepared.slab_count()), work).value();
  }
  ReconstructOptions options;
  WatchedWork work;
  PreparedStack prepared;
  std::optional<VoidDecision> decision;
  std::optional<Correspondence> voids;
};

TEST(VoidDecision, IsOfExteriorsAloneWithoutHolesAndNoneByFree) {
  const SectionStack solid = stack_of_boxes({{kOutline}, {kOutline}});
  const Decided exteriors(solid);
  ASSERT_TRUE(exteriors.voids);
  EXPECT_EQ(exteriors.voids->links[SlabId(0)],
            (std::vector<Link>{{SlabId(0), sections::kExterior, sections::kExterior}}));
  EXPECT_EQ(cavities(*exteriors.voids), 0U);
  EXPECT_TRUE(exteriors.decision->links(*exteriors.voids).empty());
  const SectionStack holed = stack_of_boxes({{kOutline}, {kOutline, box(0, 0, 1, 1)}});
  EXPECT_TRUE(Decided(holed).voids);
  ReconstructOptions free;
  free.correspondence.voids.rule = VoidRule::free;
  EXPECT_FALSE(Decided(holed, free).voids);
  EXPECT_TRUE(Decided(stack_of_boxes({{kOutline, box(0, 0, 1, 1)}})).voids);  // no slab
}

TEST(VoidDecision, LinksExteriorsInEachSlabAndTellsNothingOfThem) {
  const Decided decided(stack_of_boxes(
      {{kOutline}, {kOutline}, {kOutline, box(0, 0, 1, 1)}, {kOutline}, {kOutline}}));
  ASSERT_TRUE(decided.voids);
  ASSERT_EQ(decided.voids->links.size(), 4U);
  for (const SlabId slab : decided.voids->links.ids()) {
    EXPECT_EQ(decided.voids->links[slab],
              (std::vector<Link>{{slab, sections::kExterior, sections::kExterior}}));
    EXPECT_TRUE(decided.voids->candidates[slab].empty());
  }
  EXPECT_TRUE(decided.decision->links(*decided.voids).empty());
  EXPECT_EQ(cavities(*decided.voids), 1U);
  // Of each section the exterior is one component.
  const ComponentId outside = decided.voids->component[SectionId(0)][sections::kExterior];
  for (const auto& section : decided.voids->component) {
    EXPECT_EQ(section[sections::kExterior], outside);
  }
  EXPECT_NE(decided.voids->component[SectionId(2)][RegionId(1)], outside);
}

TEST(VoidDecision, ComponentsFollowFromItsLinks) {
  for (const StackKind kind : all_kinds()) {
    const SectionStack stack = generate(kind, 6201).stack;
    if (stack.vertex_count() > 3000 || !validate(stack).ok()) continue;
    const Decided decided(stack);
    if (!decided.voids) continue;
    SCOPED_TRACE(name_of(kind));
    for (const SlabId slab : decided.voids->links.ids()) {
      const auto& links = decided.voids->links[slab];
      EXPECT_TRUE(std::is_sorted(links.begin(), links.end()));
      for (const Link& link : links) {
        EXPECT_EQ(decided.voids->component[lower_section(slab)][link.lower],
                  decided.voids->component[upper_section(slab)][link.upper]);
      }
    }
  }
}

TEST(VoidDecision, IsThatOfLinksAndOfTheModel) {
  std::size_t compared = 0;
  for (const char* name :
       {"one_two", "oblique_tunnel", "weak_holes", "slit_over_two", "holes_wm4_20"}) {
    SCOPED_TRACE(name);
    const SectionStack stack = sample("cases/voids/" + std::string(name) + ".cnt");
    const Result<StackLinks> found = find_links(stack);
    const Result<Reconstruction> made = reconstruct(stack);
    ASSERT_TRUE(found.ok() && made.ok());
    ASSERT_EQ(made->model.void_links.size(), found->void_links.size());
    EXPECT_TRUE(test::same_rows(made->model.void_links, found->void_links));
    compared += found->void_links.size();
    ReconstructOptions free;
    free.correspondence.voids.rule = VoidRule::free;
    EXPECT_TRUE(reconstruct(stack, free)->model.void_links.empty());
  }
  EXPECT_GE(compared, 10U);
}

TEST(LeastSureFirst, OrdersVoidsAsRegions) {
  std::vector<VoidLink> links(3);
  links[0].margin = 0.5;
  links[1].margin = -0.25;
  links[2].margin = 0.375;
  for (std::size_t k = 0; k < links.size(); ++k) links[k].slab = SlabId(k);
  std::vector<std::size_t> order;
  for (const VoidLink& link : least_sure_first(links)) order.push_back(link.slab.index());
  EXPECT_EQ(order, (std::vector<std::size_t>{1, 2, 0}));
}

}  // namespace
}  // namespace tetloft::testing

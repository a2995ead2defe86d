// Links of whole stacks: the same however they are asked for, and told in order of doubt.
#include <tetloft/links.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <tuple>
#include <vector>

#include <tetloft/reconstruct.hpp>

#include "support/slabs/cases.hpp"

namespace tetloft::testing {

using namespace internal;
namespace {

auto key(const RegionLink& link) {
  return std::tuple(link.slab, link.lower, link.upper, link.evidence, link.fate, link.ratio,
                    link.moved, link.distance, link.margin, link.lead);
}

bool same(const std::vector<RegionLink>& a, const std::vector<RegionLink>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [](const RegionLink& x, const RegionLink& y) { return key(x) == key(y); });
}

bool same(const std::vector<RegionMotion>& a, const std::vector<RegionMotion>& b) {
  return std::equal(
      a.begin(), a.end(), b.begin(), b.end(), [](const RegionMotion& x, const RegionMotion& y) {
        return x.slab == y.slab && x.upper == y.upper && x.contour == y.contour && x.by == y.by;
      });
}

LinkOptions by(Criterion criterion, unsigned threads) {
  LinkOptions options;
  options.correspondence.criterion = criterion;
  options.execution.threads = threads;
  return options;
}

TEST(FindLinks, AreThoseOfTheModelAtAnyNumberOfThreads) {
  for (const StackKind kind : all_kinds()) {
    const SectionStack stack = generate(kind, 733).stack;
    for (const Criterion criterion : {Criterion::overlap, Criterion::moved, Criterion::reverse}) {
      SCOPED_TRACE(std::string(name_of(kind)) + ' ' + std::to_string(static_cast<int>(criterion)));
      const Result<StackLinks> one = find_links(stack, by(criterion, 1));
      const Result<StackLinks> three = find_links(stack, by(criterion, 3));
      ASSERT_EQ(one.ok(), three.ok());
      if (!one) continue;
      EXPECT_TRUE(same(one->links, three->links));
      EXPECT_TRUE(same(one->motions, three->motions));
      EXPECT_EQ(one->partition, three->partition);
      ReconstructOptions options;
      options.correspondence.criterion = criterion;
      const Result<Reconstruction> made = reconstruct(stack, options);
      if (!made || made->report.rules[static_cast<std::size_t>(Rule::gabriel_refinement)] > 0) {
        continue;  // by reverse tets a refinement may change the links
      }
      EXPECT_TRUE(same(one->links, made->model.links));
      EXPECT_TRUE(same(one->motions, made->model.motions));
      EXPECT_EQ(one->partition, made->partition);
      EXPECT_EQ(one->components, made->model.component_count);
    }
  }
}

TEST(FindLinks, ScaleWithTheStack) {
  for (const StackKind kind : all_kinds()) {
    const SectionStack stack = generate(kind, 734).stack;
    SectionStack large = stack;
    for (Section& section : large.sections) {
      section.z = std::ldexp(section.z, 300);
      for (Contour& contour : section.contours) {
        for (Point2& p : contour.vertices) p = {std::ldexp(p.x, 300), std::ldexp(p.y, 300)};
      }
    }
    SCOPED_TRACE(name_of(kind));
    const Result<StackLinks> small_links = find_links(stack, by(Criterion::moved, 1));
    Result<StackLinks> large_links = find_links(large, by(Criterion::moved, 1));
    ASSERT_TRUE(small_links.ok() && large_links.ok());
    for (RegionMotion& motion : large_links->motions) {
      motion.by = {std::ldexp(motion.by.x, -300), std::ldexp(motion.by.y, -300)};
    }
    EXPECT_TRUE(same(small_links->links, large_links->links));
    EXPECT_TRUE(same(small_links->motions, large_links->motions));
  }
}

TEST(FindLinks, LeadsAreOverTheBestOtherPairOfEitherRegion) {
  // A plate over three squares, half, a quarter and an eighth of which it covers.
  const SectionStack stack =
      stack_of_boxes({{box(0, 0, 8, 8), box(10, 0, 18, 8), box(20, 0, 28, 8)},
                      {box(0, 0, 30, 1), box(0, 2, 8, 5), box(10, 2, 18, 3)}});
  LinkOptions options = by(Criterion::overlap, 1);
  const Result<StackLinks> found = find_links(stack, options);
  ASSERT_TRUE(found.ok());
  for (const RegionLink& link : found->links) {
    std::optional<double> best;
    for (const RegionLink& other : found->links) {
      const bool beside = (other.lower == link.lower) != (other.upper == link.upper);
      if (beside) best = std::max(best.value_or(-10), other.moved - other.distance);
    }
    ASSERT_EQ(link.lead.has_value(), best.has_value());
    if (best) {
      EXPECT_EQ(*link.lead, link.moved - link.distance - *best);
    }
  }
}

TEST(FindLinks, LeastSureFirstIsByMarginAndOfLoneOnesByLead) {
  std::vector<RegionLink> links(5);
  links[0].margin = 0.5;
  links[1].margin = -0.25;
  links[2].margin = 0.25;
  links[3].margin = 0.75;
  links[3].lead = 0.125;
  links[4].margin = 0.75;
  links[4].lead = 0.125;
  links[4].evidence = Evidence::lone;
  for (std::size_t k = 0; k < links.size(); ++k) links[k].slab = SlabId(k);
  std::vector<std::size_t> order;
  for (const RegionLink& link : least_sure_first(links)) order.push_back(link.slab.index());
  EXPECT_EQ(order, (std::vector<std::size_t>{4, 1, 2, 0, 3}));
}

TEST(FindLinks, RefuseWhatReconstructRefuses) {
  LinkOptions options;
  options.correspondence.tau = 1;
  const SectionStack stack = stack_of_boxes({{box(0, 0, 1, 1)}, {box(0, 0, 1, 1)}});
  EXPECT_EQ(find_links(stack, options).error().code, ErrorCode::usage);
  EXPECT_EQ(find_links({}, {}).error().code, ErrorCode::invalid_input);
  options.correspondence.tau = std::nullopt;
  options.correspondence.labels = labels_from("0 3 1");
  EXPECT_EQ(find_links(stack, options).error().code, ErrorCode::invalid_input);
}

}  // namespace
}  // namespace tetloft::testing

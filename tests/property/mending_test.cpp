// Stacks that come broken: what is left of them by definition, point by point, and models of it.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

#include <tetloft/check.hpp>
#include <tetloft/nesting.hpp>
#include <tetloft/reconstruct.hpp>

#include "support/stacks/broken.hpp"

namespace tetloft::testing {
namespace {

using Vertices = std::vector<Point2>;

// How often the contour winds around p, which is on no edge: by its edges across a ray to the left.
int winding(const Vertices& v, const Point2& p) {
  int sum = 0;
  for (std::size_t k = 0; k < v.size(); ++k) {
    const Point2& a = v[k];
    const Point2& b = v[(k + 1) % v.size()];
    if ((a.y <= p.y) == (b.y <= p.y)) continue;
    const Sign side = orient2d(a, b, p);
    if (b.y > a.y && side == Sign::positive) ++sum;
    if (b.y < a.y && side == Sign::negative) --sum;
  }
  return sum;
}

double distance_to(const Section& section, const Point2& p) {
  double least = INFINITY;
  for (const Contour& c : section.contours) {
    for (std::size_t k = 0; k < c.vertices.size(); ++k) {
      const Point2& a = c.vertices[k];
      const Point2& b = c.vertices[(k + 1) % c.vertices.size()];
      const double dx = b.x - a.x;
      const double dy = b.y - a.y;
      const double all = dx * dx + dy * dy;
      const double along = (p.x - a.x) * dx + (p.y - a.y) * dy;
      const double t = all == 0 ? 0 : std::clamp(along / all, 0.0, 1.0);
      least = std::min(least, std::hypot(p.x - a.x - t * dx, p.y - a.y - t * dy));
    }
  }
  return least;
}

bool edges_cross(const Vertices& v, const Vertices& w) {
  for (std::size_t i = 0; i < v.size(); ++i) {
    for (std::size_t k = 0; k < w.size(); ++k) {
      const Point2& a = v[i];
      const Point2& b = v[(i + 1) % v.size()];
      const Point2& c = w[k];
      const Point2& d = w[(k + 1) % w.size()];
      const Sign abc = orient2d(a, b, c);
      const Sign abd = orient2d(a, b, d);
      const Sign cda = orient2d(c, d, a);
      const Sign cdb = orient2d(c, d, b);
      if (abc != Sign::zero && abd == -abc && cda != Sign::zero && cdb == -cda) return true;
    }
  }
  return false;
}

// Traces in general position overlap in part where edges cross.
std::vector<std::size_t> groups_of(const Section& section) {
  const std::size_t n = section.contours.size();
  std::vector<std::size_t> group(n);
  std::iota(group.begin(), group.end(), std::size_t{0});
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t k = i + 1; k < n; ++k) {
      const std::size_t from = group[k];
      if (group[i] == from || !edges_cross(section.contours[ContourId(i)].vertices,
                                           section.contours[ContourId(k)].vertices)) {
        continue;
      }
      const std::size_t to = group[i];
      for (std::size_t& g : group) g = g == from ? to : g;
    }
  }
  return group;
}

bool in_region(const Section& section, const std::vector<std::size_t>& group, FillRule rule,
               const Point2& p) {
  int total = 0;
  std::vector<bool> inside(group.size(), false);
  for (std::size_t c = 0; c < group.size(); ++c) {
    const int times = winding(section.contours[ContourId(c)].vertices, p);
    total += times;
    if (times != 0) inside[group[c]] = true;
  }
  if (rule == FillRule::odd) return total % 2 != 0;
  if (rule == FillRule::winding) return total != 0;
  return std::count(inside.begin(), inside.end(), true) % 2 != 0;
}

bool by_parity(const Section& section, const Point2& p) {
  int total = 0;
  for (const Contour& c : section.contours) total += winding(c.vertices, p);
  return total % 2 != 0;
}

double area_by_nesting(const SectionStack& stack) {
  double sum = 0;
  for (const Section& section : stack.sections) {
    const Nesting nesting = nest(section);
    for (const ContourId c : section.contours.ids()) {
      const double area = std::abs(twice_area(section.contours[c])) / 2;
      sum += nesting.depth[c] % 2 == 0 ? area : -area;
    }
  }
  return sum;
}

std::size_t holes_in(const Section& section) {
  const Nesting nesting = nest(section);
  return static_cast<std::size_t>(std::count(nesting.depth.begin(), nesting.depth.end(), 1U));
}

double nearest_vertices(const Section& section) {
  double least = INFINITY;
  std::vector<Point2> all;
  for (const Contour& c : section.contours) {
    all.insert(all.end(), c.vertices.begin(), c.vertices.end());
  }
  for (std::size_t i = 0; i < all.size(); ++i) {
    for (std::size_t k = i + 1; k < all.size(); ++k) {
      least = std::min(least, std::hypot(all[i].x - all[k].x, all[i].y - all[k].y));
    }
  }
  return least;
}

void expect_model(const SectionStack& stack) {
  const auto made = reconstruct(stack);
  ASSERT_TRUE(made.ok()) << to_string(made.error());
  const auto checked = check(made->model, stack);
  ASSERT_TRUE(checked.ok());
  EXPECT_TRUE(checked->pass());
}

TEST(Mending, OverlapsKeepThePointsOfTheirFillRule) {
  std::size_t compared = 0;
  std::size_t inside = 0;
  for (std::uint64_t seed = 1; seed <= 90; ++seed) {
    SCOPED_TRACE(seed);
    const BrokenStack given = broken(BrokenKind::overlaps, seed);
    const auto repaired = repair(given.stack, given.repair);
    ASSERT_TRUE(repaired.ok()) << to_string(repaired.error());
    if (repaired->stack.contour_count() == 0) continue;
    ASSERT_TRUE(validate(repaired->stack).ok());
    EXPECT_NEAR(repaired->area_after, area_by_nesting(repaired->stack), 1e-9);
    EXPECT_NEAR(repaired->area_before, repaired->area_after, 1e-2);
    Prng prng(seed);
    for (const SectionId s : given.stack.sections.ids()) {
      const Section& before = given.stack.sections[s];
      const Section& after = repaired->stack.sections[s];
      const auto group = groups_of(before);
      for (int k = 0; k < 60; ++k) {
        const Point2 p{prng.between(-9, 9), prng.between(-9, 9)};
        if (distance_to(before, p) < 1e-3) continue;
        const bool expected = in_region(before, group, given.repair.fill, p);
        ASSERT_EQ(by_parity(after, p), expected) << p.x << ' ' << p.y;
        ++compared;
        inside += expected ? 1U : 0U;
      }
    }
    if (seed % 6 == 0) expect_model(repaired->stack);
  }
  EXPECT_GT(compared, 10000U);
  EXPECT_GT(inside, 1500U);
}

TEST(Mending, CopiesAreKeptOnce) {
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    SCOPED_TRACE(seed);
    const BrokenStack given = broken(BrokenKind::copies, seed);
    for (const FillRule fill : {FillRule::odd, FillRule::unite}) {
      const auto repaired = repair(given.stack, {.fill = fill});
      ASSERT_TRUE(repaired.ok()) << to_string(repaired.error());
      const std::size_t left = given.stack.sections.size() * (1 + *given.holes);
      ASSERT_EQ(repaired->stack.contour_count(), left);
      EXPECT_EQ(repaired->copies, given.stack.contour_count() - left);
      for (const Section& section : repaired->stack.sections) {
        EXPECT_EQ(holes_in(section), *given.holes);
      }
      EXPECT_TRUE(repaired->lost.empty());
      if (seed % 6 == 0) expect_model(repaired->stack);
    }
  }
}

TEST(Mending, KeyholesBecomeHoles) {
  std::size_t channels = 0;
  for (std::uint64_t seed = 1; seed <= 90; ++seed) {
    SCOPED_TRACE(seed);
    const BrokenStack given = broken(BrokenKind::keyholes, seed);
    const auto repaired = repair(given.stack, given.repair);
    ASSERT_TRUE(repaired.ok()) << to_string(repaired.error());
    channels += repaired->channels;
    for (const SectionId s : given.stack.sections.ids()) {
      const Section& after = repaired->stack.sections[s];
      ASSERT_EQ(after.contours.size(), 1 + *given.holes) << "section " << s.index();
      EXPECT_EQ(holes_in(after), *given.holes);
      EXPECT_GT(nearest_vertices(after), 1e-10);
      // But for the channels, all of it stays.
      Prng prng(seed);
      for (int k = 0; k < 60; ++k) {
        const Point2 p{prng.between(-13, 25), prng.between(-13, 25)};
        if (distance_to(given.stack.sections[s], p) <= given.repair.keyholes.value_or(1e-3)) {
          continue;
        }
        ASSERT_EQ(by_parity(after, p), by_parity(given.stack.sections[s], p));
      }
    }
    if (seed % 6 == 0) expect_model(repaired->stack);
  }
  EXPECT_GT(channels, 200U);
}

// Contours of a section by their first vertices, whatever order they came in.
std::vector<Vertices> contours_of(const Section& section) {
  std::vector<Vertices> result;
  for (const Contour& c : section.contours) result.push_back(c.vertices);
  std::sort(result.begin(), result.end(), [](const Vertices& a, const Vertices& b) {
    return canonical_less(a.front(), b.front());
  });
  return result;
}

TEST(Mending, PlanesAreArranged) {
  std::size_t merged = 0;
  for (std::uint64_t seed = 1; seed <= 90; ++seed) {
    SCOPED_TRACE(seed);
    const BrokenStack given = broken(BrokenKind::planes, seed);
    const auto arranged = arrange_planes(given.stack, *given.planes);
    ASSERT_TRUE(arranged.ok()) << to_string(arranged.error());
    ASSERT_EQ(arranged->stack.sections.size(), given.ordered->sections.size());
    ASSERT_EQ(arranged->origin.size(), arranged->stack.sections.size());
    for (const SectionId s : given.ordered->sections.ids()) {
      const Section& expected = given.ordered->sections[s];
      EXPECT_EQ(arranged->stack.sections[s].z, expected.z);
      EXPECT_EQ(contours_of(arranged->stack.sections[s]), contours_of(expected));
      merged += arranged->origin[s].size() > 1 ? 1U : 0U;
    }
    EXPECT_TRUE(validate(arranged->stack).ok());
    if (seed % 6 == 0) expect_model(arranged->stack);
  }
  EXPECT_GT(merged, 30U);
}

}  // namespace
}  // namespace tetloft::testing

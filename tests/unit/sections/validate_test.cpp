// validate(): every defect gets its reason and its place; nothing valid is refused.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>

#include "support/stacks/generate.hpp"
#include "unit/sections/shapes.hpp"

namespace tetloft::testing {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

// "contour 1, vertex 2: reason" of the first defect; "" if valid.
std::string verdict(const SectionStack& stack) {
  const Result<void> valid = validate(stack);
  if (valid) return "";
  const Error& error = valid.error();
  EXPECT_EQ(error.code, ErrorCode::invalid_input);
  std::string place;
  if (error.where.contour) place += std::to_string(*error.where.contour);
  if (error.where.vertex) {
    place += '.';
    place += std::to_string(*error.where.vertex);
    const Section& section = stack.sections[SectionId(*error.where.section)];
    const Point2& p =
        section.contours[ContourId(*error.where.contour)].vertices[*error.where.vertex];
    EXPECT_TRUE(error.where.point.has_value());
    if (std::isfinite(p.x) && std::isfinite(p.y)) {
      EXPECT_EQ(*error.where.point, (Point3{p.x, p.y, section.z}));
    }
  }
  return place + " " + error.message;
}

void expect_verdict(const SectionStack& stack, const std::string& beginning) {
  const std::string text = verdict(stack);
  EXPECT_EQ(text.substr(0, beginning.size()), beginning) << text;
}

const Contour kSquare = rectangle(0, 0, 10, 10);

TEST(Validate, AcceptsContoursInEitherDirectionAndEmptySections) {
  EXPECT_EQ(verdict(one({kSquare})), "");
  EXPECT_EQ(verdict(one({reversed(kSquare)})), "");
  EXPECT_EQ(verdict(stack({section(0, {kSquare}), section(1, {}), section(2, {kSquare})})), "");
}

TEST(Validate, AcceptsCollinearVertices) {
  EXPECT_EQ(verdict(one({contour({{0, 0}, {5, 0}, {10, 0}, {10, 10}, {5, 5}})})), "");
}

TEST(Validate, NamesAStackWithoutSections) { EXPECT_FALSE(validate(SectionStack{}).ok()); }

TEST(Validate, NamesAStackWithoutContours) {
  for (std::size_t n = 1; n < 4; ++n) {
    SectionStack empty;
    for (std::size_t s = 0; s < n; ++s)
      empty.sections.push_back(section(static_cast<double>(s), {}));
    const auto valid = validate(empty);
    ASSERT_FALSE(valid.ok());
    EXPECT_EQ(valid.error().code, ErrorCode::invalid_input);
    EXPECT_NE(valid.error().message.find("all its sections are empty"), std::string::npos);
    // One contour anywhere is enough.
    for (std::size_t s = 0; s < n; ++s) {
      SectionStack filled = empty;
      filled.sections[SectionId(s)] = section(static_cast<double>(s), {kSquare});
      EXPECT_TRUE(validate(filled).ok());
    }
  }
}

TEST(Validate, NamesHeights) {
  const auto at = [](double z0, double z1) {
    return stack({section(z0, {kSquare}), section(z1, {kSquare})});
  };
  expect_verdict(at(1, 1),
                 " z does not increase (1 after 1): put all contours of one height into one "
                 "section");
  expect_verdict(at(1, 0),
                 " z does not increase (0 after 1): the sections descend; put them in the opposite "
                 "order");
  expect_verdict(stack({section(0, {kSquare}), section(2, {kSquare}), section(1, {kSquare})}),
                 " z does not increase (1 after 2): the sections are not sorted; put them in the "
                 "order of their z");
  expect_verdict(at(0, std::nan("")), " z: coordinate is not finite");
  expect_verdict(at(0, 0x1p1000), " z: coordinate is not below 2^1000");
  EXPECT_EQ(*validate(at(1, 0)).error().where.section, 1U);
  EXPECT_EQ(verdict(at(0, std::nextafter(0, 1))), "");
}

TEST(Validate, NamesCoordinates) {
  for (const double bad : {kInfinity, -kInfinity, std::nan("")}) {
    expect_verdict(one({kSquare, contour({{20, 0}, {30, bad}, {30, 10}})}),
                   "1.1 coordinate is not finite");
    expect_verdict(one({contour({{bad, 0}, {30, 0}, {30, 10}})}), "0.0 coordinate is not finite");
  }
  expect_verdict(one({contour({{0, 0}, {30, 0}, {30, -0x1p1000}})}),
                 "0.2 coordinate is not below 2^1000");
  const double most = std::nextafter(0x1p1000, 0);
  EXPECT_EQ(verdict(one({contour({{-most, -most}, {most, 0}, {0, most}})})), "");
}

TEST(Validate, NamesDegenerateContours) {
  expect_verdict(one({contour({})}), "0 contour has fewer than three vertices");
  expect_verdict(one({kSquare, contour({{20, 0}, {30, 0}})}),
                 "1 contour has fewer than three vertices");
  expect_verdict(one({contour({{0, 0}, {5, 0}, {10, 0}})}), "0 contour has zero area");
  expect_verdict(one({contour({{1, 1}, {1, 1}, {1, 1}})}), "0 contour has zero area");
  expect_verdict(one({contour({{0, 0}, {0.1, 0.3}, {0, 0}, {0.2, 0.6}})}),
                 "0 contour has zero area");
}

TEST(Validate, NamesRepeatedVertices) {
  expect_verdict(one({contour({{0, 0}, {10, 0}, {10, 0}, {10, 10}, {0, 10}})}),
                 "0.2 vertex repeats its predecessor");
  expect_verdict(one({contour({{0, 0}, {10, 0}, {10, 10}, {0, 10}, {0, 0}})}),
                 "0.4 first vertex is repeated at the end");
}

TEST(Validate, NamesSpikesWhereverTheContourStarts) {
  const Contour spike = contour({{0, 0}, {15, 0}, {10, 0}, {10, 10}, {0, 10}});
  const Contour exact = contour({{0, 0}, {10, 0}, {15, 0}, {10, 0}, {10, 10}, {0, 10}});
  const Contour inward = contour({{0, 0}, {5, 0}, {2, 0}, {10, 0}, {10, 10}, {0, 10}});
  for (std::size_t k = 0; k < 5; ++k) {
    const std::string at = std::string("0.") + std::to_string((6 - k) % 5);
    expect_verdict(one({rotated(spike, k)}), at + " edge folds back on itself (spike)");
  }
  for (std::size_t k = 0; k < 6; ++k) {
    const std::string at = std::string("0.") + std::to_string((8 - k) % 6);
    expect_verdict(one({rotated(exact, k)}), at + " edge folds back on itself (spike)");
  }
  expect_verdict(one({inward}), "0.1 edge folds back on itself (spike)");
}

TEST(Validate, NamesCrossings) {
  expect_verdict(one({contour({{0, 0}, {10, 10}, {10, 0}, {0, 10}})}),
                 "0.0 contour crosses itself (the edge from vertex 2)");
  expect_verdict(one({contour({{0, 0}, {10, 0}, {10, 10}, {5, -5}, {0, 10}})}),
                 "0.0 contour crosses itself");
  expect_verdict(one({kSquare, rectangle(5, 5, 15, 15)}),
                 "0.1 contour crosses contour 1 (the edge from vertex 0 there)");
}

TEST(Validate, SeesCrossingsOfOneUlp) {
  const Contour other = contour({{-1, 0}, {3, 1}, {7, 2.3333333333333335}, {7, 9}});
  expect_verdict(one({contour({{0, 0}, {3, 1.0000000000000002}, {6, 2}, {6, -5}}), other}),
                 "0.0 contour crosses contour 1");
}

TEST(Validate, NamesContacts) {
  expect_verdict(
      one({contour({{0, 0}, {10, 0}, {10, 10}, {5, 5}, {0, 10}, {0, 8}, {5, 5}, {0, 2}})}),
      "0.3 contour passes twice through one point (again at vertex 6)");
  expect_verdict(one({contour({{0, 0}, {10, 0}, {10, 10}, {5, 0}, {0, 10}})}),
                 "0.3 vertex lies on an edge of its own contour");
  expect_verdict(one({kSquare, contour({{10, 10}, {20, 10}, {20, 20}})}),
                 "0.2 two contours share a vertex (with contour 1, vertex 0)");
  expect_verdict(one({kSquare, contour({{10, 5}, {20, 0}, {20, 10}})}),
                 "1.0 vertex lies on an edge of contour 0");
  expect_verdict(one({contour({{10, 5}, {20, 0}, {20, 10}}), kSquare}),
                 "0.0 vertex lies on an edge of contour 1");
  expect_verdict(one({kSquare, rectangle(10, 0, 20, 10)}), "0.1 two contours share an edge");
  expect_verdict(one({kSquare, rectangle(10, 2, 20, 8)}), "1.0 edge overlaps an edge of contour 0");
  expect_verdict(one({kSquare, contour({{0, 0}, {5, 2}, {2, 5}})}),
                 "0.0 two contours share a vertex");
}

TEST(Validate, NamesTheSameContourTwiceInWhicheverDirection) {
  for (std::size_t k = 0; k < 4; ++k) {
    expect_verdict(one({kSquare, rotated(kSquare, k)}),
                   "0.0 the same contour twice (again as contour 1)");
    expect_verdict(one({kSquare, rotated(reversed(kSquare), k)}),
                   "0.0 the same contour twice (again as contour 1)");
  }
}

TEST(Validate, ReportsTheFirstDefect) {
  const Contour spike = contour({{20, 0}, {35, 0}, {30, 0}, {30, 10}, {20, 10}});
  expect_verdict(one({kSquare, spike, rectangle(5, 5, 15, 15)}), "0.1 contour crosses contour 2");
  expect_verdict(one({spike, kSquare, rectangle(5, 5, 15, 15)}), "0.1 edge folds back");
  expect_verdict(one({kSquare, rectangle(5, 5, 15, 15), contour({})}), "0.1 contour crosses");
  expect_verdict(one({contour({}), kSquare, rectangle(5, 5, 15, 15)}), "0 contour has fewer");
  const Result<void> second =
      validate(stack({section(0, {kSquare}), section(1, {spike}), section(2, {contour({})})}));
  EXPECT_EQ(*second.error().where.section, 1U);
}

// By definition, in integers: is the section valid?
bool is_valid_by_force(const std::vector<Contour>& contours) {
  struct Edge {
    std::int64_t ax, ay, bx, by;
    std::size_t contour, from, count;
  };
  std::vector<Edge> edges;
  for (std::size_t c = 0; c < contours.size(); ++c) {
    const auto& v = contours[c].vertices;
    if (v.size() < 3) return false;
    for (std::size_t k = 0; k < v.size(); ++k) {
      const Point2& a = v[k];
      const Point2& b = v[(k + 1) % v.size()];
      if (a == b) return false;
      edges.push_back({static_cast<std::int64_t>(a.x), static_cast<std::int64_t>(a.y),
                       static_cast<std::int64_t>(b.x), static_cast<std::int64_t>(b.y), c, k,
                       v.size()});
    }
  }
  const auto turn = [](const Edge& e, std::int64_t x, std::int64_t y) {
    const std::int64_t t = (e.bx - e.ax) * (y - e.ay) - (e.by - e.ay) * (x - e.ax);
    return t > 0 ? 1 : (t < 0 ? -1 : 0);
  };
  const auto on = [&](const Edge& e, std::int64_t x, std::int64_t y) {
    return turn(e, x, y) == 0 && std::min(e.ax, e.bx) <= x && x <= std::max(e.ax, e.bx) &&
           std::min(e.ay, e.by) <= y && y <= std::max(e.ay, e.by);
  };
  for (std::size_t i = 0; i < edges.size(); ++i) {
    for (std::size_t j = 0; j < edges.size(); ++j) {
      const Edge& e = edges[i];
      const Edge& f = edges[j];
      if (i == j) continue;
      // e's start may be on the edge before e only, e's end on the edge after it only.
      const bool f_after_e = e.contour == f.contour && f.from == (e.from + 1) % e.count;
      const bool e_after_f = e.contour == f.contour && e.from == (f.from + 1) % e.count;
      if (on(f, e.ax, e.ay) && !e_after_f) return false;
      if (on(f, e.bx, e.by) && !f_after_e) return false;
      if (turn(e, f.ax, f.ay) * turn(e, f.bx, f.by) < 0 &&
          turn(f, e.ax, e.ay) * turn(f, e.bx, e.by) < 0) {
        return false;
      }
    }
  }
  return true;
}

TEST(Validate, AgreesWithBruteForceOnSmallGrids) {
  Prng prng(20);
  int valid = 0;
  for (int round = 0; round < 10000; ++round) {
    std::vector<Contour> contours(1 + prng.below(2));
    for (Contour& c : contours) {
      c.vertices.resize(3 + prng.below(4));
      for (Point2& p : c.vertices) {
        p = {static_cast<double>(prng.below(7)), static_cast<double>(prng.below(7))};
      }
    }
    const bool expected = is_valid_by_force(contours);
    valid += expected ? 1 : 0;
    ASSERT_EQ(validate(one(contours)).ok(), expected) << "round " << round;
  }
  EXPECT_GT(valid, 500);
}

TEST(Validate, DoesNotDependOnScaleOrOffset) {
  Prng prng(21);
  for (int round = 0; round < 500; ++round) {
    std::vector<Contour> contours(2);
    for (Contour& c : contours) {
      c = random_star(prng, static_cast<int>(prng.below(40)), 0, 12, 8);
    }
    const std::string expected = verdict(one(contours));
    for (const double factor : {0x1p-900, 0x1p-30, 0x1p600}) {
      std::vector<Contour> scaled;
      for (const Contour& c : contours) scaled.push_back(moved(c, factor, {0, 0}));
      ASSERT_EQ(verdict(one(scaled)), expected);
    }
    std::vector<Contour> shifted;
    for (const Contour& c : contours) shifted.push_back(moved(c, 1, {0x1p40, -0x1p45}));
    ASSERT_EQ(verdict(one(shifted)), expected);
  }
}

TEST(Validate, AcceptsStarsAndGeneratedStacks) {
  Prng prng(22);
  for (int round = 0; round < 200; ++round) {
    ASSERT_EQ(verdict(one({random_star(prng, 0, 0, 1000, 100)})), "");
  }
  for (const StackKind kind : all_kinds()) {
    ASSERT_EQ(verdict(generate(kind, 1).stack), "") << name_of(kind);
  }
}

TEST(Validate, FindsTheOneDefectInALargeContour) {
  Prng prng(23);
  Contour big = random_star(prng, 0, 0, 100000, 8000);
  ASSERT_EQ(verdict(one({big})), "");
  const std::size_t v = 4321 % (big.vertices.size() - 10);
  std::swap(big.vertices[v], big.vertices[v + 3]);
  EXPECT_NE(verdict(one({big})), "");
}

TEST(SectionStack, CountsContoursAndVertices) {
  const SectionStack both = stack(
      {section(0, {kSquare}), section(1, {}), section(2, {kSquare, rectangle(20, 0, 30, 5)})});
  EXPECT_EQ(both.contour_count(), 3U);
  EXPECT_EQ(both.vertex_count(), 12U);
}

TEST(ValidStack, HoldsWhatValidateAcceptsAndItsNestings) {
  for (const StackKind kind : all_kinds()) {
    const SectionStack given = generate(kind, 3).stack;
    const Result<ValidStack> valid = ValidStack::of(given);
    ASSERT_TRUE(valid.ok()) << name_of(kind);
    ASSERT_EQ(valid->nestings().size(), given.sections.size());
    for (const SectionId s : given.sections.ids()) {
      const Nesting nesting = nest(given.sections[s]);
      EXPECT_EQ(valid->nestings()[s].parent, nesting.parent);
      EXPECT_EQ(valid->nestings()[s].depth, nesting.depth);
      EXPECT_EQ(valid->nestings()[s].region, nesting.region);
      EXPECT_EQ(valid->nestings()[s].outer, nesting.outer);
    }
  }
}

TEST(ValidStack, IsEmptyOnceItIsMovedFrom) {
  const SectionStack given = generate(all_kinds().front(), 3).stack;
  ValidStack first = *ValidStack::of(given);
  ValidStack second = std::move(first);
  EXPECT_TRUE(first.stack().sections.empty());
  EXPECT_TRUE(first.nestings().empty());
  first = second;
  EXPECT_EQ(first.nestings().size(), given.sections.size());
  second = std::move(first);
  EXPECT_TRUE(first.stack().sections.empty());
  EXPECT_TRUE(first.nestings().empty());
  EXPECT_EQ(std::move(second).take().sections.size(), given.sections.size());
  EXPECT_TRUE(second.stack().sections.empty());
  EXPECT_TRUE(second.nestings().empty());
}

TEST(ValidStack, IsRefusedAsByValidate) {
  SectionStack broken = generate(all_kinds().front(), 3).stack;
  std::vector<Point2>& vertices = broken.sections[SectionId(0)].contours[ContourId(0)].vertices;
  vertices[1] = vertices[0];
  const Result<ValidStack> valid = ValidStack::of(broken);
  ASSERT_FALSE(valid.ok());
  EXPECT_EQ(to_string(valid.error()), to_string(validate(broken).error()));
}

}  // namespace
}  // namespace tetloft::testing

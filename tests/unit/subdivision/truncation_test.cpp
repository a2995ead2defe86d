#include "subdivision/truncation.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <map>
#include <numeric>
#include <set>
#include <vector>

#include "subdivision/lifting.hpp"
#include "support/slabs/cases.hpp"

namespace tetloft::testing {

using namespace internal;
namespace {

// A skew prism without parallel quads would be no prism; this one is affine.
constexpr std::array<Point3, 6> kPrism{
    {{0, 0, 0}, {2, 0, 1}, {1, 3, 0}, {1, 1, 4}, {3, 1, 5}, {2, 4, 4}}};

TEST(SplitPrism, YieldsThreePositiveTetsThatFillItForEveryOrderOfIds) {
  // The prism is half of a parallelepiped, the tet (a, b, c, d) a third of the prism.
  const long double whole = 3 * volume6(kPrism[0], kPrism[1], kPrism[2], kPrism[3]);
  ASSERT_GT(whole, 0);
  std::array<std::size_t, 6> id{0, 1, 2, 3, 4, 5};
  int orders = 0;
  do {
    ++orders;
    std::array<NodeId, 6> prism;
    std::map<NodeId, Point3> point;
    for (std::size_t i = 0; i < 6; ++i) {
      prism[i] = NodeId(id[i]);
      point[prism[i]] = kPrism[i];
    }
    long double sum = 0;
    for (const auto& tet : split_prism(prism)) {
      const long double part = volume6(point[tet[0]], point[tet[1]], point[tet[2]], point[tet[3]]);
      EXPECT_GT(part, 0);
      sum += part;
    }
    EXPECT_EQ(sum, whole);
  } while (std::next_permutation(id.begin(), id.end()));
  EXPECT_EQ(orders, 720);
}

TEST(SplitPrism, DiagonalsOfQuadsStartAtTheirLowestIds) {
  std::array<std::size_t, 6> id{0, 1, 2, 3, 4, 5};
  do {
    std::array<NodeId, 6> prism;
    for (std::size_t i = 0; i < 6; ++i) prism[i] = NodeId(id[i]);
    std::set<std::set<NodeId>> edges;
    for (const auto& tet : split_prism(prism)) {
      for (const auto& [i, j] : kEdgeVertex) {
        edges.insert({tet.at(static_cast<std::size_t>(i)), tet.at(static_cast<std::size_t>(j))});
      }
    }
    for (std::size_t i = 0; i < 3; ++i) {
      const std::size_t j = (i + 1) % 3;
      const std::array<NodeId, 4> quad{prism[i], prism[j], prism[j + 3], prism[i + 3]};
      const auto lowest =
          static_cast<std::size_t>(std::min_element(quad.begin(), quad.end()) - quad.begin());
      EXPECT_TRUE(edges.contains({quad[lowest], quad[(lowest + 2) % 4]}));
      EXPECT_FALSE(edges.contains({quad[(lowest + 1) % 4], quad[(lowest + 3) % 4]}));
    }
  } while (std::next_permutation(id.begin(), id.end()));
}

using Vector = std::array<double, 3>;

Vector between(const Point3& a, const Point3& b) { return {b.x - a.x, b.y - a.y, b.z - a.z}; }

Vector cross(const Vector& u, const Vector& v) {
  return {u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]};
}

// Separating axes: two tets are disjoint iff some face normal or product of two edges
// separates them. A gap below a millionth counts as contact.
bool apart(const std::array<Point3, 4>& a, const std::array<Point3, 4>& b) {
  std::vector<Vector> axes;
  for (const auto* tet : {&a, &b}) {
    for (const auto& f : kFaceVertex) {
      const auto corner = [&](std::size_t i) { return tet->at(static_cast<std::size_t>(f[i])); };
      axes.push_back(cross(between(corner(0), corner(1)), between(corner(0), corner(2))));
    }
  }
  for (const auto& [i, j] : kEdgeVertex) {
    for (const auto& [k, l] : kEdgeVertex) {
      axes.push_back(
          cross(between(a.at(static_cast<std::size_t>(i)), a.at(static_cast<std::size_t>(j))),
                between(b.at(static_cast<std::size_t>(k)), b.at(static_cast<std::size_t>(l)))));
    }
  }
  return std::any_of(axes.begin(), axes.end(), [&](const Vector& axis) {
    const auto range = [&](const std::array<Point3, 4>& tet) {
      std::vector<double> at;
      for (const Point3& p : tet) at.push_back(axis[0] * p.x + axis[1] * p.y + axis[2] * p.z);
      const auto [low, high] = std::minmax_element(at.begin(), at.end());
      return std::pair(*low, *high);
    };
    const auto [low_a, high_a] = range(a);
    const auto [low_b, high_b] = range(b);
    return high_a + 1e-6 < low_b || high_b + 1e-6 < low_a;
  });
}

TEST(Truncation, PiecesOfTwoClassesInOneTetAreDisjoint) {
  // Two rhombi that cross one above the other, kept apart: their short diagonals are internal
  // and make a tet of two classes.
  const SectionStack stack = stack_of_boxes(
      {{{{{-4, 0}, {0, -1}, {4, 0}, {0, 1}}}}, {{{{0, -4}, {1, 0}, {0, 4}, {-1, 0}}}}});
  const auto c = slab_case(stack, 0, {});
  ASSERT_EQ(c->classes->class_count(), 2U);
  RuleCounts rules{};
  const auto active = c->active(true);
  Completion completion(*c->slab, *c->classes, active, seed(*c->slab, *c->classes, active, rules),
                        rules);
  ASSERT_TRUE(completion.run().empty());
  ASSERT_GT(rules[static_cast<std::size_t>(Rule::two_class_tet)], 0U);

  const Complex& complex = completion.complex();
  const Subdivision subdivision = subdivide(*c->slab, *c->classes, complex, rules);
  Lifting lifting(*c->slab, subdivision);
  ASSERT_TRUE(lifting.settle(rules));
  const Truncation truncation =
      truncate(*c->slab, *c->classes, complex, subdivision,
               IdVector<LiftedId, std::uint8_t>(subdivision.lifted.size(), 0));
  IdVector<NodeId, Point3> points = lifting.points();
  for (const Cut& cut : truncation.cuts) {
    points.push_back(place_cut(cut, points[cut.kept], points[cut.away], c->slab->gap()));
  }
  std::map<ClassId, std::vector<std::array<Point3, 4>>> pieces;
  for (const Piece& piece : truncation.pieces) {
    std::array<Point3, 4> tet;
    for (std::size_t i = 0; i < 4; ++i) tet[i] = points[piece.node[i]];
    EXPECT_GT(volume6(tet[0], tet[1], tet[2], tet[3]), 0);
    pieces[c->classes->of_region(piece.region)].push_back(tet);
  }
  ASSERT_EQ(pieces.size(), 2U);
  for (const auto& a : pieces[ClassId(0)]) {
    for (const auto& b : pieces[ClassId(1)]) EXPECT_TRUE(apart(a, b));
  }
}

TEST(PlaceCut, TwoClassesOnOneEdgeEndAnEighthOfItsLengthApart) {
  // Weights 9/16 from either end; from the middle of an edge, of weight 1/2, an eighth of the way
  // back is left.
  const Cut up{NodeId(0), NodeId(1), false, false, 1};
  const Cut down{NodeId(1), NodeId(0), false, false, 1};
  const Point3 low{2, 3, 0}, high{2, 3, 1};
  EXPECT_EQ(place_cut(up, low, high, 1), (Point3{2, 3, 0.4375}));
  EXPECT_EQ(place_cut(down, high, low, 1), (Point3{2, 3, 0.5625}));
  const Cut to_middle{NodeId(0), NodeId(2), true, false, 1};
  EXPECT_EQ(place_cut(to_middle, low, {2, 3, 0.5}, 1), (Point3{2, 3, 0.4375}));
}

TEST(PlaceCut, LiesNearerToTheKeptEnd) {
  for (const bool half : {false, true}) {
    for (const bool lifted : {false, true}) {
      const Point3 at =
          place_cut({NodeId(0), NodeId(1), half, lifted, 1}, {0, 0, 0}, {8, 0, 0.5}, 1);
      EXPECT_GT(at.x, 0);
      EXPECT_LE(at.x, kLargestLean);
      const Point3 steep =
          place_cut({NodeId(0), NodeId(1), half, lifted, 1}, {0, 0, 0}, {0, 0, 1}, 1);
      // Weight above 1/2 of what the far end has.
      EXPECT_EQ(steep.z, half ? 1 - 2 * kSeparation : 0.5 - kSeparation);
    }
  }
}

}  // namespace
}  // namespace tetloft::testing

#include "delaunay2/corners.hpp"

#include <gtest/gtest.h>

#include "planar_sets.hpp"
#include "support/exact/rational.hpp"

namespace tetloft::internal::delaunay2_detail {
namespace {

/// Every end of every segment against every other end there.
std::vector<std::array<bool, 2>> brute_force(const test::Graph& graph) {
  using oracle::Rational;
  std::vector<std::array<bool, 2>> acute(graph.segments.size());
  for (std::size_t s = 0; s < graph.segments.size(); ++s) {
    for (std::size_t t = 0; t < graph.segments.size(); ++t) {
      for (std::size_t i = 0; i < 2; ++i) {
        for (std::size_t j = 0; j < 2; ++j) {
          if (s == t || graph.segments[s][i] != graph.segments[t][j]) continue;
          const Point2& v = graph.points[graph.segments[s][i].index()];
          const Point2& a = graph.points[graph.segments[s][1 - i].index()];
          const Point2& b = graph.points[graph.segments[t][1 - j].index()];
          const auto difference = [](double p, double q) {
            return Rational::exactly(p) - Rational::exactly(q);
          };
          const Rational dot = difference(a.x, v.x) * difference(b.x, v.x) +
                               difference(a.y, v.y) * difference(b.y, v.y);
          if (dot.sign() > 0) acute[s][i] = true;
        }
      }
    }
  }
  return acute;
}

void expect_brute_force(const test::Graph& graph) {
  EXPECT_EQ(acute_ends(graph.points, graph.segments), brute_force(graph));
}

TEST(AcuteEnds, OfPolygonsMatchBruteForce) {
  Prng prng(1);
  for (int k = 0; k < 20; ++k) {
    expect_brute_force(test::skyline(10, 10, prng));
    expect_brute_force(test::star_polygon(20, 0.3, prng));
  }
}

TEST(AcuteEnds, OfFansMatchBruteForce) {
  Prng prng(2);
  for (std::size_t n = 1; n <= 12; ++n) {
    for (const double sector : {1.0, 3.0, 6.28}) {
      expect_brute_force(test::shuffled(test::fan(n, sector, prng), prng));
    }
  }
}

TEST(AcuteEnds, OfThreeArmsWithOneAcutePairMatchBruteForce) {
  // Wherever the order around the vertex begins, the acute pair is found.
  const Point2 around[] = {{4, 0}, {4, 3}, {0, 4}, {-3, 4}, {-4, 0}, {-4, -3}, {0, -4}, {3, -4}};
  for (std::size_t i = 0; i < 8; ++i) {
    for (std::size_t j = 0; j < 8; ++j) {
      for (std::size_t k = 0; k < 8; ++k) {
        if (i == j || j == k || k == i) continue;
        test::Graph graph{{{0, 0}, around[i], around[j], around[k]}, {}};
        for (int arm = 1; arm <= 3; ++arm)
          graph.segments.push_back({PlaneVertexId(arm), PlaneVertexId(0)});
        expect_brute_force(graph);
      }
    }
  }
}

TEST(AcuteEnds, RightAnglesAreNotAcute) {
  const test::Graph cross{{{0, 0}, {1, 0}, {0, 1}, {-1, 0}, {0, -1}},
                          {{PlaneVertexId(0), PlaneVertexId(1)},
                           {PlaneVertexId(0), PlaneVertexId(2)},
                           {PlaneVertexId(0), PlaneVertexId(3)},
                           {PlaneVertexId(0), PlaneVertexId(4)}}};
  for (const auto& ends : acute_ends(cross.points, cross.segments)) {
    EXPECT_FALSE(ends[0] || ends[1]);
  }
}

}  // namespace
}  // namespace tetloft::internal::delaunay2_detail

// Constrained triangulations: unique, whatever the history; edges, crossings, refusals, insides.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>

#include <tetloft/predicates.hpp>

#include "constrained_support.hpp"

namespace tetloft::test {
namespace {

std::set<std::array<std::uint32_t, 3>> triangles_of(const DelaunayTriangulation2& t,
                                                    const std::vector<std::uint32_t>& name) {
  std::set<std::array<std::uint32_t, 3>> result;
  for (const TriangleId triangle : t.triangles()) {
    std::array<std::uint32_t, 3> v;
    for (std::size_t i = 0; i < 3; ++i) v[i] = name[t.vertices(triangle)[i].index];
    std::sort(v.begin(), v.end());
    result.insert(v);
  }
  return result;
}

// The same points and constraints, from nothing.
testing::AssertionResult equals_new_one(const DelaunayTriangulation2& t, Prng& prng) {
  const std::vector<DelaunayVertex> live = live_vertices(t);
  std::vector<Point2> points;
  std::vector<std::uint32_t> name(t.vertex_slots());
  std::vector<std::uint32_t> same;
  for (const DelaunayVertex v : live) {
    same.push_back(static_cast<std::uint32_t>(points.size()));
    name[v.index] = same.back();
    points.push_back(t.point(v));
  }
  DelaunayTriangulation2 anew = value_of(DelaunayTriangulation2::of(points));
  std::vector<ConstraintId> order = t.constraints();
  prng.shuffle(order);
  for (const ConstraintId c : order) {
    const auto [u, v] = t.ends(c);
    (void)value_of(
        anew.insert_constraint(anew.vertex_at(name[v.index]), anew.vertex_at(name[u.index])));
  }
  if (triangles_of(t, name) != triangles_of(anew, same)) {
    return testing::AssertionFailure() << "not what is made of the same from nothing";
  }
  return testing::AssertionSuccess();
}

void change_constraints(DelaunayTriangulation2& t, const std::vector<DelaunayVertex>& live,
                        Prng& prng) {
  const std::vector<ConstraintId> constraints = t.constraints();
  if (!constraints.empty() && prng.chance(0.3)) {
    const ConstraintId c = constraints[prng.below(constraints.size())];
    succeed(t.remove_constraint(c));
    EXPECT_FALSE(t.is_live(c));
    return;
  }
  const DelaunayVertex u = live[prng.below(live.size())];
  const DelaunayVertex v = live[prng.below(live.size())];
  bool crosses = u == v;
  for (const Edge& e : constrained_edges(t)) {
    crosses = crosses || cross_properly(t.point(u), t.point(v), t.point(e[0]), t.point(e[1]));
  }
  EXPECT_EQ(t.insert_constraint(u, v).ok(), !crosses);
}

void change_points(DelaunayTriangulation2& t, const std::vector<DelaunayVertex>& live,
                   const PlaneSource& source, double scale, Prng& prng) {
  Point2 p = source.draw(prng);
  p = {scale * p.x, scale * p.y};
  if (live.empty() || prng.chance(0.5)) {
    (void)value_of(t.insert(p));
    return;
  }
  const DelaunayVertex v = live[prng.below(live.size())];
  bool held = false;
  for (const Edge& e : constrained_edges(t)) held = held || e[0] == v || e[1] == v;
  if (prng.chance(0.6)) {
    EXPECT_EQ(t.remove(v).ok(), !held);
    return;
  }
  const bool taken = std::any_of(live.begin(), live.end(),
                                 [&](DelaunayVertex u) { return t.point(u) == p && u != v; });
  EXPECT_EQ(t.move(v, p).ok(), t.point(v) == p || (!held && !taken));
}

TEST(Constrained, IsUniqueAfterEveryStep) {
  for (const PlaneSource& source : plane_sources()) {
    const bool whole = source.name == "lattice" || source.name == "small lattice" ||
                       source.name == "circle" || source.name == "line" ||
                       source.name == "line and a few" || source.name == "two lines";
    for (std::uint64_t seed = 1; seed <= 8; ++seed) {
      SCOPED_TRACE(testing::Message() << source.name << ", seed " << seed);
      Prng prng(seed);
      DelaunayTriangulation2 t;
      for (int step = 0; step < 80; ++step) {
        SCOPED_TRACE(testing::Message() << "step " << step);
        const std::vector<DelaunayVertex> live = live_vertices(t);
        if (live.size() > 5 && prng.chance(0.5)) {
          change_constraints(t, live, prng);
        } else {
          change_points(t, live, source, whole ? 3 : 1, prng);
        }
        for (const ConstraintId c : t.constraints()) ASSERT_TRUE(covers_its_segment(t, c));
        ASSERT_TRUE(is_constrained_delaunay(t, whole));
        if (step % 4 == 0) {
          ASSERT_TRUE(equals_new_one(t, prng));
        }
      }
    }
  }
}

// Each constraint is a path, whose vertices are as near to its segment as rounding leaves them.
testing::AssertionResult is_bent_path(const DelaunayTriangulation2& t, ConstraintId c) {
  std::map<DelaunayVertex, int> degree;
  for (const Edge& e : t.edges(c)) {
    for (const DelaunayVertex v : e) ++degree[v];
  }
  const auto ends = t.ends(c);
  const Point2 a = t.point(ends[0]), b = t.point(ends[1]);
  for (const auto& [v, n] : degree) {
    const bool is_end = v == ends[0] || v == ends[1];
    if (n != (is_end ? 1 : 2)) return testing::AssertionFailure() << "no path";
    const Point2 p = t.point(v);
    const double area = (b.x - a.x) * (p.y - a.y) - (b.y - a.y) * (p.x - a.x);
    if (std::abs(area) > 1e-12) return testing::AssertionFailure() << "bent by " << area;
  }
  return testing::AssertionSuccess();
}

TEST(Constrained, CrossingOnesAreDividedWhereTheyCross) {
  for (const bool lattice : {false, true}) {
    for (std::uint64_t seed = 1; seed <= 6; ++seed) {
      SCOPED_TRACE(testing::Message() << "seed " << seed);
      Prng prng(seed);
      DelaunayTriangulation2 t;
      for (int i = 0; i < 40; ++i) {
        const auto coordinate = [&] {
          return lattice ? static_cast<double>(prng.below(8)) / 8 : prng.unit();
        };
        (void)value_of(t.insert({coordinate(), coordinate()}));
      }
      const std::vector<DelaunayVertex> first = live_vertices(t);
      for (int i = 0; i < 25; ++i) {
        const DelaunayVertex u = first[prng.below(first.size())];
        const DelaunayVertex v = first[prng.below(first.size())];
        if (u == v) continue;
        (void)value_of(t.insert_constraint(u, v, Crossing::split));
        ASSERT_TRUE(is_constrained_delaunay(t, false));
      }
      for (const ConstraintId c : t.constraints()) ASSERT_TRUE(is_bent_path(t, c));
      for (const ConstraintId c : t.constraints()) succeed(t.remove_constraint(c));
      EXPECT_TRUE(equals_batch(t));
    }
  }
}

TEST(Constrained, ManyAreInsertedOrNone) {
  Prng prng(31);
  DelaunayTriangulation2 one;
  for (int i = 0; i < 60; ++i) (void)value_of(one.insert({prng.unit(), prng.unit()}));
  const std::vector<DelaunayVertex> live = live_vertices(one);
  std::vector<Edge> segments;
  for (std::size_t i = 0; i + 1 < live.size(); i += 2) segments.push_back({live[i], live[i + 1]});
  DelaunayTriangulation2 many = one;
  const Error refused = many.insert_constraints(segments).error();
  EXPECT_EQ(refused.code, ErrorCode::invalid_input);
  EXPECT_EQ(refused.message.find("segment "), 0U);
  EXPECT_EQ(many.constraint_count(), 0U);
  EXPECT_TRUE(equals_batch(many));

  const std::vector<ConstraintId> ids =
      value_of(many.insert_constraints(segments, Crossing::split));
  for (const Edge& e : segments) {
    (void)value_of(one.insert_constraint(e[0], e[1], Crossing::split));
  }
  EXPECT_GT(many.vertex_count(), live.size());
  EXPECT_EQ(many.edges(), one.edges());
  for (std::size_t i = 0; i < ids.size(); ++i) EXPECT_EQ(many.ends(ids[i]), segments[i]);
  segments.push_back({live[0], live[0]});
  EXPECT_FALSE(many.insert_constraints(segments, Crossing::split).ok());
  EXPECT_EQ(many.constraint_count(), ids.size());
}

// On a grid of ulps no crossing has a point of its own: pieces go over what is there.
TEST(Constrained, PiecesOfAFewUlpsEnd) {
  std::size_t refused = 0;
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    Prng prng(seed);
    DelaunayTriangulation2 t;
    const double u = 0x1p-52;
    for (int i = 0; i < 30; ++i) {
      (void)value_of(t.insert({1 + u * static_cast<double>(prng.below(9)),
                               1 + u * static_cast<double>(prng.below(9))}));
    }
    for (int i = 0; i < 20; ++i) {
      const std::vector<DelaunayVertex> live = live_vertices(t);
      const DelaunayVertex from = live[prng.below(live.size())];
      const DelaunayVertex to = live[prng.below(live.size())];
      if (from == to) continue;
      const std::size_t before = t.constraint_count();
      const auto made = t.insert_constraint(from, to, Crossing::split);
      if (!made) {
        EXPECT_EQ(made.error().code, ErrorCode::work_limit);
        EXPECT_EQ(t.constraint_count(), before);
        ++refused;
      }
      ASSERT_TRUE(is_constrained_delaunay(t, false));
    }
    for (const ConstraintId c : t.constraints()) succeed(t.remove_constraint(c));
    EXPECT_TRUE(equals_batch(t));
  }
  EXPECT_EQ(refused, 0U);
}

// Three that lie beside each other, a step of doubles apart at one end: rounded, their crossings
// would move along them by a step each.
TEST(Constrained, PiecesBesideEachOtherDoNotCreep) {
  const Point2 far{0x1.adeca10e2dd4fp+2, 0x1.546d5146407e1p+3};
  const Point2 farther{0x1.a615fcdbe097p+2, 0x1.562f1dd72a67cp+3};
  const Point2 near{0x1.b507507507518p+2, 0x1.4f8af8af8af87p+3};
  const Point2 nearer{0x1.b507507507519p+2, 0x1.4f8af8af8af86p+3};
  const std::vector<Point2> points{far, farther, near, nearer};
  DelaunayTriangulation2 t = value_of(DelaunayTriangulation2::of(points));
  const auto v = live_vertices(t);
  const std::vector<Edge> segments{{v[2], v[0]}, {v[2], v[1]}, {v[3], v[0]}, {v[3], v[1]}};
  (void)value_of(t.insert_constraints(segments, Crossing::split));
  EXPECT_LE(t.vertex_count(), 6U);
  ASSERT_TRUE(is_constrained_delaunay(t, false));
}

TEST(Constrained, RefusalsNameWhatIsInTheWay) {
  const std::vector<Point2> square{{0, 0}, {4, 0}, {4, 4}, {0, 4}};
  DelaunayTriangulation2 t = value_of(DelaunayTriangulation2::of(square));
  const auto v = live_vertices(t);
  const ConstraintId c = value_of(t.insert_constraint(v[0], v[2]));
  const Error crossing = t.insert_constraint(v[3], v[1]).error();
  EXPECT_EQ(crossing.code, ErrorCode::invalid_input);
  EXPECT_NE(crossing.message.find("constraint 0"), std::string::npos) << crossing.message;
  ASSERT_TRUE(crossing.where.point.has_value());
  EXPECT_EQ(*crossing.where.point, (Point3{2, 2, 0}));
  EXPECT_EQ(t.remove(v[2]).error().where.vertex, 2U);
  EXPECT_EQ(t.move(v[2], {5, 5}).error().code, ErrorCode::invalid_input);
  EXPECT_EQ(t.insert_constraint(v[1], v[1]).error().code, ErrorCode::invalid_input);
  EXPECT_EQ(t.insert_constraint(v[1], {}).error().code, ErrorCode::invalid_input);
  succeed(t.remove_constraint(c));
  EXPECT_EQ(t.remove_constraint(c).error().code, ErrorCode::invalid_input);
  EXPECT_THROW((void)t.ends(c), std::out_of_range);
  EXPECT_THROW((void)t.edges(c), std::out_of_range);
  EXPECT_TRUE(t.insert_constraint(v[3], v[1]).ok());
}

TEST(Constrained, OverlappingOnesShareEdges) {
  DelaunayTriangulation2 t;
  std::vector<DelaunayVertex> v;
  for (int i = 0; i < 5; ++i) v.push_back(value_of(t.insert({1.0 * i, 0})).vertex);
  const ConstraintId a = value_of(t.insert_constraint(v[0], v[3]));
  const ConstraintId b = value_of(t.insert_constraint(v[4], v[2]));
  for (const Point2& p : {Point2{2, 3}, {2, -3}, {2.5, 0}}) (void)value_of(t.insert(p));
  EXPECT_EQ(t.edges(a).size(), 4U);
  EXPECT_EQ(t.edges(b).size(), 3U);
  EXPECT_EQ(t.constraints(v[2], live_vertices(t).back()), (std::vector{a, b}));
  succeed(t.remove_constraint(a));
  EXPECT_EQ(t.edges(b).size(), 3U);
  EXPECT_EQ(t.constraints(v[0], v[1]).size(), 0U);
  EXPECT_FALSE(t.remove(v[3]).ok());
  EXPECT_TRUE(t.remove(v[0]).ok());
}

TEST(Constrained, InsideIsBetweenOutlineAndHoles) {
  DelaunayTriangulation2 t;
  std::vector<DelaunayVertex> v;
  const auto outline = [&](double low, double high) {
    std::vector<DelaunayVertex> ring;
    for (const Point2& p : {Point2{low, low}, {high, low}, {high, high}, {low, high}}) {
      ring.push_back(value_of(t.insert(p)).vertex);
    }
    for (std::size_t i = 0; i < 4; ++i) {
      (void)value_of(t.insert_constraint(ring[i], ring[(i + 1) % 4]));
    }
    v.insert(v.end(), ring.begin(), ring.end());
  };
  (void)value_of(t.insert({-3, 5}));
  for (int x = 0; x <= 10; ++x) (void)value_of(t.insert({1.0 * x, 3}));
  const auto area_inside = [&] {
    double area = 0;
    for (const TriangleId triangle : value_of(t.inside())) {
      const auto w = t.vertices(triangle);
      const Point2 a = t.point(w[0]), b = t.point(w[1]), c = t.point(w[2]);
      area += ((b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x)) / 2;
    }
    return area;
  };
  EXPECT_EQ(area_inside(), 0);
  outline(0, 10);
  EXPECT_EQ(area_inside(), 100);
  outline(2, 8);
  EXPECT_EQ(area_inside(), 64);
  outline(4, 6);
  EXPECT_EQ(area_inside(), 68);
  const ConstraintId open = value_of(t.insert_constraint(v[0], v[4]));
  EXPECT_EQ(t.inside().error().code, ErrorCode::invalid_input);
  const ConstraintId twice = value_of(t.insert_constraint(v[4], v[0]));
  EXPECT_EQ(area_inside(), 68);
  succeed(t.remove_constraint(open));
  EXPECT_FALSE(t.inside().ok());
  succeed(t.remove_constraint(twice));
  EXPECT_EQ(area_inside(), 68);
}

// A fan of long constraints over points an ulp beside them.
TEST(Constrained, VerticesBesideConstraintsStayOnTheirSide) {
  DelaunayTriangulation2 t;
  const DelaunayVertex u = value_of(t.insert({0, 0})).vertex;
  const DelaunayVertex v = value_of(t.insert({3, 1})).vertex;
  Prng prng(4);
  std::map<DelaunayVertex, Sign> side;
  const auto put = [&](double x) {
    for (const double to : {-9.0, 9.0}) {
      const Point2 p{x, std::nextafter(x / 3, to)};
      const DelaunayVertex w = value_of(t.insert(p)).vertex;
      side[w] = orient2d({0, 0}, {3, 1}, p);
    }
  };
  for (int i = 0; i < 100; ++i) put(3 * prng.unit());
  const ConstraintId c = value_of(t.insert_constraint(u, v));
  for (int i = 0; i < 100; ++i) put(3 * prng.unit());
  ASSERT_TRUE(is_constrained_delaunay(t, false));
  ASSERT_TRUE(covers_its_segment(t, c));
  for (const TriangleId triangle : t.triangles()) {
    std::set<Sign> signs;
    for (const DelaunayVertex w : t.vertices(triangle)) {
      if (w != u && w != v && side[w] != Sign::zero) signs.insert(side[w]);
    }
    EXPECT_LE(signs.size(), 1U);
  }
}

TEST(Constrained, ManyPointsAtOnceDivideConstraintsOrNothing) {
  DelaunayTriangulation2 t;
  const DelaunayVertex u = value_of(t.insert({0, 0})).vertex;
  const DelaunayVertex v = value_of(t.insert({64, 64})).vertex;
  (void)value_of(t.insert({0, 64}));
  const ConstraintId c = value_of(t.insert_constraint(u, v));
  std::vector<Point2> points;
  for (int x = 0; x < 64; ++x) {
    for (int y = 0; y < 80; ++y) points.push_back({1.0 * x, 1.0 * y});
  }
  std::stop_source stop;
  const Execution execution{.threads = 1,
                            .stop = stop.get_token(),
                            .progress = [&](std::size_t, std::size_t) { stop.request_stop(); }};
  EXPECT_EQ(t.insert(points, execution).error().code, ErrorCode::cancelled);
  EXPECT_EQ(t.vertex_count(), 3U);
  EXPECT_EQ(t.edges(c).size(), 1U);
  (void)value_of(t.insert(points));
  EXPECT_EQ(t.edges(c).size(), 64U);
  EXPECT_TRUE(covers_its_segment(t, c));
}

// Through a thousand triangles and their vertices on either side.
TEST(Constrained, LongOnesGoThroughManyTriangles) {
  Prng prng(2);
  std::vector<Point2> points{{-1, 0.5}, {2, 0.5}, {0.3, -1}, {0.4, 2}};
  for (int i = 0; i < 20000; ++i) points.push_back({prng.unit(), prng.unit()});
  DelaunayTriangulation2 t = value_of(DelaunayTriangulation2::of(points));
  const ConstraintId a = value_of(t.insert_constraint(t.vertex_at(0), t.vertex_at(1)));
  EXPECT_FALSE(t.insert_constraint(t.vertex_at(2), t.vertex_at(3)).ok());
  ASSERT_TRUE(is_constrained_delaunay(t, false));
  const ConstraintId b =
      value_of(t.insert_constraint(t.vertex_at(2), t.vertex_at(3), Crossing::split));
  ASSERT_TRUE(is_constrained_delaunay(t, false));
  EXPECT_EQ(t.edges(a).size(), 2U);
  EXPECT_EQ(t.edges(b).size(), 2U);
  succeed(t.remove_constraint(a));
  succeed(t.remove_constraint(b));
  EXPECT_EQ(t.triangle_count(), value_of(t.snapshot()).triangulation.triangles.size());
  ASSERT_TRUE(is_constrained_delaunay(t, false));
}

}  // namespace
}  // namespace tetloft::test

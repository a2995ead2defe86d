// Delaunay triangulations of the plane that change, in C: those of C++, through histories of each
// call, with constraints.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>

#include <tetloft/delaunay_triangulation2.hpp>

#include "c/changing_numbers.hpp"
#include "c/owned.hpp"
#include "core/prng.hpp"

namespace tetloft::c_test {
namespace {

using TriangleNumbers = std::array<Number, 3>;
using EdgeNumbers = std::array<Number, 2>;

std::vector<std::uint32_t> ids(const std::vector<ConstraintId>& constraints) {
  std::vector<std::uint32_t> result;
  for (const ConstraintId c : constraints) result.push_back(c.value());
  return result;
}

void expect_same_vertex(const tetloft_delaunay_plane* c, const DelaunayTriangulation2& t,
                        DelaunayVertex v) {
  expect_found<Number, Number>(
      [&](auto* a, auto n, auto* count) {
        return tetloft_delaunay_plane_neighbours(c, number(v), a, n, count);
      },
      numbers(t.neighbours(v)));
  expect_found<TriangleNumbers, Number>(
      [&](auto* a, auto n, auto* count) {
        return tetloft_delaunay_plane_star(c, number(v), a, n, count);
      },
      corners<3>(t, t.star(v)));
  std::array<double, 2> xy{};
  ASSERT_OK(tetloft_delaunay_plane_point(c, number(v), xy.data()));
  EXPECT_EQ((Point2{xy[0], xy[1]}), t.point(v));
  for (const DelaunayVertex u : t.neighbours(v)) {
    expect_found<std::uint32_t, std::uint32_t>(
        [&](auto* a, auto n, auto* count) {
          return tetloft_delaunay_plane_edge_constraints(c, number(u), number(v), a, n, count);
        },
        ids(t.constraints(u, v)));
  }
}

void expect_same_constraint(const tetloft_delaunay_plane* c, const DelaunayTriangulation2& t,
                            ConstraintId of) {
  EdgeNumbers ends{};
  ASSERT_OK(tetloft_delaunay_plane_constraint_ends(c, of.value(), ends.data()));
  EXPECT_EQ(ends, numbers(t.ends(of)));
  expect_found<EdgeNumbers, Number>(
      [&](auto* a, auto n, auto* count) {
        return tetloft_delaunay_plane_constraint_edges(c, of.value(), a, n, count);
      },
      numbers(t.edges(of)));
  int has = 7;
  ASSERT_OK(tetloft_delaunay_plane_has_constraint(c, of.value(), &has));
  EXPECT_EQ(has, 1);
}

void expect_same_inside(const tetloft_delaunay_plane* c, const DelaunayTriangulation2& t) {
  const auto inside = t.inside();
  if (inside) {
    expect_found<TriangleNumbers, Number>(
        [&](auto* a, auto n, auto* count) { return tetloft_delaunay_plane_inside(c, a, n, count); },
        corners<3>(t, *inside));
    return;
  }
  std::size_t count = 7;
  EXPECT_EQ(tetloft_delaunay_plane_inside(c, nullptr, 0, &count), TETLOFT_INVALID_INPUT);
  EXPECT_EQ(count, 0U);
  EXPECT_EQ(tetloft_last_error(), to_string(inside.error()));
}

void expect_same_plane(const tetloft_delaunay_plane* c, const DelaunayTriangulation2& t) {
  std::array<std::size_t, 4> counts{};
  int dimension = 7;
  ASSERT_OK(
      tetloft_delaunay_plane_counts(c, &counts[0], &counts[1], &counts[2], &counts[3], &dimension));
  EXPECT_EQ(counts, (std::array{t.vertex_count(), t.vertex_slots(), t.triangle_count(),
                                t.constraint_count()}));
  EXPECT_EQ(dimension, t.dimension());
  const std::vector<DelaunayVertex> live(t.vertices().begin(), t.vertices().end());
  std::vector<Point2> points;
  for (const DelaunayVertex v : live) points.push_back(t.point(v));
  expect_found<Number, Number>(
      [&](auto* a, auto n, auto* count) { return tetloft_delaunay_plane_vertices(c, a, n, count); },
      numbers(live));
  expect_found<Point2, double>(
      [&](auto* a, auto n, auto* count) { return tetloft_delaunay_plane_points(c, a, n, count); },
      points);
  expect_found<TriangleNumbers, Number>(
      [&](auto* a, auto n, auto* count) {
        return tetloft_delaunay_plane_triangles(c, a, n, count);
      },
      corners<3>(t, t.triangles()));
  expect_found<Number, Number>(
      [&](auto* a, auto n, auto* count) { return tetloft_delaunay_plane_hull(c, a, n, count); },
      numbers(t.hull()));
  for (const DelaunayVertex v : live) expect_same_vertex(c, t, v);
  expect_found<std::uint32_t, std::uint32_t>(
      [&](auto* a, auto n, auto* count) {
        return tetloft_delaunay_plane_constraints(c, a, n, count);
      },
      ids(t.constraints()));
  for (const ConstraintId of : t.constraints()) expect_same_constraint(c, t, of);
  expect_same_inside(c, t);
}

// Of a small lattice: many are equal, many are as near to one place.
class ChangingPlaneOfC : public testing::Test {
 protected:
  Point2 point() {
    const auto coordinate = [&] { return static_cast<double>(random_.below(9)); };
    const double x = coordinate();
    return {x, coordinate()};
  }
  std::vector<Point2> points(std::size_t count) {
    std::vector<Point2> result;
    for (std::size_t i = 0; i < count; ++i) result.push_back(point());
    return result;
  }
  DelaunayVertex some_vertex(const DelaunayTriangulation2& t) {
    const std::vector<DelaunayVertex> live(t.vertices().begin(), t.vertices().end());
    return live[random_.below(live.size())];
  }
  internal::Prng random_{21};
};

TEST_F(ChangingPlaneOfC, HasTheHistoryOfCpp) {
  const std::vector<Point2> first = points(40);
  auto t = DelaunayTriangulation2::of(first).value();
  Owned<tetloft_delaunay_plane> c;
  ASSERT_OK(tetloft_delaunay_plane_create(coordinates(first), first.size(), nullptr, c.out()));
  expect_same_plane(c, t);
  DelaunayVertex near;
  std::array<int, 2> refused{};
  for (int step = 0; step < 100; ++step) {
    const Point2 p = point();
    const DelaunayVertex v = some_vertex(t);
    const DelaunayVertex u = some_vertex(t);
    if (step % 4 == 0) {
      Number made = 0;
      int is_new = 7;
      ASSERT_OK(tetloft_delaunay_plane_insert(c, p.x, p.y, number(near), &made, &is_new));
      const auto expected = t.insert(p, near).value();
      EXPECT_EQ(made, number(expected.vertex));
      EXPECT_EQ(is_new, expected.is_new ? 1 : 0);
      near = expected.vertex;
    } else if (step % 4 == 1) {
      const auto moved = t.move(v, p);
      EXPECT_EQ(tetloft_delaunay_plane_move(c, number(v), p.x, p.y),
                moved ? TETLOFT_OK : TETLOFT_INVALID_INPUT);
    } else if (step % 4 == 2) {
      const auto removed = t.remove(v);
      EXPECT_EQ(tetloft_delaunay_plane_remove(c, number(v)),
                removed ? TETLOFT_OK : TETLOFT_INVALID_INPUT);
      if (removed) continue;
      ++refused[0];
      EXPECT_EQ(tetloft_last_error(), to_string(removed.error()));
    } else {
      const Crossing crossing = step % 8 == 3 ? Crossing::refuse : Crossing::split;
      const auto expected = t.insert_constraint(u, v, crossing);
      std::uint32_t made = 7;
      const tetloft_status status = tetloft_delaunay_plane_insert_constraint(
          c, number(u), number(v), static_cast<std::int32_t>(crossing), &made);
      EXPECT_EQ(status == TETLOFT_OK, expected.ok());
      EXPECT_EQ(made, expected ? expected->value() : 0);
      if (expected) continue;
      ++refused[1];
      EXPECT_EQ(tetloft_last_error(), to_string(expected.error()));
    }
  }
  EXPECT_GT(std::min(refused[0], refused[1]), 0);
  expect_same_plane(c, t);
  const std::vector<Point2> more = points(30);
  std::vector<Number> made(more.size());
  ASSERT_OK(
      tetloft_delaunay_plane_insert_all(c, coordinates(more), more.size(), nullptr, made.data()));
  EXPECT_EQ(made, numbers(t.insert(more).value()));
  const ConstraintId gone = t.constraints().front();
  ASSERT_OK(tetloft_delaunay_plane_remove_constraint(c, gone.value()));
  ASSERT_TRUE(t.remove_constraint(gone).ok());
  expect_same_plane(c, t);
  Owned<tetloft_delaunay_plane> copy;
  ASSERT_OK(tetloft_delaunay_plane_copy(c, copy.out()));
  Owned<tetloft_bytes> bytes;
  ASSERT_OK(tetloft_delaunay_plane_serialise(c, bytes.out()));
  ASSERT_OK(tetloft_delaunay_plane_clear(c));
  expect_same_plane(copy, t);
  const std::string data = bytes_of(bytes);
  const auto expected = t.serialise().value();
  EXPECT_EQ(data, std::string(reinterpret_cast<const char*>(expected.data()), expected.size()));
  Owned<tetloft_delaunay_plane> read;
  ASSERT_OK(tetloft_delaunay_plane_deserialise(data.data(), data.size(), read.out()));
  expect_same_plane(read, DelaunayTriangulation2::deserialise(expected).value());
  EXPECT_EQ(tetloft_delaunay_plane_deserialise(data.data(), data.size() - 1, read.out()),
            TETLOFT_INVALID_INPUT);
  expect_same_plane(c, DelaunayTriangulation2());
}

TEST_F(ChangingPlaneOfC, AnswersAsCpp) {
  for (const bool constrained : {false, true}) {
    const std::vector<Point2> of = points(60);
    auto t = DelaunayTriangulation2::of(of).value();
    Owned<tetloft_delaunay_plane> c;
    ASSERT_OK(tetloft_delaunay_plane_create(coordinates(of), of.size(), nullptr, c.out()));
    if (constrained) {
      const std::vector<DelaunayVertex> hull = t.hull();
      const DelaunayVertex u = hull.front(), v = hull[hull.size() / 2];
      ASSERT_TRUE(t.insert_constraint(u, v).ok());
      std::uint32_t made = 0;
      ASSERT_OK(tetloft_delaunay_plane_insert_constraint(c, number(u), number(v),
                                                         TETLOFT_CROSSING_REFUSE, &made));
    }
    std::vector<Point2> queries = points(50);
    for (Point2& q : queries) q = {q.x * 1.25 - 0.5, q.y + 0.5};
    std::vector<Number> nearest(queries.size());
    std::vector<TriangleNumbers> simplices(queries.size());
    std::vector<std::int32_t> kinds(queries.size());
    ASSERT_OK(tetloft_delaunay_plane_nearest(c, coordinates(queries), queries.size(), nullptr,
                                             nearest.data()));
    ASSERT_OK(tetloft_delaunay_plane_locate(c, coordinates(queries), queries.size(), nullptr,
                                            kinds.data(), simplices.front().data()));
    ASSERT_OK(tetloft_delaunay_plane_locate(c, coordinates(queries), queries.size(), nullptr,
                                            nullptr, nullptr));
    for (std::size_t i = 0; i < queries.size(); ++i) {
      const Point2& q = queries[i];
      EXPECT_EQ(nearest[i], number(t.nearest_vertex(q).value()));
      const Location2 location = t.locate(q).value();
      EXPECT_EQ(kinds[i], static_cast<int>(location.kind));
      EXPECT_EQ(simplices[i], numbers(location.vertices));
      expect_found<Number, Number>(
          [&](auto* a, auto n, auto* count) {
            return tetloft_delaunay_plane_nearest_few(c, q.x, q.y, 7, a, n, count);
          },
          numbers(t.nearest_vertices(q, 7).value()));
      expect_found<Number, Number>(
          [&](auto* a, auto n, auto* count) {
            return tetloft_delaunay_plane_within(c, q.x, q.y, 1.5, a, n, count);
          },
          numbers(t.vertices_within(q, 1.5).value()));
      const ConflictZone2 zone = t.conflict_zone(q).value();
      expect_zone<3>(
          [&](auto... parts) {
            return tetloft_delaunay_plane_conflict_zone(c, q.x, q.y, nearest[i], parts...);
          },
          corners<3>(t, zone.triangles), numbers(zone.horizon), numbers(zone.neighbours));
    }
    std::size_t count = 0;
    EXPECT_EQ(tetloft_delaunay_plane_within(c, 0, 0, -1, nullptr, 0, &count),
              TETLOFT_INVALID_INPUT);
  }
}

TEST_F(ChangingPlaneOfC, ConstraintsOfManyAreAllOrNone) {
  const std::vector<Point2> of{{0, 0}, {4, 0}, {4, 4}, {0, 4}, {1, 1}, {3, 1}, {3, 3}, {1, 3}};
  std::vector<Number> segments{0, 1, 1, 2, 2, 3, 3, 0, 4, 5, 5, 6, 6, 7, 7, 4};
  Owned<tetloft_delaunay_plane> c;
  ASSERT_OK(tetloft_delaunay_plane_create(coordinates(of), of.size(), nullptr, c.out()));
  std::vector<std::uint32_t> made(9, 7);
  ASSERT_OK(tetloft_delaunay_plane_insert_constraints(c, segments.data(), 8,
                                                      TETLOFT_CROSSING_REFUSE, made.data()));
  EXPECT_EQ(made, (std::vector<std::uint32_t>{0, 1, 2, 3, 4, 5, 6, 7, 7}));
  std::size_t count = 0;
  ASSERT_OK(tetloft_delaunay_plane_inside(c, nullptr, 0, &count));
  EXPECT_EQ(count, 8U) << "a square with a square hole";

  const std::vector<Number> across{0, 1, 0, 2};
  std::vector<std::uint32_t> more(2, 7);
  EXPECT_EQ(tetloft_delaunay_plane_insert_constraints(c, across.data(), 2, TETLOFT_CROSSING_REFUSE,
                                                      more.data()),
            TETLOFT_OK)
      << "through the corners of the hole";
  ASSERT_OK(tetloft_delaunay_plane_remove_constraint(c, more[1]));
  const std::vector<Number> crossing{4, 6, 5, 7};
  EXPECT_EQ(tetloft_delaunay_plane_insert_constraints(c, crossing.data(), 2,
                                                      TETLOFT_CROSSING_REFUSE, nullptr),
            TETLOFT_INVALID_INPUT);
  EXPECT_NE(std::string(tetloft_last_error()).find("segment 1"), std::string::npos);
  tetloft_place place = {TETLOFT_PLACE_VERSION, nullptr, 0, 0, 0, 0, 0, 0, {0, 0, 0}};
  ASSERT_OK(tetloft_last_place(&place));
  ASSERT_EQ(place.has_point, 1);
  EXPECT_EQ(place.point[0], 2);
  EXPECT_EQ(place.point[1], 2);
  std::size_t vertices = 0, constraints = 0;
  ASSERT_OK(tetloft_delaunay_plane_counts(c, nullptr, nullptr, nullptr, &constraints, nullptr));
  EXPECT_EQ(constraints, 9U) << "none of both";
  ASSERT_OK(tetloft_delaunay_plane_insert_constraints(c, crossing.data(), 2, TETLOFT_CROSSING_SPLIT,
                                                      nullptr));
  ASSERT_OK(tetloft_delaunay_plane_counts(c, &vertices, nullptr, nullptr, &constraints, nullptr));
  EXPECT_EQ(constraints, 11U);
  EXPECT_EQ(vertices, 9U) << "one where they cross";
}

TEST_F(ChangingPlaneOfC, RefusesWhatIsNotThere) {
  const std::vector<Point2> of{{0, 0}, {2, 0}, {2, 2}, {0, 2}, {1, 0}};
  Owned<tetloft_delaunay_plane> c;
  ASSERT_OK(tetloft_delaunay_plane_create(coordinates(of), of.size(), nullptr, c.out()));
  std::uint32_t made = 7;
  for (const std::int32_t none : {-1, 2, 1000}) {
    EXPECT_EQ(tetloft_delaunay_plane_insert_constraint(c, 0, 2, none, &made), TETLOFT_USAGE);
    EXPECT_EQ(made, 0U);
    EXPECT_EQ(tetloft_last_error(),
              "crossing is " + std::to_string(none) + ", which is none of 0 to 1");
    const EdgeNumbers segment{0, 2};
    EXPECT_EQ(tetloft_delaunay_plane_insert_constraints(c, segment.data(), 1, none, &made),
              TETLOFT_USAGE);
  }
  ASSERT_OK(tetloft_delaunay_plane_remove(c, 3));
  ASSERT_OK(tetloft_delaunay_plane_insert_constraint(c, 0, 1, TETLOFT_CROSSING_REFUSE, &made));
  EXPECT_EQ(tetloft_delaunay_plane_remove(c, 4), TETLOFT_INVALID_INPUT) << "it goes over it";
  std::size_t count = 7;
  EdgeNumbers ends{7, 7};
  std::array<double, 2> xy{7, 7};
  for (const Number gone : {Number{3}, Number{5}, Number{TETLOFT_NO_VERTEX}}) {
    EXPECT_EQ(tetloft_delaunay_plane_insert_constraint(c, gone, 0, TETLOFT_CROSSING_SPLIT, &made),
              TETLOFT_INVALID_INPUT);
    EXPECT_EQ(tetloft_delaunay_plane_move(c, gone, 5, 5), TETLOFT_INVALID_INPUT);
    EXPECT_EQ(tetloft_delaunay_plane_point(c, gone, xy.data()), TETLOFT_INVALID_INPUT);
    EXPECT_EQ(xy, (std::array<double, 2>{}));
    EXPECT_EQ(tetloft_delaunay_plane_star(c, gone, nullptr, 0, &count), TETLOFT_INVALID_INPUT);
    EXPECT_EQ(tetloft_delaunay_plane_edge_constraints(c, 0, gone, nullptr, 0, &count),
              TETLOFT_INVALID_INPUT);
    EXPECT_NE(std::string(tetloft_last_error()).find("there is no vertex"), std::string::npos);
  }
  ASSERT_OK(tetloft_delaunay_plane_remove_constraint(c, 0));
  int has = 7;
  for (const std::uint32_t gone : {0U, 1U, TETLOFT_NO_ID}) {
    ASSERT_OK(tetloft_delaunay_plane_has_constraint(c, gone, &has));
    EXPECT_EQ(has, 0);
    EXPECT_EQ(tetloft_delaunay_plane_remove_constraint(c, gone), TETLOFT_INVALID_INPUT);
    EXPECT_EQ(tetloft_delaunay_plane_constraint_ends(c, gone, ends.data()), TETLOFT_INVALID_INPUT);
    EXPECT_EQ(ends, (EdgeNumbers{}));
    EXPECT_EQ(tetloft_delaunay_plane_constraint_edges(c, gone, nullptr, 0, &count),
              TETLOFT_INVALID_INPUT);
    EXPECT_NE(std::string(tetloft_last_error()).find("there is no constraint"), std::string::npos);
  }
}

TEST_F(ChangingPlaneOfC, IsChangedByOneThreadWhileOthersAsk) {
  Owned<tetloft_delaunay_plane> c;
  const std::vector<Point2> of = points(30);
  ASSERT_OK(tetloft_delaunay_plane_create(coordinates(of), of.size(), nullptr, c.out()));
  change_while_others_ask(
      [&] {
        Number nearest = 0;
        EXPECT_OK(tetloft_delaunay_plane_nearest(c, coordinates(of), 1, nullptr, &nearest));
        EXPECT_NE(nearest, Number{TETLOFT_NO_VERTEX});
      },
      [&](int i) {
        Number made = 0;
        std::uint32_t constraint = 0;
        EXPECT_OK(tetloft_delaunay_plane_insert(c, i, 9.5, TETLOFT_NO_VERTEX, &made, nullptr));
        EXPECT_OK(tetloft_delaunay_plane_insert_constraint(c, 0, made, TETLOFT_CROSSING_SPLIT,
                                                           &constraint));
        EXPECT_OK(tetloft_delaunay_plane_remove_constraint(c, constraint));
        if (i % 2 == 0) {
          EXPECT_OK(tetloft_delaunay_plane_remove(c, made));
        }
      });
}

}  // namespace
}  // namespace tetloft::c_test

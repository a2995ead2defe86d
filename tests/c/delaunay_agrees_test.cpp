// Delaunay triangulations of C that change are those of C++, through histories of each call.
#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include <tetloft/delaunay_triangulation3.hpp>

#include "c/changing_numbers.hpp"
#include "c/owned.hpp"
#include "core/prng.hpp"

namespace tetloft::c_test {
namespace {

using TetNumbers = std::array<Number, 4>;

void expect_same_triangulation(const tetloft_delaunay* c, const DelaunayTriangulation3& t) {
  std::size_t vertices = 0, slots = 0, tets = 0;
  int dimension = 7;
  ASSERT_OK(tetloft_delaunay_counts(c, &vertices, &slots, &tets, &dimension));
  EXPECT_EQ(vertices, t.vertex_count());
  EXPECT_EQ(slots, t.vertex_slots());
  EXPECT_EQ(tets, t.tet_count());
  EXPECT_EQ(dimension, t.dimension());
  std::vector<DelaunayVertex> live;
  std::vector<Point3> points;
  for (const DelaunayVertex v : t.vertices()) {
    live.push_back(v);
    points.push_back(t.point(v));
  }
  expect_found<Number, Number>(
      [&](auto* a, auto n, auto* count) { return tetloft_delaunay_vertices(c, a, n, count); },
      numbers(live));
  expect_found<Point3, double>(
      [&](auto* a, auto n, auto* count) { return tetloft_delaunay_points(c, a, n, count); },
      points);
  expect_found<TetNumbers, Number>(
      [&](auto* a, auto n, auto* count) { return tetloft_delaunay_tets(c, a, n, count); },
      corners<4>(t, t.tets()));
  for (const DelaunayVertex v : live) {
    expect_found<Number, Number>(
        [&](auto* a, auto n, auto* count) {
          return tetloft_delaunay_neighbours(c, number(v), a, n, count);
        },
        numbers(t.neighbours(v)));
    expect_found<TetNumbers, Number>(
        [&](auto* a, auto n, auto* count) {
          return tetloft_delaunay_star(c, number(v), a, n, count);
        },
        corners<4>(t, t.star(v)));
    std::array<double, 3> xyz{};
    ASSERT_OK(tetloft_delaunay_point(c, number(v), xyz.data()));
    EXPECT_EQ((Point3{xyz[0], xyz[1], xyz[2]}), t.point(v));
  }
}

// Of a small lattice: many are equal, many are as near to one place.
class ChangingDelaunayOfC : public testing::Test {
 protected:
  Point3 point() {
    const auto coordinate = [&] { return static_cast<double>(random_.below(5)); };
    const double x = coordinate();
    const double y = coordinate();
    return {x, y, coordinate()};
  }
  std::vector<Point3> points(std::size_t count) {
    std::vector<Point3> result;
    for (std::size_t i = 0; i < count; ++i) result.push_back(point());
    return result;
  }
  internal::Prng random_{20};
};

TEST_F(ChangingDelaunayOfC, HasTheHistoryOfCpp) {
  const std::vector<Point3> first = points(40);
  auto t = DelaunayTriangulation3::of(first).value();
  Owned<tetloft_delaunay> c;
  ASSERT_OK(tetloft_delaunay_create(coordinates(first), first.size(), nullptr, c.out()));
  expect_same_triangulation(c, t);
  DelaunayVertex near;
  for (int step = 0; step < 60; ++step) {
    const Point3 p = point();
    std::vector<DelaunayVertex> live(t.vertices().begin(), t.vertices().end());
    const DelaunayVertex v = live[random_.below(live.size())];
    if (step % 3 == 0) {
      Number made = 0;
      int is_new = 7;
      ASSERT_OK(tetloft_delaunay_insert(c, p.x, p.y, p.z, number(near), &made, &is_new));
      const auto expected = t.insert(p, near).value();
      EXPECT_EQ(made, number(expected.vertex));
      EXPECT_EQ(is_new, expected.is_new ? 1 : 0);
      near = expected.vertex;
    } else if (step % 3 == 1) {
      const auto moved = t.move(v, p);
      EXPECT_EQ(tetloft_delaunay_move(c, number(v), p.x, p.y, p.z),
                moved ? TETLOFT_OK : TETLOFT_INVALID_INPUT);
    } else {
      ASSERT_OK(tetloft_delaunay_remove(c, number(v)));
      ASSERT_TRUE(t.remove(v).ok());
    }
  }
  expect_same_triangulation(c, t);
  const std::vector<Point3> more = points(30);
  std::vector<Number> made(more.size());
  ASSERT_OK(tetloft_delaunay_insert_all(c, coordinates(more), more.size(), nullptr, made.data()));
  EXPECT_EQ(made, numbers(t.insert(more).value()));
  ASSERT_OK(tetloft_delaunay_insert_all(c, coordinates(more), more.size(), nullptr, nullptr));
  ASSERT_TRUE(t.insert(more).ok());
  expect_same_triangulation(c, t);
  ASSERT_OK(tetloft_delaunay_clear(c));
  expect_same_triangulation(c, DelaunayTriangulation3());
}

TEST_F(ChangingDelaunayOfC, AnswersAsCpp) {
  const std::vector<Point3> of = points(60);
  std::vector<Point3> queries = points(50);
  for (Point3& q : queries) q = {q.x * 1.25 - 0.5, q.y + 0.5, q.z};
  const auto t = DelaunayTriangulation3::of(of).value();
  Owned<tetloft_delaunay> c;
  ASSERT_OK(tetloft_delaunay_create(coordinates(of), of.size(), nullptr, c.out()));
  std::vector<Number> nearest(queries.size());
  std::vector<TetNumbers> simplices(queries.size());
  std::vector<std::int32_t> kinds(queries.size());
  ASSERT_OK(
      tetloft_delaunay_nearest(c, coordinates(queries), queries.size(), nullptr, nearest.data()));
  ASSERT_OK(tetloft_delaunay_locate(c, coordinates(queries), queries.size(), nullptr, kinds.data(),
                                    simplices.front().data()));
  ASSERT_OK(
      tetloft_delaunay_locate(c, coordinates(queries), queries.size(), nullptr, nullptr, nullptr));
  for (std::size_t i = 0; i < queries.size(); ++i) {
    const Point3& q = queries[i];
    EXPECT_EQ(nearest[i], number(t.nearest_vertex(q).value()));
    const Location3 location = t.locate(q).value();
    EXPECT_EQ(kinds[i], static_cast<int>(location.kind));
    for (std::size_t k = 0; k < 4; ++k) {
      EXPECT_EQ(simplices[i][k], number(location.vertices[k]));
      EXPECT_EQ(simplices[i][k] == TETLOFT_NO_VERTEX, !location.vertices[k].valid());
    }
    expect_found<Number, Number>(
        [&](auto* a, auto n, auto* count) {
          return tetloft_delaunay_nearest_few(c, q.x, q.y, q.z, 7, a, n, count);
        },
        numbers(t.nearest_vertices(q, 7).value()));
    expect_found<Number, Number>(
        [&](auto* a, auto n, auto* count) {
          return tetloft_delaunay_within(c, q.x, q.y, q.z, 1.5, a, n, count);
        },
        numbers(t.vertices_within(q, 1.5).value()));
  }
  std::size_t count = 0;
  EXPECT_EQ(tetloft_delaunay_within(c, 0, 0, 0, -1, nullptr, 0, &count), TETLOFT_INVALID_INPUT);
}

TEST_F(ChangingDelaunayOfC, TellsWhatAnInsertionWouldChange) {
  const std::vector<Point3> of = points(60);
  const auto t = DelaunayTriangulation3::of(of).value();
  Owned<tetloft_delaunay> c;
  ASSERT_OK(tetloft_delaunay_create(coordinates(of), of.size(), nullptr, c.out()));
  for (const Point3& p : {Point3{1.25, 2.5, 1.75}, Point3{9, 2, 2}, of[0]}) {
    const ConflictZone3 zone = t.conflict_zone(p).value();
    EXPECT_EQ(zone.horizon.empty(), p == of[0]);
    expect_zone<4>(
        [&](auto... parts) {
          return tetloft_delaunay_conflict_zone(c, p.x, p.y, p.z, TETLOFT_NO_VERTEX, parts...);
        },
        corners<4>(t, zone.tets), corners<3>(t, zone.horizon), numbers(zone.neighbours));
  }
  std::array<std::size_t, 3> counts{7, 7, 7};
  EXPECT_EQ(tetloft_delaunay_conflict_zone(c, 0, 0, std::nan(""), 0, nullptr, 0, &counts[0],
                                           nullptr, 0, &counts[1], nullptr, 0, &counts[2]),
            TETLOFT_INVALID_INPUT);
  EXPECT_EQ(counts, (std::array<std::size_t, 3>{}));
}

TEST_F(ChangingDelaunayOfC, IsCopiedAndSerialised) {
  const std::vector<Point3> of = points(50);
  Owned<tetloft_delaunay> c;
  ASSERT_OK(tetloft_delaunay_create(coordinates(of), of.size(), nullptr, c.out()));
  ASSERT_OK(tetloft_delaunay_remove(c, 0));
  auto t = DelaunayTriangulation3::of(of).value();
  ASSERT_TRUE(t.remove({0, 0}).ok());
  Owned<tetloft_delaunay> copy;
  ASSERT_OK(tetloft_delaunay_copy(c, copy.out()));
  Owned<tetloft_bytes> bytes;
  ASSERT_OK(tetloft_delaunay_serialise(c, bytes.out()));
  const std::string data = bytes_of(bytes);
  const auto expected = t.serialise().value();
  EXPECT_EQ(data, std::string(reinterpret_cast<const char*>(expected.data()), expected.size()));
  ASSERT_OK(tetloft_delaunay_clear(c));
  expect_same_triangulation(copy, t);
  Owned<tetloft_delaunay> read;
  ASSERT_OK(tetloft_delaunay_deserialise(data.data(), data.size(), read.out()));
  expect_same_triangulation(read, DelaunayTriangulation3::deserialise(expected).value());
  EXPECT_EQ(tetloft_delaunay_deserialise(data.data(), data.size() - 1, read.out()),
            TETLOFT_INVALID_INPUT);
}

TEST_F(ChangingDelaunayOfC, RefusesVerticesThatAreGone) {
  const std::vector<Point3> of{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 1, 1}};
  Owned<tetloft_delaunay> c;
  ASSERT_OK(tetloft_delaunay_create(coordinates(of), of.size(), nullptr, c.out()));
  ASSERT_OK(tetloft_delaunay_remove(c, 4));
  Number made = 0;
  ASSERT_OK(tetloft_delaunay_insert(c, 2, 2, 2, 4, &made, nullptr));
  EXPECT_EQ(made, (Number{1} << 32) + 4) << "the place is used again";
  int live = 7;
  ASSERT_OK(tetloft_delaunay_is_live(c, made, &live));
  EXPECT_EQ(live, 1);
  std::size_t count = 7;
  std::array<double, 3> xyz{7, 7, 7};
  for (const Number gone : {Number{4}, Number{5}, Number{TETLOFT_NO_VERTEX}}) {
    ASSERT_OK(tetloft_delaunay_is_live(c, gone, &live));
    EXPECT_EQ(live, 0);
    EXPECT_EQ(tetloft_delaunay_remove(c, gone), TETLOFT_INVALID_INPUT);
    EXPECT_EQ(tetloft_delaunay_move(c, gone, 5, 5, 5), TETLOFT_INVALID_INPUT);
    EXPECT_EQ(tetloft_delaunay_point(c, gone, xyz.data()), TETLOFT_INVALID_INPUT);
    EXPECT_EQ(tetloft_delaunay_star(c, gone, nullptr, 0, &count), TETLOFT_INVALID_INPUT);
    EXPECT_EQ(tetloft_delaunay_neighbours(c, gone, nullptr, 0, &count), TETLOFT_INVALID_INPUT);
    EXPECT_NE(std::string(tetloft_last_error()).find("there is no vertex"), std::string::npos);
  }
  EXPECT_EQ(tetloft_delaunay_move(c, 0, 1, 0, 0), TETLOFT_INVALID_INPUT) << "vertex 1 is there";
}

TEST_F(ChangingDelaunayOfC, IsChangedByOneThreadWhileOthersAsk) {
  Owned<tetloft_delaunay> c;
  const std::vector<Point3> of = points(30);
  ASSERT_OK(tetloft_delaunay_create(coordinates(of), of.size(), nullptr, c.out()));
  change_while_others_ask(
      [&] {
        Number nearest = 0;
        EXPECT_OK(tetloft_delaunay_nearest(c, coordinates(of), 1, nullptr, &nearest));
        EXPECT_NE(nearest, Number{TETLOFT_NO_VERTEX});
      },
      [&](int i) {
        Number made = 0;
        EXPECT_OK(tetloft_delaunay_insert(c, i, 9, 0.5, TETLOFT_NO_VERTEX, &made, nullptr));
        if (i % 2 == 0) {
          EXPECT_OK(tetloft_delaunay_remove(c, made));
        }
      });
}

}  // namespace
}  // namespace tetloft::c_test

// What tests of triangulations that change share, in the plane and in space.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

#include <tetloft/delaunay_vertex.hpp>
#include <tetloft/result.hpp>

#include "core/prng.hpp"
#include "support/value_of.hpp"

namespace tetloft::test {

using internal::Prng;

inline void succeed(const Result<void>& result) {
  if (!result) throw std::runtime_error(to_string(result.error()));
}

/// A source of points, many of them degenerate or repeated.
template <class Point>
struct SourceOf {
  std::string name;
  std::function<Point(Prng&)> draw;
};

/// The live vertices by index.
template <class Triangulation>
[[nodiscard]] std::vector<DelaunayVertex> live_vertices(const Triangulation& t) {
  std::vector<DelaunayVertex> result;
  for (std::size_t i = 0; i < t.vertex_slots(); ++i) {
    if (t.vertex_at(i).valid()) result.push_back(t.vertex_at(i));
  }
  return result;
}

/// One random operation.
template <class Triangulation, class Point>
void change(Triangulation& t, const SourceOf<Point>& source, Prng& prng) {
  const std::vector<DelaunayVertex> live = live_vertices(t);
  const std::uint64_t draw = prng.below(10);
  if (live.empty() || draw < 5) {
    const Point p = source.draw(prng);
    const bool was_there =
        std::any_of(live.begin(), live.end(), [&](DelaunayVertex v) { return t.point(v) == p; });
    const auto made =
        value_of(t.insert(p, live.empty() || prng.chance(0.5) ? DelaunayVertex() : live.front()));
    EXPECT_EQ(made.is_new, !was_there);
    EXPECT_EQ(t.point(made.vertex), p);
    return;
  }
  const DelaunayVertex v = live[prng.below(live.size())];
  if (draw < 9) {
    succeed(t.remove(v));
    EXPECT_FALSE(t.is_live(v));
    return;
  }
  const Point to = source.draw(prng);
  const bool taken = std::any_of(live.begin(), live.end(),
                                 [&](DelaunayVertex u) { return u != v && t.point(u) == to; });
  EXPECT_EQ(t.move(v, to).ok(), !taken);
  EXPECT_TRUE(t.is_live(v));
  if (!taken) {
    EXPECT_EQ(t.point(v), to);
  }
}

/// Many points come at once, twice, and go one by one; `equals_batch(t)` is asked in between.
template <class Triangulation, class Point, class EqualsBatch>
void come_and_go(const SourceOf<Point>& source, const EqualsBatch& equals_batch) {
  SCOPED_TRACE(source.name);
  Prng prng(77);
  std::vector<Point> points;
  for (int i = 0; i < 400; ++i) points.push_back(source.draw(prng));
  Triangulation t = value_of(Triangulation::of(points));
  ASSERT_TRUE(equals_batch(t));
  std::vector<Point> more;
  for (int i = 0; i < 200; ++i) more.push_back(source.draw(prng));
  const std::vector<DelaunayVertex> handles = value_of(t.insert(more));
  for (std::size_t i = 0; i < more.size(); ++i) EXPECT_EQ(t.point(handles[i]), more[i]);
  ASSERT_TRUE(equals_batch(t));
  std::vector<DelaunayVertex> live = live_vertices(t);
  prng.shuffle(live);
  for (std::size_t i = 0; i < live.size(); ++i) {
    succeed(t.remove(live[i]));
    if (i % 16 == 0) {
      ASSERT_TRUE(equals_batch(t)) << i;
    }
  }
  EXPECT_EQ(t.vertex_count(), 0U);
  EXPECT_EQ(t.dimension(), -1);
}

/// Many questions at once have the answers of each alone on any number of threads, and a point that
/// is not finite refuses all; `simplex_of(location)` is the triangle or tet.
template <class Triangulation, class Point, class SimplexOf>
void expect_answers_of_each(const Triangulation& t, std::vector<Point> queries,
                            const SimplexOf& simplex_of) {
  const auto by_one_thread = value_of(t.locate(queries, {.threads = 1}));
  for (const unsigned threads : {1U, 2U, 5U}) {
    const auto nearest = value_of(t.nearest_vertex(queries, {.threads = threads}));
    const auto located = value_of(t.locate(queries, {.threads = threads}));
    ASSERT_EQ(nearest.size(), queries.size());
    ASSERT_EQ(located.size(), queries.size());
    for (std::size_t i = 0; i < queries.size(); ++i) {
      EXPECT_EQ(nearest[i], value_of(t.nearest_vertex(queries[i])));
      const auto one = value_of(t.locate(queries[i]));
      EXPECT_EQ(located[i].kind, one.kind);
      EXPECT_EQ(located[i].vertices, one.vertices);
      EXPECT_EQ(simplex_of(located[i]), simplex_of(by_one_thread[i]));
    }
  }
  EXPECT_TRUE(value_of(t.locate(std::span<const Point>())).empty());
  queries[7].y = std::numeric_limits<double>::infinity();
  const auto refused = t.nearest_vertex(queries);
  ASSERT_FALSE(refused.ok());
  EXPECT_EQ(refused.error().code, ErrorCode::invalid_input);
  EXPECT_EQ(refused.error().where.vertex, 7U);
}

/// A vertex by distance, which points with few bits have exactly, then by index.
struct Ranked {
  double squared;
  std::uint32_t index;
  auto operator<=>(const Ranked&) const = default;
};

/// The vertices near p are those of all, ranked by `squared(a, b)`: some nearest ones and those
/// within a random radius.
template <class Triangulation, class Point, class Squared>
void expect_nearest_of_all(const Triangulation& t, const Point& p, const Squared& squared,
                           Prng& prng) {
  std::vector<Ranked> all;
  for (const DelaunayVertex v : live_vertices(t)) all.push_back({squared(t.point(v), p), v.index});
  std::sort(all.begin(), all.end());
  const DelaunayVertex nearest = value_of(t.nearest_vertex(p));
  ASSERT_EQ(nearest.valid(), !all.empty());
  if (all.empty()) return;
  EXPECT_EQ(nearest.index, all.front().index);
  const std::size_t k = 1 + prng.below(20);
  const auto some = value_of(t.nearest_vertices(p, k, nearest));
  ASSERT_EQ(some.size(), std::min(k, all.size()));
  for (std::size_t i = 0; i < some.size(); ++i) EXPECT_EQ(some[i].index, all[i].index) << i;
  const double radius = static_cast<double>(prng.below(40)) / 8;
  const auto within = value_of(t.vertices_within(p, radius));
  const auto expected = static_cast<std::size_t>(std::count_if(
      all.begin(), all.end(), [&](const Ranked& r) { return r.squared <= radius * radius; }));
  ASSERT_EQ(within.size(), expected);
  for (std::size_t i = 0; i < within.size(); ++i) EXPECT_EQ(within[i].index, all[i].index);
}

}  // namespace tetloft::test

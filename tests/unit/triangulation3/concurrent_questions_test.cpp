// Questions of several threads at once. Run with the thread sanitizer too.
#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <thread>
#include <vector>

#include "support.hpp"

namespace tetloft::test {
namespace {

struct Answers {
  Location3 location;
  std::vector<DelaunayVertex> nearest;
  std::vector<TetId> zone;
  std::vector<DelaunayVertex> neighbours;
  friend bool operator==(const Answers& a, const Answers& b) {
    return a.location.kind == b.location.kind && a.location.vertices == b.location.vertices &&
           a.nearest == b.nearest && a.zone == b.zone && a.neighbours == b.neighbours;
  }
};

Answers ask(const DelaunayTriangulation3& t, const Point3& p) {
  Answers answers;
  answers.location = value_of(t.locate(p));
  answers.nearest = value_of(t.nearest_vertices(p, 5));
  answers.zone = value_of(t.conflict_zone(p)).tets;
  if (!answers.nearest.empty()) answers.neighbours = t.neighbours(answers.nearest.front());
  return answers;
}

TEST(ConcurrentQuestions, AreAnsweredAsEachAlone) {
  for (const PointSource& source : point_sources()) {
    SCOPED_TRACE(source.name);
    Prng prng(5);
    std::vector<Point3> points;
    for (int i = 0; i < 100; ++i) points.push_back(source.draw(prng));
    DelaunayTriangulation3 t = value_of(DelaunayTriangulation3::of(points));
    // Some places free, and a start grid with vertices that are gone.
    std::vector<DelaunayVertex> live = live_vertices(t);
    for (std::size_t i = 0; i < live.size(); i += 3) succeed(t.remove(live[i]));
    std::vector<Point3> queries;
    for (int i = 0; i < 40; ++i) queries.push_back(source.draw(prng));
    std::vector<Answers> alone;
    for (const Point3& q : queries) alone.push_back(ask(t, q));

    std::atomic<int> differ{0};
    std::vector<std::thread> threads;
    for (std::size_t n = 0; n < 4; ++n) {
      threads.emplace_back([&, n] {
        for (std::size_t k = 0; k < queries.size(); ++k) {
          const std::size_t i = (k + 11 * n) % queries.size();
          if (!(ask(t, queries[i]) == alone[i])) ++differ;
        }
      });
    }
    for (std::thread& thread : threads) thread.join();
    EXPECT_EQ(differ, 0);
  }
}

}  // namespace
}  // namespace tetloft::test

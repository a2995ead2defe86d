// A triangulation that changes, in the plane or in space, and what is known of it: who lives where,
// and who is gone. Answers are those of asking all; distances are compared by the library's
// predicate, which has tests of its own.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include <tetloft/delaunay_vertex.hpp>
#include <tetloft/point.hpp>
#include <tetloft/predicates.hpp>
#include <tetloft/result.hpp>

#include "fuzz/target.hpp"
#include "predicates/distances.hpp"

namespace tetloft::fuzz {

constexpr std::size_t kMostOperations = 48;

/// What is not refused, as points are finite.
template <class Value>
Value fine_value(Result<Value> result) {
  if (!result) {
    require_clean(result.error());
    require(false, "finite points are refused: " + to_string(result.error()));
  }
  return *std::move(result);
}

/// Lattices or doubles of any size, times a power of two.
class ScaledCoordinates {
 public:
  explicit ScaledCoordinates(Bytes& bytes)
      : exponent_(kExponents[bytes.below(4)]), coordinates_(bytes) {}
  double next() {
    const double x = std::ldexp(coordinates_.next(), exponent_);
    return x - x == 0 ? x : 1;
  }

 private:
  static constexpr std::array<int, 4> kExponents{0, 0, -400, 300};
  int exponent_;
  Coordinates coordinates_;
};

inline Point3 in_space(const Point2& p) { return {p.x, p.y, 0}; }
inline Point3 in_space(const Point3& p) { return p; }

/// Of points that `Points` makes of bytes.
template <class Triangulation, class Points>
class History {
 protected:
  using Point = decltype(std::declval<Points&>().next());
  struct Vertex {
    DelaunayVertex handle;
    Point point;
  };

  explicit History(Bytes& bytes) : bytes_(bytes), points_(bytes) {}

  const Vertex* at(const Point& p) const {
    for (const Vertex& v : live_) {
      if (v.point == p) return &v;
    }
    return nullptr;
  }
  /// Of a live vertex, of one that is gone, or of none.
  DelaunayVertex any_handle() {
    const std::size_t k = bytes_.byte();
    if (k < 32 || (live_.empty() && gone_.empty())) return {};
    if (!gone_.empty() && (k < 64 || live_.empty())) return gone_[k % gone_.size()];
    return live_[k % live_.size()].handle;
  }
  typename std::vector<Vertex>::iterator find(DelaunayVertex v) {
    return std::find_if(live_.begin(), live_.end(),
                        [&](const Vertex& known) { return known.handle == v; });
  }
  void learn(DelaunayVertex v, const Point& p) {
    if (const Vertex* known = at(p)) {
      require(v == known->handle, "a point has another vertex");
    } else {
      require(find(v) == live_.end(), "a handle twice");
      live_.push_back({v, p});
    }
  }

  void insert() {
    const Point p = points_.next();
    const bool is_new = at(p) == nullptr;
    const auto made = fine_value(made_.insert(p, any_handle()));
    require(made.is_new == is_new, "a point is new, or is not");
    learn(made.vertex, p);
  }
  void insert_many() {
    std::vector<Point> points(bytes_.below(8));
    for (Point& p : points) p = points_.next();
    const auto made = fine_value(made_.insert(points, {.threads = 1}));
    for (std::size_t i = 0; i < points.size(); ++i) learn(made[i], points[i]);
  }
  /// What is held stays.
  template <class IsHeld>
  void remove(const IsHeld& is_held) {
    const DelaunayVertex v = any_handle();
    const auto known = find(v);
    const Result<void> removed = made_.remove(v);
    require(removed.ok() == (known != live_.end() && !is_held(v)),
            "a vertex is removed, or is not");
    if (!removed) {
      require_clean(removed.error());
    } else {
      gone_.push_back(v);
      live_.erase(known);
    }
  }
  template <class IsHeld>
  void move(const IsHeld& is_held) {
    const DelaunayVertex v = any_handle();
    const Point to = points_.next();
    const auto known = find(v);
    const Vertex* there = at(to);
    const bool can = known != live_.end() && (there == nullptr ? !is_held(v) : there->handle == v);
    const Result<void> moved = made_.move(v, to);
    require(moved.ok() == can, "a vertex moves, or does not");
    if (can) known->point = to;
    if (!moved) require_clean(moved.error());
  }
  /// Each lives where it is known to, and nobody else does.
  void compare_vertices(const Triangulation& t) const {
    require(t.vertex_count() == live_.size(), "count of vertices");
    for (const Vertex& v : live_) {
      require(t.is_live(v.handle) && t.point(v.handle) == v.point, "a vertex is elsewhere");
    }
    for (const DelaunayVertex v : gone_) require(!t.is_live(v), "a vertex that is gone lives");
  }

  std::vector<DelaunayVertex> by_distance(const Point& p) const {
    std::vector<Vertex> all = live_;
    std::sort(all.begin(), all.end(), [&](const Vertex& a, const Vertex& b) {
      const Sign s = internal::predicates::compare_distances(in_space(p), in_space(a.point),
                                                             in_space(b.point));
      return s == Sign::negative || (s == Sign::zero && a.handle.index < b.handle.index);
    });
    std::vector<DelaunayVertex> result;
    for (const Vertex& v : all) result.push_back(v.handle);
    return result;
  }
  void ask_nearest() {
    const Point p = points_.next();
    std::vector<DelaunayVertex> expected = by_distance(p);
    const DelaunayVertex nearest = fine_value(made_.nearest_vertex(p, any_handle()));
    require(nearest == (expected.empty() ? DelaunayVertex() : expected.front()),
            "another vertex is nearest");
    const std::size_t k = bytes_.below(8);
    expected.resize(std::min(k, expected.size()));
    require(fine_value(made_.nearest_vertices(p, k, any_handle())) == expected,
            "other vertices are nearest");
  }
  void ask_within() {
    const Point p = points_.next();
    const double radius = std::abs(points_.next().x);
    std::vector<DelaunayVertex> expected = by_distance(p);
    std::erase_if(expected, [&](DelaunayVertex v) {
      return internal::predicates::compare_distance(in_space(p), in_space(made_.point(v)),
                                                    radius) == Sign::positive;
    });
    require(fine_value(made_.vertices_within(p, radius, any_handle())) == expected,
            "other vertices are within");
  }

  Bytes& bytes_;
  Points points_;
  Triangulation made_;
  std::vector<Vertex> live_;
  std::vector<DelaunayVertex> gone_;
};

}  // namespace tetloft::fuzz

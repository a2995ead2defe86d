// The arrangement of edges of contours that may cross and touch: nodes, and pieces of edges that
// meet at nodes only. Crossings are rounded once and stored; from then on they are input.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <map>
#include <utility>
#include <vector>

#include <tetloft/ids.hpp>
#include <tetloft/point.hpp>
#include <tetloft/repair.hpp>

namespace tetloft::internal::sections {

using NodeId = Id<struct ArrangementNodeTag>;

/// An edge of a contour, or a piece of one.
struct ArrangementPiece {
  NodeId a;
  NodeId b;
  ContourId contour;
  int times = 1;  ///< that the contour goes from a to b, less those from b to a
};

/// What happened on the way to the arrangement.
struct ArrangementEvent {
  enum class Kind : unsigned char { merged, crossing, cancelled, shared };
  Kind kind;
  ContourId contour;
  Point2 at;
};

[[nodiscard]] inline bool boxes_meet(const Point2& a, const Point2& b, const Point2& c,
                                     const Point2& d) {
  return std::max(a.x, b.x) >= std::min(c.x, d.x) && std::max(c.x, d.x) >= std::min(a.x, b.x) &&
         std::max(a.y, b.y) >= std::min(c.y, d.y) && std::max(c.y, d.y) >= std::min(a.y, b.y);
}

/// Calls pair(i, j), i < j, for edges whose boxes meet; `edge` gives ends.
template <class Edge, class Pair>
void for_each_near_pair(std::size_t n, const Edge& edge, const Pair& pair) {
  std::vector<std::size_t> order(n);
  for (std::size_t i = 0; i < n; ++i) order[i] = i;
  const auto low = [&](std::size_t i) { return std::min(edge(i)[0].x, edge(i)[1].x); };
  std::sort(order.begin(), order.end(), [&](std::size_t i, std::size_t j) {
    return low(i) != low(j) ? low(i) < low(j) : i < j;
  });
  std::vector<std::size_t> active;
  for (const std::size_t i : order) {
    const std::array<Point2, 2> e = edge(i);
    std::erase_if(active,
                  [&](std::size_t j) { return std::max(edge(j)[0].x, edge(j)[1].x) < low(i); });
    for (const std::size_t j : active) {
      const std::array<Point2, 2> f = edge(j);
      if (boxes_meet(e[0], e[1], f[0], f[1])) pair(std::min(i, j), std::max(i, j));
    }
    active.push_back(i);
  }
}

class Arrangement {
 public:
  /// What lies nearer than `radius` is taken to meet, so that three edges through nearly one
  /// point, say, do not leave a triangle a few ulps wide. settle() may move points of edges by
  /// `most`.
  Arrangement(double radius, double most, FillRule rule)
      : radius_(radius), most_(most), rule_(rule) {}

  void add_edge(const Point2& a, const Point2& b, ContourId contour);

  /// Makes one of vertices that are near each other, then splits pieces where they meet, round by
  /// round, until they meet at ends only, and removes pieces that have the same on both sides by
  /// the rule: which points it takes stays. Gives up where that does not end, makes many more
  /// pieces than there were edges, or moves a point too far.
  enum class Outcome { settled, endless, moved_too_far };
  [[nodiscard]] Outcome settle();

  [[nodiscard]] std::size_t node_count() const { return nodes_.size(); }
  [[nodiscard]] const Point2& at(NodeId n) const { return nodes_[n]; }
  /// From the lower end to the higher one, by ends, then by contour: each contour once at most.
  [[nodiscard]] const std::vector<ArrangementPiece>& pieces() const { return pieces_; }
  /// Those from i on with the ends of i: where they stop.
  [[nodiscard]] std::size_t end_of_equal(std::size_t i) const;
  /// An upper bound of how far settle() moved a point of an edge.
  [[nodiscard]] double moved() const { return moved_; }
  [[nodiscard]] const std::vector<ArrangementEvent>& events() const { return events_; }

 private:
  NodeId node(const Point2& p);
  NodeId node_near(const Point2& p);
  [[nodiscard]] bool lies_on(const Point2& p, const Point2& a, const Point2& b) const;
  void merge_near_nodes();
  [[nodiscard]] IdVector<NodeId, NodeId> nearest_kept_nodes() const;
  [[nodiscard]] bool takes_nothing(std::size_t first, std::size_t last) const;
  void cancel();
  void tell_shared();
  bool split_once();
  void apply(std::vector<std::vector<NodeId>>& splits);

  double radius_;
  double most_;
  FillRule rule_;
  double moved_ = 0;
  IdVector<NodeId, Point2> nodes_;
  std::map<std::pair<double, double>, NodeId> node_of_;
  std::vector<ArrangementPiece> pieces_;
  std::vector<ArrangementEvent> events_;
};

}  // namespace tetloft::internal::sections

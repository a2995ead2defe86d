// The vertices of a triangulation by their distance from a point, compared exactly.
//
// A vertex without a strictly nearer neighbour is nearest of all: its Voronoi cell is bounded by
// the bisectors with its neighbours. So whoever steps from neighbour to neighbour as long as one is
// nearer comes to a nearest vertex, and in order of distance every vertex but the nearest ones has
// a neighbour that came before. The nearest ones, if they are several, lie on a sphere with nothing
// inside; their hull is a union of simplices of every Delaunay triangulation, so edges join them.
#pragma once

#include <cstddef>
#include <vector>

#include <tetloft/ids.hpp>
#include <tetloft/point.hpp>

#include "triangulation3/live_tets.hpp"
#include "triangulation3/stars.hpp"

namespace tetloft::internal::triangulation3 {

class Nearest {
 public:
  /// Of a triangulation with points; the search starts at `near` if it is live.
  Nearest(const LiveTets& tets, const Point3& p, VertexId near);

  /// The nearest vertex, of several that of lowest id.
  [[nodiscard]] VertexId first() const { return candidates_.front().vertex; }
  /// The next one by distance, then by id; the nearest at first, invalid in the end.
  [[nodiscard]] VertexId next();

 private:
  struct Candidate {
    VertexId vertex;
    double squared = 0;  // distance, rounded
  };
  [[nodiscard]] Candidate candidate(VertexId v) const;
  [[nodiscard]] Sign compare(const Candidate& a, const Candidate& b) const;
  [[nodiscard]] bool comes_later(const Candidate& a, const Candidate& b) const;
  [[nodiscard]] Candidate nearer_corner(VertexId near) const;
  [[nodiscard]] bool step(Candidate& at, bool& tied);
  void collect_nearest(const Candidate& nearest);
  void add(const Candidate& c);

  const LiveTets& tets_;
  Point3 p_;
  std::vector<Candidate> candidates_;  // a heap, the first one nearest
  IdSet<VertexId> seen_;
  IdSet<TetId> around_;  // scratch
};

}  // namespace tetloft::internal::triangulation3

// The vertices of a triangulation by their distance from a point.
#pragma once

#include <vector>

#include <tetloft/ids.hpp>
#include <tetloft/point.hpp>

#include "predicates/by_distance.hpp"
#include "triangulation3/live_tets.hpp"
#include "triangulation3/stars.hpp"

namespace tetloft::internal::triangulation3 {

/// The points of a triangulation and its edges.
class EdgesOfTets {
 public:
  explicit EdgesOfTets(const LiveTets& tets) : tets_(&tets) {}
  [[nodiscard]] const Point3& point(VertexId v) const { return tets_->point(v); }
  template <class Visit>
  void for_each_neighbour(VertexId v, const Visit& visit) {
    for_each_around(*tets_, v, around_,
                    [&](TetId /*t*/, VertexId u) { return !LiveTets::is_point(u) || visit(u); });
  }

 private:
  const LiveTets* tets_;
  IdSet<TetId> around_;  // scratch
};

/// Points near p: of the tet that p lies in, or of the hull facet beyond which it lies.
[[nodiscard]] std::vector<VertexId> points_near(const LiveTets& tets, const Point3& p,
                                                VertexId near);

class Nearest : public predicates::ByDistance<EdgesOfTets> {
 public:
  /// Of a triangulation with points; the search starts at `near` if it is live.
  Nearest(const LiveTets& tets, const Point3& p, VertexId near)
      : ByDistance(EdgesOfTets(tets), p, points_near(tets, p, near)) {}
};

}  // namespace tetloft::internal::triangulation3

// Conforming triangulation: rounds of splits until every segment is a chain of edges.
//
// A round looks at all subsegments that may have changed, splits those that are missing (or
// not Gabriel, where asked for), each at the point that its own ends and corner determine
// (shells.hpp), and inserts the new points together. Which points a round inserts depends on
// the set of points and of segments only, since the triangulation is unique: so does the
// result, whatever the order of points, segments, or ends in the input.
//
// It ends: a missing subsegment has a vertex in or on its diametral circle, and splitting
// encroached subsegments at midpoints, and on shells at acute corners, stops at the scale of
// the features (Ruppert 1995, Shewchuk 2002). Where that scale is below what doubles resolve,
// a subsegment runs out of room, which is an Error; so does the bound on inserted points
// catch requests that end, but later than anyone would wait.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include <tetloft/delaunay2.hpp>
#include <tetloft/point.hpp>
#include <tetloft/result.hpp>

#include "core/watched_work.hpp"
#include "delaunay2/start.hpp"

namespace tetloft::internal::delaunay2_detail {

/// The vertices of every segment from its first to its second end, segment after segment.
class Chains {
 public:
  /// Ends the chain of a segment, of all vertices added since the last one.
  void end_chain() { end_.push_back(static_cast<std::uint32_t>(vertices_.size())); }
  void add(PlaneVertexId v) { vertices_.push_back(v); }
  void reserve(std::size_t chains, std::size_t vertices) {
    end_.reserve(chains);
    vertices_.reserve(vertices);
  }

  [[nodiscard]] std::size_t size() const { return end_.size(); }
  [[nodiscard]] std::span<const PlaneVertexId> operator[](std::size_t segment) const {
    const std::uint32_t begin = segment == 0 ? 0 : end_[segment - 1];
    return std::span(vertices_).subspan(begin, end_[segment] - begin);
  }
  /// All vertices, to be renamed.
  [[nodiscard]] std::vector<PlaneVertexId>& vertices() { return vertices_; }

 private:
  std::vector<std::uint32_t> end_;  // by segment, in vertices_
  std::vector<PlaneVertexId> vertices_;
};

/// A conforming triangulation before anything is numbered canonically.
struct ConformedPlane {
  Start start;                 ///< numbers sites by `points`; without a plane if all are collinear
  std::vector<Point2> points;  ///< the input, then what was inserted
  Chains chains;
};

/// conforming_delaunay2() for arguments that have been checked: `start` has a plane, points
/// are finite and distinct, segments distinct, with valid and different ends, flags none or
/// one for each. `most_inserted` bounds the number of inserted points. Tells no
/// step.
[[nodiscard]] Result<ConformedPlane> conform(Start start, std::span<const Point2> points,
                                             std::span<const Segment> segments,
                                             const std::vector<bool>& gabriel,
                                             std::size_t most_inserted, WatchedWork& work);

/// conforming_delaunay2() up to there, of segments known to be distinct, with valid and different
/// ends. Throws what its steps throw.
[[nodiscard]] Result<ConformedPlane> conformed_plane(std::span<const Point2> points,
                                                     std::span<const Segment> segments,
                                                     const ConformingOptions& options);

}  // namespace tetloft::internal::delaunay2_detail

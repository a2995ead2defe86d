#include "delaunay2/conforming.hpp"

#include <algorithm>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "core/check.hpp"
#include "delaunay2/canonical.hpp"
#include "delaunay2/corners.hpp"
#include "delaunay2/diametral.hpp"
#include "delaunay2/incremental.hpp"
#include "delaunay2/shells.hpp"
#include "delaunay2/start.hpp"

namespace tetloft::delaunay2_detail {

namespace {

using SubsegmentId = LabelId;  // subsegments are what edges are labelled with
using RayId = Id<struct RayTag>;

enum class Rule : std::uint8_t {
  midpoint,      // no acute end
  first_middle,  // two acute ends: the midpoint, from where each half has one
  shells,        // one acute end
};

struct Subsegment {
  VertexId from;  // vertices of the plane, in the direction of the segment
  VertexId to;
  SubsegmentId next;  // along the segment; invalid at its end
  std::uint32_t segment;
  Rule rule;
  RayId ray;  // with shells: where radii are measured
  double from_radius;
  double to_radius;
};

struct Split {
  Point2 point;
  SubsegmentId subsegment;
  double radius;  // with shells
};

class Conformer {
 public:
  Conformer(Start start, std::span<const Point2> points, std::span<const Segment> segments,
            const std::vector<bool>& gabriel, std::size_t most_inserted)
      : input_(points),
        segments_(segments),
        gabriel_(gabriel),
        most_inserted_(most_inserted),
        start_(std::move(start)),
        plane_(start_.plane.value()) {}

  Result<Conforming2> run() {
    add_segments();
    while (!queue_.empty()) {
      std::vector<Split> round = splits_of_round();
      if (Result<void> possible = verify(round); !possible) return possible.error();
      for (const Split& split : round) {
        const VertexId at = subsegments_[split.subsegment].from;
        const VertexId v = plane_.insert(split.point, at);
        // Only subsegments closer than doubles resolve can meet in a point.
        if (v.index() != start_.input_of.size()) return no_room(split, "meets another vertex");
        start_.input_of.emplace_back(input_.size() + inserted_.size());
        inserted_.push_back(split.subsegment);
        divide(split, v);
      }
      for (const SubsegmentId s : plane_.take_touched()) enqueue(s);
    }
    return result();
  }

 private:
  /// The subsegments of the start: segment s is subsegment s.
  void add_segments() {
    const auto acute = acute_ends(input_, segments_);
    subsegments_.reserve(2 * segments_.size());
    for (std::size_t s = 0; s < segments_.size(); ++s) {
      Subsegment sub{};
      sub.from = start_.vertex_of[segments_[s][0].index()];
      sub.to = start_.vertex_of[segments_[s][1].index()];
      sub.segment = static_cast<std::uint32_t>(s);
      sub.rule = acute[s][0] && acute[s][1] ? Rule::first_middle : Rule::midpoint;
      const SubsegmentId id = subsegments_.push_back(sub);
      if (acute[s][0] != acute[s][1]) measure_from(id, acute[s][0] ? sub.from : sub.to);
      enqueue(id);
    }
  }

  /// From now on the subsegment is split on shells around its end `corner`.
  void measure_from(SubsegmentId id, VertexId corner) {
    Subsegment& sub = subsegments_[id];
    const VertexId far = corner == sub.from ? sub.to : sub.from;
    sub.rule = Rule::shells;
    sub.ray = rays_.push_back(Ray(plane_.point(corner), plane_.point(far)));
    sub.from_radius = corner == sub.from ? 0 : rays_[sub.ray].length();
    sub.to_radius = corner == sub.to ? 0 : rays_[sub.ray].length();
  }

  void enqueue(SubsegmentId s) {
    if (is_queued_.size() < subsegments_.size()) is_queued_.resize(subsegments_.size(), 0);
    if (is_queued_[s] != 0) return;
    is_queued_[s] = 1;
    queue_.push_back(s);
  }

  /// Empties the queue; labels what is an edge, returns splits of what must be split, in
  /// canonical order.
  std::vector<Split> splits_of_round() {
    std::vector<Split> splits;
    for (const SubsegmentId s : queue_) {
      is_queued_[s] = 0;
      const Subsegment& sub = subsegments_[s];
      const HalfEdgeId edge = plane_.find_edge(sub.from, sub.to);
      if (edge.valid()) plane_.set_label(edge, s);
      if (!edge.valid() || (is_to_be_gabriel(sub) && !is_gabriel(edge))) {
        splits.push_back(split_of(s));
      }
    }
    queue_.clear();
    std::sort(splits.begin(), splits.end(),
              [](const Split& a, const Split& b) { return canonical_less(a.point, b.point); });
    return splits;
  }

  [[nodiscard]] bool is_to_be_gabriel(const Subsegment& sub) const {
    return !gabriel_.empty() && gabriel_[sub.segment];
  }

  /// The part of the diametral circle on either side of a Delaunay edge holds a vertex only
  /// if it holds the apex there.
  [[nodiscard]] bool is_gabriel(HalfEdgeId edge) const {
    const Point2& a = plane_.point(plane_.origin(edge));
    const Point2& b = plane_.point(plane_.destination(edge));
    for (const HalfEdgeId side : {edge, plane_.opposite(edge)}) {
      const VertexId v = plane_.apex(side);
      if (v != Incremental2::kGhost && in_diametral_circle(a, b, plane_.point(v))) return false;
    }
    return true;
  }

  [[nodiscard]] Split split_of(SubsegmentId s) const {
    const Subsegment& sub = subsegments_[s];
    if (sub.rule != Rule::shells) {
      return {midpoint(plane_.point(sub.from), plane_.point(sub.to)), s, 0};
    }
    const double radius = roundest_between(sub.from_radius, sub.to_radius);
    return {rays_[sub.ray].at(radius), s, radius};
  }

  /// Is there room for all splits? Names the first, in canonical order, for which there is not.
  [[nodiscard]] Result<void> verify(const std::vector<Split>& round) const {
    for (std::size_t i = 0; i < round.size(); ++i) {
      const Subsegment& sub = subsegments_[round[i].subsegment];
      if (!lies_between(plane_.point(sub.from), round[i].point, plane_.point(sub.to))) {
        return no_room(round[i], "has no room between its neighbours");
      }
      if (i > 0 && round[i - 1].point == round[i].point) {
        return no_room(round[i], "lies on two segments");
      }
    }
    if (inserted_.size() + round.size() > most_inserted_) {
      Error error = no_room(round.front(), "exceeds the bound on inserted points");
      error.code = ErrorCode::work_limit;
      return error;
    }
    return {};
  }

  [[nodiscard]] Error no_room(const Split& split, const char* reason) const {
    const std::uint32_t segment = subsegments_[split.subsegment].segment;
    Error error{ErrorCode::unrepresentable,
                "the point that would split segment " + std::to_string(segment) + " " + reason,
                {}};
    error.where.vertex = segments_[segment][0].index();
    error.where.point = Point3{split.point.x, split.point.y, 0};
    return error;
  }

  /// Divides a subsegment at the new vertex v: the first part keeps its id.
  void divide(const Split& split, VertexId v) {
    Subsegment first = subsegments_[split.subsegment];
    Subsegment second = first;
    first.to = second.from = v;
    first.to_radius = second.from_radius = split.radius;
    const SubsegmentId id = subsegments_.push_back(second);
    first.next = id;
    subsegments_[split.subsegment] = first;
    if (first.rule == Rule::first_middle) {
      measure_from(split.subsegment, first.from);
      measure_from(id, second.to);
    }
    enqueue(split.subsegment);
    enqueue(id);
  }

  Conforming2 result() {
    Conforming2 result;
    result.split.resize(inserted_.size());
    result.chains.resize(segments_.size());
    for (std::size_t s = 0; s < segments_.size(); ++s) {
      std::vector<VertexId>& chain = result.chains[s];
      chain.push_back(segments_[s][0]);
      for (SubsegmentId sub(s); sub.valid(); sub = subsegments_[sub].next) {
        chain.push_back(start_.input_of[subsegments_[sub].to.index()]);
      }
      for (std::size_t i = 1; i + 1 < chain.size(); ++i) {
        result.split[chain[i].index() - input_.size()] = {s, i - 1};
      }
    }
    std::vector<Point2> points(input_.begin(), input_.end());
    points.resize(input_.size() + inserted_.size());
    for (std::size_t v = 1; v < start_.input_of.size(); ++v) {
      points[start_.input_of[v].index()] = plane_.point(VertexId(v));
    }
    result.triangulation = canonical_triangulation(plane_, start_.input_of, std::move(points));
    return result;
  }

  std::span<const Point2> input_;
  std::span<const Segment> segments_;
  const std::vector<bool>& gabriel_;
  std::size_t most_inserted_;
  Start start_;
  Incremental2& plane_;

  IdVector<SubsegmentId, Subsegment> subsegments_;
  IdVector<RayId, Ray> rays_;
  std::vector<SubsegmentId> inserted_;  // by inserted point: what it split
  std::vector<SubsegmentId> queue_;     // to be looked at in the next round
  IdVector<SubsegmentId, std::uint8_t> is_queued_;
};

}  // namespace

Result<Conforming2> conform(Start start, std::span<const Point2> points,
                            std::span<const Segment> segments, const std::vector<bool>& gabriel,
                            std::size_t most_inserted) {
  return Conformer(std::move(start), points, segments, gabriel, most_inserted).run();
}

}  // namespace tetloft::delaunay2_detail

#include "delaunay2/conforming.hpp"

#include <algorithm>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "core/guard.hpp"
#include "delaunay2/corners.hpp"
#include "delaunay2/diametral.hpp"
#include "delaunay2/feet.hpp"
#include "delaunay2/incremental.hpp"
#include "delaunay2/shells.hpp"
#include "delaunay2/sight.hpp"
#include "delaunay2/start.hpp"

namespace tetloft::internal::delaunay2_detail {

namespace {

using SubsegmentId = LabelId;  // subsegments are what edges are labelled with
using RayId = Id<struct RayTag>;

enum class Rule : std::uint8_t {
  midpoint,      // no acute end
  first_middle,  // two acute ends: the midpoint, from where each half has one
  shells,        // one acute end
};

struct Subsegment {
  SiteId from;  // vertices of the plane, in the direction of the segment
  SiteId to;
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

/// How split points are chosen.
enum class Scheme : std::uint8_t {
  shells,  // from the ends of a piece alone
  feet,    // from what the piece meets
};

/// Crossings of missing pieces and edges that are looked at for each point that may be inserted:
/// ten times what dense stacks of thin triangles take.
constexpr std::size_t kMostCrossings = 32;

/// Pieces of a segment after which shells are given up where no segment must be Gabriel (feet of
/// feet hardly help these: they need length / distance). One real section with a spike of 3e-6 has
/// a segment of 132 pieces, all others are below 100.
constexpr std::size_t kMostPieces = 160;

class Conformer {
 public:
  Conformer(Start start, std::span<const Point2> points, std::span<const Segment> segments,
            const std::vector<bool>& gabriel, std::size_t most_inserted, Scheme scheme,
            const WatchedWork& work)
      : input_(points),
        segments_(segments),
        gabriel_(gabriel),
        most_inserted_(most_inserted),
        scheme_(scheme),
        work_(work),
        pieces_(segments.size(), 1),
        start_(std::move(start)),
        plane_(start_.plane.value()) {
    if (scheme_ == Scheme::feet) list_neighbours();
  }

  Result<ConformedPlane> run() {
    add_segments();
    while (!queue_.empty()) {
      work_.go_on();
      std::vector<Split> round = splits_of_round();
      if (Result<void> possible = verify(round); !possible) return possible.error();
      for (const Split& split : round) {
        const SiteId at = subsegments_[split.subsegment].from;
        const SiteId v = plane_.insert(split.point, at);
        // Only subsegments closer than doubles resolve can meet in a point.
        if (v.index() != start_.input_of.size()) return no_room(split, "meets another vertex");
        start_.input_of.push_back(PlaneVertexId(input_.size() + inserted_.size()));
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
      sub.from = start_.site_of[segments_[s][0]];
      sub.to = start_.site_of[segments_[s][1]];
      sub.segment = static_cast<std::uint32_t>(s);
      sub.rule = acute[s][0] && acute[s][1] ? Rule::first_middle : Rule::midpoint;
      const SubsegmentId id = subsegments_.push_back(sub);
      if (acute[s][0] != acute[s][1]) measure_from(id, acute[s][0] ? sub.from : sub.to);
      enqueue(id);
    }
  }

  /// From now on the subsegment is split on shells around its end `corner`.
  void measure_from(SubsegmentId id, SiteId corner) {
    Subsegment& sub = subsegments_[id];
    const SiteId far = corner == sub.from ? sub.to : sub.from;
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
    std::vector<SubsegmentId> missing;
    std::vector<SubsegmentId> encroached;
    for (const SubsegmentId s : queue_) {
      is_queued_[s] = 0;
      const Subsegment& sub = subsegments_[s];
      const HalfEdgeId edge = plane_.find_edge(sub.from, sub.to);
      if (edge.valid()) plane_.set_label(edge, s);
      if (!edge.valid()) {
        missing.push_back(s);
      } else if (is_to_be_gabriel(sub) && !is_gabriel(edge)) {
        encroached.push_back(s);
      }
    }
    queue_.clear();
    std::vector<Split> splits = scheme_ == Scheme::shells ? splits_on_shells(missing, encroached)
                                                          : splits_at_feet(missing, encroached);
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
      const SiteId v = plane_.apex(side);
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

  [[nodiscard]] std::vector<Split> splits_on_shells(
      const std::vector<SubsegmentId>& missing, const std::vector<SubsegmentId>& encroached) const {
    std::vector<Split> splits;
    for (const SubsegmentId s : missing) splits.push_back(split_of(s));
    for (const SubsegmentId s : encroached) splits.push_back(split_of(s));
    return splits;
  }

  /// A missing subsegment that only others hide from its obstacles waits for them.
  std::vector<Split> splits_at_feet(const std::vector<SubsegmentId>& missing,
                                    const std::vector<SubsegmentId>& encroached) {
    std::vector<std::array<SiteId, 2>> ends;
    for (const SubsegmentId s : missing) ends.push_back({subsegments_[s].from, subsegments_[s].to});
    const Sight sight = look(plane_, ends);
    crossings_ += sight.crossings;
    std::vector<Split> splits;
    for (std::size_t k = 0; k < missing.size(); ++k) {
      if (const SiteId obstacle = widest(missing[k], sight.vertices[k]); obstacle.valid()) {
        splits.push_back(foot_of(obstacle, missing[k]));
      } else {
        enqueue(missing[k]);
      }
    }
    for (const SubsegmentId s : encroached) {
      const HalfEdgeId edge = plane_.find_edge(subsegments_[s].from, subsegments_[s].to);
      const SiteId apexes[] = {plane_.apex(edge), plane_.apex(plane_.opposite(edge))};
      splits.push_back(foot_of(widest(s, apexes), s));
    }
    if (!splits.empty()) return splits;
    for (std::size_t k = 0; k < missing.size(); ++k) {
      const SiteId obstacle = widest(missing[k], vertices_around(plane_, ends[k]));
      TETLOFT_CHECK(obstacle.valid());
      splits.push_back(foot_of(obstacle, missing[k]));
    }
    return splits;
  }

  /// The vertex in the diametral circle that sees the subsegment under the widest angle, if any.
  [[nodiscard]] SiteId widest(SubsegmentId s, std::span<const SiteId> vertices) const {
    const Point2& a = plane_.point(subsegments_[s].from);
    const Point2& b = plane_.point(subsegments_[s].to);
    SiteId best;
    double best_width = 0;
    for (const SiteId v : vertices) {
      if (v == Incremental2::kGhost || v == subsegments_[s].from || v == subsegments_[s].to) {
        continue;
      }
      const Point2& p = plane_.point(v);
      if (!in_diametral_circle(a, b, p)) continue;
      const double width = angle_width(a, p, b);
      if (!best.valid() || width > best_width ||
          (width == best_width && canonical_less(p, plane_.point(best)))) {
        best = v;
        best_width = width;
      }
    }
    return best;
  }

  [[nodiscard]] Split foot_of(SiteId obstacle, SubsegmentId s) const {
    const Subsegment& sub = subsegments_[s];
    const Segment& whole = segments_[sub.segment];
    const Piece piece{input_[whole[0].index()], input_[whole[1].index()], plane_.point(sub.from),
                      plane_.point(sub.to)};
    const bool shares[] = {is_joined(obstacle, whole[0]), is_joined(obstacle, whole[1])};
    const Point2* corner = shares[0] == shares[1] ? nullptr : shares[0] ? &piece.from : &piece.to;
    return {split_at_foot(piece, plane_.point(obstacle), corner), s, 0};
  }

  /// Does v lie on a segment that ends at the input point `corner`?
  [[nodiscard]] bool is_joined(SiteId v, PlaneVertexId corner) const {
    const PlaneVertexId point = start_.input_of[v];
    if (point.index() >= input_.size()) {
      const Segment& t = segments_[subsegments_[inserted_[point.index() - input_.size()]].segment];
      return t[0] == corner || t[1] == corner;
    }
    const auto [low, high] = std::minmax({point, corner});
    return std::binary_search(neighbours_.begin(), neighbours_.end(), Segment{low, high});
  }

  void list_neighbours() {
    for (const Segment& s : segments_) {
      const auto [low, high] = std::minmax(s[0], s[1]);
      neighbours_.push_back({low, high});
    }
    std::sort(neighbours_.begin(), neighbours_.end());
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
    if (scheme_ == Scheme::shells && gabriel_.empty()) {
      for (const Split& split : round) {
        if (pieces_[subsegments_[split.subsegment].segment] >= kMostPieces) {
          return no_room(split, "is one too many for its segment");
        }
      }
    }
    if (inserted_.size() + round.size() > most_inserted_ ||
        crossings_ / kMostCrossings > most_inserted_) {
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
  void divide(const Split& split, SiteId v) {
    Subsegment first = subsegments_[split.subsegment];
    Subsegment second = first;
    first.to = second.from = v;
    first.to_radius = second.from_radius = split.radius;
    const SubsegmentId id = subsegments_.push_back(second);
    first.next = id;
    ++pieces_[first.segment];
    subsegments_[split.subsegment] = first;
    if (first.rule == Rule::first_middle) {
      measure_from(split.subsegment, first.from);
      measure_from(id, second.to);
    }
    enqueue(split.subsegment);
    enqueue(id);
  }

  ConformedPlane result() {
    ConformedPlane result;
    result.chains.reserve(segments_.size(), 2 * segments_.size() + inserted_.size());
    for (std::size_t s = 0; s < segments_.size(); ++s) {
      result.chains.add(segments_[s][0]);
      for (SubsegmentId sub(s); sub.valid(); sub = subsegments_[sub].next) {
        result.chains.add(start_.input_of[subsegments_[sub].to]);
      }
      result.chains.end_chain();
    }
    result.points.assign(input_.begin(), input_.end());
    result.points.resize(input_.size() + inserted_.size());
    for (const SiteId v : start_.input_of.ids()) {
      if (v == Incremental2::kGhost) continue;
      result.points[start_.input_of[v].index()] = plane_.point(v);
    }
    result.start = std::move(start_);
    return result;
  }

  std::span<const Point2> input_;
  std::span<const Segment> segments_;
  const std::vector<bool>& gabriel_;
  std::size_t most_inserted_;
  Scheme scheme_;
  const WatchedWork& work_;
  std::size_t crossings_ = 0;        // with feet: looked at
  std::vector<std::size_t> pieces_;  // by segment
  std::vector<Segment> neighbours_;  // with feet: the segments, lower end first, sorted
  Start start_;
  Incremental2& plane_;

  IdVector<SubsegmentId, Subsegment> subsegments_;
  IdVector<RayId, Ray> rays_;
  std::vector<SubsegmentId> inserted_;  // by inserted point: what it split
  std::vector<SubsegmentId> queue_;     // to be looked at in the next round
  IdVector<SubsegmentId, std::uint8_t> is_queued_;
};

}  // namespace

Result<ConformedPlane> conform(Start start, std::span<const Point2> points,
                               std::span<const Segment> segments, const std::vector<bool>& gabriel,
                               std::size_t most_inserted, WatchedWork& work) {
  Result<ConformedPlane> result =
      Conformer(std::move(start), points, segments, gabriel, most_inserted, Scheme::shells, work)
          .run();
  if (result) return result;
  const Execution alone = untold(work.execution());
  WatchedWork again(alone, 0);
  return Conformer(triangulate(points, again), points, segments, gabriel, most_inserted,
                   Scheme::feet, again)
      .run();
}

}  // namespace tetloft::internal::delaunay2_detail

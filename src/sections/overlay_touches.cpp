// A node lies on one contour of each section, so about it there is one region of each and one void:
// up to four sectors, of which at most two are SS. Of the common points of the two regions, a node
// with f SS sectors and t touching arcs adds 1 − f − t / 2 to the Euler characteristic of SS faces:
// f sectors have two bordering arcs each, and an arc counts half at either end.
#include "sections/overlay_touches.hpp"

#include <algorithm>
#include <tuple>

#include "core/sort_distinct.hpp"
#include "core/union_find.hpp"

namespace tetloft::internal::sections {

namespace {

bool is_solid(const OverlayFace& face) { return face.lower.solid && face.upper.solid; }
bool is_mixed(const OverlayFace& face) { return face.lower.solid != face.upper.solid; }

class TouchFinder {
 public:
  TouchFinder(const OverlayGraph& graph, const TwoCurves& curves,
              const IdVector<FaceId, OverlayFace>& faces, const std::vector<FaceId>& face_of_cycle,
              const std::array<const Nesting*, 2>& nestings)
      : graph_(graph),
        curves_(curves),
        faces_(faces),
        face_of_cycle_(face_of_cycle),
        nestings_(nestings),
        chains_(graph.nodes().nodes.size()),
        twice_(graph.nodes().nodes.size(), 2) {}

  OverlayTouches find() {
    for (const OverlayFace& face : faces_) {
      if (is_solid(face))
        result_.meetings.push_back({face.lower.id, face.upper.id, true, face.chi});
    }
    for (std::uint32_t half = 0; half < 2 * graph_.arcs().size(); ++half) look_at(half);
    find_pinched_voids();
    for (std::uint32_t node = 0; node < twice_.size(); ++node) add_touch(node);
    gather();
    sort_distinct(result_.voids);
    return std::move(result_);
  }

 private:
  [[nodiscard]] const OverlayFace& left_of(std::uint32_t half) const {
    return faces_[face_of_cycle_[graph_.cycle(half)]];
  }
  [[nodiscard]] const OverlayNode& node(std::uint32_t n) const { return graph_.nodes().nodes[n]; }
  [[nodiscard]] RegionId region(std::uint32_t n, std::size_t s) const {
    return nestings_[s]->region[ContourId(curves_[s]->contour(node(n).edge[s]))];
  }

  // The sector to the left of a half-arc at its node, and the arc as one that touches.
  void look_at(std::uint32_t half) {
    if (graph_.cycle(half) == kNone || graph_.is_loop(half)) return;
    const std::uint32_t from = graph_.leaving(half).node;
    const OverlayFace& left = left_of(half);
    if (is_solid(left)) twice_[from] -= 2;
    const OverlayFace& right = left_of(half ^ 1U);
    if (!is_mixed(left) || !is_mixed(right) || left.lower.solid == right.lower.solid) return;
    --twice_[from];
    chains_.unite(from, graph_.leaving(half ^ 1U).node);
    if (left.lower.solid) {
      result_.voids.push_back({right.lower.id, left.upper.id, left.lower.id, right.upper.id});
    }
  }

  // Two SS sectors part the two voids about a node, which have no sector in common.
  void find_pinched_voids() {
    std::vector<std::uint8_t> solids(twice_.size(), 0);
    std::vector<VoidTouch> voids(twice_.size());
    for (std::uint32_t half = 0; half < 2 * graph_.arcs().size(); ++half) {
      if (graph_.cycle(half) == kNone || graph_.is_loop(half)) continue;
      const std::uint32_t from = graph_.leaving(half).node;
      const OverlayFace& left = left_of(half);
      if (is_solid(left)) ++solids[from];
      if (!left.lower.solid) voids[from].lower = left.lower.id;
      if (!left.upper.solid) voids[from].upper = left.upper.id;
    }
    for (std::size_t n = 0; n < solids.size(); ++n) {
      if (solids[n] != 2) continue;
      const auto node = static_cast<std::uint32_t>(n);
      result_.voids.push_back({voids[n].lower, voids[n].upper, region(node, 0), region(node, 1)});
    }
  }

  // What the chain of arcs that a node leads adds; of all nodes of a chain the first speaks.
  void add_touch(std::uint32_t n) {
    if (chains_.find(n) != n) return;
    if (sums_.empty()) {
      sums_.assign(twice_.size(), 0);
      for (std::size_t k = 0; k < twice_.size(); ++k) sums_[chains_.find(k)] += twice_[k];
    }
    const std::int32_t adds = sums_[n] / 2;
    result_.meetings.push_back(
        {region(n, 0), region(n, 1), false, 0, std::max(adds, 0), std::max(-adds, 0)});
  }

  void gather() {
    auto& all = result_.meetings;
    std::sort(all.begin(), all.end(), [](const RegionMeeting& p, const RegionMeeting& q) {
      return std::tie(p.lower, p.upper) < std::tie(q.lower, q.upper);
    });
    std::vector<RegionMeeting> meetings;
    for (const RegionMeeting& part : all) {
      if (meetings.empty() || meetings.back().lower != part.lower ||
          meetings.back().upper != part.upper) {
        meetings.push_back({part.lower, part.upper});
      }
      meetings.back().overlap = meetings.back().overlap || part.overlap;
      meetings.back().chi += part.chi;
      meetings.back().touches += part.touches;
      meetings.back().connections += part.connections;
    }
    all = std::move(meetings);
  }

  const OverlayGraph& graph_;
  const TwoCurves& curves_;
  const IdVector<FaceId, OverlayFace>& faces_;
  const std::vector<FaceId>& face_of_cycle_;
  std::array<const Nesting*, 2> nestings_;
  UnionFind chains_;                 // nodes joined by touching arcs
  std::vector<std::int32_t> twice_;  // twice what a node adds
  std::vector<std::int32_t> sums_;   // of chains, at their first node
  OverlayTouches result_;
};

}  // namespace

OverlayTouches touches_of(const OverlayGraph& graph, const TwoCurves& curves,
                          const IdVector<FaceId, OverlayFace>& faces,
                          const std::vector<FaceId>& face_of_cycle,
                          const std::array<const Nesting*, 2>& nestings) {
  return TouchFinder(graph, curves, faces, face_of_cycle, nestings).find();
}

}  // namespace tetloft::internal::sections

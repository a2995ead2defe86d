#include "sections/overlay_curves.hpp"

#include <cmath>

#include <tetloft/predicates.hpp>

namespace tetloft::internal::sections {

namespace {

// A tree over single edges costs more to build than it saves. But runs must be short as well: of
// wide contours around each other, boxes of whole ones would all meet.
constexpr std::uint32_t kBlockEdges = 8;

double extent(const Box2& box) { return (box.x1 - box.x0) + (box.y1 - box.y0); }

}  // namespace

OverlayCurves::OverlayCurves(const Section& section) : tree_({}) {
  std::size_t vertices = 0;
  for (const Contour& contour : section.contours) vertices += contour.vertices.size();
  at_.reserve(vertices);
  contour_.reserve(vertices);
  first_.push_back(0);
  for (const Contour& contour : section.contours) {
    const auto c = static_cast<std::uint32_t>(first_.size() - 1);
    at_.insert(at_.end(), contour.vertices.begin(), contour.vertices.end());
    contour_.resize(at_.size(), c);
    first_.push_back(static_cast<std::uint32_t>(at_.size()));
  }
  count_turns();
  make_blocks();
}

void OverlayCurves::count_turns() {
  turns_before_.reserve(at_.size() + 1);
  turns_before_.push_back(0);
  for (std::uint32_t c = 0; c < contour_count(); ++c) {
    std::uint32_t lowest = first_[c];
    std::uint32_t before = first_[c + 1] - 1;
    bool rose = rises(before);
    for (std::uint32_t v = first_[c]; v < first_[c + 1]; before = v++) {
      if (canonical_less(at_[v], at_[lowest])) lowest = v;
      std::int32_t turn = 0;
      if (const bool rising = rises(v); rising != rose) {
        turn = static_cast<std::int32_t>(orient2d(at_[before], at_[v], end(v)));
        rose = rising;
      }
      turns_before_.push_back(turns_before_.back() + turn);
    }
    lowest_.push_back(lowest);
  }
}

void OverlayCurves::make_blocks() {
  Box2 all;
  for (const Point2& p : at_) all.add(p);
  const double longest = 4 * extent(all) / std::sqrt(static_cast<double>(at_.size()));
  blocks_.reserve(at_.size() / 4);
  block_boxes_.reserve(at_.size() / 4);
  for (std::uint32_t v = 0; v < edge_count(); ++v) {
    const Box2 edge = box_of(start(v), end(v));
    if (v != first_[contour_[v]] && v - blocks_.back().first < kBlockEdges) {
      Box2 box = block_boxes_.back();
      box.add(edge);
      if (extent(box) <= longest) {
        blocks_.back().last = v + 1;
        block_boxes_.back() = box;
        continue;
      }
    }
    blocks_.push_back({v, v + 1});
    block_boxes_.push_back(edge);
  }
  tree_ = BoxTree2(block_boxes_);
}

}  // namespace tetloft::internal::sections

// The regions of one section, as the rules of correspondence look at them.
#pragma once

#include <algorithm>
#include <cstddef>
#include <memory>
#include <mutex>
#include <optional>
#include <vector>

#include <tetloft/nesting.hpp>
#include <tetloft/overlap.hpp>

#include "sections/contour_edges.hpp"
#include "spatial/box_tree.hpp"

namespace tetloft::internal {

class SectionRegions {
 public:
  /// Section and nesting must outlive this.
  SectionRegions(const Section& section, const Nesting& nesting);

  double z = 0;
  IdVector<RegionId, RegionOutline> outline;
  IdVector<RegionId, Box2> box;  ///< of the outer contour

  [[nodiscard]] std::size_t size() const { return outline.size(); }
  [[nodiscard]] IdRange<RegionId> ids() const { return outline.ids(); }
  [[nodiscard]] Point2 centre(RegionId r) const {
    return {(box[r].x0 + box[r].x1) / 2, (box[r].y0 + box[r].y1) / 2};
  }

  /// Calls visit(r) for the regions whose boxes meet this one, in order.
  template <class Visit>
  void for_each_near(const Box2& near, const Visit& visit) const {
    std::vector<RegionId> found;
    tree_.query(near, [&](std::size_t r) { found.emplace_back(r); });
    std::sort(found.begin(), found.end());
    for (const RegionId r : found) visit(r);
  }

  /// The edges of a region, in a tree that is made when it is first asked for. Thread-safe.
  [[nodiscard]] const sections::ContourEdges& edges(RegionId r) const;
  /// Gives all trees up, which take more memory than the section; to be made again where asked for.
  /// While nobody uses any.
  void forget_edges() const;

 private:
  struct Edges {
    std::mutex mutex;  // of making the tree
    std::optional<sections::ContourEdges> tree;
  };
  BoxTree2 tree_;
  IdVector<RegionId, std::unique_ptr<Edges>> edges_;
};

/// Of a stack, by section.
using StackSections = IdVector<SectionId, SectionRegions>;
void forget_edges(const StackSections& sections);

/// d of the rule: the distance of two regions over the gap between their sections; none where it
/// exceeds `reach`. For regions whose interiors meet it is 0, which needs no asking.
[[nodiscard]] std::optional<double> gaps_apart(const SectionRegions& below, RegionId lower,
                                               const SectionRegions& above, RegionId upper,
                                               double reach);

/// The box, larger by this on all sides and by a little more: nothing nearer is missed.
[[nodiscard]] Box2 grown(const Box2& box, double by);

}  // namespace tetloft::internal

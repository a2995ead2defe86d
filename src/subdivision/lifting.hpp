// Lifting: how far each new vertex leaves its section plane.
//
// A vertex moves from its base towards its target by a fraction, 1/2 at first. Fractions
// are halved at every child tet that is not positive, or flatter than a tenth of what it
// was unlifted, until none is left; then raised again one vertex at a time where there is
// room. Every placement is rounded once, and its tets are tested exactly as stored. That
// pieces of the solid do not touch each other is tested afterwards (embedding.hpp); no
// isotopy is needed for the proof.
//
// Where halving leads nowhere, the target is at fault, and the next one is tried:
//   ring      the mean of the opposite vertices of the edge's ring; best on the whole
//   own       the same mean within the one parent tet that is not positive. A vertex that
//             moves inside a tet towards the tet's own corners keeps its children positive
//             however thin the tet is: a matter of barycentric coordinates
//   vertical  straight across the gap
//   ring      again, down to the smallest fraction
//   squeezed  towards the own target, then to where all children are positive (squeeze.hpp):
//             for tets thinner than the spacing of doubles
#pragma once

#include <span>
#include <vector>

#include <tetloft/point.hpp>
#include <tetloft/result.hpp>

#include "core/buckets.hpp"
#include "subdivision/subdivision.hpp"

namespace tetloft::internal {

/// A lifted vertex rises at least this share of its external edge's length, or of the gap
/// if that is less, or the slab is refused. So little only where features are as thin: two nearly
/// parallel tets on one edge leave its midpoint about as much height as they are thick. (Of the
/// edge's length, since two contours that nearly touch leave no more room.) The power is a choice:
/// at coordinates about as large as the gap, 2^-36 of it is 2^16 ulps, enough to be told from the
/// plane; it is also what ends halving, after 35 of them. Between 2^-37 and 2^-35 no sample
/// changes.
inline constexpr double kSmallestLift = 0x1p-36;
/// Below this the next target is tried, if there is one left. A choice: seven halvings are given to
/// each, since a vertex that low is as good as not lifted. Half or twice as much changes one
/// sample.
inline constexpr double kLowLift = 0x1p-8;

class Lifting {
 public:
  /// Keeps references to its arguments.
  Lifting(const Slab& slab, const Subdivision& subdivision);

  /// Finds fractions under which all children are positive. Returns false if some vertex
  /// would fall below kSmallestLift; at() then is the place.
  [[nodiscard]] bool settle(RuleCounts& rules);

  /// Halves the fraction of lifted vertex k (for contacts found later); settle() again
  /// afterwards. Returns false below kSmallestLift.
  [[nodiscard]] bool halve(LiftedId k);

  /// Positions of slab vertices and lifted vertices.
  [[nodiscard]] const IdVector<NodeId, Point3>& points() const { return points_; }
  [[nodiscard]] double smallest_fraction() const;
  [[nodiscard]] const Point3& at() const { return at_; }

 private:
  enum class Aim : std::uint8_t { ring, own, vertical, ring_again, squeezed };

  [[nodiscard]] std::span<const std::uint32_t> children_at(LiftedId k) const {
    return children_[k.index()];
  }
  void look_again(LiftedId k);
  void place(LiftedId k);
  [[nodiscard]] bool lower(LiftedId k, std::uint32_t bad_child);
  void aim_next(LiftedId k, std::uint32_t bad_child);
  void aim(LiftedId k, Aim aim, std::uint32_t bad_child);
  [[nodiscard]] bool good(std::size_t child) const;
  void raise();

  const Slab& slab_;
  const Subdivision& subdivision_;
  const Nodes nodes_;
  IdVector<LiftedId, double> fraction_;
  IdVector<LiftedId, double> smallest_;  // the least fraction allowed
  IdVector<LiftedId, double> ceiling_;   // what raise() may go up to
  IdVector<LiftedId, Point3> target_;
  IdVector<LiftedId, Aim> aim_;  // what the target is
  IdVector<NodeId, Point3> points_;
  std::vector<double> unlifted_volume_;  // by child
  // The children at each lifted vertex, by id.
  const Buckets children_;
  // Children that may not be good: all at first, later those at vertices lowered since.
  std::vector<std::uint32_t> todo_;
  Point3 at_;
};

}  // namespace tetloft::internal

#include "subdivision/lifting.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <tuple>

#include <tetloft/predicates.hpp>

#include "core/sort_distinct.hpp"
#include "subdivision/squeeze.hpp"

namespace tetloft::internal {

namespace {

// Six times the signed volume, rounded: for comparing sizes only.
double volume6(const Point3& a, const Point3& b, const Point3& c, const Point3& d) {
  const double bx = b.x - a.x, by = b.y - a.y, bz = b.z - a.z;
  const double cx = c.x - a.x, cy = c.y - a.y, cz = c.z - a.z;
  const double dx = d.x - a.x, dy = d.y - a.y, dz = d.z - a.z;
  return (by * cz - bz * cy) * dx + (bz * cx - bx * cz) * dy + (bx * cy - by * cx) * dz;
}

// A child flatter than this share of its unlifted self is lifted less … A choice between the shape
// of children and height: more keeps children fatter and vertices lower (README.md, "Constants").
constexpr double kFlat = 0.1;
// … unless its vertices are this low already: shape is a wish, positivity a must. A choice: four
// halvings for shape. Half or twice as much changes two or one of the samples.
constexpr double kLowEnough = 0x1p-5;
// No child in particular.
constexpr std::uint32_t kNone = 0xFFFFFFFFU;

Buckets children_at_lifted(const Subdivision& subdivision) {
  struct Corner {
    LiftedId vertex;
    std::uint32_t child;
  };
  std::vector<Corner> corners;
  for (std::size_t c = 0; c < subdivision.children.size(); ++c) {
    for (const NodeId n : subdivision.children[c].node) {
      if (!subdivision.nodes.is_constructed(n)) continue;
      corners.push_back({subdivision.nodes.lifted(n), static_cast<std::uint32_t>(c)});
    }
  }
  Buckets children(subdivision.lifted.size(), corners.size(),
                   [&](std::size_t i) { return corners[i].vertex.index(); });
  children.replace([&](std::uint32_t i) { return corners[i].child; });
  return children;
}

}  // namespace

Lifting::Lifting(const Slab& slab, const Subdivision& subdivision)
    : slab_(slab),
      subdivision_(subdivision),
      nodes_(subdivision.nodes),
      fraction_(subdivision.lifted.size(), 0.5),
      ceiling_(subdivision.lifted.size(), 0.5),
      aim_(subdivision.lifted.size(), Aim::ring),
      children_(children_at_lifted(subdivision)) {
  points_.reserve(nodes_.size_without_caps());
  for (const SlabVertexId v : slab.vertices()) points_.push_back(slab.point(v));
  for (const LiftedVertex& vertex : subdivision.lifted) {
    points_.push_back(vertex.base);
    target_.push_back(vertex.target);
    const Point3 a = slab.point(vertex.of[0]);
    const Point3 b = slab.point(vertex.of[1]);
    const double length = std::hypot(b.x - a.x, b.y - a.y);
    smallest_.push_back(kSmallestLift * std::min(1.0, length / slab.gap()));
  }
  unlifted_volume_.reserve(subdivision.children.size());
  for (const Child& child : subdivision.children) {
    const auto& node = child.node;
    unlifted_volume_.push_back(
        std::abs(volume6(points_[node[0]], points_[node[1]], points_[node[2]], points_[node[3]])));
  }
  for (const LiftedId k : fraction_.ids()) place(k);
  todo_.resize(subdivision.children.size());
  std::iota(todo_.begin(), todo_.end(), 0U);
}

void Lifting::look_again(LiftedId k) {
  todo_.insert(todo_.end(), children_at(k).begin(), children_at(k).end());
}

void Lifting::place(LiftedId k) {
  const Point3& base = subdivision_.lifted[k].base;
  const Point3& target = target_[k];
  const double f = fraction_[k];
  points_[nodes_.of(k)] = {base.x + f * (target.x - base.x), base.y + f * (target.y - base.y),
                           base.z + f * (target.z - base.z)};
  if (aim_[k] != Aim::squeezed) return;
  std::vector<std::array<NodeId, 4>> tets;
  for (const std::uint32_t c : children_at(k)) tets.push_back(subdivision_.children[c].node);
  const DoubleRange heights{std::nextafter(std::min(base.z, target.z), HUGE_VAL),
                            std::nextafter(std::max(base.z, target.z), -HUGE_VAL)};
  const Point3 a = slab_.point(subdivision_.lifted[k].of[0]);
  // Where nothing is found children stay bad, and the next fraction is tried.
  std::ignore =
      squeeze(points_, tets, nodes_.of(k), heights, f * std::hypot(base.x - a.x, base.y - a.y));
}

bool Lifting::good(std::size_t child) const {
  const auto& node = subdivision_.children[child].node;
  const Point3& a = points_[node[0]];
  const Point3& b = points_[node[1]];
  const Point3& c = points_[node[2]];
  const Point3& d = points_[node[3]];
  if (orient3d(a, b, c, d) != Sign::positive) return false;
  if (volume6(a, b, c, d) >= kFlat * unlifted_volume_[child]) return true;
  return std::all_of(node.begin(), node.end(), [&](NodeId n) {
    if (nodes_.is_slab_vertex(n)) return true;
    const LiftedId k = nodes_.lifted(n);
    return fraction_[k] <= kLowEnough || aim_[k] == Aim::squeezed;
  });
}

bool Lifting::halve(LiftedId k) {
  ceiling_[k] = 0.5 * fraction_[k];
  look_again(k);
  return lower(k, kNone);
}

bool Lifting::lower(LiftedId k, std::uint32_t bad_child) {
  fraction_[k] *= 0.5;
  if (fraction_[k] < (aim_[k] < Aim::ring_again ? kLowLift : smallest_[k])) {
    if (aim_[k] == Aim::squeezed) {
      at_ = points_[nodes_.of(k)];
      return false;
    }
    aim_next(k, bad_child);
  }
  place(k);
  return true;
}

// Vertices of one bad child change from `ring` to `own` together: moving towards the same
// corners is what keeps it positive.
void Lifting::aim_next(LiftedId k, std::uint32_t bad_child) {
  const Aim next = static_cast<Aim>(static_cast<int>(aim_[k]) + 1);
  aim(k, next, bad_child);
  if (next != Aim::own || bad_child == kNone) return;
  for (const NodeId n : subdivision_.children[bad_child].node) {
    if (nodes_.is_slab_vertex(n)) continue;
    const LiftedId other = nodes_.lifted(n);
    if (aim_[other] != Aim::ring) continue;
    aim(other, next, bad_child);
    place(other);
  }
}

// Takes another target, and starts over at the largest fraction allowed.
void Lifting::aim(LiftedId k, Aim aim, std::uint32_t bad_child) {
  const LiftedVertex& vertex = subdivision_.lifted[k];
  aim_[k] = aim;
  fraction_[k] = std::min(0.5, ceiling_[k]);
  target_[k] = vertex.target;
  switch (aim) {
    case Aim::own:
    case Aim::squeezed: {
      if (bad_child == kNone) break;
      Point3 sum{0, 0, vertex.target.z};
      int n = 0;
      for (const SlabVertexId v : slab_.vertices(subdivision_.children[bad_child].parent)) {
        if (slab_.is_upper(v) == vertex.upper) continue;
        const Point3 p = slab_.point(v);
        sum.x += p.x;
        sum.y += p.y;
        ++n;
      }
      target_[k] = {sum.x / n, sum.y / n, sum.z};
      break;
    }
    case Aim::vertical: target_[k] = {vertex.base.x, vertex.base.y, vertex.target.z}; break;
    case Aim::ring:
    case Aim::ring_again: break;
  }
}

bool Lifting::settle(RuleCounts& rules) {
  // The first bad child of a vertex that is to be lowered; kNone otherwise.
  IdVector<LiftedId, std::uint32_t> bad_child(subdivision_.lifted.size(), kNone);
  sort_distinct(todo_);

  // Rounds: all vertices of bad children are halved together, then the children they touch
  // are looked at again.
  while (!todo_.empty()) {
    std::vector<LiftedId> halved;
    for (const std::uint32_t c : todo_) {
      if (good(c)) continue;
      for (const NodeId n : subdivision_.children[c].node) {
        if (nodes_.is_slab_vertex(n)) continue;  // nothing to move: a tet of D is positive
        const LiftedId k = nodes_.lifted(n);
        if (bad_child[k] != kNone) continue;
        bad_child[k] = c;
        halved.push_back(k);
      }
    }
    std::sort(halved.begin(), halved.end());
    todo_.clear();
    for (const LiftedId k : halved) {
      count(rules, Rule::halved_lift);
      if (!lower(k, bad_child[k])) return false;
      bad_child[k] = kNone;
      look_again(k);
    }
    sort_distinct(todo_);
  }
  raise();
  return true;
}

// Halving together overshoots: raise one at a time, lowest first, while all of its children
// stay good.
void Lifting::raise() {
  for (const LiftedId k : fraction_.ids()) {
    if (aim_[k] == Aim::squeezed) continue;
    while (fraction_[k] < ceiling_[k]) {
      const double before = fraction_[k];
      fraction_[k] = std::min(ceiling_[k], 2 * before);
      place(k);
      if (std::all_of(children_at(k).begin(), children_at(k).end(),
                      [&](std::uint32_t c) { return good(c); })) {
        continue;
      }
      fraction_[k] = before;
      place(k);
      break;
    }
  }
}

double Lifting::smallest_fraction() const {
  double smallest = 1;
  for (const double f : fraction_) smallest = std::min(smallest, f);
  return smallest;
}

}  // namespace tetloft::internal

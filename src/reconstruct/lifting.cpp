#include "reconstruct/lifting.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <tuple>

#include <tetloft/predicates.hpp>

#include "reconstruct/squeeze.hpp"

namespace tetloft {

namespace {

// Six times the signed volume, rounded: for comparing sizes only.
double volume6(const Point3& a, const Point3& b, const Point3& c, const Point3& d) {
  const double bx = b.x - a.x, by = b.y - a.y, bz = b.z - a.z;
  const double cx = c.x - a.x, cy = c.y - a.y, cz = c.z - a.z;
  const double dx = d.x - a.x, dy = d.y - a.y, dz = d.z - a.z;
  return (by * cz - bz * cy) * dx + (bz * cx - bx * cz) * dy + (bx * cy - by * cx) * dz;
}

// A child flatter than this share of its unlifted self is lifted less …
constexpr double kFlat = 0.1;
// … unless its vertices are this low already: shape is a wish, positivity a must.
constexpr double kLowEnough = 0x1p-5;
// No child in particular.
constexpr std::uint32_t kNone = 0xFFFFFFFFU;

void sort_unique(std::vector<std::uint32_t>& items) {
  std::sort(items.begin(), items.end());
  items.erase(std::unique(items.begin(), items.end()), items.end());
}

}  // namespace

Lifting::Lifting(const Slab& slab, const Subdivision& subdivision)
    : slab_(slab), subdivision_(subdivision) {
  const std::size_t n = slab.vertex_count();
  const std::size_t lifted = subdivision.lifted.size();
  points_.reserve(n + lifted);
  for (std::size_t v = 0; v < n; ++v) points_.push_back(slab.point(VertexId(v)));
  for (const LiftedVertex& vertex : subdivision.lifted) {
    points_.push_back(vertex.base);
    target_.push_back(vertex.target);
    const Point3& a = points_[vertex.of[0].index()];
    const Point3& b = points_[vertex.of[1].index()];
    const double length = std::hypot(b.x - a.x, b.y - a.y);
    smallest_.push_back(kSmallestLift * std::min(1.0, length / slab.gap()));
  }
  fraction_.assign(lifted, 0.5);
  ceiling_.assign(lifted, 0.5);
  aim_.assign(lifted, Aim::ring);

  first_child_.assign(lifted + 1, 0);
  for (const Child& child : subdivision.children) {
    for (const VertexId v : child.node) {
      if (v.index() >= n) ++first_child_[v.index() - n + 1];
    }
  }
  for (std::size_t k = 0; k < lifted; ++k) first_child_[k + 1] += first_child_[k];
  child_.resize(first_child_.back());
  std::vector<std::uint32_t> cursor(first_child_.begin(), first_child_.end() - 1);
  unlifted_volume_.reserve(subdivision.children.size());
  for (std::size_t c = 0; c < subdivision.children.size(); ++c) {
    const auto& node = subdivision.children[c].node;
    for (const VertexId v : node) {
      if (v.index() >= n) child_[cursor[v.index() - n]++] = static_cast<std::uint32_t>(c);
    }
    unlifted_volume_.push_back(
        std::abs(volume6(points_[node[0].index()], points_[node[1].index()],
                         points_[node[2].index()], points_[node[3].index()])));
  }
  for (std::size_t k = 0; k < lifted; ++k) place(k);
  todo_.resize(subdivision.children.size());
  std::iota(todo_.begin(), todo_.end(), 0U);
}

void Lifting::place(std::size_t k) {
  const Point3& base = subdivision_.lifted[k].base;
  const Point3& target = target_[k];
  const double f = fraction_[k];
  points_[slab_.vertex_count() + k] = {base.x + f * (target.x - base.x),
                                       base.y + f * (target.y - base.y),
                                       base.z + f * (target.z - base.z)};
  if (aim_[k] != Aim::squeezed) return;
  std::vector<std::array<VertexId, 4>> tets;
  for (std::uint32_t i = first_child_[k]; i < first_child_[k + 1]; ++i) {
    tets.push_back(subdivision_.children[child_[i]].node);
  }
  const DoubleRange heights{std::nextafter(std::min(base.z, target.z), HUGE_VAL),
                            std::nextafter(std::max(base.z, target.z), -HUGE_VAL)};
  const Point3& a = points_[subdivision_.lifted[k].of[0].index()];
  // Where nothing is found children stay bad, and the next fraction is tried.
  std::ignore = squeeze(points_, tets, VertexId(slab_.vertex_count() + k), heights,
                        f * std::hypot(base.x - a.x, base.y - a.y));
}

bool Lifting::good(std::size_t child) const {
  const auto& node = subdivision_.children[child].node;
  const Point3& a = points_[node[0].index()];
  const Point3& b = points_[node[1].index()];
  const Point3& c = points_[node[2].index()];
  const Point3& d = points_[node[3].index()];
  if (orient3d(a, b, c, d) != Sign::positive) return false;
  if (volume6(a, b, c, d) >= kFlat * unlifted_volume_[child]) return true;
  return std::all_of(node.begin(), node.end(), [&](VertexId v) {
    const std::size_t k = v.index() - slab_.vertex_count();
    return v.index() < slab_.vertex_count() || fraction_[k] <= kLowEnough ||
           aim_[k] == Aim::squeezed;
  });
}

bool Lifting::halve(std::size_t k) {
  ceiling_[k] = 0.5 * fraction_[k];
  todo_.insert(todo_.end(), child_.begin() + first_child_[k], child_.begin() + first_child_[k + 1]);
  return lower(k, kNone);
}

bool Lifting::lower(std::size_t k, std::uint32_t bad_child) {
  fraction_[k] *= 0.5;
  if (fraction_[k] < (aim_[k] < Aim::ring_again ? kLowLift : smallest_[k])) {
    if (aim_[k] == Aim::squeezed) {
      at_ = points_[slab_.vertex_count() + k];
      return false;
    }
    aim_next(k, bad_child);
  }
  place(k);
  return true;
}

// Vertices of one bad child change from `ring` to `own` together: moving towards the same
// corners is what keeps it positive.
void Lifting::aim_next(std::size_t k, std::uint32_t bad_child) {
  const Aim next = static_cast<Aim>(static_cast<int>(aim_[k]) + 1);
  aim(k, next, bad_child);
  if (next != Aim::own || bad_child == kNone) return;
  for (const VertexId v : subdivision_.children[bad_child].node) {
    if (v.index() < slab_.vertex_count()) continue;
    const std::size_t other = v.index() - slab_.vertex_count();
    if (aim_[other] != Aim::ring) continue;
    aim(other, next, bad_child);
    place(other);
  }
}

// Takes another target, and starts over at the largest fraction allowed.
void Lifting::aim(std::size_t k, Aim aim, std::uint32_t bad_child) {
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
      for (const VertexId v : slab_.mesh().vertices(subdivision_.children[bad_child].parent)) {
        if (slab_.is_upper(v) == vertex.upper) continue;
        sum.x += points_[v.index()].x;
        sum.y += points_[v.index()].y;
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
  const std::size_t n = slab_.vertex_count();
  // The first bad child of a vertex that is to be lowered; kNone otherwise.
  std::vector<std::uint32_t> bad_child(subdivision_.lifted.size(), kNone);
  sort_unique(todo_);

  // Rounds: all vertices of bad children are halved together, then the children they touch
  // are looked at again.
  while (!todo_.empty()) {
    std::vector<std::size_t> halved;
    for (const std::uint32_t c : todo_) {
      if (good(c)) continue;
      for (const VertexId v : subdivision_.children[c].node) {
        if (v.index() < n) continue;  // nothing to move: a tet of D is positive
        if (bad_child[v.index() - n] != kNone) continue;
        bad_child[v.index() - n] = c;
        halved.push_back(v.index() - n);
      }
    }
    std::sort(halved.begin(), halved.end());
    todo_.clear();
    for (const std::size_t k : halved) {
      count(rules, Rule::halved_lift);
      if (!lower(k, bad_child[k])) return false;
      bad_child[k] = kNone;
      todo_.insert(todo_.end(), child_.begin() + first_child_[k],
                   child_.begin() + first_child_[k + 1]);
    }
    sort_unique(todo_);
  }
  raise();
  return true;
}

// Halving together overshoots: raise one at a time, lowest first, while all of its children
// stay good.
void Lifting::raise() {
  for (std::size_t k = 0; k < fraction_.size(); ++k) {
    if (aim_[k] == Aim::squeezed) continue;
    while (fraction_[k] < ceiling_[k]) {
      const double before = fraction_[k];
      fraction_[k] = std::min(ceiling_[k], 2 * before);
      place(k);
      const bool fits =
          std::all_of(child_.begin() + first_child_[k], child_.begin() + first_child_[k + 1],
                      [&](std::uint32_t c) { return good(c); });
      if (fits) continue;
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

}  // namespace tetloft

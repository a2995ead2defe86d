#include "subdivision/truncation.hpp"

#include <algorithm>
#include <bit>
#include <cmath>

#include "core/guard.hpp"

namespace tetloft::internal {

std::array<std::array<NodeId, 4>, 3> split_prism(const std::array<NodeId, 6>& prism) {
  // The symmetries of the prism that keep its orientation and bring vertex i to the front.
  static constexpr std::array<std::array<std::size_t, 6>, 6> kToFront{{{0, 1, 2, 3, 4, 5},
                                                                       {1, 2, 0, 4, 5, 3},
                                                                       {2, 0, 1, 5, 3, 4},
                                                                       {3, 5, 4, 0, 2, 1},
                                                                       {4, 3, 5, 1, 0, 2},
                                                                       {5, 4, 3, 2, 1, 0}}};
  const auto lowest =
      static_cast<std::size_t>(std::min_element(prism.begin(), prism.end()) - prism.begin());
  std::array<NodeId, 6> v;
  for (std::size_t i = 0; i < 6; ++i) v[i] = prism[kToFront[lowest][i]];
  // The lowest vertex v0 sends diagonals to e and f; the quad b c f e is left to choose.
  if (std::min(v[1], v[5]) < std::min(v[2], v[4])) {
    return {{{v[0], v[1], v[2], v[5]}, {v[0], v[1], v[5], v[4]}, {v[0], v[4], v[5], v[3]}}};
  }
  return {{{v[0], v[1], v[2], v[4]}, {v[0], v[4], v[2], v[5]}, {v[0], v[4], v[5], v[3]}}};
}

namespace {

// A cut is at least this many ulps of its coordinates from the corner kept, across the gap
// and sideways, or rounding would decide the shape of what is left: a constructed coordinate is off
// by about an ulp (half for the product, half for the sum, and the step itself), which turns an
// offset of 2^10 ulps by 2^-10 or so. How many bits of direction are enough is a choice.
constexpr double kResolution = 0x1p10;

double ulp(double value) { return std::nextafter(value, HUGE_VAL) - value; }

// The share of a distance at which it is resolved by coordinates of this magnitude.
double resolved_share(double magnitude, double distance) {
  return distance > 0 ? kResolution * ulp(magnitude) / distance : 0;
}

}  // namespace

Point3 place_cut(const Cut& cut, const Point3& kept, const Point3& away, double gap) {
  const double dx = away.x - kept.x;
  const double dy = away.y - kept.y;
  const double dz = away.z - kept.z;
  const double sideways = std::max(std::abs(dx), std::abs(dy)) > 0 ? std::hypot(dx, dy) : 0;
  const double full = cut.towards_half ? 1 - 2 * kSeparation : 0.5 - kSeparation;
  const double lean = (cut.from_lifted ? 0.5 : 1.0) * kLargestLean * gap;
  double t = full;
  if (t * sideways > lean) {
    const double floor =
        std::max(resolved_share(std::max(std::abs(kept.x), std::abs(kept.y)), sideways),
                 resolved_share(std::max(std::abs(kept.z), std::abs(away.z)), std::abs(dz)));
    t = std::min(full, std::max(lean / sideways, floor));
  }
  t *= cut.scale;
  return {kept.x + t * dx, kept.y + t * dy, kept.z + t * dz};
}

namespace {

class Truncator {
 public:
  Truncator(const Slab& slab, const SlabClasses& classes, const Complex& complex,
            const Subdivision& subdivision, const IdVector<LiftedId, std::uint8_t>& trimmed)
      : slab_(slab),
        classes_(classes),
        complex_(complex),
        subdivision_(subdivision),
        nodes_(subdivision.nodes),
        trimmed_(trimmed) {}

  Truncation run() {
    // Two passes over the same pieces: the first collects cuts, which are then sorted and
    // numbered, the second makes the tets.
    for_each_piece([&](const Child& child, SlabRegionId, unsigned attached) {
      for (std::size_t p = 0; p < 4; ++p) {
        for (std::size_t q = 0; q < 4; ++q) {
          if (!whole(child, p, attached) || whole(child, q, attached)) continue;
          const bool half = std::popcount(child.mean_of[q]) == 2 && (child.mean_of[q] & attached);
          const bool from_lifted = nodes_.is_lifted(child.node[p]);
          result_.cuts.push_back({child.node[p], child.node[q], half, from_lifted, 1});
        }
      }
    });
    const auto key = [](const Cut& cut) { return std::pair(cut.kept, cut.away); };
    std::vector<Cut>& cuts = result_.cuts.raw();
    std::sort(cuts.begin(), cuts.end(),
              [&](const Cut& a, const Cut& b) { return key(a) < key(b); });
    const auto end = std::unique(cuts.begin(), cuts.end(), [&](const Cut& a, const Cut& b) {
      if (key(a) != key(b)) return false;
      TETLOFT_CHECK(a.towards_half == b.towards_half);
      return true;
    });
    cuts.erase(end, cuts.end());
    result_.nodes = Nodes(slab_.vertex_count(), subdivision_.lifted.size(), cuts.size());
    for_each_piece([&](const Child& child, SlabRegionId region, unsigned attached) {
      cut_out(child, region, attached);
    });
    return std::move(result_);
  }

 private:
  // Is corner i of weight 1 for the class with these attached corners of the parent?
  [[nodiscard]] bool whole(const Child& child, std::size_t i, unsigned attached) const {
    const NodeId n = child.node[i];
    const bool cut_off = nodes_.is_lifted(n) && trimmed_[nodes_.lifted(n)] != 0;
    return !cut_off && (child.mean_of[i] & ~attached) == 0;
  }

  // Visits (child, a region of the class, the class's attached corners of the parent).
  template <class Visit>
  void for_each_piece(const Visit& visit) const {
    for (const Child& child : subdivision_.children) {
      unsigned left = complex_.attached[child.parent];
      while (left != 0) {
        const int corner = std::countr_zero(left);
        const SlabRegionId region = classes_.region(slab_.vertex(child.parent, corner));
        const ClassId c = classes_.of_region(region);
        const unsigned own = left & own_corners(slab_, classes_, child.parent, c);
        visit(child, classes_.regions(c).front(), own);
        left &= ~own;
      }
    }
  }

  [[nodiscard]] NodeId cut_node(NodeId kept, NodeId away) const {
    const auto at = std::lower_bound(
        result_.cuts.begin(), result_.cuts.end(), std::pair(kept, away),
        [](const Cut& cut, const auto& k) { return std::pair(cut.kept, cut.away) < k; });
    return result_.nodes.of(CutId(static_cast<std::uint32_t>(at - result_.cuts.begin())));
  }

  void emit(const Child& child, SlabRegionId region, const std::array<NodeId, 4>& node) {
    result_.pieces.push_back({node, region, slab_.kind(child.parent)});
    result_.parent.push_back(child.parent);
  }

  void emit_prism(const Child& child, SlabRegionId region, const std::array<NodeId, 6>& prism) {
    for (const auto& tet : split_prism(prism)) emit(child, region, tet);
  }

  void cut_out(const Child& child, SlabRegionId region, unsigned attached) {
    // Even permutation: kept corners first.
    std::array<std::size_t, 4> order{};
    std::size_t kept = 0;
    std::size_t others = 0;
    std::size_t inversions = 0;
    std::array<std::size_t, 4> other{};
    for (std::size_t i = 0; i < 4; ++i) {
      if (whole(child, i, attached)) {
        inversions += others;
        order[kept++] = i;
      } else {
        other[others++] = i;
      }
    }
    if (kept == 0) return;
    std::copy_n(other.begin(), others, order.begin() + static_cast<std::ptrdiff_t>(kept));
    if (inversions % 2 != 0) {
      if (kept >= 2) {
        std::swap(order[0], order[1]);
      } else {
        std::swap(order[2], order[3]);
      }
    }
    const auto [a, b, c, d] = std::array{child.node[order[0]], child.node[order[1]],
                                         child.node[order[2]], child.node[order[3]]};
    switch (kept) {
      case 4: emit(child, region, {a, b, c, d}); break;
      case 3:
        emit_prism(child, region, {a, b, c, cut_node(a, d), cut_node(b, d), cut_node(c, d)});
        break;
      case 2:
        // Triangles at the two kept corners; (a, ac, ad, b) is positive with (a, c, d, b),
        // an even permutation of (a, b, c, d).
        emit_prism(child, region,
                   {a, cut_node(a, c), cut_node(a, d), b, cut_node(b, c), cut_node(b, d)});
        break;
      default: emit(child, region, {a, cut_node(a, b), cut_node(a, c), cut_node(a, d)}); break;
    }
  }

  const Slab& slab_;
  const SlabClasses& classes_;
  const Complex& complex_;
  const Subdivision& subdivision_;
  const Nodes nodes_;
  const IdVector<LiftedId, std::uint8_t>& trimmed_;
  Truncation result_;
};

}  // namespace

Truncation truncate(const Slab& slab, const SlabClasses& classes, const Complex& complex,
                    const Subdivision& subdivision,
                    const IdVector<LiftedId, std::uint8_t>& trimmed) {
  return Truncator(slab, classes, complex, subdivision, trimmed).run();
}

}  // namespace tetloft::internal

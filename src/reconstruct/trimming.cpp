#include "reconstruct/trimming.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/union_find.hpp"

namespace tetloft {

namespace {

// Distance from p to the region of a section, rounded, 0 inside; `enough` may end the
// search early, with some smaller distance.
double distance_to_region(const ConformingSection& section, const Point2& p, double enough) {
  double best = std::numeric_limits<double>::infinity();
  bool inside = false;
  for (std::size_t k = 0; k < section.vertex_count(); ++k) {
    const Point2 a = section.point(VertexId(k));
    const Point2 b = section.point(section.next[VertexId(k)]);
    const double dx = b.x - a.x;
    const double dy = b.y - a.y;
    const double length2 = dx * dx + dy * dy;
    const double along = length2 > 0 ? ((p.x - a.x) * dx + (p.y - a.y) * dy) / length2 : 0;
    const double t = std::clamp(along, 0.0, 1.0);
    best = std::min(best, std::hypot(p.x - a.x - t * dx, p.y - a.y - t * dy));
    if (best <= enough) return best;
    if ((a.y > p.y) != (b.y > p.y) && p.x < a.x + (p.y - a.y) / dy * dx) inside = !inside;
  }
  return inside ? 0 : best;
}

class Trimmer {
 public:
  Trimmer(const Slab& slab, const Complex& complex, const Subdivision& subdivision,
          const Lifting& lifting)
      : slab_(slab), complex_(complex), subdivision_(subdivision), lifting_(lifting) {}

  std::vector<std::uint8_t> run() {
    const std::size_t n = subdivision_.lifted.size();
    trimmed_.assign(n, 0);
    std::vector<std::pair<double, std::size_t>> overhanging;
    for (std::size_t k = 0; k < n; ++k) {
      const double overhang = overhang_of(k);
      if (overhang > kLargestOverhang * slab_.gap()) overhanging.emplace_back(-overhang, k);
    }
    if (overhanging.empty()) return trimmed_;
    std::sort(overhanging.begin(), overhanging.end());
    collect_neighbours(overhanging);
    UnionFind components(n);
    for (const auto& entry : overhanging) try_to_trim(entry.second, components);
    return trimmed_;
  }

 private:
  // A neighbour of an overhanging vertex in one parent tet.
  struct Neighbour {
    std::size_t vertex;  // the overhanging one
    TetId parent;
    std::size_t other;
    bool through_interior;
    friend auto operator<=>(const Neighbour&, const Neighbour&) = default;
  };

  [[nodiscard]] double overhang_of(std::size_t k) const {
    const LiftedVertex& vertex = subdivision_.lifted[k];
    const Point3& at = lifting_.points()[slab_.vertex_count() + k];
    const Point2 p{at.x, at.y};
    const double enough = kLargestOverhang * slab_.gap();
    for (const VertexId v : vertex.of) {
      if (!v.valid()) continue;
      const Point3 end = slab_.point(v);
      if (std::hypot(end.x - p.x, end.y - p.y) <= enough) return 0;
    }
    return std::min(distance_to_region(slab_.lower(), p, enough),
                    distance_to_region(slab_.upper(), p, enough));
  }

  // Lifted vertices that share a child with one that overhangs. Only those that belong to
  // the solid count: all corners they are the mean of are attached.
  void collect_neighbours(const std::vector<std::pair<double, std::size_t>>& overhanging) {
    std::vector<std::uint8_t> wanted(subdivision_.lifted.size(), 0);
    for (const auto& entry : overhanging) wanted[entry.second] = 1;
    const std::size_t n = slab_.vertex_count();
    for (const Child& child : subdivision_.children) {
      const unsigned attached = complex_.attached[child.parent];
      const bool type1 = slab_.kind(child.parent) == TetKind::t1_external;
      for (std::size_t i = 0; i < 4; ++i) {
        const std::size_t v = child.node[i].index();
        if (v < n || wanted[v - n] == 0 || (child.mean_of[i] & ~attached) != 0) continue;
        for (std::size_t j = 0; j < 4; ++j) {
          const std::size_t w = child.node[j].index();
          if (j == i || w < n || wanted[w - n] == 0) continue;
          if ((child.mean_of[j] & ~attached) != 0) continue;
          neighbours_.push_back({v - n, child.parent, w - n, !type1});
        }
      }
    }
    std::sort(neighbours_.begin(), neighbours_.end());
    neighbours_.erase(std::unique(neighbours_.begin(), neighbours_.end()), neighbours_.end());
  }

  void try_to_trim(std::size_t k, UnionFind& components) {
    auto at = std::lower_bound(neighbours_.begin(), neighbours_.end(), k,
                               [](const Neighbour& a, std::size_t v) { return a.vertex < v; });
    // Trimmed neighbours of one parent triangle are joined to each other there: one contact.
    std::vector<std::pair<TetId, std::size_t>> met;  // parent, component
    for (; at != neighbours_.end() && at->vertex == k; ++at) {
      if (trimmed_[at->other] == 0) continue;
      if (at->through_interior) return;
      const std::pair contact(at->parent, components.find(at->other));
      if (std::find(met.begin(), met.end(), contact) != met.end()) continue;
      for (const auto& earlier : met) {
        if (earlier.second == contact.second) return;
      }
      met.push_back(contact);
    }
    trimmed_[k] = 1;
    for (const auto& contact : met) components.unite(k, contact.second);
  }

  const Slab& slab_;
  const Complex& complex_;
  const Subdivision& subdivision_;
  const Lifting& lifting_;
  std::vector<std::uint8_t> trimmed_;
  std::vector<Neighbour> neighbours_;  // sorted
};

}  // namespace

std::vector<std::uint8_t> choose_trimmed(const Slab& slab, const Complex& complex,
                                         const Subdivision& subdivision, const Lifting& lifting) {
  return Trimmer(slab, complex, subdivision, lifting).run();
}

}  // namespace tetloft

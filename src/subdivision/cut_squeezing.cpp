#include "subdivision/cut_squeezing.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <tuple>

#include <tetloft/predicates.hpp>

#include "core/sort_distinct.hpp"

namespace tetloft::internal {

namespace {

using Tet = std::array<NodeId, 4>;

// A cut moves at most this share of its distance from the kept corner. A choice that asks for
// little: the doubles looked for are a few ulps away, and the bound keeps those of a degenerate
// range from coming near another node, which the embedding test would refuse. Neither half nor
// twice as much changes a sample.
constexpr double kReach = 0x1p-4;

bool has(const Tet& tet, NodeId v) { return std::find(tet.begin(), tet.end(), v) != tet.end(); }

Tet replaced(Tet tet, NodeId from, NodeId to) {
  std::replace(tet.begin(), tet.end(), from, to);
  return tet;
}

class CutSqueezing {
 public:
  CutSqueezing(IdVector<NodeId, Point3>& points, const Subdivision& subdivision,
               const Truncation& truncation, DoubleRange heights)
      : points_(points), subdivision_(subdivision), truncation_(truncation), heights_(heights) {}

  /// `cuts`: all of one class, in any order.
  void run(std::vector<CutId> cuts, const std::vector<CutId>& cuts_of_class) {
    // The children around these cuts, all cuts of these, and the children around those.
    std::vector<std::size_t> around = children_at(cuts);
    cuts.clear();
    for (const CutId k : cuts_of_class) {
      if (std::any_of(around.begin(), around.end(), [&](std::size_t c) {
            return lies_on_edge(k, subdivision_.children[c].node);
          })) {
        cuts.push_back(k);
      }
    }
    around = children_at(cuts);
    tets_.clear();
    for (const std::size_t c : around) tets_.push_back(subdivision_.children[c].node);
    for (auto k = cuts.rbegin(); k != cuts.rend(); ++k) split_at(*k);
  }

 private:
  [[nodiscard]] bool lies_on_edge(CutId cut, const Tet& tet) const {
    return has(tet, truncation_.cuts[cut].kept) && has(tet, truncation_.cuts[cut].away);
  }

  [[nodiscard]] std::vector<std::size_t> children_at(const std::vector<CutId>& cuts) const {
    std::vector<std::size_t> found;
    for (std::size_t c = 0; c < subdivision_.children.size(); ++c) {
      if (std::any_of(cuts.begin(), cuts.end(),
                      [&](CutId k) { return lies_on_edge(k, subdivision_.children[c].node); })) {
        found.push_back(c);
      }
    }
    return found;
  }

  void split_at(CutId k) {
    const Cut& cut = truncation_.cuts[k];
    const NodeId v = truncation_.nodes.of(k);
    const auto ring = std::partition(tets_.begin(), tets_.end(), [&](const Tet& t) {
      return !has(t, cut.kept) || !has(t, cut.away);
    });
    std::vector<Tet> halves;
    for (auto t = ring; t != tets_.end(); ++t) {
      halves.push_back(replaced(*t, cut.away, v));
      halves.push_back(replaced(*t, cut.kept, v));
    }
    const bool positive = std::all_of(halves.begin(), halves.end(), [&](const Tet& t) {
      return orient3d(points_[t[0]], points_[t[1]], points_[t[2]], points_[t[3]]) == Sign::positive;
    });
    if (!positive) {
      const Point3& p = points_[v];
      const Point3& kept = points_[cut.kept];
      const double reach = kReach * std::hypot(p.x - kept.x, p.y - kept.y, p.z - kept.z);
      std::ignore = squeeze(
          points_, halves, v,
          {std::max(heights_.first, p.z - reach), std::min(heights_.last, p.z + reach)}, reach);
    }
    tets_.erase(ring, tets_.end());
    tets_.insert(tets_.end(), halves.begin(), halves.end());
  }

  IdVector<NodeId, Point3>& points_;
  const Subdivision& subdivision_;
  const Truncation& truncation_;
  DoubleRange heights_;
  std::vector<Tet> tets_;
};

}  // namespace

void squeeze_cuts(IdVector<NodeId, Point3>& points, const SlabClasses& classes,
                  const Subdivision& subdivision, const Truncation& truncation,
                  std::span<const std::size_t> bad, DoubleRange heights) {
  const auto class_of = [&](std::size_t piece) {
    return classes.of_region(truncation.pieces[piece].region);
  };
  const auto append_cuts = [&](std::size_t piece, std::vector<CutId>& cuts) {
    for (const NodeId n : truncation.pieces[piece].node) {
      if (truncation.nodes.is_cut(n)) cuts.push_back(truncation.nodes.cut(n));
    }
  };
  std::vector<ClassId> affected;
  for (const std::size_t piece : bad) affected.push_back(class_of(piece));
  sort_distinct(affected);
  CutSqueezing squeezing(points, subdivision, truncation, heights);
  for (const ClassId c : affected) {
    std::vector<CutId> of_bad, of_class;
    for (const std::size_t piece : bad) {
      if (class_of(piece) == c) append_cuts(piece, of_bad);
    }
    for (std::size_t piece = 0; piece < truncation.pieces.size(); ++piece) {
      if (class_of(piece) == c) append_cuts(piece, of_class);
    }
    sort_distinct(of_bad);
    sort_distinct(of_class);
    squeezing.run(std::move(of_bad), of_class);
  }
}

}  // namespace tetloft::internal

#include "reconstruct/cut_squeezing.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <tuple>

#include <tetloft/predicates.hpp>

namespace tetloft {

namespace {

using Tet = std::array<VertexId, 4>;

// A cut moves at most this share of its distance from the kept corner.
constexpr double kReach = 0x1p-4;

void sort_distinct(std::vector<std::size_t>& items) {
  std::sort(items.begin(), items.end());
  items.erase(std::unique(items.begin(), items.end()), items.end());
}

bool has(const Tet& tet, VertexId v) { return std::find(tet.begin(), tet.end(), v) != tet.end(); }

Tet replaced(Tet tet, VertexId from, VertexId to) {
  std::replace(tet.begin(), tet.end(), from, to);
  return tet;
}

class CutSqueezing {
 public:
  CutSqueezing(std::span<Point3> points, std::size_t first_cut, const Subdivision& subdivision,
               const Truncation& truncation, DoubleRange heights)
      : points_(points),
        first_cut_(first_cut),
        subdivision_(subdivision),
        truncation_(truncation),
        heights_(heights) {}

  /// `cuts`: all of one class, in any order.
  void run(std::vector<std::size_t> cuts, const std::vector<std::size_t>& cuts_of_class) {
    // The children around these cuts, all cuts of these, and the children around those.
    std::vector<std::size_t> around = children_at(cuts);
    cuts.clear();
    for (const std::size_t k : cuts_of_class) {
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
  [[nodiscard]] bool lies_on_edge(std::size_t cut, const Tet& tet) const {
    return has(tet, truncation_.cuts[cut].kept) && has(tet, truncation_.cuts[cut].away);
  }

  [[nodiscard]] std::vector<std::size_t> children_at(const std::vector<std::size_t>& cuts) const {
    std::vector<std::size_t> found;
    for (std::size_t c = 0; c < subdivision_.children.size(); ++c) {
      if (std::any_of(cuts.begin(), cuts.end(), [&](std::size_t k) {
            return lies_on_edge(k, subdivision_.children[c].node);
          })) {
        found.push_back(c);
      }
    }
    return found;
  }

  void split_at(std::size_t k) {
    const Cut& cut = truncation_.cuts[k];
    const VertexId v(first_cut_ + k);
    const auto ring = std::partition(tets_.begin(), tets_.end(), [&](const Tet& t) {
      return !has(t, cut.kept) || !has(t, cut.away);
    });
    std::vector<Tet> halves;
    for (auto t = ring; t != tets_.end(); ++t) {
      halves.push_back(replaced(*t, cut.away, v));
      halves.push_back(replaced(*t, cut.kept, v));
    }
    const bool positive = std::all_of(halves.begin(), halves.end(), [&](const Tet& t) {
      return orient3d(points_[t[0].index()], points_[t[1].index()], points_[t[2].index()],
                      points_[t[3].index()]) == Sign::positive;
    });
    if (!positive) {
      const Point3& p = points_[v.index()];
      const Point3& kept = points_[cut.kept.index()];
      const double reach = kReach * std::hypot(p.x - kept.x, p.y - kept.y, p.z - kept.z);
      std::ignore = squeeze(
          points_, halves, v,
          {std::max(heights_.first, p.z - reach), std::min(heights_.last, p.z + reach)}, reach);
    }
    tets_.erase(ring, tets_.end());
    tets_.insert(tets_.end(), halves.begin(), halves.end());
  }

  std::span<Point3> points_;
  std::size_t first_cut_;
  const Subdivision& subdivision_;
  const Truncation& truncation_;
  DoubleRange heights_;
  std::vector<Tet> tets_;
};

}  // namespace

void squeeze_cuts(std::span<Point3> points, std::size_t first_cut, const SlabClasses& classes,
                  const Subdivision& subdivision, const Truncation& truncation,
                  std::span<const std::size_t> bad, DoubleRange heights) {
  const auto class_of = [&](std::size_t piece) {
    return classes.of_region(truncation.pieces[piece].region);
  };
  const auto append_cuts = [&](std::size_t piece, std::vector<std::size_t>& cuts) {
    for (const VertexId v : truncation.pieces[piece].node) {
      if (v.index() >= first_cut) cuts.push_back(v.index() - first_cut);
    }
  };
  std::vector<ClassId> affected;
  for (const std::size_t piece : bad) affected.push_back(class_of(piece));
  std::sort(affected.begin(), affected.end());
  affected.erase(std::unique(affected.begin(), affected.end()), affected.end());
  CutSqueezing squeezing(points, first_cut, subdivision, truncation, heights);
  for (const ClassId c : affected) {
    std::vector<std::size_t> of_bad, of_class;
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

}  // namespace tetloft

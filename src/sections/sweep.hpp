// A sweep over edges of the plane that meet at common ends only.
//
// The line sweeps by canonical order (x, y), that is, tilted infinitesimally, so that a
// vertical edge is an edge like others. Invariant: status_ holds the edges that cross the
// line, bottom up; orientation tests and comparisons decide everything (Shamos and Hoey,
// "Geometric intersection problems", FOCS 1976).
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <set>
#include <span>
#include <utility>
#include <vector>

#include <tetloft/point.hpp>
#include <tetloft/predicates.hpp>

#include "spatial/sort_by_key.hpp"

namespace tetloft::internal::sections {

/// An edge from its lower to its higher end in canonical order; the ends differ.
struct SweepEdge {
  Point2 low, high;
};

inline constexpr std::uint32_t kNoEdge = 0xFFFFFFFFU;

/// What the sweep finds at one vertex.
struct SweepEvent {
  Point2 at;
  std::span<const std::uint32_t> incoming;  ///< edges with their high end here
  std::span<const std::uint32_t> outgoing;  ///< edges with their low end here, bottom up
  std::uint32_t below = kNoEdge;            ///< the edge next below the vertex
  std::uint32_t above = kNoEdge;            ///< the edge next above it
};

class Sweep {
 public:
  /// `edges` must outlive the sweep. No two may be equal, cross or touch but at ends, up
  /// to the vertex where the sweep is stopped.
  explicit Sweep(std::span<const SweepEdge> edges)
      : edges_(edges), status_(Below{edges}), place_(edges.size(), status_.end()) {}

  /// Calls visit(event) at every vertex in canonical order, before its outgoing edges enter
  /// the status. Stops when visit returns false.
  template <class Visit>
  void run(Visit visit) {
    const std::vector<std::uint32_t> starts = sorted_by(&SweepEdge::low);
    const std::vector<std::uint32_t> ends = sorted_by(&SweepEdge::high);
    std::size_t s = 0;
    std::size_t e = 0;
    std::vector<std::uint32_t> outgoing;
    while (e < ends.size()) {
      SweepEvent event;
      event.at = edges_[ends[e]].high;
      if (s < starts.size() && canonical_less(edges_[starts[s]].low, event.at)) {
        event.at = edges_[starts[s]].low;
      }
      outgoing.clear();
      while (s < starts.size() && edges_[starts[s]].low == event.at) {
        outgoing.push_back(starts[s++]);
      }
      if (outgoing.size() > 1)
        std::sort(outgoing.begin(), outgoing.end(), [&](std::uint32_t i, std::uint32_t j) {
          return orient2d(event.at, edges_[i].high, edges_[j].high) == Sign::positive;
        });
      event.outgoing = outgoing;
      const std::size_t first_end = e;
      while (e < ends.size() && edges_[ends[e]].high == event.at) ++e;
      event.incoming = std::span(ends).subspan(first_end, e - first_end);

      // One edge that continues another takes its place: no search, no balancing.
      const bool continues = event.incoming.size() == 1 && outgoing.size() == 1;
      const Iterator place = continues ? place_[event.incoming[0]] : remove_incoming(event);
      const Iterator next = continues ? std::next(place) : place;
      if (place != status_.begin()) event.below = std::prev(place)->edge;
      if (next != status_.end()) event.above = next->edge;
      if (!visit(std::as_const(event))) return;
      if (continues) {
        place->edge = outgoing[0];
        place_[outgoing[0]] = place;
        continue;
      }
      for (const std::uint32_t edge : outgoing) {
        place_[edge] = status_.emplace_hint(next, Item{edge});
      }
    }
  }

 private:
  struct Item {
    mutable std::uint32_t edge;  // replaced by its continuation, which keeps the order
  };
  struct Below {
    using is_transparent = void;
    std::span<const SweepEdge> edges;

    bool operator()(const Item& i, const Point2& p) const {
      return orient2d(edges[i.edge].low, edges[i.edge].high, p) == Sign::positive;
    }
    bool operator()(const Item& i, const Item& j) const {
      const SweepEdge& a = edges[i.edge];
      const SweepEdge& b = edges[j.edge];
      if (a.low == b.low) return orient2d(a.low, a.high, b.high) == Sign::positive;
      if (canonical_less(a.low, b.low)) return orient2d(a.low, a.high, b.low) == Sign::positive;
      return orient2d(b.low, b.high, a.low) == Sign::negative;
    }
  };
  using Status = std::set<Item, Below>;
  using Iterator = Status::iterator;

  [[nodiscard]] std::vector<std::uint32_t> sorted_by(Point2 SweepEdge::*end) const {
    std::vector<Keyed> entries(edges_.size());
    for (std::uint32_t i = 0; i < entries.size(); ++i) entries[i].place = i;
    sort_canonically(entries,
                     [&](std::uint32_t edge) -> const Point2& { return edges_[edge].*end; });
    std::vector<std::uint32_t> order(entries.size());
    for (std::size_t i = 0; i < order.size(); ++i) order[i] = entries[i].place;
    return order;
  }

  // Returns the first edge above the vertex.
  Iterator remove_incoming(const SweepEvent& event) {
    if (event.incoming.empty()) return status_.lower_bound(event.at);
    // Edges ending at one point are neighbours in the status: whichever goes last, the
    // edge after it is the first one above.
    Iterator above = status_.end();
    for (const std::uint32_t edge : event.incoming) above = status_.erase(place_[edge]);
    return above;
  }

  std::span<const SweepEdge> edges_;
  Status status_;
  std::vector<Iterator> place_;  // place_[edge]: where it is in the status
};

}  // namespace tetloft::internal::sections

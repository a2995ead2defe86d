// Tets kept for a class beyond what the rules ask for, and attached (see completion.hpp).
#include <algorithm>

#include "completion/completion.hpp"

namespace tetloft::internal {

void Completion::build(const std::vector<Wall>& walls) {
  for (const Wall& wall : walls) keep(wall.tet, wall.id);
  settle_queue();
  for (const Wall& wall : walls) {
    for (int i = 0; i < 4; ++i) {
      if (!has_corner(wall.corners, i) || complex_.is_attached(wall.tet, i)) continue;
      for (const TetId t : way_to_primary(wall.tet, slab_.vertex(wall.tet, i))) keep(t, wall.id);
      settle_queue();
    }
  }
}

void Completion::adopt(Completion&& trial) { complex_ = std::move(trial.complex_); }

// The shortest way of tets in the star of p from t to its primary sheet; ties by the order of
// spokes. A star is connected.
std::vector<TetId> Completion::way_to_primary(TetId t, SlabVertexId p) {
  gather_star(p);
  find_primary_sheet(p);
  std::vector<std::uint32_t> from(spokes_.size(), kUnreached);
  std::vector<std::uint32_t> order{static_cast<std::uint32_t>(spoke_of_[t])};
  from[order.front()] = order.front();
  for (std::size_t at = 0; at < order.size(); ++at) {
    const std::uint32_t k = order[at];
    if (primary_[k] != 0) {
      std::vector<TetId> way;
      for (std::uint32_t back = k; from[back] != back; back = from[back]) {
        way.push_back(spokes_[back].tet);
      }
      return way;
    }
    for (int i = 0; i < 4; ++i) {
      if (i == spokes_[k].corner) continue;
      const std::int32_t next = spokes_[k].next[static_cast<std::size_t>(i)];
      if (next == kHull || from[static_cast<std::size_t>(next)] != kUnreached) continue;
      from[static_cast<std::size_t>(next)] = k;
      order.push_back(static_cast<std::uint32_t>(next));
    }
  }
  return {};
}

}  // namespace tetloft::internal

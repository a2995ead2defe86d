#include "unit/check/blocks.hpp"

#include <array>
#include <map>

namespace tetloft::testing {

namespace {

using Corner = std::array<std::size_t, 3>;

class Builder {
 public:
  explicit Builder(const Layers& layers) : layers_(layers) {
    for (const Section& section : layers.sections) made_.stack.sections.push_back(section);
  }

  Case run() {
    for (std::size_t k = 0; k < layers_.pictures.size(); ++k) {
      const Picture& picture = layers_.pictures[k];
      for (std::size_t j = 0; j < picture.size(); ++j) {
        for (std::size_t i = 0; i < picture[j].size(); ++i) {
          if (picture[j][i] == '#') add_cube({i, j, k});
        }
      }
    }
    return std::move(made_);
  }

 private:
  VertexId vertex(const Corner& at) {
    const auto [found, fresh] = vertices_.try_emplace(at);
    if (fresh) {
      found->second = made_.model.points.push_back(
          {static_cast<double>(at[0]), static_cast<double>(at[1]), layers_.heights[at[2]]});
    }
    return found->second;
  }

  // Six tets about the diagonal from the lowest corner to the highest: one for each order in which
  // a path along edges leads from the one to the other.
  void add_cube(const Corner& low) {
    constexpr std::array<std::array<std::size_t, 3>, 6> kOrders{
        {{0, 1, 2}, {1, 2, 0}, {2, 0, 1}, {1, 0, 2}, {0, 2, 1}, {2, 1, 0}}};
    for (std::size_t o = 0; o < kOrders.size(); ++o) {
      Corner at = low;
      TetVertices tet;
      tet[0] = vertex(at);
      for (std::size_t step = 0; step < 3; ++step) {
        ++at[kOrders[o][step]];
        tet[step + 1] = vertex(at);
      }
      const auto point = [&](std::size_t i) { return made_.model.points[tet[i]]; };
      if (orient3d(point(0), point(1), point(2), point(3)) == Sign::negative) {
        std::swap(tet[2], tet[3]);
      }
      made_.model.tets.push_back(tet);
    }
  }

  const Layers& layers_;
  Case made_;
  std::map<Corner, VertexId> vertices_;
};

}  // namespace

Case build(const Layers& layers) { return Builder(layers).run(); }

}  // namespace tetloft::testing

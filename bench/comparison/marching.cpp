#include "comparison/marching.hpp"

#include <algorithm>
#include <array>
#include <limits>
#include <utility>

namespace tetloft::bench {

namespace {

constexpr float kOutside = std::numeric_limits<float>::infinity();

// Corners of a cell are numbered by bits: 1 for x, 2 for y, 4 for z. Each tet leads from corner 0
// along the axes in some order to corner 7, and is positive: odd orders have two vertices swapped.
constexpr unsigned kTets[6][4] = {{0, 1, 3, 7}, {0, 2, 6, 7}, {0, 4, 5, 7},
                                  {0, 5, 1, 7}, {0, 3, 2, 7}, {0, 6, 4, 7}};

class Marching {
 public:
  explicit Marching(const ScalarGrid& grid) : grid_(grid), area_(grid.nx * grid.ny) {
    for (auto& slots : vertex_) slots.assign(8 * area_, VertexId());
  }

  TriangleMesh run() {
    // Below the first layer and above the last there is one that is outside, in the same plane.
    for (layer_ = 0; layer_ <= grid_.z.size(); ++layer_) {
      for (std::size_t y = 0; y + 1 < grid_.ny; ++y) {
        for (std::size_t x = 0; x + 1 < grid_.nx; ++x) march(y * grid_.nx + x);
      }
      vertex_[layer_ % 2].assign(8 * area_, VertexId());
    }
    return std::move(mesh_);
  }

 private:
  [[nodiscard]] float value(std::size_t layer, std::size_t sample) const {
    if (layer == 0 || layer > grid_.z.size()) return kOutside;
    return grid_.value[(layer - 1) * area_ + sample];
  }
  [[nodiscard]] double height(std::size_t layer) const {
    return grid_.z[layer == 0 ? 0 : std::min(layer, grid_.z.size()) - 1];
  }
  [[nodiscard]] std::size_t sample(unsigned corner) const {
    return first_ + (corner & 1U) + (corner >> 1U & 1U) * grid_.nx;
  }

  void march(std::size_t first) {
    first_ = first;
    unsigned inside = 0;
    for (unsigned c = 0; c < 8; ++c) {
      corner_[c] = value(layer_ + (c >> 2U), sample(c));
      if (corner_[c] < 0) inside |= 1U << c;
    }
    if (inside == 0 || inside == 0xFF) return;
    for (const auto& tet : kTets) march_tet(tet);
  }

  // With k of the vertices inside; outward normals lead from the inside ones to the others.
  void march_tet(const unsigned (&tet)[4]) {
    std::array<unsigned, 4> in{}, out{};
    std::size_t k = 0, m = 0;
    for (unsigned i = 0; i < 4; ++i) {
      if (corner_[tet[i]] < 0) {
        in[k++] = i;
      } else {
        out[m++] = i;
      }
    }
    const auto at = [&](unsigned i, unsigned j) { return vertex(tet[i], tet[j]); };
    if (k == 1) {
      const auto& face = kFaceVertex[in[0]];
      add(at(in[0], local(face[0])), at(in[0], local(face[1])), at(in[0], local(face[2])));
    } else if (k == 3) {
      const auto& face = kFaceVertex[out[0]];
      add(at(out[0], local(face[2])), at(out[0], local(face[1])), at(out[0], local(face[0])));
    } else if (k == 2) {
      // (in, in, out, out) is an even order of the tet's vertices unless these are 02|13 or 13|02.
      if (in[0] + 2 == in[1]) std::swap(out[0], out[1]);
      const VertexId a = at(in[0], out[0]), b = at(in[0], out[1]);
      const VertexId c = at(in[1], out[1]), d = at(in[1], out[0]);
      add(a, b, c);
      add(a, c, d);
    }
  }
  static unsigned local(int i) { return static_cast<unsigned>(i); }

  void add(VertexId a, VertexId b, VertexId c) { mesh_.triangles.push_back({a, b, c}); }

  // Where the surface crosses the edge between two corners, one of which leads to the other.
  VertexId vertex(unsigned u, unsigned v) {
    if (u > v) std::swap(u, v);
    const std::size_t low = sample(u), high = sample(v);
    const std::size_t below = layer_ + (u >> 2U), above = layer_ + (v >> 2U);
    VertexId& id = vertex_[below % 2][8 * low + (v ^ u)];
    if (id.valid()) return id;
    const double a = corner_[u], b = corner_[v];
    // With the outside layers at infinity, the crossing is at the inside end.
    double t = 0;
    if (b == kOutside) {
      t = 0;
    } else if (a == kOutside) {
      t = 1;
    } else {
      t = a / (a - b);
    }
    const auto x = [&](std::size_t s) { return static_cast<double>(s % grid_.nx); };
    const auto y = [&](std::size_t s) { return static_cast<double>(s / grid_.nx); };
    id = mesh_.points.push_back({grid_.origin.x + grid_.step * (x(low) + t * (x(high) - x(low))),
                                 grid_.origin.y + grid_.step * (y(low) + t * (y(high) - y(low))),
                                 height(below) + t * (height(above) - height(below))});
    return id;
  }

  const ScalarGrid& grid_;
  std::size_t area_;
  std::size_t layer_ = 0;  // of the cells' lower corners; 0 is the one below the grid
  std::size_t first_ = 0;  // the sample at corner 0
  std::array<float, 8> corner_{};
  // By parity of the layer: for edges from sample s on in direction d (bits as of corners), the
  // vertex at 8 s + d.
  std::array<std::vector<VertexId>, 2> vertex_;
  TriangleMesh mesh_;
};

}  // namespace

TriangleMesh marching_tets(const ScalarGrid& grid) { return Marching(grid).run(); }

}  // namespace tetloft::bench

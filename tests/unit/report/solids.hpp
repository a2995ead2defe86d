// Solids, and what can be counted and measured of them without the report's code.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <map>
#include <set>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include <tetloft/io.hpp>
#include <tetloft/reconstruct.hpp>

namespace tetloft::test {

/// A block of three sections with a hollow in its middle, a hole through a second one, and a
/// third that stands alone.
inline const std::string kBlocks =
    "S 3\n"
    "v 12 z 0\n{ 0 0 8 0 8 8 0 8 }\n{ 20 0 28 0 28 8 20 8 }\n{ 23 3 25 3 25 5 23 5 }\n"
    "v 20 z 2\n{ 0 0 8 0 8 8 0 8 }\n{ 3 3 5 3 5 5 3 5 }\n{ 20 0 28 0 28 8 20 8 }\n"
    "{ 23 3 25 3 25 5 23 5 }\n{ 40 0 44 0 44 4 40 4 }\n"
    "v 16 z 5\n{ 0 0 8 0 8 8 0 8 }\n{ 20 0 28 0 28 8 20 8 }\n{ 23 3 25 3 25 5 23 5 }\n"
    "{ 40 0 44 0 44 4 40 4 }\n";

inline SectionStack stack_of(const std::string& text) {
  auto read = parse_cnt(text, "test.cnt");
  if (!read) throw std::invalid_argument(to_string(read.error()));
  return std::move(read->stack);
}

inline Model model_of(const SectionStack& stack) {
  auto made = reconstruct(stack);
  if (!made) throw std::invalid_argument(to_string(made.error()));
  return std::move(made->model);
}

/// Counted and measured the slow way, from the faces of tets that have no other tet.
struct Measured {
  std::size_t edges = 0;    ///< of all tets
  std::size_t surface = 0;  ///< triangles
  double area = 0;
  double volume = 0;  ///< by Gauss, from the surface alone
  long euler = 0;     ///< of the surface
  double shortest = 1e300, longest = 0;
};

/// Of the tets of one component, or of all (−1).
inline Measured measured(const Model& model, long component = -1) {
  using Key = std::array<std::uint32_t, 3>;
  std::map<Key, std::pair<int, std::array<std::uint32_t, 3>>> faces;
  std::set<std::pair<std::uint32_t, std::uint32_t>> edges;
  for (std::size_t t = 0; t < model.tets.size(); ++t) {
    if (component >= 0 && model.component[TetId(t)].value() != component) continue;
    std::array<std::uint32_t, 4> v{};
    for (std::size_t i = 0; i < 4; ++i) v[i] = model.tets[TetId(t)][i].value();
    // Each face as it is seen from outside a positive tet.
    for (const Key& f : {Key{v[1], v[2], v[3]}, Key{v[0], v[3], v[2]}, Key{v[0], v[1], v[3]},
                         Key{v[0], v[2], v[1]}}) {
      Key key = f;
      std::sort(key.begin(), key.end());
      auto& [count, outward] = faces[key];
      ++count;
      outward = f;
    }
    for (std::size_t i = 0; i < 4; ++i) {
      for (std::size_t j = i + 1; j < 4; ++j) edges.insert(std::minmax(v[i], v[j]));
    }
  }
  const auto at = [&](std::uint32_t v) { return model.points[VertexId(v)]; };
  const auto length = [&](std::uint32_t a, std::uint32_t b) {
    return std::hypot(at(b).x - at(a).x, at(b).y - at(a).y, at(b).z - at(a).z);
  };
  Measured result;
  result.edges = edges.size();
  for (const auto& [a, b] : edges) {
    result.shortest = std::min(result.shortest, length(a, b));
    result.longest = std::max(result.longest, length(a, b));
  }
  std::set<std::uint32_t> corners;
  std::set<std::pair<std::uint32_t, std::uint32_t>> borders;
  for (const auto& [key, face] : faces) {
    if (face.first != 1) continue;
    ++result.surface;
    const auto& [a, b, c] = face.second;
    corners.insert({a, b, c});
    for (const auto& [p, q] : {std::pair{a, b}, std::pair{b, c}, std::pair{a, c}}) {
      borders.insert(std::minmax(p, q));
    }
    // Heron.
    const double x = length(a, b), y = length(b, c), z = length(a, c);
    const double s = (x + y + z) / 2;
    result.area += std::sqrt(std::max(0.0, s * (s - x) * (s - y) * (s - z)));
    const Point3 p = at(a), q = at(b), r = at(c);
    result.volume += (p.x * (q.y * r.z - q.z * r.y) + p.y * (q.z * r.x - q.x * r.z) +
                      p.z * (q.x * r.y - q.y * r.x)) /
                     6;
  }
  result.euler = static_cast<long>(corners.size()) - static_cast<long>(borders.size()) +
                 static_cast<long>(result.surface);
  return result;
}

}  // namespace tetloft::test

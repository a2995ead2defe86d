// The half-faces of a tet soup, grouped by the three vertices of their face.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include <tetloft/tet_mesh.hpp>

#include "core/buckets.hpp"

namespace tetloft::internal::mesh_detail {

/// The vertices of a face by id, and which way its half-face lists them.
struct SortedFace {
  std::array<std::uint32_t, 3> vertex{};
  bool even = true;  ///< the outward order is an even permutation of the sorted one
};

template <class V>
[[nodiscard]] inline SortedFace sorted_face(const std::array<V, 4>& tet, std::size_t face) {
  SortedFace f;
  for (std::size_t k = 0; k < 3; ++k) {
    f.vertex[k] = tet[static_cast<std::size_t>(kFaceVertex[face][k])].value();
  }
  const auto order = [&f](std::size_t i, std::size_t j) {
    if (f.vertex[i] <= f.vertex[j]) return;
    std::swap(f.vertex[i], f.vertex[j]);
    f.even = !f.even;
  };
  order(0, 1);
  order(1, 2);
  order(0, 1);
  return f;
}

/// One half-face of a group.
struct FaceMember {
  std::uint64_t upper = 0;  ///< middle and highest vertex of the face
  HalfFaceId half_face;
  bool even = true;
};

/// Calls visit(lowest vertex, members) for each face of the tets 0 … tet_count − 1; members by
/// half-face id, faces by their sorted vertices. corners(t) are the four vertices of tet t, ids of
/// any one kind; sound(t) tells whether they are below vertex_count: other tets are left out.
/// Linear for bounded stars; a vertex of k tets costs k log k.
template <class Corners, class Sound, class Visit>
void for_each_face_group(std::size_t vertex_count, std::size_t tet_count, const Corners& corners,
                         const Sound& sound, Visit&& visit) {
  const auto lowest_vertex = [&](std::size_t h) -> std::size_t {
    if (!sound(h / 4)) return vertex_count;
    const auto& tet = corners(h / 4);
    const std::array<int, 3>& f = kFaceVertex[h % 4];
    return std::min({tet[static_cast<std::size_t>(f[0])], tet[static_cast<std::size_t>(f[1])],
                     tet[static_cast<std::size_t>(f[2])]})
        .index();
  };
  const Buckets by_lowest(vertex_count, 4 * tet_count, lowest_vertex);

  std::vector<FaceMember> members;
  for (std::size_t v = 0; v < vertex_count; ++v) {
    members.clear();
    for (const std::uint32_t h : by_lowest[v]) {
      const SortedFace f = sorted_face(corners(h / 4), h % 4);
      members.push_back({(std::uint64_t{f.vertex[1]} << 32) | f.vertex[2], HalfFaceId(h), f.even});
    }
    std::sort(members.begin(), members.end(), [](const FaceMember& a, const FaceMember& b) {
      return a.upper != b.upper ? a.upper < b.upper : a.half_face < b.half_face;
    });
    for (std::size_t i = 0; i < members.size();) {
      std::size_t j = i + 1;
      while (j < members.size() && members[j].upper == members[i].upper) ++j;
      visit(v, std::span<const FaceMember>(members.data() + i, j - i));
      i = j;
    }
  }
}

/// Of tets that are all sound.
inline constexpr auto kAllSound = [](std::size_t) { return true; };

/// Calls visit(half-face) for each face that one tet alone has; the rest as above.
template <class Corners, class Sound, class Visit>
void for_each_boundary_face(std::size_t vertex_count, std::size_t tet_count, const Corners& corners,
                            const Sound& sound, Visit&& visit) {
  for_each_face_group(vertex_count, tet_count, corners, sound,
                      [&](std::size_t, std::span<const FaceMember> members) {
                        if (members.size() == 1) visit(members[0].half_face);
                      });
}

}  // namespace tetloft::internal::mesh_detail

// Handles of the vertices of a triangulation that changes, and data by vertex.
#pragma once

#include <compare>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace tetloft {

/// A vertex of a DelaunayTriangulation3 or DelaunayTriangulation2. The place of a removed vertex is
/// used again; the generation tells the vertices of one place apart, so that a handle of one that
/// is gone names nothing. By default: none.
struct DelaunayVertex {
  static constexpr std::uint32_t kNone = 0xFFFFFFFFU;

  std::uint32_t index = kNone;   ///< the place, below vertex_slots()
  std::uint32_t generation = 0;  ///< how many vertices had it before

  [[nodiscard]] constexpr bool valid() const { return index != kNone; }
  friend constexpr auto operator<=>(const DelaunayVertex&, const DelaunayVertex&) = default;
};

/// Data of the caller by vertex, T() where none were given. Those of a vertex that is gone are not
/// found under the handle of the next one in its place.
template <class T>
class DelaunayVertexMap {
 public:
  /// Those of v, made where there are none. Requires a valid handle.
  [[nodiscard]] T& operator[](DelaunayVertex v) {
    if (v.index >= entries_.size()) entries_.resize(v.index + std::size_t{1});
    Entry& entry = entries_[v.index];
    if (!entry.given || entry.generation != v.generation) entry = {v.generation, true, T()};
    return entry.value;
  }
  /// Those of v, or null.
  [[nodiscard]] const T* find(DelaunayVertex v) const {
    if (v.index >= entries_.size()) return nullptr;
    const Entry& entry = entries_[v.index];
    return entry.given && entry.generation == v.generation ? &entry.value : nullptr;
  }

 private:
  struct Entry {
    std::uint32_t generation = 0;
    bool given = false;
    T value{};
  };
  std::vector<Entry> entries_;
};

}  // namespace tetloft

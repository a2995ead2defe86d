// The places of vertices that come and go: which are free, and how many vertices had each.
#pragma once

#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <vector>

#include <tetloft/delaunay_vertex.hpp>
#include <tetloft/result.hpp>

#include "core/provide_room.hpp"

namespace tetloft::internal {

struct VertexPlaces {
  std::vector<std::uint32_t> generation;  // by place
  std::vector<std::uint32_t> free;        // the next to be taken last

  [[nodiscard]] std::size_t size() const { return generation.size(); }
  /// Is v the latest that its place had? Whether it is there still, the owner knows.
  [[nodiscard]] bool is_latest(DelaunayVertex v) const {
    return v.index < size() && generation[v.index] == v.generation;
  }
  [[nodiscard]] DelaunayVertex handle(std::size_t place) const {
    return {static_cast<std::uint32_t>(place), generation[place]};
  }
  /// The place to be taken next, a new one where none is free.
  [[nodiscard]] std::size_t next(std::size_t most) {
    if (free.empty()) {
      if (size() >= most) throw std::length_error("too many vertices");
      free.reserve(1);
      provide_room(generation, 1);
      generation.push_back(0);
      give_back(size() - 1);
    }
    return free.back();
  }
  /// The next one has a vertex from now on.
  void take() { free.pop_back(); }
  /// Of a vertex whose handle nobody has seen.
  void give_back(std::size_t place) { free.push_back(static_cast<std::uint32_t>(place)); }
  /// Of a vertex that is gone.
  void release(std::size_t place) {
    ++generation[place];
    give_back(place);
  }
};

[[nodiscard]] inline Error no_such_vertex(DelaunayVertex v) {
  Error error{ErrorCode::invalid_input, "there is no such vertex, or no longer", {}};
  if (v.valid()) error.where.vertex = v.index;
  return error;
}

}  // namespace tetloft::internal

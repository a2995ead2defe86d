// Vertices shared out to the parts of space that they lie in.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include <tetloft/ids.hpp>

#include "delaunay3/growing_tets.hpp"
#include "delaunay3/partition.hpp"

namespace tetloft::internal::delaunay3_detail {

/// Gives the vertices before `end` their parts, and collects those of `vertices`, all before `end`,
/// by part.
class Shares {
 public:
  Shares(GrowingTets& tets, std::size_t end, std::span<const VertexId> vertices,
         const Partition& partition, unsigned threads);

  [[nodiscard]] std::size_t size() const { return begin_.size() - 1; }
  /// In the order of `vertices`.
  [[nodiscard]] std::span<const VertexId> operator[](Part part) const {
    return std::span(shared_).subspan(begin_[part], begin_[part + 1] - begin_[part]);
  }

 private:
  std::vector<VertexId> shared_;
  std::vector<std::size_t> begin_;  // by part, and the end
};

}  // namespace tetloft::internal::delaunay3_detail

// The nodes of a slab's solid in one numbering: slab vertices, then what is constructed, in the
// order in which it comes to be: lifted vertices, cuts, caps.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include <tetloft/ids.hpp>

#include "slab/numbering.hpp"

namespace tetloft::internal {

using NodeId = Id<struct NodeTag>;
/// A vertex that left its section plane: subdivision.hpp.
using LiftedId = Id<struct LiftedTag>;
/// A point on an edge that leaves a class: truncation.hpp.
using CutId = Id<struct CutTag>;
/// A copy of a region's vertex on the far side of a prism: embedding.hpp.
using CapId = Id<struct CapTag>;
/// Lifted vertices, cuts and caps in one sequence.
using ConstructedId = Id<struct ConstructedTag>;

/// How many nodes of each kind there are; a kind's ids need the counts of those before it only.
class Nodes {
 public:
  Nodes() = default;
  explicit Nodes(std::size_t slab_vertices, std::size_t lifted = 0, std::size_t cuts = 0)
      : first_lifted_(NodeId(slab_vertices).value()),
        first_cut_(NodeId(slab_vertices + lifted).value()),
        first_cap_(NodeId(slab_vertices + lifted + cuts).value()) {}

  [[nodiscard]] std::size_t slab_vertices() const { return first_lifted_; }
  /// All but caps.
  [[nodiscard]] std::size_t size_without_caps() const { return first_cap_; }

  [[nodiscard]] static NodeId of(SlabVertexId v) { return NodeId(v.value()); }
  [[nodiscard]] static std::array<NodeId, 4> of(const std::array<SlabVertexId, 4>& tet) {
    return {of(tet[0]), of(tet[1]), of(tet[2]), of(tet[3])};
  }
  [[nodiscard]] NodeId of(LiftedId k) const { return NodeId(first_lifted_ + k.value()); }
  [[nodiscard]] NodeId of(CutId k) const { return NodeId(first_cut_ + k.value()); }
  [[nodiscard]] NodeId of(CapId k) const { return NodeId(first_cap_ + k.value()); }
  [[nodiscard]] NodeId of(ConstructedId k) const { return NodeId(first_lifted_ + k.value()); }

  [[nodiscard]] bool is_slab_vertex(NodeId n) const { return n.value() < first_lifted_; }
  [[nodiscard]] bool is_constructed(NodeId n) const { return !is_slab_vertex(n); }
  [[nodiscard]] bool is_lifted(NodeId n) const {
    return n.value() >= first_lifted_ && n.value() < first_cut_;
  }
  [[nodiscard]] bool is_cut(NodeId n) const {
    return n.value() >= first_cut_ && n.value() < first_cap_;
  }
  [[nodiscard]] bool is_cap(NodeId n) const { return n.value() >= first_cap_; }

  /// Each requires a node of its kind.
  [[nodiscard]] static SlabVertexId slab_vertex(NodeId n) { return SlabVertexId(n.value()); }
  [[nodiscard]] LiftedId lifted(NodeId n) const { return LiftedId(n.value() - first_lifted_); }
  [[nodiscard]] CutId cut(NodeId n) const { return CutId(n.value() - first_cut_); }
  [[nodiscard]] CapId cap(NodeId n) const { return CapId(n.value() - first_cap_); }
  [[nodiscard]] ConstructedId constructed(NodeId n) const {
    return ConstructedId(n.value() - first_lifted_);
  }

 private:
  std::uint32_t first_lifted_ = 0;
  std::uint32_t first_cut_ = 0;
  std::uint32_t first_cap_ = 0;
};

}  // namespace tetloft::internal

// Numberings of a slab and of a stack, and the only places where one becomes another.
//
// A slab counts what its sections have in one sequence, the lower section's first; the vertices
// of a model count those of all sections in one sequence, from below. Ids of different numberings
// are different types.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include <tetloft/ids.hpp>

namespace tetloft::internal {

/// A vertex of a slab: of its lower section, then of its upper one, each by (x, y).
using SlabVertexId = Id<struct SlabVertexTag>;
/// A region of a slab: of its lower section, then of its upper one.
using SlabRegionId = Id<struct SlabRegionTag>;

/// The sections below and above a slab.
[[nodiscard]] constexpr SectionId lower_section(SlabId slab) { return SectionId(slab.value()); }
[[nodiscard]] constexpr SectionId upper_section(SlabId slab) { return SectionId(slab.value() + 1); }
[[nodiscard]] constexpr SectionId section_of(SlabId slab, bool upper) {
  return upper ? upper_section(slab) : lower_section(slab);
}

/// Ids of one kind from two sections, and of the slab between.
template <class InSection, class InSlab>
class SlabNumbering {
 public:
  SlabNumbering() = default;
  SlabNumbering(std::size_t lower, std::size_t upper)
      : lower_(InSlab(lower).value()), size_(InSlab(lower + upper).value()) {}

  [[nodiscard]] std::size_t size() const { return size_; }
  [[nodiscard]] std::size_t lower_size() const { return lower_; }
  [[nodiscard]] std::size_t upper_size() const { return size_ - lower_; }
  [[nodiscard]] bool is_upper(InSlab id) const { return id.value() >= lower_; }
  [[nodiscard]] InSection in_section(InSlab id) const {
    return InSection(is_upper(id) ? id.value() - lower_ : id.value());
  }
  [[nodiscard]] InSlab in_slab(bool upper, InSection id) const {
    return InSlab(upper ? id.value() + lower_ : id.value());
  }

 private:
  // Both are ids, behind the last: sums of ids below them need no look at 32 bits.
  std::uint32_t lower_ = 0;
  std::uint32_t size_ = 0;
};

using SlabVertices = SlabNumbering<PlaneVertexId, SlabVertexId>;
using SlabRegions = SlabNumbering<RegionId, SlabRegionId>;

/// The vertices of sections in one sequence, as a model numbers them.
class StackVertices {
 public:
  void add_section(std::size_t vertices) {
    first_.push_back(VertexId(first_.back() + vertices).value());
  }
  [[nodiscard]] std::size_t size() const { return first_.back(); }
  [[nodiscard]] VertexId of(SectionId section, PlaneVertexId vertex) const {
    return VertexId(first_[section.index()] + vertex.value());
  }

 private:
  std::vector<std::uint32_t> first_{0};
};

}  // namespace tetloft::internal

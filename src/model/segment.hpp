// Models of slabs next to each other, from below, become the model of all, number for number as
// gluing makes it: vertices by section, then constructed ones by slab; tets by slab.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include <tetloft/model.hpp>
#include <tetloft/result.hpp>

namespace tetloft::internal {

/// The slabs first … end − 1 of a stack, and their sections, first … end. Of a stack of one
/// section, which has no slab, both are 0, and all its tets are meant.
struct SlabRange {
  std::size_t first = 0;
  std::size_t end = 0;
  [[nodiscard]] bool holds(SlabId slab) const {
    return first == end || (slab.index() >= first && slab.index() < end);
  }
  /// Is a slab in both?
  [[nodiscard]] bool meets(const SlabRange& other) const {
    return first < other.end && other.first < end;
  }
  friend bool operator==(const SlabRange&, const SlabRange&) = default;
};

/// Ids first … end − 1.
struct IndexRange {
  std::size_t first = 0;
  std::size_t end = 0;
  [[nodiscard]] std::size_t size() const { return end - first; }
};

/// What a segment, the next one of all, adds to the whole.
struct AddedSegment {
  IndexRange section_vertices;        ///< of the model, in order
  std::vector<VertexId> constructed;  ///< likewise
  IndexRange tets;                    ///< likewise
  /// By vertex of the model its number in the whole: of a section's vertices that number, of the
  /// k-th constructed one −1 − k, since what comes before these is known at the end alone. kNone:
  /// it is not taken.
  std::vector<std::int64_t> number;
  static constexpr std::int64_t kNone = INT64_MIN;
};

class SegmentNumbers {
 public:
  /// Of slabs from this one on.
  explicit SegmentNumbers(std::size_t first_slab = 0) : slabs_(first_slab) {}

  /// Takes the tets of these slabs, which follow those before, out of a model that is numbered as
  /// gluing does it, its ids of slabs and sections those of the whole. Refused (invalid_input) is
  /// one that is not, or whose first section is not as the last one before, bit for bit.
  [[nodiscard]] Result<AddedSegment> add(const Model& model, const SlabRange& slabs);

  /// Of all sections so far.
  [[nodiscard]] std::size_t section_vertices() const { return section_vertices_; }
  [[nodiscard]] std::size_t constructed() const { return constructed_; }
  [[nodiscard]] std::size_t vertices() const { return section_vertices_ + constructed_; }
  [[nodiscard]] std::size_t tets() const { return tets_; }
  /// Where the next segment begins.
  [[nodiscard]] std::size_t slabs() const { return slabs_; }

  /// Of AddedSegment::number, when all are added.
  [[nodiscard]] std::int64_t vertex(std::int64_t number) const {
    return number >= 0 ? number : static_cast<std::int64_t>(section_vertices_) - 1 - number;
  }

 private:
  // A vertex of the last section, as it must be in the next segment.
  struct Seam {
    Point3 point;
    ContourId contour;
    PointOrigin origin;
  };
  [[nodiscard]] bool fits_seam(const Model& model, const IndexRange& section) const;

  std::size_t section_vertices_ = 0;
  std::size_t constructed_ = 0;
  std::size_t tets_ = 0;
  std::size_t slabs_;  // the next one
  bool any_ = false;
  std::vector<Seam> seam_;
};

/// The tables' rows of these slabs, at the end of the whole's.
void append_rows(const Model& model, const SlabRange& slabs, Model& whole);

/// All in memory: the segments' model.
class JoinedModel {
 public:
  /// Of slabs from this one on.
  explicit JoinedModel(std::size_t first_slab = 0) : numbers_(first_slab) {}

  [[nodiscard]] Result<void> add(const Model& model, const SlabRange& slabs);
  /// With component_count, frame and texts of the first.
  [[nodiscard]] Model take();

 private:
  SegmentNumbers numbers_;
  Model whole_;        // tets without vertices
  Model constructed_;  // their vertices
  std::vector<std::array<std::int64_t, 4>> tets_;
};

}  // namespace tetloft::internal

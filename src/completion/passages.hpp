// Passages between voids that do not belong together, and the walls that close them.
//
// A *passage* is a part of the void (void_space.hpp) that touches two void classes. It is closed by
// the least cut of a flow network over its tets, nearest to the one class: by tets whose four
// corners are of one solid class, or of which what they share with a neighbour or a plane is. The
// class keeps the tets of the cut. So a wall belongs to one class and joins nothing.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "completion/completion.hpp"
#include "completion/void_space.hpp"

namespace tetloft::internal {

/// Two voids of different classes that no wall can part.
using Inseparable = std::array<SlabVoidId, 2>;

class Passages {
 public:
  /// All must outlive this.
  Passages(const Slab& slab, const SlabClasses& classes,
           const IdVector<ClassId, std::uint8_t>& active, const SlabVoids& voids,
           Completion& completion);

  /// Closes passages, the lowest first, until none is left; or returns two voids that cannot be
  /// parted.
  [[nodiscard]] std::optional<Inseparable> close();
  /// How many were closed.
  [[nodiscard]] std::uint64_t closed() const { return closed_; }

 private:
  enum class Protect : std::uint8_t { linked, nothing };

  [[nodiscard]] std::vector<VoidClassId> classes_at(const std::vector<TetId>& part) const;
  [[nodiscard]] std::optional<Inseparable> part_off(const std::vector<TetId>& part,
                                                    VoidClassId from);
  void protect_linked(const std::vector<TetId>& part);
  void protect_class(const std::vector<TetId>& part, VoidClassId c);
  [[nodiscard]] double open_area(TetId t) const;
  [[nodiscard]] double face_area(TetId t, int face) const;

  const Slab& slab_;
  const SlabClasses& classes_;
  const IdVector<ClassId, std::uint8_t>& active_;
  const SlabVoids& voids_;
  Completion& completion_;
  VoidSpace space_;
  std::uint64_t closed_ = 0;
  // Of the tets of the current part.
  IdVector<TetId, std::uint32_t> place_;
  IdVector<TetId, std::uint8_t> is_protected_;

  friend class PassageCut;
};

}  // namespace tetloft::internal

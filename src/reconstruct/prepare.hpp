// A stack in the unit of length that its model is made in, with its conforming sections.
#pragma once

#include <optional>
#include <vector>

#include <tetloft/conforming_section.hpp>
#include <tetloft/nesting.hpp>
#include <tetloft/reconstruct.hpp>
#include <tetloft/valid_stack.hpp>

#include "core/watched_work.hpp"
#include "slab/link.hpp"

namespace tetloft::internal {

/// In which unit of length a model is made: README.md, "Scale".
enum class Unit : std::uint8_t { of_the_stack, as_given };

/// A stack as handed in, which must outlive this, and its nestings where it is known to be valid.
struct GivenStack {
  GivenStack(const SectionStack& unchecked) : stack(&unchecked) {}
  GivenStack(const ValidStack& valid) : stack(&valid.stack()), nestings(&valid.nestings()) {}

  const SectionStack* stack;
  const IdVector<SectionId, Nesting>* nestings = nullptr;
};

/// A section next to a window of a longer stack, and the slab between them.
struct BeyondWindow {
  Section section;
  Nesting nesting;
  std::vector<Link> links;  ///< of that slab's regions, accepted
};

/// What is decided about voids rests on more than a window.
struct OfWhole {
  double far_outside = 0;  ///< sections/complement.hpp
  bool has_hole = false;
};

struct PreparedStack {
  SectionStack stack;  ///< times 2^exponent
  int exponent = 0;
  IdVector<SectionId, Nesting> nestings;
  IdVector<SectionId, ConformingSection> sections;
  /// What the sections were conformed with.
  IdVector<SectionId, std::vector<EdgeDivision>> divisions;
  std::vector<Warning> warnings;  ///< of coarse contours that are not divided
  double work_limit = kDefaultWorkLimit;
  /// Edges of coarse contours are long above this (sections/coarse_edges.hpp), if they are to be
  /// divided.
  std::optional<double> least_long;
  /// Of a window of a longer stack: the number of its first section there, and the sections beyond
  /// it.
  std::size_t first_section = 0;
  /// And of one that is decided about.
  std::optional<OfWhole> of_whole;
  std::optional<BeyondWindow> beyond_below;
  std::optional<BeyondWindow> beyond_above;

  [[nodiscard]] std::size_t section_count() const { return stack.sections.size(); }
  /// Requires a section, as validate() does.
  [[nodiscard]] std::size_t slab_count() const { return section_count() - 1; }

  /// Conforms a section; the edges of the given contours become Gabriel (empty: none), `apart` and
  /// `divided` are as in ConformOptions. Leaves it as it was where that fails.
  [[nodiscard]] std::optional<Error> conform_section(SectionId s,
                                                     const IdVector<ContourId, bool>& gabriel = {},
                                                     const std::vector<Point2>& apart = {},
                                                     const std::vector<EdgeDivision>& divided = {});

  /// The sections below and above, those beyond too.
  [[nodiscard]] std::vector<const Section*> neighbours(SectionId s) const;

  /// Gives up a section's triangles and edges and what leads along contours, which take more memory
  /// than all else together. The vertices stay, their contours and regions, and which triangles
  /// were inside.
  void release_triangulation(SectionId s);
  [[nodiscard]] bool is_triangulated(SectionId s) const {
    return sections[s].vertex_count() == 0 || !sections[s].edges.empty();
  }
};

/// Conforms all sections of a stack with nestings, coarse contours divided where `least_long` says
/// so and that can be done; each a step of the work.
[[nodiscard]] std::optional<Error> conform_all(PreparedStack& prepared, unsigned threads,
                                               WatchedWork& work);

/// Are the sections needed as conforming ones?
enum class Conform : std::uint8_t { all, none };

/// Validates, unless that was done, nests and conforms all sections, coarse contours divided if the
/// options say so, each a step of the work. Errors are in the unit given.
[[nodiscard]] Result<PreparedStack> prepare(const GivenStack& given, Unit unit,
                                            const ReconstructOptions& options, WatchedWork& work,
                                            Conform conform = Conform::all);

}  // namespace tetloft::internal

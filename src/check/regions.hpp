// The regions of a stack as the rule of tetloft/correspondence.hpp looks at them, and links between
// them. Written for `check` alone: what recomputes the rule shares no line with the
// reconstruction's own.
#pragma once

#include <cstddef>
#include <limits>
#include <optional>
#include <vector>

#include <tetloft/nesting.hpp>
#include <tetloft/overlap.hpp>
#include <tetloft/section_stack.hpp>

#include "check/box_tree.hpp"

namespace tetloft::internal::checking {

/// Two regions of neighbouring sections; the slab follows from the lower one. The order is
/// that of rule 6: (slab, lower region, upper region).
struct Link {
  std::size_t lower = 0;
  std::size_t upper = 0;
  friend auto operator<=>(const Link&, const Link&) = default;
};

/// Regions of all sections in one sequence, by (section, region).
struct Regions {
  std::vector<Nesting> nesting;      ///< per section
  std::vector<std::size_t> first;    ///< per section; the number of regions at the end
  std::vector<double> z;             ///< per section
  std::vector<BoxTree> tree;         ///< per section, of its regions' boxes
  std::vector<std::size_t> section;  ///< per region
  std::vector<RegionOutline> shape;  ///< per region
  std::vector<Box2> box;             ///< per region, of the outer contour

  [[nodiscard]] std::size_t size() const { return section.size(); }
  [[nodiscard]] std::size_t section_count() const { return z.size(); }
  [[nodiscard]] std::size_t of(std::size_t s, std::size_t contour) const {
    return first[s] + nesting[s].region[ContourId(contour)].index();
  }
  /// Is contour c the outer one of its region?
  [[nodiscard]] bool is_outer(std::size_t s, std::size_t contour) const;

  /// The distance of two sections.
  [[nodiscard]] double gap(std::size_t s, std::size_t t) const;
  [[nodiscard]] double gap(const Link& link) const {
    return gap(section[link.lower], section[link.upper]);
  }
  /// r.
  [[nodiscard]] double ratio(const Link& link) const {
    return overlap_ratio(shape[link.lower], shape[link.upper]);
  }
  /// d, unless it is more than `most`.
  [[nodiscard]] std::optional<double> distance(
      const Link& link, double most = std::numeric_limits<double>::infinity()) const;

  /// Calls visit(q) for the regions q of section s whose boxes meet this one.
  template <class Visit>
  void for_each_meeting(std::size_t s, const Box2& near, Visit&& visit) const {
    tree[s].meeting(near, [&](std::uint32_t q) {
      visit(first[s] + q);
      return true;
    });
  }
};

/// The stack must outlive them.
[[nodiscard]] Regions number_regions(const SectionStack& stack);

[[nodiscard]] Box2 bounding_box(const Contour& contour);
/// A box that holds all that is no farther from this one than `by`, along either axis.
[[nodiscard]] Box2 surroundings(const Box2& box, double by);
/// The link of two regions of neighbouring sections, whichever is given first.
[[nodiscard]] Link link_between(std::size_t a, std::size_t b);

/// Per region, the regions of the section above that links join it to, and of the one below.
struct LinkedRegions {
  LinkedRegions(std::size_t regions, const std::vector<Link>& links);
  std::vector<std::vector<std::size_t>> up, down;
};

}  // namespace tetloft::internal::checking

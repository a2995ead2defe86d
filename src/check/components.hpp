#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "check/findings.hpp"
#include "check/partition.hpp"
#include "check/regions.hpp"
#include "check/resampling.hpp"
#include "check/view.hpp"
#include "core/union_find.hpp"

namespace tetloft::internal::checking {

/// The face-connected components of a solid that is shown as a whole, or segment by segment, and
/// which contours they lie on.
class SolidComponents {
 public:
  explicit SolidComponents(const ContourNumbers& numbers);

  /// Those of a view that is no seam; returns the number of the first. They grow together at seams.
  std::uint32_t add(const ModelView& view);
  void unite(std::uint32_t a, std::uint32_t b) { sets_.unite(a, b); }
  /// Tets of the view on the contours of `on`; by sound tet its component. Views come in order of
  /// their tets, for each contour.
  void meet(const ModelView& view, const OnContours& on, std::span<const std::uint32_t> component);

  [[nodiscard]] std::size_t count() const;
  [[nodiscard]] const ContourNumbers& numbers() const { return numbers_; }
  /// The component of each contour, that of the first tet there is; none: OnContours::kNone.
  /// Reports 4.1 and 4.2.
  [[nodiscard]] std::vector<std::uint32_t> of_contours(Findings& findings) const;

 private:
  const ContourNumbers& numbers_;
  UnionFind sets_{0};
  std::vector<TetId> first_tet_;                               // by component
  std::vector<std::uint8_t> has_contour_;                      // likewise
  std::vector<std::uint32_t> first_;                           // by contour
  std::vector<std::pair<std::uint32_t, std::uint32_t>> more_;  // a contour, and another component
};

struct Components {
  Findings findings;
  std::size_t dropped_links = 0;
  /// What the correspondence is, where it can be recomputed.
  struct Expected {
    std::vector<Link> links;  ///< those accepted, sorted
    std::size_t components = 0;
  };
  std::optional<Expected> expected = std::nullopt;
};

/// Guarantee 4, conditions 4.1 to 4.8 of README.md: the face-connected components of the
/// model part the contours as the correspondence says. `refined`: as check_resampling() makes it.
/// Refused where labels are invalid.
[[nodiscard]] Result<Components> check_components(const SolidComponents& components,
                                                  const SectionStack& stack,
                                                  const SectionStack& refined, const Claims& claims,
                                                  const CheckOptions& options);

}  // namespace tetloft::internal::checking

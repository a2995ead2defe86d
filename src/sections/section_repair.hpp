// Repair of one section: the region by a fill rule of contours that are not simple or touch, as
// contours that are and do not.
//
// The contours that have a contact are taken apart into their arrangement; of its pieces those
// are the boundary that have the region on one side only.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <tetloft/repair.hpp>
#include <tetloft/result.hpp>

#include "sections/arrangement.hpp"
#include "sections/copies.hpp"
#include "sections/region_sides.hpp"

namespace tetloft::internal::sections {

class SectionRepair {
 public:
  struct Options {
    double distance = 0;
    FillRule fill = FillRule::odd;
    std::optional<double> keyholes;
  };

  /// Of the section times 2^exponent: what run() returns is, too; what is told is not.
  SectionRepair(const Section& section, std::size_t number, const Options& options, int exponent);

  [[nodiscard]] Result<Section> run();

  /// Adds what was done and found.
  void report(Repaired& result) const;

 private:
  [[nodiscard]] Error refusal(const std::string& why) const;
  void tell(const std::string& message, ContourId contour, std::optional<Point2> p);
  [[nodiscard]] std::string length_text(double scaled_length) const;

  void find_contacts();
  void leave_out_copies();
  void tell_events();
  void tell_overlaps(const RegionSides& sides);
  void find_area_before(const RegionSides& sides);
  void find_lost(const RegionSides& sides);
  void add_edges();
  [[nodiscard]] Result<Section> retrace(const RegionSides& sides);
  [[nodiscard]] Section with_traced(const RegionSides& sides,
                                    const std::vector<std::pair<ContourId, Contour>>& traced);
  [[nodiscard]] Section without_channels(Section section);

  Section section_;
  std::size_t number_;
  Options options_;  // lengths times 2^exponent
  int exponent_;
  double moved_ = 0;
  double area_before_ = 0;
  double area_after_ = 0;
  std::size_t channels_ = 0;
  std::vector<bool> dirty_;  // by contour: in the arrangement
  std::vector<bool> left_out_;
  std::vector<std::pair<ContourId, ContourId>> contacts_;  // a contour with itself, too
  std::vector<Copy> copies_;
  Arrangement arrangement_;
  IdVector<ContourId, ContourId> origin_;  // of what is left: the given contour it begins with
  std::vector<LostBody> lost_;
  std::vector<Warning> changes_;
};

}  // namespace tetloft::internal::sections

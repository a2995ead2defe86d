// The nodes of a given layer: they come from its contours, not from samples, which would lose what
// is thinner than the lattice.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include <tetloft/ids.hpp>
#include <tetloft/nesting.hpp>
#include <tetloft/section_stack.hpp>

#include "between/layer_labels.hpp"
#include "motion/lattice_window.hpp"

namespace tetloft::internal::between {

/// A class in one of the slab's sections, on the lattice.
struct GivenRegions {
  const Section& section;
  const Nesting& nesting;
  const std::vector<RegionId>& regions;
  double step = 0;
};

class GivenLabels {
 public:
  GivenLabels(const GivenRegions& given, const motion::LatticeWindow& window);

  /// Node n is regions[n]. It has the samples within it, and those nearer to it than 0.72 steps
  /// that are in none; or one sample of another region's, if that can spare it.
  [[nodiscard]] const LayerLabels& solids() const { return solids_; }
  /// The exterior, and each hole contour with what is in it and in none of the regions inside that
  /// hole. Made anew each time.
  [[nodiscard]] LayerLabels voids() const;

 private:
  /// A contour of the class, in lattice units.
  struct LatticeContour {
    std::vector<Point2> vertices;
    std::uint32_t solid = 0;       // of its region
    std::uint32_t hole = kNoNode;  // none of outer contours
    std::uint32_t depth = 0;
  };
  /// The contours around a sample, as a row is run through.
  class Around;

  void add_contours(const GivenRegions& given);
  template <class Visit>
  void visit_runs(const Visit& visit) const;
  [[nodiscard]] std::vector<LabelledRun> samples_beside(const std::vector<LabelledRun>& runs) const;
  void give_one_each();

  motion::LatticeWindow window_;
  std::vector<LatticeContour> contours_;  // by their lowest vertices
  std::size_t holes_ = 0;
  LayerLabels solids_;
};

}  // namespace tetloft::internal::between

// What is measured of every run of a method on a stack.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include <tetloft/sections.hpp>

#include "comparison/methods.hpp"
#include "comparison/surface_distance.hpp"
#include "comparison/truth.hpp"
#include "corpus/union_errors.hpp"

namespace tetloft::bench {

/// A stack with where it comes from and what is known of it.
struct Subject {
  std::string name;
  std::string set;   ///< "corpus", or the folder
  std::string kind;  ///< of solid; empty for folders, as the next two
  std::size_t spacing = 0;
  std::string contouring;
  SectionStack stack;
  /// By slab, the pieces of its regions, as SlicedSolid::piece; empty where they are not known.
  std::vector<std::vector<std::size_t>> piece = {};
};

/// Truth, ready to be compared with; shared by all stacks of the same extent.
struct Reference {
  explicit Reference(Truth known);
  Truth truth;
  std::optional<SurfaceSearch> search;
};

struct Run {
  std::string method;
  std::string refusal;  ///< empty: made, and all below is set
  double seconds = 0;
  std::size_t tets = 0;  ///< 0 of mere surfaces
  /// Verdicts of check() on the five guarantees, as far as they are asked of the method; none for
  /// mere surfaces.
  std::optional<std::array<bool, 5>> guarantees;
  /// All guarantees hold, the last two only if the method has a criterion; none as above.
  std::optional<bool> valid;
  /// Exceptions from guarantee 5 that the model lists: deviations, and links of voids that were
  /// forced or could not be realised. None where that guarantee is not asked.
  std::optional<long> exceptions;
  std::size_t singular_vertices = 0;
  std::size_t singular_edges = 0;
  double deviation = 0;  ///< section_deviation()
  std::size_t lost = 0;  ///< lost_contours()
  /// Of the method's links against the pieces, where both are known.
  std::optional<UnionErrors> links;
  Topology topology;
  double volume = 0;
  // Against the truth, as far as that is known. Errors are absolute, of the volume relative.
  std::optional<long> component_error, cavity_error, genus_error;
  std::optional<double> volume_error;
  std::optional<SurfaceDistance> distance;
};

/// Runs the method and measures what it makes. `samples`: points on each surface.
[[nodiscard]] Run measure_run(const Method& method, const Subject& subject,
                              const Reference& reference, std::size_t samples);

/// Runs of one method taken together. Refused ones count as not valid, and in nothing else.
struct Aggregate {
  std::size_t stacks = 0;
  std::size_t refused = 0;
  std::optional<double> right_topology;  ///< share, where truth tells components, cavities or genus
  std::optional<double> valid;           ///< share of all stacks
  std::optional<double> resampled;       ///< share of all stacks with guarantee 2
  std::optional<double> defined;         ///< share of all stacks with guarantee 5
  std::optional<long> exceptions;        ///< sum
  std::size_t singular_vertices = 0, singular_edges = 0;
  std::size_t lost = 0;
  double deviation = 0;                                               ///< mean
  std::optional<UnionErrors> links;                                   ///< sums
  std::optional<long> component_errors, cavity_errors, genus_errors;  ///< sums
  std::optional<double> volume_error, mean_distance, hausdorff;       ///< means
  std::size_t tets = 0;                                               ///< sum
  double seconds_per_10k = 0;  ///< per 10,000 input vertices, of the sums
};

/// A run with the number of input vertices of its stack.
struct SizedRun {
  const Run* run = nullptr;
  std::size_t vertices = 0;
};
[[nodiscard]] Aggregate aggregate(const std::vector<SizedRun>& runs);

}  // namespace tetloft::bench

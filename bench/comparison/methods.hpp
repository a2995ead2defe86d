// The methods compared: a table {name, what check is to ask, run}.
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include <tetloft/correspondence.hpp>
#include <tetloft/model.hpp>
#include <tetloft/sections.hpp>

#include "comparison/triangle_mesh.hpp"

namespace tetloft::bench {

/// What a method made of a stack.
struct Outcome {
  std::string refusal;         ///< why there is nothing; empty if there is
  std::optional<Model> model;  ///< of tets; none where the method makes a mere surface
  TriangleMesh surface;        ///< where there is no model
  /// A contour is kept if the surface passes one of its vertices within this.
  double tolerance = 0;
  double seconds = 0;  ///< wall clock, of one thread
};

struct Method {
  std::string name;
  /// What guarantees 4 and 5 are judged by; none: the method has no criterion, they are not asked.
  std::optional<CorrespondenceOptions> correspondence;
  std::function<Outcome(const SectionStack&)> run;
};

/// tetloft's own method; `between` as in ReconstructOptions.
[[nodiscard]] Method tetloft_by(std::string name, const CorrespondenceOptions& correspondence,
                                std::optional<std::size_t> between = 0);
/// Geiger's.
[[nodiscard]] Method geiger();

/// `between`: further methods, with so many sections put between two.
[[nodiscard]] std::vector<Method> all_methods(const std::vector<std::size_t>& between = {});

}  // namespace tetloft::bench

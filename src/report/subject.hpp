// A model as the report looks at it: its sound tets, whatever else is wrong with it, and to which
// component each of them and of the faces of its surface belongs.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <tetloft/model.hpp>
#include <tetloft/result.hpp>
#include <tetloft/section_stack.hpp>
#include <tetloft/tet_mesh.hpp>

#include "check/view.hpp"

namespace tetloft::internal::report {

struct Subject {
  const Model& model;
  const SectionStack* stack;  ///< null: none was given

  /// The model's, and what it does not tell the stack's.
  Description about = {};
  std::vector<double> planes =
      {};  ///< z of the stack's sections, else of those that the model names
  checking::ModelView view = {};
  SurfaceComponents surface = {};             ///< of view.boundary
  std::vector<std::uint32_t> behind = {};     ///< of each boundary face, its tet in view.tets
  std::vector<std::uint32_t> component = {};  ///< of each tet of view.tets
  std::vector<std::string> names = {};        ///< of the components
  Point3 low = {}, high = {};                 ///< the box of the vertices in use
  /// Lengths in the file are those of the stack. Else its axes are skew, or have other units.
  bool is_rigid = true;

  [[nodiscard]] bool is_whole() const {  ///< its boundary is a closed surface
    return view.malformed.empty() && view.crowded_faces.empty() && view.doubled_faces.empty();
  }
};

/// Error invalid_input as render_report(). Model and stack must outlive the subject.
[[nodiscard]] Result<Subject> subject_of(const Model& model, const SectionStack* stack);

}  // namespace tetloft::internal::report

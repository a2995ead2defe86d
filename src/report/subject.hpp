// A model as the report looks at it: its sound tets, whatever else is wrong with it, and to which
// component each of them and of the faces of its surface belongs.
#pragma once

#include <algorithm>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

#include <tetloft/model.hpp>
#include <tetloft/result.hpp>
#include <tetloft/section_stack.hpp>
#include <tetloft/tet_mesh.hpp>

#include "check/view.hpp"

namespace tetloft::internal::report {

/// An edge as one number, whichever end comes first: the lower one is in the upper half.
[[nodiscard]] inline std::uint64_t edge_key(VertexId a, VertexId b) {
  return std::uint64_t{std::min(a, b).value()} << 32 | std::max(a, b).value();
}

/// The box of points; of none nothing is in it.
struct Box3 {
  Point3 low{kBeyond, kBeyond, kBeyond};
  Point3 high{-kBeyond, -kBeyond, -kBeyond};
  void include(const Point3& p) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
  }

 private:
  static constexpr double kBeyond = std::numeric_limits<double>::infinity();
};

struct Subject {
  const Model& model;
  const SectionStack* stack;  ///< null: none was given

  /// The model's, and what it does not tell the stack's.
  Description about = {};
  /// z of the stack's sections, else of all vertices that the model puts into sections.
  std::vector<double> planes = {};
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

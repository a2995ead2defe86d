// A solid by its components, as the files of simulation programs want it: to each a number, a name,
// its tets and its part of the boundary; and the way back, from the groups of such a file.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include <tetloft/model.hpp>

#include "io/warning_list.hpp"

namespace tetloft::internal::io {

/// Of a model that tells no components all tets are of the first.
[[nodiscard]] ComponentId component_at(const Model& model, TetId tet);
/// The number of a component in files, from 1 on, as in its name; 0 of tets that are of none.
[[nodiscard]] inline std::int64_t component_tag(ComponentId component) {
  return component.valid() ? std::int64_t{component.value()} + 1 : 0;
}
/// component_name(); of tets without component "no component".
[[nodiscard]] std::string group_name(const Model& model, ComponentId component);

struct ComponentGroup {
  ComponentId component;  ///< invalid: the tets that are of none
  std::string name;       ///< group_name()
  std::vector<TetId> tets;
  /// Faces of its tets that no other tet has, outward. A face between two components is of neither.
  std::vector<TriangleVertices> triangles;

  [[nodiscard]] std::int64_t tag() const { return component_tag(component); }
};

/// Those that have tets, by number, the tets of none last; tets and triangles in the order of the
/// model. A model that tells no components is one. Requires a well formed model.
[[nodiscard]] std::vector<ComponentGroup> component_groups(const Model& model);

/// Sets component_count as the components of the tets say.
void count_components(Model& model);

/// Makes negative tets positive, which a warning counts, as another does those without volume. The
/// points are finite.
void turn_positive(Model& model, WarningList& warnings);

/// Puts a model together from tets in groups, such as other programs write.
class GroupedSolid {
 public:
  /// The corners are points, or will be.
  void add_tet(const TetVertices& corners, std::int64_t group) {
    tets_.push_back(corners);
    groups_.push_back(group);
  }
  [[nodiscard]] std::size_t size() const { return tets_.size(); }

  /// The model of `points`, which are finite. Groups become components, in the order of their
  /// numbers, with the names that `names` has for them (valid UTF-8); without any tet in a group
  /// of a number other than kNoGroup the model has no components. Tets are positive:
  /// turn_positive().
  [[nodiscard]] Model take(IdVector<VertexId, Point3> points,
                           const std::map<std::int64_t, std::string>& names, WarningList& warnings);

  /// The group of tets that are in none, in the files that are read as well.
  static constexpr std::int64_t kNoGroup = 0;

 private:
  IdVector<TetId, TetVertices> tets_;
  std::vector<std::int64_t> groups_;  // by tet
};

}  // namespace tetloft::internal::io

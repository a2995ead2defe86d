// One model of the viewer's page: what is told of it, and its arrays.
#pragma once

#include <cstddef>
#include <string>

#include <tetloft/model.hpp>
#include <tetloft/render.hpp>

#include "core/watched_work.hpp"
#include "io/json_write.hpp"
#include "render/subject.hpp"

namespace tetloft::internal::render {

/// A model, its own coordinates taken between the two spaces of a page. Points of a page are in the
/// model's own coordinates, those of its stack, about its own centre, so that a section is a plane
/// of one height exactly; the space of the page, where models lie beside each other as in their
/// files, follows by the linear part of the frame and a shift.
struct PageLayer {
  const Model* model = nullptr;
  std::string name;
  Subject subject;

  /// The exponent for which all that is placed stays near 1.
  [[nodiscard]] int placed_exponent() const;
  /// Where a point of the subject lies in the file, times 2^−exponent, heights stretched.
  [[nodiscard]] Point3 placed(const Point3& p, int exponent) const;
};

/// The space that the models of a page share: that of their files, about a centre, in units of half
/// the diagonal of all.
struct PageSpace {
  int exponent = 0;  ///< centre and scale are times 2^−exponent
  Point3 centre;
  double scale = 1;
};

/// The arrays of a layer, one step of the work each.
inline constexpr std::size_t kPageArrays = 11;

/// What is told of a layer, as a JSON object.
void add_page_layer_header(io::JsonWriter& json, const PageLayer& layer, const PageSpace& space,
                           double stretch);
/// A plane of the stack's coordinates in those of the layer.
[[nodiscard]] double page_layer_cut(const PageLayer& layer, const PageSpace& space,
                                    const PictureCut& cut, double stretch);
/// Appends the layer's arrays, as elements "array-NUMBER-WHAT"; tells `work` of kPageArrays steps.
void append_page_layer(std::string& page, std::size_t number, const PageLayer& layer,
                       const PageSpace& space, WatchedWork& work);

}  // namespace tetloft::internal::render

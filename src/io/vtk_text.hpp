// What VTK files tell in words of a model: arrays of bytes, which are UTF-8, as data of the whole
// grid. Not arrays of type String, which few readers beside VTK's own take.
#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include <tetloft/model.hpp>

#include "io/description_texts.hpp"
#include "io/vtk_write.hpp"

namespace tetloft::internal::io {

/// Its names have a zero byte between two of them.
inline constexpr std::string_view kComponentNames = "component_names";
/// The names of all such arrays.
inline constexpr auto kTextArrays = [] {
  std::array<std::string_view, kDescriptionTexts.size() + 1> all;
  for (std::size_t i = 0; i < kDescriptionTexts.size(); ++i) all[i] = kDescriptionTexts[i].name;
  all.back() = kComponentNames;
  return all;
}();

struct VtkText {
  std::string_view array;
  std::string bytes;  ///< valid UTF-8
};
/// Those that are not empty, the names of components last.
[[nodiscard]] std::vector<VtkText> texts_of(const Model& model);
/// Appends an array for each of these.
void add_texts(const Model& model, VtkGroup& field_data);
/// Sets what an array of this name says. Nothing is done where its bytes are no UTF-8; or of names
/// where there is not one for each component, or there are more components than tets: a small file
/// would make a large model.
void set_text(Model& model, std::string_view array, std::string_view bytes);

}  // namespace tetloft::internal::io

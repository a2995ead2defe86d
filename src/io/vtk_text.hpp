// What VTK files tell in words of a model: arrays of bytes, which are UTF-8, as data of the whole
// grid. Not arrays of type String, which few readers beside VTK's own take.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include <tetloft/model.hpp>

#include "io/vtk_write.hpp"

namespace tetloft::internal::io {

/// A text of the model: the name of its array, and where it stands.
struct VtkText {
  std::string_view array;
  std::string Description::*text;
};
/// visit(text), for each.
template <class Visit>
void for_each_text(Visit&& visit) {
  visit(VtkText{"name", &Description::name});
  visit(VtkText{"unit", &Description::unit});
  visit(VtkText{"orientation", &Description::orientation});
}
inline constexpr std::string_view kComponentNames = "component_names";

/// The names of the components, a zero byte between two of them; empty where all are.
[[nodiscard]] std::string joined_names(const Model& model);
/// Appends an array for each text that there is.
void add_texts(const Model& model, VtkGroup& field_data);
/// Whether an array of this name holds one of these.
[[nodiscard]] bool is_text_array(std::string_view array);
/// Sets what an array of this name says. Nothing is done where its bytes are no UTF-8; or of names
/// where there is not one for each component, or there are more components than tets: a small file
/// would make a large model.
void set_text(Model& model, std::string_view array, std::string_view bytes);

}  // namespace tetloft::internal::io

// What a .vtu tells in words of its model: bytes of UTF-8, as data of the whole grid. Not arrays of
// type String, which few readers beside VTK's own take.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include <tetloft/model.hpp>

namespace tetloft::internal::io {

/// A text of the model: the name of its array, and where it stands.
struct VtuText {
  std::string_view array;
  std::string Description::*text;
};
/// visit(text), for each.
template <class Visit>
void for_each_text(Visit&& visit) {
  visit(VtuText{"name", &Description::name});
  visit(VtuText{"unit", &Description::unit});
  visit(VtuText{"orientation", &Description::orientation});
}
inline constexpr std::string_view kComponentNames = "component_names";

/// The names of the components, a zero byte between two of them; empty where all are.
[[nodiscard]] std::string joined_names(const Model& model);
/// Sets them. Nothing is done where there is not one name for each component, or where there are
/// more components than tets: a small file would make a large model.
void set_names(Model& model, std::string_view joined);

}  // namespace tetloft::internal::io

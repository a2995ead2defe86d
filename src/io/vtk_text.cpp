#include "io/vtk_text.hpp"

#include <algorithm>

#include "core/text.hpp"

namespace tetloft::internal::io {

namespace {

void set_names(Model& model, std::string_view joined) {
  const auto zeros = static_cast<std::size_t>(std::count(joined.begin(), joined.end(), '\0'));
  if (joined.empty() || zeros + 1 != model.component_count || zeros >= model.tets.size()) return;
  model.component_names.clear();
  model.component_names.reserve(model.component_count);
  for (std::size_t i = 0; i <= zeros; ++i) {
    const std::size_t end = std::min(joined.find('\0'), joined.size());
    model.component_names.push_back(valid_utf8(joined.substr(0, end)));
    joined.remove_prefix(std::min(end + 1, joined.size()));
  }
}

// Empty where all of them are.
std::string joined_names(const Model& model) {
  const auto& names = model.component_names;
  std::string joined;
  if (std::all_of(names.begin(), names.end(), [](const auto& name) { return name.empty(); })) {
    return joined;
  }
  for (const ComponentId c : names.ids()) {
    if (c.index() != 0) joined += '\0';
    joined += valid_utf8(names[c]);  // which holds no zero byte
  }
  return joined;
}

}  // namespace

std::vector<VtkText> texts_of(const Model& model) {
  std::vector<VtkText> texts;
  for (const auto& [name, text] : kDescriptionTexts) {
    texts.push_back({name, valid_utf8(model.about.*text)});
  }
  texts.push_back({kComponentNames, joined_names(model)});
  std::erase_if(texts, [](const VtkText& text) { return text.bytes.empty(); });
  return texts;
}

void add_texts(const Model& model, VtkGroup& field_data) {
  for (const VtkText& text : texts_of(model)) {
    field_data.arrays.push_back(vtk_array<std::uint8_t>(
        std::string(text.array), 1, text.bytes.size(),
        [bytes = text.bytes](std::size_t i) { return static_cast<std::uint8_t>(bytes[i]); }));
  }
}

void set_text(Model& model, std::string_view array, std::string_view bytes) {
  if (!is_utf8(bytes)) return;
  for (const auto& [name, text] : kDescriptionTexts) {
    if (name == array) model.about.*text = valid_utf8(bytes);
  }
  if (array == kComponentNames) set_names(model, bytes);
}

}  // namespace tetloft::internal::io

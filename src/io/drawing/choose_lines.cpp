// Finding a structure by its name or number.
#include "io/drawing/choose_lines.hpp"

#include <algorithm>
#include <optional>
#include <utility>

#include "core/spelling.hpp"
#include "core/text.hpp"
#include "io/numbers.hpp"

namespace tetloft::internal::io {

namespace {

using Known = std::vector<std::pair<double, std::string>>;

// "1 'lung', 2 'heart'": of many the first ones.
std::string listed(const Known& known) {
  constexpr std::size_t kMost = 40;
  std::string text;
  for (std::size_t i = 0; i < known.size() && i < kMost; ++i) {
    if (i > 0) text += ", ";
    append_number(text, known[i].first);
    if (!known[i].second.empty()) text += ' ' + in_quotes(known[i].second);
  }
  if (known.size() > kMost) text += " and " + std::to_string(known.size() - kMost) + " more";
  return text;
}

Error choice_error(const std::string& message, const std::string& option, const Known& known) {
  return {ErrorCode::usage,
          message + ": " + listed(known) + "; choose with " + option + " NUMBER or NAME",
          {}};
}

Error unknown_structure(const std::string& asked, const std::string& option, const Known& known) {
  std::vector<std::string_view> names;
  for (const auto& [number, name] : known) {
    if (!name.empty()) names.push_back(name);
  }
  std::string numbers;
  std::size_t bearers = 0;
  for (const auto& [number, name] : known) {
    if (name != asked) continue;
    numbers += bearers++ == 0 ? "#" : ", #";
    append_number(numbers, number);
  }
  if (bearers > 1) {
    return {ErrorCode::usage,
            std::to_string(bearers) + " structures of this file are named " + in_quotes(asked) +
                "; choose with " + option + " by their numbers: " + numbers,
            {}};
  }
  return choice_error(
      "there is no " + in_quotes(asked) + " in this file" + did_you_mean(asked, names) + "; it has",
      option, known);
}

bool is_solid(const DrawnLine& line) {
  return line.kind == LineKind::closed && line.points.size() >= 3;
}

void take(Drawing& drawing, std::size_t structure, ChosenLines& chosen) {
  std::vector<DrawnLine>& lines = drawing.structures[structure].lines;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    chosen.lines.push_back({std::move(lines[i]), structure, i});
  }
}

Result<ChosenLines> choose_structure(Drawing& drawing, const std::string& asked) {
  Known known;
  std::vector<std::size_t> solid;
  for (std::size_t s = 0; s < drawing.structures.size(); ++s) {
    const DrawnStructure& structure = drawing.structures[s];
    known.emplace_back(static_cast<double>(structure.number), structure.name);
    if (std::any_of(structure.lines.begin(), structure.lines.end(), is_solid)) solid.push_back(s);
  }
  std::optional<std::size_t> found;
  if (!asked.empty()) {
    found = find_structure(asked, known);
    if (!found) return unknown_structure(asked, drawing.chosen_by, known);
  } else if (solid.size() == 1) {
    found = solid.front();
  } else if (solid.size() > 1) {
    return choice_error("this file has several structures", drawing.chosen_by, known);
  } else if (known.size() != 1) {
    return Error{ErrorCode::invalid_input, "no structure of this file has a closed contour", {}};
  } else {
    found = 0;
  }
  ChosenLines chosen;
  chosen.name = drawing.structures[*found].name;
  take(drawing, *found, chosen);
  return chosen;
}

Result<ChosenLines> choose_label(Drawing& drawing, const std::string& asked) {
  ChosenLines chosen;
  for (std::size_t s = 0; s < drawing.structures.size(); ++s) take(drawing, s, chosen);
  if (asked.empty()) return chosen;
  Known known;
  for (const ChosenLine& line : chosen.lines) {
    const auto label = static_cast<double>(line.line.label);
    const auto same = [&](const auto& k) { return k.first == label; };
    if (std::none_of(known.begin(), known.end(), same)) known.emplace_back(label, "");
  }
  std::sort(known.begin(), known.end());
  const auto found = find_structure(asked, known);
  if (!found) return unknown_structure(asked, drawing.chosen_by, known);
  const double wanted = known[*found].first;
  std::erase_if(chosen.lines, [&](const ChosenLine& line) {
    return static_cast<double>(line.line.label) != wanted;
  });
  chosen.name = asked;
  return chosen;
}

}  // namespace

std::optional<std::size_t> find_structure(const std::string& asked, const Known& known) {
  const auto only = [&](auto&& fits) -> std::optional<std::size_t> {
    std::optional<std::size_t> found;
    for (std::size_t i = 0; i < known.size(); ++i) {
      if (!fits(known[i])) continue;
      if (found) return std::nullopt;
      found = i;
    }
    return found;
  };
  if (const auto exact = only([&](const auto& k) { return k.second == asked; })) return exact;
  const std::string_view digits = std::string_view(asked).substr(asked.starts_with('#') ? 1 : 0);
  const ParsedNumber number = parse_number(digits);
  if (number.ok()) {
    if (const auto by = only([&](const auto& k) { return k.first == number.value; })) return by;
  }
  return only([&](const auto& k) { return lower_case(k.second) == lower_case(asked); });
}

Result<ChosenLines> choose_lines(Drawing& drawing, const std::string& asked) {
  if (drawing.apart) return choose_structure(drawing, asked);
  if (drawing.labelled) return choose_label(drawing, asked);
  if (!asked.empty() && drawing.structures.size() > 1) return choose_structure(drawing, asked);
  if (!asked.empty()) {
    return Error{
        ErrorCode::usage,
        "this file has no structures or labels to choose from: leave out " + drawing.chosen_by,
        {}};
  }
  ChosenLines chosen;
  for (std::size_t s = 0; s < drawing.structures.size(); ++s) take(drawing, s, chosen);
  return chosen;
}

std::string place_of(const Drawing& drawing, const ChosenLine& line) {
  std::string text = "contour " + std::to_string(line.position);
  if (line.structure < drawing.structures.size()) {
    const DrawnStructure& structure = drawing.structures[line.structure];
    if (drawing.apart || drawing.structures.size() > 1) {
      text += " of structure " + (structure.name.empty() ? std::to_string(structure.number)
                                                         : in_quotes(structure.name));
    }
  }
  if (line.line.offset != 0) text += " (byte " + std::to_string(line.line.offset) + ')';
  return text;
}

}  // namespace tetloft::internal::io

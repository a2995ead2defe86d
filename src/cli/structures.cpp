// Listing structures, and naming files by them.
#include "cli/structures.hpp"

#include <algorithm>
#include <set>

#include "cli/console.hpp"
#include "core/text.hpp"
#include "io/files.hpp"

namespace tetloft::cli {

using namespace internal;

namespace {

// Letters, digits, and what is beyond ASCII; anything else may mean something to a shell or a
// system.
std::string as_file_name(const std::string& name) {
  constexpr std::size_t kLongest = 100;
  std::string text;
  for (const char c : name.substr(0, kLongest)) {
    const bool plain = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
                       c == '_' || c == '-' || c == '.' || static_cast<unsigned char>(c) >= 0x80;
    text += plain ? c : '_';
  }
  return text;
}

}  // namespace

std::vector<Structure> structures_of(const FileSummary& file) {
  std::vector<Structure> all;
  if (file.volume) {
    // As the file's format says, by value or by name.
    for (const std::string& asked : file.volume->structures) {
      Structure structure{asked, {}, {}, 0};
      for (const LabelSummary& label : file.volume->labels) {
        if (label.name != asked && exact(label.value) != asked) continue;
        structure = {asked, label.name, exact(label.value), label.value};
      }
      if (structure.number.empty()) structure.name = asked;
      all.push_back(structure);
    }
    return all;
  }
  if (!file.structures.empty()) {
    for (const StructureSummary& structure : file.structures) {
      if (structure.closed == 0) continue;
      all.push_back({{},
                     structure.name,
                     std::to_string(structure.number),
                     static_cast<double>(structure.number)});
    }
  } else if (file.lines) {
    for (const std::int64_t label : file.lines->labels) {
      if (label != 0) all.push_back({{}, {}, std::to_string(label), static_cast<double>(label)});
    }
  }
  // A name that several bear names none.
  for (Structure& structure : all) {
    const auto bears = [&](const Structure& other) { return other.name == structure.name; };
    const bool named = !structure.name.empty() && std::count_if(all.begin(), all.end(), bears) == 1;
    structure.asked = named ? structure.name : '#' + structure.number;
  }
  return all;
}

std::vector<std::string> outputs_of(const std::string& path,
                                    const std::vector<Structure>& structures) {
  const std::string extension = path.substr(path.size() - io::extension_of(path).size());
  const std::string stem = path.substr(0, path.size() - extension.size());
  std::set<std::string> taken;
  std::vector<std::string> outputs;
  for (const Structure& structure : structures) {
    const std::string base =
        as_file_name(structure.name.empty() ? structure.number : structure.name);
    std::string name = base;
    for (std::size_t i = 0; !taken.insert(lower_case(name)).second; ++i) {
      name = base + '-' + structure.number + (i == 0 ? "" : '-' + std::to_string(i));
    }
    outputs.push_back(stem + '-' + name + extension);
  }
  return outputs;
}

}  // namespace tetloft::cli

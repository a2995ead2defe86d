#include "io/msh_write.hpp"

#include <algorithm>
#include <limits>
#include <utility>

#include "core/text.hpp"
#include "io/solid_comments.hpp"

namespace tetloft::internal::io {

namespace {

// Quotes end a name, lines end with it, and of longer ones programs keep the beginning at best.
std::string physical_name(const std::string& name) {
  constexpr std::size_t kLongestName = 127;
  std::string shown = printable(name);
  std::replace(shown.begin(), shown.end(), '"', '\'');
  return std::string(beginning(shown, kLongestName));
}

void append_names(MshWriter& out, const std::vector<MshGroup>& groups,
                  std::vector<Warning>& warnings) {
  std::vector<std::string> lines;
  for (const std::int64_t dimension : {2, 3}) {
    for (const auto& [group, entity] : groups) {
      const bool is_there = dimension == 3 || !group.triangles.empty();
      if (group.tag() == 0 || !is_there) continue;
      const std::string name = physical_name(group.name);
      lines.push_back(std::to_string(dimension) + ' ' + std::to_string(group.tag()) + " \"" + name +
                      '"');
      if (dimension == 2 || name == group.name) continue;
      warnings.push_back({"the name of component " + std::to_string(group.tag()) +
                              " cannot stand in the file as it is; written is " + in_quotes(name),
                          {}});
    }
  }
  if (lines.empty()) return;
  out.line("$PhysicalNames");
  out.line(std::to_string(lines.size()));
  for (const std::string& line : lines) out.line(line);
  out.line("$EndPhysicalNames");
}

void append_about(MshWriter& out, const Model& model) {
  std::string lines;
  append_comments(lines, kMshComment, model, {});
  if (lines.empty()) return;
  out.line("$Comments");
  out.line(lines + "$EndComments");
}

}  // namespace

Result<std::vector<MshGroup>> msh_groups(const Model& model) {
  std::vector<MshGroup> groups;
  std::int64_t last = 0;
  for (ComponentGroup& group : component_groups(model)) {
    // Without a component there is no physical group, but an entity there must be.
    const std::int64_t entity = group.component.valid() ? group.tag() : last + 1;
    last = entity;
    groups.push_back({std::move(group), entity});
  }
  if (groups.empty() && !model.points.empty()) groups.push_back({ComponentGroup(), 1});
  if (last <= std::numeric_limits<std::int32_t>::max()) return groups;
  return Error{ErrorCode::invalid_input,
               "component " + std::to_string(last) + " has a number above those of Gmsh",
               {}};
}

std::size_t count_elements(const Model& model, const std::vector<MshGroup>& groups) {
  std::size_t count = model.tets.size();
  for (const MshGroup& g : groups) count += g.group.triangles.size();
  return count;
}

std::vector<Warning> append_msh_head(MshWriter& out, std::string_view version, const Model& model,
                                     const std::vector<MshGroup>& groups) {
  std::vector<Warning> warnings;
  out.line("$MeshFormat");
  out.line(std::string(version) + (out.ascii() ? " 0 8" : " 1 8"));
  if (!out.ascii()) {
    // By which readers know the order of bytes.
    out.integer(1);
    out.line("");
  }
  out.line("$EndMeshFormat");
  append_about(out, model);
  append_names(out, groups, warnings);
  return warnings;
}

}  // namespace tetloft::internal::io

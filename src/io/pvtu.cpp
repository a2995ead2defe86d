#include "io/pvtu.hpp"

#include <cstdint>
#include <string_view>
#include <type_traits>

#include "io/vtk_write.hpp"
#include "io/vtu_frame.hpp"
#include "io/xml.hpp"
#include "io/xml_text.hpp"
#include "model/fields.hpp"

namespace tetloft::internal::io {

namespace {

constexpr std::string_view kIndexType = "PUnstructuredGrid";

std::string index_array(std::string_view type, std::string_view name, bool of_points) {
  return "      <PDataArray type=\"" + std::string(type) + "\" Name=\"" + std::string(name) + '"' +
         (of_points ? " NumberOfComponents=\"3\"" : "") + "/>\n";
}

std::string index_fields(bool of_points) {
  std::string text;
  for_each_field([&](const auto& field) {
    using Field = std::remove_cvref_t<decltype(field)>;
    if (Field::kOfPoints != of_points) return;
    text += index_array(vtk_type_name<typename Field::Stored::Type>(), field.name, false);
  });
  return text;
}

}  // namespace

bool begins_as_index(std::string_view bytes) { return is_vtk_file(bytes, kIndexType); }

Result<std::vector<std::string>> index_sources(std::string_view bytes, const std::string& name) {
  XmlScanner scanner(bytes, name);
  std::vector<std::string> sources;
  std::vector<std::string> open;
  bool closed = false;  // the root
  while (true) {
    const Result<XmlTag> tag = scanner.next_tag();
    if (!tag) return tag.error();
    if (tag->kind == XmlTag::Kind::end_of_file) break;
    if (tag->kind == XmlTag::Kind::close) {
      if (open.empty() || open.back() != tag->name) return scanner.complain_of_close(*tag);
      open.pop_back();
      closed = open.empty();
      continue;
    }
    const bool listed = open.size() == 2 && open.back() == kIndexType;
    if (tag->name == "Piece" && listed) {
      const std::string* const source = tag->find("Source");
      if (source == nullptr || source->empty()) {
        return scanner.complain(tag->position, "a piece has no Source");
      }
      sources.push_back(*source);
    }
    if (open.size() > 3) return scanner.complain(tag->position, "the tags are nested too deep");
    if (tag->kind == XmlTag::Kind::open) open.emplace_back(tag->name);
  }
  if (!closed) return scanner.complain(scanner.position(), "the index is cut off");
  if (sources.empty()) return scanner.complain(0, "the index lists no piece");
  return sources;
}

void append_index(Sink& sink, const IndexedGrid& grid) {
  std::string text =
      "<?xml version=\"1.0\"?>\n"
      "<VTKFile type=\"PUnstructuredGrid\" version=\"1.0\" byte_order=\"LittleEndian\" "
      "header_type=\"UInt64\">\n  <PUnstructuredGrid GhostLevel=\"0\">\n    <PPointData>\n" +
      index_fields(true);
  if (grid.with_stack_points) text += index_array(vtk_type_name<double>(), kStackPointArray, true);
  text += "    </PPointData>\n    <PCellData>\n" + index_fields(false) +
          "    </PCellData>\n    <PPoints>\n" +
          index_array(vtk_type_name<double>(), "Points", true) + "    </PPoints>\n";
  sink.append(text);
  for (const std::string& source : grid.sources) {
    sink.append("    <Piece Source=\"" + xml_text(source) + "\"/>\n");
  }
  sink.append("  </PUnstructuredGrid>\n</VTKFile>\n");
}

}  // namespace tetloft::internal::io

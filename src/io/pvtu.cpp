#include "io/pvtu.hpp"

#include <cstdint>
#include <string_view>
#include <type_traits>

#include "io/vtk_write.hpp"
#include "io/vtu_frame.hpp"
#include "io/xml_text.hpp"
#include "model/fields.hpp"

namespace tetloft::internal::io {

namespace {

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

// Surfaces as .3mf (3MF Consortium, Core Specification 1.3): a zip archive with one XML document
// of an object for each component. Section numbers are those of the specification.
#include <array>
#include <cstdint>
#include <cstdio>
#include <string>
#include <string_view>
#include <vector>

#include "core/text.hpp"
#include "io/bytes/zip.hpp"
#include "io/description_texts.hpp"
#include "io/format.hpp"
#include "io/length_unit.hpp"
#include "io/numbers.hpp"
#include "io/xml_text.hpp"
#include "model/component_colour.hpp"

namespace tetloft::internal::io {

namespace {

constexpr std::string_view kXmlHead = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n";

// Section 2.1: what the parts of the package are, and which of them is the model.
constexpr std::string_view kContentTypes =
    "<Types xmlns=\"http://schemas.openxmlformats.org/package/2006/content-types\">\n"
    "<Default Extension=\"rels\" "
    "ContentType=\"application/vnd.openxmlformats-package.relationships+xml\"/>\n"
    "<Default Extension=\"model\" "
    "ContentType=\"application/vnd.ms-package.3dmanufacturing-3dmodel+xml\"/>\n"
    "</Types>\n";
constexpr std::string_view kRelationships =
    "<Relationships xmlns=\"http://schemas.openxmlformats.org/package/2006/relationships\">\n"
    "<Relationship Target=\"/3D/3dmodel.model\" Id=\"rel0\" "
    "Type=\"http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel\"/>\n"
    "</Relationships>\n";

// The materials are resource 1, the objects those that follow.
constexpr std::size_t kMaterials = 1;
constexpr std::size_t kFirstObject = 2;

// Section 3.4, ST_Unit. Empty: it has no such unit.
std::string_view unit_of_3mf(std::string_view unit) {
  struct Named {
    std::string_view name, known_as;
  };
  constexpr std::array kUnits{Named{"micron", "um"},     Named{"millimeter", "mm"},
                              Named{"centimeter", "cm"}, Named{"inch", "in"},
                              Named{"foot", "ft"},       Named{"meter", "m"}};
  const auto metres = metres_in(unit);
  if (!metres) return {};
  for (const Named& named : kUnits) {
    if (*metres == metres_in(named.known_as)) return named.name;
  }
  return {};
}

std::string attribute(std::string_view name, std::string_view value) {
  return ' ' + std::string(name) + "=\"" + std::string(value) + '"';
}

// In one line: not every reader knows references to characters ("&#10;").
std::string line_of_xml(std::string_view text) { return xml_text(printable(text)); }

std::string metadata(std::string_view name, std::string_view text) {
  return "<metadata" + attribute("name", name) + '>' + line_of_xml(text) + "</metadata>\n";
}

// Names of metadata are the specification's (section 3.4.1); what has none is described.
std::string description(const Description& about) {
  std::string text;
  for (const std::string& line : description_lines({{}, about.unit, about.orientation})) {
    text += (text.empty() ? "" : "; ") + line;
  }
  return text.empty() ? text : metadata("Description", text);
}

std::string display_colour(ComponentId component) {
  const Rgb colour = component_colour(component.index());
  std::array<char, 8> text{};
  std::snprintf(text.data(), text.size(), "#%02X%02X%02X", unsigned{colour.r}, unsigned{colour.g},
                unsigned{colour.b});
  return text.data();
}

std::string materials(const std::vector<SurfacePart>& parts) {
  if (parts.empty()) return {};
  std::string text = "<basematerials" + attribute("id", std::to_string(kMaterials)) + ">\n";
  for (const SurfacePart& part : parts) {
    text += "<base" + attribute("name", line_of_xml(part.name)) +
            attribute("displaycolor", display_colour(part.component)) + "/>\n";
  }
  return text + "</basematerials>\n";
}

// The mesh of an object shares its vertices: readers do not join them.
void append_mesh(std::string& text, const SurfaceMesh& mesh, const PartMesh& own) {
  text += "<mesh>\n<vertices>\n";
  for (const std::uint32_t v : own.vertex) {
    const Point3& p = mesh.points[v];
    text += "<vertex x=\"";
    append_number(text, p.x);
    text += "\" y=\"";
    append_number(text, p.y);
    text += "\" z=\"";
    append_number(text, p.z);
    text += "\"/>\n";
  }
  text += "</vertices>\n<triangles>\n";
  for (const auto& triangle : own.triangles) {
    text += "<triangle v1=\"";
    append_number(text, triangle[0]);
    text += "\" v2=\"";
    append_number(text, triangle[1]);
    text += "\" v3=\"";
    append_number(text, triangle[2]);
    text += "\"/>\n";
  }
  text += "</triangles>\n</mesh>\n";
}

std::string model_part(const SurfaceMesh& mesh, const Model& model,
                       const std::vector<SurfacePart>& parts, std::string_view unit) {
  std::string text(kXmlHead);
  text += "<model" + attribute("unit", unit) + attribute("xml:lang", "en-US") +
          attribute("xmlns", "http://schemas.microsoft.com/3dmanufacturing/core/2015/02") + ">\n";
  if (!model.about.name.empty()) text += metadata("Title", model.about.name);
  text += metadata("Application", "tetloft") + description(model.about);
  text += "<resources>\n" + materials(parts);
  std::string items;
  for (std::size_t k = 0; k < parts.size(); ++k) {
    const std::string id = std::to_string(kFirstObject + k);
    text += "<object" + attribute("id", id) + attribute("type", "model") +
            attribute("name", line_of_xml(parts[k].name)) +
            attribute("pid", std::to_string(kMaterials)) + attribute("pindex", std::to_string(k)) +
            ">\n";
    append_mesh(text, mesh, part_mesh(mesh, parts[k]));
    text += "</object>\n";
    items += "<item" + attribute("objectid", id) + "/>\n";
  }
  return text + "</resources>\n<build>\n" + items + "</build>\n</model>\n";
}

Warning open_warning(const SurfacePart& part, std::size_t edges) {
  return {in_quotes(part.name) + " is not closed by itself: " + std::to_string(edges) +
              (edges == 1 ? " edge is" : " edges are") +
              " not between two of its triangles, as 3MF asks; programs may repair or refuse it",
          {}};
}

Written write_3mf(Sink& sink, const SurfaceMesh& mesh, const Model& model,
                  const Target& /*target*/) {
  std::vector<Warning> warnings;
  std::string_view unit = unit_of_3mf(model.about.unit);
  if (unit.empty()) {
    unit = "millimeter";  // what readers take where nothing is said
    if (!model.about.unit.empty()) {
      warnings.push_back({"3MF has no unit " + in_quotes(model.about.unit) +
                              ": the coordinates stand there as millimeters",
                          {}});
    }
  }
  const std::vector<SurfacePart> parts = surface_parts(mesh, model);
  for (const SurfacePart& part : parts) {
    const std::size_t edges = unmatched_edges(mesh, part);
    if (edges != 0) warnings.push_back(open_warning(part, edges));
  }
  const std::array entries{
      zip_entry("[Content_Types].xml", std::string(kXmlHead) + std::string(kContentTypes)),
      zip_entry("_rels/.rels", std::string(kXmlHead) + std::string(kRelationships)),
      zip_entry("3D/3dmodel.model", model_part(mesh, model, parts, unit))};
  if (Result<void> written = append_zip(sink, entries); !written) return written.error();
  return warnings;
}

}  // namespace

extern constinit const Format threemf_format{.name = "3mf",
                                             .summary = "3D Manufacturing Format",
                                             .extensions = {".3mf"},
                                             .write_surface = write_3mf};

}  // namespace tetloft::internal::io

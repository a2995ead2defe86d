// See report_json.hpp.
#include "cli/report_json.hpp"

#include <array>
#include <vector>

#include "cli/verdicts.hpp"

namespace tetloft::cli {

namespace {

void write_guarantees(JsonWriter& json, const std::vector<ReportGuarantee>& guarantees) {
  json.key("guarantees");
  json.begin_array();
  for (const ReportGuarantee& guarantee : guarantees) {
    json.begin_object();
    json.member("number", guarantee.number);
    json.member("name", guarantee.name);
    json.member("verdict", name_of(guarantee.verdict));
    json.member("why", guarantee.why);
    write_failures(json, guarantee.failures);
    json.end_object();
  }
  json.end_array();
}

void write_section(JsonWriter& json, const char* name, const std::optional<SectionId>& section) {
  std::optional<std::size_t> number;
  if (section) number = section->index();
  json.member(name, number);
}

void write_measures(JsonWriter& json, const ReportMeasures& measures) {
  json.member("tets", measures.tets);
  json.member("volume", measures.volume);
  json.member("surface_area", measures.surface_area);
  json.member("surfaces", measures.surfaces);
  json.member("cavities", measures.cavities);
  json.member("genus", measures.genus);
  write_section(json, "first_section", measures.first);
  write_section(json, "last_section", measures.last);
}

void write_spread(JsonWriter& json, const char* name, const ReportSpread& spread) {
  json.key(name);
  json.begin_object();
  json.member("least", spread.least);
  json.member("median", spread.median);
  json.member("most", spread.most);
  json.end_object();
}

void write_histogram(JsonWriter& json, const char* name, const ReportHistogram& histogram) {
  json.key(name);
  json.begin_object();
  json.member("edges", histogram.edges);
  json.member("counts", histogram.counts);
  json.end_object();
}

void write_quality(JsonWriter& json, const ReportQuality& quality) {
  json.key("quality");
  json.begin_object();
  json.member("edges", quality.edges);
  write_spread(json, "edge_length", quality.edge_length);
  write_spread(json, "dihedral_degrees", quality.dihedral);
  write_spread(json, "smallest_dihedral_degrees", quality.smallest_dihedral);
  write_spread(json, "mean_ratio", quality.mean_ratio);
  write_histogram(json, "dihedral_histogram", quality.dihedrals);
  write_histogram(json, "edge_length_histogram", quality.edge_lengths);
  json.end_object();
}

void write_areas(JsonWriter& json, const char* name, const std::vector<ReportArea>& areas) {
  json.key(name);
  json.begin_array();
  for (const ReportArea& area : areas) json.value(std::array{area.z, area.area});
  json.end_array();
}

void write_kinds(JsonWriter& json, const std::vector<std::size_t>& kinds) {
  json.key("kinds");
  json.begin_object();
  for (std::size_t k = 0; k < kinds.size(); ++k) {
    json.member(name_of(static_cast<TetKind>(k)), kinds[k]);
  }
  json.end_object();
}

}  // namespace

void write_report(JsonWriter& json, const Report& report) {
  const ReportFigures& figures = report.figures;
  json.member("title", report.title);
  json.member("pass", report.pass());
  write_guarantees(json, report.guarantees);
  write_measures(json, figures.all);
  json.key("components");
  json.begin_array();
  for (const ReportComponent& component : figures.components) {
    json.begin_object();
    json.member("name", component.name);
    write_measures(json, component.measures);
    json.end_object();
  }
  json.end_array();
  json.member("components_touch", figures.components_touch);
  json.member("vertices", figures.vertices);
  json.member("boundary_triangles", figures.boundary_triangles);
  write_kinds(json, figures.kinds);
  write_quality(json, figures.quality);
  write_areas(json, "area_of_solid", figures.solid);
  write_areas(json, "area_of_sections", figures.sections);
  json.member("volume_between_sections", figures.volume_between);
  json.member("frustum_volume", figures.frustum_volume);
}

}  // namespace tetloft::cli

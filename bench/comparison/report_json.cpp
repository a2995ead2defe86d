#include "cli/json.hpp"
#include "comparison/report.hpp"

namespace tetloft::bench {

namespace {

using cli::JsonWriter;

template <class Value>
void optional_member(JsonWriter& json, const char* name, const std::optional<Value>& value) {
  if (value) json.member(name, *value);
}

void write_run(JsonWriter& json, const Run& run) {
  json.begin_object();
  json.member("method", run.method);
  json.member("seconds", run.seconds);
  if (!run.refusal.empty()) {
    json.member("refused", run.refusal);
    json.end_object();
    return;
  }
  if (run.tets != 0) json.member("tets", run.tets);
  if (run.guarantees) {
    json.key("guarantees");
    json.begin_array();
    for (const bool holds : *run.guarantees) json.value(holds);
    json.end_array();
  }
  optional_member(json, "valid", run.valid);
  optional_member(json, "exceptions", run.exceptions);
  json.member("singular_vertices", run.singular_vertices);
  json.member("singular_edges", run.singular_edges);
  json.member("section_deviation", run.deviation);
  json.member("lost_contours", run.lost);
  if (run.links) {
    json.member("missing_unions", run.links->missing);
    json.member("false_unions", run.links->wrong);
  }
  json.member("components", run.topology.components);
  json.member("cavities", run.topology.cavities);
  json.member("genus", run.topology.genus);
  json.member("volume", run.volume);
  optional_member(json, "component_error", run.component_error);
  optional_member(json, "cavity_error", run.cavity_error);
  optional_member(json, "genus_error", run.genus_error);
  optional_member(json, "volume_error", run.volume_error);
  if (run.distance) {
    json.member("mean_distance", run.distance->mean);
    json.member("hausdorff", run.distance->hausdorff);
  }
  json.end_object();
}

void write_row(JsonWriter& json, const Row& row) {
  json.begin_object();
  json.member("name", row.subject.name);
  json.member("set", row.subject.set);
  if (!row.subject.kind.empty()) {
    json.member("kind", row.subject.kind);
    json.member("spacing", row.subject.spacing);
    json.member("contours_are", row.subject.contouring);
  }
  json.member("sections", row.sections);
  json.member("contours", row.contours);
  json.member("vertices", row.vertices);
  json.key("runs");
  json.begin_array();
  for (const Run& run : row.runs) write_run(json, run);
  json.end_array();
  json.end_object();
}

void write_line(JsonWriter& json, const Table::Line& line) {
  const Aggregate& a = line.aggregate;
  json.begin_object();
  json.member("group", line.group);
  json.member("method", line.method);
  json.member("stacks", a.stacks);
  json.member("refused", a.refused);
  optional_member(json, "valid", a.valid);
  optional_member(json, "resampled", a.resampled);
  optional_member(json, "defined", a.defined);
  optional_member(json, "exceptions", a.exceptions);
  json.member("singular_vertices", a.singular_vertices);
  json.member("singular_edges", a.singular_edges);
  json.member("lost_contours", a.lost);
  json.member("section_deviation", a.deviation);
  if (a.links) {
    json.member("missing_unions", a.links->missing);
    json.member("false_unions", a.links->wrong);
  }
  optional_member(json, "right_topology", a.right_topology);
  optional_member(json, "component_errors", a.component_errors);
  optional_member(json, "cavity_errors", a.cavity_errors);
  optional_member(json, "genus_errors", a.genus_errors);
  optional_member(json, "volume_error", a.volume_error);
  optional_member(json, "mean_distance", a.mean_distance);
  optional_member(json, "hausdorff", a.hausdorff);
  if (a.tets != 0) json.member("tets", a.tets);
  json.member("seconds_per_10k_vertices", a.seconds_per_10k);
  json.end_object();
}

}  // namespace

std::string json_of(const CompareOptions& options, const std::vector<Row>& rows,
                    const std::vector<Table>& tables) {
  JsonWriter json;
  json.begin_object();
  json.member("solids", options.solids);
  json.member("size", options.size);
  json.member("seed", options.seed);
  json.member("samples", options.samples);
  json.key("tables");
  json.begin_array();
  for (const Table& table : tables) {
    json.begin_object();
    json.member("title", table.title);
    json.key("lines");
    json.begin_array();
    for (const Table::Line& line : table.lines) write_line(json, line);
    json.end_array();
    json.end_object();
  }
  json.end_array();
  json.key("stacks");
  json.begin_array();
  for (const Row& row : rows) write_row(json, row);
  json.end_array();
  json.end_object();
  return json.text() + '\n';
}

}  // namespace tetloft::bench

#include "comparison/report.hpp"

#include <algorithm>
#include <array>
#include <cstdio>
#include <functional>
#include <optional>

namespace tetloft::bench {

namespace {

using GroupOf = std::function<std::string(const Subject&)>;  // empty: not in this table

Table table_by(std::string title, const std::vector<Row>& rows, const GroupOf& group_of) {
  using Key = std::pair<std::string, std::string>;
  std::vector<std::pair<Key, std::vector<SizedRun>>> groups;
  for (const Row& row : rows) {
    const std::string group = group_of(row.subject);
    if (group.empty()) continue;
    for (const Run& run : row.runs) {
      const Key key{group, run.method};
      auto at = std::find_if(groups.begin(), groups.end(),
                             [&](const auto& entry) { return entry.first == key; });
      if (at == groups.end()) at = groups.insert(at, {key, {}});
      at->second.push_back({&run, row.vertices});
    }
  }
  Table table{std::move(title), {}};
  for (const auto& [key, runs] : groups) {
    table.lines.push_back({key.first, key.second, aggregate(runs)});
  }
  return table;
}

std::string format(const char* pattern, double value) {
  std::array<char, 40> buffer{};
  std::snprintf(buffer.data(), buffer.size(), pattern, value);
  return buffer.data();
}

const std::string kNone = "—";

std::string show(const char* pattern, const std::optional<double>& value, double factor = 1) {
  return value ? format(pattern, factor * *value) : kNone;
}
std::string show(const std::optional<long>& value) {
  return value ? std::to_string(*value) : kNone;
}

std::string line_of(const Table::Line& line) {
  const Aggregate& a = line.aggregate;
  std::string text;
  const auto cell = [&](const std::string& content) { text += "| " + content + " "; };
  cell(line.group);
  cell(line.method);
  cell(std::to_string(a.stacks));
  cell(std::to_string(a.refused));
  cell(show("%.1f", a.valid, 100));
  cell(show("%.1f", a.resampled, 100));
  cell(show("%.1f", a.defined, 100));
  cell(show(a.exceptions));
  cell(std::to_string(a.singular_vertices) + " + " + std::to_string(a.singular_edges));
  cell(std::to_string(a.lost));
  cell(format("%.3f", 100 * a.deviation));
  cell(a.links ? std::to_string(a.links->missing) + " + " + std::to_string(a.links->wrong) : kNone);
  cell(show("%.1f", a.right_topology, 100));
  cell(show(a.component_errors));
  cell(show(a.cavity_errors));
  cell(show(a.genus_errors));
  cell(show("%.2f", a.volume_error, 100));
  cell(show("%.3f", a.mean_distance));
  cell(show("%.2f", a.hausdorff));
  cell(a.tets == 0 ? kNone : std::to_string(a.tets));
  cell(format("%.3f", a.seconds_per_10k));
  return text + "|\n";
}

}  // namespace

std::vector<Table> tables_of(const std::vector<Row>& rows) {
  const auto in_corpus = [](const Subject& subject) { return !subject.kind.empty(); };
  std::vector<Table> tables;
  tables.push_back(table_by("corpus, by spacing", rows, [&](const Subject& s) {
    return in_corpus(s) ? "every " + std::to_string(s.spacing) : "";
  }));
  tables.push_back(
      table_by("corpus, by contours", rows, [](const Subject& s) { return s.contouring; }));
  tables.push_back(
      table_by("corpus, by kind of solid", rows, [](const Subject& s) { return s.kind; }));
  tables.push_back(
      table_by("folders", rows, [&](const Subject& s) { return in_corpus(s) ? "" : s.set; }));
  std::erase_if(tables, [](const Table& table) { return table.lines.empty(); });
  return tables;
}

std::string markdown_of(const std::vector<Table>& tables) {
  std::string text;
  for (const Table& table : tables) {
    text += "### " + table.title + "\n\n" +
            "| stacks | method | number | refused | fully valid (%) | sections exact (%) | "
            "cavities and tunnels as defined (%) | exceptions listed | "
            "singular vertices + edges | contours lost | section deviation (%) | unions missing + "
            "false | topology right (%) | component errors "
            "| cavity errors | genus errors | volume error (%) | mean distance | Hausdorff | tets "
            "| s per "
            "10,000 vertices "
            "|\n|---|---|---|---|---|---|---|---|---|---|---|---|---|---|---|---|---|---|---|---|--"
            "-|\n";
    for (const Table::Line& line : table.lines) text += line_of(line);
    text += '\n';
  }
  return text;
}

}  // namespace tetloft::bench

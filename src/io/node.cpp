// Points of TetGen's .node files: "count 3 attributes markers", then "number x y z …" for each.
#include "io/node.hpp"

#include <array>
#include <string>
#include <utility>
#include <vector>

#include "io/numbers.hpp"
#include "io/rows.hpp"
#include "io/table_rows.hpp"

namespace tetloft::internal::io {

namespace {

Error node_error(const Source& source, std::size_t line, const std::string& message) {
  return row_error(source.name, line, message);
}

// "count dimension attributes markers": the last two may be missing.
Result<std::array<std::size_t, 4>> read_head(const Source& source, const TableRows& rows) {
  std::array<std::size_t, 4> head{};
  const std::vector<std::string_view>& fields = rows.fields();
  if (fields.size() < 2 || fields.size() > 4) {
    return node_error(source, rows.line(),
                      "expected \"count 3 attributes markers\", got " +
                          std::to_string(fields.size()) + " fields");
  }
  for (std::size_t i = 0; i < fields.size(); ++i) {
    const auto number = parse_integer(fields[i]);
    if (!number || *number < 0) {
      return node_error(source, rows.line(), in_quotes(fields[i]) + " is no count");
    }
    head[i] = static_cast<std::size_t>(*number);
  }
  if (head[1] != 3) {
    return node_error(source, rows.line(),
                      "points of dimension " + std::to_string(head[1]) + "; only 3 is read");
  }
  return head;
}

}  // namespace

Result<NodePoints> read_node_points(const Source& source) {
  TableRows rows(source.bytes);
  if (!rows.next()) return node_error(source, rows.line(), "the file is empty");
  const auto head = read_head(source, rows);
  if (!head) return head.error();
  const auto [count, dimension, attributes, markers] = *head;
  NodePoints read;
  while (rows.next()) {
    const std::vector<std::string_view>& fields = rows.fields();
    const std::size_t k = read.points.size();
    if (k == count) {
      return node_error(source, rows.line(),
                        "more points than the " + std::to_string(count) + " announced");
    }
    // Some writers leave the marker out though they announce one, or the other way round.
    const std::size_t due = 1 + dimension + attributes;
    if (fields.size() < due || fields.size() > due + 1) {
      return node_error(source, rows.line(),
                        "expected a number, x, y, z and " + std::to_string(attributes) +
                            " attributes, got " + std::to_string(fields.size()) + " fields");
    }
    const auto number = parse_integer(fields[0]);
    if (k == 0) read.first = number.value_or(-1);
    if (!number || read.first < 0 || read.first > 1 ||
        *number != read.first + static_cast<std::int64_t>(k)) {
      return node_error(source, rows.line(),
                        "points are numbered in order from 0 or 1, not " + in_quotes(fields[0]));
    }
    std::array<double, 3> xyz{};
    for (std::size_t i = 0; i < 3; ++i) {
      const ParsedNumber value = parse_number(fields[1 + i]);
      if (!value.ok()) {
        return node_error(source, rows.line(), complaint(fields[1 + i], value.status));
      }
      xyz[i] = value.value;
    }
    read.points.push_back({xyz[0], xyz[1], xyz[2]});
  }
  if (read.points.size() != count) {
    return node_error(source, rows.line(),
                      std::to_string(count) + " points are announced, here are " +
                          std::to_string(read.points.size()));
  }
  if (attributes > 0 || markers > 0) {
    Warning warning{"left out: attributes and markers of points", {}};
    warning.where.file = source.name;
    read.warnings.push_back(std::move(warning));
  }
  return read;
}

namespace {

Result<ReadPoints> read_node(const Source& source, const ReadOptions& /*options*/) {
  Result<NodePoints> nodes = read_node_points(source);
  if (!nodes) return nodes.error();
  return ReadPoints{std::move(nodes->points), std::move(nodes->warnings)};
}

}  // namespace

extern constinit const Format node_format{
    .name = "node", .summary = "TetGen points", .extensions = {".node"}, .read_points = read_node};

}  // namespace tetloft::internal::io

// TetGen's .ele: "count 4 attributes", then "number a b c d …" for each tet. The points are in the
// .node beside it, of whose numbers a, b, c and d are some.
#include "io/tetgen_read.hpp"

#include <array>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "io/files.hpp"
#include "io/groups.hpp"
#include "io/node.hpp"
#include "io/numbers.hpp"
#include "io/rows.hpp"
#include "io/solid_comments.hpp"
#include "io/table_rows.hpp"
#include "io/warning_list.hpp"
#include "model/well_formed.hpp"

namespace tetloft::internal::io {

namespace {

// The points of "NAME.ele" are in "NAME.node".
Result<NodePoints> points_beside(const Source& source) {
  if (source.folder.empty()) {
    return row_error(source.name, 1,
                     "the points are in a .node beside this .ele, which was not read from a file");
  }
  std::filesystem::path path(source.name);
  for (const char* extension : {".node", ".NODE"}) {
    path.replace_extension(extension);
    std::error_code ignored;
    if (!std::filesystem::exists(path, ignored)) continue;
    const Result<std::string> bytes = read_file(path.string());
    if (!bytes) return bytes.error();
    return read_node_points({*bytes, path.string(), source.folder});
  }
  path.replace_extension(".node");
  return row_error(
      source.name, 1,
      "the points of this .ele, " + in_quotes(path.filename().string()) + ", are not beside it");
}

class EleReader {
 public:
  EleReader(const Source& source, const NodePoints& nodes)
      : source_(source), nodes_(nodes), warnings_(source.name), rows_(source.bytes) {}

  // The rows.
  Result<void> read() {
    take_comments();
    if (!rows_.next()) return complain("the file is empty");
    if (Result<void> head = take_head(rows_.fields()); !head) return head;
    while (rows_.next()) {
      if (Result<void> taken = take_tet(rows_.fields()); !taken) return taken;
    }
    if (solid_.size() != count_) {
      return complain(std::to_string(count_) + " tets are announced, here are " +
                      std::to_string(solid_.size()));
    }
    return {};
  }

  ReadModel take(std::vector<Point3> points) {
    if (attributes_ > 1) warnings_.add("left out: attributes of tets but the first");
    ReadModel read;
    read.model =
        solid_.take(IdVector<VertexId, Point3>(std::move(points)), comments_.names(), warnings_);
    read.model.about = comments_.about();
    read.warnings = nodes_.warnings;
    for (Warning& warning : warnings_.take()) read.warnings.push_back(std::move(warning));
    return read;
  }

 private:
  using Row = std::vector<std::string_view>;

  Error complain(const std::string& message) const {
    return row_error(source_.name, rows_.line(), message);
  }

  void take_comments() {
    for (std::size_t at = source_.bytes.find('#'); at != std::string_view::npos;) {
      const std::string_view rest = source_.bytes.substr(at + 1);
      const std::string_view comment = rest.substr(0, rest.find('\n'));
      comments_.take(comment);
      at = source_.bytes.find('#', at + 1 + comment.size());
    }
  }

  Result<void> take_head(const Row& row) {
    std::array<std::int64_t, 3> head{};
    if (row.size() < 2 || row.size() > 3) {
      return row_form_error(source_.name, rows_.line(), "count 4 attributes", row.size());
    }
    for (std::size_t i = 0; i < row.size(); ++i) {
      const auto number = parse_integer(row[i]);
      if (!number || *number < 0) return complain(in_quotes(row[i]) + " is no count");
      head[i] = *number;
    }
    if (head[1] != 4) {
      return complain("tets of " + std::to_string(head[1]) + " points; only those of 4 are read");
    }
    count_ = static_cast<std::size_t>(head[0]);
    attributes_ = static_cast<std::size_t>(head[2]);
    return {};
  }

  Result<void> take_tet(const Row& row) {
    if (solid_.size() == count_ || solid_.size() + 1 >= kMostModelTets) {
      return complain("more tets than the " + std::to_string(count_) + " announced, or 2^30");
    }
    if (row.size() < 5 || row.size() - 5 != attributes_) {
      return complain("expected a number, four points and " + std::to_string(attributes_) +
                      " attributes, got " + std::to_string(row.size()) + " fields");
    }
    const auto due = nodes_.first + static_cast<std::int64_t>(solid_.size());
    if (parse_integer(row[0]) != due) {
      return complain("tets are numbered in order as points are, from " +
                      std::to_string(nodes_.first) + ", not " + in_quotes(row[0]));
    }
    TetVertices tet;
    for (std::size_t k = 0; k < 4; ++k) {
      const auto number = parse_integer(row[1 + k]);
      const auto end = nodes_.first + static_cast<std::int64_t>(nodes_.points.size());
      if (!number || *number < nodes_.first || *number >= end) {
        return complain(in_quotes(row[1 + k]) + " is none of the points, which count from " +
                        std::to_string(nodes_.first) + " to " + std::to_string(end - 1));
      }
      tet[k] = VertexId(*number - nodes_.first);
    }
    std::int64_t group = GroupedSolid::kNoGroup;
    if (attributes_ > 0) {
      const ParsedNumber region = parse_number(row[5]);
      // TetGen takes any number for a region, and writes it as such. Above 2^53, and this is a
      // round number below, doubles no longer tell integers apart.
      constexpr double kMost = 9e15;
      if (!region.ok() || region.value != std::floor(region.value) ||
          std::fabs(region.value) > kMost) {
        return complain(in_quotes(row[5]) + " is no number of a region");
      }
      group = static_cast<std::int64_t>(region.value);
    }
    solid_.add_tet(tet, group);
    return {};
  }

  const Source& source_;
  const NodePoints& nodes_;
  WarningList warnings_;
  SolidComments comments_;
  TableRows rows_;
  std::size_t count_ = 0;
  std::size_t attributes_ = 0;
  GroupedSolid solid_;
};

}  // namespace

Result<ReadModel> read_tetgen(const Source& source, const ReadOptions& /*options*/) {
  Result<NodePoints> nodes = points_beside(source);
  if (!nodes) return nodes.error();
  EleReader reader(source, *nodes);
  if (Result<void> rows = reader.read(); !rows) return rows.error();
  return reader.take(std::move(nodes->points));
}

}  // namespace tetloft::internal::io

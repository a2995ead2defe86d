// Gmsh's files (.msh): versions 2.0 to 2.2, and 4.1; text, and binary of either order of bytes
// (reference manual, sections "MSH file format" and "MSH file format version 2").
//
// Tets of four nodes are kept. A component is a physical group, with its name, or else an entity.
// Elements of lower dimension are the boundary of those, which follows from them; other solid
// elements are counted. Nodes, and tets, are put in the order of their numbers.
#include "io/msh_read.hpp"

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "core/guard.hpp"
#include "io/cursor.hpp"
#include "io/data_cursor.hpp"
#include "io/groups.hpp"
#include "io/msh_write.hpp"
#include "io/numbered_mesh.hpp"
#include "io/numbers.hpp"
#include "io/solid_comments.hpp"
#include "model/well_formed.hpp"

namespace tetloft::internal::io {

namespace {

// By Gmsh's number of the kind of element, less 1: how many nodes, and of which dimension.
struct MshKind {
  int nodes;
  int dimension;
};
constexpr std::array<MshKind, 31> kMshKinds{
    {{2, 1},  {3, 2},  {4, 2},  {4, 3}, {8, 3}, {6, 3},  {5, 3},  {3, 1},  {6, 2}, {9, 2},  {10, 3},
     {27, 3}, {18, 3}, {14, 3}, {1, 0}, {8, 2}, {20, 3}, {15, 3}, {13, 3}, {9, 2}, {10, 2}, {12, 2},
     {15, 2}, {15, 2}, {21, 2}, {4, 1}, {5, 1}, {6, 1},  {20, 3}, {35, 3}, {56, 3}}};

class MshReader {
 public:
  explicit MshReader(const Source& source)
      : cursor_(source.bytes, source.name), warnings_(source.name) {}

  ReadModel read() {
    for (;;) {
      const std::string_view word = cursor_.word();
      if (word.empty()) break;
      if (word.front() != '$') cursor_.fail(in_quotes(word) + " begins no section");
      read_section(word.substr(1));
    }
    if (!seen_.contains("Elements")) cursor_.fail("the file has no section $Elements");
    return finish();
  }

 private:
  // Of a group: physical ones by their number, entities above them.
  static constexpr std::int64_t kEntities = std::int64_t{1} << 33;

  void read_section(std::string_view name) {
    const bool first = seen_.empty() || name == "Comments";
    if (first != (name == "MeshFormat" || name == "Comments")) {
      cursor_.fail("this is no file of Gmsh: it does not begin with $MeshFormat");
    }
    if (name == "MeshFormat") {
      read_format();
    } else if (name == "PhysicalNames") {
      read_names();
    } else if (name == "Comments") {
      read_comments();
    } else if (name == "Entities" && version_ == 4) {
      read_entities();
    } else if (name == "Nodes") {
      once(name);
      version_ == 4 ? read_nodes() : read_nodes2();
      index_nodes();
    } else if (name == "Elements") {
      if (!seen_.contains("Nodes")) cursor_.fail("$Elements stand before $Nodes");
      once(name);
      version_ == 4 ? read_elements() : read_elements2();
    } else {
      pass_over(name);
    }
    const std::string_view end = cursor_.word();
    if (end != "$End" + std::string(name)) {
      cursor_.fail("section $" + std::string(name) + " does not end where it should");
    }
  }

  void once(std::string_view name) {
    if (!seen_.insert(name).second) cursor_.fail("section $" + std::string(name) + " stands twice");
  }

  // Data of a section that is not looked at; its end is left to be read.
  std::string_view pass_over(std::string_view name) {
    const std::size_t end = cursor_.rest().find("$End" + std::string(name));
    if (end == std::string_view::npos) {
      cursor_.fail("section $" + std::string(name.substr(0, 40)) + " does not end");
    }
    return cursor_.bytes(end);
  }

  void read_format() {
    once("MeshFormat");
    const std::string_view version = cursor_.word();
    const std::int64_t form = cursor_.text_integer();
    const std::int64_t size = cursor_.text_integer();
    const bool old = version == "2" || version.substr(0, 2) == "2.";
    if (!old && version != "4.1") {
      cursor_.fail("version " + in_quotes(version) +
                   " of Gmsh's files is not read; 2.2 and 4.1 are: write it anew");
    }
    version_ = old ? 2 : 4;
    if (form == 0) return;
    if (form != 1 || size != 8) cursor_.fail("this is no form of Gmsh's files");
    cursor_.line();
    cursor_.set_form(DataForm::little_endian);
    const std::int64_t one = cursor_.integer(ScalarType::int32);
    if (one == 1) return;
    if (one != std::int64_t{1} << 24) cursor_.fail("the order of bytes is none");
    cursor_.set_form(DataForm::big_endian);
  }

  // N, and lines: dimension, number, "name".
  void read_names() {
    const std::size_t count = cursor_.text_count("names");
    for (std::size_t i = 0; i < count; ++i) {
      const std::int64_t dimension = cursor_.text_integer();
      const std::int64_t number = cursor_.text_integer();
      std::string_view name = trimmed(cursor_.line());
      if (name.size() < 2 || name.front() != '"' || name.back() != '"') {
        cursor_.fail("a physical group has no name in quotes");
      }
      name = name.substr(1, name.size() - 2);
      if (dimension == 3) names_.emplace(number, name);
    }
  }

  void read_comments() {
    cursor_.line();
    DataCursor comments(pass_over("Comments"), {});
    while (comments.left() != 0) {
      std::string_view line = comments.line();
      if (line.substr(0, kMshComment.size()) == kMshComment) {
        line.remove_prefix(kMshComment.size());
      }
      comments_.take(line);
    }
  }

  std::size_t size() {
    const std::int64_t value = cursor_.integer(ScalarType::uint64);
    if (value < 0) cursor_.fail("a count is too large");
    return static_cast<std::size_t>(value);
  }
  std::int64_t integer() {
    const std::int64_t value = cursor_.integer(ScalarType::int32);
    if (value != static_cast<std::int32_t>(value)) cursor_.fail("a number has more than 32 bits");
    return value;
  }

  void begin_numbers() {
    if (cursor_.form() != DataForm::text) cursor_.line();
  }

  // Of volumes the first physical group is that of their tets.
  void read_entities() {
    once("Entities");
    if (seen_.contains("Elements")) cursor_.fail("$Entities stand behind $Elements");
    begin_numbers();
    std::array<std::size_t, 4> count{};
    for (std::size_t& c : count) c = size();
    for (std::size_t dimension = 0; dimension < 4; ++dimension) {
      for (std::size_t i = 0; i < count[dimension]; ++i) {
        const std::int64_t number = integer();
        cursor_.skip(dimension == 0 ? 3 : 6, ScalarType::float64);
        const std::size_t groups = size();
        for (std::size_t k = 0; k < groups; ++k) {
          const std::int64_t group = integer();
          if (k == 0 && dimension == 3 && group != 0) physical_.emplace(number, std::abs(group));
        }
        if (dimension != 0) cursor_.skip(size(), ScalarType::int32);
      }
    }
  }

  void add_node(std::int64_t number) {
    const double x = cursor_.number(ScalarType::float64);
    const double y = cursor_.number(ScalarType::float64);
    mesh_.add_node(number, {x, y, cursor_.number(ScalarType::float64)});
  }

  void read_nodes() {
    begin_numbers();
    const std::size_t blocks = size();
    const std::size_t count = size();
    cursor_.skip(2, ScalarType::uint64);  // the least number and the largest
    std::vector<std::int64_t> numbers;
    for (std::size_t block = 0; block < blocks; ++block) {
      const std::int64_t dimension = integer();
      static_cast<void>(integer());  // the entity
      const std::int64_t parametric = integer();
      const std::size_t in_block = size();
      if (dimension < 0 || dimension > 3) cursor_.fail("an entity has no dimension that there is");
      cursor_.require(in_block, ScalarType::uint64);
      numbers.clear();
      for (std::size_t i = 0; i < in_block; ++i) {
        numbers.push_back(cursor_.integer(ScalarType::uint64));
      }
      for (const std::int64_t number : numbers) {
        add_node(number);
        const auto parameters = static_cast<std::uint64_t>(parametric != 0 ? dimension : 0);
        cursor_.skip(parameters, ScalarType::float64);
      }
    }
    expect_count("$Nodes", mesh_.nodes(), count);
  }

  void read_nodes2() {
    const std::size_t count = cursor_.text_count("nodes");
    begin_numbers();
    for (std::size_t i = 0; i < count; ++i) add_node(integer());
  }

  void expect_count(const char* what, std::size_t found, std::size_t due) const {
    if (found == due) return;
    cursor_.fail(std::string(what) + " hold " + std::to_string(found) + " where " +
                 std::to_string(due) + " are announced");
  }

  void index_nodes() {
    if (const auto twice = mesh_.index_nodes()) {
      cursor_.fail("node " + std::to_string(*twice) + " stands twice");
    }
    if (mesh_.nodes() >= VertexId::kInvalid) cursor_.fail("the file holds too many nodes");
  }

  VertexId vertex_of(std::int64_t number) const {
    const auto vertex = mesh_.find(number);
    if (vertex) return *vertex;
    cursor_.fail("an element refers to node " + std::to_string(number) + ", which there is not");
  }

  // Of one element behind its number and tags.
  void take_element(std::int64_t kind, std::int64_t number, std::int64_t group, ScalarType type) {
    ++elements_;
    if (kind == kMshTet) {
      TetVertices corners;
      for (VertexId& v : corners) v = vertex_of(cursor_.integer(type));
      if (mesh_.tets() + 1 >= kMostModelTets) cursor_.fail("the file holds too many tets");
      mesh_.add_tet(number, corners, group);
      return;
    }
    const std::optional<MshKind> known = kind_of(kind);
    if (known) {
      cursor_.skip(static_cast<std::uint64_t>(known->nodes), type);
    } else if (cursor_.form() == DataForm::text) {
      cursor_.line();
    } else {
      cursor_.fail("elements of kind " + std::to_string(kind) + " are not known");
    }
    if (!known || known->dimension == 3) ++others_;
  }

  static std::optional<MshKind> kind_of(std::int64_t kind) {
    if (kind < 1 || static_cast<std::size_t>(kind) > kMshKinds.size()) return std::nullopt;
    return kMshKinds[static_cast<std::size_t>(kind) - 1];
  }

  static std::int64_t group_of(std::int64_t physical, std::int64_t entity) {
    if (physical != 0) return std::abs(physical);
    return entity == 0 ? GroupedSolid::kNoGroup : kEntities + entity;
  }

  void read_elements() {
    begin_numbers();
    const std::size_t blocks = size();
    const std::size_t count = size();
    cursor_.skip(2, ScalarType::uint64);
    std::size_t found = 0;
    for (std::size_t block = 0; block < blocks; ++block) {
      static_cast<void>(integer());  // the dimension, which follows from the kind
      const std::int64_t entity = integer();
      const std::int64_t kind = integer();
      const std::size_t in_block = size();
      const auto physical = physical_.find(entity);
      const std::int64_t group =
          group_of(physical == physical_.end() ? 0 : physical->second, entity);
      for (std::size_t i = 0; i < in_block; ++i) {
        const std::int64_t number = cursor_.integer(ScalarType::uint64);
        take_element(kind, number, group, ScalarType::uint64);
      }
      found += in_block;
    }
    expect_count("$Elements", found, count);
  }

  void read_elements2() {
    const std::size_t count = cursor_.text_count("elements");
    begin_numbers();
    const bool text = cursor_.form() == DataForm::text;
    for (std::size_t found = 0; found < count;) {
      std::int64_t number = text ? integer() : 0;
      const std::int64_t kind = integer();
      // Binary elements follow in rows of one kind.
      const std::int64_t in_row = text ? 1 : integer();
      const std::int64_t tags = integer();
      if (in_row < 1 || static_cast<std::uint64_t>(in_row) > count - found || tags < 0) {
        cursor_.fail("elements of " + std::to_string(tags) + " tags, " + std::to_string(in_row) +
                     " in a row, cannot be");
      }
      for (std::int64_t i = 0; i < in_row; ++i) {
        if (!text) number = integer();
        std::array<std::int64_t, 2> tag{};
        for (std::int64_t k = 0; k < tags; ++k) {
          const std::int64_t value = integer();
          if (k < 2) tag[static_cast<std::size_t>(k)] = value;
        }
        take_element(kind, number, group_of(tag[0], tag[1]), ScalarType::int32);
      }
      found += static_cast<std::size_t>(in_row);
    }
  }

  ReadModel finish() {
    if (elements_ != 0 && mesh_.tets() == 0) {
      cursor_.fail("none of the elements is a tet of four nodes");
    }
    if (others_ != 0) {
      warnings_.add("left out: " + std::to_string(others_) +
                    (others_ == 1 ? " element that is" : " elements that are") +
                    " no tet of four nodes");
    }
    ReadModel read{mesh_.take(names_, warnings_), {}};
    read.model.about = comments_.about();
    read.warnings = warnings_.take();
    return read;
  }

  DataCursor cursor_;
  WarningList warnings_;
  int version_ = 0;
  std::set<std::string_view> seen_;  // sections that may stand once
  SolidComments comments_;
  std::map<std::int64_t, std::string> names_;      // of physical groups of volumes
  std::map<std::int64_t, std::int64_t> physical_;  // of volumes: their group
  NumberedMesh mesh_;
  std::size_t elements_ = 0;
  std::size_t others_ = 0;  // of these: solid ones that are no tet of four nodes
};

}  // namespace

bool is_msh(std::string_view bytes) {
  constexpr std::size_t kBeginning = 4096;  // room for comments
  const std::string_view head = trimmed(bytes.substr(0, kBeginning));
  return head.substr(0, 11) == "$MeshFormat" ||
         (head.substr(0, 9) == "$Comments" && head.find("$MeshFormat") != std::string_view::npos);
}

Result<ReadModel> read_msh(const Source& source, const ReadOptions& /*options*/) {
  try {
    return MshReader(source).read();
  } catch (const Failed& failed) {
    return failed.error();
  }
}

}  // namespace tetloft::internal::io

// MEDIT's .mesh: keywords, each followed by a count and rows of numbers; white space between all of
// them, # begins a comment.
#include "io/medit_read.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <string>
#include <utility>

#include "io/cursor.hpp"
#include "io/groups.hpp"
#include "io/numbers.hpp"
#include "io/rows.hpp"
#include "io/solid_comments.hpp"
#include "io/warning_list.hpp"
#include "model/well_formed.hpp"

namespace tetloft::internal::io {

namespace {

// What else there is are faces, edges and corners, marks of them, and normals.
constexpr std::array<std::string_view, 6> kOtherMeditCells{
    "Hexahedra", "Prisms", "Pentahedra", "Pyramids", "TetrahedraP2", "Polyhedra"};

class MeditReader {
 public:
  explicit MeditReader(const Source& source)
      : cursor_(source.bytes), name_(source.name), warnings_(source.name) {}

  Result<ReadModel> read() {
    std::string_view word = next();
    for (; !word.empty() && word != "End"; word = next()) {
      if (!is_letter(word.front())) return complain(in_quotes(word) + " stands for a keyword");
      if (Result<void> taken = take_section(word); !taken) return taken.error();
    }
    if (word.empty()) warnings_.add("the file has no End: it may have been cut off");
    if (!has_tets_) return complain("the file has no Tetrahedra");
    if (largest_ > points_.size()) {
      return complain("a tetrahedron refers to vertex " + std::to_string(largest_) + " of " +
                      std::to_string(points_.size()));
    }
    ReadModel read;
    read.model = solid_.take(std::move(points_), comments_.names(), warnings_);
    read.model.about = comments_.about();
    read.warnings = warnings_.take();
    return read;
  }

 private:
  Error complain(const std::string& message) const {
    return row_error(name_, cursor_.line(), message);
  }

  // The next word, or nothing at the end.
  std::string_view next() {
    for (cursor_.skip_white(); cursor_.peek() == '#'; cursor_.skip_white()) {
      const std::string_view rest = cursor_.rest();
      comments_.take(rest.substr(1, rest.find('\n') - 1));
      cursor_.skip_line();
    }
    return cursor_.token(kWhiteOrComment);
  }

  Result<void> take_section(std::string_view keyword) {
    if (keyword == "MeshVersionFormatted") {
      if (!parse_integer(next())) return complain("MeshVersionFormatted is followed by a number");
      return {};
    }
    if (keyword == "Dimension") {
      const std::string_view dimension = next();
      if (dimension == "3") return {};
      return complain("points of dimension " + in_quotes(dimension) + "; only 3 is read");
    }
    if (keyword == "Vertices") return take_vertices();
    if (keyword == "Tetrahedra") return take_tets();
    const bool cells = std::find(kOtherMeditCells.begin(), kOtherMeditCells.end(), keyword) !=
                       kOtherMeditCells.end();
    TextCursor ahead = cursor_;
    ahead.skip_white();
    const std::int64_t count = parse_integer(ahead.token(kWhiteOrComment)).value_or(0);
    if (cells && count > 0) {
      warnings_.add("left out: " + std::to_string(count) + ' ' + std::string(keyword),
                    cursor_.line());
    }
    skip_numbers();
    return {};
  }

  void skip_numbers() {
    while (true) {
      const TextCursor before = cursor_;
      const std::string_view word = next();
      if (word.empty()) return;
      if (!is_letter(word.front())) continue;
      cursor_ = before;
      return;
    }
  }

  Result<std::size_t> take_count(const char* of) {
    const std::string_view word = next();
    const auto count = parse_integer(word);
    if (!count || *count < 0) return complain(in_quotes(word) + " is no count of " + of);
    return static_cast<std::size_t>(*count);
  }

  Error ends(const char* of, std::size_t here, std::size_t announced) const {
    return complain(std::to_string(announced) + ' ' + of + " are announced, the file ends after " +
                    std::to_string(here));
  }

  // The reference of a vertex or tetrahedron.
  Result<std::int64_t> take_reference() {
    const std::string_view word = next();
    if (const auto reference = parse_integer(word)) return *reference;
    return complain(in_quotes(word) + " is no reference");
  }

  Result<void> take_vertices() {
    if (!points_.empty()) return complain("Vertices stand twice");
    const Result<std::size_t> count = take_count("vertices");
    if (!count) return count.error();
    for (std::size_t v = 0; v < *count; ++v) {
      std::array<double, 3> xyz{};
      for (double& c : xyz) {
        const std::string_view word = next();
        if (word.empty()) return ends("vertices", v, *count);
        const ParsedNumber number = parse_number(word);
        if (!number.ok()) return complain(complaint(word, number.status));
        c = number.value;
      }
      points_.push_back({xyz[0], xyz[1], xyz[2]});
      if (const auto reference = take_reference(); !reference) return reference.error();
    }
    return {};
  }

  Result<void> take_tets() {
    has_tets_ = true;
    const Result<std::size_t> count = take_count("tetrahedra");
    if (!count) return count.error();
    for (std::size_t t = 0; t < *count; ++t) {
      if (solid_.size() + 1 >= kMostModelTets) return complain("2^30 tets or more");
      TetVertices tet;
      for (VertexId& v : tet) {
        const std::string_view word = next();
        if (word.empty()) return ends("tetrahedra", t, *count);
        const auto number = parse_integer(word);
        if (!number || *number < 1 || *number > std::int64_t{UINT32_MAX} - 1) {
          return complain(in_quotes(word) + " is no number of a vertex, which count from 1");
        }
        largest_ = std::max(largest_, static_cast<std::size_t>(*number));
        v = VertexId(*number - 1);
      }
      const Result<std::int64_t> reference = take_reference();
      if (!reference) return reference.error();
      solid_.add_tet(tet, *reference);
    }
    return {};
  }

  TextCursor cursor_;
  const std::string& name_;
  WarningList warnings_;
  SolidComments comments_;
  IdVector<VertexId, Point3> points_;
  GroupedSolid solid_;
  std::size_t largest_ = 0;  // vertex of a tet, from 1; the points may follow
  bool has_tets_ = false;
};

}  // namespace

Result<ReadModel> read_medit(const Source& source, const ReadOptions& /*options*/) {
  return MeditReader(source).read();
}

}  // namespace tetloft::internal::io

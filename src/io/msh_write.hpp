// What both versions of Gmsh's files share: words and numbers, as text or as bytes; names of
// physical groups.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include <tetloft/model.hpp>

#include "core/little_endian.hpp"
#include "io/format.hpp"
#include "io/groups.hpp"
#include "io/numbers.hpp"

namespace tetloft::internal::io {

/// Appends to a file; numbers as its encoding says, those of a row in a line of text.
class MshWriter {
 public:
  MshWriter(Sink& sink, Encoding encoding) : pieces_(sink), ascii_(encoding == Encoding::ascii) {}

  [[nodiscard]] bool ascii() const { return ascii_; }
  /// A line of text, whatever the encoding.
  void line(std::string_view text) {
    pieces_.text() += text;
    pieces_.text() += '\n';
    pieces_.next();
  }
  /// An int of Gmsh, a size_t, a double.
  void integer(std::int64_t value) { append(static_cast<std::int32_t>(value)); }
  void size(std::uint64_t value) { append(value); }
  void number(double value) { append(value); }
  void point(const Point3& p) {
    for (const double x : {p.x, p.y, p.z}) number(x);
  }
  void end_row() {
    if (ascii_ && !pieces_.text().empty()) pieces_.text().back() = '\n';
    pieces_.next();
  }
  /// Behind the numbers of a section: its end.
  void end_section(std::string_view name) {
    if (!ascii_) pieces_.text() += '\n';
    line("$End" + std::string(name));
  }
  void finish() { pieces_.finish(); }

 private:
  template <class T>
  void append(T value) {
    if (ascii_) {
      append_number(pieces_.text(), value);
      pieces_.text() += ' ';
    } else {
      append_little(pieces_.text(), value);
    }
  }

  Pieces pieces_;
  bool ascii_;
};

/// A component with its entities: a volume, and the surface around it, of the same number.
struct MshGroup {
  ComponentGroup group;
  std::int64_t entity = 0;
};

/// Of a model; one without tets if it has points, but no tets. Error invalid_input where numbers
/// do not fit the 32 bits that Gmsh has for them.
[[nodiscard]] Result<std::vector<MshGroup>> msh_groups(const Model& model);

/// What stands before nodes and elements, for append_msh().
[[nodiscard]] std::vector<Warning> append_msh_head(MshWriter& out, std::string_view version,
                                                   const Model& model,
                                                   const std::vector<MshGroup>& groups);

/// Tets, and triangles of boundaries.
[[nodiscard]] std::size_t count_elements(const Model& model, const std::vector<MshGroup>& groups);

/// A file: the format's section, the names of physical groups, what else is known about the whole
/// as comments, and the sections that are `Sections(out, model, groups).append()`. Warnings tell
/// which names had to be written otherwise.
template <class Sections>
[[nodiscard]] std::vector<Warning> append_msh(Sink& sink, Encoding encoding,
                                              std::string_view version, const Model& model,
                                              const std::vector<MshGroup>& groups) {
  MshWriter out(sink, encoding);
  std::vector<Warning> warnings = append_msh_head(out, version, model, groups);
  Sections(out, model, groups).append();
  out.finish();
  return warnings;
}

/// The elements that are written, in Gmsh's numbers.
inline constexpr std::int64_t kMshTriangle = 2;
inline constexpr std::int64_t kMshTet = 4;

/// What the lines of comments begin with.
inline constexpr std::string_view kMshComment = "#";

}  // namespace tetloft::internal::io

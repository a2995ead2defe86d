// See stl_read.hpp.
#include "io/stl_read.hpp"

#include <array>
#include <cmath>
#include <cstdint>
#include <string>
#include <utility>

#include "core/little_endian.hpp"
#include "core/text.hpp"
#include "io/cursor.hpp"
#include "io/numbers.hpp"
#include "io/rows.hpp"

namespace tetloft::internal::io {

namespace {

std::uint64_t announced_bytes(std::string_view bytes) {
  const auto triangles = load_little<std::uint32_t>(bytes.data() + kStlHeadBytes - 4);
  return kStlHeadBytes + std::uint64_t{triangles} * kStlTriangleBytes;
}

void add_triangle(const std::array<Point3, 3>& corners, TriangleMesh& mesh) {
  const auto first = static_cast<std::uint32_t>(mesh.points.size());
  mesh.points.insert(mesh.points.end(), corners.begin(), corners.end());
  mesh.triangles.push_back({first, first + 1, first + 2});
}

Warning stl_warning(const Source& source, const std::string& message) {
  Warning warning{message, {}};
  warning.where.file = source.name;
  return warning;
}

Result<ReadTriangles> read_binary(const Source& source) {
  const auto refuse = [&](const std::string& message) {
    Error error{ErrorCode::invalid_input, message, {}};
    error.where.file = source.name;
    return error;
  };
  const std::string_view bytes = source.bytes;
  if (bytes.size() < kStlHeadBytes) {
    return refuse(
        "this is no STL: neither text that begins with 'solid', nor the 84 bytes of a "
        "binary head");
  }
  const std::uint64_t announced = announced_bytes(bytes);
  if (bytes.size() < announced) {
    return refuse("the file is cut off, or no STL: " + std::to_string(announced) +
                  " bytes are announced, here are " + std::to_string(bytes.size()));
  }
  ReadTriangles read;
  for (std::uint64_t at = kStlHeadBytes; at < announced; at += kStlTriangleBytes) {
    std::array<Point3, 3> corners;
    for (std::size_t k = 0; k < 3; ++k) {
      const char* const from = bytes.data() + at + 12 * (k + 1);  // behind the normal
      corners[k] = {load_little<float>(from), load_little<float>(from + 4),
                    load_little<float>(from + 8)};
      const Point3& p = corners[k];
      if (std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z)) continue;
      return refuse("byte " + std::to_string(at + 12 * (k + 1)) + ": corner " + std::to_string(k) +
                    " of triangle " + std::to_string((at - kStlHeadBytes) / kStlTriangleBytes) +
                    " is not finite");
    }
    add_triangle(corners, read.mesh);
  }
  if (bytes.size() > announced) {
    read.warnings.push_back(
        stl_warning(source, "left out: " + std::to_string(bytes.size() - announced) +
                                " bytes behind the last triangle announced"));
  }
  return read;
}

class StlText {
 public:
  explicit StlText(const Source& source) : source_(source), cursor_(source.bytes) {}

  Result<ReadTriangles> read() {
    for (cursor_.skip_white(); !cursor_.at_end(); cursor_.skip_white()) {
      if (Result<void> taken = take_word(); !taken) return taken.error();
    }
    if (in_facet_) return complain("the file ends inside of a facet");
    if (in_solid_) {
      read_.warnings.push_back(
          stl_warning(source_, "the file ends without 'endsolid': it may be cut off"));
    }
    return std::move(read_);
  }

 private:
  Error complain(const std::string& message) const {
    return row_error(source_.name, cursor_.line(), message);
  }

  // Whether the word is `expected`, which is in lower case.
  static bool is(std::string_view word, std::string_view expected) {
    return word.size() == expected.size() && lower_case(word) == expected;
  }

  std::string_view next() {
    cursor_.skip_white();
    return cursor_.token();
  }

  Result<void> take_word() {
    const std::string_view word = cursor_.token();
    if (is(word, "solid") || is(word, "endsolid")) {
      if (in_facet_) return complain(in_quotes(word) + " inside of a facet");
      in_solid_ = is(word, "solid");
      cursor_.skip_line();  // a name
      return {};
    }
    if (is(word, "facet") && !in_facet_) {
      in_facet_ = true;
      corners_ = 0;
      if (!is(next(), "normal")) return complain("'facet' without 'normal'");
      for (int i = 0; i < 3; ++i) next();  // some write nan
      return {};
    }
    if (is(word, "outer") && in_facet_) {
      return is(next(), "loop") ? Result<void>() : complain("'outer' without 'loop'");
    }
    if (is(word, "vertex") && in_facet_) return take_corner();
    if (is(word, "endloop") && in_facet_) return {};
    if (is(word, "endfacet") && in_facet_) {
      in_facet_ = false;
      if (corners_ != 3) {
        return complain("a facet has three vertices, here are " + std::to_string(corners_));
      }
      add_triangle(corner_, read_.mesh);
      return {};
    }
    return complain("unexpected " + in_quotes(word));
  }

  Result<void> take_corner() {
    std::array<double, 3> xyz{};
    for (double& c : xyz) {
      const std::string_view text = next();
      const ParsedNumber number = parse_number(text);
      if (!number.ok()) return complain(complaint(text, number.status));
      c = number.value;
    }
    if (corners_ < 3) corner_[corners_] = {xyz[0], xyz[1], xyz[2]};
    ++corners_;
    return {};
  }

  const Source& source_;
  TextCursor cursor_;
  bool in_solid_ = false;
  bool in_facet_ = false;
  std::size_t corners_ = 0;
  std::array<Point3, 3> corner_;
  ReadTriangles read_;
};

// Text has no zeros; binary files have them in their head at the latest, in the count.
bool is_stl_text(std::string_view bytes) {
  const std::string_view head = bytes.substr(0, kStlHeadBytes);
  std::string_view text = head;
  if (text.substr(0, 3) == "\xEF\xBB\xBF") text.remove_prefix(3);
  while (!text.empty() && is_white(text.front())) text.remove_prefix(1);
  constexpr std::string_view kSolid = "solid";
  for (std::size_t i = 0; i < kSolid.size(); ++i) {
    if (i >= text.size() || (text[i] | 0x20) != kSolid[i]) return false;
  }
  return head.find('\0') == std::string_view::npos;
}

}  // namespace

bool is_binary_stl(std::string_view bytes) {
  return bytes.size() >= kStlHeadBytes && bytes.size() == announced_bytes(bytes);
}

Result<ReadTriangles> read_stl(const Source& source, const ReadOptions& /*options*/) {
  if (!is_binary_stl(source.bytes) && is_stl_text(source.bytes)) return StlText(source).read();
  return read_binary(source);
}

}  // namespace tetloft::internal::io

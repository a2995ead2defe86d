// Solids as legacy VTK files (.vtk): the unstructured grid of "VTK File Formats", "Simple Legacy
// Formats".
//
// Written is version 3.0. Its layout is that of all before 5.0, which whatever reads .vtk files
// takes; programs that know 4.x or 5.x take it too, while many know neither. Binary data are
// big-endian in all of them.
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string>
#include <type_traits>
#include <vector>

#include "core/little_endian.hpp"
#include "core/text.hpp"
#include "io/format.hpp"
#include "io/numbers.hpp"
#include "io/vtk_read.hpp"
#include "io/vtk_text.hpp"
#include "io/vtu_read.hpp"
#include "model/fields.hpp"

namespace tetloft::internal::io {

namespace {

bool is_legacy_vtk(std::string_view bytes) { return bytes.substr(0, 14) == "# vtk DataFile"; }

template <class T>
constexpr const char* legacy_type_name() {
  if constexpr (std::is_same_v<T, std::int32_t>) return "int";
  if constexpr (std::is_same_v<T, std::uint8_t>) return "unsigned_char";
  return nullptr;
}

// The second line: what the solid is, in the 255 bytes that readers have for it.
std::string title_of(const Model& model) {
  constexpr std::size_t kLongest = 255;
  const std::string title = printable(model.about.name);
  return title.empty() ? "solid" : std::string(beginning(title, kLongest));
}

class LegacyWriter {
 public:
  LegacyWriter(Sink& sink, bool ascii) : pieces_(sink), ascii_(ascii) {}

  void line(const std::string& text) {
    pieces_.text() += text + '\n';
    pieces_.next();
  }

  // n values of type T, `row` of them in a line of text.
  template <class T, class Get>
  void values(std::size_t n, std::size_t row, Get get) {
    std::string& text = pieces_.text();
    for (std::size_t i = 0; i < n; ++i) {
      const T value = get(i);
      if (!ascii_) {
        append_little(text, value);
        std::reverse(text.end() - static_cast<std::ptrdiff_t>(sizeof(T)), text.end());
      } else {
        if constexpr (sizeof(T) == 1) {
          append_number(text, static_cast<int>(value));
        } else {
          append_number(text, value);
        }
        text += (i + 1) % row == 0 || i + 1 == n ? '\n' : ' ';
      }
      pieces_.next();
    }
    if (!ascii_) text += '\n';
  }

  void finish() { pieces_.finish(); }

 private:
  Pieces pieces_;
  bool ascii_;
};

constexpr std::size_t kRow = 16;

void append_texts(LegacyWriter& out, const Model& model) {
  const std::vector<VtkText> texts = texts_of(model);
  if (texts.empty()) return;
  out.line("FIELD FieldData " + std::to_string(texts.size()));
  for (const VtkText& text : texts) {
    const std::string& bytes = text.bytes;
    out.line(std::string(text.array) + " 1 " + std::to_string(bytes.size()) + " unsigned_char");
    out.values<std::uint8_t>(bytes.size(), kRow, [&bytes](std::size_t i) {
      return static_cast<std::uint8_t>(bytes[i]);
    });
  }
}

// The first as scalars, by which programs colour what they show; the others as arrays of a field.
void append_fields(LegacyWriter& out, const Model& model, bool of_points) {
  std::size_t count = 0;
  const auto for_each_present = [&](const auto& visit) {
    for_each_field([&](const auto& field) {
      const auto& values = (model.*field.values).raw();
      if (field.kOfPoints == of_points && !values.empty()) visit(field, values);
    });
  };
  for_each_present([&](const auto&, const auto&) { ++count; });
  if (count == 0) return;
  out.line((of_points ? "POINT_DATA " : "CELL_DATA ") +
           std::to_string(of_points ? model.points.size() : model.tets.size()));
  bool first = true;
  for_each_present([&](const auto& field, const auto& values) {
    using Stored = typename std::remove_cvref_t<decltype(field)>::Stored;
    const std::string name(field.name);
    const std::string type = legacy_type_name<typename Stored::Type>();
    if (first) {
      out.line("SCALARS " + name + ' ' + type + " 1\nLOOKUP_TABLE default");
    } else {
      out.line(name + " 1 " + std::to_string(values.size()) + ' ' + type);
    }
    out.values<typename Stored::Type>(values.size(), kRow,
                                      [&](std::size_t i) { return Stored::store(values[i]); });
    if (first && count > 1) out.line("FIELD FieldData " + std::to_string(count - 1));
    first = false;
  });
}

Written write_vtk(Sink& sink, const Model& model, const Target& target) {
  // Ids, and how many numbers the cells have, are of 32 bits.
  constexpr std::size_t kMost = 0x7FFFFFFF;
  const std::size_t tets = model.tets.size();
  if (model.points.size() > kMost || tets > kMost / 5) {
    return Error{ErrorCode::invalid_input, "legacy VTK files hold less points and tets: .vtu", {}};
  }
  const bool ascii = target.options.encoding == Encoding::ascii;
  LegacyWriter out(sink, ascii);
  out.line("# vtk DataFile Version 3.0\n" + title_of(model) + (ascii ? "\nASCII" : "\nBINARY") +
           "\nDATASET UNSTRUCTURED_GRID\nPOINTS " + std::to_string(model.points.size()) +
           " double");
  out.values<double>(3 * model.points.size(), 3, [&](std::size_t i) {
    const Point3& p = model.points[VertexId(i / 3)];
    return i % 3 == 0 ? p.x : i % 3 == 1 ? p.y : p.z;
  });
  out.line("CELLS " + std::to_string(tets) + ' ' + std::to_string(5 * tets));
  out.values<std::int32_t>(5 * tets, 5, [&](std::size_t i) {
    return i % 5 == 0 ? 4 : static_cast<std::int32_t>(model.tets[TetId(i / 5)][i % 5 - 1].value());
  });
  out.line("CELL_TYPES " + std::to_string(tets));
  out.values<std::int32_t>(tets, kRow, [](std::size_t) { return std::int32_t{kVtkTetra}; });
  append_texts(out, model);
  append_fields(out, model, false);
  append_fields(out, model, true);
  out.finish();
  return std::vector<Warning>();
}

}  // namespace

extern constinit const Format vtk_format{.name = "vtk",
                                         .summary = "legacy VTK unstructured grid",
                                         .extensions = {".vtk"},
                                         .recognise = is_legacy_vtk,
                                         .read_model = read_vtk,
                                         .write_model = write_vtk};

}  // namespace tetloft::internal::io

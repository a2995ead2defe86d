// Labels of contours, a line each.
#include <array>
#include <cstdint>
#include <limits>
#include <string>

#include "io/format.hpp"
#include "io/numbers.hpp"
#include "io/rows.hpp"

namespace tetloft::internal::io {

namespace {

// Largest value of a section, contour or label: one less than an invalid id.
constexpr std::int64_t kLargestIndex = std::numeric_limits<std::uint32_t>::max() - 1;

Result<std::vector<Label>> read_label_lines(const Source& source, const ReadOptions& /*options*/) {
  constexpr std::array kNames{"section", "contour", "label"};
  std::vector<Label> labels;
  const auto take = [&](std::size_t line, const RowFields& fields) -> Result<void> {
    std::array<std::int64_t, 3> values{};
    for (std::size_t i = 0; i < 3; ++i) {
      const auto value = parse_integer(fields[i]);
      if (!value || *value < 0 || *value > kLargestIndex) {
        return row_error(
            source.name, line,
            in_quotes(fields[i]) + " is no " + kNames[i] + ": expected an integer from 0");
      }
      values[i] = *value;
    }
    labels.push_back(
        {SectionId(values[0]), ContourId(values[1]), static_cast<std::uint32_t>(values[2])});
    return {};
  };
  Result<void> rows = for_each_row(source.bytes, source.name, "section contour label", take);
  if (!rows) return rows.error();
  return labels;
}

Written write_label_lines(Sink& sink, const std::vector<Label>& labels, const Target& /*target*/) {
  Pieces pieces(sink);
  for (const Label& label : labels) {
    append_number(pieces.text(), label.section.value());
    pieces.text() += ' ';
    append_number(pieces.text(), label.contour.value());
    pieces.text() += ' ';
    append_number(pieces.text(), label.label);
    pieces.text() += '\n';
    pieces.next();
  }
  pieces.finish();
  return std::vector<Warning>();
}

}  // namespace

extern constinit const Format labels_format{
    .name = "labels",
    .summary = "lines \"section contour label\", zero-based, # comments",
    .extensions = {".labels", ".txt"},
    .takes_text = true,
    .read_labels = read_label_lines,
    .write_labels = write_label_lines};

}  // namespace tetloft::internal::io

// What users decide of contours: labels, and links joined or parted, a line each.
#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <string>
#include <tuple>

#include "core/spelling.hpp"
#include "io/format.hpp"
#include "io/numbers.hpp"
#include "io/rows.hpp"

namespace tetloft::internal::io {

namespace {

constexpr std::string_view kJoin = "join";
constexpr std::string_view kPart = "part";
constexpr std::string_view kLabelForm = "section contour label";
constexpr std::string_view kDecisionForm = " section contour contour_above";

// Largest value of a section, contour or label: one less than an invalid id.
constexpr std::int64_t kLargestIndex = std::numeric_limits<std::uint32_t>::max() - 1;

using Values = std::array<std::uint32_t, 3>;

bool begins_as_number(std::string_view field) {
  const char c = field.front();
  return (c >= '0' && c <= '9') || c == '-' || c == '+' || c == '.';
}

class LabelReader {
 public:
  explicit LabelReader(const Source& source) : source_(source) {}

  Result<Labels> read() {
    Result<void> good = for_each_row(
        source_.bytes,
        [this](std::size_t line, const RowFields& fields) { return take(line, fields); });
    if (good) good = refuse_contradictions();
    if (!good) return good.error();
    return std::move(labels_);
  }

 private:
  Result<void> take(std::size_t line, const RowFields& fields) {
    const std::string_view word = fields.field[0];
    if (word == kJoin || word == kPart) return take_decision(line, fields, word == kJoin);
    if (!begins_as_number(word)) {
      return row_error(source_.name, line,
                       in_quotes(word) + " is neither join, part nor a section" +
                           did_you_mean(word, {kJoin, kPart}));
    }
    if (fields.count != 3) return row_form_error(source_.name, line, kLabelForm, fields.count);
    const auto values = integers(line, fields, 0, {"section", "contour", "label"});
    if (!values) return values.error();
    const auto [section, contour, label] = *values;
    labels_.labels.push_back({SectionId(section), ContourId(contour), label});
    return {};
  }

  Result<void> take_decision(std::size_t line, const RowFields& fields, bool join) {
    if (fields.count != 4) {
      return row_form_error(source_.name, line,
                            std::string(join ? kJoin : kPart) + std::string(kDecisionForm),
                            fields.count);
    }
    const auto values = integers(line, fields, 1, {"section", "contour", "contour"});
    if (!values) return values.error();
    const auto [section, lower, upper] = *values;
    labels_.decisions.push_back({SlabId(section), ContourId(lower), ContourId(upper), join});
    line_.push_back(line);
    return {};
  }

  // Three of the fields.
  Result<Values> integers(std::size_t line, const RowFields& fields, std::size_t first,
                          const std::array<const char*, 3>& names) const {
    Values values{};
    for (std::size_t i = 0; i < values.size(); ++i) {
      const std::string_view field = fields.field[first + i];
      const auto value = parse_integer(field);
      if (!value || *value < 0 || *value > kLargestIndex) {
        return row_error(source_.name, line,
                         in_quotes(field) + " is no " + names[i] + ": expected an integer from 0");
      }
      values[i] = static_cast<std::uint32_t>(*value);
    }
    return values;
  }

  // Of two lines on the same contours: that on the regions of different ones is found later.
  [[nodiscard]] Result<void> refuse_contradictions() const {
    std::vector<std::size_t> order(line_.size());
    for (std::size_t k = 0; k < order.size(); ++k) order[k] = k;
    const auto link = [this](std::size_t k) {
      const LinkDecision& decision = labels_.decisions[k];
      return std::tuple(decision.slab, decision.lower, decision.upper);
    };
    std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
      return std::tuple(link(a), a) < std::tuple(link(b), b);
    });
    for (std::size_t k = 1; k < order.size(); ++k) {
      const std::size_t before = order[k - 1];
      const std::size_t here = order[k];
      if (link(before) != link(here)) continue;
      if (labels_.decisions[before].join == labels_.decisions[here].join) continue;
      return row_error(
          source_.name, line_[here],
          "join and part of the same contours: see line " + std::to_string(line_[before]));
    }
    return {};
  }

  const Source& source_;
  Labels labels_;
  std::vector<std::size_t> line_;  // of each decision
};

Result<Labels> read_label_lines(const Source& source, const ReadOptions& /*options*/) {
  return LabelReader(source).read();
}

void append_values(Pieces& pieces, const Values& values) {
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (i != 0) pieces.text() += ' ';
    append_number(pieces.text(), values[i]);
  }
  pieces.text() += '\n';
  pieces.next();
}

Written write_label_lines(Sink& sink, const Labels& labels, const Target& /*target*/) {
  Pieces pieces(sink);
  for (const Label& label : labels.labels) {
    append_values(pieces, {label.section.value(), label.contour.value(), label.label});
  }
  for (const LinkDecision& decision : labels.decisions) {
    pieces.text() += decision.join ? kJoin : kPart;
    pieces.text() += ' ';
    append_values(pieces, {decision.slab.value(), decision.lower.value(), decision.upper.value()});
  }
  pieces.finish();
  return std::vector<Warning>();
}

}  // namespace

extern constinit const Format labels_format{
    .name = "labels",
    .summary =
        "lines \"section contour label\", \"join section contour contour_above\" or \"part "
        "section contour contour_above\", zero-based, # comments",
    .extensions = {".labels", ".txt"},
    .takes_text = true,
    .read_labels = read_label_lines,
    .write_labels = write_label_lines};

}  // namespace tetloft::internal::io

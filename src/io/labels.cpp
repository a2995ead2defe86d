// What users decide of contours: labels, and links joined or parted, a line each.
#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <string>
#include <tuple>
#include <vector>

#include "core/spelling.hpp"
#include "io/format.hpp"
#include "io/numbers.hpp"
#include "io/rows.hpp"

namespace tetloft::internal::io {

namespace {

constexpr std::string_view kLabelForm = "section contour label";
constexpr std::string_view kHole = "hole";
constexpr std::string_view kHoleForm = "hole section contour label";
// In place of a hole.
constexpr std::string_view kOutside = "outside";

// Lines of decisions: on regions, or on voids.
struct DecisionForm {
  std::string_view yes, no, fields;
  std::vector<LinkDecision> Labels::*decisions;
};
constexpr std::array<DecisionForm, 2> kDecisions{
    {{"join", "part", " section contour contour_above", &Labels::decisions},
     {"open", "close", " section hole hole_above", &Labels::void_decisions}}};
constexpr std::size_t kOfVoids = 1;

// Largest value of a section, contour or label: one less than an invalid id.
constexpr std::int64_t kLargestIndex = std::numeric_limits<std::uint32_t>::max() - 1;

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
    for (std::size_t kind = 0; kind < kDecisions.size() && good; ++kind) {
      good = refuse_contradictions(kind);
    }
    if (!good) return good.error();
    return std::move(labels_);
  }

 private:
  Result<void> take(std::size_t line, const RowFields& fields) {
    const std::string_view word = fields.field[0];
    for (std::size_t kind = 0; kind < kDecisions.size(); ++kind) {
      const DecisionForm& form = kDecisions[kind];
      if (word == form.yes || word == form.no) return take_decision(line, fields, kind);
    }
    if (word == kHole) return take_label(line, fields, 1, kHoleForm, labels_.hole_labels);
    if (!begins_as_number(word)) {
      return row_error(source_.name, line,
                       in_quotes(word) + " is neither join, part, hole, open, close nor a section" +
                           did_you_mean(word, {"join", "part", kHole, "open", "close"}));
    }
    return take_label(line, fields, 0, kLabelForm, labels_.labels);
  }

  // Its fields begin with `first`.
  Result<void> take_label(std::size_t line, const RowFields& fields, std::size_t first,
                          std::string_view form, std::vector<Label>& labels) {
    if (fields.count != first + 3) return row_form_error(source_.name, line, form, fields.count);
    const auto section = index(line, fields.field[first], "section");
    if (!section) return section.error();
    const auto contour = index(line, fields.field[first + 1], "contour");
    if (!contour) return contour.error();
    const auto label = index(line, fields.field[first + 2], "label");
    if (!label) return label.error();
    labels.push_back({SectionId(*section), ContourId(*contour), *label});
    return {};
  }

  Result<void> take_decision(std::size_t line, const RowFields& fields, std::size_t kind) {
    const DecisionForm& form = kDecisions[kind];
    const std::string_view word = fields.field[0];
    if (fields.count != 4) {
      return row_form_error(source_.name, line, std::string(word) + std::string(form.fields),
                            fields.count);
    }
    const auto section = index(line, fields.field[1], "section");
    if (!section) return section.error();
    const auto lower = contour(line, fields.field[2], kind);
    if (!lower) return lower.error();
    const auto upper = contour(line, fields.field[3], kind);
    if (!upper) return upper.error();
    if (!lower->valid() && !upper->valid()) {
      return row_error(source_.name, line,
                       "the outside is the same in all sections: there is nothing to decide");
    }
    (labels_.*form.decisions).push_back({SlabId(*section), *lower, *upper, word == form.yes});
    line_[kind].push_back(line);
    return {};
  }

  // A contour, or of voids the outside, which has none.
  Result<ContourId> contour(std::size_t line, std::string_view field, std::size_t kind) const {
    if (kind != kOfVoids) {
      const auto value = index(line, field, "contour");
      if (!value) return value.error();
      return ContourId(*value);
    }
    if (field == kOutside) return ContourId();
    const auto value = index(line, field, "hole", " or outside");
    if (!value) return value.error();
    return ContourId(*value);
  }

  Result<std::uint32_t> index(std::size_t line, std::string_view field, const char* name,
                              const char* other = "") const {
    const auto value = parse_integer(field);
    if (!value || *value < 0 || *value > kLargestIndex) {
      return row_error(
          source_.name, line,
          in_quotes(field) + " is no " + name + ": expected an integer from 0" + other);
    }
    return static_cast<std::uint32_t>(*value);
  }

  // Of two lines on the same contours: that on the regions of different ones is found later.
  [[nodiscard]] Result<void> refuse_contradictions(std::size_t kind) const {
    const DecisionForm& form = kDecisions[kind];
    const std::vector<LinkDecision>& decisions = labels_.*form.decisions;
    std::vector<std::size_t> order(decisions.size());
    for (std::size_t k = 0; k < order.size(); ++k) order[k] = k;
    const auto link = [&](std::size_t k) {
      return std::tuple(decisions[k].slab, decisions[k].lower, decisions[k].upper);
    };
    std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
      return std::tuple(link(a), a) < std::tuple(link(b), b);
    });
    for (std::size_t k = 1; k < order.size(); ++k) {
      const std::size_t before = order[k - 1];
      const std::size_t here = order[k];
      if (link(before) != link(here)) continue;
      if (decisions[before].join == decisions[here].join) continue;
      return row_error(source_.name, line_[kind][here],
                       std::string(form.yes) + " and " + std::string(form.no) +
                           " of the same contours: see line " +
                           std::to_string(line_[kind][before]));
    }
    return {};
  }

  const Source& source_;
  Labels labels_;
  // Of each decision, by kind.
  std::array<std::vector<std::size_t>, kDecisions.size()> line_;
};

Result<Labels> read_label_lines(const Source& source, const ReadOptions& /*options*/) {
  return LabelReader(source).read();
}

void append_field(std::string& text, std::uint32_t value) {
  if (!text.empty()) text += ' ';
  append_number(text, value);
}

void append_labels(Pieces& pieces, std::string_view word, const std::vector<Label>& labels) {
  for (const Label& label : labels) {
    std::string line(word);
    append_field(line, label.section.value());
    append_field(line, label.contour.value());
    append_field(line, label.label);
    pieces.text() += line + '\n';
    pieces.next();
  }
}

void append_decisions(Pieces& pieces, const DecisionForm& form,
                      const std::vector<LinkDecision>& decisions) {
  for (const LinkDecision& decision : decisions) {
    std::string line(decision.join ? form.yes : form.no);
    append_field(line, decision.slab.value());
    for (const ContourId contour : {decision.lower, decision.upper}) {
      if (contour.valid()) {
        append_field(line, contour.value());
      } else {
        (line += ' ') += kOutside;
      }
    }
    pieces.text() += line + '\n';
    pieces.next();
  }
}

Written write_label_lines(Sink& sink, const Labels& labels, const Target& /*target*/) {
  Pieces pieces(sink);
  append_labels(pieces, "", labels.labels);
  append_decisions(pieces, kDecisions[0], labels.decisions);
  append_labels(pieces, kHole, labels.hole_labels);
  append_decisions(pieces, kDecisions[kOfVoids], labels.void_decisions);
  pieces.finish();
  return std::vector<Warning>();
}

}  // namespace

extern constinit const Format labels_format{
    .name = "labels",
    .summary =
        "lines \"section contour label\", \"join section contour contour_above\" or \"part "
        "section contour contour_above\"; of voids \"hole section contour label\", \"open section "
        "hole hole_above\" or \"close section hole hole_above\", where a hole may be \"outside\"; "
        "zero-based, # comments",
    .extensions = {".labels", ".txt"},
    .takes_text = true,
    .read_labels = read_label_lines,
    .write_labels = write_label_lines};

}  // namespace tetloft::internal::io

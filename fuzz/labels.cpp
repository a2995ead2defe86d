// The reader of label files.
#include <tetloft/io.hpp>

#include "fuzz/target.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace tetloft;
  using namespace tetloft::fuzz;
  const auto labels = parse_labels(text_of(data, size), "fuzz.txt");
  if (!labels) {
    require_clean(labels.error());
    require(labels.error().where.line.has_value(), "an error without a line");
    return 0;
  }
  for (const Label& label : labels->labels) {
    require(label.section.valid() && label.contour.valid(), "an invalid id");
  }
  for (const LinkDecision& decision : labels->decisions) {
    require(decision.slab.valid() && decision.lower.valid() && decision.upper.valid(),
            "an invalid id");
  }
  for (const Label& label : labels->hole_labels) {
    require(label.section.valid() && label.contour.valid(), "an invalid id");
  }
  for (const LinkDecision& decision : labels->void_decisions) {
    require(decision.slab.valid() && (decision.lower.valid() || decision.upper.valid()),
            "a decision on two exteriors");
  }
  // What was read is written so that it reads back.
  const auto bytes = format_labels(*labels);
  require(bytes.ok(), "labels that cannot be written");
  const auto again = parse_labels(*bytes, "again");
  require(again.ok() && again->labels.size() == labels->labels.size() &&
              again->decisions.size() == labels->decisions.size() &&
              again->hole_labels.size() == labels->hole_labels.size() &&
              again->void_decisions.size() == labels->void_decisions.size() &&
              *format_labels(*again) == *bytes,
          "labels that do not read back");
  return 0;
}

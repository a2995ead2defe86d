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
  for (const Label& label : *labels) {
    require(label.section.valid() && label.contour.valid(), "an invalid id");
  }
  return 0;
}

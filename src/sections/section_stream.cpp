#include <tetloft/section_stream.hpp>

namespace tetloft {

SectionStream::~SectionStream() = default;

Frame SectionStream::frame() const { return {}; }

Description SectionStream::about() const { return {}; }

Place SectionStream::located(Place where) { return where; }

Result<std::optional<Section>> StackStream::next() {
  if (next_ == stack_.sections.size()) return std::optional<Section>();
  return std::optional(stack_.sections[SectionId(next_++)]);
}

}  // namespace tetloft

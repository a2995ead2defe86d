#include <tetloft/section_source.hpp>

namespace tetloft {

SectionSource::~SectionSource() = default;

Frame SectionSource::frame() const { return {}; }

Description SectionSource::about() const { return {}; }

Place SectionSource::located(Place where) { return where; }

Result<std::optional<Section>> StackSource::next() {
  if (next_ == stack_.sections.size()) return std::optional<Section>();
  return std::optional(stack_.sections[SectionId(next_++)]);
}

}  // namespace tetloft

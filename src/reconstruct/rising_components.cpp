#include "reconstruct/rising_components.hpp"

namespace tetloft::internal {

SectionComponents RisingComponents::add(const Nesting& nesting, const std::vector<Link>& links) {
  SectionComponents here;
  here.of_region.resize(nesting.outer.size());
  for (const Link& link : links) {
    const ComponentId below = below_[link.lower];
    ComponentId& above = here.of_region[link.upper];
    if (above.valid()) {
      sets_.unite(below.index(), above.index());
    } else {
      above = below;
    }
  }
  // What nothing below is linked to begins here. Numbers ascend with its first contour, and the
  // least of a set is its name.
  for (const RegionId r : nesting.region) {
    ComponentId& id = here.of_region[r];
    if (!id.valid()) id = ComponentId(sets_.add());
    here.of_contour.push_back(id);
  }
  below_ = here.of_region;
  return here;
}

IdVector<ComponentId, ComponentId> RisingComponents::numbers() const {
  IdVector<ComponentId, ComponentId> numbers(sets_.size());
  std::size_t components = 0;
  for (const ComponentId id : numbers.ids()) {
    const ComponentId least(sets_.find(id.index()));
    numbers[id] = least == id ? ComponentId(components++) : numbers[least];
  }
  return numbers;
}

void renumber(SectionComponents& components, const IdVector<ComponentId, ComponentId>& numbers) {
  for (ComponentId& id : components.of_region) id = numbers[id];
  for (ComponentId& id : components.of_contour) id = numbers[id];
}

}  // namespace tetloft::internal

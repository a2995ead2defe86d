// What belongs together in a stack.
#include <tetloft/links.hpp>

#include <limits>

#include "c/arrays.hpp"
#include "c/handles.hpp"
#include "c/options.hpp"

namespace tetloft::internal::c {

namespace {

template <class Link>
std::vector<tetloft_link> plain_links(const std::vector<Link>& links) {
  std::vector<tetloft_link> plain;
  plain.reserve(links.size());
  for (const Link& link : links) {
    plain.push_back({link.slab.value(), link.lower.value(), link.upper.value(),
                     static_cast<std::int32_t>(link.evidence), static_cast<std::int32_t>(link.fate),
                     link.ratio, link.moved, link.distance, link.margin,
                     link.lead.value_or(std::numeric_limits<double>::quiet_NaN())});
  }
  return plain;
}

// Answers with links and their number.
void put_links(const std::vector<tetloft_link>& links, const tetloft_link** array,
               std::size_t* count) {
  require_output(array, "array");
  require_output(count, "count");
  *array = links.empty() ? nullptr : links.data();
  *count = links.size();
}

}  // namespace

}  // namespace tetloft::internal::c

using namespace tetloft::internal::c;

tetloft_status tetloft_links_find(const tetloft_stack* stack, const tetloft_correspondence* options,
                                  const tetloft_execution* execution, tetloft_links** links,
                                  tetloft_warnings** warnings) {
  clear(links);
  clear(warnings);
  return answer([&] {
    const auto value = value_of_handle(stack, "stack");
    require_output(links, "links");
    tetloft::LinkOptions asked;
    asked.correspondence = correspondence_of(options);
    asked.execution = execution_of(execution);
    tetloft::StackLinks found = value_of(tetloft::find_links(*value, asked));
    LinksValue made;
    made.regions = plain_links(found.links);
    made.voids = plain_links(found.void_links);
    made.partition = std::move(found.partition);
    made.components = found.components;
    made.cavities = found.cavities;
    hand_out(links, std::move(made), warnings, found.warnings);
  });
}

tetloft_status tetloft_links_regions(const tetloft_links* links, const tetloft_link** array,
                                     size_t* count) {
  clear(array);
  clear(count);
  return answer([&] { put_links(value_of_handle(links, "links")->regions, array, count); });
}

tetloft_status tetloft_links_voids(const tetloft_links* links, const tetloft_link** array,
                                   size_t* count) {
  clear(array);
  clear(count);
  return answer([&] { put_links(value_of_handle(links, "links")->voids, array, count); });
}

tetloft_status tetloft_links_counts(const tetloft_links* links, size_t* components,
                                    size_t* cavities) {
  clear(components, cavities);
  return answer([&] {
    const auto value = value_of_handle(links, "links");
    put(components, value->components);
    put(cavities, value->cavities);
  });
}

tetloft_status tetloft_links_partition(const tetloft_links* links, size_t section,
                                       const uint32_t** component, size_t* contours) {
  clear(component);
  clear(contours);
  return answer([&] {
    const auto value = value_of_handle(links, "links");
    require_index(section, value->partition.size(), "section");
    put_array(value->partition.raw()[section].raw(), component, contours);
  });
}

tetloft_status tetloft_links_free(tetloft_links* links) { return free_handle(links); }

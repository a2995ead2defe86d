// What a user decides about contours.
#include <tetloft/io.hpp>

#include "c/arrays.hpp"
#include "c/handles.hpp"

namespace tetloft::internal::c {

namespace {

std::vector<Label> labels_of(const tetloft_label* labels, std::size_t count, const char* name) {
  require_array(labels, count, sizeof(tetloft_label), name);
  std::vector<Label> result(count);
  for (std::size_t i = 0; i < count; ++i) {
    result[i] = {SectionId(labels[i].section), ContourId(labels[i].contour), labels[i].label};
  }
  return result;
}

std::vector<LinkDecision> decisions_of(const tetloft_decision* decisions, std::size_t count,
                                       const char* name) {
  require_array(decisions, count, sizeof(tetloft_decision), name);
  std::vector<LinkDecision> result(count);
  for (std::size_t i = 0; i < count; ++i) {
    result[i] = {SlabId(decisions[i].slab), ContourId(decisions[i].lower),
                 ContourId(decisions[i].upper), decisions[i].join != 0};
  }
  return result;
}

}  // namespace

}  // namespace tetloft::internal::c

using namespace tetloft::internal::c;

tetloft_status tetloft_labels_create(const tetloft_label* labels, size_t label_count,
                                     const tetloft_decision* decisions, size_t decision_count,
                                     const tetloft_label* hole_labels, size_t hole_label_count,
                                     const tetloft_decision* void_decisions,
                                     size_t void_decision_count, tetloft_labels** out) {
  clear(out);
  return answer([&] {
    require_output(out, "out");
    tetloft::Labels made;
    made.labels = labels_of(labels, label_count, "labels");
    made.decisions = decisions_of(decisions, decision_count, "decisions");
    made.hole_labels = labels_of(hole_labels, hole_label_count, "hole_labels");
    made.void_decisions = decisions_of(void_decisions, void_decision_count, "void_decisions");
    hand_out(out, std::move(made));
  });
}

tetloft_status tetloft_labels_read(const char* path, tetloft_labels** labels) {
  clear(labels);
  return answer([&] {
    require_output(labels, "labels");
    hand_out(labels, value_of(tetloft::read_labels(text_of(path, "path"))));
  });
}

tetloft_status tetloft_labels_parse(const void* data, size_t size, const char* name,
                                    tetloft_labels** labels) {
  clear(labels);
  return answer([&] {
    require_output(labels, "labels");
    hand_out(labels, value_of(tetloft::parse_labels(bytes_of(data, size), text_of(name, "name"))));
  });
}

tetloft_status tetloft_labels_write(const tetloft_labels* labels, const char* path) {
  return answer([&] {
    const auto value = value_of_handle(labels, "labels");
    require_success(tetloft::write_labels(text_of(path, "path"), *value));
  });
}

tetloft_status tetloft_labels_format(const tetloft_labels* labels, tetloft_bytes** bytes) {
  clear(bytes);
  return answer([&] {
    const auto value = value_of_handle(labels, "labels");
    require_output(bytes, "bytes");
    hand_out(bytes, value_of(tetloft::format_labels(*value)));
  });
}

tetloft_status tetloft_labels_free(tetloft_labels* labels) { return free_handle(labels); }

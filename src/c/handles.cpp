#include "c/handles.hpp"

namespace tetloft::internal::c {

void require_type(const Named& named, HandleType wanted, bool is_null, const char* argument) {
  if (named.value != nullptr && named.type == wanted) return;
  std::string message = argument;
  message += " must be ";
  message += name_of(wanted);
  if (is_null) {
    message += ", but is NULL";
  } else if (named.value != nullptr) {
    message += ", but is ";
    message += name_of(named.type);
  } else {
    message += ", but was freed or never made";
  }
  throw Refusal{TETLOFT_BAD_HANDLE, std::move(message)};
}

WarningsValue lines_of(const std::vector<Warning>& warnings) {
  WarningsValue value;
  value.lines.reserve(warnings.size());
  for (const Warning& warning : warnings) value.lines.push_back(to_string(warning));
  return value;
}

}  // namespace tetloft::internal::c

using namespace tetloft::internal::c;

tetloft_status tetloft_warnings_count(const tetloft_warnings* warnings, size_t* count) {
  clear(count);
  return answer([&] {
    const auto value = value_of_handle(warnings, "warnings");
    require_output(count, "count");
    *count = value->lines.size();
  });
}

tetloft_status tetloft_warnings_text(const tetloft_warnings* warnings, size_t index,
                                     const char** text) {
  clear(text);
  return answer([&] {
    const auto value = value_of_handle(warnings, "warnings");
    require_output(text, "text");
    require_index(index, value->lines.size(), "warning");
    *text = value->lines[index].c_str();
  });
}

tetloft_status tetloft_warnings_free(tetloft_warnings* warnings) { return free_handle(warnings); }

tetloft_status tetloft_bytes_data(const tetloft_bytes* bytes, const void** data, size_t* size) {
  clear(data);
  clear(size);
  return answer([&] {
    const auto value = value_of_handle(bytes, "bytes");
    require_output(data, "data");
    require_output(size, "size");
    *data = value->data();
    *size = value->size();
  });
}

tetloft_status tetloft_bytes_free(tetloft_bytes* bytes) { return free_handle(bytes); }

// Versioned structs, as callers hand them in.
#pragma once

#include <cstdint>
#include <string>

#include "c/call.hpp"

namespace tetloft::internal::c {

/// Ends a body with TETLOFT_USAGE unless the struct is of a version that is known.
template <class Struct>
void require_version(const Struct& value, std::uint32_t version, const char* name) {
  if (value.version != version) {
    fail_usage(std::string(name) + ": there is no version " + std::to_string(value.version) +
               " of this struct, only " + std::to_string(version));
  }
}

/// Of a struct that takes a result: that there is one, and its version. It is cleared then.
template <class Struct>
void require_result(Struct* result, std::uint32_t version, const char* name) {
  require_output(result, name);
  require_version(*result, version, name);
  *result = Struct{};
  result->version = version;
}

/// Ends a body with TETLOFT_USAGE unless a field holds an enumerator, which count from 0.
template <class Enum>
[[nodiscard]] Enum enumerator_of(std::int32_t value, Enum last, const char* field) {
  if (value < 0 || value > static_cast<std::int32_t>(last)) {
    fail_usage(std::string(field) + " is " + std::to_string(value) + ", which is none of 0 to " +
               std::to_string(static_cast<std::int32_t>(last)));
  }
  return static_cast<Enum>(value);
}

}  // namespace tetloft::internal::c

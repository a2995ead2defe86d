// Values of enumerations as callers hand them in: any number fits.
#pragma once

#include <type_traits>

namespace tetloft::internal {

/// Whether `value` is an enumerator, of an enumeration that counts from 0 to `last`.
template <class Enum>
[[nodiscard]] constexpr bool is_enumerator(Enum value, Enum last) {
  using Number = std::make_unsigned_t<std::underlying_type_t<Enum>>;
  return static_cast<Number>(value) <= static_cast<Number>(last);
}

}  // namespace tetloft::internal

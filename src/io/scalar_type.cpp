// Names of types.
#include "io/scalar_type.hpp"

#include <array>

namespace tetloft::internal::io {

std::string_view name_of(ScalarType type) {
  constexpr std::array<std::string_view, 10> kScalarNames{"int8",    "uint8",  "int16", "uint16",
                                                          "int32",   "uint32", "int64", "uint64",
                                                          "float32", "float64"};
  const auto index = static_cast<std::size_t>(type);
  return index < kScalarNames.size() ? kScalarNames[index] : "unknown";
}

}  // namespace tetloft::internal::io

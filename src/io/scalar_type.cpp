// Names of types.
#include "io/scalar_type.hpp"

#include <algorithm>
#include <array>

namespace tetloft::internal::io {

std::string_view name_of(ScalarType type) {
  constexpr std::array<std::string_view, 10> kScalarNames{"int8",    "uint8",  "int16", "uint16",
                                                          "int32",   "uint32", "int64", "uint64",
                                                          "float32", "float64"};
  const auto index = static_cast<std::size_t>(type);
  return index < kScalarNames.size() ? kScalarNames[index] : "unknown";
}

std::optional<ScalarType> find_scalar(std::span<const ScalarName> names, std::string_view name) {
  const auto found = std::find_if(names.begin(), names.end(),
                                  [&](const ScalarName& known) { return known.name == name; });
  if (found == names.end()) return std::nullopt;
  return found->type;
}

}  // namespace tetloft::internal::io

// The numbers that binary files are made of.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <utility>

namespace tetloft::internal::io {

enum class ScalarType : std::uint8_t {
  int8,
  uint8,
  int16,
  uint16,
  int32,
  uint32,
  int64,
  uint64,
  float32,
  float64,
};

[[nodiscard]] constexpr bool is_float(ScalarType type) {
  return type == ScalarType::float32 || type == ScalarType::float64;
}

/// visit(number), of the C++ type that `type` is; the number is 0.
template <class Visit>
constexpr decltype(auto) visit_scalar(ScalarType type, Visit&& visit) {
  switch (type) {
    case ScalarType::int8: return visit(std::int8_t{});
    case ScalarType::uint8: return visit(std::uint8_t{});
    case ScalarType::int16: return visit(std::int16_t{});
    case ScalarType::uint16: return visit(std::uint16_t{});
    case ScalarType::int32: return visit(std::int32_t{});
    case ScalarType::uint32: return visit(std::uint32_t{});
    case ScalarType::int64: return visit(std::int64_t{});
    case ScalarType::uint64: return visit(std::uint64_t{});
    case ScalarType::float32: return visit(float{});
    case ScalarType::float64: break;
  }
  return visit(double{});
}

/// In bytes.
[[nodiscard]] constexpr std::size_t size_of(ScalarType type) {
  return visit_scalar(type, [](auto number) { return sizeof number; });
}

/// "int8", …
[[nodiscard]] std::string_view name_of(ScalarType type);

/// What a format calls a type; it may have several names for one.
struct ScalarName {
  std::string_view name;
  ScalarType type;
};
[[nodiscard]] std::optional<ScalarType> find_scalar(std::span<const ScalarName> names,
                                                    std::string_view name);

}  // namespace tetloft::internal::io

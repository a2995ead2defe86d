// Arrays on their way in and out: plain numbers outside, points and ids inside.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include <tetloft/ids.hpp>
#include <tetloft/periodic.hpp>
#include <tetloft/point.hpp>

#include "c/call.hpp"
#include "c/handles.hpp"

namespace tetloft::internal::c {

// What arrays of the library look like from outside: so many plain numbers each.
template <class T>
struct Flat;
template <class Tag>
struct Flat<Id<Tag>> {
  using Number = std::uint32_t;
};
template <class T, std::size_t n>
struct Flat<std::array<T, n>> {
  using Number = typename Flat<T>::Number;
};
template <>
struct Flat<Point2> {
  using Number = double;
};
template <>
struct Flat<Point3> {
  using Number = double;
};
template <class N>
requires std::is_arithmetic_v<N>
struct Flat<N> {
  using Number = N;
};
template <class Enum>
requires std::is_enum_v<Enum>
struct Flat<Enum> {
  using Number = std::underlying_type_t<Enum>;
};

/// An array of the library as its numbers, without a copy; NULL if it is empty.
template <class T>
[[nodiscard]] const typename Flat<T>::Number* numbers_of(std::span<const T> values) {
  using Number = typename Flat<T>::Number;
  static_assert(std::is_standard_layout_v<T> && std::is_trivially_copyable_v<T>);
  static_assert(sizeof(T) % sizeof(Number) == 0 && alignof(T) == alignof(Number));
  return values.empty() ? nullptr : reinterpret_cast<const Number*>(values.data());
}
template <class T>
[[nodiscard]] const typename Flat<T>::Number* numbers_of(const std::vector<T>& values) {
  return numbers_of(std::span<const T>(values));
}
static_assert(sizeof(Point2) == 2 * sizeof(double) && sizeof(Point3) == 3 * sizeof(double));

/// Answers with an array of the library and its size in elements.
template <class T>
void put_array(std::span<const T> values, const typename Flat<T>::Number** numbers,
               std::size_t* count) {
  require_output(numbers, "array");
  require_output(count, "count");
  *numbers = numbers_of(values);
  *count = values.size();
}
template <class T>
void put_array(const std::vector<T>& values, const typename Flat<T>::Number** numbers,
               std::size_t* count) {
  put_array(std::span<const T>(values), numbers, count);
}

/// The body of a function that answers with an array of what a handle names.
template <class Handle, class Value, class T>
[[nodiscard]] tetloft_status answer_array(const Handle* handle, const char* argument,
                                          std::vector<T> Value::*array,
                                          const typename Flat<T>::Number** numbers,
                                          std::size_t* count) noexcept {
  clear(numbers);
  clear(count);
  return answer([&] {
    const auto value = value_of_handle(handle, argument);
    put_array((*value).*array, numbers, count);
  });
}

/// Ends a body with TETLOFT_TOO_SMALL where a caller's array does not take `needed` elements.
inline void require_room(std::size_t capacity, std::size_t needed, const char* name) {
  if (capacity >= needed) return;
  throw Refusal{TETLOFT_TOO_SMALL, "the array " + std::string(name) + " holds " +
                                       std::to_string(capacity) + ", but there are " +
                                       std::to_string(needed)};
}

/// An array of the caller's, of `capacity` elements, and where to tell how many there are.
template <class Number>
struct CallerArray {
  Number* numbers;
  std::size_t capacity;
  std::size_t* count;
  const char* name;

  /// Ends a body with TETLOFT_USAGE where it cannot be written.
  void require_output() const {
    c::require_output(count, "count");
    if (numbers == nullptr && capacity != 0) {
      fail_usage(std::string("the array ") + name + " is NULL");
    }
  }
  /// Ends a body with TETLOFT_TOO_SMALL where it does not take `*count` elements, unless their
  /// number alone is asked for.
  void require_room() const {
    if (numbers != nullptr) c::require_room(capacity, *count, name);
  }
};

/// Lets `write` put `needed` elements there, unless their number alone is asked for.
template <class Number, class Write>
void fill_by(std::size_t needed, const CallerArray<Number>& array, Write&& write) {
  array.require_output();
  if (array.numbers == nullptr || array.capacity < needed) {
    *array.count = needed;
    array.require_room();
    return;
  }
  write(array.numbers);
  *array.count = needed;
}

/// Copies values there.
template <class T>
void fill_array(const std::vector<T>& values, const CallerArray<typename Flat<T>::Number>& array) {
  using Number = typename Flat<T>::Number;
  fill_by(values.size(), array, [&](Number* to) {
    std::copy_n(numbers_of(values), values.size() * (sizeof(T) / sizeof(Number)), to);
  });
}
template <class T>
void fill_array(const std::vector<T>& values, typename Flat<T>::Number* array, std::size_t capacity,
                std::size_t* count, const char* name) {
  fill_array(values, {array, capacity, count, name});
}

/// Ends a body with TETLOFT_USAGE unless an array of `count` elements, of `size` bytes each, can be
/// in memory and is there.
inline void require_array(const void* array, std::size_t count, std::size_t size,
                          const char* name) {
  if (array == nullptr && count != 0) fail_usage(std::string("the array ") + name + " is NULL");
  if (count > std::numeric_limits<std::ptrdiff_t>::max() / size) {
    fail_usage("no array " + std::string(name) + " of " + std::to_string(count) + " can be");
  }
}

/// Ends a body with TETLOFT_INVALID_INPUT for more elements than ids name.
void require_countable(std::size_t count);

/// The points of `count` pairs, or triples, of coordinates.
[[nodiscard]] std::vector<Point2> plane_points(const double* xy, std::size_t count);
[[nodiscard]] std::vector<Point3> space_points(const double* xyz, std::size_t count);

/// Of nine coordinates, which must be there.
[[nodiscard]] PeriodicBox periodic_box(const double* vectors);

/// The tuples of ids, `n` in each.
template <class IdType, std::size_t n>
[[nodiscard]] std::vector<std::array<IdType, n>> id_tuples(const std::uint32_t* ids,
                                                           std::size_t count, const char* name) {
  require_array(ids, count, n * sizeof(std::uint32_t), name);
  std::vector<std::array<IdType, n>> tuples(count);
  for (std::size_t i = 0; i < count; ++i) {
    for (std::size_t k = 0; k < n; ++k) tuples[i][k] = IdType(ids[n * i + k]);
  }
  return tuples;
}

/// Fewer than 2^30.
[[nodiscard]] std::vector<TetVertices> tets_of(const std::uint32_t* tets, std::size_t count);

/// A text that must be there.
[[nodiscard]] std::string text_of(const char* text, const char* name);
/// Bytes that must be there, unless there are none.
[[nodiscard]] std::string_view bytes_of(const void* data, std::size_t size);

}  // namespace tetloft::internal::c

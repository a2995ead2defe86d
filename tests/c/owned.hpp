// Handles that free themselves, and arrays of C compared with those of C++.
#pragma once

#include <gtest/gtest.h>

#include <cstddef>
#include <cstring>
#include <string>
#include <vector>

#include <tetloft/tetloft.h>

#include "c/calls/arguments.hpp"

namespace tetloft::c_test {

template <class Handle>
class Owned {
 public:
  Owned() = default;
  ~Owned() { free_handle(KindOf<Handle>::value, handle_); }
  Owned(const Owned&) = delete;
  Owned& operator=(const Owned&) = delete;
  operator Handle*() const { return handle_; }
  [[nodiscard]] const Handle* handle() const { return handle_; }
  /// For a call that makes one.
  Handle** out() {
    free_handle(KindOf<Handle>::value, handle_);
    handle_ = nullptr;
    return &handle_;
  }

 private:
  Handle* handle_ = nullptr;
};

#define EXPECT_OK(CALL) EXPECT_EQ(CALL, TETLOFT_OK) << tetloft_last_error()
#define ASSERT_OK(CALL) ASSERT_EQ(CALL, TETLOFT_OK) << tetloft_last_error()

/// The same bytes: `count` elements as those of C++.
template <class Number, class Values>
testing::AssertionResult same_array(const Number* array, std::size_t count, const Values& values) {
  if (count != values.size()) {
    return testing::AssertionFailure() << count << " elements instead of " << values.size();
  }
  if (count == 0) {
    return array == nullptr ? testing::AssertionSuccess()
                            : testing::AssertionFailure() << "an empty array is not NULL";
  }
  const std::size_t bytes = count * sizeof(*values.data());
  return std::memcmp(array, values.data(), bytes) == 0
             ? testing::AssertionSuccess()
             : testing::AssertionFailure() << "other elements";
}

/// What `get` answers with is the same array.
template <class Number, class Handle, class Values>
void expect_array(tetloft_status (*get)(const Handle*, const Number**, std::size_t*),
                  const Handle* handle, const Values& values) {
  const Number* array = nullptr;
  std::size_t count = 0;
  EXPECT_OK(get(handle, &array, &count));
  EXPECT_TRUE(same_array(array, count, values));
}

/// An array of C, which lives as long as its handle.
template <class T>
struct Array {
  const T* data = nullptr;
  std::size_t size = 0;
  const T& operator[](std::size_t i) const { return data[i]; }
};
template <class T, class Handle>
Array<T> array_of(tetloft_status (*get)(const Handle*, const T**, std::size_t*),
                  const Handle* handle) {
  Array<T> array;
  EXPECT_OK(get(handle, &array.data, &array.size));
  return array;
}

inline std::string bytes_of(const tetloft_bytes* bytes) {
  const void* data = nullptr;
  std::size_t size = 0;
  EXPECT_OK(tetloft_bytes_data(bytes, &data, &size));
  return {static_cast<const char*>(data), size};
}

[[nodiscard]] inline std::vector<std::string> texts_of(const tetloft_warnings* warnings) {
  std::size_t count = 0;
  EXPECT_OK(tetloft_warnings_count(warnings, &count));
  std::vector<std::string> texts;
  for (std::size_t i = 0; i < count; ++i) {
    const char* text = nullptr;
    EXPECT_OK(tetloft_warnings_text(warnings, i, &text));
    texts.emplace_back(text);
  }
  return texts;
}

}  // namespace tetloft::c_test

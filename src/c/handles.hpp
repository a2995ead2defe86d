// Handles of C and the values that they name.
#pragma once

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include <tetloft/result.hpp>

#include "c/call.hpp"
#include "c/registry.hpp"
#include "c/values.hpp"

namespace tetloft::internal::c {

template <class Handle>
using ValueOf = typename HandleTraits<Handle>::Value;

[[nodiscard]] inline HandleName name_of_handle(const void* handle) {
  return reinterpret_cast<HandleName>(handle);
}

/// Ends a body with TETLOFT_BAD_HANDLE unless `named` is of type `wanted`.
void require_type(const Named& named, HandleType wanted, bool is_null, const char* argument);

/// What a handle names, for as long as the result lives. Another than a good one ends the body with
/// TETLOFT_BAD_HANDLE; `argument` is what it is called in messages.
template <class Handle>
[[nodiscard]] std::shared_ptr<const ValueOf<Handle>> value_of_handle(const Handle* handle,
                                                                     const char* argument) {
  const Named named = Registry::of_process().find(name_of_handle(handle));
  require_type(named, HandleTraits<Handle>::kType, handle == nullptr, argument);
  return std::static_pointer_cast<const ValueOf<Handle>>(named.value);
}

/// A handle on its way to the caller: taken back unless it arrives.
template <class Handle>
class NewHandle {
 public:
  explicit NewHandle(ValueOf<Handle> value)
      : name_(Registry::of_process().add(
            {HandleTraits<Handle>::kType,
             std::make_shared<const ValueOf<Handle>>(std::move(value))})) {}
  ~NewHandle() {
    if (name_ != 0) Registry::of_process().remove(name_);
  }
  NewHandle(const NewHandle&) = delete;
  NewHandle& operator=(const NewHandle&) = delete;

  void give(Handle** output) noexcept {
    *output = reinterpret_cast<Handle*>(name_);
    name_ = 0;
  }

 private:
  HandleName name_;
};

/// Gives the caller a value.
template <class Handle>
void hand_out(Handle** output, ValueOf<Handle> value) {
  NewHandle<Handle>(std::move(value)).give(output);
}

[[nodiscard]] WarningsValue lines_of(const std::vector<Warning>& warnings);

/// Gives the caller warnings, if he wants them.
inline void hand_out_warnings(tetloft_warnings** output, const std::vector<Warning>& warnings) {
  if (output != nullptr) hand_out(output, lines_of(warnings));
}

/// Gives the caller a value and, if he wants them, warnings: both or none.
template <class Handle>
void hand_out(Handle** output, ValueOf<Handle> value, tetloft_warnings** warnings_output,
              const std::vector<Warning>& warnings) {
  NewHandle<Handle> handle(std::move(value));
  hand_out_warnings(warnings_output, warnings);
  handle.give(output);
}

/// The body of a _free function.
template <class Handle>
[[nodiscard]] tetloft_status free_handle(Handle* handle) noexcept {
  if (handle == nullptr) return TETLOFT_OK;
  return answer([&] {
    // Held until the end of the body: to be destroyed without the registry's lock.
    const auto value = value_of_handle(handle, "the handle");
    const Named removed = Registry::of_process().remove(name_of_handle(handle));
    require_type(removed, HandleTraits<Handle>::kType, false, "the handle");
  });
}

}  // namespace tetloft::internal::c

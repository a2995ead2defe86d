// A stack known to be valid, so that it need not be validated again.
#pragma once

#include <utility>

#include <tetloft/execution.hpp>
#include <tetloft/export.hpp>
#include <tetloft/ids.hpp>
#include <tetloft/nesting.hpp>
#include <tetloft/result.hpp>
#include <tetloft/section_stack.hpp>

namespace tetloft {

namespace internal::sections {
struct ValidStackMaker;
}

/// validate(), and the nestings that it finds on the way: those of nest().
[[nodiscard]] TETLOFT_API Result<IdVector<SectionId, Nesting>> nest_if_valid(
    const SectionStack& stack, const Execution& execution = {});

/// A stack that validate() accepts, and the nesting of its sections, which validation finds on the
/// way. Nobody changes it: it stays valid. One that was moved from has no sections, and is refused
/// as an empty stack is.
class TETLOFT_API ValidStack {
 public:
  /// Refused as by validate().
  [[nodiscard]] static Result<ValidStack> of(SectionStack stack, const Execution& execution = {});

  ValidStack(const ValidStack&) = default;
  ValidStack(ValidStack&& other) noexcept : ValidStack({}, {}) { swap(other); }
  /// Stack and nestings together, or neither: where memory ends while copying, this stays as it
  /// was.
  ValidStack& operator=(ValidStack other) noexcept {
    swap(other);
    return *this;
  }
  ~ValidStack() = default;

  [[nodiscard]] const SectionStack& stack() const { return stack_; }
  /// As by nest().
  [[nodiscard]] const IdVector<SectionId, Nesting>& nestings() const { return nestings_; }
  /// The stack, to be changed; this one is moved from then.
  [[nodiscard]] SectionStack take() && { return ValidStack(std::move(*this)).stack_; }

 private:
  friend struct internal::sections::ValidStackMaker;
  ValidStack(SectionStack stack, IdVector<SectionId, Nesting> nestings)
      : stack_(std::move(stack)), nestings_(std::move(nestings)) {}
  void swap(ValidStack& other) noexcept {
    std::swap(stack_, other.stack_);
    std::swap(nestings_, other.nestings_);
  }

  SectionStack stack_;
  IdVector<SectionId, Nesting> nestings_;
};

}  // namespace tetloft

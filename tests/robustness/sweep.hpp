// A function run with its first, second, … allocation failing.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <type_traits>

#include <tetloft/tetloft.hpp>

namespace tetloft::test {

/// What a run came to.
struct Ended {
  std::optional<ErrorCode> error = {};  ///< nothing where it succeeded
  std::uint64_t digest = 0;             ///< of the value then, where its kind has one
  friend bool operator==(const Ended&, const Ended&) = default;
};

/// Digests without allocation, of what is computed by trial and error and could come out wrong
/// where a trial fails for want of memory.
std::uint64_t digest(const Model& model);
std::uint64_t digest(const SectionStack& stack);
std::uint64_t digest(const CheckReport& report);
inline std::uint64_t digest(const Reconstruction& value) { return digest(value.model); }
inline std::uint64_t digest(const GeigerModel& value) { return digest(value.model); }
inline std::uint64_t digest(const LongStack& value) { return digest(value.stack); }
inline std::uint64_t digest(const Snapped& value) { return digest(value.stack); }
inline std::uint64_t digest(const Repaired& value) { return digest(value.stack); }
inline std::uint64_t digest(const Refined& value) { return digest(value.stack); }
template <class T>
std::uint64_t digest(const T& /*value*/) {
  return 0;
}

template <class T>
Ended ended(const Result<T>& result) {
  if (!result) return {result.error().code, 0};
  if constexpr (std::is_void_v<T>) {
    return {};
  } else {
    return {std::nullopt, digest(*result)};
  }
}

/// Of a function that may throw std::bad_alloc, and nothing else.
Ended ended_throwing(const std::function<void()>& call);

/// Runs `call` with each of its allocations failing, alone and with all that follow; where there
/// are many, with `some` of them spread over all, unless the environment has TETLOFT_SWEEP=all.
/// Expects that each run ends with out_of_memory (or does without the block, as sorting and
/// helper threads may, with the usual value), that all blocks are given back, and that `intact`,
/// asked after each run with memory again, is true. Prints the number of failure points.
void sweep(
    const std::string& name, const std::function<Ended()>& call,
    const std::function<bool()>& intact = [] { return true; }, std::size_t some = 24);

}  // namespace tetloft::test

// Asking the processor for memory that will be used soon.
#pragma once

namespace tetloft::internal::core {

/// A hint, and nothing where the compiler has no word for it. Any address will do.
inline void prefetch([[maybe_unused]] const void* address) {
#if defined(__GNUC__)
  __builtin_prefetch(address);
#endif
}

}  // namespace tetloft::internal::core

// See pages.hpp. The one file that knows how the system hands out memory.
#include "core/pages.hpp"

#if defined(__linux__)
#include <cstdint>

#include <sys/mman.h>
#endif

namespace tetloft::internal::core {

#if defined(__linux__)

void give_back_pages(std::span<std::byte> bytes) {
  // A multiple of the pages of all systems; less is not worth the call.
  constexpr std::size_t kPages = std::size_t{1} << 16;
  const std::size_t before =
      (kPages - reinterpret_cast<std::uintptr_t>(bytes.data()) % kPages) % kPages;
  if (bytes.size() < before + kPages) return;
  const std::size_t length = (bytes.size() - before) / kPages * kPages;
  // A refusal leaves them in use, which is no error.
  (void)madvise(bytes.data() + before, length, MADV_DONTNEED);
}

#else

void give_back_pages(std::span<std::byte>) {}

#endif

}  // namespace tetloft::internal::core

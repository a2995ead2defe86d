// See pages.hpp. The one file that knows how the system hands out memory.
#include "core/pages.hpp"

#if defined(__linux__)
#include <cstdint>

#include <sys/mman.h>
#include <unistd.h>
#endif

namespace tetloft::internal::core {

#if defined(__linux__)

void give_back_pages(std::span<std::byte> bytes) {
  // A few pages are not worth the call.
  constexpr std::size_t kLeast = std::size_t{1} << 16;
  if (bytes.size() < kLeast) return;
  const auto page = static_cast<std::size_t>(sysconf(_SC_PAGESIZE));
  const std::size_t before = (page - reinterpret_cast<std::uintptr_t>(bytes.data()) % page) % page;
  const std::size_t length = (bytes.size() - before) / page * page;
  // A refusal leaves them in use, which is no error.
  (void)madvise(bytes.data() + before, length, MADV_DONTNEED);
}

#else

void give_back_pages(std::span<std::byte>) {}

#endif

}  // namespace tetloft::internal::core

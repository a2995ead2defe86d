// See pages.hpp. The one file that knows how the system hands out memory.
#include "core/pages.hpp"

#if defined(__linux__)
#include <cstdint>

#include <sys/mman.h>
#endif

namespace tetloft::internal::core {

#if defined(__linux__)

namespace {

// The part of `bytes` that is made of whole pages, as what else is on a page belongs to others;
// empty where it has few.
std::span<std::byte> whole_pages(std::span<std::byte> bytes) {
  // A multiple of the pages of all systems; less is not worth the call.
  constexpr std::size_t kPages = std::size_t{1} << 16;
  const std::size_t before =
      (kPages - reinterpret_cast<std::uintptr_t>(bytes.data()) % kPages) % kPages;
  if (bytes.size() < before + kPages) return {};
  return bytes.subspan(before, (bytes.size() - before) / kPages * kPages);
}

// A refusal changes nothing but time and memory, and is no error.
void advise(std::span<std::byte> pages, int advice) {
  if (!pages.empty()) (void)madvise(pages.data(), pages.size(), advice);
}

}  // namespace

void give_back_pages(std::span<std::byte> bytes) { advise(whole_pages(bytes), MADV_DONTNEED); }

void make_pages([[maybe_unused]] std::span<std::byte> bytes) {
#if defined(MADV_POPULATE_WRITE)
  advise(whole_pages(bytes), MADV_POPULATE_WRITE);
#endif
}

#else

void give_back_pages(std::span<std::byte>) {}
void make_pages(std::span<std::byte>) {}

#endif

}  // namespace tetloft::internal::core

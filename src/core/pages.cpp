// See pages.hpp. The one file that knows how the system hands out memory.
#include "core/pages.hpp"

#include <cstdint>

#include <sys/mman.h>  // POSIX, as files are; what is asked for is Linux's
#include <unistd.h>

#if defined(__GLIBC__)
// Its header is in no other library, so it is not among those that are included here.
extern "C" int malloc_trim(std::size_t) noexcept;
#endif

namespace tetloft::internal::core {

#if defined(__linux__)

namespace {

// The part of `bytes` that is made of whole pages, as what else is on a page belongs to others;
// empty where it has few.
std::span<std::byte> whole_pages(std::span<std::byte> bytes) {
  constexpr std::size_t kFew = std::size_t{1} << 14;  // not worth the call
  const auto page = static_cast<std::size_t>(sysconf(_SC_PAGESIZE));
  const std::size_t before = (page - reinterpret_cast<std::uintptr_t>(bytes.data()) % page) % page;
  if (bytes.size() < before + kFew) return {};
  return bytes.subspan(before, (bytes.size() - before) / page * page);
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

void give_back_freed() {
#if defined(__GLIBC__)
  (void)malloc_trim(0);
#endif
}

#else

void give_back_freed() {}
void give_back_pages(std::span<std::byte>) {}
void make_pages(std::span<std::byte>) {}

#endif

}  // namespace tetloft::internal::core

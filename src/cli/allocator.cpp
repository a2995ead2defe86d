#include "cli/allocator.hpp"

#include <cstddef>

#if defined(__GLIBC__)
// Its header, which others lack, is not worth a condition.
extern "C" int mallopt(int, int) noexcept;
#endif

namespace tetloft::cli {

void keep_freed_memory() {
#if defined(__GLIBC__)
  constexpr int kTrimThreshold = -1;  // M_TRIM_THRESHOLD and M_MMAP_THRESHOLD of that header
  constexpr int kMmapThreshold = -3;
  // The largest array of a slab of 250,000 tets, and all that is made for one.
  (void)mallopt(kMmapThreshold, 1 << 22);
  (void)mallopt(kTrimThreshold, 1 << 26);
#endif
}

}  // namespace tetloft::cli

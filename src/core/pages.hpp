// Large pieces of memory, page by page.
#pragma once

#include <algorithm>
#include <cstddef>
#include <span>
#include <type_traits>
#include <vector>

namespace tetloft::internal::core {

/// Gives the whole pages within `bytes` back to the system, where it takes them: what they held is
/// lost, but they may be used again.
void give_back_pages(std::span<std::byte> bytes);

/// Has the system make the pages of `bytes`, which will be written soon, all at once: it would do
/// so one by one, and slower, when they are. What they hold does not change.
void make_pages(std::span<std::byte> bytes);

template <class T>
void make_pages(T* items, std::size_t count) {
  make_pages({reinterpret_cast<std::byte*>(items), count * sizeof(T)});
}

template <class T>
void give_back_pages(std::span<T> items) {
  // Nothing reads the lost items, not even a destructor.
  static_assert(std::is_trivially_destructible_v<T>);
  give_back_pages(std::as_writable_bytes(items));
}

/// Gives memory back that was freed, where the allocator keeps it in many small pieces. Takes some
/// milliseconds: for once, before much is asked for.
void give_back_freed();

/// Has `take` copy items that are needed elsewhere, some at a time, and gives their memory back as
/// it goes on: items and copies are hardly ever both there.
template <class T, class Take>
void hand_over(std::span<T> items, const Take& take) {
  constexpr std::size_t kAtATime = (std::size_t{1} << 20) / sizeof(T) + 1;
  while (!items.empty()) {
    const std::span<T> first = items.first(std::min(kAtATime, items.size()));
    take(first);
    give_back_pages(first);
    items = items.subspan(first.size());
  }
}

/// Frees a large vector at once, where an allocator would keep its memory for later.
template <class T>
void release(std::vector<T>& items) {
  give_back_pages(std::span<T>(items));
  items = std::vector<T>();
}

}  // namespace tetloft::internal::core

#include "robustness/failing_allocator.hpp"

#include <algorithm>
#include <atomic>
#include <cstdlib>
#include <new>

namespace {

std::atomic<bool> armed{false};
std::atomic<bool> persistent{false};
std::atomic<std::size_t> fails_at{0};
std::atomic<std::size_t> count{0};
std::atomic<bool> failed{false};
std::atomic<long> live{0};

bool fails() {
  if (!armed) return false;
  const std::size_t at = ++count;
  const bool fails = persistent ? at >= fails_at : at == fails_at;
  if (fails) failed = true;
  return fails;
}

void* allocate(std::size_t size, std::size_t alignment) {
  if (fails()) return nullptr;
  size = std::max<std::size_t>(size, 1);
  void* const block =
      alignment <= alignof(std::max_align_t)
          ? std::malloc(size)
          : std::aligned_alloc(alignment, (size + alignment - 1) / alignment * alignment);
  if (block != nullptr) ++live;
  return block;
}

void* allocate_or_throw(std::size_t size, std::size_t alignment) {
  void* const block = allocate(size, alignment);
  if (block == nullptr) throw std::bad_alloc();
  return block;
}

void release(void* block) {
  if (block == nullptr) return;
  --live;
  std::free(block);
}

constexpr std::size_t kUsual = alignof(std::max_align_t);

std::size_t number(std::align_val_t alignment) { return static_cast<std::size_t>(alignment); }

}  // namespace

void* operator new(std::size_t size) { return allocate_or_throw(size, kUsual); }
void* operator new[](std::size_t size) { return allocate_or_throw(size, kUsual); }
void* operator new(std::size_t size, std::align_val_t a) {
  return allocate_or_throw(size, number(a));
}
void* operator new[](std::size_t size, std::align_val_t a) {
  return allocate_or_throw(size, number(a));
}
void* operator new(std::size_t size, const std::nothrow_t&) noexcept {
  return allocate(size, kUsual);
}
void* operator new[](std::size_t size, const std::nothrow_t&) noexcept {
  return allocate(size, kUsual);
}
void operator delete(void* block) noexcept { release(block); }
void operator delete[](void* block) noexcept { release(block); }
void operator delete(void* block, std::size_t) noexcept { release(block); }
void operator delete[](void* block, std::size_t) noexcept { release(block); }
void operator delete(void* block, std::align_val_t) noexcept { release(block); }
void operator delete[](void* block, std::align_val_t) noexcept { release(block); }
void operator delete(void* block, std::size_t, std::align_val_t) noexcept { release(block); }
void operator delete[](void* block, std::size_t, std::align_val_t) noexcept { release(block); }
void operator delete(void* block, const std::nothrow_t&) noexcept { release(block); }
void operator delete[](void* block, const std::nothrow_t&) noexcept { release(block); }

namespace tetloft::test {

void arm_allocator(std::size_t n, Failing how) {
  count = 0;
  failed = false;
  fails_at = n;
  persistent = how == Failing::from_there;
  armed = true;
}

std::size_t disarm_allocator() {
  armed = false;
  return count;
}

bool allocator_failed() { return failed; }

long live_blocks() { return live; }

}  // namespace tetloft::test

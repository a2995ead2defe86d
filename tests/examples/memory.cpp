// A limit of memory of one's own: what the library may not have is an error, and nothing is lost.
#include <atomic>
#include <cstddef>
#include <cstdio>
#include <cstdlib>
#include <new>

#include <tetloft/tetloft.hpp>

namespace {

// Every block carries its size in front.
constexpr std::size_t kHead = alignof(std::max_align_t);
std::atomic<std::size_t> used = 0;
std::atomic<std::size_t> budget = static_cast<std::size_t>(-1);

}  // namespace

void* operator new(std::size_t size) {
  if (used.fetch_add(size) + size <= budget) {
    if (char* const block = static_cast<char*>(std::malloc(kHead + size))) {
      ::new (block) std::size_t(size);
      return block + kHead;
    }
  }
  used -= size;
  throw std::bad_alloc();
}

void operator delete(void* block) noexcept {
  if (block == nullptr) return;
  char* const head = static_cast<char*>(block) - kHead;
  used -= *reinterpret_cast<std::size_t*>(head);
  std::free(head);
}
void operator delete(void* block, std::size_t) noexcept { operator delete(block); }

namespace {

// A reconstruction that may take so much more than is in use now.
bool fits(const tetloft::SectionStack& stack, std::size_t megabytes) {
  budget = used + (megabytes << 20U);
  const auto solid = tetloft::reconstruct(stack);
  budget = static_cast<std::size_t>(-1);
  if (solid) {
    std::printf("%zu MB: %zu tets\n", megabytes, solid->model.tets.size());
  } else {
    std::printf("%zu MB: %s\n", megabytes, to_string(solid.error()).c_str());
  }
  return solid.ok();
}

}  // namespace

int main(int argc, char** argv) {
  const auto input = argc > 1 ? tetloft::read_stack(argv[1]) : tetloft::Error{};
  if (!input) return 3;
  const std::size_t before = used;
  std::size_t megabytes = 1;
  while (!fits(input->stack, megabytes)) megabytes *= 4;
  std::printf("%zu bytes kept\n", used - before);
  return 0;
}

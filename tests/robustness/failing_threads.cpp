#include "robustness/failing_threads.hpp"

#include <dlfcn.h>
#include <pthread.h>

#include <atomic>
#include <cerrno>
#include <cstring>

namespace {

constexpr std::size_t kUnlimited = static_cast<std::size_t>(-1);
std::atomic<std::size_t> left{kUnlimited};
std::atomic<std::size_t> refusals{0};

using Create = int (*)(pthread_t*, const pthread_attr_t*, void* (*)(void*), void*);

Create real_create() {
  void* const found = dlsym(RTLD_NEXT, "pthread_create");
  Create create = nullptr;
  std::memcpy(&create, &found, sizeof create);
  return create;
}

}  // namespace

extern "C" int pthread_create(pthread_t* thread, const pthread_attr_t* attributes,
                              void* (*start)(void*), void* argument) {
  static const Create create = real_create();
  if (left != kUnlimited) {
    if (left == 0) {
      ++refusals;
      return EAGAIN;
    }
    --left;
  }
  return create(thread, attributes, start, argument);
}

namespace tetloft::test {

FewThreads::FewThreads(std::size_t most) {
  refusals = 0;
  left = most;
}

FewThreads::~FewThreads() { left = kUnlimited; }

std::size_t FewThreads::refused() { return refusals; }

}  // namespace tetloft::test

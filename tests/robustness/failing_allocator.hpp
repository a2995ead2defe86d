// The program's own operator new, which can be told to fail.
#pragma once

#include <cstddef>

namespace tetloft::test {

/// How an armed allocator fails.
enum class Failing {
  once,        ///< one allocation, as where a large block is asked for
  from_there,  ///< that one and all after it, as where memory has ended
};

/// The n-th allocation from now on fails (n from 1), of any thread. Without it none does.
void arm_allocator(std::size_t n, Failing how);
/// No allocation fails any more; how many there were since the allocator was armed.
std::size_t disarm_allocator();
/// Whether an allocation has failed since it was armed.
[[nodiscard]] bool allocator_failed();
/// Blocks that were handed out and not given back.
[[nodiscard]] long live_blocks();

}  // namespace tetloft::test

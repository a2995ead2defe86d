// What the last failure of a thread was. Its texts are kept in fixed arrays: telling that memory
// ended must not take any, and a thread that ends has nothing to give back.
#pragma once

#include <tetloft/tetloft.h>
#include <tetloft/result.hpp>

namespace tetloft::internal::c {

/// Remembers the exception in flight as this thread's last failure; returns what it means. Only in
/// a catch block.
tetloft_status remember_exception() noexcept;

}  // namespace tetloft::internal::c

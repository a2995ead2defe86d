// What a reader of stacks hands over.
#pragma once

#include <tetloft/io.hpp>
#include <tetloft/nesting.hpp>

namespace tetloft::internal::io {

/// A stack as read, and its nestings where it was validated; none where it was not.
struct StackOfFile {
  ReadStack read;
  IdVector<SectionId, Nesting> nestings = {};
};

}  // namespace tetloft::internal::io

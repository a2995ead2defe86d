// Stacks of drawings.
#include "io/drawing/stack_of_drawing.hpp"

namespace tetloft::internal::io {

Result<ReadStack> stack_of_drawing(Drawing /*drawing*/, const std::string& /*name*/,
                                   const ReadOptions& /*options*/) {
  return Error{ErrorCode::internal, "drawings are not read yet", {}};
}

}  // namespace tetloft::internal::io

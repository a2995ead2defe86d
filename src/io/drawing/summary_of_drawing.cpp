// Drawings, counted.
#include "io/drawing/stack_of_drawing.hpp"

namespace tetloft::internal::io {

FileSummary summary_of_drawing(Drawing /*drawing*/) { return {}; }

}  // namespace tetloft::internal::io

#pragma once

namespace tetloft::internal::report {

/// The style sheet of the page: light and dark by the reader's preference, light in print. It has
/// no character that XML or HTML takes for more than text.
extern const char* const kStyle;

}  // namespace tetloft::internal::report

// The viewer's page, as text: the files of src/render/viewer.
#pragma once

#include <span>

namespace tetloft::internal::render {

extern const char* const kViewerHtml;  ///< of the page's body
extern const char* const kViewerCss;
[[nodiscard]] std::span<const char* const> viewer_scripts();  ///< in the order of their running

}  // namespace tetloft::internal::render

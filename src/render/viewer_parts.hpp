// The viewer's page, as text: the files of src/render/viewer.
#pragma once

namespace tetloft::internal::render {

extern const char* const kViewerHtml;  ///< of the page's body
extern const char* const kViewerCss;
extern const char* const kViewerScripts[3];  ///< in the order of their running

}  // namespace tetloft::internal::render

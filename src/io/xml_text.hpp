// Text on its way into XML.
#pragma once

#include <string>
#include <string_view>

namespace tetloft::internal::io {

/// `text` as an element, or an attribute between double quotes, may hold it and gives it back;
/// what XML cannot hold is U+FFFD (valid_utf8()).
[[nodiscard]] std::string xml_text(std::string_view text);

}  // namespace tetloft::internal::io

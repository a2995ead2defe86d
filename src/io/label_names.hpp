// Names of components where programs take words of ASCII alone.
#pragma once

#include <string>
#include <vector>

#include "io/groups.hpp"

namespace tetloft::internal::io {

/// For each group its name in capital letters, digits and single underscores, beginning with a
/// letter, of at most 60 characters; without two that are equal, nor one of `taken`. What a name
/// loses by that stands in a comment (solid_comments.hpp).
[[nodiscard]] std::vector<std::string> label_names(const std::vector<ComponentGroup>& groups,
                                                   std::vector<std::string> taken = {});

}  // namespace tetloft::internal::io

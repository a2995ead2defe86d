// One JSON value, as the commands print it.
#pragma once

#include "io/json_write.hpp"

namespace tetloft::cli {

using internal::io::JsonWriter;

}  // namespace tetloft::cli

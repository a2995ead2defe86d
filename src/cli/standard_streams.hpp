// Standard streams that the caller closed.
#pragma once

namespace tetloft::cli {

/// Keeps the numbers 0 to 2 of closed streams (`>&-`) from going to the next file that is opened,
/// which messages would then be written into. Writing to one that was closed still fails.
void occupy_standard_streams();

}  // namespace tetloft::cli

// How the program's memory is allocated: its own business, and no library's.
#pragma once

namespace tetloft::cli {

/// Has the allocator keep what is freed in pieces of up to 4 MiB, as long as that is 64 MiB in a
/// row at most: it would give it back and take it again, page by page, for each slab, which took a
/// sixth of the time of stacks with sections in between.
void keep_freed_memory();

}  // namespace tetloft::cli

// What a signal that ends the program must not leave behind.
#pragma once

#include "io/pending_file.hpp"

namespace tetloft::cli {

/// From now on the signals by which a program is ended remove named temporaries first, and then
/// end it as before. A limit of the size of files no longer ends it: the write fails. What the
/// caller's caller had ignored (nohup) stays ignored.
void handle_signals();

/// Learns of named temporaries; to be given to the functions of stage.hpp.
[[nodiscard]] internal::io::TemporaryWatcher* temporary_watcher();

}  // namespace tetloft::cli

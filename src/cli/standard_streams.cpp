// See standard_streams.hpp.
#include "cli/standard_streams.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <initializer_list>

namespace tetloft::cli {

void occupy_standard_streams() {
  for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) {
    if (fcntl(stream, F_GETFD) != -1) continue;
    // The lowest free number, which is this one; for reading only, so that writing fails.
    if (open("/dev/null", O_RDONLY) == -1) return;
  }
}

}  // namespace tetloft::cli

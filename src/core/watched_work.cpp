#include "core/watched_work.hpp"

#include <exception>
#include <string>

#include "core/guard.hpp"

namespace tetloft::internal {

void WatchedWork::go_on() const {
  if (execution_.stop.stop_requested()) throw Cancelled("stopped");
}

void WatchedWork::step_done() {
  if (!execution_.progress) return;
  const std::scoped_lock lock(mutex_);
  try {
    execution_.progress(++done_, all_);
  } catch (const Cancelled&) {  // of the library's own callbacks, which say why
    throw;
  } catch (const std::exception& e) {
    throw Cancelled(std::string("the progress callback threw: ") + e.what());
  } catch (...) {
    throw Cancelled("the progress callback threw");
  }
}

}  // namespace tetloft::internal

#include "core/guard.hpp"

#include <new>
#include <stdexcept>
#include <string>

namespace tetloft::internal {

Error out_of_memory() { return {ErrorCode::out_of_memory, "out of memory", {}}; }

Error error_of_exception() {
  try {
    // Texts of errors take memory, too: the outer handler is for where that ends here.
    try {
      throw;
    } catch (const std::bad_alloc&) {
      return out_of_memory();
    } catch (const std::length_error&) {  // more than any memory holds
      return out_of_memory();
    } catch (const Failed& e) {
      return e.error();
    } catch (const Cancelled& e) {
      return Error{ErrorCode::cancelled, e.what(), {}};
    } catch (const std::exception& e) {
      return Error{ErrorCode::internal, e.what(), {}};
    } catch (...) {
      return Error{ErrorCode::internal, "unknown exception", {}};
    }
  } catch (...) {
    return out_of_memory();
  }
}

void fail_check(const char* condition, const char* file, int line) {
  std::string name = file;
  if (const auto slash = name.find_last_of('/'); slash != std::string::npos) {
    name.erase(0, slash + 1);
  }
  throw InternalError("internal check failed: " + std::string(condition) + " (" + name + ':' +
                      std::to_string(line) + ')');
}

}  // namespace tetloft::internal

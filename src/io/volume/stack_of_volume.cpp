// Contours of volumes.
#include "io/volume/stack_of_volume.hpp"

namespace tetloft::internal::io {

Result<ReadStack> stack_of_volume(Volume& /*volume*/, const std::string& /*name*/,
                                  const ReadOptions& /*options*/) {
  return Error{ErrorCode::internal, "volumes are not read yet", {}};
}

Result<FileSummary> summary_of_volume(Volume& /*volume*/, const ReadOptions& /*options*/) {
  return Error{ErrorCode::internal, "volumes are not read yet", {}};
}

}  // namespace tetloft::internal::io

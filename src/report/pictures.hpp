// Pictures of the model from several sides, for the page.
#pragma once

#include <cstddef>
#include <string>

#include "core/watched_work.hpp"
#include "report/subject.hpp"

namespace tetloft::internal::report {

inline constexpr std::size_t kPictureSteps = 5;

/// From four sides; of a model that cannot be drawn, why not. Tells `work` of
/// kPictureSteps steps where all goes well.
[[nodiscard]] std::string pictures(const Subject& subject, WatchedWork& work);

/// Which letter of `orientation` ("LPS") a direction of the stack points to, placed by `frame`; of
/// one that lies askew, and without orientation, none: 0.
[[nodiscard]] char orientation_letter(const Frame& frame, const std::string& orientation,
                                      const Point3& direction);

}  // namespace tetloft::internal::report

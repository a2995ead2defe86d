// The work limit of a reconstruction, in what the engines count.
#pragma once

#include <algorithm>
#include <cstddef>
#include <limits>

namespace tetloft::internal {

/// Sections and slabs of fewer vertices may take as much work as one of so many: seconds, and
/// some hundred megabytes, by the default limit.
inline constexpr std::size_t kFewVertices = std::size_t{1} << 15;

/// An inserted vertex counts as so many tets: it has about that many in the two slabs at its
/// section.
inline constexpr std::size_t kWorkPerInserted = 16;

/// The most tets for so many vertices; `limit` is ReconstructOptions::work_limit.
[[nodiscard]] inline std::size_t most_work(double limit, std::size_t vertices) {
  const double most = limit * static_cast<double>(std::max(vertices, kFewVertices));
  constexpr std::size_t kAll = std::numeric_limits<std::size_t>::max();
  return most < static_cast<double>(kAll) ? std::max<std::size_t>(1, static_cast<std::size_t>(most))
                                          : kAll;
}

/// The most vertices to be inserted into a section of so many.
[[nodiscard]] inline std::size_t most_inserted(double limit, std::size_t vertices) {
  return std::max<std::size_t>(1, most_work(limit, vertices) / kWorkPerInserted);
}

}  // namespace tetloft::internal

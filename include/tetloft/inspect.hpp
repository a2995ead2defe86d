// What a file holds, told before anything is built of it.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <tetloft/export.hpp>
#include <tetloft/formats.hpp>
#include <tetloft/result.hpp>

namespace tetloft {

/// A structure of a file (ROI, object, segment) as it stands there: nothing is left out.
struct StructureSummary {
  std::int64_t number = 0;
  std::string name;
  /// How many contours there are of each type, by the format's names for them, sorted.
  std::vector<std::pair<std::string, std::size_t>> types;
  std::size_t contours = 0;
  std::size_t points = 0;
  std::size_t planes =
      0;  ///< of closed contours of three points or more; 0 if they are not parallel
  std::size_t closed = 0;  ///< contours, of three points or more
};

/// A value of the voxels of a volume, and what the file calls it.
struct LabelSummary {
  double value = 0;
  std::size_t voxels = 0;
  std::string name;
};

struct VolumeSummary {
  std::vector<std::size_t> size;  ///< voxels along each axis, the fastest first
  std::array<double, 3> spacing{};
  /// From indices to the format's own world, which `space` names ("LPS", "RAS"), row by row.
  std::array<std::array<double, 4>, 4> matrix{};
  std::string space;
  std::string type;  ///< of a voxel: "uint8", "float64", …
  std::string unit;  ///< "mm", "um", …; empty where the file says none
  /// By value, 0 among them; empty where the voxels have more than kMostLabels values. Of all
  /// volumes of the file together, but for segments of several volumes, which are one each.
  std::vector<LabelSummary> labels;
  /// What ReadOptions::structure names, one after the other, to read all structures: segments by
  /// name, labels but 0 by value. Empty of an image.
  std::vector<std::string> structures;
  bool intensities = false;  ///< more values than labels have: an image, to be read at an iso-value
  double least = 0;          ///< value of a voxel
  double largest = 0;
};
inline constexpr std::size_t kMostLabels = 4096;

/// Lines of a drawing, all structures together.
struct LinesSummary {
  std::size_t planes = 0;  ///< of all lines; those that are not planar count for none
  std::size_t contours = 0;
  std::size_t points = 0;
  std::size_t open = 0;
  std::size_t closed = 0;
  std::vector<std::int64_t> labels;  ///< that contours bear, sorted
};

struct FileSummary {
  std::string format;
  std::vector<StructureSummary> structures;  ///< of formats that have them
  std::optional<VolumeSummary> volume;
  std::optional<LinesSummary> lines;  ///< of files of contours
  std::string unit;
  std::vector<Warning> warnings;
};

/// What the file holds. Structures and lines are counted as they stand in it, before any is left
/// out, mended or put into planes; voxels are all read. Errors as of read_stack(), but for what
/// only concerns the stack that would be made of it.
[[nodiscard]] TETLOFT_API Result<FileSummary> inspect(const std::string& path,
                                                      const ReadOptions& options = {});
/// The same of bytes; `name` stands for the file in messages.
[[nodiscard]] TETLOFT_API Result<FileSummary> inspect_bytes(std::string_view bytes,
                                                            const std::string& name,
                                                            const ReadOptions& options = {});

}  // namespace tetloft

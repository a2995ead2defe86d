// Files of whichever format: the formats that there are, and readers and writers that find the
// right one. A file is recognised by its contents, then by its extension; text that is neither is
// taken for the format that has no mark of its own (.cnt of stacks, lines of points). An output's
// format is that of its extension. Errors as in io.hpp; invalid_input where nothing recognises a
// file, usage where an option, or an output's extension, names no format.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <tetloft/execution.hpp>
#include <tetloft/export.hpp>
#include <tetloft/io.hpp>
#include <tetloft/model.hpp>
#include <tetloft/point.hpp>
#include <tetloft/result.hpp>
#include <tetloft/section_stack.hpp>
#include <tetloft/section_stream.hpp>
#include <tetloft/slice.hpp>

namespace tetloft {

/// What a file can hold.
enum class Contents : std::uint8_t {
  stack = 0,
  model = 1,
  surface = 2,  ///< triangles; of a model its boundary
  points = 3,
  labels = 4,  ///< of contours
  lines = 5,   ///< in space
};
inline constexpr int kContents = 6;
/// "stack", "model", …
[[nodiscard]] TETLOFT_API const char* name_of(Contents contents);

class ContentsSet {
 public:
  constexpr void add(Contents contents) {
    bits_ = static_cast<std::uint8_t>(bits_ | 1U << static_cast<unsigned>(contents));
  }
  [[nodiscard]] constexpr bool has(Contents contents) const {
    return (bits_ >> static_cast<unsigned>(contents) & 1U) != 0;
  }

 private:
  std::uint8_t bits_ = 0;
};

struct FormatInfo {
  std::string_view name;     ///< for ReadOptions, WriteOptions, and --format
  std::string_view summary;  ///< a few words, for help
  /// Lower case, with the dot; the first is the usual one.
  std::span<const std::string_view> extensions;
  ContentsSet reads;
  ContentsSet writes;
};

/// All formats, in the order in which contents are looked at.
[[nodiscard]] TETLOFT_API std::span<const FormatInfo> formats();

/// Contours of volumes: through the middles between voxels, moved where values say so, or along the
/// faces of voxels.
enum class VolumeContours : std::uint8_t { sub_pixel, lattice };

/// How contours that lie nearly in one plane are put together where a file has points in space:
/// within this part of the usual gap between planes, if nothing else is said.
inline constexpr double kDefaultPlaneTolerance = 0.01;

struct ReadOptions {
  Validity validity = Validity::required;  ///< of stacks
  std::string format = {};                 ///< by name; empty: it is recognised
  /// Of files of several structures (ROIs, objects, segments, labels) the one that is read: its
  /// name, whatever the case if that is unique, or its number or value. Empty: the only one there
  /// is to read; of contours with labels, all of them.
  std::string structure = {};
  /// GeoJSON: the property that holds the height. Empty: it is found.
  std::string property = {};
  /// Volumes: the region is where values are at least this, in place of a label.
  std::optional<double> iso = {};
  VolumeContours contours = VolumeContours::sub_pixel;
  /// Volumes: the index axis (0, 1, 2) across which slices are taken; none: the last.
  std::optional<int> axis = {};
  /// Points in space: contours whose heights differ by at most this are one section; above 0, in
  /// the file's unit. None: kDefaultPlaneTolerance of the usual gap.
  std::optional<double> plane_tolerance = {};
  /// Lines that end at the rectangle around all lines are closed along it (close_on_frame() in
  /// repair.hpp).
  bool close_on_frame = false;
  Execution execution = {};
};

struct WriteOptions {
  Encoding encoding = Encoding::binary;  ///< where the format has both
  std::string format = {};               ///< by name; empty: as the extension says
};

/// The sections of a file, one after the other.
struct OpenedSections {
  std::unique_ptr<SectionStream> sections;
  std::size_t count = 0;  ///< how many there are
  std::vector<Warning> warnings;
  Labels labels = {};      ///< that the file gives its contours
  bool in_memory = false;  ///< all of it was read
};

struct ReadModel {
  Model model;
  std::vector<Warning> warnings;
};

struct ReadPoints {
  std::vector<Point3> points;
  std::vector<Warning> warnings;
};

struct ReadTriangles {
  /// Polygons of more corners are fans of triangles around their first one.
  TriangleMesh mesh;
  std::vector<Warning> warnings;
};

/// A file's bytes, and the warnings that its writer would return.
struct Formatted {
  std::string bytes;
  std::vector<Warning> warnings;
};

// Each: read_ from a file; parse_ from bytes, where `name` stands for the file in messages and
// tells the extension; write_ to a file; format_ to bytes, in options.format, which is required.

[[nodiscard]] TETLOFT_API Result<ReadStack> read_stack(const std::string& path,
                                                       const ReadOptions& options = {});
[[nodiscard]] TETLOFT_API Result<ReadStack> parse_stack(std::string_view bytes,
                                                        const std::string& name,
                                                        const ReadOptions& options = {});
/// The same of what reconstruct() need not validate again; options.validity plays no part.
[[nodiscard]] TETLOFT_API Result<ReadValidStack> read_valid_stack(const std::string& path,
                                                                  const ReadOptions& options = {});
[[nodiscard]] TETLOFT_API Result<ReadValidStack> parse_valid_stack(std::string_view bytes,
                                                                   const std::string& name,
                                                                   const ReadOptions& options = {});
/// The sections that read_stack() reads, bit for bit, with its warnings and its errors, each in its
/// words, all when it is opened: a file that is faulty is refused here. A .cnt is then read once
/// more, section by section: memory of some sections, whatever their number, but for 32 bytes each;
/// and the file, which stays open, may be larger than kLargestFile. Where it has changed meanwhile,
/// next() ends with an error, io, or what is wrong with it now. Read as a whole, and handed out
/// from memory, is what is no regular file, of another format (volumes too: which sections they
/// have the last slice tells), or to be closed on the frame; with Validity::unchecked; and a .cnt
/// whose numbers are not plainly pairs, for which the counts of all sections have to be looked at
/// again.
[[nodiscard]] TETLOFT_API Result<OpenedSections> open_sections(const std::string& path,
                                                               const ReadOptions& options = {});
[[nodiscard]] TETLOFT_API Result<std::vector<Warning>> write_stack(
    const std::string& path, const SectionStack& stack, const WriteOptions& options = {});
[[nodiscard]] TETLOFT_API Result<Formatted> format_stack(const SectionStack& stack,
                                                         const WriteOptions& options);

/// Models are written where they are well formed, as write_vtu() asks.
[[nodiscard]] TETLOFT_API Result<ReadModel> read_model(const std::string& path,
                                                       const ReadOptions& options = {});
[[nodiscard]] TETLOFT_API Result<ReadModel> parse_model(std::string_view bytes,
                                                        const std::string& name,
                                                        const ReadOptions& options = {});
[[nodiscard]] TETLOFT_API Result<std::vector<Warning>> write_model(
    const std::string& path, const Model& model, const WriteOptions& options = {});
[[nodiscard]] TETLOFT_API Result<Formatted> format_model(const Model& model,
                                                         const WriteOptions& options);

/// A surface of any origin, as it stands in the file: closed or not, points perhaps several times.
/// All coordinates are finite, every corner is a point, and there is a triangle. Of the options
/// `format` alone matters.
[[nodiscard]] TETLOFT_API Result<ReadTriangles> read_triangles(const std::string& path,
                                                               const ReadOptions& options = {});
[[nodiscard]] TETLOFT_API Result<ReadTriangles> parse_triangles(std::string_view bytes,
                                                                const std::string& name,
                                                                const ReadOptions& options = {});

/// The boundary of a model; contracts as of write_surface() in io.hpp.
[[nodiscard]] TETLOFT_API Result<std::vector<Warning>> write_surface(const std::string& path,
                                                                     const Model& model,
                                                                     const WriteOptions& options);
[[nodiscard]] TETLOFT_API Result<Formatted> format_surface(const Model& model,
                                                           const WriteOptions& options);

/// Text lines "x y z" (# comments), or little-endian float64 triples if the name ends in
/// ".bin". All coordinates are finite.
[[nodiscard]] TETLOFT_API Result<ReadPoints> read_points(const std::string& path,
                                                         const ReadOptions& options = {});
[[nodiscard]] TETLOFT_API Result<ReadPoints> parse_points(std::string_view bytes,
                                                          const std::string& name,
                                                          const ReadOptions& options = {});
[[nodiscard]] TETLOFT_API Result<std::vector<Warning>> write_points(
    const std::string& path, const std::vector<Point3>& points, const WriteOptions& options = {});
[[nodiscard]] TETLOFT_API Result<Formatted> format_points(const std::vector<Point3>& points,
                                                          const WriteOptions& options);

}  // namespace tetloft

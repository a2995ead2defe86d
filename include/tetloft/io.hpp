// Readers and writers of one format each; formats.hpp has those that find the format. A file
// appears complete or not at all; symbolic links are followed. Errors: io where a file cannot be
// read or written, invalid_input naming file and line where its contents are wrong, usage for an
// Encoding or Validity that there is none of. Counts in headers are checked, never trusted.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include <tetloft/correspondence.hpp>
#include <tetloft/export.hpp>
#include <tetloft/model.hpp>
#include <tetloft/result.hpp>
#include <tetloft/section_stack.hpp>
#include <tetloft/valid_stack.hpp>

namespace tetloft {

/// Larger files, and longer streams (pipes, devices), are refused (io), for a reader holds what
/// it reads. Bytes that the caller has go through parse_… whatever their size.
inline constexpr std::uint64_t kLargestFile = std::uint64_t{1} << 32;
inline constexpr std::uint64_t kLargestStream = std::uint64_t{1} << 28;

/// Whatever a file holds, reading it takes at most this many bytes of memory for each of its
/// own, and kReaderBytes.
inline constexpr std::size_t kReaderMultiple = 64;
/// A stack of a volume takes more where each voxel has a contour of its own: at most so many bytes
/// for each voxel of one byte, or its part of a packed file.
inline constexpr std::size_t kVolumeMultiple = 512;
inline constexpr std::size_t kReaderBytes = std::size_t{1} << 21;

struct ReadStack {
  SectionStack stack;
  std::vector<Warning> warnings;  ///< harmless slips, mended
  /// Where each contour begins, for messages: lines[section][contour]. Empty where the format has
  /// no lines.
  IdVector<SectionId, IdVector<ContourId, std::size_t>> lines;
  Labels labels = {};  ///< that the file gives its contours
};

/// The same where the stack was validated, and may not be changed since.
struct ReadValidStack {
  ValidStack stack;
  std::vector<Warning> warnings;
  IdVector<SectionId, IdVector<ContourId, std::size_t>> lines;
  Labels labels = {};
};

/// Whether a reader validates what it read, or leaves that to the caller, who may repair() first.
enum class Validity { required, unchecked };

/// Reads NUAGES .cnt: "S n", then for each section "v n z z" and contours "{ x y … }". Header
/// letters in either case, any white space, LF or CRLF, commas or semicolons between numbers, #
/// comments, any numeric form that strtod of the C locale accepts for finite numbers. Mends
/// harmless slips (mend() in repair.hpp, wrong counts, the height as third number of every
/// vertex) and validates; warns of suspicious_gaps(), and of contours that seem to be open lines
/// cut off at a frame. At most about a thousand warnings. Errors name file and line.
[[nodiscard]] TETLOFT_API Result<ReadStack> read_cnt(const std::string& path,
                                                     Validity validity = Validity::required);
/// The same from text; `name` stands for the file in messages.
[[nodiscard]] TETLOFT_API Result<ReadStack> parse_cnt(std::string_view text,
                                                      const std::string& name,
                                                      Validity validity = Validity::required);
[[nodiscard]] TETLOFT_API Result<void> write_cnt(const std::string& path,
                                                 const SectionStack& stack);
/// The bytes that write_cnt() writes; and so with each format_ below.
[[nodiscard]] TETLOFT_API Result<std::string> format_cnt(const SectionStack& stack);

/// Lines "section contour label", and "join section contour other" or "part section contour other":
/// decisions on the link between a contour of a section and another of the section above. Of voids:
/// "hole section contour label", and "open section hole other" or "close section hole other", where
/// a hole is a contour or the word "outside". Zero-based; # starts a comment. Refused where two
/// lines say join and part, or open and close, of the same.
[[nodiscard]] TETLOFT_API Result<Labels> read_labels(const std::string& path);
[[nodiscard]] TETLOFT_API Result<Labels> parse_labels(std::string_view text,
                                                      const std::string& name);
[[nodiscard]] TETLOFT_API Result<void> write_labels(const std::string& path, const Labels& labels);
[[nodiscard]] TETLOFT_API Result<std::string> format_labels(const Labels& labels);

enum class Encoding {
  binary,
  ascii,
  compressed,  ///< binary, as zlib streams where the format has them
};

/// VTK XML unstructured grid: Float64 points; cell data component, slab, kind; point data
/// section, contour, origin, each left out where the model's is empty; an invalid id is −1; links
/// and motions, and about and component_names as UTF-8, as field data. All is read back bit for
/// bit, ASCII too; but of names, where there are more components than tets, nothing. Compressed
/// data would not be read back where they unpack to more than 32 times their size: they are written
/// plain then. Refused (invalid_input) where an array has a wrong length, a tet names a vertex that
/// there is not, a kind or origin is none; or a link or motion has no slab or contour, no evidence
/// or fate, or a number that is not finite.
[[nodiscard]] TETLOFT_API Result<void> write_vtu(const std::string& path, const Model& model,
                                                 Encoding encoding = Encoding::binary);
[[nodiscard]] TETLOFT_API Result<std::string> format_vtu(const Model& model,
                                                         Encoding encoding = Encoding::binary);
/// Writes any tetrahedral mesh, without provenance. Refused as above.
[[nodiscard]] TETLOFT_API Result<void> write_vtu(const std::string& path,
                                                 const std::vector<Point3>& points,
                                                 const std::vector<TetVertices>& tets,
                                                 Encoding encoding = Encoding::binary);
[[nodiscard]] TETLOFT_API Result<std::string> format_vtu(const std::vector<Point3>& points,
                                                         const std::vector<TetVertices>& tets,
                                                         Encoding encoding = Encoding::binary);
/// Reads points, tets and, where present, the arrays that write_vtu makes. Accepts
/// ascii, inline base64 and appended (raw or base64) data, plain or packed by zlib.
/// Arrays that a file lacks, or has with values of another meaning, are left empty, and so are
/// links, or motions, of which one array is such.
[[nodiscard]] TETLOFT_API Result<Model> read_vtu(const std::string& path);
/// The same from bytes; `name` stands for the file in messages.
[[nodiscard]] TETLOFT_API Result<Model> parse_vtu(std::string_view bytes, const std::string& name);

/// Writes the boundary surface as .obj, .off, .ply, .vtp or .3mf (doubles), .stl or .glb (float32),
/// by extension, with components, names and unit as far as the format has them. Vertices are those
/// of the surface, renumbered by id. The warnings say where rounding to float32 merges vertices or
/// flattens triangles, and what .3mf lacks: the unit, or a closed surface of each component.
/// Refused: other extensions (usage), coordinates beyond float32 in .stl and .glb, .3mf and .glb of
/// 4 GiB, and models as in write_vtu() (invalid_input).
[[nodiscard]] TETLOFT_API Result<std::vector<Warning>> write_surface(
    const std::string& path, const Model& model, Encoding encoding = Encoding::binary);

/// Line segments in space, each with integers of the same names.
struct LineSet {
  struct Array {
    std::string name;
    std::vector<std::int32_t> value;  ///< by line
  };
  std::vector<std::array<Point3, 2>> lines;
  std::vector<Array> data;
};

/// VTK XML poly data (.vtp) of lines, with `data` as cell data. Refused (invalid_input) where an
/// array has a wrong length.
[[nodiscard]] TETLOFT_API Result<void> write_lines(const std::string& path, const LineSet& lines,
                                                   Encoding encoding = Encoding::binary);
[[nodiscard]] TETLOFT_API Result<std::string> format_lines(const LineSet& lines,
                                                           Encoding encoding = Encoding::binary);

/// Polyhedra in space, each with numbers of the same names: Voronoi cells, say.
struct PolyhedronSet {
  struct Array {
    std::string name;
    std::vector<double> value;  ///< by cell
  };
  /// A face: its corners' places in `points`, counter-clockwise as seen from outside.
  using Face = std::vector<std::uint32_t>;
  std::vector<Point3> points;
  std::vector<std::vector<Face>> cells;  ///< by cell, its faces
  std::vector<Array> data;
};

/// VTK XML unstructured grid (.vtu) of polyhedra, with `data` as cell data. Refused (invalid_input)
/// where an array has a wrong length, or a corner is no point.
[[nodiscard]] TETLOFT_API Result<void> write_polyhedra(const std::string& path,
                                                       const PolyhedronSet& polyhedra,
                                                       Encoding encoding = Encoding::binary);
[[nodiscard]] TETLOFT_API Result<std::string> format_polyhedra(
    const PolyhedronSet& polyhedra, Encoding encoding = Encoding::binary);

/// Writes `bytes`, which appear at `path` all or not at all; directly where a pipe or a device is.
[[nodiscard]] TETLOFT_API Result<void> write_file(const std::string& path, std::string_view bytes);

}  // namespace tetloft

// A report that can be handed on: one page with pictures, sections, guarantees, figures and plots,
// and all its numbers as values.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include <tetloft/check.hpp>
#include <tetloft/execution.hpp>
#include <tetloft/export.hpp>
#include <tetloft/ids.hpp>
#include <tetloft/model.hpp>
#include <tetloft/result.hpp>
#include <tetloft/section_stack.hpp>

namespace tetloft {

/// How many sections a report shows.
inline constexpr std::size_t kMostReportSections = 12;
inline constexpr std::size_t kDefaultReportSections = 8;

/// Texts may hold anything: what is no UTF-8, and control characters, are shown as U+FFFD.
struct ReportOptions {
  std::string title = {};  ///< empty: the name of the model, or of the stack
  std::string model_file = {};
  std::string stack_file = {};
  std::string command = {};  ///< the command line that makes the report
  std::string date = {};     ///< shown as it is; the library asks no clock
  /// So many are shown at most, the first, the last, and evenly between; and the middles between
  /// them and the next. 1 to kMostReportSections.
  std::size_t sections = kDefaultReportSections;
  std::vector<Warning> warnings = {};  ///< of reading
  CheckOptions check = {};             ///< its `execution` is not looked at
  Execution execution = {};
};

struct ReportSpread {
  double least = 0;
  double median = 0;  ///< the lower one of an even number
  double most = 0;
};

/// counts[k] values lie in [edges[k], edges[k + 1]), in the last bin also its upper end.
struct ReportHistogram {
  std::vector<double> edges = {};
  std::vector<std::size_t> counts = {};
};

/// Of one component, or of all. Lengths, areas and volumes are those where the model lies in the
/// space of its file.
struct ReportMeasures {
  std::size_t tets = 0;
  double volume = 0;
  double surface_area = 0;
  std::size_t surfaces = 0;  ///< connected parts of the boundary
  /// Closed hollows: every component has one outer surface, and each further one is a cavity's.
  /// None, like genus, where the boundary is no manifold (guarantee 1 fails).
  std::optional<std::size_t> cavities = std::nullopt;
  /// Summed over the surfaces: how many handles, which are tunnels through the solid.
  std::optional<long> genus = std::nullopt;
  /// The first and the last section with a vertex of it; none where there is no such section.
  std::optional<SectionId> first = std::nullopt;
  std::optional<SectionId> last = std::nullopt;
};

struct ReportComponent {
  std::string name;
  ReportMeasures measures = {};
};

/// An area at a height: z of the stack.
struct ReportArea {
  double z = 0;
  double area = 0;
};

struct ReportQuality {
  std::size_t edges = 0;  ///< distinct ones
  ReportSpread edge_length = {};
  ReportSpread dihedral = {};           ///< of all angles, in degrees
  ReportSpread smallest_dihedral = {};  ///< of each tet's smallest
  /// 12 (3 V)^(2/3) / (sum of squared edges) of each tet (Liu and Joe 1994): 1 of a regular one, 0
  /// of a flat one.
  ReportSpread mean_ratio = {};
  ReportHistogram dihedrals = {};     ///< all angles, in steps of 5 degrees
  ReportHistogram edge_lengths = {};  ///< in steps of a factor
};

struct ReportFigures {
  ReportMeasures all = {};
  std::vector<ReportComponent> components = {};
  std::size_t vertices = 0;  ///< in use
  std::size_t boundary_triangles = 0;
  /// Components have points in common, as other programs' may: their areas, genus and cavities are
  /// then of the boundary of all.
  bool components_touch = false;
  std::vector<std::size_t> kinds = {};  ///< by TetKind; empty where the model tells none
  ReportQuality quality = {};
  std::vector<ReportArea> solid = {};     ///< of the solid, at heights between sections
  std::vector<ReportArea> sections = {};  ///< of the regions of each section; empty without a stack
  /// Of the solid between the first section and the last, and what the areas of the sections alone
  /// give: the sum of frusta, gap (A + √(A B) + B) / 3. None without a stack of two sections.
  std::optional<double> volume_between = std::nullopt;
  std::optional<double> frustum_volume = std::nullopt;
};

/// What became of a guarantee.
enum class ReportVerdict : std::uint8_t { holds, fails, unchecked };
[[nodiscard]] TETLOFT_API const char* name_of(ReportVerdict verdict);

struct ReportGuarantee {
  int number = 0;
  std::string name;
  ReportVerdict verdict = ReportVerdict::unchecked;
  std::string why = {};  ///< of an unchecked one
  std::vector<CheckFailure> failures = {};
};

struct TETLOFT_API Report {
  std::string html;
  std::string title;
  ReportFigures figures;
  std::vector<ReportGuarantee> guarantees;  ///< the five, in order
  std::optional<CheckReport> check;         ///< none without a stack
  /// Whether no guarantee that was asked failed.
  [[nodiscard]] bool pass() const;
};

/// The report of a model, against the stack that it claims to fill; null: guarantees 1 and 3 alone
/// are checked, and the outlines of the model stand for contours. A model that fails guarantees has
/// a report that says so; what cannot be drawn or measured of it is left out, and the page says
/// that, too. Refused: as check(); and usage for `sections` out of range, invalid_input for a model
/// without sound tets (guarantee 1.1), or with arrays of wrong lengths.
[[nodiscard]] TETLOFT_API Result<Report> render_report(const Model& model,
                                                       const SectionStack* stack,
                                                       const ReportOptions& options = {});

}  // namespace tetloft

// The check of a solid that is never in memory as a whole: segment by segment, from below.
//
// A segment is a model of slabs next to each other. Two that follow each other share the vertices
// of one section, their seam, and nothing else. A seam is flat: its vertices lie in the plane of
// its section, all others of segments below lie below it, and those of segments above above it.
// What README.md asks is then asked once, of segments and of what lies around seams ("Piece by
// piece" there).
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include <tetloft/check.hpp>

#include "check/conclusions.hpp"
#include "check/figures.hpp"
#include "check/findings.hpp"
#include "check/seam.hpp"
#include "check/winding.hpp"
#include "core/watched_work.hpp"

namespace tetloft::internal::checking {

struct Segment {
  Model model;
  SectionRange sections;         ///< of its slabs, those of its seams with them
  std::vector<VertexId> number;  ///< of its vertices, in the whole
  std::size_t first_tet = 0;     ///< the number of the first in the whole; others follow it
  std::string name;              ///< in front of places
};

class SegmentCheck {
 public:
  /// All must outlive it; the stack is valid, and the options are sensible (check_arguments()).
  SegmentCheck(const SectionStack& stack, const CheckOptions& options, WatchedWork& work);

  /// The next one; its tables are those of its slabs. Requires flat seams.
  void add(Segment segment);
  /// As check() of the whole model, but for: places, which are those of the first segments that
  /// have any; volume, a sum in another order; counts of contacts, of which each segment and seam
  /// has its own limit; and 3.4 where guarantee 1 fails, too: each surface is asked at one of its
  /// triangles, which tells of all of it where the boundary is closed.
  [[nodiscard]] Result<CheckReport> report();
  /// The steps of the work that it takes: components, what is expected of cavities, and these.
  static constexpr std::size_t kReportSteps = 3;

 private:
  [[nodiscard]] ModelView show(const Segment& segment) const;
  SegmentNumbering check_view(const Segment& segment, const ModelView& view,
                              const SurfaceComponents& surface);
  void check_seam(std::size_t section, const SeamSide& upper, const std::string& name);
  void wind(const ModelView& view, std::span<const TriangleVertices> triangles,
            std::span<const std::uint32_t> patch);
  void check_winding();
  void add_tables(const Model& model);

  const SectionStack& stack_;
  const CheckOptions& options_;
  WatchedWork& work_;
  Conclusions conclusions_;
  std::vector<std::size_t> region_at_, void_at_;
  SectionStack refined_;
  Findings manifold_, resampling_, embedded_;
  SolidComponents components_;
  SurfacePatches patches_;
  OuterWinding winding_;
  std::vector<SlabPart> parts_;
  ModelTables tables_;
  ViewFigures figures_;
  // Of the segment before.
  std::optional<SeamSide> below_;
  std::string name_below_;
};

}  // namespace tetloft::internal::checking

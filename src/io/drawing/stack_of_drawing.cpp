// From a drawing to a stack, in these steps: the structure is chosen; lines that bound nothing are
// left out; parallel planes are found and turned to constant z; sections are filled; what the
// format allows to touch is repaired; labels and adjacency become those of the stack.
#include "io/drawing/stack_of_drawing.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include <tetloft/repair.hpp>
#include <tetloft/valid_stack.hpp>

#include "io/drawing/choose_lines.hpp"
#include "io/drawing/file_labels.hpp"
#include "io/drawing/join_lines.hpp"
#include "io/drawing/plane_gaps.hpp"
#include "io/drawing/planes.hpp"
#include "io/numbers.hpp"

namespace tetloft::internal::io {

namespace {

class StackMaker {
 public:
  StackMaker(Drawing drawing, const std::string& name, const ReadOptions& options)
      : drawing_(std::move(drawing)), name_(name), options_(options) {}

  Result<StackOfFile> make() {
    if (drawing_.prepare) {
      if (Result<void> done = drawing_.prepare(drawing_); !done) return at(done.error());
    }
    if (!drawing_.leaves_out_open) join_pieces();
    Result<ChosenLines> chosen = choose_lines(drawing_, options_.structure);
    if (!chosen) return at(chosen.error());
    lines_ = std::move(chosen->lines);
    read_.stack.about = {std::move(chosen->name), drawing_.unit, drawing_.orientation};
    read_.warnings = std::move(drawing_.warnings);
    if (!drawing_.not_parallel.empty()) {
      return at({ErrorCode::invalid_input,
                 drawing_.not_parallel + "; sections must be parallel planes",
                 {}});
    }
    if (Result<void> done = leave_out(); !done) return at(done.error());
    if (Result<void> done = fill_sections(); !done) return at(done.error());
    if (options_.close_on_frame) {
      if (Result<void> done = close_lines(); !done) return at(done.error());
    }
    for (Warning& warning : suspicious_gaps(read_.stack)) warn(std::move(warning));
    if (options_.validity == Validity::required) {
      if (Result<void> done = make_valid(); !done) return at(done.error());
    }
    add_labels();
    for (Warning& warning : read_.warnings) {
      if (warning.where.file.empty()) warning.where.file = name_;
    }
    return StackOfFile{std::move(read_), std::move(nestings_)};
  }

 private:
  Error at(Error error) const {
    if (error.where.file.empty()) error.where.file = name_;
    return error;
  }

  void warn(Warning warning) { read_.warnings.push_back(std::move(warning)); }

  Error of_line(const std::string& message, const ChosenLine& line) const {
    Error error{ErrorCode::invalid_input, place_of(drawing_, line) + ": " + message, {}};
    if (line.line.line != 0) error.where.line = line.line.line;
    return error;
  }

  void join_pieces() {
    std::size_t joined = 0;
    for (DrawnStructure& structure : drawing_.structures) {
      joined += join_open_lines(structure.lines);
    }
    if (joined == 0) return;
    drawing_.warnings.push_back({std::to_string(joined) +
                                     (joined == 1 ? " open line" : " open lines") +
                                     " joined to others that begin or end in the same point",
                                 {}});
  }

  // Points, open lines, and what is left of a contour without repeated vertices.
  Result<void> leave_out() {
    std::map<std::string, std::size_t> kinds;  // that are left out, by what they are called
    std::size_t few = 0;
    std::vector<ChosenLine> kept;
    for (ChosenLine& line : lines_) {
      if (line.line.left_out) continue;
      const bool closes = options_.close_on_frame && line.line.kind == LineKind::open;
      if (line.line.kind == LineKind::open && !drawing_.leaves_out_open && !closes) {
        return of_line(
            "an open line, as " + std::to_string(open_lines()) + " of " +
                std::to_string(lines_.size()) +
                " are; it bounds no region (lines that end at the frame of all lines are "
                "closed along it on request: --close-on-frame)",
            line);
      }
      if (line.line.kind != LineKind::closed && !closes) {
        const bool open = line.line.kind == LineKind::open;
        ++kinds[line.line.type.empty() ? (open ? "open line" : "points") : line.line.type];
        continue;
      }
      drop_repeated(line.line.points);
      if (line.line.points.size() < (closes ? 2U : 3U)) {
        ++few;
        continue;
      }
      kept.push_back(std::move(line));
    }
    lines_ = std::move(kept);
    for (const auto& [kind, count] : kinds) {
      warn({"left out: " + std::to_string(count) + " of type " + in_quotes(kind) +
                ", which bound no region",
            {}});
    }
    if (few > 0) {
      warn({"left out: " + std::to_string(few) + (few == 1 ? " contour" : " contours") +
                " of one or two points",
            {}});
    }
    if (lines_.empty()) {
      return Error{ErrorCode::invalid_input,
                   (read_.stack.about.name.empty()
                        ? std::string("there")
                        : "in structure " + in_quotes(read_.stack.about.name) + " there") +
                       " is no closed contour of three points or more",
                   {}};
    }
    return {};
  }

  std::size_t open_lines() const {
    std::size_t count = 0;
    for (const ChosenLine& line : lines_) count += line.line.kind == LineKind::open ? 1 : 0;
    return count;
  }

  // In space: what is twice in the plane may be two points of an oblique line.
  static void drop_repeated(std::vector<Point3>& points) {
    points.erase(std::unique(points.begin(), points.end()), points.end());
    while (points.size() > 1 && points.back() == points.front()) points.pop_back();
  }

  Result<void> fill_sections() {
    std::vector<PointsOfLine> points;
    for (const ChosenLine& line : lines_) points.push_back(&line.line.points);
    const PlanesOfLines planes =
        planes_of(points, plane_tolerance(drawing_, options_.plane_tolerance));
    if (const auto off = off_plane(planes)) return not_parallel(planes, *off);
    read_.stack.frame = planes.frame;
    warn_of_heights(planes);
    for (Warning& warning : plane_gaps(planes)) warn(std::move(warning));
    for (const double z : planes.height) {
      read_.stack.sections.push_back({z, {}});
      read_.lines.push_back({});
      origin_.emplace_back();
    }
    const double lattice = lattice_of(planes, points);
    const auto rounded = [&](double x) {
      return lattice == 0 ? x : std::nearbyint(x / lattice) * lattice;
    };
    for (std::size_t i = 0; i < lines_.size(); ++i) {
      const SectionId s(planes.plane[i]);
      Contour contour;
      contour.vertices.reserve(lines_[i].line.points.size());
      for (const Point3& p : lines_[i].line.points) {
        const Point3 q = unplace(planes.frame, p);
        const Point2 flat{rounded(q.x), rounded(q.y)};
        if (!contour.vertices.empty() && contour.vertices.back() == flat) continue;
        contour.vertices.push_back(flat);
      }
      lines_[i].line.points = {};
      read_.stack.sections[s].contours.push_back(std::move(contour));
      read_.lines[s].push_back(lines_[i].line.line);
      origin_[s.index()].push_back(i);
    }
    return {};
  }

  // Contours that are lines stand in the sections like others, until here.
  Result<void> close_lines() {
    std::vector<ContourOfSection> open;
    for (const SectionId s : read_.stack.sections.ids()) {
      for (std::size_t c = 0; c < origin_[s.index()].size(); ++c) {
        if (lines_[origin_[s.index()][c]].line.kind != LineKind::open) continue;
        open.push_back({s, ContourId(c)});
      }
    }
    if (open.empty()) {
      warn({"no line is open: nothing is closed along a frame", {}});
      return {};
    }
    Result<ClosedOnFrame> closed = close_on_frame(read_.stack, open);
    if (!closed) return refusal(closed.error());
    read_.stack = std::move(closed->stack);
    for (Warning& change : closed->changes) warn(std::move(change));
    const LineOfContour before = std::move(origin_);
    origin_ = {};
    for (const SectionId s : read_.stack.sections.ids()) {
      origin_.emplace_back();
      read_.lines[s].clear();
      for (const ContourId of : closed->origin[s]) {
        // The rectangle stands for the first line of the file.
        const std::size_t line = of.valid() ? before[s.index()][of.index()] : 0;
        origin_.back().push_back(line);
        read_.lines[s].push_back(of.valid() ? lines_[line].line.line : 0);
      }
    }
    // What runs along the frame may touch what ends there.
    drawing_.may_touch = true;
    return {};
  }

  Error not_parallel(const PlanesOfLines& planes, std::size_t off) const {
    const double extent = planes.high[off] - planes.low[off];
    std::string message = "is not in a plane parallel to the others: its points are up to ";
    append_number(message, extent);
    message += " apart across it (more than the tolerance, ";
    append_number(message, planes.tolerance);
    message += "); sections must be parallel planes (--plane-tolerance allows more)";
    return of_line(message, lines_[off]);
  }

  // Heights that were brought to those of their planes.
  void warn_of_heights(const PlanesOfLines& planes) {
    std::size_t moved = 0;
    double farthest = 0;
    for (std::size_t i = 0; i < planes.low.size(); ++i) {
      const double z = planes.height[planes.plane[i]];
      const double by = std::max(z - planes.low[i], planes.high[i] - z);
      if (by > 0) ++moved;
      farthest = std::max(farthest, by);
    }
    // Turning rounds heights, which is nothing to tell of.
    if (moved == 0 || (!is_exact(planes.frame) && farthest < planes.tolerance / 1024)) return;
    std::string message = std::to_string(moved) + (moved == 1 ? " contour" : " contours") +
                          " put into the planes of others near them, by ";
    append_number(message, farthest);
    message += " at most; planes less than ";
    append_number(message, planes.tolerance);
    message += " apart are one (--plane-tolerance)";
    warn({std::move(message), {}});
  }

  Result<void> make_valid() {
    Result<void> valid = nest();
    if (valid) return {};
    if (!drawing_.may_touch) return refusal(valid.error());
    Result<Repaired> repaired = repair(read_.stack, {.execution = options_.execution});
    if (!repaired) return refusal(repaired.error());
    for (const Warning& change : repaired->changes) {
      Warning warning{"repaired: " + change.message, change.where};
      warn(std::move(warning));
    }
    read_.stack = std::move(repaired->stack);
    read_.lines = {};
    repaired_ = true;
    return nest();
  }

  // Validates.
  Result<void> nest() {
    auto nested = nest_if_valid(read_.stack, {.threads = 1});
    if (!nested) return nested.error();
    nestings_ = *std::move(nested);
    return {};
  }

  // With the place in the file.
  Error refusal(Error error) const {
    if (!error.where.section || !error.where.contour) return error;
    const auto& of_section = origin_[*error.where.section];
    if (*error.where.contour >= of_section.size()) return error;
    const ChosenLine& line = lines_[of_section[*error.where.contour]];
    if (line.line.line != 0) {
      error.where.line = line.line.line;
    } else {
      error.message += " (" + place_of(drawing_, line) + " of the file)";
    }
    return error;
  }

  void add_labels() {
    if (!drawing_.labelled && drawing_.joins.empty()) return;
    // Unchecked: what is mended is numbered anew.
    if (nestings_.empty() && !validate(read_.stack, {.threads = 1})) return;
    if (repaired_) {
      warn({"the labels of the file are left out, for repairing numbered the contours anew", {}});
      return;
    }
    read_.labels = drawing_.labelled
                       ? labels_of_lines(origin_, lines_, read_.stack)
                       : labels_of_joins(origin_, lines_, drawing_.joins, read_.stack);
  }

  Drawing drawing_;
  const std::string& name_;
  const ReadOptions& options_;
  std::vector<ChosenLine> lines_;
  ReadStack read_;
  IdVector<SectionId, Nesting> nestings_;
  LineOfContour origin_;
  bool repaired_ = false;
};

}  // namespace

Result<StackOfFile> stack_of_drawing(Drawing drawing, const std::string& name,
                                     const ReadOptions& options) {
  return StackMaker(std::move(drawing), name, options).make();
}

}  // namespace tetloft::internal::io

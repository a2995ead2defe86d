// Open level lines closed along a rectangle: which of a section's two closings (frame_perimeter)
// is meant follows from the sections beside it.
#include <algorithm>
#include <array>
#include <charconv>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include <tetloft/repair.hpp>

#include "core/guard.hpp"
#include "sections/contour_edges.hpp"
#include "sections/frame_perimeter.hpp"

namespace tetloft {

using namespace internal;

namespace {

// One by one: in the one file a directive would hand the names of all sources to those behind.
using sections::closing;
using sections::ContourEdges;
using sections::FramedContour;
using sections::FramedSection;
using sections::FramePosition;
using sections::LineEnd;
using sections::OpenLineOnFrame;
using sections::position_on;
using sections::Rectangle;
using sections::trim_along;

// [whether the closing is the one with inside before the corner]
using ByClosing = std::array<std::size_t, 2>;

std::string number_text(double value) {
  char text[32];
  return {text, std::to_chars(text, text + sizeof text, value).ptr};
}

std::string text_of(const Point2& p) {
  return '(' + number_text(p.x) + ", " + number_text(p.y) + ')';
}

std::string text_of(const Rectangle& frame) {
  return "the rectangle from " + text_of(frame.low) + " to " + text_of(frame.high);
}

std::string counted(std::size_t n, const char* one, const char* many) {
  return std::to_string(n) + ' ' + (n == 1 ? one : many);
}

class FrameCloser {
 public:
  FrameCloser(const SectionStack& stack, const std::vector<ContourOfSection>& open,
              const FrameOptions& options)
      : stack_(stack), options_(options) {
    for (const Section& section : stack.sections) is_open_.emplace_back(section.contours.size());
    for (const ContourOfSection& line : open) {
      if (line.section.index() >= stack.sections.size() ||
          line.contour.index() >= is_open_[line.section.index()].size()) {
        stray_ = true;
        continue;
      }
      is_open_[line.section.index()][line.contour.index()] = true;
    }
  }

  Result<ClosedOnFrame> close() {
    if (stray_) return Error{ErrorCode::usage, "an open line is none of the stack's contours", {}};
    if (Result<void> found = find_frame(); !found) return found.error();
    for (const SectionId s : stack_.sections.ids()) {
      if (Result<void> taken = take_section(s); !taken) return taken.error();
    }
    const std::vector<bool> chosen = choose();
    ClosedOnFrame result;
    result.stack.frame = stack_.frame;
    result.stack.about = stack_.about;
    std::size_t whole = 0;
    for (const SectionId s : stack_.sections.ids()) {
      const FramedSection& section = sections_[s.index()];
      const bool inside = chosen[s.index()];
      if (inside && section.ends.empty()) ++whole;
      result.stack.sections.push_back({stack_.sections[s].z, {}});
      result.origin.push_back({});
      for (FramedContour& contour : closing(section, frame_, inside)) {
        result.stack.sections[s].contours.push_back(std::move(contour.contour));
        result.origin[s].push_back(contour.of);
      }
    }
    tell(whole);
    result.low = frame_.low;
    result.high = frame_.high;
    result.changes = std::move(changes_);
    return result;
  }

 private:
  Result<void> find_frame() {
    if (options_.corners) {
      frame_ = {(*options_.corners)[0], (*options_.corners)[1]};
    } else {
      bound();
    }
    if (!(frame_.low.x < frame_.high.x && frame_.low.y < frame_.high.y)) {
      return Error{options_.corners ? ErrorCode::usage : ErrorCode::invalid_input,
                   text_of(frame_) + " along which lines are to be closed has no area",
                   {}};
    }
    if (Result<void> ends = check_ends(); !ends) return ends;
    if (!options_.corners) widen();
    return {};
  }

  template <class Take>
  void for_each_line(Take&& take) const {
    for (const SectionId s : stack_.sections.ids()) {
      for (const ContourId c : stack_.sections[s].contours.ids()) {
        if (is_open_[s.index()][c.index()]) take(s, c, stack_.sections[s].contours[c].vertices);
      }
    }
  }

  void bound() {
    constexpr double kInfinity = std::numeric_limits<double>::infinity();
    frame_ = {{kInfinity, kInfinity}, {-kInfinity, -kInfinity}};
    for (const Section& section : stack_.sections) {
      for (const Contour& contour : section.contours) {
        for (const Point2& p : contour.vertices) {
          frame_.low = {std::min(frame_.low.x, p.x), std::min(frame_.low.y, p.y)};
          frame_.high = {std::max(frame_.high.x, p.x), std::max(frame_.high.y, p.y)};
        }
      }
    }
  }

  Result<void> check_ends() {
    std::size_t lines = 0;
    std::size_t astray = 0;
    Error error;
    for_each_line([&](SectionId s, ContourId c, const std::vector<Point2>& points) {
      ++lines;
      const auto refuse = [&](std::size_t vertex, const std::string& message) {
        if (astray++ > 0) return;
        error = {ErrorCode::invalid_input, message, {}};
        error.where.section = s.index();
        error.where.contour = c.index();
        if (points.empty()) return;
        error.where.vertex = vertex;
        error.where.point = Point3{points[vertex].x, points[vertex].y, stack_.sections[s].z};
      };
      if (points.size() < 2) return refuse(0, "an open line of less than two vertices");
      for (const std::size_t vertex : {std::size_t{0}, points.size() - 1}) {
        if (position_on(frame_, points[vertex])) continue;
        return refuse(vertex, "an open line ends here, and not on " + text_of(frame_) +
                                  " along which lines are to be closed");
      }
    });
    if (astray == 0) return {};
    if (astray > 1) {
      error.message += " (" + std::to_string(astray) + " of " + std::to_string(lines) +
                       " open lines cannot be closed)";
    }
    return error;
  }

  // A side where no line ends is where some line happens to reach farthest: the frame lies beyond.
  void widen() {
    std::array<bool, 4> met{};
    for_each_line([&](SectionId, ContourId, const std::vector<Point2>& points) {
      for (const Point2& p : {points.front(), points.back()}) {
        met[0] = met[0] || p.y == frame_.low.y;
        met[1] = met[1] || p.x == frame_.high.x;
        met[2] = met[2] || p.y == frame_.high.y;
        met[3] = met[3] || p.x == frame_.low.x;
      }
    });
    const double by =
        std::max(frame_.high.x - frame_.low.x, frame_.high.y - frame_.low.y) / kBeyond;
    if (!met[0]) frame_.low.y -= by;
    if (!met[1]) frame_.high.x += by;
    if (!met[2]) frame_.high.y += by;
    if (!met[3]) frame_.low.x -= by;
    const auto sides = static_cast<std::size_t>(std::count(met.begin(), met.end(), false));
    if (sides == 0 || sides == 4) return;
    changes_.push_back({"no open line ends on " + counted(sides, "side", "sides") +
                            " of the box of all lines: " + (sides == 1 ? "it is" : "they are") +
                            " taken farther out, by " + number_text(by),
                        {}});
  }

  Result<void> take_section(SectionId s) {
    FramedSection section;
    for (const ContourId c : stack_.sections[s].contours.ids()) {
      const Contour& contour = stack_.sections[s].contours[c];
      if (!is_open_[s.index()][c.index()]) {
        section.closed.push_back({contour, c});
        continue;
      }
      if (contour.vertices.front() == contour.vertices.back()) {
        Contour closed = contour;
        closed.vertices.pop_back();
        section.closed.push_back({std::move(closed), c});
        continue;
      }
      OpenLineOnFrame line{contour.vertices, c};
      trim_along(frame_, line.points);
      if (line.points.empty()) {
        ++along_;
        continue;
      }
      for (const bool last : {false, true}) {
        const Point2& p = last ? line.points.back() : line.points.front();
        section.ends.push_back({*position_on(frame_, p), section.lines.size(), last});
      }
      section.lines.push_back(std::move(line));
      ++closed_;
    }
    std::sort(section.ends.begin(), section.ends.end(),
              [](const LineEnd& a, const LineEnd& b) { return a.at < b.at; });
    const auto twice =
        std::adjacent_find(section.ends.begin(), section.ends.end(),
                           [](const LineEnd& a, const LineEnd& b) { return a.at == b.at; });
    if (twice != section.ends.end()) {
      const OpenLineOnFrame& line = section.lines[twice->line];
      const Point2& p = twice->last ? line.points.back() : line.points.front();
      Error error{ErrorCode::invalid_input, "two open lines end in one point of the frame", {}};
      error.where.section = s.index();
      error.where.contour = line.of.index();
      error.where.point = Point3{p.x, p.y, stack_.sections[s].z};
      return error;
    }
    sections_.push_back(std::move(section));
    return {};
  }

  // How many facts speak against two closings of neighbouring sections, [lower][upper].
  using Against = std::array<ByClosing, 2>;

  // Of the arcs between all ends: that the upper section is inside where the lower is outside.
  void count_arcs(const FramedSection& lower, const FramedSection& upper, Against& against) const {
    std::array<ByClosing, 2> arcs{};  // by what the closings 0 are there
    std::size_t l = 0;
    std::size_t u = 0;
    FramePosition at{0, frame_.low.x};
    while (l < lower.ends.size() || u < upper.ends.size()) {
      FramePosition next{4, 0};
      if (l < lower.ends.size()) next = std::min(next, lower.ends[l].at);
      if (u < upper.ends.size()) next = std::min(next, upper.ends[u].at);
      if (at < next) ++arcs[l % 2][u % 2];
      at = next;
      while (l < lower.ends.size() && lower.ends[l].at == at) ++l;
      while (u < upper.ends.size() && upper.ends[u].at == at) ++u;
    }
    ++arcs[l % 2][u % 2];
    for (std::size_t a = 0; a < 2; ++a) {
      for (std::size_t b = 0; b < 2; ++b) against[a][b] += arcs[a][1 - b];
    }
  }

  // Whether closed contours of a section lie inside of another in its closing 0: how many do not
  // and do. Those of which the first vertices lie on a contour tell nothing.
  ByClosing count_inside(const FramedSection& of, const ContourEdges& in) const {
    constexpr std::size_t kTried = 8;
    ByClosing count{};
    for (const FramedContour& contour : of.closed) {
      const std::vector<Point2>& v = contour.contour.vertices;
      for (std::size_t i = 0; i < v.size() && i < kTried; ++i) {
        const ContourEdges::Where where = in.locate(v[i]);
        if (where == ContourEdges::Where::boundary) continue;
        ++count[where == ContourEdges::Where::inside ? 1 : 0];
        break;
      }
    }
    return count;
  }

  std::vector<Against> weigh() const {
    std::vector<ContourEdges> edges;
    for (const FramedSection& section : sections_) {
      const std::vector<FramedContour> contours = closing(section, frame_, false);
      RegionOutline outline;
      for (const FramedContour& contour : contours) outline.contours.push_back(&contour.contour);
      edges.emplace_back(outline);
    }
    std::vector<Against> all;
    for (std::size_t i = 0; i + 1 < sections_.size(); ++i) {
      Against against{};
      count_arcs(sections_[i], sections_[i + 1], against);
      const ByClosing above = count_inside(sections_[i + 1], edges[i]);
      const ByClosing below = count_inside(sections_[i], edges[i + 1]);
      for (std::size_t a = 0; a < 2; ++a) {
        for (std::size_t b = 0; b < 2; ++b) against[a][b] += above[a] + below[1 - b];
      }
      all.push_back(against);
    }
    return all;
  }

  // The closings against which least speaks, altogether; of equal ones the first, from above.
  std::vector<bool> choose() {
    const std::vector<Against> against = weigh();
    const std::size_t n = sections_.size();
    // Least that speaks against what is below, and above, a section, by its closing.
    std::vector<ByClosing> below(n, ByClosing{});
    std::vector<ByClosing> above(n, ByClosing{});
    for (std::size_t i = 1; i < n; ++i) {
      for (std::size_t b = 0; b < 2; ++b) {
        below[i][b] = std::min(below[i - 1][0] + against[i - 1][0][b],
                               below[i - 1][1] + against[i - 1][1][b]);
      }
    }
    for (std::size_t i = n - 1; i-- > 0;) {
      for (std::size_t a = 0; a < 2; ++a) {
        above[i][a] =
            std::min(above[i + 1][0] + against[i][a][0], above[i + 1][1] + against[i][a][1]);
      }
    }
    std::vector<bool> chosen(n, false);
    for (std::size_t i = n; i-- > 0;) {
      const auto total = [&](std::size_t closing) {
        const std::size_t next =
            i + 1 < n ? against[i][closing][chosen[i + 1] ? 1 : 0] : std::size_t{0};
        return below[i][closing] + next;
      };
      chosen[i] = total(1) < total(0);
      if (i + 1 == n) contradictions_ = std::min(total(0), total(1));
      if (below[i][0] + above[i][0] != below[i][1] + above[i][1]) continue;
      if (!sections_[i].ends.empty()) untold_.push_back(i);
    }
    return chosen;
  }

  void tell(std::size_t whole) {
    std::string message =
        counted(closed_, "open line", "open lines") + " closed along " + text_of(frame_);
    if (whole > 0) {
      message +=
          "; " +
          counted(whole, "section without open lines holds", "sections without open lines hold") +
          " all of it but for what contours cut out";
    }
    changes_.push_back({std::move(message), {}});
    if (along_ > 0) {
      changes_.push_back({counted(along_, "open line", "open lines") +
                              " left out, which only run along the rectangle",
                          {}});
    }
    if (!untold_.empty()) {
      Warning warning{"nothing tells on which side of its open lines this section, of " +
                          counted(untold_.size(), "such section", "such sections") +
                          ", is solid: taken is the side away from " + text_of(frame_.low),
                      {}};
      warning.where.section = untold_.back();
      changes_.push_back(std::move(warning));
    }
    if (contradictions_ > 0) {
      changes_.push_back({"these are not level lines of one height: at " +
                              counted(contradictions_, "place", "places") +
                              " a section is solid where the one below it is not, however lines "
                              "are closed",
                          {}});
    }
  }

  // How far beyond all lines a side lies on which none ends: this part of the larger extent.
  static constexpr double kBeyond = 16;

  const SectionStack& stack_;
  const FrameOptions& options_;
  std::vector<std::vector<bool>> is_open_;
  bool stray_ = false;
  Rectangle frame_;
  std::vector<FramedSection> sections_;
  std::vector<Warning> changes_;
  std::vector<std::size_t> untold_;  // sections
  std::size_t closed_ = 0;
  std::size_t along_ = 0;
  std::size_t contradictions_ = 0;
};

}  // namespace

Result<ClosedOnFrame> close_on_frame(const SectionStack& stack,
                                     const std::vector<ContourOfSection>& open,
                                     const FrameOptions& options) {
  return guard_internal([&]() -> Result<ClosedOnFrame> {
    if (!open.empty()) return FrameCloser(stack, open, options).close();
    ClosedOnFrame result;
    result.stack = stack;
    for (const Section& section : stack.sections) {
      IdVector<ContourId, ContourId> same;
      for (const ContourId c : section.contours.ids()) same.push_back(c);
      result.origin.push_back(std::move(same));
    }
    return result;
  });
}

}  // namespace tetloft

#include "report/plot.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>

#include "report/markup.hpp"

namespace tetloft::internal::report {

namespace {

// Of the drawing, in its own units; letters are 12 high.
constexpr double kRight = 14;
constexpr double kTop = 12;
constexpr double kFloor = kPlotHeight - 46;  // of the plot
constexpr double kMiddle = (kTop + kFloor) / 2;
constexpr std::size_t kTicksAcross = 6;
constexpr std::size_t kTicksUp = 5;

// The axes, and where values stand in the drawing.
class PlotFrame {
 public:
  PlotFrame(Axis x, Axis y) : x_(std::move(x)), y_(std::move(y)) {
    std::size_t longest = 0;
    for (const Tick& tick : y_.ticks()) longest = std::max(longest, letters(tick.label));
    left_ = kLeast + kLetter * static_cast<double>(longest);
  }
  [[nodiscard]] double left() const { return left_; }
  [[nodiscard]] double across(double value) const {
    return left_ + x_.position(value) * (kPlotWidth - kRight - left_);
  }
  [[nodiscard]] double up(double value) const {
    return kFloor - y_.position(value) * (kFloor - kTop);
  }
  [[nodiscard]] double middle() const { return (left_ + kPlotWidth - kRight) / 2; }
  [[nodiscard]] const Axis& x() const { return x_; }
  [[nodiscard]] const Axis& y() const { return y_; }

 private:
  static constexpr double kLeast = 32;  // for the name of the axis
  static constexpr double kLetter = 7;

  // Of UTF-8: bytes that begin one.
  static std::size_t letters(const std::string& text) {
    return static_cast<std::size_t>(
        std::count_if(text.begin(), text.end(), [](char c) { return (c & 0xC0) != 0x80; }));
  }

  Axis x_, y_;
  double left_ = 0;
};

void append_pair(std::string& out, const char* name_x, double x, const char* name_y, double y) {
  out += std::string(" ") + name_x + "=\"";
  append_coordinate(out, x);
  out += std::string("\" ") + name_y + "=\"";
  append_coordinate(out, y);
  out += '"';
}

void append_line(std::string& out, double x1, double y1, double x2, double y2, const char* css) {
  out += "<line class=\"" + std::string(css) + '"';
  append_pair(out, "x1", x1, "y1", y1);
  append_pair(out, "x2", x2, "y2", y2);
  out += "/>";
}

void append_text(std::string& out, double x, double y, const char* anchor, const std::string& text,
                 const char* more = "") {
  out += "<text";
  append_pair(out, "x", x, "y", y);
  out += " text-anchor=\"" + std::string(anchor) + "\"" + more + ">" + escaped(text) + "</text>";
}

std::string opened(const PlotLabels& labels) {
  std::string out = "<svg class=\"plot\" role=\"img\" viewBox=\"0 0 ";
  append_coordinate(out, kPlotWidth);
  out += ' ';
  append_coordinate(out, kPlotHeight);
  return out + "\"><title>" + escaped(labels.title) + "</title>";
}

// Grid and numbers; bars and lines go above.
void append_axes(std::string& out, const PlotFrame& frame, const PlotLabels& labels) {
  for (const Tick& tick : frame.y().ticks()) {
    const double at = frame.up(tick.value);
    append_line(out, frame.left(), at, kPlotWidth - kRight, at, "grid");
    append_text(out, frame.left() - 7, at + 4, "end", tick.label);
  }
  for (const Tick& tick : frame.x().ticks()) {
    const double at = frame.across(tick.value);
    append_line(out, at, kFloor, at, kFloor + 4, "axis");
    append_text(out, at, kFloor + 17, "middle", tick.label);
  }
  append_line(out, frame.left(), kFloor, kPlotWidth - kRight, kFloor, "axis");
  append_text(out, frame.middle(), kPlotHeight - 8, "middle", labels.x, " class=\"label\"");
  std::string turned = " class=\"label\" transform=\"rotate(-90 14 ";
  append_coordinate(turned, kMiddle);
  append_text(out, 14, kMiddle, "middle", labels.y, (turned + ")\"").c_str());
}

std::string empty_plot(const PlotLabels& labels) {
  std::string out = opened(labels);
  append_line(out, kRight, kFloor, kPlotWidth - kRight, kFloor, "axis");
  append_text(out, kPlotWidth / 2, kMiddle, "middle", "nothing to show", " class=\"label\"");
  return out + "</svg>";
}

struct Range {
  double low = std::numeric_limits<double>::infinity();
  double high = -low;
  void include(double value) {
    low = std::min(low, value);
    high = std::max(high, value);
  }
  [[nodiscard]] bool empty() const { return !(low <= high); }
};

bool has_place(double value, Scale scale) {
  return std::isfinite(value) && (scale == Scale::linear || value > 0);
}

// Those of the curve's points that have a place.
std::vector<Point2> shown(const Curve& curve, const PlotScales& scales) {
  std::vector<Point2> points;
  for (const Point2& p : curve.points) {
    if (has_place(p.x, scales.x) && has_place(p.y, scales.y)) points.push_back(p);
  }
  return points;
}

void append_curve(std::string& out, const Curve& curve, const PlotScales& scales,
                  const PlotFrame& frame) {
  std::string path;
  for (const Point2& p : shown(curve, scales)) {
    const double at = frame.across(p.x);
    const double height = frame.up(p.y);
    if (curve.dots) {
      out += "<circle class=\"" + std::string(curve.css_class) + '"';
      append_pair(out, "cx", at, "cy", height);
      out += " r=\"2.2\"/>";
      continue;
    }
    path += path.empty() ? 'M' : 'L';
    append_coordinate(path, at);
    path += ' ';
    append_coordinate(path, height);
  }
  if (path.empty()) return;
  out += "<path class=\"" + std::string(curve.css_class) + "\" d=\"" + path + "\"/>";
}

}  // namespace

std::string histogram_svg(const ReportHistogram& histogram, Scale scale, const PlotLabels& labels) {
  const auto& counts = histogram.counts;
  if (counts.empty() || histogram.edges.size() != counts.size() + 1) return empty_plot(labels);
  const std::size_t most = *std::max_element(counts.begin(), counts.end());
  if (most == 0) return empty_plot(labels);
  const PlotFrame frame(
      Axis(histogram.edges.front(), histogram.edges.back(), scale, kTicksAcross, false),
      Axis(0, static_cast<double>(most), Scale::linear, kTicksUp, true));
  std::string out = opened(labels);
  append_axes(out, frame, labels);
  for (std::size_t k = 0; k < counts.size(); ++k) {
    if (counts[k] == 0) continue;
    const double left = frame.across(histogram.edges[k]);
    const double right = frame.across(histogram.edges[k + 1]);
    // What is there is seen, however little it is.
    const double height = std::max(0.7, kFloor - frame.up(static_cast<double>(counts[k])));
    out += "<rect class=\"bar\"";
    append_pair(out, "x", left, "y", kFloor - height);
    append_pair(out, "width", std::max(0.5, right - left - 0.8), "height", height);
    out += "/>";
  }
  return out + "</svg>";
}

std::string line_plot_svg(std::span<const Curve> curves, const PlotLabels& labels,
                          const PlotScales& scales) {
  Range across_range, up_range;
  for (const Curve& curve : curves) {
    for (const Point2& p : shown(curve, scales)) {
      across_range.include(p.x);
      up_range.include(p.y);
    }
  }
  if (across_range.empty()) return empty_plot(labels);
  if (scales.y == Scale::linear) up_range.include(0);
  const PlotFrame frame(
      Axis(across_range.low, across_range.high, scales.x, kTicksAcross, false),
      Axis(up_range.low, up_range.high, scales.y, kTicksUp, scales.y == Scale::linear));
  std::string out = opened(labels);
  append_axes(out, frame, labels);
  for (const Curve& curve : curves) append_curve(out, curve, scales, frame);
  return out + "</svg>";
}

}  // namespace tetloft::internal::report

#include "report/panels.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <span>
#include <utility>

#include "io/numbers.hpp"
#include "render/palette.hpp"
#include "report/axis.hpp"
#include "report/cuts.hpp"
#include "report/markup.hpp"
#include "report/scale_bar.hpp"

namespace tetloft::internal::report {

namespace {

// Drawings are so wide or high in their own units, tenths of what is a pixel at their usual size.
constexpr double kSide = 2400;
constexpr double kMargin = 90;
constexpr double kBarRoom = 260;
// Vertices nearer than this to the one before are left out.
constexpr double kFinest = 5;
// Within this long holds the difference of two, and a browser's floats are right to a unit.
constexpr double kFarthest = 1e7;

// The same for all drawings.
class Sheet {
 public:
  explicit Sheet(const Subject& subject) : low_(subject.low), high_(subject.high) {
    if (subject.stack != nullptr) {
      for (const Section& section : subject.stack->sections) {
        for (const Contour& contour : section.contours) include(contour.vertices);
      }
    }
    const double across = high_.x - low_.x;
    const double along = high_.y - low_.y;
    const double side = std::max(across, along);
    scale_ = side > 0 && std::isfinite(side) ? kSide / side : 1;
    // Needles have room, too.
    width_ = std::max(across * scale_, kSide / 4) + 2 * kMargin;
    height_ = std::max(along * scale_, kSide / 8) + 2 * kMargin;
  }

  [[nodiscard]] Point2 at(const Point2& p) const {
    return {kMargin + (p.x - low_.x) * scale_, height_ - kMargin - (p.y - low_.y) * scale_};
  }
  [[nodiscard]] double scale() const { return scale_; }
  [[nodiscard]] double width() const { return width_; }
  [[nodiscard]] double height() const { return height_; }

 private:
  void include(std::span<const Point2> points) {
    for (const Point2& p : points) {
      low_.x = std::min(low_.x, p.x);
      low_.y = std::min(low_.y, p.y);
      high_.x = std::max(high_.x, p.x);
      high_.y = std::max(high_.y, p.y);
    }
  }

  Point3 low_, high_;
  double scale_ = 1, width_ = 0, height_ = 0;
};

// A closed path in whole units, each step from the one before: short, and the same at any origin.
void append_loop(std::string& path, std::span<const Point2> points, const Sheet& sheet) {
  long x = 0, y = 0;
  Point2 last{};
  bool begun = false;
  for (const Point2& p : points) {
    const Point2 q = sheet.at(p);
    // Beyond what can be drawn at all: of coordinates whose differences are no doubles.
    if (!(std::abs(q.x) < kFarthest && std::abs(q.y) < kFarthest)) continue;
    if (begun && std::hypot(q.x - last.x, q.y - last.y) < kFinest) continue;
    const long to_x = std::lround(q.x);
    const long to_y = std::lround(q.y);
    path += begun ? 'l' : 'M';
    io::append_number(path, begun ? to_x - x : to_x);
    path += ' ';
    io::append_number(path, begun ? to_y - y : to_y);
    x = to_x;
    y = to_y;
    last = q;
    begun = true;
  }
  if (begun) path += 'z';
}

std::string path_of(const Section& section, const Sheet& sheet) {
  std::string path;
  for (const Contour& contour : section.contours) append_loop(path, contour.vertices, sheet);
  return path;
}

// `attributes` as they stand in the tag; nothing of an empty path.
std::string path_element(const std::string& path, const std::string& attributes) {
  return path.empty() ? "" : "<path " + attributes + " d=\"" + path + "\"/>";
}

std::string solid_paths(const Subject& subject, const CutHeight& height, const Sheet& sheet,
                        bool outlined) {
  std::map<std::uint32_t, std::string> by_component;
  for (const CutLoop& loop : cut_loops(subject, height)) {
    append_loop(by_component[loop.component], loop.points, sheet);
  }
  std::string out;
  std::string all;
  for (const auto& [component, path] : by_component) {
    out += path_element(path, "class=\"area\" fill-rule=\"evenodd\" fill=\"" +
                                  render::hex(render::component_colour(component)) + '"');
    if (outlined) all += path;
  }
  return out + path_element(all, "class=\"outline\"");
}

struct Panel {
  std::string caption;
  CutHeight height;
  std::vector<std::pair<const Section*, const char*>> contours;  // and their class
};

std::string panel_svg(const Subject& subject, const Sheet& sheet, const Panel& panel) {
  std::string out = "<figure class=\"panel\"><svg viewBox=\"0 0 ";
  append_coordinate(out, sheet.width(), 0);
  out += ' ';
  append_coordinate(out, sheet.height(), 0);
  out += "\" role=\"img\"><title>" + panel.caption + "</title>";
  out += solid_paths(subject, panel.height, sheet, subject.stack == nullptr);
  for (const auto& [section, css] : panel.contours) {
    out += path_element(path_of(*section, sheet), std::string("class=\"") + css + '"');
  }
  return out + "</svg>" + element("figcaption", panel.caption) + "</figure>";
}

class Panels {
 public:
  explicit Panels(const Subject& subject)
      : subject_(subject), unit_(subject.about.unit), sheet_(subject) {}

  std::string sections(const std::vector<std::size_t>& shown) {
    std::vector<Panel> panels;
    for (const std::size_t s : shown) {
      const double z = subject_.planes[s];
      Panel panel{"section " + count_text(s) + ": z = " + with_unit(z, unit_, 1),
                  {z, z <= subject_.low.z},
                  {}};
      if (subject_.stack != nullptr) {
        panel.contours = {{&subject_.stack->sections[SectionId(s)], "contour"}};
      }
      panels.push_back(std::move(panel));
    }
    return grid(panels);
  }

  std::string middles(const std::vector<std::size_t>& shown) {
    std::vector<Panel> panels;
    for (const std::size_t s : shown) {
      if (s + 1 >= subject_.planes.size()) continue;
      const double z = subject_.planes[s] / 2 + subject_.planes[s + 1] / 2;
      Panel panel{count_text(s) + "–" + count_text(s + 1) + ": z = " + with_unit(z, unit_, 1),
                  {z, false},
                  {}};
      if (subject_.stack != nullptr) {
        panel.contours = {{&subject_.stack->sections[SectionId(s)], "below"},
                          {&subject_.stack->sections[SectionId(s + 1)], "above"}};
      }
      panels.push_back(std::move(panel));
    }
    return grid(panels);
  }

  std::string even_cuts(std::size_t shown) {
    std::vector<Panel> panels;
    for (std::size_t k = 0; k < shown; ++k) {
      const double part = (static_cast<double>(k) + 0.5) / static_cast<double>(shown);
      const double z = (1 - part) * subject_.low.z + part * subject_.high.z;
      panels.push_back({"z = " + with_unit(z, unit_, 1), {z, false}, {}});
    }
    return grid(panels);
  }

 private:
  std::string grid(const std::vector<Panel>& panels) {
    std::string out = "<div class=\"panels\">";
    for (const Panel& panel : panels) out += panel_svg(subject_, sheet_, panel);
    if (subject_.is_rigid) out += bar();
    return out + "</div>";
  }

  // One for all, as a drawing of the same scale.
  [[nodiscard]] std::string bar() const {
    std::string out = "<figure class=\"panel bar-panel\"><svg viewBox=\"0 0 ";
    append_coordinate(out, sheet_.width(), 0);
    out += ' ';
    append_coordinate(out, kBarRoom, 0);
    out += "\" role=\"img\"><title>scale</title>";
    out += scale_bar({kMargin, kBarRoom - 40}, sheet_.width() / 2, sheet_.scale(), unit_, 10);
    return out + "</svg></figure>";
  }

  const Subject& subject_;
  const std::string& unit_;
  Sheet sheet_;
};

// Who compares with the file must know what z is.
std::string turned_note(const Frame& frame) {
  if (frame == Frame{}) return {};
  const Point3& up = frame.axes[2];
  return element("p", "The planes of the file are turned: z is the height along its direction (" +
                          number_text(up.x, 3) + ", " + number_text(up.y, 3) + ", " +
                          number_text(up.z, 3) + "), and the drawings lie in the planes.");
}

}  // namespace

std::vector<std::size_t> evenly(std::size_t count, std::size_t shown) {
  std::vector<std::size_t> positions;
  const std::size_t n = std::min(count, shown);
  for (std::size_t k = 0; k < n; ++k) {
    positions.push_back(n == 1 ? 0 : (k * (count - 1) + (n - 1) / 2) / (n - 1));
  }
  return positions;
}

std::string section_panels(const Subject& subject, std::size_t shown) {
  Panels panels(subject);
  if (subject.planes.empty()) {
    return element("p", "The model does not tell its sections: it is cut at even heights.") +
           panels.even_cuts(shown);
  }
  const std::vector<std::size_t> positions = evenly(subject.planes.size(), shown);
  const bool given = subject.stack != nullptr;
  std::string out = element(
      "p", given ? "In the sections: the input contours (lines) over the cut solid (areas). Both "
                   "agree where the solid fills its sections."
                 : "In the sections: the cut solid and its outlines. No stack was given.");
  out += turned_note(subject.model.frame);
  out += panels.sections(positions);
  if (subject.planes.size() < 2) return out;
  out += element("p", given ? "Half way to the next section, where the shape is inferred: the cut "
                              "solid, with the contours of the section below (dashed) and above "
                              "(solid line)."
                            : "Half way to the next section, where the shape is inferred.");
  return out + panels.middles(positions);
}

}  // namespace tetloft::internal::report

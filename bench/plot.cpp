#include "plot.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

#include "report/markup.hpp"
#include "report/plot.hpp"

namespace tetloft::bench {

namespace {

using internal::report::Curve;
using internal::report::escaped;
using internal::report::kPlotHeight;
using internal::report::kPlotWidth;
using internal::report::line_plot_svg;
using internal::report::PlotLabels;
using internal::report::PlotScales;
using internal::report::Scale;

// Of the picture, in pixels; a plot is as large as in its own units.
constexpr int kColumns = 3;
constexpr int kTitle = 26;
constexpr int kLegend = 40;

// Okabe and Ito's colours, told apart by everybody.
struct Style {
  const char* line;
  const char* dots;
  const char* colour;
};
constexpr std::array<Style, 7> kStyles{{{"e0", "d0", "#d55e00"},
                                        {"e1", "d1", "#0072b2"},
                                        {"e2", "d2", "#009e73"},
                                        {"e3", "d3", "#cc79a7"},
                                        {"e4", "d4", "#56b4e9"},
                                        {"e5", "d5", "#e69f00"},
                                        {"e6", "d6", "#000000"}}};

using Names = std::vector<std::string>;

void add_name(const std::string& name, Names& names) {
  if (!name.empty() && std::find(names.begin(), names.end(), name) == names.end()) {
    names.push_back(name);
  }
}

std::vector<const Measurement*> valid_of(const CaseReport& one) {
  std::vector<const Measurement*> all;
  for (const auto* side : {&one.own, &one.peers}) {
    for (const Measurement& m : *side) {
      if (m.valid()) all.push_back(&m);
    }
  }
  return all;
}

// The cases of one distribution, by size.
std::vector<const CaseReport*> cases_of(const Report& report, const std::string& distribution) {
  std::vector<const CaseReport*> cases;
  for (const CaseReport& one : report.cases) {
    if (one.distribution == distribution) cases.push_back(&one);
  }
  std::stable_sort(cases.begin(), cases.end(),
                   [](const CaseReport* a, const CaseReport* b) { return a->points < b->points; });
  return cases;
}

// By size, on one thread.
template <class Value>
std::vector<Point2> by_size(const std::vector<const CaseReport*>& cases, const std::string& engine,
                            Value value) {
  std::vector<Point2> points;
  for (const CaseReport* one : cases) {
    for (const Measurement* m : valid_of(*one)) {
      if (m->engine != engine || m->threads != 1) continue;
      points.push_back({static_cast<double>(one->points), value(*m)});
    }
  }
  return points;
}

// Against the same engine on one thread, by threads.
std::vector<Point2> speed_up(const CaseReport& one, const std::string& engine) {
  double alone = 0;
  std::vector<Point2> points;
  for (const Measurement* m : valid_of(one)) {
    if (m->engine != engine) continue;
    if (m->threads == 1) alone = m->best();
    if (alone > 0) points.push_back({static_cast<double>(m->threads), alone / m->best()});
  }
  return points.size() > 1 ? points : std::vector<Point2>{};
}

template <class PointsOf>
std::string plotted(const Names& engines, const PlotLabels& labels, const PlotScales& scales,
                    PointsOf points_of) {
  std::vector<Curve> curves;
  for (std::size_t k = 0; k < engines.size(); ++k) {
    const Style& style = kStyles[k % kStyles.size()];
    const std::vector<Point2> points = points_of(engines[k]);
    curves.push_back({points, style.line, false});
    curves.push_back({points, style.dots, true});
  }
  return line_plot_svg(curves, labels, scales);
}

std::string placed(int column, int top, const std::string& plot) {
  return "<svg x=\"" + std::to_string(column * kPlotWidth) + "\" y=\"" + std::to_string(top) +
         "\" width=\"" + std::to_string(kPlotWidth) + "\" height=\"" + std::to_string(kPlotHeight) +
         "\">" + plot + "</svg>\n";
}

std::string text_at(int x, int y, const std::string& more, const std::string& text) {
  return "<text x=\"" + std::to_string(x) + "\" y=\"" + std::to_string(y) + "\"" + more + ">" +
         escaped(text) + "</text>\n";
}

std::string legend(const Names& engines) {
  std::string out;
  for (std::size_t k = 0; k < engines.size(); ++k) {
    const std::string colour = kStyles[k % kStyles.size()].colour;
    out += text_at(20 + 140 * static_cast<int>(k), 24,
                   " class=\"engine\" style=\"fill: " + colour + "\"", engines[k]);
  }
  return out;
}

std::string row(const std::string& distribution, const std::vector<const CaseReport*>& cases,
                const Names& engines, int top) {
  const PlotScales by_points{Scale::logarithmic, Scale::logarithmic};
  std::string out = text_at(20, top + 18, " class=\"name\"", distribution);
  top += kTitle;
  out +=
      placed(0, top,
             plotted(engines, {distribution + ": time by points", "points", "seconds"}, by_points,
                     [&](const std::string& engine) {
                       return by_size(cases, engine, [](const Measurement& m) { return m.best(); });
                     }));
  out += placed(1, top,
                plotted(engines, {distribution + ": memory by points", "points", "MB"}, by_points,
                        [&](const std::string& engine) {
                          return by_size(cases, engine,
                                         [](const Measurement& m) { return m.peak_megabytes; });
                        }));
  out +=
      placed(2, top,
             plotted(engines, {distribution + ": speed-up by threads", "threads", "speed-up"}, {},
                     [&](const std::string& engine) { return speed_up(*cases.back(), engine); }));
  return out;
}

std::string style() {
  std::string out =
      "<style>text { font: 12px sans-serif; fill: #555 } .label { fill: #222 } .name { font-size: "
      "15px; fill: #222 } .engine { font-size: 14px; font-weight: bold }\n"
      ".plot { overflow: visible } .grid { stroke: #ddd } .axis { stroke: #888 }\n";
  for (const Style& one : kStyles) {
    out += std::string(".") + one.line + " { fill: none; stroke: " + one.colour +
           "; stroke-width: 1.7; stroke-linejoin: round } ." + one.dots + " { fill: " + one.colour +
           " }\n";
  }
  return out + "</style>\n";
}

}  // namespace

std::string plot_of(const Report& report) {
  Names distributions, engines;
  for (const CaseReport& one : report.cases) {
    add_name(one.distribution, distributions);
    if (one.distribution.empty()) continue;
    for (const Measurement* m : valid_of(one)) add_name(m->engine, engines);
  }
  const int width = kColumns * kPlotWidth;
  std::string rows;
  int top = kLegend;
  for (const std::string& name : distributions) {
    rows += row(name, cases_of(report, name), engines, top);
    top += kTitle + kPlotHeight;
  }
  if (distributions.empty()) {
    rows = text_at(20, top, "", "no case by distribution was run");
    top += kTitle;
  }
  const std::string size = std::to_string(width) + " " + std::to_string(top);
  return "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"" + std::to_string(width) +
         "\" height=\"" + std::to_string(top) + "\" viewBox=\"0 0 " + size + "\">\n" + style() +
         "<rect width=\"100%\" height=\"100%\" fill=\"#fff\"/>\n" + legend(engines) + rows +
         "</svg>\n";
}

}  // namespace tetloft::bench

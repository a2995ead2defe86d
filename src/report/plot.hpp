// Small plots as <svg> elements. Colours are the page's: by classes, and currentColor.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <tetloft/point.hpp>
#include <tetloft/report_page.hpp>

#include "report/axis.hpp"

namespace tetloft::internal::report {

/// Of every plot, in its own units.
inline constexpr int kPlotWidth = 420;
inline constexpr int kPlotHeight = 236;

/// Plain texts.
struct PlotLabels {
  std::string title;  ///< for those who do not see it
  std::string x;
  std::string y;
};

/// Bars from edge to edge; of no counts a frame that says so.
[[nodiscard]] std::string histogram_svg(const ReportHistogram& histogram, Scale scale,
                                        const PlotLabels& labels);

struct Curve {
  std::vector<Point2> points;
  std::string_view css_class;
  bool dots = false;  ///< of single points, else a line through all
};

struct PlotScales {
  Scale x = Scale::linear;
  Scale y = Scale::linear;
};

/// A linear y is from 0, or from the least value where that is negative. Points that are not
/// finite, or not positive where the scale is logarithmic, are left out.
[[nodiscard]] std::string line_plot_svg(std::span<const Curve> curves, const PlotLabels& labels,
                                        const PlotScales& scales = {});

}  // namespace tetloft::internal::report

#include "report/scale_bar.hpp"

#include <cmath>

#include "report/axis.hpp"
#include "report/markup.hpp"

namespace tetloft::internal::report {

std::string scale_bar(const Point2& at, double room, double scale, std::string_view unit,
                      double pixel) {
  if (!(scale > 0) || !std::isfinite(scale) || !std::isfinite(room / scale) ||
      !(room / scale > 0)) {
    return "";
  }
  const double length = round_down(room / scale);
  std::string out = "<g class=\"scale\"><path d=\"M";
  append_coordinate(out, at.x);
  out += ' ';
  append_coordinate(out, at.y - 4 * pixel);
  out += 'v';
  append_coordinate(out, 4 * pixel);
  out += 'h';
  append_coordinate(out, length * scale);
  out += 'v';
  append_coordinate(out, -4 * pixel);
  out += "\" stroke-width=\"";
  append_coordinate(out, 1.6 * pixel);
  out += "\"/><text x=\"";
  append_coordinate(out, at.x + 4 * pixel);
  out += "\" y=\"";
  append_coordinate(out, at.y - 6 * pixel);
  out += "\" font-size=\"";
  append_coordinate(out, 13 * pixel);
  return out + "\">" + with_unit(length, unit, 1) + "</text></g>";
}

}  // namespace tetloft::internal::report

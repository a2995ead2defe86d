#include "report/markup.hpp"

#include <cmath>

#include "core/text.hpp"
#include "io/numbers.hpp"
#include "report/axis.hpp"

namespace tetloft::internal::report {

std::string escaped(std::string_view text) {
  const std::string valid = valid_utf8(text);
  std::string out;
  for (std::size_t at = 0; at < valid.size();) {
    const TextUnit unit = first_unit(std::string_view(valid).substr(at));
    const char c = valid[at];
    if (c == '<') {
      out += "&lt;";
    } else if (c == '>') {
      out += "&gt;";
    } else if (c == '&') {
      out += "&amp;";
    } else if (c == '"') {
      out += "&quot;";
    } else if (c == '\'') {
      out += "&#39;";
    } else if (c != '\n' && c != '\t' && misleads(unit.code)) {
      out += "\xEF\xBF\xBD";
    } else {
      out.append(valid, at, unit.length);
    }
    at += unit.length;
  }
  return out;
}

std::string count_text(std::size_t count) {
  std::string text = std::to_string(count);
  group_thousands(text, text.size());
  return text;
}

std::string counted_text(std::size_t count, std::string_view singular) {
  return count_text(count) + ' ' + std::string(singular) + (count == 1 ? "" : "s");
}

std::string unit_text(std::string_view unit, int power) {
  if (unit.empty()) return "";
  return escaped(unit) + (power == 2 ? "²" : power == 3 ? "³" : "");
}

std::string with_unit(double value, std::string_view unit, int power) {
  const std::string name = unit_text(unit, power);
  return number_text(value) + (name.empty() ? "" : "\xC2\xA0" + name);  // U+00A0
}

void append_coordinate(std::string& out, double value, int decimals) {
  const double unit = decimals == 0 ? 1 : decimals == 1 ? 10 : 100;
  const double rounded = std::round(value * unit) / unit;
  io::append_number(out, rounded == 0 ? 0.0 : rounded);
}

std::string element(std::string_view tag, std::string_view content, std::string_view attributes) {
  std::string text = "<";
  text += tag;
  if (!attributes.empty()) {
    text += ' ';
    text += attributes;
  }
  text += '>';
  text += content;
  text += "</";
  text += tag;
  text += '>';
  return text;
}

}  // namespace tetloft::internal::report

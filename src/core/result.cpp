// Texts of errors, warnings and places.
#include <tetloft/result.hpp>

#include <cstdio>

#include "core/text.hpp"

namespace tetloft {

using namespace internal;

const char* name_of(ErrorCode code) {
  switch (code) {
    case ErrorCode::usage: return "usage";
    case ErrorCode::invalid_input: return "invalid_input";
    case ErrorCode::io: return "io";
    case ErrorCode::unrepresentable: return "unrepresentable";
    case ErrorCode::cancelled: return "cancelled";
    case ErrorCode::work_limit: return "work_limit";
    case ErrorCode::internal: return "internal";
    case ErrorCode::out_of_memory: return "out_of_memory";
    case ErrorCode::unfit_arithmetic: return "unfit_arithmetic";
  }
  return "internal";
}

namespace {

// Digits enough to read back exactly.
std::string digits(double value) {
  char buffer[40];
  std::snprintf(buffer, sizeof buffer, "%.17g", value);
  return buffer;
}

void append_part(std::string& text, const char* name, const std::optional<std::size_t>& index) {
  if (!index) return;
  if (!text.empty()) text += text.back() == ':' ? " " : ", ";
  text += name;
  text += ' ';
  text += std::to_string(*index);
}

std::string with_place(const Place& where, const std::string& message) {
  const std::string place = to_string(where);
  const std::string shown = printable(message);
  if (place.empty()) return shown;
  return place.back() == ':' ? place + ' ' + shown : place + ": " + shown;
}

}  // namespace

std::string to_string(const Place& place) {
  std::string text = printable(place.file);
  if (place.line) text += (text.empty() ? "line " : ":") + std::to_string(*place.line);
  if (!text.empty()) text += ':';
  append_part(text, "section", place.section);
  append_part(text, "slab", place.slab);
  append_part(text, "contour", place.contour);
  append_part(text, "vertex", place.vertex);
  if (place.point) {
    if (!text.empty()) text += ' ';
    text += '(' + digits(place.point->x) + ", " + digits(place.point->y) + ", " +
            digits(place.point->z) + ')';
  }
  return text;
}

std::string to_string(const Error& error) { return with_place(error.where, error.message); }

std::string to_string(const Warning& warning) { return with_place(warning.where, warning.message); }

}  // namespace tetloft

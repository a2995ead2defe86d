// Messages and their JSON.
#include "cli/console.hpp"

#include <cstdio>

namespace tetloft::cli {

void Console::print(const std::string& text) const {
  std::fwrite(text.data(), 1, text.size(), stdout);
  if (text.empty() || text.back() != '\n') std::fputc('\n', stdout);
}

void Console::say(const std::string& text) const {
  const std::string line = "tetloft: " + text + '\n';
  std::fwrite(line.data(), 1, line.size(), stderr);
}

void Console::warn(const Warning& warning) {
  say("warning: " + to_string(warning));
  warnings_.push_back(warning);
}

int Console::fail(const Error& error) const {
  say("error: " + to_string(error));
  if (json_) {
    JsonWriter json;
    json.begin_object();
    json.key("error");
    json.begin_object();
    json.member("code", name_of(error.code));
    json.member("message", error.message);
    json.key("where");
    write_place(json, error.where);
    json.end_object();
    json.end_object();
    print(json.text());
  }
  return static_cast<int>(error.code);
}

void write_place(JsonWriter& json, const Place& place) {
  json.begin_object();
  if (!place.file.empty()) json.member("file", place.file);
  if (place.line) json.member("line", *place.line);
  if (place.section) json.member("section", *place.section);
  if (place.slab) json.member("slab", *place.slab);
  if (place.contour) json.member("contour", *place.contour);
  if (place.vertex) json.member("vertex", *place.vertex);
  if (place.point) {
    json.key("point");
    json.begin_array();
    for (const double c : {place.point->x, place.point->y, place.point->z}) json.value(c);
    json.end_array();
  }
  json.end_object();
}

void write_warnings(JsonWriter& json, const std::vector<Warning>& warnings) {
  json.key("warnings");
  json.begin_array();
  for (const Warning& warning : warnings) {
    json.begin_object();
    json.member("message", warning.message);
    json.key("where");
    write_place(json, warning.where);
    json.end_object();
  }
  json.end_array();
}

std::string readable(double value) {
  char buffer[40];
  std::snprintf(buffer, sizeof buffer, "%.6g", value);
  return buffer;
}

std::string readable_seconds(double seconds) {
  char buffer[40];
  std::snprintf(buffer, sizeof buffer, "%.3f", seconds);
  return buffer;
}

std::string counted(std::size_t n, const char* singular) {
  return std::to_string(n) + ' ' + singular + (n == 1 ? "" : "s");
}

}  // namespace tetloft::cli

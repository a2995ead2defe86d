// Messages and their JSON.
#include "cli/console.hpp"

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdio>
#include <system_error>

#include "core/text.hpp"
#include "io/numbers.hpp"

namespace tetloft::cli {

using namespace internal;

namespace {

// Lines as they are, and nothing in them that misleads.
std::string shown(std::string_view text) {
  std::string lines;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    lines += printable(text.substr(0, end)) + '\n';
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return lines;
}

// All of it with the system: a full disk shows when the buffer is emptied.
Result<void> reach_reader(const std::string& text) {
  errno = 0;
  const bool written = std::fwrite(text.data(), 1, text.size(), stdout) == text.size();
  if (written && std::fflush(stdout) == 0) return {};
  const std::string reason = errno == 0 ? "" : ": " + std::generic_category().message(errno);
  return Error{ErrorCode::io, "standard output cannot be written" + reason, {}};
}

}  // namespace

Result<void> Console::deliver(const std::string& text) {
  tell_rest();
  delivered_ = true;
  return reach_reader(shown(text));
}

void Console::say(const std::string& text) const {
  if (!shows_) return;
  const std::string line = "tetloft: " + printable(text) + '\n';
  std::fwrite(line.data(), 1, line.size(), stderr);
}

void Console::warn(const Warning& warning) {
  constexpr std::size_t kFew = 3;
  Kind& kind = kinds_[kind_of(warning.message)];
  if (kind.printed < kFew) {
    if (kind.printed == 0) kind.first = warning.message;
    ++kind.printed;
    say("warning: " + to_string(warning));
  } else {
    ++kind.unprinted;
  }
  warnings_.push_back(warning);
}

void Console::tell_rest() {
  for (auto& [key, kind] : kinds_) {
    if (kind.unprinted == 0) continue;
    say("warning: … and " + std::to_string(kind.unprinted) + " more of this kind: " + kind.first +
        (json_ ? "" : " (--json lists all)"));
    kind.unprinted = 0;
  }
}

int Console::fail(const Error& error) {
  tell_rest();
  say("error: " + to_string(error));
  const int code = static_cast<int>(error.code);
  if (!json_ || delivered_) return code;
  JsonWriter json;
  json.begin_object();
  write_error(json, error);
  json.end_object();
  const Result<void> told = deliver(json.text());
  if (!told) say("error: " + to_string(told.error()));
  return code;
}

std::string kind_of(std::string_view message) {
  std::string kind;
  bool quoted = false;
  for (const char c : message) {
    if (c == '\'') quoted = !quoted;
    const bool number = (c >= '0' && c <= '9') || c == '.' || c == '-' || c == '+';
    if (number && !kind.empty() && kind.back() == '#') continue;
    if (!quoted) kind += number ? '#' : c;
  }
  return kind;
}

void write_error(JsonWriter& json, const Error& error) {
  json.key("error");
  json.begin_object();
  json.member("code", name_of(error.code));
  json.member("message", error.message);
  json.key("where");
  write_place(json, error.where);
  json.end_object();
}

void write_place(JsonWriter& json, const Place& place) {
  json.begin_object();
  if (!place.file.empty()) json.member("file", place.file);
  if (place.line) json.member("line", *place.line);
  if (place.section) json.member("section", *place.section);
  if (place.slab) json.member("slab", *place.slab);
  if (place.contour) json.member("contour", *place.contour);
  if (place.vertex) json.member("vertex", *place.vertex);
  if (place.point) json.member("point", std::array{place.point->x, place.point->y, place.point->z});
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

std::string exact(double value) {
  std::string text;
  io::append_number(text, value);
  return text;
}

std::string in_hex(std::uint64_t number) {
  constexpr std::string_view kDigits = "0123456789abcdef";
  std::string text(16, '0');
  for (std::size_t k = 0; k < text.size(); ++k) text[15 - k] = kDigits[number >> (4 * k) & 15U];
  return text;
}

std::string readable_seconds(double seconds) {
  char buffer[40];
  std::snprintf(buffer, sizeof buffer, "%.3f", seconds);
  return buffer;
}

std::string counted(std::size_t n, const char* singular) {
  return std::to_string(n) + ' ' + singular + (n == 1 ? "" : "s");
}

void Console::warn_of(const std::string& file, const std::vector<Warning>& warnings) {
  for (Warning warning : warnings) {
    if (warning.where.file.empty()) warning.where.file = file;
    warn(warning);
  }
}

Error in_file(Error error, const std::string& file) {
  if (error.where.file.empty()) error.where.file = file;
  return error;
}

}  // namespace tetloft::cli

// Finding files of voxels.
#include "io/volume/data_files.hpp"

#include <algorithm>
#include <filesystem>
#include <optional>

#include "io/numbers.hpp"
#include "io/volume/volume_error.hpp"

namespace tetloft::internal::io {

namespace {

namespace fs = std::filesystem;

bool is_there(const fs::path& path) {
  std::error_code ignored;
  return fs::exists(path, ignored);
}

bool leads_elsewhere(const fs::path& named) {
  if (named.is_absolute()) return true;
  return std::find(named.begin(), named.end(), fs::path("..")) != named.end();
}

// Both kinds of separators: headers come from other systems, too.
std::string last_part(const std::string& named) {
  return named.substr(named.find_last_of("/\\") + 1);
}

/// Where the conversion of a pattern begins and ends, and how it fills up.
struct Conversion {
  std::size_t begin = 0;
  std::size_t end = 0;
  bool zeros = false;
  std::size_t width = 0;
};

std::optional<Conversion> conversion_in(const std::string& pattern) {
  std::optional<Conversion> found;
  for (std::size_t i = pattern.find('%'); i != std::string::npos; i = pattern.find('%', i)) {
    if (pattern.compare(i, 2, "%%") == 0) {
      i += 2;
      continue;
    }
    if (found) return std::nullopt;
    Conversion c;
    c.begin = i++;
    c.zeros = i < pattern.size() && pattern[i] == '0';
    for (; i < pattern.size() && pattern[i] >= '0' && pattern[i] <= '9'; ++i) {
      c.width = 10 * c.width + static_cast<std::size_t>(pattern[i] - '0');
      if (c.width > 64) return std::nullopt;
    }
    if (i == pattern.size() || std::string_view("diu").find(pattern[i]) == std::string_view::npos) {
      return std::nullopt;
    }
    c.end = ++i;
    found = c;
  }
  return found;
}

std::string without_doubled_percents(const std::string& text) {
  std::string plain;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text.compare(i, 2, "%%") == 0) ++i;
    plain += text[i];
  }
  return plain;
}

}  // namespace

Result<std::string> data_file(const std::string& folder, const std::string& header,
                              const std::string& named) {
  if (folder.empty()) {
    return volume_error(header, "the data are in the file " + in_quotes(named) +
                                    " beside this header, which was not read from a file");
  }
  const fs::path path(named);
  const fs::path beside = fs::path(folder) / last_part(named);
  if (!leads_elsewhere(path) && is_there(fs::path(folder) / path)) {
    return (fs::path(folder) / path).string();
  }
  if (!last_part(named).empty() && last_part(named) != ".." && is_there(beside)) {
    return beside.string();
  }
  return volume_error(
      header, "the data file " + in_quotes(named) + " is not there" +
                  (leads_elsewhere(path) ? "; of files outside of the header's folder only copies "
                                           "beside the header are read"
                                         : ""));
}

Result<std::string> image_of_pair(const std::string& folder, const std::string& header) {
  if (folder.empty()) {
    return volume_error(
        header, "the data are in an .img beside this header, which was not read from a file");
  }
  std::string stem = header;
  for (const std::string_view end : {".gz", ".hdr", ".GZ", ".HDR"}) {
    if (stem.size() > end.size() && stem.compare(stem.size() - end.size(), end.size(), end) == 0) {
      stem.resize(stem.size() - end.size());
    }
  }
  for (const char* end : {".img", ".img.gz", ".IMG", ".IMG.GZ"}) {
    if (is_there(stem + end)) return stem + end;
  }
  return volume_error(header, "the data of this header, " + in_quotes(last_part(stem) + ".img") +
                                  " or .img.gz, are not beside it");
}

bool is_pattern(const std::string& name) { return conversion_in(name).has_value(); }

std::string numbered(const std::string& pattern, std::int64_t number) {
  const Conversion c = conversion_in(pattern).value();
  std::string digits = std::to_string(number);
  const bool negative = c.zeros && number < 0;
  if (negative) digits.erase(0, 1);
  const std::size_t width = c.width - std::min<std::size_t>(c.width, negative ? 1 : 0);
  if (digits.size() < width) digits.insert(0, width - digits.size(), c.zeros ? '0' : ' ');
  return without_doubled_percents(pattern.substr(0, c.begin)) + (negative ? "-" : "") + digits +
         without_doubled_percents(pattern.substr(c.end));
}

}  // namespace tetloft::internal::io

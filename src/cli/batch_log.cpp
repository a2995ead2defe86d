// See batch_log.hpp. A line is written by one call, its end with it: what has no end was
// interrupted.
#include "cli/batch_log.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <charconv>
#include <cstddef>
#include <filesystem>
#include <system_error>
#include <utility>

#include <tetloft/pieces.hpp>
#include <tetloft/version.hpp>

#include "cli/console.hpp"
#include "core/text.hpp"
#include "io/bytes/checksum.hpp"
#include "io/json_scan.hpp"
#include "io/output_place.hpp"

namespace tetloft::cli {

using namespace internal;

namespace {

namespace fs = std::filesystem;
using io::JsonEvent;
using io::JsonKind;

constexpr std::string_view kProgram = "tetloft";  // the member that a line begins with
constexpr std::string_view kLineBegin = "{\"tetloft\":\"";

std::uint64_t from_hex(std::string_view text) {
  std::uint64_t number = 0;
  std::from_chars(text.data(), text.data() + text.size(), number, 16);
  return number;
}

// No more than a double counts exactly: no file is larger.
std::uint64_t size_from(const JsonEvent& value) {
  const bool counts = value.number >= 0 && value.number < 0x1p53;
  return counts ? static_cast<std::uint64_t>(value.number) : 0;
}

// A name as JSON brings it back.
std::string name_in_log(const std::string& path) {
  return valid_utf8(fs::path(path).filename().string());
}

// In one text, of which each part has an end that none contains.
std::string key_text(const std::string& version, const BatchKey& key) {
  std::string text = version + '\n' + key.options + '\n';
  for (const FileSum& file : key.read) {
    text += name_in_log(file.path) + '\0' + std::to_string(file.bytes) + ' ' +
            in_hex(file.checksum) + '\n';
  }
  for (const std::string& path : key.written) text += name_in_log(path) + '\0';
  return text;
}

// A line as it is read.
struct LogEntry {
  std::string version;
  BatchKey key;
  std::vector<FileSum> written;
};

Result<FileSum> take_sum(io::JsonScanner& scanner) {
  FileSum sum;
  for (;;) {
    const Result<JsonEvent> key = scanner.next();
    if (!key) return key.error();
    if (key->kind == JsonKind::close_object) return sum;
    const Result<JsonEvent> value = scanner.next();
    if (!value) return value.error();
    if (key->text == "file") sum.path = value->text;
    if (key->text == "bytes") sum.bytes = size_from(*value);
    if (key->text == "checksum") sum.checksum = from_hex(value->text);
    if (Result<void> rest = scanner.skip(*value); !rest) return rest.error();
  }
}

// The rest of an array of files.
Result<std::vector<FileSum>> take_sums(io::JsonScanner& scanner) {
  std::vector<FileSum> sums;
  for (;;) {
    const Result<JsonEvent> event = scanner.next();
    if (!event) return event.error();
    if (event->kind == JsonKind::close_array) return sums;
    if (event->kind != JsonKind::open_object) {
      return scanner.complain("this is no file as logs of batches have it", event->line);
    }
    Result<FileSum> sum = take_sum(scanner);
    if (!sum) return sum.error();
    sums.push_back(*std::move(sum));
  }
}

// The rest of an object.
Result<LogEntry> take_entry(io::JsonScanner& scanner) {
  LogEntry entry;
  for (;;) {
    const Result<JsonEvent> key = scanner.next();
    if (!key) return key.error();
    if (key->kind == JsonKind::close_object) return entry;
    const Result<JsonEvent> value = scanner.next();
    if (!value) return value.error();
    if (value->kind == JsonKind::open_array && (key->text == "read" || key->text == "written")) {
      Result<std::vector<FileSum>> sums = take_sums(scanner);
      if (!sums) return sums.error();
      (key->text == "read" ? entry.key.read : entry.written) = *std::move(sums);
      continue;
    }
    if (key->text == kProgram) entry.version = value->text;
    if (key->text == "options") entry.key.options = value->text;
    if (Result<void> rest = scanner.skip(*value); !rest) return rest.error();
  }
}

}  // namespace

Result<std::vector<FileSum>> sums_of(const std::vector<std::string>& files) {
  std::vector<FileSum> sums;
  for (const std::string& file : files) {
    std::error_code code;
    const fs::file_status status = fs::status(file, code);
    if (!fs::exists(status)) {
      return io::io_error(file, "cannot be opened", code ? code.value() : ENOENT);
    }
    if (!fs::is_regular_file(status)) {
      return io::io_error(file, "is no regular file: one of a batch is read twice", 0);
    }
    const Result<PlanSource> source = plan_source(file);
    if (!source) return source.error();
    sums.push_back({file, source->bytes, source->checksum});
  }
  return sums;
}

bool still_so(const std::vector<std::string>& paths, const std::vector<FileSum>& files) {
  if (paths.size() != files.size()) return false;
  for (std::size_t i = 0; i < paths.size(); ++i) {
    std::error_code code;
    if (fs::file_size(paths[i], code) != files[i].bytes || code) return false;
    const Result<PlanSource> now = plan_source(paths[i]);
    if (!now || now->bytes != files[i].bytes || now->checksum != files[i].checksum) return false;
  }
  return true;
}

std::string digest_of(std::string_view text) {
  io::TwofoldChecksum checksum;
  checksum.add(text);
  return in_hex(checksum.value());
}

void write_sums(JsonWriter& json, std::string_view name, const std::vector<FileSum>& files) {
  json.key(name);
  json.begin_array();
  for (const FileSum& file : files) {
    json.begin_object();
    json.member("file", file.path);
    json.member("bytes", file.bytes);
    json.member("checksum", in_hex(file.checksum));
    json.end_object();
  }
  json.end_array();
}

void write_key(JsonWriter& json, const BatchKey& key) {
  json.member(kProgram, std::string_view(version()));
  json.member("options", key.options);
  write_sums(json, "read", key.read);
}

BatchLog::~BatchLog() {
  if (descriptor_ >= 0) close(descriptor_);
}

Result<void> BatchLog::open(const std::string& path) {
  path_ = path;
  descriptor_ = ::open(path.c_str(), O_RDWR | O_CREAT | O_APPEND | O_CLOEXEC | O_NOCTTY, 0666);
  if (descriptor_ < 0) return io::io_error(path, "cannot be opened", errno);
  std::error_code code;
  if (!fs::is_regular_file(path, code)) {
    return io::io_error(path, "is no regular file, as the log of a batch must be", 0);
  }
  // A file system without locks has none to respect.
  struct flock lock {};
  lock.l_type = F_WRLCK;
  lock.l_whence = SEEK_SET;
  if (fcntl(descriptor_, F_SETLK, &lock) != 0 && (errno == EAGAIN || errno == EACCES)) {
    return io::io_error(path, "is the log of a batch that is at work", 0);
  }
  const Result<std::string> bytes = whole();
  if (!bytes) return bytes.error();
  const std::size_t end = bytes->rfind('\n') + 1;  // 0 where there is none
  if (Result<void> taken = take_lines(std::string_view(*bytes).substr(0, end)); !taken) {
    return taken;
  }
  const std::string_view tail = std::string_view(*bytes).substr(end);
  if (tail.empty()) return {};
  if (tail.substr(0, kLineBegin.size()) != kLineBegin.substr(0, tail.size())) {
    return io::JsonScanner(tail, path_)
        .complain("this is no log of a batch",
                  1 + static_cast<std::size_t>(std::count(bytes->begin(), bytes->end(), '\n')));
  }
  if (ftruncate(descriptor_, static_cast<off_t>(end)) != 0) {
    return io::io_error(path, "cannot be written", errno);
  }
  return {};
}

Result<std::string> BatchLog::whole() const {
  std::string bytes;
  std::array<char, std::size_t{1} << 16> piece;
  for (;;) {
    const ssize_t got =
        pread(descriptor_, piece.data(), piece.size(), static_cast<off_t>(bytes.size()));
    if (got < 0 && errno == EINTR) continue;
    if (got < 0) return io::io_error(path_, "cannot be read", errno);
    if (got == 0) return bytes;
    bytes.append(piece.data(), static_cast<std::size_t>(got));
  }
}

Result<void> BatchLog::take_lines(std::string_view lines) {
  io::JsonScanner scanner(lines, path_);
  for (;;) {
    const Result<JsonEvent> event = scanner.next();
    if (!event) return event.error();
    if (event->kind == JsonKind::end) return {};
    Result<LogEntry> entry = LogEntry{};
    if (event->kind == JsonKind::open_object) entry = take_entry(scanner);
    if (!entry) return entry.error();
    if (entry->version.empty()) return scanner.complain("this is no log of a batch", event->line);
    if (entry->written.empty()) continue;  // it failed
    for (const FileSum& file : entry->written) entry->key.written.push_back(file.path);
    done_[key_text(entry->version, entry->key)] = std::move(entry->written);
  }
}

const std::vector<FileSum>* BatchLog::find(const BatchKey& key) const {
  const auto found = done_.find(key_text(version(), key));
  return found == done_.end() ? nullptr : &found->second;
}

Result<void> BatchLog::append(const std::string& line) {
  const std::scoped_lock lock(appending_);
  const off_t before = lseek(descriptor_, 0, SEEK_END);
  const std::string text = line + '\n';
  std::string_view left = text;
  while (!left.empty()) {
    const ssize_t written = write(descriptor_, left.data(), left.size());
    if (written < 0 && errno == EINTR) continue;
    if (written <= 0) break;
    left.remove_prefix(static_cast<std::size_t>(written));
  }
  // File systems that cannot be asked for it say EINVAL.
  if (left.empty() && (fdatasync(descriptor_) == 0 || errno == EINVAL)) return {};
  Error error = io::io_error(path_, "cannot be written", errno);
  if (before >= 0 && ftruncate(descriptor_, before) != 0) error.message += ", and ends badly now";
  return error;
}

}  // namespace tetloft::cli

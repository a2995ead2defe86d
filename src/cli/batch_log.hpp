// The log of a batch: a line of JSON for each stack, appended as it ends, by which a later run
// knows what is done. A stack is known by the contents of its files, not by their dates, and done
// as long as what was written has the contents that it had then.
#pragma once

#include <cstdint>
#include <map>
#include <mutex>
#include <string>
#include <string_view>
#include <vector>

#include <tetloft/result.hpp>

#include "cli/json.hpp"

namespace tetloft::cli {

/// A file as it is, or was.
struct FileSum {
  std::string path;
  std::uint64_t bytes = 0;
  std::uint64_t checksum = 0;
};
/// Reads all of each. Error io.
[[nodiscard]] Result<std::vector<FileSum>> sums_of(const std::vector<std::string>& files);
/// Whether files are at these paths with the contents of those, which may have been elsewhere.
[[nodiscard]] bool still_so(const std::vector<std::string>& paths,
                            const std::vector<FileSum>& files);

/// 64 bits of a text, in hex.
[[nodiscard]] std::string digest_of(std::string_view text);

/// What decides a solid: names (without folders) and contents of the files that are read, options,
/// and the program's version; and the names of the files that are written.
struct BatchKey {
  std::vector<FileSum> read;
  std::string options;  ///< digest_of() them
  std::vector<std::string> written;
};

class BatchLog {
 public:
  BatchLog() = default;
  ~BatchLog();
  BatchLog(const BatchLog&) = delete;
  BatchLog& operator=(const BatchLog&) = delete;

  /// Reads the log that is there, or begins one. The last line may have been interrupted: it is cut
  /// off. Error io, also where another process has it open; invalid_input, with the line, where it
  /// is something else.
  [[nodiscard]] Result<void> open(const std::string& path);
  /// What was written when that was done last; null where it never was.
  [[nodiscard]] const std::vector<FileSum>* find(const BatchKey& key) const;
  /// Appends one line, which is with the disk afterwards, or not there (error io). From several
  /// threads at once.
  [[nodiscard]] Result<void> append(const std::string& line);

 private:
  [[nodiscard]] Result<std::string> whole() const;
  [[nodiscard]] Result<void> take_lines(std::string_view lines);

  std::string path_;
  int descriptor_ = -1;
  std::mutex appending_;
  std::map<std::string, std::vector<FileSum>> done_;
};

/// A line's beginning, within the object: program, version, options and what was read. A line of
/// what is done has a member "written" of write_sums(), too.
void write_key(JsonWriter& json, const BatchKey& key);
void write_sums(JsonWriter& json, std::string_view name, const std::vector<FileSum>& files);

}  // namespace tetloft::cli

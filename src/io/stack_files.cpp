// See stack_files.hpp.
#include "io/stack_files.hpp"

#include <algorithm>
#include <cstddef>
#include <memory>
#include <utility>

#include "io/bytes/byte_source.hpp"
#include "io/formats.hpp"
#include "io/output_place.hpp"

namespace tetloft::internal::io {

namespace {

struct FileBeginning {
  std::unique_ptr<ByteSource> bytes;  // null where it cannot be read at any place
  std::string first;
};

// Formats tell themselves by few bytes, and headers of volumes are read from the file.
FileBeginning file_beginning(const std::string& path) {
  constexpr std::size_t kLooked = std::size_t{1} << 16;
  FileBeginning file;
  Result<std::unique_ptr<ByteSource>> bytes = open_bytes(path);
  if (!bytes || *bytes == nullptr) return file;
  file.first.resize(kLooked);
  const Result<std::size_t> got = (*bytes)->read_at(0, file.first);
  file.first.resize(got ? *got : 0);
  if (got) file.bytes = *std::move(bytes);
  return file;
}

}  // namespace

bool is_stack_file(const std::string& path, const std::string& format) {
  const FileBeginning file = file_beginning(path);
  const auto tells = [&](const Format* one) {
    if (!reads(*one, Contents::stack) || (!format.empty() && one->name != format)) return false;
    return !extension_in(*one, path).empty() ||
           (one->recognise != nullptr && one->recognise(file.first));
  };
  return std::any_of(format_table().begin(), format_table().end(), tells);
}

bool is_read_by_section(const std::string& path, const ReadOptions& options) {
  if (options.close_on_frame || options.validity != Validity::required) return false;
  const FileBeginning file = file_beginning(path);
  if (file.bytes == nullptr) return false;
  const Source source{file.first, path, {}, file.bytes.get()};
  return choose_by_section(format_table(), source, options.format) != nullptr;
}

std::vector<std::string> stack_files(const std::string& path, const std::string& format) {
  std::vector<std::string> files{path};
  const FileBeginning file = file_beginning(path);
  if (file.bytes == nullptr) return files;
  const Source source{file.first, path, folder_of(path), file.bytes.get()};
  const auto reader = choose_reader(format_table(), Contents::stack, source, format);
  if (!reader || (*reader)->open_volume == nullptr) return files;
  const auto volume = (*reader)->open_volume(source, {});
  if (!volume) return files;
  for (std::string& beside : (*volume)->data_files()) files.push_back(std::move(beside));
  return files;
}

}  // namespace tetloft::internal::io

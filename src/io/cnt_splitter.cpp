#include "io/cnt_splitter.hpp"

#include <algorithm>

#include "io/cursor.hpp"
#include "io/output_place.hpp"

namespace tetloft::internal::io {

namespace {

// More than in_quotes() shows of a word.
constexpr std::size_t kShown = 64;

}  // namespace

Result<std::optional<CntPart>> CntSplitter::next() {
  const auto done = buffer_.begin() + static_cast<std::ptrdiff_t>(begin_);
  at_.line += static_cast<std::size_t>(
      std::count(done, done + static_cast<std::ptrdiff_t>(part_size_), '\n'));
  at_.offset += part_size_;
  begin_ += part_size_;
  part_size_ = 0;
  if (begin_ == buffer_.size() && all_read()) return std::optional<CntPart>();
  scanned_ = begin_;
  in_comment_ = false;
  while (!find_end() && !all_read()) {
    if (Result<void> loaded = load(); !loaded) return loaded.error();
    if (buffer_.size() - begin_ <= blocks_.largest_section + blocks_.read) continue;
    return io_error(name_,
                    "has a section that is too large to be read: more than " +
                        std::to_string(blocks_.largest_section >> 20) + " MiB",
                    0);
  }
  part_size_ = scanned_ - begin_;
  while (buffer_.size() - scanned_ < kShown && !all_read()) {
    if (Result<void> loaded = load(); !loaded) return loaded.error();
  }
  const std::size_t follows = std::min(kShown, buffer_.size() - scanned_);
  const std::string_view text = std::string_view(buffer_).substr(begin_, part_size_ + follows);
  return std::optional(CntPart{text, follows, at_});
}

// Goes on to the next section, or to the end of the buffer; whether there is one.
bool CntSplitter::find_end() {
  for (; scanned_ < buffer_.size(); ++scanned_) {
    const char c = buffer_[scanned_];
    if (in_comment_) {
      in_comment_ = c != '\n';
    } else if (c == '#') {
      in_comment_ = true;
    } else if ((c == 'v' || c == 'V') && scanned_ > begin_) {
      const char before = buffer_[scanned_ - 1];
      if (is_white(before) || before == '}') return true;
    }
  }
  return false;
}

// One block more; what is before the part is dropped.
Result<void> CntSplitter::load() {
  buffer_.erase(0, begin_);
  scanned_ -= begin_;
  begin_ = 0;
  const std::size_t before = buffer_.size();
  const auto wanted =
      static_cast<std::size_t>(std::min<std::uint64_t>(blocks_.read, source_.size() - read_));
  buffer_.resize(before + wanted);
  const Result<std::size_t> got =
      source_.read_at(read_, std::span(buffer_).subspan(before, wanted));
  if (!got) return got.error();
  if (*got < wanted) return io_error(name_, "changes while it is read", 0);
  read_ += wanted;
  checksum_ = crc32(checksum_, std::string_view(buffer_).substr(before));
  return {};
}

}  // namespace tetloft::internal::io

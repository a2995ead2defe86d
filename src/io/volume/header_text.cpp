// Lines and words of headers.
#include "io/volume/header_text.hpp"

#include "io/cursor.hpp"
#include "io/volume/volume_error.hpp"

namespace tetloft::internal::io {

namespace {

constexpr std::uint64_t kLongestHeader = std::uint64_t{1} << 24;
constexpr std::size_t kReadAtOnce = std::size_t{1} << 12;

}  // namespace

std::vector<std::string> words_of(std::string_view text) {
  std::vector<std::string> words;
  TextCursor cursor(text);
  for (;;) {
    cursor.skip_white();
    if (cursor.at_end()) return words;
    words.emplace_back(cursor.token());
  }
}

Result<bool> HeaderLines::next() {
  std::size_t searched = used_;
  std::size_t end = 0;
  for (;;) {
    end = buffer_.find('\n', searched);
    if (end != std::string::npos) break;
    searched = buffer_.size();
    if (position_ + (buffer_.size() - used_) > kLongestHeader) {
      return volume_error(name_, "the header does not end within 16 MiB");
    }
    buffer_.erase(0, used_);
    searched -= used_;
    used_ = 0;
    const std::size_t before = buffer_.size();
    buffer_.resize(before + kReadAtOnce);
    const Result<std::size_t> got =
        file_.read_at(position_ + before, std::span(buffer_).subspan(before));
    if (!got) return got.error();
    buffer_.resize(before + *got);
    if (*got > 0) continue;
    if (buffer_.empty()) return false;
    end = buffer_.size();
    break;
  }
  const std::size_t length = end - used_;
  text_ = buffer_.substr(used_, length);
  if (!text_.empty() && text_.back() == '\r') text_.pop_back();
  const std::size_t passed = length + (end < buffer_.size() ? 1 : 0);
  used_ += passed;
  position_ += passed;
  ++number_;
  return true;
}

}  // namespace tetloft::internal::io

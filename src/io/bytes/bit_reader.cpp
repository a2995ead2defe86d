// Bits of a source.
#include "io/bytes/bit_reader.hpp"

#include <algorithm>

namespace tetloft::internal::io {

bool BitReader::refill() {
  const Result<std::size_t> got = source_->read_at(next_, buffer_);
  if (!got) throw Failed(got.error());
  buffer_at_ = 0;
  buffer_end_ = *got;
  next_ += *got;
  return *got > 0;
}

void BitReader::fill() {
  while (count_ <= 56) {
    if (buffer_at_ == buffer_end_ && !refill()) return;
    const auto byte = static_cast<unsigned char>(buffer_[buffer_at_++]);
    bits_ |= std::uint64_t{byte} << count_;
    count_ += 8;
  }
}

std::size_t BitReader::copy(char* to, std::size_t count) {
  std::size_t done = 0;
  for (; done < count && count_ > 0; ++done) to[done] = static_cast<char>(take(8));
  while (done < count) {
    if (buffer_at_ == buffer_end_ && !refill()) break;
    const std::size_t part = std::min(count - done, buffer_end_ - buffer_at_);
    std::copy_n(buffer_.data() + buffer_at_, part, to + done);
    buffer_at_ += part;
    done += part;
  }
  return done;
}

void BitReader::fail(const std::string& what) const {
  Error error{ErrorCode::invalid_input, what + " (byte " + std::to_string(position()) + ")", {}};
  error.where.file = name_;
  throw Failed(std::move(error));
}

}  // namespace tetloft::internal::io

// DEFLATE: blocks of literals and of matches in the window behind them (RFC 1951), and the
// wrappings with checksums around them (RFC 1950, RFC 1952).
#include "io/bytes/inflate.hpp"

#include <algorithm>
#include <array>
#include <optional>

#include "io/bytes/bit_reader.hpp"
#include "io/bytes/checksum.hpp"
#include "io/bytes/deflate_codes.hpp"
#include "io/bytes/huffman.hpp"

namespace tetloft::internal::io {

class Inflater::Work {
 public:
  Work(const ByteSource& source, std::uint64_t offset, Wrapping wrapping, std::string name)
      : in_(source, offset, std::move(name)), wrapping_(wrapping) {}

  // What was unpacked before an error is handed out before it, as far as whole requests go.
  Result<std::size_t> read(std::span<char> to) {
    std::size_t done = take_ready(to);
    while (done < to.size()) {
      if (error_) return *error_;
      if (state_ == State::end) break;
      go_on();
      done += take_ready(to.subspan(done));
    }
    return done;
  }
  [[nodiscard]] std::uint64_t position() const { return in_.position(); }

 private:
  enum class State : std::uint8_t { wrapping, block, stored, coded, trailer, end };

  std::size_t take_ready(std::span<char> to);
  void go_on();
  void step();
  void begin_member();
  void read_zlib_header();
  void read_gzip_header();
  std::uint32_t header_byte();
  void begin_block();
  void begin_stored();
  void read_codes();
  void copy_stored();
  void decode();
  void put_match(unsigned length, std::size_t distance);
  unsigned length_of(unsigned symbol);
  std::size_t distance_of(unsigned symbol);
  void add_to_sum();
  void end_member();

  [[nodiscard]] bool has_room() const { return written_ - taken_ + kLongestMatch <= kWindow; }
  void put(char c) {
    ring_[written_ & (ring_.size() - 1)] = c;
    ++written_;
  }

  BitReader in_;
  Wrapping wrapping_;
  State state_ = State::wrapping;
  std::optional<Error> error_;
  bool last_block_ = false;
  std::size_t stored_left_ = 0;
  HuffmanCode literals_;
  HuffmanCode distances_;
  /// The window, and behind it as much that is unpacked and not yet taken. All counts are of bytes
  /// since the beginning.
  std::array<char, 2 * kWindow> ring_{};
  std::uint64_t written_ = 0;
  std::uint64_t taken_ = 0;
  std::uint64_t summed_ = 0;
  std::uint64_t member_start_ = 0;
  std::uint32_t sum_ = 0;
  std::uint32_t header_sum_ = 0;
};

std::size_t Inflater::Work::take_ready(std::span<char> to) {
  std::size_t done = 0;
  while (done < to.size() && taken_ < written_) {
    const auto from = static_cast<std::size_t>(taken_ & (ring_.size() - 1));
    const auto ready = static_cast<std::size_t>(written_ - taken_);
    const std::size_t part = std::min({to.size() - done, ready, ring_.size() - from});
    std::copy_n(ring_.data() + from, part, to.data() + done);
    taken_ += part;
    done += part;
  }
  return done;
}

void Inflater::Work::go_on() {
  try {
    step();
    add_to_sum();
  } catch (const Failed& failed) {
    error_ = failed.error();
  }
}

void Inflater::Work::step() {
  switch (state_) {
    case State::wrapping: return begin_member();
    case State::block: return begin_block();
    case State::stored: return copy_stored();
    case State::coded: return decode();
    case State::trailer: return end_member();
    case State::end: return;
  }
}

void Inflater::Work::begin_member() {
  if (wrapping_ == Wrapping::zlib) read_zlib_header();
  if (wrapping_ == Wrapping::gzip) read_gzip_header();
  member_start_ = written_;
  sum_ = wrapping_ == Wrapping::zlib ? kAdlerOfNothing : kCrcOfNothing;
  last_block_ = false;
  state_ = State::block;
}

void Inflater::Work::read_zlib_header() {
  const std::uint32_t method = in_.take(8);
  const std::uint32_t flags = in_.take(8);
  if ((method & 15U) != 8 || method >> 4 > 7 || (method * 256 + flags) % 31 != 0) {
    in_.fail("these are no zlib data");
  }
  if ((flags & 32U) != 0) in_.fail("zlib data with a preset dictionary are not read");
}

std::uint32_t Inflater::Work::header_byte() {
  const std::uint32_t byte = in_.take(8);
  const char c = static_cast<char>(byte);
  header_sum_ = crc32(header_sum_, {&c, 1});
  return byte;
}

void Inflater::Work::read_gzip_header() {
  header_sum_ = kCrcOfNothing;
  const std::uint32_t first = header_byte();
  if (first != 0x1F || header_byte() != 0x8B) in_.fail("these are no gzip data");
  if (header_byte() != 8) in_.fail("gzip data of an unknown method");
  const std::uint32_t flags = header_byte();
  if ((flags & 0xE0U) != 0) in_.fail("gzip data with unknown flags");
  for (int i = 0; i < 6; ++i) static_cast<void>(header_byte());
  if ((flags & 4U) != 0) {
    std::uint32_t extra = header_byte();
    extra |= header_byte() << 8;
    for (; extra > 0; --extra) static_cast<void>(header_byte());
  }
  for (const std::uint32_t text : {8U, 16U}) {
    while ((flags & text) != 0 && header_byte() != 0) {
    }
  }
  if ((flags & 2U) != 0) {
    const std::uint32_t expected = header_sum_ & 0xFFFFU;
    if (in_.take(16) != expected) in_.fail("the checksum of the gzip header is wrong");
  }
}

void Inflater::Work::begin_block() {
  if (last_block_) {
    state_ = State::trailer;
    return;
  }
  last_block_ = in_.take(1) != 0;
  const std::uint32_t type = in_.take(2);
  if (type == 0) return begin_stored();
  if (type == 3) in_.fail("the compressed data have a block of an unknown type");
  if (type == 2) {
    read_codes();
  } else {
    std::array<std::uint8_t, HuffmanCode::kMostSymbols> lengths{};
    std::fill_n(lengths.begin(), 144, std::uint8_t{8});
    std::fill_n(lengths.begin() + 144, 112, std::uint8_t{9});
    std::fill_n(lengths.begin() + 256, 24, std::uint8_t{7});
    std::fill_n(lengths.begin() + 280, 8, std::uint8_t{8});
    static_cast<void>(literals_.assign(lengths));
    lengths.fill(5);
    static_cast<void>(distances_.assign(std::span(lengths).first(32)));
  }
  state_ = State::coded;
}

void Inflater::Work::begin_stored() {
  in_.skip_to_byte();
  const std::uint32_t length = in_.take(16);
  if (in_.take(16) != (~length & 0xFFFFU)) in_.fail("the length of a stored block is wrong");
  stored_left_ = length;
  state_ = State::stored;
}

// RFC 1951, 3.2.7: the lengths of both codes, run-length coded by a code of their own.
void Inflater::Work::read_codes() {
  const std::size_t literals = in_.take(5) + 257;
  const std::size_t distances = in_.take(5) + 1;
  const std::size_t count = in_.take(4) + 4;
  if (literals > 286 || distances > 30) in_.fail("the compressed data have too many codes");
  std::array<std::uint8_t, 19> own{};
  for (std::size_t i = 0; i < count; ++i)
    own[kCodeLengthOrder[i]] = static_cast<std::uint8_t>(in_.take(3));
  HuffmanCode code;
  if (!code.assign(own)) in_.fail("the compressed data have an impossible code");
  std::array<std::uint8_t, 286 + 30> lengths{};
  for (std::size_t i = 0; i < literals + distances;) {
    const HuffmanCode::Symbol symbol = code.find(in_.peek());
    if (symbol.length == 0) in_.fail("the compressed data have a length without a code");
    in_.skip(symbol.length);
    if (symbol.value < 16) {
      lengths[i++] = static_cast<std::uint8_t>(symbol.value);
      continue;
    }
    if (symbol.value == 16 && i == 0) in_.fail("the compressed data repeat a length before any");
    const std::uint8_t value = symbol.value == 16 ? lengths[i - 1] : std::uint8_t{0};
    const std::size_t run = symbol.value == 16   ? 3 + in_.take(2)
                            : symbol.value == 17 ? 3 + in_.take(3)
                                                 : 11 + in_.take(7);
    if (run > literals + distances - i) in_.fail("the compressed data have too many lengths");
    std::fill_n(lengths.begin() + static_cast<std::ptrdiff_t>(i), run, value);
    i += run;
  }
  if (lengths[kEndOfBlock] == 0) in_.fail("the compressed data have a block without end");
  const std::span<const std::uint8_t> all(lengths);
  if (!literals_.assign(all.first(literals)) ||
      !distances_.assign(all.subspan(literals, distances))) {
    in_.fail("the compressed data have an impossible code");
  }
}

void Inflater::Work::copy_stored() {
  if (stored_left_ == 0) {
    state_ = State::block;
    return;
  }
  const auto at = static_cast<std::size_t>(written_ & (ring_.size() - 1));
  const auto room = kWindow - static_cast<std::size_t>(written_ - taken_);
  const std::size_t part = std::min({stored_left_, room, ring_.size() - at});
  if (in_.copy(ring_.data() + at, part) != part) in_.fail("the compressed data are cut off");
  written_ += part;
  stored_left_ -= part;
}

void Inflater::Work::decode() {
  while (has_room()) {
    const HuffmanCode::Symbol symbol = literals_.find(in_.peek());
    if (symbol.length == 0) in_.fail("the compressed data have bits without a code");
    in_.skip(symbol.length);
    if (symbol.value < kEndOfBlock) {
      put(static_cast<char>(symbol.value));
    } else if (symbol.value == kEndOfBlock) {
      state_ = State::block;
      return;
    } else {
      const unsigned length = length_of(symbol.value);
      const HuffmanCode::Symbol distance = distances_.find(in_.peek());
      if (distance.length == 0) in_.fail("the compressed data have bits without a code");
      in_.skip(distance.length);
      put_match(length, distance_of(distance.value));
    }
  }
}

unsigned Inflater::Work::length_of(unsigned symbol) {
  const std::size_t code = symbol - kEndOfBlock - 1;
  if (code >= kMatchLengths.size()) in_.fail("the compressed data have an unknown length");
  return kMatchLengths[code].base + in_.take(kMatchLengths[code].extra);
}

std::size_t Inflater::Work::distance_of(unsigned symbol) {
  if (symbol >= kMatchDistances.size()) in_.fail("the compressed data have an unknown distance");
  return kMatchDistances[symbol].base + in_.take(kMatchDistances[symbol].extra);
}

void Inflater::Work::put_match(unsigned length, std::size_t distance) {
  if (distance > written_ - member_start_) {
    in_.fail("the compressed data refer to what is before their beginning");
  }
  // Byte by byte: a match may overlap what it makes.
  for (; length > 0; --length) put(ring_[(written_ - distance) & (ring_.size() - 1)]);
}

void Inflater::Work::add_to_sum() {
  while (summed_ < written_) {
    const auto from = static_cast<std::size_t>(summed_ & (ring_.size() - 1));
    const auto ready = static_cast<std::size_t>(written_ - summed_);
    const std::string_view piece(ring_.data() + from, std::min(ready, ring_.size() - from));
    if (wrapping_ == Wrapping::zlib) sum_ = adler32(sum_, piece);
    if (wrapping_ == Wrapping::gzip) sum_ = crc32(sum_, piece);
    summed_ += piece.size();
  }
}

void Inflater::Work::end_member() {
  in_.skip_to_byte();
  state_ = State::end;
  if (wrapping_ == Wrapping::zlib) {
    std::uint32_t expected = 0;
    for (int i = 0; i < 4; ++i) expected = expected << 8 | in_.take(8);
    if (expected != sum_) in_.fail("the checksum of the compressed data is wrong");
  }
  if (wrapping_ != Wrapping::gzip) return;
  if (in_.take(32) != sum_) in_.fail("the checksum of the compressed data is wrong");
  if (in_.take(32) != ((written_ - member_start_) & 0xFFFFFFFFU)) {
    in_.fail("the compressed data unpack to another size than they say");
  }
  // Whatever else follows is padding.
  if ((in_.peek() & 0xFFFFU) == 0x8B1F) state_ = State::wrapping;
}

Inflater::Inflater(const ByteSource& source, std::uint64_t offset, Wrapping wrapping,
                   std::string name)
    : work_(std::make_unique<Work>(source, offset, wrapping, std::move(name))) {}
Inflater::~Inflater() = default;

Result<std::size_t> Inflater::read(std::span<char> to) { return work_->read(to); }
std::uint64_t Inflater::position() const { return work_->position(); }

Result<std::string> inflate(std::string_view bytes, Wrapping wrapping, std::size_t most,
                            const std::string& name) {
  const MemoryBytes source(bytes);
  Inflater inflater(source, 0, wrapping, name);
  std::string all;
  std::array<char, kWindow> piece{};
  for (;;) {
    const Result<std::size_t> got = inflater.read(piece);
    if (!got) return got.error();
    if (*got > most - all.size()) {
      Error error{ErrorCode::invalid_input,
                  "the compressed data unpack to more than " + std::to_string(most) + " bytes",
                  {}};
      error.where.file = name;
      return error;
    }
    all.append(piece.data(), *got);
    if (*got < piece.size()) return all;
  }
}

}  // namespace tetloft::internal::io

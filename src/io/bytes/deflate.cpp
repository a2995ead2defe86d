// Matches by hash chains, one dynamic Huffman code for each block.
#include "io/bytes/deflate.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <queue>
#include <utility>
#include <vector>

#include "io/bytes/checksum.hpp"
#include "io/bytes/deflate_codes.hpp"

namespace tetloft::internal::io {

namespace {

constexpr std::size_t kLeastMatch = 3;
constexpr std::size_t kMostTries = 48;
constexpr std::size_t kLongEnough = 32;
// Short matches from farther away take more bits than literals.
constexpr std::size_t kNear = 4096;
constexpr std::size_t kBlockSymbols = std::size_t{1} << 16;

// A literal (distance 0), or a match.
struct Symbol {
  std::uint16_t value = 0;  // literal byte, or length
  std::uint16_t distance = 0;
};

class BitWriter {
 public:
  explicit BitWriter(std::string& out) : out_(out) {}
  // The lowest bit first.
  void put(std::uint32_t bits, unsigned count) {
    held_ |= static_cast<std::uint64_t>(bits) << count_;
    count_ += count;
    while (count_ >= 8) {
      out_ += static_cast<char>(held_ & 0xFFU);
      held_ >>= 8;
      count_ -= 8;
    }
  }
  void flush() {
    if (count_ > 0) out_ += static_cast<char>(held_ & 0xFFU);
    held_ = 0;
    count_ = 0;
  }

 private:
  std::string& out_;
  std::uint64_t held_ = 0;
  unsigned count_ = 0;
};

struct Code {
  std::vector<std::uint8_t> length;
  std::vector<std::uint16_t> bits;  // reversed: to be sent lowest bit first
};

// Depths of the leaves of a Huffman tree; counts of zero get none.
std::vector<std::uint8_t> huffman_lengths(const std::vector<std::uint32_t>& count) {
  struct Node {
    std::uint64_t weight;
    std::size_t number;
    bool operator>(const Node& other) const {
      return std::pair(weight, number) > std::pair(other.weight, other.number);
    }
  };
  std::priority_queue<Node, std::vector<Node>, std::greater<>> heap;
  for (std::size_t k = 0; k < count.size(); ++k) {
    if (count[k] != 0) heap.push({count[k], k});
  }
  std::vector<std::uint8_t> length(count.size(), 0);
  if (heap.size() == 1) {
    length[heap.top().number] = 1;
    return length;
  }
  // parent[n]: inner nodes are numbered after the leaves, in the order of their making.
  std::vector<std::size_t> parent(count.size());
  while (heap.size() > 1) {
    const Node a = heap.top();
    heap.pop();
    const Node b = heap.top();
    heap.pop();
    const std::size_t made = parent.size();
    parent.push_back(made);
    parent[a.number] = parent[b.number] = made;
    heap.push({a.weight + b.weight, made});
  }
  std::vector<std::uint8_t> depth(parent.size(), 0);
  for (std::size_t n = parent.size() - 1; n-- > 0;) {
    if (n < count.size() && count[n] == 0) continue;
    depth[n] = static_cast<std::uint8_t>(depth[parent[n]] + 1);
    if (n < count.size()) length[n] = depth[n];
  }
  return length;
}

// A code no longer than `limit`: counts are flattened until the tree is shallow enough.
Code code_for(std::vector<std::uint32_t> count, std::uint8_t limit) {
  Code code;
  for (;;) {
    code.length = huffman_lengths(count);
    if (*std::max_element(code.length.begin(), code.length.end()) <= limit) break;
    for (std::uint32_t& c : count) {
      if (c != 0) c = c / 2 + 1;
    }
  }
  std::array<std::uint16_t, 17> of_length{};
  for (const std::uint8_t length : code.length) ++of_length[length];
  of_length[0] = 0;
  std::array<std::uint16_t, 17> next{};
  for (std::size_t k = 1; k < next.size(); ++k) {
    next[k] = static_cast<std::uint16_t>((next[k - 1] + of_length[k - 1]) << 1U);
  }
  code.bits.resize(code.length.size());
  for (std::size_t k = 0; k < code.length.size(); ++k) {
    unsigned value = next[code.length[k]]++;
    unsigned reversed = 0;
    for (unsigned b = 0; b < code.length[k]; ++b, value >>= 1)
      reversed = reversed << 1 | (value & 1U);
    code.bits[k] = static_cast<std::uint16_t>(reversed);
  }
  return code;
}

template <std::size_t n>
std::size_t code_of(const std::array<CodedRange, n>& ranges, std::size_t value) {
  const auto behind = std::upper_bound(
      ranges.begin(), ranges.end(), value,
      [](std::size_t sought, const CodedRange& range) { return sought < range.base; });
  return static_cast<std::size_t>(behind - ranges.begin()) - 1;
}

void write_code_lengths(const std::vector<std::uint8_t>& lengths, BitWriter& out) {
  // Runs of section 3.2.7 are left out but for zeros: 17 and 18.
  struct Item {
    std::uint8_t code, extra, bits;
  };
  std::vector<Item> items;
  for (std::size_t k = 0; k < lengths.size();) {
    std::size_t run = 0;
    while (k + run < lengths.size() && lengths[k + run] == 0 && run < 138) ++run;
    if (run >= 11) {
      items.push_back({18, static_cast<std::uint8_t>(run - 11), 7});
    } else if (run >= 3) {
      items.push_back({17, static_cast<std::uint8_t>(run - 3), 3});
    } else {
      items.push_back({lengths[k], 0, 0});
      run = 1;
    }
    k += run;
  }
  std::vector<std::uint32_t> count(19, 0);
  for (const Item& item : items) ++count[item.code];
  const Code code = code_for(count, 7);
  std::size_t sent = 19;
  while (sent > 4 && code.length[kCodeLengthOrder[sent - 1]] == 0) --sent;
  out.put(static_cast<std::uint32_t>(sent - 4), 4);
  for (std::size_t k = 0; k < sent; ++k) out.put(code.length[kCodeLengthOrder[k]], 3);
  for (const Item& item : items) {
    out.put(code.bits[item.code], code.length[item.code]);
    out.put(item.extra, item.bits);
  }
}

void write_block(const std::vector<Symbol>& symbols, bool last, BitWriter& out) {
  std::vector<std::uint32_t> literals(286, 0), distances(30, 0);
  literals[kEndOfBlock] = 1;
  for (const Symbol& s : symbols) {
    if (s.distance == 0) {
      ++literals[s.value];
    } else {
      ++literals[257 + code_of(kMatchLengths, s.value)];
      ++distances[code_of(kMatchDistances, s.distance)];
    }
  }
  // A distance code must have at least one length.
  if (*std::max_element(distances.begin(), distances.end()) == 0) distances[0] = 1;
  const Code literal = code_for(literals, 15);
  const Code distance = code_for(distances, 15);

  out.put(last ? 1 : 0, 1);
  out.put(2, 2);
  out.put(286 - 257, 5);
  out.put(30 - 1, 5);
  std::vector<std::uint8_t> lengths = literal.length;
  lengths.insert(lengths.end(), distance.length.begin(), distance.length.end());
  write_code_lengths(lengths, out);
  for (const Symbol& s : symbols) {
    if (s.distance == 0) {
      out.put(literal.bits[s.value], literal.length[s.value]);
      continue;
    }
    const std::size_t l = code_of(kMatchLengths, s.value);
    out.put(literal.bits[257 + l], literal.length[257 + l]);
    out.put(s.value - kMatchLengths[l].base, kMatchLengths[l].extra);
    const std::size_t d = code_of(kMatchDistances, s.distance);
    out.put(distance.bits[d], distance.length[d]);
    out.put(static_cast<std::uint32_t>(s.distance) - kMatchDistances[d].base,
            kMatchDistances[d].extra);
  }
  out.put(literal.bits[kEndOfBlock], literal.length[kEndOfBlock]);
}

// Earlier places with the same first three bytes, the nearest first.
class Chains {
 public:
  explicit Chains(std::string_view bytes) : bytes_(bytes), head_(kTable, kNone) {
    before_.resize(std::min(kWindow, bytes.size()), kNone);
  }

  void insert(std::size_t at) {
    if (at + kLeastMatch > bytes_.size()) return;
    std::uint32_t& head = head_[hash(at)];
    before_[at % before_.size()] = head;
    head = static_cast<std::uint32_t>(at);
  }

  // The longest match for what begins at `at`; length 0 if there is none.
  [[nodiscard]] Symbol find(std::size_t at) const {
    Symbol best;
    if (at + kLeastMatch > bytes_.size()) return best;
    const std::size_t most = std::min(kLongestMatch, bytes_.size() - at);
    std::uint32_t place = head_[hash(at)];
    for (std::size_t k = 0; k < kMostTries && place != kNone; ++k) {
      if (at - place > kWindow) break;
      std::size_t length = 0;
      while (length < most && bytes_[place + length] == bytes_[at + length]) ++length;
      const bool pays = length > kLeastMatch + 1 || (length >= kLeastMatch && at - place <= kNear);
      if (pays && length > best.value) {
        best = {static_cast<std::uint16_t>(length), static_cast<std::uint16_t>(at - place)};
        if (length == most) break;
      }
      const std::uint32_t next = before_[place % before_.size()];
      if (next == kNone || next >= place) break;  // overwritten
      place = next;
    }
    return best;
  }

 private:
  static constexpr std::size_t kTable = std::size_t{1} << 15;
  static constexpr std::uint32_t kNone = 0xFFFFFFFFU;

  [[nodiscard]] std::size_t hash(std::size_t at) const {
    std::uint32_t word = 0;
    for (std::size_t k = 0; k < kLeastMatch; ++k) {
      word = word << 8 | static_cast<unsigned char>(bytes_[at + k]);
    }
    return word * 2654435761U >> 17;
  }

  std::string_view bytes_;
  std::vector<std::uint32_t> head_, before_;
};

}  // namespace

std::string deflated(std::string_view bytes) {
  std::string out;
  BitWriter writer(out);
  Chains chains(bytes);
  std::vector<Symbol> symbols;
  for (std::size_t at = 0; at < bytes.size();) {
    const Symbol match = chains.find(at);
    chains.insert(at);
    std::size_t step = match.value;
    // A longer match that begins with the next byte is worth a literal more.
    if (step == 0 || (step < kLongEnough && chains.find(at + 1).value > step)) {
      symbols.push_back({static_cast<unsigned char>(bytes[at]), 0});
      step = 1;
    } else {
      symbols.push_back(match);
      for (std::size_t k = 1; k < step; ++k) chains.insert(at + k);
    }
    at += step;
    if (symbols.size() == kBlockSymbols && at < bytes.size()) {
      write_block(symbols, false, writer);
      symbols.clear();
    }
  }
  write_block(symbols, true, writer);
  writer.flush();
  return out;
}

std::string zlib_compressed(std::string_view bytes) {
  std::string out = "\x78\x9c" + deflated(bytes);
  const std::uint32_t sum = adler32(kAdlerOfNothing, bytes);
  for (int shift = 24; shift >= 0; shift -= 8) out += static_cast<char>(sum >> shift & 0xFFU);
  return out;
}

}  // namespace tetloft::internal::io

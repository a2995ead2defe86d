// Records: values as bytes that another program, on another machine, reads back.
//
// A record is "tetloft", a zero byte, four letters that say what it holds, the version of that (32
// bits), the length of its contents (64 bits), the contents, and the checksum of all before (64
// bits, FNV-1a); numbers are little-endian, floating-point numbers the bits of IEEE 754. What is
// not a record, damaged, cut off, of another kind or of a later version is refused, naming the
// reason; contents are read within their bounds whatever they hold.
#pragma once

#include <concepts>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include <tetloft/ids.hpp>
#include <tetloft/result.hpp>

#include "core/little_endian.hpp"

namespace tetloft::internal {

/// What a record holds.
struct RecordKind {
  std::string_view letters;  ///< four
  std::uint32_t version = 1;
  std::string_view name;  ///< for messages: "a plan"
};

class RecordWriter {
 public:
  explicit RecordWriter(const RecordKind& kind);

  template <class T>
  requires std::is_arithmetic_v<T>
  void put(T value) { append_little(bytes_, value); }
  template <class Tag>
  void put(Id<Tag> id) {
    append_little(bytes_, id.value());
  }
  /// The number of items that follow.
  void put_count(std::size_t n) { put(static_cast<std::uint64_t>(n)); }
  /// The number of elements and each of them.
  template <class Range>
  void put_all(const Range& range) {
    put_count(range.size());
    for (const auto& item : range) put(item);
  }

  /// The number of bytes, and they.
  void put_text(std::string_view text) {
    put_count(text.size());
    bytes_.append(text);
  }

  [[nodiscard]] std::string take();
  [[nodiscard]] std::vector<std::byte> take_bytes();

 private:
  std::string bytes_;
};

/// Whether bytes begin as a record of this kind does, whatever comes behind.
[[nodiscard]] bool begins_as(std::string_view bytes, const RecordKind& kind);

class RecordReader {
 public:
  /// `name` stands for the file in messages.
  RecordReader(std::string_view bytes, const RecordKind& kind, std::string name);
  /// Of no file.
  RecordReader(std::span<const std::byte> bytes, const RecordKind& kind);

  /// The next value; 0 once the contents are at their end or were refused.
  template <class T>
  requires std::is_arithmetic_v<T>
  [[nodiscard]] T get() {
    if (left_.size() < sizeof(T)) {
      refuse("ends too early");
      return T{};
    }
    const T value = load_little<T>(left_.data());
    left_.remove_prefix(sizeof(T));
    return value;
  }
  template <class T>
  requires requires(T id) { id.valid(); }
  [[nodiscard]] T get() { return T(get<std::uint32_t>()); }
  /// A number of items of at least so many bytes each, for which there is room; else 0.
  [[nodiscard]] std::size_t get_count(std::size_t bytes_each);
  /// Elements as put_all() writes them.
  template <class T>
  [[nodiscard]] std::vector<T> get_all() {
    std::vector<T> items(get_count(size_of<T>()));
    for (auto&& item : items) item = get<T>();
    return items;
  }

  /// Bytes as put_text() writes them.
  [[nodiscard]] std::string get_text() {
    const std::size_t size = get_count(1);
    std::string text(left_.substr(0, size));
    left_.remove_prefix(size);
    return text;
  }

  /// Refuses the record; the first reason counts.
  void refuse(std::string_view reason);
  void require(bool condition, std::string_view reason) {
    if (!condition) refuse(reason);
  }
  [[nodiscard]] bool refused() const { return refused_; }
  /// Nothing if all was read and nothing refused; else the error.
  [[nodiscard]] Result<void> end();

 private:
  template <class T>
  static constexpr std::size_t size_of() {
    if constexpr (std::is_arithmetic_v<T>) {
      return sizeof(T);
    } else {
      return sizeof(std::uint32_t);
    }
  }

  std::string_view left_;
  RecordKind kind_;
  std::string name_;
  bool refused_ = false;
  Error error_;
};

}  // namespace tetloft::internal

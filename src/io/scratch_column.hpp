// Numbers in scratch files: appended, and read back in order.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/little_endian.hpp"
#include "io/scratch_file.hpp"

namespace tetloft::internal::io {

template <class T>
class ScratchColumn {
 public:
  explicit ScratchColumn(const std::string& path) : file_(path) {}

  void push_back(T value) {
    store_little<T>(last_.data() + count_ * sizeof(T), value);
    if (++count_ == kAtOnce) put_away();
  }
  [[nodiscard]] std::size_t size() const {
    return static_cast<std::size_t>(file_.size() / sizeof(T)) + count_;
  }
  void cut(std::size_t size) {
    put_away();
    file_.cut(std::uint64_t{size} * sizeof(T));
  }
  /// Of what was put away: the last values are not, before they are read.
  [[nodiscard]] const std::optional<Error>& failure() const { return file_.failure(); }

  /// All values, as little-endian bytes.
  void append_to(Sink& sink) {
    put_away();
    std::vector<char> bytes(std::size_t{1} << 16);
    for (std::uint64_t at = 0; at < file_.size(); at += bytes.size()) {
      bytes.resize(std::min<std::uint64_t>(bytes.size(), file_.size() - at));
      file_.read(at, bytes);
      sink.append({bytes.data(), bytes.size()});
    }
  }

  /// The values from `first` to `end`, all of which must be there.
  [[nodiscard]] std::vector<T> values(std::size_t first, std::size_t end) {
    put_away();
    std::vector<char> bytes((end - first) * sizeof(T));
    file_.read(std::uint64_t{first} * sizeof(T), bytes);
    std::vector<T> values(end - first);
    for (std::size_t k = 0; k < values.size(); ++k) {
      values[k] = load_little<T>(bytes.data() + k * sizeof(T));
    }
    return values;
  }

 private:
  static constexpr std::size_t kAtOnce = 512;

  void put_away() {
    file_.append({last_.data(), count_ * sizeof(T)});
    count_ = 0;
  }

  ScratchFile file_;
  std::array<char, kAtOnce * sizeof(T)> last_;
  std::size_t count_ = 0;  // of values there
};

/// Columns one behind the other as one sequence, of which a stretch is in memory. They must outlive
/// it, and do not change meanwhile.
template <class T>
class ScratchSequence {
 public:
  explicit ScratchSequence(std::vector<ScratchColumn<T>*> columns) : columns_(std::move(columns)) {
    for (const ScratchColumn<T>* column : columns_) size_ += column->size();
  }

  [[nodiscard]] std::size_t size() const { return size_; }
  /// Cheap where i is not far from the one before.
  [[nodiscard]] T at(std::size_t i) {
    if (i < first_ || i - first_ >= loaded_.size()) load(i);
    return loaded_[i - first_];
  }

 private:
  static constexpr std::size_t kStretch = std::size_t{1} << 13;

  void load(std::size_t i) {
    std::size_t before = 0;
    for (ScratchColumn<T>* column : columns_) {
      if (i - before < column->size()) {
        const std::size_t first = (i - before) / kStretch * kStretch;
        first_ = before + first;
        loaded_ = column->values(first, std::min(first + kStretch, column->size()));
        return;
      }
      before += column->size();
    }
  }

  std::vector<ScratchColumn<T>*> columns_;
  std::size_t size_ = 0;
  std::size_t first_ = 0;
  std::vector<T> loaded_;
};

}  // namespace tetloft::internal::io

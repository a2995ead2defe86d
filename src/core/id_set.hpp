// Sets of a few ids.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace tetloft::internal {

/// A few ids, each once, in the order in which they came.
template <class IdType>
class IdSet {
 public:
  /// False where it was there.
  bool insert(IdType id) {
    if (ids_.empty()) ids_.reserve(kFirstTable / 2);
    if (2 * (ids_.size() + 1) > mask_ + 1) grow();
    IdType* const table = this->table();
    std::size_t at = place(id);
    for (; table[at].valid(); at = (at + 1) & mask_) {
      if (table[at] == id) return false;
    }
    ids_.push_back(id);
    table[at] = id;
    return true;
  }
  [[nodiscard]] bool contains(IdType id) const {
    const IdType* const table = large_.empty() ? first_.data() : large_.data();
    for (std::size_t at = place(id); table[at].valid(); at = (at + 1) & mask_) {
      if (table[at] == id) return true;
    }
    return false;
  }
  [[nodiscard]] const std::vector<IdType>& ids() const { return ids_; }
  void clear() {
    IdType* const table = this->table();
    for (const IdType id : ids_) {
      for (std::size_t at = place(id); table[at].valid(); at = (at + 1) & mask_) {
        table[at] = IdType();
      }
    }
    ids_.clear();
  }

 private:
  static constexpr std::size_t kFirstTable = 128;  // a star has 27 tets, on average
  [[nodiscard]] std::size_t place(IdType id) const {
    // Fibonacci hashing (Knuth, TAOCP 3, 6.4).
    return static_cast<std::size_t>(id.value() * std::uint64_t{0x9E37'79B9'7F4A'7C15U} >> 32) &
           mask_;
  }
  [[nodiscard]] IdType* table() { return large_.empty() ? first_.data() : large_.data(); }
  void grow() {
    large_.assign(2 * (mask_ + 1), IdType());
    mask_ = large_.size() - 1;
    for (const IdType id : ids_) {
      std::size_t at = place(id);
      while (large_[at].valid()) at = (at + 1) & mask_;
      large_[at] = id;
    }
  }

  std::vector<IdType> ids_;
  // The table, of mask_ + 1 places: in the set itself while it is small, as most stars are.
  std::array<IdType, kFirstTable> first_{};
  std::vector<IdType> large_;
  std::size_t mask_ = kFirstTable - 1;
};

}  // namespace tetloft::internal

// Sets of a few ids.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace tetloft::internal {

/// A few ids, each once, in the order in which they came.
template <class IdType>
class IdSet {
 public:
  IdSet() : table_(kFirstTable) {}

  /// False where it was there.
  bool insert(IdType id) {
    if (2 * (ids_.size() + 1) > table_.size()) grow();
    std::size_t at = place(id);
    for (; table_[at].valid(); at = (at + 1) & (table_.size() - 1)) {
      if (table_[at] == id) return false;
    }
    ids_.push_back(id);
    table_[at] = id;
    return true;
  }
  [[nodiscard]] bool contains(IdType id) const {
    for (std::size_t at = place(id); table_[at].valid(); at = (at + 1) & (table_.size() - 1)) {
      if (table_[at] == id) return true;
    }
    return false;
  }
  [[nodiscard]] const std::vector<IdType>& ids() const { return ids_; }
  void clear() {
    for (const IdType id : ids_) {
      for (std::size_t at = place(id); table_[at].valid(); at = (at + 1) & (table_.size() - 1)) {
        table_[at] = IdType();
      }
    }
    ids_.clear();
  }

 private:
  static constexpr std::size_t kFirstTable = 128;  // a star has 27 tets, on average
  [[nodiscard]] std::size_t place(IdType id) const {
    // Fibonacci hashing (Knuth, TAOCP 3, 6.4).
    return static_cast<std::size_t>(id.value() * std::uint64_t{0x9E37'79B9'7F4A'7C15U} >> 32) &
           (table_.size() - 1);
  }
  void grow() {
    table_.assign(2 * table_.size(), IdType());
    for (const IdType id : ids_) {
      std::size_t at = place(id);
      while (table_[at].valid()) at = (at + 1) & (table_.size() - 1);
      table_[at] = id;
    }
  }

  std::vector<IdType> ids_;
  std::vector<IdType> table_;
};

}  // namespace tetloft::internal

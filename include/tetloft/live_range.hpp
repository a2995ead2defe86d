// Ranges over the places of a triangulation that changes.
#pragma once

#include <cstddef>
#include <iterator>

namespace tetloft {

/// The live ones among numbered places: a forward range.
template <class Triangulation, class Item>
class LiveRange {
 public:
  class Iterator {
   public:
    using value_type = Item;
    using difference_type = std::ptrdiff_t;

    Iterator() = default;
    Iterator(const Triangulation* of, std::size_t at) : of_(of), at_(at) { skip(); }
    [[nodiscard]] Item operator*() const { return of_->item_at(at_, Item()); }
    Iterator& operator++() {
      ++at_;
      skip();
      return *this;
    }
    Iterator operator++(int) {
      Iterator before = *this;
      ++*this;
      return before;
    }
    friend bool operator==(const Iterator&, const Iterator&) = default;

   private:
    void skip() {
      while (at_ < of_->places(Item()) && !of_->item_at(at_, Item()).valid()) ++at_;
    }
    const Triangulation* of_ = nullptr;
    std::size_t at_ = 0;
  };

  explicit LiveRange(const Triangulation& of) : of_(&of) {}
  [[nodiscard]] Iterator begin() const { return Iterator(of_, 0); }
  [[nodiscard]] Iterator end() const { return Iterator(of_, of_->places(Item())); }

 private:
  const Triangulation* of_;
};

}  // namespace tetloft

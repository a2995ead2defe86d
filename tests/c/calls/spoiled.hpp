// A good handle of each kind, one that was freed, and others that are none.
#pragma once

#include <array>
#include <cstdint>
#include <new>

#include "c/calls/arguments.hpp"

namespace tetloft::c_test {

class RightHandles {
 public:
  RightHandles() {
    for (int k = 0; k < kKinds; ++k) {
      const Kind kind = static_cast<Kind>(k);
      good_[static_cast<std::size_t>(k)] = new_handle(kind);
      freed_[static_cast<std::size_t>(k)] = new_handle(kind);
      free_handle(kind, freed_[static_cast<std::size_t>(k)]);
    }
  }
  ~RightHandles() {
    for (int k = 0; k < kKinds; ++k) {
      free_handle(static_cast<Kind>(k), good_[static_cast<std::size_t>(k)]);
    }
  }
  RightHandles(const RightHandles&) = delete;
  RightHandles& operator=(const RightHandles&) = delete;

  [[nodiscard]] void* good(Kind kind) const { return good_[static_cast<std::size_t>(kind)]; }

  /// 0 to 5: freed, of another kind, a small number, an address, the largest number, the next one.
  [[nodiscard]] void* wrong(Kind kind, std::size_t which) const {
    const auto k = static_cast<std::size_t>(kind);
    switch (which) {
      case 0: return freed_[k];
      case 1: return good_[(k + 1) % kKinds];
      case 2: return reinterpret_cast<void*>(std::uintptr_t{1});
      case 3: return const_cast<RightHandles*>(this);
      case 4: return reinterpret_cast<void*>(~std::uintptr_t{0});
      default: return reinterpret_cast<void*>(reinterpret_cast<std::uintptr_t>(good_[k]) + 1);
    }
  }

 private:
  std::array<void*, kKinds> good_{};
  std::array<void*, kKinds> freed_{};
};

/// Right arguments, but for one at most.
class SpoiledArguments : public Arguments {
 public:
  /// Request `request` gets its variant `variant`; by default all are right.
  SpoiledArguments(const RightHandles& handles, std::string folder,
                   std::size_t request = static_cast<std::size_t>(-1), std::size_t variant = 0)
      : Arguments(std::move(folder)), handles_(handles), request_(request), variant_(variant) {}

  /// What each variant of each request so far must come to.
  [[nodiscard]] const std::vector<std::vector<Expected>>& requests() const { return requests_; }

 protected:
  std::size_t choose(std::initializer_list<Expected> expected) override {
    requests_.emplace_back(expected);
    return requests_.size() - 1 == request_ ? variant_ : 0;
  }
  void* right_handle(Kind kind) override { return handles_.good(kind); }
  void* wrong_handle(Kind kind, std::size_t which) override { return handles_.wrong(kind, which); }

 private:
  const RightHandles& handles_;
  std::size_t request_;
  std::size_t variant_;
  std::vector<std::vector<Expected>> requests_;
};

}  // namespace tetloft::c_test

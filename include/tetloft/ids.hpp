// Strong 32-bit ids and the vectors they index.
//
// An id names an element of one flat array; ids of different arrays do not mix:
// `VertexId == TetId` does not compile. A default-constructed id is invalid. Arrays of 2^32 − 1
// elements or more cannot be indexed: making an id of a number too large for one throws
// std::out_of_range, which functions that return a Result turn into ErrorCode::internal.
#pragma once

#include <array>
#include <compare>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <type_traits>
#include <utility>
#include <vector>

#include <tetloft/export.hpp>

namespace tetloft {

/// Throws std::out_of_range: a number that 32 bits do not hold is no id.
[[noreturn]] TETLOFT_API void throw_no_id();

template <class Tag>
class Id {
 public:
  using Value = std::uint32_t;
  static constexpr Value kInvalid = 0xFFFFFFFFU;

  constexpr Id() = default;
  template <std::integral I>
  constexpr explicit Id(I value) : value_(static_cast<Value>(value)) {
    // What fits in a Value by its type costs nothing; negative numbers are large ones here.
    if constexpr (std::is_signed_v<I> || sizeof(I) > sizeof(Value)) {
      if (static_cast<std::uint64_t>(value) >= kInvalid) throw_no_id();
    }
  }

  [[nodiscard]] constexpr bool valid() const { return value_ != kInvalid; }
  [[nodiscard]] constexpr Value value() const { return value_; }
  [[nodiscard]] constexpr std::size_t index() const { return value_; }

  friend constexpr auto operator<=>(Id, Id) = default;

 private:
  Value value_ = kInvalid;
};

/// A vertex of a mesh, and so of a model.
using VertexId = Id<struct VertexTag>;
/// A vertex of a triangulation of the plane, and so of a conforming section.
using PlaneVertexId = Id<struct PlaneVertexTag>;
/// A tetrahedron.
using TetId = Id<struct TetTag>;
/// A half-face: face i (opposite vertex i) of tet t, numbered 4 t + i.
using HalfFaceId = Id<struct HalfFaceTag>;
/// A triangle of a plane triangulation or of a surface.
using TriangleId = Id<struct TriangleTag>;
/// An undirected edge of a plane triangulation.
using EdgeId = Id<struct EdgeTag>;
/// A contour of one section, in input order.
using ContourId = Id<struct ContourTag>;
/// A connected region of one section: an outer contour with its immediate holes.
using RegionId = Id<struct RegionTag>;
/// A section of a stack, by increasing z.
using SectionId = Id<struct SectionTag>;
/// A slab: SlabId i lies between sections i and i + 1.
using SlabId = Id<struct SlabTag>;
/// A connected component of the object.
using ComponentId = Id<struct ComponentTag>;

using TetVertices = std::array<VertexId, 4>;
using TriangleVertices = std::array<VertexId, 3>;
using PlaneTriangleVertices = std::array<PlaneVertexId, 3>;
/// The ids 0 … n − 1, for range-based loops.
template <class IdType>
class IdRange {
 public:
  class Iterator {
   public:
    explicit constexpr Iterator(std::size_t at) : at_(at) {}
    [[nodiscard]] constexpr IdType operator*() const {
      return IdType(static_cast<typename IdType::Value>(at_));
    }
    constexpr Iterator& operator++() {
      ++at_;
      return *this;
    }
    friend constexpr bool operator==(const Iterator&, const Iterator&) = default;

   private:
    std::size_t at_;
  };

  explicit constexpr IdRange(std::size_t n) : n_(n) {}
  [[nodiscard]] constexpr Iterator begin() const { return Iterator(0); }
  [[nodiscard]] constexpr Iterator end() const { return Iterator(n_); }

 private:
  std::size_t n_;
};

/// A std::vector indexed by one kind of id only.
template <class IdType, class T>
class IdVector {
 public:
  IdVector() = default;
  explicit IdVector(std::size_t n) : data_(n) {}
  IdVector(std::size_t n, const T& value) : data_(n, value) {}
  explicit IdVector(std::vector<T> data) : data_(std::move(data)) {}

  [[nodiscard]] decltype(auto) operator[](IdType id) { return data_[id.index()]; }
  [[nodiscard]] decltype(auto) operator[](IdType id) const { return data_[id.index()]; }

  [[nodiscard]] std::size_t size() const { return data_.size(); }
  [[nodiscard]] bool empty() const { return data_.empty(); }
  [[nodiscard]] IdType end_id() const { return IdType(data_.size()); }
  [[nodiscard]] IdRange<IdType> ids() const { return IdRange<IdType>(data_.size()); }

  /// Appends `value`; returns the id it got.
  IdType push_back(const T& value) {
    data_.push_back(value);
    return IdType(data_.size() - 1);
  }
  IdType push_back(T&& value) {
    data_.push_back(std::move(value));
    return IdType(data_.size() - 1);
  }
  void resize(std::size_t n) { data_.resize(n); }
  void resize(std::size_t n, const T& value) { data_.resize(n, value); }
  void assign(std::size_t n, const T& value) { data_.assign(n, value); }
  void reserve(std::size_t n) { data_.reserve(n); }
  void clear() { data_.clear(); }

  [[nodiscard]] auto begin() { return data_.begin(); }
  [[nodiscard]] auto end() { return data_.end(); }
  [[nodiscard]] auto begin() const { return data_.begin(); }
  [[nodiscard]] auto end() const { return data_.end(); }

  /// The underlying vector, for bulk work that needs no ids.
  [[nodiscard]] std::vector<T>& raw() { return data_; }
  [[nodiscard]] const std::vector<T>& raw() const { return data_; }

  friend bool operator==(const IdVector&, const IdVector&) = default;

 private:
  std::vector<T> data_;
};

}  // namespace tetloft

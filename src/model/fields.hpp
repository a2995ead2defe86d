// The data that a model carries about its points and tets, once: every reader, writer and check of
// it goes through this list. In files an id is an Int32, −1 where it is invalid, a count an Int32,
// an enumeration or a yes or no a UInt8, and a number, which is finite, a Float64.
#pragma once

#include <cmath>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <string_view>
#include <type_traits>

#include <tetloft/model.hpp>

#include "core/enums.hpp"

namespace tetloft::internal {

/// How values of one type are stored: as what, and which numbers are values.
template <class Value>
struct StoredAs;

template <class Tag>
struct StoredAs<Id<Tag>> {
  using Type = std::int32_t;
  static constexpr std::int64_t kLeast = -1;
  static constexpr std::int64_t kLargest = std::numeric_limits<Type>::max();
  static Type store(Id<Tag> id) { return static_cast<Type>(id.value()); }
  static Id<Tag> load(std::int64_t value) { return value < 0 ? Id<Tag>() : Id<Tag>(value); }
  static bool legal(Id<Tag>) { return true; }
};

template <class Enum, int kCount>
struct StoredEnum {
  using Type = std::uint8_t;
  static constexpr std::int64_t kLeast = 0;
  static constexpr std::int64_t kLargest = kCount - 1;
  static Type store(Enum value) { return static_cast<Type>(value); }
  static Enum load(std::int64_t value) { return static_cast<Enum>(value); }
  static bool legal(Enum value) { return is_enumerator(value, static_cast<Enum>(kCount - 1)); }
};
template <>
struct StoredAs<TetKind> : StoredEnum<TetKind, kTetKinds> {};
template <>
struct StoredAs<PointOrigin> : StoredEnum<PointOrigin, kPointOrigins> {};
template <>
struct StoredAs<Evidence> : StoredEnum<Evidence, kEvidences> {};
template <>
struct StoredAs<LinkFate> : StoredEnum<LinkFate, kLinkFates> {};
template <>
struct StoredAs<VoidPlanes> : StoredEnum<VoidPlanes, kVoidPlanes> {};

template <>
struct StoredAs<bool> {
  using Type = std::uint8_t;
  static constexpr std::int64_t kLeast = 0;
  static constexpr std::int64_t kLargest = 1;
  static Type store(bool value) { return value ? 1 : 0; }
  static bool load(std::int64_t value) { return value != 0; }
  static bool legal(bool) { return true; }
};

template <>
struct StoredAs<std::int32_t> {
  using Type = std::int32_t;
  static constexpr std::int64_t kLeast = std::numeric_limits<Type>::min();
  static constexpr std::int64_t kLargest = std::numeric_limits<Type>::max();
  static Type store(std::int32_t value) { return value; }
  static std::int32_t load(std::int64_t value) { return static_cast<std::int32_t>(value); }
  static bool legal(std::int32_t) { return true; }
};

template <>
struct StoredAs<double> {
  using Type = double;
  static double store(double value) { return value; }
  static double load(double value) { return value; }
  static bool legal(double value) { return std::isfinite(value); }
};

/// One array of the model, by tet or by point; empty where the model has none.
template <class Index, class V>
struct ModelField {
  using Value = V;
  using Stored = StoredAs<V>;
  static constexpr bool kOfPoints = std::same_as<Index, VertexId>;

  std::string_view name;
  IdVector<Index, V> Model::*values;
  bool on_surfaces;  ///< kept where only the boundary is written

  constexpr ModelField(std::string_view its_name, IdVector<Index, V> Model::*its_values,
                       bool surfaces = false)
      : name(its_name), values(its_values), on_surfaces(surfaces) {}

  /// How many values there are where there are any.
  [[nodiscard]] static std::size_t due(const Model& model) {
    return kOfPoints ? model.points.size() : model.tets.size();
  }
};

/// visit(field), for each field in the order of this list.
template <class Visit>
void for_each_field(Visit&& visit) {
  visit(ModelField{"component", &Model::component, true});
  visit(ModelField{"slab", &Model::slab});
  visit(ModelField{"kind", &Model::kind});
  visit(ModelField{"section", &Model::section, true});
  visit(ModelField{"contour", &Model::contour, true});
  visit(ModelField{"origin", &Model::origin});
}

}  // namespace tetloft::internal

// Random smooth solids with known truth: implicit functions on a fine grid, and stacks of their
// sections at any spacing.
#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include <tetloft/correspondence.hpp>
#include <tetloft/sections.hpp>

namespace tetloft::bench {

enum class SolidKind : std::uint8_t {
  blobs,    ///< balls that melt into each other
  tubes,    ///< bent tubes of varying width, many of them oblique
  rings,    ///< tori in all positions
  plates,   ///< thick plates with pits, holes and cavities
  horns,    ///< a body with thin oblique horns
  bundles,  ///< rods side by side, nearly parallel, that do not touch
};
inline constexpr SolidKind kSolidKinds[] = {SolidKind::blobs, SolidKind::tubes,
                                            SolidKind::rings, SolidKind::plates,
                                            SolidKind::horns, SolidKind::bundles};
[[nodiscard]] std::string_view name_of(SolidKind kind);

/// A solid sampled on a grid of unit cells: inside where the value is negative. Outermost samples
/// are outside.
struct SampledSolid {
  std::size_t nx = 0, ny = 0, nz = 0;
  std::vector<float> value;  ///< by z, y, x
  [[nodiscard]] float at(std::size_t x, std::size_t y, std::size_t z) const {
    return value[(z * ny + y) * nx + x];
  }
  [[nodiscard]] bool inside(std::size_t x, std::size_t y, std::size_t z) const {
    return at(x, y, z) < 0;
  }
};

/// The same for the same kind, seed and size. `size`: samples along each axis, 32 at least.
[[nodiscard]] SampledSolid sample_solid(SolidKind kind, std::uint64_t seed, std::size_t size);

/// Volume, components (6-connected), cavities (18-connected outside) and handles of the solid, by
/// counting cells of its samples.
struct SolidTruth {
  double volume = 0;
  long components = 0;
  long cavities = 0;
  long genus = 0;  ///< handles, of all boundary surfaces
};
[[nodiscard]] SolidTruth truth_of(const SampledSolid& solid);

enum class Contouring : std::uint8_t {
  smooth,   ///< marching squares with linear interpolation
  lattice,  ///< marching squares of the inside/outside mask: vertices on half-integers
};

/// The sections at every `spacing`-th layer that holds a part of the solid, with what the solid
/// says of their regions.
struct SlicedSolid {
  SectionStack stack;
  /// By slab: for each region of the section below, then above (numbered as by nest()), the
  /// piece of the solid between the two planes that it belongs to.
  std::vector<std::vector<std::size_t>> piece;
};
[[nodiscard]] SlicedSolid slice(const SampledSolid& solid, std::size_t spacing,
                                Contouring contouring);

}  // namespace tetloft::bench

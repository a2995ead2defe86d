// What is known of the solids that stacks were cut from.
#pragma once

#include <filesystem>
#include <optional>

#include <tetloft/sections.hpp>

#include "comparison/triangle_mesh.hpp"
#include "corpus/solids.hpp"

namespace tetloft::bench {

/// Numbers to compare with; those not known are left out.
struct Truth {
  std::optional<long> components, cavities, genus;
  std::optional<double> volume;
  std::optional<TriangleMesh> surface;
};

/// The solid between the layers `first` and `last` alone: what is beyond the first and the last
/// section no method can know.
[[nodiscard]] SampledSolid clipped(const SampledSolid& solid, std::size_t first, std::size_t last);

/// Truth of the solid between the first and last section of a stack that slice() cut from it. Its
/// surface, and the volume in it, are those of the samples by marching tetrahedra.
[[nodiscard]] Truth truth_between_sections(const SampledSolid& solid, const SectionStack& stack);

/// From the flat .json beside a .cnt file, where there is one and it tells numbers. Its volume is
/// that of the whole solid, and left out.
[[nodiscard]] Truth truth_beside(std::filesystem::path path);

}  // namespace tetloft::bench

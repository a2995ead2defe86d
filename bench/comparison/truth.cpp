#include "comparison/truth.hpp"

#include <cmath>

#include "comparison/marching.hpp"
#include "stack_truth.hpp"

namespace tetloft::bench {

SampledSolid clipped(const SampledSolid& solid, std::size_t first, std::size_t last) {
  SampledSolid result = solid;
  const std::size_t layer = solid.nx * solid.ny;
  for (std::size_t k = 0; k < result.value.size(); ++k) {
    if (k / layer < first || k / layer > last) result.value[k] = 1;
  }
  return result;
}

Truth truth_between_sections(const SampledSolid& solid, const SectionStack& stack) {
  const auto first = static_cast<std::size_t>(stack.sections[SectionId(0)].z);
  const auto last =
      static_cast<std::size_t>(stack.sections[SectionId(stack.sections.size() - 1)].z);
  const SolidTruth counted = truth_of(clipped(solid, first, last));
  Truth truth{counted.components, counted.cavities, counted.genus, {}, {}};
  ScalarGrid grid{solid.nx, solid.ny, {0, 0}, 1, {}, {}};
  const auto layer = static_cast<std::ptrdiff_t>(solid.nx * solid.ny);
  for (std::size_t z = first; z <= last; ++z) grid.z.push_back(static_cast<double>(z));
  grid.value.assign(solid.value.begin() + static_cast<std::ptrdiff_t>(first) * layer,
                    solid.value.begin() + static_cast<std::ptrdiff_t>(last + 1) * layer);
  truth.surface = marching_tets(grid);
  truth.volume = enclosed_volume(*truth.surface);
  return truth;
}

Truth truth_beside(std::filesystem::path path) {
  const StackTruth read = read_stack_truth(std::move(path));
  const auto count = [](const std::optional<double>& value) -> std::optional<long> {
    if (!value || *value < 0) return std::nullopt;  // of open meshes the genus is no count
    return std::lround(*value);
  };
  return {count(read.components), count(read.cavities), count(read.genus), {}, {}};
}

}  // namespace tetloft::bench

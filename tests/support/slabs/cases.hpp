// What the tests of reconstruct share: stacks from text, slabs built by hand, and the
// demand that a model passes check.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <tetloft/check.hpp>
#include <tetloft/reconstruct.hpp>

#include "completion/completion.hpp"
#include "completion/complex.hpp"
#include "slab/classes.hpp"
#include "slab/slab.hpp"
#include "support/stacks/generate.hpp"

namespace tetloft::testing {

using namespace internal;

/// A stack from NUAGES text. Requires valid text.
[[nodiscard]] SectionStack stack_from(std::string_view text);
/// A file of the repository's data folder, by its path in it.
[[nodiscard]] SectionStack sample(const std::string& name);
[[nodiscard]] std::vector<Label> labels_from(std::string_view text);

/// Counter-clockwise, axis-parallel.
[[nodiscard]] Contour box(double x0, double y0, double x1, double y1);
/// Section i at z = i.
[[nodiscard]] SectionStack stack_of_boxes(const std::vector<std::vector<Contour>>& sections);

/// A slab of a stack with what it refers to; links by the overlap criterion.
struct SlabCase {
  ConformingSection lower;
  ConformingSection upper;
  std::vector<Link> links;
  std::optional<Slab> slab;
  std::optional<SlabClasses> classes;

  /// 1 for every class, or only for those that are not lone.
  [[nodiscard]] IdVector<ClassId, std::uint8_t> active(bool lone_too) const;
};

/// Slab k of the stack; null where one of its sections is empty.
[[nodiscard]] std::unique_ptr<SlabCase> slab_case(const SectionStack& stack, std::size_t k);
[[nodiscard]] std::unique_ptr<SlabCase> slab_case(const SectionStack& stack, std::size_t k,
                                                  std::vector<Link> links);

/// The slabs of one generated stack of each kind; `name` tells kind, seed and slab.
struct NamedSlab {
  std::string name;
  std::unique_ptr<SlabCase> built;
};
[[nodiscard]] std::vector<NamedSlab> generated_slabs(std::uint64_t first_seed, std::uint64_t seeds);

/// Reconstructs and checks; failures of either are failures of the test. The report of
/// check, and the result.
struct Checked {
  Reconstruction result;
  CheckReport report;
};
[[nodiscard]] std::optional<Checked> reconstruct_and_check(const SectionStack& stack,
                                                           const ReconstructOptions& options = {});

/// How often a rule fired.
[[nodiscard]] std::uint64_t fired(const Reconstruction& result, Rule rule);

/// Six times the volume of a tet, in long double.
[[nodiscard]] long double volume6(const Point3& a, const Point3& b, const Point3& c,
                                  const Point3& d);

}  // namespace tetloft::testing

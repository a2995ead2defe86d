// What follows from all that views of a model have shown: guarantees 4 and 5, and figures.
#pragma once

#include <optional>
#include <vector>

#include <tetloft/check.hpp>

#include "check/cavities.hpp"
#include "check/components.hpp"
#include "check/surfaces.hpp"
#include "check/topology.hpp"
#include "core/watched_work.hpp"

namespace tetloft::internal::checking {

/// What a model says of how it was made.
struct ModelTables {
  std::vector<RegionLink> links = {};
  std::vector<RegionMotion> motions = {};
  std::vector<VoidLink> void_links = {};
  std::vector<Deviation> deviations = {};
};

/// Finite, and sensible; and a valid stack.
[[nodiscard]] Result<void> check_arguments(const SectionStack& stack, const CheckOptions& options);

/// What is known of a stack, and then of a model of it.
class Conclusions {
 public:
  /// Requires a valid stack. All must outlive it.
  Conclusions(const SectionStack& stack, const CheckOptions& options)
      : stack_(stack), options_(options), numbers_(stack), voids_(stack) {}
  Conclusions(const Conclusions&) = delete;
  Conclusions& operator=(const Conclusions&) = delete;

  [[nodiscard]] const ContourNumbers& numbers() const { return numbers_; }
  [[nodiscard]] std::vector<std::size_t> region_at() const {
    return bounded_by(stack_, voids_.regions());
  }
  [[nodiscard]] std::vector<std::size_t> void_at() const {
    return bounded_by(stack_, voids_.voids());
  }

  /// Guarantee 4, and what is expected for 5. Takes two steps of the work.
  [[nodiscard]] Result<void> decide(const SolidComponents& components, const SectionStack& refined,
                                    const ModelTables& model, WatchedWork& work);

  /// The report; figures that views are measured for are the caller's.
  [[nodiscard]] CheckReport report(GuaranteeVerdict manifold, GuaranteeVerdict resampling,
                                   GuaranteeVerdict embedded,
                                   const std::vector<BoundarySurface>& surfaces,
                                   std::vector<SlabPart> parts, const ModelTables& model);

 private:
  [[nodiscard]] Result<void> expect_cavities(const Components::Expected& components,
                                             const ModelTables& model);
  [[nodiscard]] GuaranteeVerdict cavities(bool filled, const std::vector<BoundarySurface>& surfaces,
                                          const std::vector<SlabPart>& parts,
                                          const ModelTables& model);

  const SectionStack& stack_;
  const CheckOptions& options_;
  ContourNumbers numbers_;
  StackVoids voids_;
  GuaranteeVerdict components_;
  std::optional<ExpectedCavities> expected_;
  CheckReport report_;
};

}  // namespace tetloft::internal::checking

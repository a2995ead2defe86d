// Remedies that are known, told as warnings where a stack shows signs of needing them.
#pragma once

#include <optional>

#include <tetloft/model.hpp>

#include "correspondence/correspondence.hpp"
#include "reconstruct/prepare.hpp"

namespace tetloft::internal {

/// Contours of so few vertices, linked ones, that between them hardly anything of either can be
/// followed: refine().
[[nodiscard]] std::optional<Warning> hint_of_coarse_contours(const PreparedStack& prepared,
                                                             const Correspondence& decided);

/// Most regions meet none of a neighbouring section, as they lie or as they are moved: the gaps
/// are too large for them, or z has another unit.
[[nodiscard]] std::optional<Warning> hint_of_missing_partners(const PreparedStack& prepared,
                                                              const StackCandidates& candidates);

/// A slab of far more tets than its vertices call for: round contours of many vertices about nearly
/// the same centre, whose Voronoi diagrams are all but equal there: snap().
[[nodiscard]] std::optional<Warning> hint_of_many_tets(const PreparedStack& prepared,
                                                       const Model& model);

}  // namespace tetloft::internal

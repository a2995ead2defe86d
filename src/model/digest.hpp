// A number for all that a model says: of another model, with near certainty, another one.
#pragma once

#include <cstdint>

#include <tetloft/model.hpp>

namespace tetloft::internal {

/// Over points, tets, fields, tables, frame and description, which files keep; a zero without its
/// sign, and texts as UTF-8, as files have them. Where the bits of one number differ and all else
/// is the same, the digest certainly differs.
[[nodiscard]] std::uint64_t digest_of(const Model& model);

}  // namespace tetloft::internal

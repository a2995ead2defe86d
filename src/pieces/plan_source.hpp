// Whether a file is the one that a plan was made from, where reading all of it would cost more than
// what is to be done.
#pragma once

#include <cstdint>
#include <string>

#include <tetloft/pieces.hpp>

namespace tetloft::internal::pieces {

/// PlanSource::sampled of a file of so many bytes.
[[nodiscard]] Result<std::uint64_t> sampled_checksum(const std::string& path, std::uint64_t bytes);

}  // namespace tetloft::internal::pieces

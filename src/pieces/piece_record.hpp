// What a piece says of itself, beside its solid.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include <tetloft/report.hpp>

#include "reconstruct/settle.hpp"

namespace tetloft::internal::pieces {

inline constexpr std::uint32_t kPieceVersion = 1;

struct PieceRecord {
  std::uint64_t plan = 0;    ///< identity
  std::size_t sections = 0;  ///< of the whole stack
  std::size_t components = 0;
  SlabRange slabs;
  std::vector<ClusterSpan> clusters;
  IdVector<ComponentId, std::string> names;  ///< Model::component_names of the whole
  std::uint64_t digest = 0;                  ///< of its solid: model/digest.hpp
  /// Of its parts; what is told of a whole model is 0, and so are seconds: a piece that is built
  /// twice has the same bytes.
  ReconstructReport report;
};

[[nodiscard]] std::string to_record(const PieceRecord& piece);
[[nodiscard]] Result<PieceRecord> piece_from_record(std::string_view bytes,
                                                    const std::string& name);

}  // namespace tetloft::internal::pieces

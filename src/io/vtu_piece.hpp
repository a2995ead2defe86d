// A .vtu with bytes of its writer's own, as data of the whole grid: what joining needs of a part of
// a solid. Other readers pass over them.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include <tetloft/model.hpp>
#include <tetloft/result.hpp>

#include "io/format.hpp"
#include "io/stage.hpp"

namespace tetloft::internal::io {

inline constexpr std::string_view kPieceArray = "tetloft_piece";

/// As stage_model() of a .vtu, with these bytes. The model is well formed.
[[nodiscard]] Result<Staged> stage_piece(const std::string& path, const Model& model,
                                         std::string_view bytes, Encoding encoding,
                                         TemporaryWatcher* watcher = nullptr);

/// Whether a file is a .vtu that speaks of such bytes, well formed or not.
[[nodiscard]] bool names_piece(std::string_view file);

struct PieceBytes {
  std::string bytes;
  std::size_t points = 0;  ///< as the file announces them; no array is looked at
  std::size_t tets = 0;
};
/// The bytes alone; refused (invalid_input) where there are none.
[[nodiscard]] Result<PieceBytes> piece_bytes(std::string_view file, const std::string& name);

}  // namespace tetloft::internal::io

#include "mesh/tet_soup.hpp"

namespace tetloft::internal::mesh_detail {

std::optional<Error> refuse_tet(const TetVertices& tet, std::size_t vertex_count, TetId name) {
  for (std::size_t i = 0; i < 4; ++i) {
    if (tet[i].index() >= vertex_count) {
      return refusal("tet " + std::to_string(name.value()) + " names vertex " +
                     std::to_string(tet[i].value()) + " of " + std::to_string(vertex_count));
    }
    for (std::size_t j = 0; j < i; ++j) {
      if (tet[i] == tet[j]) {
        return refusal("tet " + std::to_string(name.value()) + " repeats vertex " +
                       std::to_string(tet[i].value()));
      }
    }
  }
  return std::nullopt;
}

Error refusal(std::string message) { return {ErrorCode::invalid_input, std::move(message), {}}; }

std::string face_text(const std::array<std::uint32_t, 3>& vertices) {
  std::string text = "face (";
  text += std::to_string(vertices[0]) + ", ";
  text += std::to_string(vertices[1]) + ", ";
  text += std::to_string(vertices[2]) + ")";
  return text;
}

}  // namespace tetloft::internal::mesh_detail

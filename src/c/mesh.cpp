// Tetrahedral meshes: star and link.
#include <tetloft/model.hpp>
#include <tetloft/tet_mesh.hpp>

#include <algorithm>

#include "c/arrays.hpp"
#include "c/handles.hpp"

namespace tetloft::internal::c {

namespace {

VertexId vertex_of(const TetMesh& mesh, std::uint32_t vertex) {
  require_index(vertex, mesh.vertex_count(), "vertex");
  return VertexId(vertex);
}

using EdgeEnds = std::array<VertexId, 2>;

EdgeEnds edge_of(const TetMesh& mesh, std::uint32_t a, std::uint32_t b) {
  const EdgeEnds ends{vertex_of(mesh, a), vertex_of(mesh, b)};
  if (a == b) fail_usage("an edge has two ends");
  return ends;
}

// Answers with what a query of the mesh finds, copied to the caller's array.
template <class Query, class Number>
tetloft_status answer_with(const tetloft_mesh* mesh, Number* array, std::size_t capacity,
                           std::size_t* count, const char* name, Query&& query) {
  clear(count);
  return answer([&] {
    const auto value = value_of_handle(mesh, "mesh");
    fill_array(query(*value), array, capacity, count, name);
  });
}

template <class Query>
tetloft_status answer_with_kind(const tetloft_mesh* mesh, tetloft_link_kind* kind, Query&& query) {
  clear(kind);
  return answer([&] {
    const auto value = value_of_handle(mesh, "mesh");
    require_output(kind, "kind");
    *kind = static_cast<tetloft_link_kind>(query(*value));
  });
}
static_assert(TETLOFT_LINK_DISC == static_cast<int>(LinkKind::disc) &&
              TETLOFT_LINK_SPHERE == static_cast<int>(LinkKind::sphere) &&
              TETLOFT_LINK_EMPTY == static_cast<int>(LinkKind::empty) &&
              TETLOFT_LINK_COMPONENTS == static_cast<int>(LinkKind::singular_components) &&
              TETLOFT_LINK_PINCH == static_cast<int>(LinkKind::singular_pinch) &&
              TETLOFT_LINK_HOLES == static_cast<int>(LinkKind::singular_holes));

}  // namespace

}  // namespace tetloft::internal::c

using namespace tetloft::internal::c;
using tetloft::TetMesh;

tetloft_status tetloft_mesh_create(size_t vertex_count, const uint32_t* tets, size_t tet_count,
                                   tetloft_mesh** mesh) {
  clear(mesh);
  return answer([&] {
    require_output(mesh, "mesh");
    require_countable(vertex_count);
    hand_out(mesh, value_of(TetMesh::from_tets(vertex_count, tets_of(tets, tet_count))));
  });
}

tetloft_status tetloft_model_mesh(const tetloft_model* model, tetloft_mesh** mesh) {
  clear(mesh);
  return answer([&] {
    const auto value = value_of_handle(model, "model");
    require_output(mesh, "mesh");
    hand_out(mesh, value_of(tetloft::half_faces(value->model)));
  });
}

tetloft_status tetloft_mesh_counts(const tetloft_mesh* mesh, size_t* vertices, size_t* tets) {
  clear(vertices, tets);
  return answer([&] {
    const auto value = value_of_handle(mesh, "mesh");
    put(vertices, value->vertex_count());
    put(tets, value->tet_count());
  });
}

tetloft_status tetloft_mesh_tets(const tetloft_mesh* mesh, const uint32_t** tets, size_t* count) {
  clear(tets);
  clear(count);
  return answer([&] { put_array(value_of_handle(mesh, "mesh")->tets(), tets, count); });
}

tetloft_status tetloft_mesh_opposites(const tetloft_mesh* mesh, const uint32_t** opposite,
                                      size_t* count) {
  clear(opposite);
  clear(count);
  return answer([&] { put_array(value_of_handle(mesh, "mesh")->opposites(), opposite, count); });
}

tetloft_status tetloft_mesh_star(const tetloft_mesh* mesh, uint32_t vertex, uint32_t* tets,
                                 size_t capacity, size_t* count) {
  return answer_with(mesh, tets, capacity, count, "tets",
                     [&](const TetMesh& m) { return m.star(vertex_of(m, vertex)); });
}

tetloft_status tetloft_mesh_edge_star(const tetloft_mesh* mesh, uint32_t a, uint32_t b,
                                      uint32_t* tets, size_t capacity, size_t* count) {
  return answer_with(mesh, tets, capacity, count, "tets", [&](const TetMesh& m) {
    const EdgeEnds ends = edge_of(m, a, b);
    return m.star(ends[0], ends[1]);
  });
}

tetloft_status tetloft_mesh_link(const tetloft_mesh* mesh, uint32_t vertex, uint32_t* triangles,
                                 size_t capacity, size_t* count) {
  return answer_with(mesh, triangles, capacity, count, "triangles",
                     [&](const TetMesh& m) { return m.link(vertex_of(m, vertex)); });
}

tetloft_status tetloft_mesh_edge_link(const tetloft_mesh* mesh, uint32_t a, uint32_t b,
                                      uint32_t* edges, size_t capacity, size_t* count) {
  return answer_with(mesh, edges, capacity, count, "edges", [&](const TetMesh& m) {
    const EdgeEnds ends = edge_of(m, a, b);
    return m.link(ends[0], ends[1]);
  });
}

tetloft_status tetloft_mesh_link_kind(const tetloft_mesh* mesh, uint32_t vertex,
                                      tetloft_link_kind* kind) {
  return answer_with_kind(mesh, kind,
                          [&](const TetMesh& m) { return m.classify_link(vertex_of(m, vertex)); });
}

tetloft_status tetloft_mesh_edge_link_kind(const tetloft_mesh* mesh, uint32_t a, uint32_t b,
                                           tetloft_link_kind* kind) {
  return answer_with_kind(mesh, kind, [&](const TetMesh& m) {
    const EdgeEnds ends = edge_of(m, a, b);
    return m.classify_link(ends[0], ends[1]);
  });
}

tetloft_status tetloft_mesh_singular_vertices(const tetloft_mesh* mesh, uint32_t* vertices,
                                              size_t capacity, size_t* count) {
  return answer_with(mesh, vertices, capacity, count, "vertices", [](const TetMesh& m) {
    std::vector<tetloft::VertexId> ids;
    for (const auto& singular : m.singular_vertices()) ids.push_back(singular.first);
    return ids;
  });
}

tetloft_status tetloft_mesh_boundary(const tetloft_mesh* mesh, uint32_t* half_faces,
                                     size_t capacity, size_t* count) {
  return answer_with(mesh, half_faces, capacity, count, "half_faces",
                     [](const TetMesh& m) { return m.boundary(); });
}

tetloft_status tetloft_mesh_free(tetloft_mesh* mesh) { return free_handle(mesh); }

// The half-face mesh under edits: valid after each, and queries equal to those by definition.
#include <algorithm>
#include <map>
#include <set>
#include <vector>

#include <tetloft/tet_mesh.hpp>

#include "fuzz/target.hpp"
#include "unit/mesh/link_oracle.hpp"

namespace tetloft::fuzz {
namespace {

constexpr std::size_t kVertices = 9;

std::vector<TetVertices> live_tets(const TetMesh& mesh) {
  std::vector<TetVertices> tets;
  for (std::size_t t = 0; t < mesh.tet_slots(); ++t) {
    if (mesh.is_live(TetId(t))) tets.push_back(mesh.vertices(TetId(t)));
  }
  return tets;
}

// A face as a set belongs to two tets at most, which see it from different sides: the
// condition for being added, by definition.
bool can_hold(std::vector<TetVertices> tets, const TetVertices& added) {
  tets.push_back(added);
  std::map<std::set<VertexId>, std::vector<bool>> sides;
  for (const TetVertices& t : tets) {
    for (const VertexId v : t) {
      if (v.index() >= kVertices) return false;
    }
    if (std::set<VertexId>(t.begin(), t.end()).size() != 4) return false;
    for (std::size_t i = 0; i < 4; ++i) {
      std::vector<VertexId> face;
      for (std::size_t k = 0; k < 4; ++k) {
        if (k != i) face.push_back(t[k]);
      }
      // The parity of sorting the face, and of its place in the tet.
      bool odd = i % 2 == 1;
      for (std::size_t a = 0; a < 3; ++a) {
        for (std::size_t b = a + 1; b < 3; ++b) odd = odd != (face[b] < face[a]);
      }
      sides[{face.begin(), face.end()}].push_back(odd);
    }
  }
  return std::all_of(sides.begin(), sides.end(), [](const auto& entry) {
    const std::vector<bool>& seen = entry.second;
    return seen.size() == 1 || (seen.size() == 2 && seen[0] != seen[1]);
  });
}

void check_queries(const TetMesh& mesh) {
  const std::vector<TetVertices> tets = live_tets(mesh);
  // Two tets of the same four vertices, inverse to each other, are no simplicial complex: the
  // oracle, which knows sets, does not apply.
  std::set<std::set<VertexId>> sets;
  for (const TetVertices& t : tets) sets.insert({t.begin(), t.end()});
  if (sets.size() != tets.size()) return;
  for (std::size_t v = 0; v < kVertices; ++v) {
    const auto link = mesh_test::link_of(tets, {VertexId(v)});
    require(mesh.star(VertexId(v)).size() == link.size(), "size of a star");
    require(mesh.classify_link(VertexId(v)) == mesh_test::oracle_kind_of_vertex_link(link),
            "kind of a vertex link");
    for (std::size_t w = 0; w < v; ++w) {
      const auto edge_link = mesh_test::link_of(tets, {VertexId(v), VertexId(w)});
      require(mesh.classify_link(VertexId(v), VertexId(w)) ==
                  mesh_test::oracle_kind_of_edge_link(edge_link),
              "kind of an edge link");
    }
  }
}

}  // namespace
}  // namespace tetloft::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace tetloft;
  using namespace tetloft::fuzz;
  if (size > 512) return 0;
  Bytes bytes(data, size);
  auto made = TetMesh::from_tets(kVertices, {});
  require(made.ok(), "an empty mesh is refused");
  TetMesh mesh = std::move(made.value());
  while (!bytes.empty()) {
    const std::uint8_t what = bytes.byte();
    if (what % 4 != 0) {
      TetVertices tet;
      const std::uint8_t ab = bytes.byte();
      const std::uint8_t cd = bytes.byte();
      tet = {VertexId(ab & 15), VertexId(ab >> 4), VertexId(cd & 15), VertexId(cd >> 4)};
      const bool possible = can_hold(live_tets(mesh), tet);
      const auto added = mesh.add_tet(tet);
      if (!added) require_clean(added.error());
      require(added.ok() == possible, "a tet is added that cannot be, or refused that can");
    } else if (what == 252) {
      const auto before = live_tets(mesh);
      mesh.compact();
      require(live_tets(mesh) == before, "compact changes tets");
    } else if (mesh.tet_slots() > 0) {
      const TetId t(bytes.below(mesh.tet_slots()));
      if (mesh.is_live(t)) mesh.remove_tet(t);
    }
    require(mesh.validate().empty(), "the mesh is not valid");
  }
  check_queries(mesh);
  return 0;
}

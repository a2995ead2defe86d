// Local edits: every condition holds after each, and the result is what from_tets builds.
#include "unit/mesh/meshes.hpp"

namespace tetloft::mesh_test {
namespace {

/// The live tets, and which tet lies across each face, independent of slots.
std::map<TetVertices, std::array<TetVertices, 4>> gluing(const TetMesh& mesh) {
  std::map<TetVertices, std::array<TetVertices, 4>> result;
  for (std::size_t t = 0; t < mesh.tet_slots(); ++t) {
    if (!mesh.is_live(TetId(t))) continue;
    std::array<TetVertices, 4>& across = result[mesh.vertices(TetId(t))];
    for (int i = 0; i < 4; ++i) {
      const TetId n = mesh.neighbour(TetId(t), i);
      if (n.valid()) across[static_cast<std::size_t>(i)] = mesh.vertices(n);
    }
  }
  return result;
}

Soup live_tets(const TetMesh& mesh) {
  Soup soup;
  for (std::size_t t = 0; t < mesh.tet_slots(); ++t) {
    if (mesh.is_live(TetId(t))) soup.push_back(mesh.vertices(TetId(t)));
  }
  return soup;
}

TEST(TetMeshEdit, RandomAddingAndRemovingKeepsEveryCondition) {
  Prng random(51);
  const Grid grid{2, 2, 1};
  const Soup all = grid.tets();
  TetMesh mesh = make(0, {});
  ASSERT_EQ(mesh.add_vertices(grid.vertices()), VertexId(0));
  int refused = 0;
  int accepted = 0;
  for (int round = 0; round < 1500; ++round) {
    const double growth = round % 300 < 150 ? 0.8 : 0.3;
    if (random.chance(growth)) {
      TetVertices t = all[random.below(all.size())];
      if (random.chance(0.1)) std::swap(t[0], t[1]);
      if (random.chance(0.1)) t[random.below(4)] = VertexId(random.below(grid.vertices() + 1));
      Soup with = live_tets(mesh);
      with.push_back(t);
      const bool possible = TetMesh::from_tets(grid.vertices(), with).ok();
      const Result<TetId> added = mesh.add_tet(t);
      ASSERT_EQ(added.ok(), possible) << "round " << round;
      ++(possible ? accepted : refused);
      if (added) {
        ASSERT_EQ(mesh.vertices(*added), t);
      } else {
        ASSERT_EQ(added.error().code, ErrorCode::invalid_input);
      }
    } else if (mesh.tet_count() > 0) {
      TetId t;
      do t = TetId(random.below(mesh.tet_slots()));
      while (!mesh.is_live(t));
      mesh.remove_tet(t);
      ASSERT_FALSE(mesh.is_live(t));
    }
    if (random.chance(0.02)) mesh.compact();
    ASSERT_VALID(mesh);
    ASSERT_EQ(gluing(mesh), gluing(make(grid.vertices(), live_tets(mesh)))) << "round " << round;
  }
  EXPECT_GT(accepted, 100);
  EXPECT_GT(refused, 100);
}

TEST(TetMeshEdit, StarsAreByIdAlsoAfterSlotsWereReused) {
  const Grid grid{1, 1, 1};
  TetMesh mesh = make(grid.vertices(), grid.tets());
  for (const std::size_t t : {0UL, 3UL, 1UL}) mesh.remove_tet(TetId(t));
  for (const std::size_t t : {3UL, 0UL, 1UL}) ASSERT_TRUE(mesh.add_tet(grid.tets()[t]).ok());
  EXPECT_EQ(mesh.tet_slots(), 6U);
  const std::vector<TetId> star = mesh.star(VertexId(0));
  EXPECT_EQ(star.size(), 6U);
  EXPECT_TRUE(std::is_sorted(star.begin(), star.end()));
}

TEST(TetMeshEdit, CompactKeepsOrderAndReturnsNewIds) {
  const Grid grid{1, 1, 1};
  TetMesh mesh = make(grid.vertices(), grid.tets());
  mesh.remove_tet(TetId(1));
  mesh.remove_tet(TetId(4));
  EXPECT_EQ(mesh.tet_count(), 4U);
  EXPECT_EQ(mesh.components()[TetId(1)], ComponentId());
  const Soup before = live_tets(mesh);
  const auto new_id = mesh.compact();
  EXPECT_EQ(new_id.raw(),
            (std::vector<TetId>{TetId(0), TetId(), TetId(1), TetId(2), TetId(), TetId(3)}));
  EXPECT_EQ(live_tets(mesh), before);
  EXPECT_EQ(mesh.tet_slots(), 4U);
  EXPECT_VALID(mesh);
}

TEST(TetMeshEdit, ArraysAreThoseOfTheSlots) {
  const Grid grid{1, 1, 1};
  TetMesh mesh = make(grid.vertices(), grid.tets());
  mesh.remove_tet(TetId(1));
  ASSERT_EQ(mesh.tets().size(), mesh.tet_slots());
  ASSERT_EQ(mesh.opposites().size(), 4 * mesh.tet_slots());
  std::size_t glued = 0;
  for (std::size_t t = 0; t < mesh.tet_slots(); ++t) {
    EXPECT_EQ(mesh.tets()[t][0].valid(), mesh.is_live(TetId(t)));
    EXPECT_EQ(mesh.tets()[t], mesh.vertices(TetId(t)));
    for (int i = 0; i < 4; ++i) {
      const HalfFaceId h = TetMesh::half_face(TetId(t), i);
      EXPECT_EQ(mesh.opposites()[h.index()], mesh.opposite(h));
      if (mesh.opposites()[h.index()].valid()) ++glued;
    }
  }
  EXPECT_GT(glued, 0U);
  EXPECT_TRUE(TetMesh().tets().empty());
  EXPECT_TRUE(TetMesh().opposites().empty());
}

TEST(TetMeshEdit, RefusedTetChangesNothing) {
  TetMesh mesh = make(6, {tet(0, 1, 2, 3), tet(0, 2, 1, 4)});
  const auto before = gluing(mesh);
  for (const TetVertices& t :
       {tet(0, 1, 2, 5), tet(5, 2, 1, 0), tet(1, 0, 3, 5), tet(0, 1, 1, 5), tet(0, 1, 2, 6)}) {
    EXPECT_FALSE(mesh.add_tet(t).ok());
  }
  EXPECT_EQ(gluing(mesh), before);
  EXPECT_VALID(mesh);
}

}  // namespace
}  // namespace tetloft::mesh_test

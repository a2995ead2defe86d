// validate() names each condition when it is broken, and reads nonsense in bounds.
#include "unit/mesh/meshes.hpp"

namespace tetloft {

struct TetMeshTestAccess {
  static std::vector<TetVertices>& tets(TetMesh& m) { return m.tets_; }
  static std::vector<HalfFaceId>& opposite(TetMesh& m) { return m.opposite_; }
  static std::vector<HalfFaceId>& first_corner(TetMesh& m) {
    return m.editable_corner_lists().first;
  }
  static std::vector<HalfFaceId>& next_corner(TetMesh& m) { return m.editable_corner_lists().next; }
  static std::vector<TetId>& free_list(TetMesh& m) { return m.free_; }
};

namespace mesh_test {
namespace {

using Access = TetMeshTestAccess;

TetMesh cube() {
  const Grid grid{1, 1, 1};
  return make(grid.vertices() + 1, grid.tets());
}

std::vector<int> conditions(const TetMesh& mesh) {
  std::vector<int> result;
  for (const MeshViolation& v : mesh.validate()) {
    result.push_back(v.condition);
    EXPECT_FALSE(v.message.empty());
  }
  return result;
}

bool violates(const TetMesh& mesh, int condition) {
  const std::vector<int> all = conditions(mesh);
  EXPECT_TRUE(std::is_sorted(all.begin(), all.end()));
  return std::count(all.begin(), all.end(), condition) == 1;
}

HalfFaceId glued_half_face(const TetMesh& mesh) {
  HalfFaceId h(0);
  while (!mesh.opposite(h).valid()) h = HalfFaceId(h.value() + 1);
  return h;
}

TEST(Validate, VertexOutOfRangeBreaks1) {
  TetMesh mesh = cube();
  Access::tets(mesh)[2][3] = VertexId(77);
  EXPECT_TRUE(violates(mesh, 1));
}

TEST(Validate, RepeatedVertexBreaks1) {
  TetMesh mesh = cube();
  Access::tets(mesh)[2][3] = Access::tets(mesh)[2][1];
  EXPECT_TRUE(violates(mesh, 1));
}

TEST(Validate, OneSidedOppositeBreaks2) {
  TetMesh mesh = cube();
  const HalfFaceId h = glued_half_face(mesh);
  Access::opposite(mesh)[mesh.opposite(h).index()] = HalfFaceId();
  EXPECT_TRUE(violates(mesh, 2));
}

TEST(Validate, OppositeOutOfRangeBreaks2) {
  TetMesh mesh = cube();
  Access::opposite(mesh)[0] = HalfFaceId(4000);
  EXPECT_TRUE(violates(mesh, 2));
}

TEST(Validate, OppositeOfItselfBreaks2) {
  TetMesh mesh = cube();
  Access::opposite(mesh)[0] = HalfFaceId(0);
  EXPECT_TRUE(violates(mesh, 2));
}

TEST(Validate, OppositeOfADeadSlotBreaks2) {
  TetMesh mesh = cube();
  mesh.remove_tet(TetId(2));
  const HalfFaceId free = mesh.boundary().front();
  Access::opposite(mesh)[8] = free;
  Access::opposite(mesh)[free.index()] = HalfFaceId(8);
  EXPECT_TRUE(violates(mesh, 2));
}

TEST(Validate, OppositeOfAnotherFaceBreaks3) {
  TetMesh mesh = cube();
  const std::vector<HalfFaceId> boundary = mesh.boundary();
  Access::opposite(mesh)[boundary[0].index()] = boundary[1];
  Access::opposite(mesh)[boundary[1].index()] = boundary[0];
  EXPECT_EQ(conditions(mesh), std::vector<int>{3});
}

TEST(Validate, OppositeOnTheSameSideBreaks3) {
  const std::vector<TetVertices> tets{tet(0, 1, 2, 3), tet(0, 1, 2, 4)};
  std::vector<HalfFaceId> opposite(8);
  opposite[3] = HalfFaceId(7);
  opposite[7] = HalfFaceId(3);
  EXPECT_EQ(conditions(TetMesh::from_adjacency(5, tets, opposite)), std::vector<int>{3});
}

TEST(Validate, UngluedFaceBreaks4) {
  TetMesh mesh = cube();
  const HalfFaceId h = glued_half_face(mesh);
  const HalfFaceId o = mesh.opposite(h);
  Access::opposite(mesh)[h.index()] = Access::opposite(mesh)[o.index()] = HalfFaceId();
  EXPECT_EQ(conditions(mesh), std::vector<int>{4});
}

TEST(Validate, ThreeTetsAtAFaceBreak4) {
  const std::vector<TetVertices> tets{tet(0, 1, 2, 3), tet(0, 2, 1, 4), tet(0, 1, 2, 5)};
  std::vector<HalfFaceId> opposite(12);
  opposite[3] = HalfFaceId(7);
  opposite[7] = HalfFaceId(3);
  EXPECT_EQ(conditions(TetMesh::from_adjacency(6, tets, opposite)), std::vector<int>{4});
}

TEST(Validate, FirstCornerOfAnotherVertexBreaks5) {
  TetMesh mesh = cube();
  Access::first_corner(mesh)[0] = Access::first_corner(mesh)[1];
  EXPECT_EQ(conditions(mesh), std::vector<int>{5});
}

TEST(Validate, MissingFirstCornerBreaks5) {
  TetMesh mesh = cube();
  Access::first_corner(mesh)[3] = HalfFaceId();
  EXPECT_EQ(conditions(mesh), std::vector<int>{5});
}

TEST(Validate, CornerOfAVertexInNoTetBreaks5) {
  TetMesh mesh = cube();
  Access::first_corner(mesh)[8] = HalfFaceId(0);
  EXPECT_EQ(conditions(mesh), std::vector<int>{5});
}

TEST(Validate, CornerListThatSkipsOrNeverEndsBreaks5) {
  TetMesh mesh = cube();
  const HalfFaceId first = mesh.first_corner(VertexId(0));
  const HalfFaceId second = mesh.next_corner(first);
  Access::next_corner(mesh)[second.index()] = second;
  EXPECT_EQ(conditions(mesh), std::vector<int>{5});
  Access::next_corner(mesh)[second.index()] = HalfFaceId(4000);
  EXPECT_EQ(conditions(mesh), std::vector<int>{5});
}

TEST(Validate, FreeListMustHoldExactlyTheDeadSlots) {
  TetMesh mesh = cube();
  mesh.remove_tet(TetId(2));
  EXPECT_VALID(mesh);
  Access::free_list(mesh) = {};
  EXPECT_EQ(conditions(mesh), std::vector<int>{6});
  Access::free_list(mesh) = {TetId(2), TetId(2)};
  EXPECT_EQ(conditions(mesh), std::vector<int>{6});
  Access::free_list(mesh) = {TetId(2), TetId(3)};
  EXPECT_EQ(conditions(mesh), std::vector<int>{6});
  Access::free_list(mesh) = {TetId(2), TetId(900)};
  EXPECT_EQ(conditions(mesh), std::vector<int>{6});
}

TEST(Validate, ReadsRandomNonsenseInBounds) {
  Prng random(61);
  for (int round = 0; round < 300; ++round) {
    std::vector<TetVertices> tets(5);
    std::vector<HalfFaceId> opposite(20);
    for (TetVertices& t : tets) {
      for (VertexId& v : t) v = random.chance(0.1) ? VertexId() : VertexId(random.below(7));
    }
    for (HalfFaceId& h : opposite) {
      h = random.chance(0.4) ? HalfFaceId() : HalfFaceId(random.below(22));
    }
    TetMesh mesh = TetMesh::from_adjacency(6, tets, opposite);
    for (HalfFaceId& h : Access::first_corner(mesh)) {
      if (random.chance(0.1)) h = HalfFaceId(random.below(22));
    }
    for (HalfFaceId& h : Access::next_corner(mesh)) {
      if (random.chance(0.1)) h = HalfFaceId(random.below(22));
    }
    EXPECT_FALSE(conditions(mesh).empty());
  }
}

}  // namespace
}  // namespace mesh_test
}  // namespace tetloft

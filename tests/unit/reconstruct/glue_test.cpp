// Gluing: parts become one model, section vertices shared, the rest a part's own.
#include "reconstruct/glue.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <map>
#include <set>
#include <utility>
#include <vector>

#include "support/slabs/cases.hpp"

namespace tetloft::testing {

using namespace internal;
namespace {

// Three sections of one, two and one regions at z = 0, 1, 2, each region with a component of its
// own that differs from its number.
class Glue : public ::testing::Test {
 protected:
  Glue() {
    const SectionStack stack =
        stack_of_boxes({{box(0, 0, 4, 2)}, {box(0, 0, 3, 2), box(5, 0, 6, 2)}, {box(1, 0, 2, 2)}});
    for (const SectionId s : stack.sections.ids()) {
      sections_.push_back(conform(stack.sections[s], s).value());
    }
    components_.push_back(IdVector<RegionId, ComponentId>({ComponentId(2)}));
    components_.push_back(IdVector<RegionId, ComponentId>({ComponentId(0), ComponentId(3)}));
    components_.push_back(IdVector<RegionId, ComponentId>({ComponentId(1)}));
  }

  // A prism below a section; its regions are the lower ones of the solid.
  [[nodiscard]] Part below(std::size_t section) const {
    const SectionId s(section);
    return {SlabId(section), SectionId(), s, build_end(sections_[s], sections_[s].z - 0.25)};
  }
  // And one above.
  [[nodiscard]] Part above(std::size_t section) const {
    const SectionId s(section);
    return {SlabId(section), s, SectionId(), build_end(sections_[s], sections_[s].z + 0.25)};
  }

  [[nodiscard]] std::size_t section_vertices() const {
    std::size_t vertices = 0;
    for (const ConformingSection& section : sections_) vertices += section.vertex_count();
    return vertices;
  }

  IdVector<SectionId, ConformingSection> sections_;
  RegionComponents components_;
};

// The points of a solid's pieces, by piece.
std::vector<std::array<Point3, 4>> points_of(const Part& part,
                                             const IdVector<SectionId, ConformingSection>& all) {
  std::vector<std::array<Point3, 4>> result;
  const SlabSolid& solid = part.solid;
  for (const Piece& piece : solid.pieces) {
    std::array<Point3, 4>& p = result.emplace_back();
    for (std::size_t i = 0; i < 4; ++i) {
      const std::size_t node = piece.node.at(i).index();
      const std::size_t lower = solid.vertices.lower_size();
      if (node < lower) {
        p[i] = all[part.lower].point3(PlaneVertexId(node));
      } else if (node < solid.vertices.size()) {
        p[i] = all[part.upper].point3(PlaneVertexId(node - lower));
      } else {
        p[i] = solid.constructed[ConstructedId(node - solid.vertices.size())];
      }
    }
  }
  return result;
}

// More parts than are glued at once, and one without tets among them.
TEST_F(Glue, TetsAreThePiecesOfAllPartsInOrderPointByPoint) {
  std::vector<Part> parts;
  for (int i = 0; i < 10; ++i) {
    parts.insert(parts.end(), {below(0), above(0), above(1), below(2)});
    if (i == 5) parts.push_back({SlabId(0), SectionId(0), SectionId(1), SlabSolid()});
  }
  std::vector<std::array<Point3, 4>> expected;
  std::vector<SlabId> slabs;
  for (const Part& part : parts) {
    for (const auto& p : points_of(part, sections_)) {
      expected.push_back(p);
      slabs.push_back(part.slab);
    }
  }
  for (const unsigned threads : {1U, 3U}) {
    const Model model = glue(sections_, components_, parts, threads);
    ASSERT_EQ(model.tets.size(), expected.size());
    for (const TetId t : model.tets.ids()) {
      for (std::size_t i = 0; i < 4; ++i) {
        EXPECT_EQ(model.points[model.tets[t].at(i)], expected[t.index()].at(i));
      }
      EXPECT_EQ(model.slab[t], slabs[t.index()]);
      EXPECT_EQ(model.kind[t], TetKind::prism);
    }
  }
}

TEST_F(Glue, PartsOnEitherSideOfASectionShareItsVerticesAndNothingElse) {
  const Model model = glue(sections_, components_, {below(0), above(0)});
  std::set<VertexId> low, high;
  for (const TetId t : model.tets.ids()) {
    bool is_above = false;
    for (const VertexId v : model.tets[t]) is_above = is_above || model.points[v].z > 0;
    for (const VertexId v : model.tets[t]) (is_above ? high : low).insert(v);
  }
  std::size_t shared = 0;
  for (const VertexId v : low) {
    if (!high.contains(v)) continue;
    ++shared;
    EXPECT_EQ(model.points[v].z, 0);
    EXPECT_EQ(model.section[v], SectionId(0));
  }
  EXPECT_EQ(shared, 4U);
  std::set<std::array<double, 3>> places;
  for (const Point3& p : model.points) EXPECT_TRUE(places.insert({p.x, p.y, p.z}).second);
}

TEST_F(Glue, SectionVerticesComeFirstBySectionThenConstructedOnesByPart) {
  const Model model = glue(sections_, components_, {above(2), below(0)});
  std::size_t at = 0;
  for (const SectionId s : sections_.ids()) {
    const ConformingSection& section = sections_[s];
    for (std::size_t k = 0; k < section.vertex_count(); ++k, ++at) {
      EXPECT_EQ(model.points[VertexId(at)], section.point3(PlaneVertexId(k)));
      EXPECT_EQ(model.section[VertexId(at)], s);
      EXPECT_EQ(model.contour[VertexId(at)], section.contour[PlaneVertexId(k)]);
      EXPECT_EQ(model.origin[VertexId(at)], PointOrigin::input);
    }
  }
  ASSERT_EQ(model.points.size(), at + 8);
  for (std::size_t k = 0; k < 8; ++k, ++at) {
    EXPECT_EQ(model.points[VertexId(at)].z, k < 4 ? 2.25 : -0.25);
    EXPECT_FALSE(model.section[VertexId(at)].valid());
    EXPECT_FALSE(model.contour[VertexId(at)].valid());
    EXPECT_EQ(model.origin[VertexId(at)], PointOrigin::cap);
  }
}

TEST_F(Glue, ConstructedNodesThatNoPieceUsesAreLeftOut) {
  Part part = above(1);
  const std::size_t all = part.solid.constructed.size();
  // Without the pieces at the first constructed node, which lies in the first region.
  const NodeId gone = part.solid.nodes().of(ConstructedId(0));
  std::erase_if(part.solid.pieces, [&](const Piece& piece) {
    return std::count(piece.node.begin(), piece.node.end(), gone) > 0;
  });
  std::set<NodeId> used;
  for (const Piece& piece : part.solid.pieces) {
    for (const NodeId n : piece.node) {
      if (n.index() >= part.solid.vertices.size()) used.insert(n);
    }
  }
  ASSERT_LT(used.size(), all);
  ASSERT_FALSE(used.empty());
  std::vector<Point3> expected;
  for (const NodeId n : used) {
    expected.push_back(
        part.solid.constructed[ConstructedId(n.index() - part.solid.vertices.size())]);
  }
  const Model model = glue(sections_, components_, {std::move(part)});
  ASSERT_EQ(model.points.size(), section_vertices() + expected.size());
  EXPECT_EQ(
      std::vector<Point3>(model.points.begin() + static_cast<std::ptrdiff_t>(section_vertices()),
                          model.points.end()),
      expected);
}

TEST_F(Glue, ComponentsAreThoseOfTheRegions) {
  const Model model = glue(sections_, components_, {below(0), above(1), below(2)});
  EXPECT_EQ(model.component_count, 4U);
  for (const TetId t : model.tets.ids()) {
    const Point3& p = model.points[model.tets[t][0]];
    const std::size_t expected = p.z < 0.5 ? 2 : p.z > 1.5 ? 1 : p.x <= 3 ? 0 : 3;
    EXPECT_EQ(model.component[t], ComponentId(expected));
  }
}

TEST_F(Glue, SolidsOfNeighbouringSlabsAreFaceToFaceAtTheirSection) {
  std::vector<Part> parts;
  for (std::size_t k = 0; k < 2; ++k) {
    const SectionId low(k);
    const SectionId high(k + 1);
    std::vector<Link> links{{SlabId(k), RegionId(0), RegionId(0)}};
    Result<SlabOutcome> built = build_slab(SlabId(k), sections_[low], sections_[high], {links},
                                           {DelaunayEngine::automatic, kDefaultWorkLimit});
    ASSERT_TRUE(built.ok());
    parts.push_back({SlabId(k), low, high, std::get<SlabSolid>(std::move(*built))});
  }
  const Model model = glue(sections_, components_, std::move(parts));
  // Faces in the middle section, by vertices; each once from below and once from above.
  std::map<std::set<VertexId>, std::set<SlabId>> faces;
  for (const TetId t : model.tets.ids()) {
    for (std::size_t i = 0; i < 4; ++i) {
      std::set<VertexId> face(model.tets[t].begin(), model.tets[t].end());
      face.erase(model.tets[t].at(i));
      bool in_plane = true;
      for (const VertexId v : face) in_plane = in_plane && model.section[v] == SectionId(1);
      if (!in_plane) continue;
      EXPECT_TRUE(faces[face].insert(model.slab[t]).second);
    }
  }
  std::size_t internal = 0;
  for (const std::uint8_t inside : sections_[SectionId(1)].internal) internal += inside;
  EXPECT_EQ(faces.size(), internal);
  for (const auto& [face, slabs] : faces) EXPECT_EQ(slabs.size(), 2U);
}

}  // namespace
}  // namespace tetloft::testing

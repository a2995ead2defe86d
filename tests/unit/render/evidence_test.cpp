// Which parts of a model show the evidence of which link.
#include "render/evidence.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

#include "unit/render/boxes.hpp"

namespace tetloft::internal::render {
namespace {

constexpr std::size_t kTetsOfABox = 6;

// Boxes as in boxes.hpp, the contours of column c numbered c.
Model columns(std::size_t slabs, std::size_t components) {
  Model model = test::boxes(slabs, components);
  const std::size_t points = 4 * (slabs + 1);
  for (std::size_t v = 0; v < model.points.size(); ++v) {
    model.section[VertexId(v)] = SectionId(v % points / 4);
    model.contour[VertexId(v)] = ContourId(v / points);
  }
  return model;
}

RegionLink link(std::size_t slab, std::size_t lower, std::size_t upper, Evidence evidence,
                double margin, LinkFate fate = LinkFate::made) {
  RegionLink made{SlabId(slab), ContourId(lower), ContourId(upper), evidence, fate};
  made.margin = margin;
  return made;
}

// The evidence of each box, slab by slab, column by column: that of all its tets.
std::vector<int> evidence_of(const Model& model, std::size_t columns_in_all) {
  RenderOptions options;
  options.colour = ColourBy::evidence;
  const Result<Subject> subject = subject_of(model, nullptr, options);
  EXPECT_TRUE(subject.ok()) << to_string(subject.error());
  std::vector<int> boxes(subject->slab_count * columns_in_all, -1);
  for (std::size_t t = 0; t < subject->tets.size(); ++t) {
    double left = 1e9;
    for (const VertexId v : subject->tets[t]) left = std::min(left, model.points[v].x);
    int& box = boxes[subject->slab[t] * columns_in_all + static_cast<std::size_t>(left / 5)];
    const int evidence = subject->evidence[t];
    EXPECT_TRUE(box == -1 || box == evidence) << t;
    box = evidence;
  }
  return boxes;
}

constexpr int kOverlap = 0, kMotion = 2, kLone = 4, kLabel = 5, kDecision = 6;

TEST(Evidence, IsThatOfTheLeastSureLinkOfAPartThatWasMade) {
  Model model = columns(3, 2);
  model.links = {
      link(0, 0, 0, Evidence::overlap, 0.5),
      link(0, 1, 1, Evidence::motion, 0.1),
      // The first of equals, whatever the sign; what was not made does not count.
      link(1, 0, 0, Evidence::decision, -0.2),
      link(1, 0, 0, Evidence::lone, 0.2),
      link(1, 0, 0, Evidence::chain, 0.01, LinkFate::too_weak),
      link(1, 1, 1, Evidence::chain, 0.01, LinkFate::unrealisable),
      link(2, 0, 0, Evidence::overlap, 0.9),
      link(2, 0, 0, Evidence::label, 0.3),
      link(2, 1, 1, Evidence::lone, 1e-300),
      link(2, 1, 1, Evidence::overlap, 0),
  };
  EXPECT_EQ(evidence_of(model, 2),
            (std::vector<int>{kOverlap, kMotion, kDecision, kNoEvidence, kLabel, kOverlap}));
  std::reverse(model.links.begin(), model.links.end());
  EXPECT_EQ(evidence_of(model, 2),
            (std::vector<int>{kOverlap, kMotion, kLone, kNoEvidence, kLabel, kOverlap}));
}

// As in least_sure_first(): a lone region may also be unsure which other it belongs to.
TEST(Evidence, OfALoneRegionIsAsSureAsItsLead) {
  Model model = columns(1, 1);
  model.links = {link(0, 0, 0, Evidence::overlap, 0.2), link(0, 0, 0, Evidence::lone, 0.4),
                 link(0, 0, 0, Evidence::chain, 0.3)};
  EXPECT_EQ(evidence_of(model, 1), std::vector<int>{kOverlap});
  model.links[1].lead = -0.1;
  model.links[2].lead = 0.05;
  EXPECT_EQ(evidence_of(model, 1), std::vector<int>{kLone});
}

// A link belongs where one of its contours is: in its own slab, below or above.
TEST(Evidence, IsFoundByEitherContourInTheSlabOfTheLink) {
  Model model = columns(2, 3);
  model.links = {link(0, 0, 99, Evidence::motion, 1), link(0, 99, 1, Evidence::lone, 1),
                 link(1, 99, 99, Evidence::overlap, 1), link(7, 2, 2, Evidence::overlap, 1),
                 link(0x7FFFFFFF, 0, 0, Evidence::overlap, 1)};
  EXPECT_EQ(evidence_of(model, 3),
            (std::vector<int>{kMotion, kLone, kNoEvidence, kNoEvidence, kNoEvidence, kNoEvidence}));
}

// Two columns of one component: each has its own. Joined by faces, they have one.
TEST(Evidence, BelongsToPartsNotToComponents) {
  Model model = columns(1, 2);
  for (ComponentId& component : model.component) component = ComponentId(0);
  model.links = {link(0, 0, 0, Evidence::motion, 0.2), link(0, 1, 1, Evidence::lone, 0.1)};
  EXPECT_EQ(evidence_of(model, 2), (std::vector<int>{kMotion, kLone}));
  // Two boxes one upon the other, in one slab: the part knows the contours of all its sections.
  model = columns(2, 1);
  for (SlabId& slab : model.slab) slab = SlabId(0);
  model.links = {link(0, 0, 7, Evidence::motion, 0.2)};
  EXPECT_EQ(evidence_of(model, 1), (std::vector<int>{kMotion}));
}

TEST(Evidence, IsNotThatOfEnds) {
  Model model = columns(2, 1);
  // The lower box is an end, which counts to the slab above it.
  for (std::size_t t = 0; t < model.tets.size(); ++t) {
    model.slab[TetId(t)] = SlabId(0);
    if (t < kTetsOfABox) model.kind[TetId(t)] = TetKind::prism;
  }
  for (SectionId& section : model.section) {
    section = section == SectionId(0) ? SectionId() : SectionId(section.index() - 1);
  }
  model.links = {link(0, 0, 0, Evidence::decision, 1)};
  RenderOptions options;
  const Result<Subject> subject = subject_of(model, nullptr, options);
  ASSERT_TRUE(subject.ok());
  for (std::size_t t = 0; t < subject->tets.size(); ++t) {
    EXPECT_EQ(subject->evidence[t], t < kTetsOfABox ? kNoEvidence : kDecision) << t;
  }
}

// Slabs are renumbered for pictures, tets reordered; links name the model's.
TEST(Evidence, KnowsTheNumbersOfTheModelsSlabs) {
  Model model = columns(2, 1);
  for (std::size_t t = 0; t < model.tets.size(); ++t) {
    model.slab[TetId(t)] = t < kTetsOfABox ? SlabId(9) : SlabId(4);
  }
  for (std::size_t v = 0; v < model.points.size(); ++v) {
    model.section[VertexId(v)] = SectionId(v < 4 ? 9 : v < 8 ? 10 : 5);
  }
  model.links = {link(9, 0, 0, Evidence::motion, 1), link(4, 3, 0, Evidence::lone, 1)};
  EXPECT_EQ(evidence_of(model, 1), (std::vector<int>{kLone, kMotion}));
}

TEST(Evidence, OfAModelCountsTheLinksThatWereMade) {
  Model model = columns(1, 1);
  const auto subject = [&] { return subject_of(model, nullptr, {}).value(); };
  EXPECT_TRUE(subject().evidence.empty());
  model.links = {link(0, 0, 0, Evidence::lone, 1), link(0, 1, 0, Evidence::lone, 1),
                 link(0, 0, 1, Evidence::lone, 1, LinkFate::outruled),
                 link(0, 5, 5, Evidence::decision, 1)};
  EXPECT_EQ(subject().links, (std::array<std::size_t, kEvidences>{0, 0, 0, 0, 2, 0, 1}));
}

}  // namespace
}  // namespace tetloft::internal::render

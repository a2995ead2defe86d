// What takes too much work is refused while it works, and not if the caller allows more; what is
// costly by a slip of ours is seen in the work told.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

#include "support/slabs/cases.hpp"
#include "support/stacks/shapes.hpp"

namespace tetloft::testing {
namespace {

// Large round contours about different centres: tets grow with the product of their vertices.
SectionStack circles(std::size_t n) {
  return stack_of({{regular_polygon({0, 0}, 1, n, 0)}, {regular_polygon({0.1, 0.05}, 1, n, 0.3)}},
                  {0, 1});
}

SectionStack islands(std::size_t side, bool over_one) {
  Layer layer;
  for (std::size_t i = 0; i < side * side; ++i) {
    const auto x = 2 * static_cast<double>(i % side);
    const auto y = 2 * static_cast<double>(i / side);
    layer.push_back(rectangle({x, y}, {x + 1, y + 1}));
  }
  const auto end = 2 * static_cast<double>(side);
  const Layer below = over_one ? Layer{rectangle({-1, -1}, {end, end})} : layer;
  return stack_of({below, layer}, {0, 1});
}

double work_per_vertex(const SectionStack& stack) {
  const Result<Reconstruction> made = reconstruct(stack);
  EXPECT_TRUE(made.ok());
  return made ? static_cast<double>(made->report.work) / static_cast<double>(stack.vertex_count())
              : 0;
}

TEST(WorkLimit, EndsSlabsOfTooManyTetsNamingTheSlab) {
  const SectionStack stack = circles(400);
  for (const DelaunayEngine engine : {DelaunayEngine::slab, DelaunayEngine::incremental}) {
    ReconstructOptions options;
    options.delaunay = engine;
    options.between = 0;
    options.work_limit = 0.5;
    const Result<Reconstruction> refused = reconstruct(stack, options);
    ASSERT_FALSE(refused.ok());
    EXPECT_EQ(refused.error().code, ErrorCode::work_limit);
    EXPECT_EQ(refused.error().where.slab, 0U);
    EXPECT_TRUE(refused.error().where.point.has_value());
    for (const char* remedy : {"--snap 16", "fewer vertices", "raise the limit"}) {
      EXPECT_NE(refused.error().message.find(remedy), std::string::npos) << remedy;
    }
    options.work_limit = 4;
    EXPECT_TRUE(reconstruct(stack, options).ok());
  }
}

// With a section between, of fewer vertices, there is no such slab.
TEST(WorkLimit, TheDefaultEndsTwoCirclesOfTwentyThousandVertices) {
  const Result<Reconstruction> refused = reconstruct(circles(20000), {.between = 0});
  ASSERT_FALSE(refused.ok());
  EXPECT_EQ(refused.error().code, ErrorCode::work_limit);
}

TEST(WorkLimit, EndsSectionsThatAreSplitTooOftenNamingContourAndVertex) {
  // Each of the long edges has vertices of its neighbours in its circle.
  std::vector<Contour> bars;
  for (int k = 0; k < 20; ++k) {
    const double y = k;
    bars.push_back(rectangle({0.37 * (k % 7), y}, {100 - 0.41 * (k % 5), y + 0.5}));
  }
  const SectionStack stack = stack_of({bars, {rectangle({0, 0}, {100, 20})}}, {0, 1});
  ReconstructOptions options;
  options.work_limit = 1e-3;  // two vertices
  const Result<Reconstruction> refused = reconstruct(stack, options);
  ASSERT_FALSE(refused.ok());
  EXPECT_EQ(refused.error().code, ErrorCode::work_limit);
  EXPECT_EQ(refused.error().where.section, 0U);
  EXPECT_TRUE(refused.error().where.contour.has_value());
  EXPECT_TRUE(refused.error().where.vertex.has_value());
  EXPECT_TRUE(reconstruct(stack).ok());
}

TEST(WorkLimit, ChangesNothingWhereItIsNotReached) {
  const SectionStack stack = circles(40);
  ReconstructOptions unlimited;
  unlimited.work_limit = std::numeric_limits<double>::infinity();
  const Result<Reconstruction> a = reconstruct(stack);
  const Result<Reconstruction> b = reconstruct(stack, unlimited);
  ASSERT_TRUE(a.ok() && b.ok());
  EXPECT_EQ(a->model.tets.raw(), b->model.tets.raw());
  EXPECT_EQ(a->report.work, b->report.work);
}

TEST(WorkLimit, OutOfRangeIsAUsageError) {
  for (const double limit : {0.0, -1.0, std::nan("")}) {
    ReconstructOptions options;
    options.work_limit = limit;
    const Result<Reconstruction> refused = reconstruct(circles(5), options);
    ASSERT_FALSE(refused.ok());
    EXPECT_EQ(refused.error().code, ErrorCode::usage);
  }
}

// Sixteen times the islands, the same work for each.
TEST(WorkPerVertex, DoesNotGrowWithTheNumberOfIslands) {
  EXPECT_LT(work_per_vertex(islands(32, false)), 1.5 * work_per_vertex(islands(8, false)));
}

TEST(WorkPerVertex, OfOneConvexFillingDoesNotGrowWithItsSize) {
  // Tets grow with the square, and nothing faster.
  const double few = work_per_vertex(circles(100));
  EXPECT_LT(work_per_vertex(circles(400)), 6 * few);
}

}  // namespace
}  // namespace tetloft::testing

#include "between/competition.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/prng.hpp"
#include "unit/between/field_slab.hpp"

namespace tetloft::testing {

using namespace internal;
using namespace internal::between;
namespace {

// Three discs that lie over each other, in windows of their own.
FieldSlab three_discs() {
  const auto disc = [](double cx, double cy, double radius) {
    return [=](double x, double y, std::size_t) { return to_disc(x, y, cx, cy, radius); };
  };
  return FieldSlab({{{octagon(-1, 0, 0.4)}, {octagon(-1, 0, 0.4)}, disc(-1, 0, 1.5)},
                    {{octagon(1, 0, 0.4)}, {octagon(1, 0, 0.4)}, disc(1, 0, 1.5)},
                    {{octagon(0, 1.5, 0.4)}, {octagon(0, 1.5, 0.4)}, disc(0, 1.5, 1.2)}},
                   0.1, 2);
}

double value_at(const ClassShape& shape, std::size_t layer, std::int64_t i, std::int64_t j) {
  const motion::LatticeWindow& w = shape.window;
  if (i < w.i0 || i >= w.i1 || j < w.j0 || j >= w.j1) return 1e9;
  return shape.value[layer][w.place(i, j)];
}

TEST(Competition, TheLowestValueHasTheSampleAndOthersAreFartherOutside) {
  const FieldSlab slab = three_discs();
  const ClassShapes before = slab.shapes();
  ClassShapes after = before;
  compete(after, meeting_windows(after));
  std::size_t contested = 0;
  for (std::int64_t j = -40; j < 40; ++j) {
    for (std::int64_t i = -40; i < 40; ++i) {
      ClassId owner(0);
      std::size_t inside = 0;
      for (const ClassId c : before.ids()) {
        const double v = value_at(before[c], 1, i, j);
        if (v < 0) ++inside;
        if (v < value_at(before[owner], 1, i, j)) owner = c;
      }
      if (inside > 1) ++contested;
      const double least = value_at(before[owner], 1, i, j);
      for (const ClassId c : before.ids()) {
        const double was = value_at(before[c], 1, i, j);
        const double want =
            c == owner || least >= 0 || was > 1e8 ? was : std::max(was, 1.15 * -least);
        EXPECT_EQ(value_at(after[c], 1, i, j), want) << i << ' ' << j << ' ' << c.index();
      }
    }
  }
  EXPECT_GT(contested, 100U);
}

TEST(Competition, OfEqualValuesTheFirstClassHasTheSample) {
  const auto disc = [](double x, double y, std::size_t) { return to_disc(x, y, 0, 0, 1); };
  const FieldSlab slab({{{octagon(0, 0, 1)}, {}, disc}, {{}, {octagon(0, 0, 1)}, disc}}, 0.1, 1);
  ClassShapes shapes = slab.shapes();
  compete(shapes, meeting_windows(shapes));
  EXPECT_EQ(shapes[ClassId(0)].value, slab.shapes()[ClassId(0)].value);
  const std::vector<double>& second = shapes[ClassId(1)].value[1];
  EXPECT_GT(*std::min_element(second.begin(), second.end()), 0);
}

TEST(Competition, GivenLayersStay) {
  const FieldSlab slab = three_discs();
  ClassShapes shapes = slab.shapes();
  for (ClassShape& shape : shapes) shape.value.front() = shape.value[1];
  const ClassShapes before = shapes;
  const std::vector<MeetingWindows> meetings = meeting_windows(shapes);
  compete(shapes, meetings);
  part_contours(shapes, meetings);
  for (const ClassId c : shapes.ids()) {
    EXPECT_EQ(shapes[c].value.front(), before[c].value.front());
    EXPECT_EQ(shapes[c].value.back(), before[c].value.back());
    EXPECT_NE(shapes[c].value[1], before[c].value[1]);
  }
}

// Along every lattice edge between samples of two classes: the first one's crossing comes first,
// by far enough that neither is moved when it is kept away from the samples, and no farther where
// both would have the whole edge.
TEST(Competition, CrossingsOfNeighboursKeepTheirOrder) {
  const FieldSlab slab = three_discs();
  const ClassShapes before = slab.shapes();
  ClassShapes shapes = before;
  const std::vector<MeetingWindows> meetings = meeting_windows(shapes);
  compete(shapes, meetings);
  part_contours(shapes, meetings);
  std::size_t edges = 0;
  std::size_t contested = 0;
  for (const ClassId a : shapes.ids()) {
    for (const ClassId b : shapes.ids()) {
      if (a == b) continue;
      for (std::int64_t j = -40; j < 40; ++j) {
        for (std::int64_t i = -40; i < 40; ++i) {
          for (const auto& [di, dj] : {std::pair{1, 0}, std::pair{0, 1}}) {
            const double a0 = value_at(shapes[a], 1, i, j);
            const double a1 = value_at(shapes[a], 1, i + di, j + dj);
            const double b0 = value_at(shapes[b], 1, i, j);
            const double b1 = value_at(shapes[b], 1, i + di, j + dj);
            if (!(a0 < 0 && b1 < 0)) continue;
            ++edges;
            EXPECT_GE(a0, -0.5);
            EXPECT_LE(a0, -0.1);
            const double first = std::max(a0 / (a0 - a1), 1.0 / 64);
            const double second = std::min(b0 / (b0 - b1), 63.0 / 64);
            EXPECT_GT(second - first, 1.0 / 32);
            if (value_at(before[a], 1, i + di, j + dj) > 0) continue;
            if (value_at(before[b], 1, i, j) > 0) continue;
            ++contested;
            EXPECT_LT(second - first, 0.1);
          }
        }
      }
    }
  }
  EXPECT_GT(edges, contested);
  EXPECT_GT(contested, 20U);
}

TEST(Competition, ForeignSamplesAreThoseInsideAnotherClass) {
  const FieldSlab slab = three_discs();
  ClassShapes shapes = slab.shapes();
  const std::vector<MeetingWindows> meetings = meeting_windows(shapes);
  compete(shapes, meetings);
  for (const ClassId c : shapes.ids()) {
    ForeignSamples foreign(shapes, meetings, c);
    const motion::LatticeWindow& w = shapes[c].window;
    for (std::int64_t j = w.j0; j < w.j1; ++j) {
      for (std::int64_t i = w.i0; i < w.i1; ++i) {
        bool other = false;
        for (const ClassId d : shapes.ids()) other |= d != c && value_at(shapes[d], 2, i, j) < 0;
        EXPECT_EQ(foreign.in(2)[w.place(i, j)] != 0, other);
      }
    }
  }
}

}  // namespace
}  // namespace tetloft::testing

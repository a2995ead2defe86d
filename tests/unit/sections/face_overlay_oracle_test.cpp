// Overlays of random sections against trapezoids in rationals.
#include "sections/face_overlay.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <map>
#include <set>
#include <span>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include <tetloft/sections.hpp>

#include "core/prng.hpp"
#include "support/overlay_oracle.hpp"
#include "support/stacks/generate.hpp"
#include "unit/sections/shapes.hpp"

namespace tetloft::testing {
namespace {

using namespace internal::sections;
using oracle::CellOverlay;

CellOverlay::Face plain(const OverlayFace& face) {
  CellOverlay::Face result;
  result.side = {CellOverlay::Side{face.lower.solid, face.lower.id.value()},
                 CellOverlay::Side{face.upper.solid, face.upper.id.value()}};
  result.chi = face.chi;
  for (const BorderRegion& b : face.border) {
    result.border.push_back({b.upper ? 1U : 0U, b.region.value()});
  }
  return result;
}

std::vector<CellOverlay::Face> plain(const FaceOverlay& overlay) {
  std::vector<CellOverlay::Face> result;
  for (const OverlayFace& face : overlay.faces()) result.push_back(plain(face));
  return result;
}

// Points where faces are thin: vertices, midpoints between them, and their neighbours.
std::vector<Point2> probes(Prng& prng, const Section& lower, const Section& upper,
                           std::size_t count) {
  std::vector<Point2> vertices;
  for (const Section* section : {&lower, &upper}) {
    for (const Contour& c : section->contours) {
      vertices.insert(vertices.end(), c.vertices.begin(), c.vertices.end());
    }
  }
  std::vector<Point2> result;
  if (vertices.empty()) return {{0, 0}};
  const auto any = [&] { return vertices[prng.below(vertices.size())]; };
  const auto near = [&](double v) {
    const double inf = std::numeric_limits<double>::infinity();
    const std::uint64_t way = prng.below(3);
    return way == 0 ? v : std::nextafter(v, way == 1 ? inf : -inf);
  };
  for (std::size_t k = 0; k < count; ++k) {
    const Point2 p = any();
    const Point2 q = any();
    const Point2 r = any();
    result.push_back({near(p.x), near(q.y)});
    result.push_back({near(p.x / 2 + q.x / 2), near(p.y / 2 + q.y / 2)});
    result.push_back({p.x / 2 + q.x / 4 + r.x / 4, p.y / 2 + q.y / 4 + r.y / 4});
  }
  return result;
}

// What the oracle need not tell: the order, and that it does not depend on the order of contours.
void expect_canonical(Prng& prng, const Section& lower, const Section& upper,
                      const FaceOverlay& overlay, const std::vector<Point2>& points) {
  const auto shuffled = [&](const Section& section) {
    std::vector<Contour> contours;
    for (const Contour& contour : section.contours) {
      const Contour turned = rotated(contour, prng.below(contour.vertices.size()));
      contours.push_back(prng.below(2) == 0 ? turned : reversed(turned));
    }
    for (std::size_t k = contours.size(); k > 1; --k) {
      std::swap(contours[k - 1], contours[prng.below(k)]);
    }
    return testing::section(section.z, contours);
  };
  const Section lower2 = shuffled(lower);
  const Section upper2 = shuffled(upper);
  const FaceOverlay overlay2(lower2, nest(lower2), upper2, nest(upper2));
  ASSERT_EQ(plain(overlay), plain(overlay2));
  for (const Point2& p : points) ASSERT_EQ(overlay.locate(p), overlay2.locate(p));
  const auto& faces = overlay.faces().raw();
  ASSERT_TRUE(std::is_sorted(faces.begin(), faces.end(), [](const auto& a, const auto& b) {
    return std::tie(a.lower, a.upper) < std::tie(b.lower, b.upper);
  }));
}

void expect_faces_of_oracle(Prng& prng, const Section& lower, const Section& upper) {
  const Nesting lower_nesting = nest(lower);
  const Nesting upper_nesting = nest(upper);
  const FaceOverlay overlay(lower, lower_nesting, upper, upper_nesting);
  const CellOverlay cells(lower, lower_nesting, upper, upper_nesting);
  std::vector<CellOverlay::Face> found = plain(overlay);
  std::vector<CellOverlay::Face> expected = cells.faces();
  std::sort(found.begin(), found.end());
  std::sort(expected.begin(), expected.end());
  ASSERT_EQ(found.size(), expected.size());
  ASSERT_TRUE(found == expected);

  // Points lie in the same faces, one to one.
  const std::vector<Point2> points = probes(prng, lower, upper, 8);
  std::map<FaceId, std::size_t> theirs;
  std::map<std::size_t, FaceId> ours;
  for (const Point2& p : points) {
    const FaceId face = overlay.locate(p);
    const auto cell = cells.locate(p);
    ASSERT_EQ(face.valid(), cell.has_value());
    if (!cell) continue;
    ASSERT_EQ(theirs.emplace(face, *cell).first->second, *cell);
    ASSERT_EQ(ours.emplace(*cell, face).first->second, face);
    ASSERT_EQ(plain(overlay.faces()[face]), cells.faces()[*cell]);
  }
  ASSERT_EQ(cells.locate({-0x1p500, 1}), cells.locate({0x1p500, 1}));
  ASSERT_EQ(overlay.locate({0x1p500, 1}), overlay.unbounded());
  expect_canonical(prng, lower, upper, overlay, points);
}

std::size_t vertex_count(const Section& section) {
  std::size_t n = 0;
  for (const Contour& c : section.contours) n += c.vertices.size();
  return n;
}

TEST(FaceOverlay, AgreesWithTrapezoidsOnRandomStacks) {
  Prng prng(7);
  std::size_t compared = 0;
  for (const StackKind kind : all_kinds()) {
    for (std::uint64_t seed = 0; seed < 6; ++seed) {
      const SectionStack stack = generate(kind, seed).stack;
      for (std::size_t k = 0; k + 1 < stack.sections.size(); ++k) {
        const Section& lower = stack.sections[SectionId(k)];
        const Section& upper = stack.sections[SectionId(k + 1)];
        if (vertex_count(lower) + vertex_count(upper) > 64) continue;
        expect_faces_of_oracle(prng, lower, upper);
        if (HasFatalFailure()) FAIL() << name_of(kind) << " seed " << seed << " slab " << k;
        ++compared;
      }
    }
  }
  EXPECT_GT(compared, 200U);
}

}  // namespace
}  // namespace tetloft::testing

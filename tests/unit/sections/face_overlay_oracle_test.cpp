// Overlays of random sections against trapezoids in rationals.
#include "sections/face_overlay.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <map>
#include <numbers>
#include <tuple>
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
  ASSERT_EQ(overlay.locate({0x1p500, 1}), kUnboundedFace);
  expect_canonical(prng, lower, upper, overlay, points);
}

std::size_t vertex_count(const Section& section) {
  std::size_t n = 0;
  for (const Contour& c : section.contours) n += c.vertices.size();
  return n;
}

// Up to four stars on a small grid, none of which touch; most sections of such touch each other.
Section crowded(Prng& prng, double z) {
  std::vector<Contour> contours;
  const std::size_t draws = 1 + prng.below(8);
  for (std::size_t k = 0; k < draws && contours.size() < 4; ++k) {
    const int radius = 1 + static_cast<int>(prng.below(4));
    const int x = static_cast<int>(prng.below(8));
    const int y = static_cast<int>(prng.below(8));
    contours.push_back(random_star(prng, x, y, radius, static_cast<int>(prng.below(5))));
    if (!validate(one(contours)).ok()) contours.pop_back();
  }
  return section(z, contours);
}

Section mapped(const Section& original, const std::function<Point2(const Point2&)>& map) {
  Section result = original;
  for (Contour& contour : result.contours) {
    for (Point2& p : contour.vertices) p = map(p);
  }
  return result;
}

bool is_valid(const Section& section) {
  return section.contours.empty() || validate(stack({section})).ok();
}

TEST(FaceOverlay, AgreesWithTrapezoidsOnRandomStacks) {
  Prng prng(7);
  std::size_t compared = 0;
  for (const StackKind kind : all_kinds()) {
    for (std::uint64_t seed = 0; seed < 2; ++seed) {
      const SectionStack stack = generate(kind, seed).stack;
      for (std::size_t k = 0; k + 1 < stack.sections.size(); ++k) {
        const Section& lower = stack.sections[SectionId(k)];
        const Section& upper = stack.sections[SectionId(k + 1)];
        if (vertex_count(lower) + vertex_count(upper) > 48) continue;
        expect_faces_of_oracle(prng, lower, upper);
        if (HasFatalFailure()) FAIL() << name_of(kind) << " seed " << seed << " slab " << k;
        ++compared;
      }
    }
  }
  EXPECT_GT(compared, 40U);
}

TEST(FaceOverlay, AgreesWithTrapezoidsOnCrowdedGrids) {
  for (std::uint64_t seed = 0; seed < 250; ++seed) {
    Prng prng(seed);
    const Section lower = crowded(prng, 0);
    // Often parts of the lower section again: shared runs.
    Section upper = crowded(prng, 1);
    for (const Contour& contour : lower.contours) {
      if (prng.below(3) != 0) continue;
      upper.contours.push_back(contour);
      if (!is_valid(upper)) upper.contours.raw().pop_back();
    }
    expect_faces_of_oracle(prng, lower, upper);
    if (HasFatalFailure()) FAIL() << "seed " << seed;
  }
}

TEST(FaceOverlay, AgreesWithTrapezoidsInTheLastBits) {
  std::size_t compared = 0;
  for (std::uint64_t seed = 0; seed < 120; ++seed) {
    Prng prng(seed);
    const bool of_ulps = prng.below(2) == 0;
    const auto jitter = [&] { return static_cast<double>(prng.below(3)) - 1; };
    const auto map = [&](const Point2& p) {
      // A grid of single ulps, or one of halves whose points have strayed by an ulp.
      if (of_ulps) return Point2{1 + p.x * 0x1p-52, 3 + p.y * 0x1p-51};
      return Point2{p.x / 2 + 16 + jitter() * 0x1p-48, p.y / 2 + 16 + jitter() * 0x1p-48};
    };
    const Section grid = crowded(prng, 0);
    const Section lower = mapped(grid, map);
    const Section upper = mapped(prng.below(2) == 0 ? grid : crowded(prng, 1), map);
    if (!is_valid(lower) || !is_valid(upper)) continue;
    expect_faces_of_oracle(prng, lower, upper);
    if (HasFatalFailure()) FAIL() << "seed " << seed;
    ++compared;
  }
  EXPECT_GT(compared, 60U);
}

TEST(FaceOverlay, IsTheSameAtAnyScale) {
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    Prng prng(seed);
    const Section lower = crowded(prng, 0);
    const Section upper = crowded(prng, 1);
    const FaceOverlay overlay(lower, nest(lower), upper, nest(upper));
    // Points of a finer grid, so that they do not round at the smallest scale.
    std::vector<Point2> points;
    for (int k = 0; k < 100; ++k) {
      points.push_back({static_cast<double>(prng.below(64)) / 4 - 4,
                        static_cast<double>(prng.below(64)) / 4 - 4});
    }
    for (const double factor : {0x1p-1072, 0x1p-700, 0x1p300, 0x1p990}) {
      const auto map = [&](const Point2& p) { return Point2{p.x * factor, p.y * factor}; };
      const Section a = mapped(lower, map);
      const Section b = mapped(upper, map);
      const FaceOverlay scaled(a, nest(a), b, nest(b));
      ASSERT_EQ(plain(scaled), plain(overlay)) << seed << " " << factor;
      for (const Point2& p : points) ASSERT_EQ(scaled.locate(map(p)), overlay.locate(p));
    }
  }
}

// The plane is what the faces and the contours leave of each other: contours have χ = 0, and what
// they share, points and runs, is counted twice.
TEST(FaceOverlay, HasFacesWhoseCharacteristicsSumUp) {
  Prng prng(3);
  for (std::size_t n : {10U, 100U, 3000U}) {
    std::array<Section, 2> sections;
    for (Section& section : sections) {
      Contour wave;
      const double phase = prng.unit();
      for (std::size_t i = 0; i < n; ++i) {
        const double t = 2 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(n);
        const double r = 1 + prng.between(-0.01, 0.01) + phase * 0.01;
        wave.vertices.push_back({r * std::cos(t), r * std::sin(t)});
      }
      section.contours.push_back(wave);
    }
    std::int64_t crossings = 0;
    const auto& a = sections[0].contours[ContourId(0U)].vertices;
    const auto& b = sections[1].contours[ContourId(0U)].vertices;
    for (std::size_t i = 0; i < n; ++i) {
      const Point2& p = a[i];
      const Point2& q = a[(i + 1) % n];
      for (std::size_t j = 0; j < n; ++j) {
        const Point2& r = b[j];
        const Point2& s = b[(j + 1) % n];
        if (std::abs(p.x - r.x) > 0.7 || std::abs(p.y - r.y) > 1.3) continue;
        const bool parted = orient2d(p, q, r) == -orient2d(p, q, s);
        if (parted && orient2d(r, s, p) == -orient2d(r, s, q)) ++crossings;
      }
    }
    const FaceOverlay overlay(sections[0], nest(sections[0]), sections[1], nest(sections[1]));
    std::int64_t sum = 0;
    for (const OverlayFace& face : overlay.faces()) sum += face.chi;
    EXPECT_EQ(sum, 1 + crossings);
    EXPECT_GT(crossings, 1);
  }
}

}  // namespace
}  // namespace tetloft::testing

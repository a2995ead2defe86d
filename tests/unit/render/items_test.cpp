// The item buffer: what is seen, and how much was looked at to find it.
#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <limits>

#include "core/prng.hpp"
#include "render/items.hpp"

namespace tetloft::internal::render {
namespace {

constexpr std::size_t kSide = 512;

RenderOptions from_above() {
  RenderOptions options;
  options.azimuth = -90;
  options.elevation = 90;
  options.width = options.height = kSide;
  return options;
}

void add(Scene& scene, Point3 a, Point3 b, Point3 c) {
  if ((b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x) < 0) std::swap(b, c);
  scene.triangles.push_back({{a, b, c}, {}, {}, 0});
}

double random(Prng& prng) { return static_cast<double>(prng.next() % 1'000'003) / 1'000'003; }

ItemBuffer items_of(const Scene& scene) {
  const RenderOptions options = from_above();
  return draw_items(scene, View(scene, options), kSide, kSide);
}

// Needles from the middle outwards; teeth of a comb, slanted; triangles of all forms; layers.
Scene needles(std::size_t n) {
  Scene scene;
  for (std::size_t k = 0; k < n; ++k) {
    const double a = 2 * 3.14159265358979 * static_cast<double>(k) / static_cast<double>(n);
    const double b = 2 * 3.14159265358979 * static_cast<double>(k + 1) / static_cast<double>(n);
    add(scene, {0, 0, 0}, {std::cos(a), std::sin(a), 0}, {std::cos(b), std::sin(b), 0});
  }
  return scene;
}
Scene teeth(std::size_t n) {
  Scene scene;
  for (std::size_t k = 0; k < n; ++k) {
    const double x = static_cast<double>(k) / static_cast<double>(n);
    add(scene, {x, 0, 0}, {x + 0.5 / static_cast<double>(n), 0, 0}, {x + 1, 1, x});
  }
  return scene;
}
Scene layers(std::size_t n) {
  Scene scene;
  // From far to near: the worst order.
  for (std::size_t k = 0; k < n; ++k) {
    const double z = static_cast<double>(k) / static_cast<double>(n);
    add(scene, {0, 0, z}, {1, 0, z}, {1, 1, z});
    add(scene, {0, 0, z}, {1, 1, z}, {0, 1, z});
  }
  return scene;
}
Scene mixed(std::size_t n) {
  Prng prng(7);
  Scene scene;
  for (std::size_t k = 0; k < n; ++k) {
    const double reach = std::pow(2.0, -12 * random(prng));
    const Point3 a{random(prng), random(prng), random(prng)};
    const Point3 b{a.x + random(prng) - 0.5, a.y + random(prng) - 0.5, random(prng)};
    add(scene, a, b, {b.x + reach * random(prng), b.y + reach * random(prng), random(prng)});
  }
  return scene;
}

TEST(ItemBuffer, ShowsAtEachPixelTheNearestOfAllTriangles) {
  for (const Scene& scene : {needles(97), teeth(60), layers(9), mixed(60)}) {
    const View view(scene, from_above());
    const ItemBuffer found = draw_items(scene, view, kSide, kSide);
    std::vector<double> depth(kSide * kSide, -std::numeric_limits<double>::infinity());
    for (const SceneTriangle& triangle : scene.triangles) {
      const Projected p = view.project(triangle.corner[0]);
      const Projected q = view.project(triangle.corner[1]);
      const Projected r = view.project(triangle.corner[2]);
      const auto area = [](const Projected& a, const Projected& b, double x, double y) {
        return (b.x - a.x) * (y - a.y) - (b.y - a.y) * (x - a.x);
      };
      const double all = area(p, q, r.x, r.y);
      if (all == 0) continue;
      for (std::size_t at = 0; at < depth.size(); ++at) {
        const double x = static_cast<double>(at % kSide) + 0.5;
        const double y = static_cast<double>(at / kSide) + 0.5;
        const double u = area(q, r, x, y) / all;
        const double v = area(r, p, x, y) / all;
        const double w = area(p, q, x, y) / all;
        if (u < 0 || v < 0 || w < 0) continue;
        depth[at] = std::max(depth[at], u * p.depth + v * q.depth + w * r.depth);
      }
    }
    std::size_t wrong = 0;
    for (std::size_t at = 0; at < depth.size(); ++at) {
      const bool seen = depth[at] > -std::numeric_limits<double>::infinity();
      if (seen != (found.item[at] != ItemBuffer::kNothing)) ++wrong;
      if (seen && std::abs(depth[at] - static_cast<double>(found.depth[at])) > 1e-3) ++wrong;
    }
    EXPECT_EQ(wrong, 0U) << scene.triangles.size();
  }
}

TEST(ItemBuffer, LooksAtFewPixelsHoweverThinOrHiddenTrianglesAre) {
  constexpr double kPixels = kSide * kSide;
  const auto visits = [](const Scene& scene) {
    return static_cast<double>(items_of(scene).visits);
  };
  // Their boxes have up to 250,000 pixels each: 1,000 and more for each pixel of the picture.
  EXPECT_LT(visits(needles(20'000)), 8 * (kPixels + 20'000));
  EXPECT_LT(visits(teeth(20'000)), 8 * (kPixels + 20'000));
  // Of hidden layers the squares at their borders only, which are never full: 5,000 times the
  // picture otherwise.
  EXPECT_LT(visits(layers(5'000)), 250 * kPixels);
}

TEST(DepthPyramid, HidesWhatLiesBehindSquaresThatAreFull) {
  DepthPyramid pyramid(50, 20);
  EXPECT_FALSE(pyramid.hides(0, 0, 50, 20, -1e30F));
  for (std::size_t x = 0; x < 7; ++x) {
    for (std::size_t y = 0; y < 3; ++y) pyramid.raise(x, y, x == 6 ? 1.0F : 2.0F);
  }
  EXPECT_TRUE(pyramid.hides(0, 0, 50, 20, 1.0F));
  EXPECT_FALSE(pyramid.hides(0, 0, 50, 20, 1.5F));
  EXPECT_TRUE(pyramid.hides(0, 0, 30, 20, 2.0F));
}

}  // namespace
}  // namespace tetloft::internal::render

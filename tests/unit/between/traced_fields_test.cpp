// From fields to sections: what must hold of any. Oracles share no code with what they check: they
// flood samples and links by going over all of them until nothing changes.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

#include "between/trace_shapes.hpp"
#include "core/prng.hpp"
#include "unit/between/field_slab.hpp"

namespace tetloft::testing {

using namespace internal;
using namespace internal::between;
namespace {

// A disc and a few bumps, of which each layer has its own mixture.
Field random_bumps(Prng& random, double level, double centre) {
  struct Bump {
    double x, y, radius, weight, drift;
  };
  std::vector<Bump> bumps;
  for (int n = 0; n < 14; ++n) {
    bumps.push_back({random.between(-4, 4), random.between(-4, 4), random.between(0.5, 1.6),
                     random.between(-1, 1.4), random.between(-0.3, 0.3)});
  }
  return [bumps, level, centre](double x, double y, std::size_t layer) {
    double sum = level;
    for (const Bump& b : bumps) {
      const double d = ((x - b.x) * (x - b.x) + (y - b.y) * (y - b.y)) / (b.radius * b.radius);
      sum -= (b.weight + b.drift * static_cast<double>(layer)) / (1 + d * d);
    }
    sum = std::min(sum, to_disc(x, y, centre, 0.15, 0.8));
    return std::max(sum, to_box(x, y, -5, -5, 5, 5));
  };
}

struct RandomSlab {
  std::vector<FieldClass> classes;
  std::size_t layers;
  double step = 0.17;

  explicit RandomSlab(std::uint64_t seed) : layers(1 + seed % 3) {
    Prng random(seed);
    for (int c = 0; c < 3; ++c) {
      const double x = -3 + 3 * c;
      FieldClass made{{octagon(x, 0, 1.2)}, {octagon(x, 0.3, 1.2)}, random_bumps(random, 0.8, x)};
      if (c == 1) {
        made.lower = {octagon(0, 0, 1.3), octagon(0, 0, 0.6), octagon(0, 2.2, 0.4)};
        made.upper = {octagon(0, 0.5, 1.3), octagon(0, 0.5, 0.6), octagon(0, -2.2, 0.4)};
      }
      classes.push_back(made);
    }
  }
};

// The number of parts, through straight neighbours or through all eight.
std::size_t flooded_parts(const ClassShape& shape, std::size_t layer, bool inside, bool diagonal) {
  const motion::LatticeWindow& w = shape.window;
  std::vector<std::size_t> label(w.size());
  for (std::size_t at = 0; at < label.size(); ++at) label[at] = at;
  const auto in = [&](std::int64_t i, std::int64_t j) {
    return (shape.value[layer][w.place(i, j)] < 0) == inside;
  };
  for (bool changed = true; changed;) {
    changed = false;
    for (std::int64_t j = w.j0; j < w.j1; ++j) {
      for (std::int64_t i = w.i0; i < w.i1; ++i) {
        for (std::int64_t dj = 0; dj <= 1; ++dj) {
          for (std::int64_t di = -1; di <= 1; ++di) {
            if (!diagonal && di != 0 && dj != 0) continue;
            if (i + di < w.i0 || i + di >= w.i1 || j + dj >= w.j1) continue;
            if (!in(i, j) || !in(i + di, j + dj)) continue;
            std::size_t& a = label[w.place(i, j)];
            std::size_t& b = label[w.place(i + di, j + dj)];
            if (a == b) continue;
            a = b = std::min(a, b);
            changed = true;
          }
        }
      }
    }
  }
  std::size_t parts = 0;
  for (std::size_t at = 0; at < label.size(); ++at) {
    if (label[at] == at && (shape.value[layer][at] < 0) == inside) ++parts;
  }
  return parts;
}

bool is_within(const Point2& p, const Contour& contour) {
  bool within = false;
  for (std::size_t v = 0; v < contour.vertices.size(); ++v) {
    const Point2& a = contour.vertices[v];
    const Point2& b = contour.vertices[(v + 1) % contour.vertices.size()];
    if ((a.y <= p.y) == (b.y <= p.y)) continue;
    if (a.x + (p.y - a.y) / (b.y - a.y) * (b.x - a.x) < p.x) within = !within;
  }
  return within;
}

// The class whose region holds the point; none where no region does.
ClassId class_at(const InnerSection& section, const Point2& p) {
  ContourId innermost;
  for (const ContourId c : section.section.contours.ids()) {
    if (!is_within(p, section.section.contours[c])) continue;
    if (!innermost.valid() || section.nesting.depth[c] > section.nesting.depth[innermost]) {
      innermost = c;
    }
  }
  if (!innermost.valid() || section.nesting.depth[innermost] % 2 == 1) return {};
  return section.class_of[section.nesting.region[innermost]];
}

// Sections show what the samples say: as many regions and holes of each class, and at samples that
// are well inside a class a region of it.
void expect_sections_of(const ClassShapes& shapes, const InnerSections& inner, double step) {
  for (std::size_t k = 0; k < inner.sections.size(); ++k) {
    const InnerSection& section = inner.sections[k];
    std::size_t regions = 0;
    std::size_t contours = 0;
    for (const ClassId c : shapes.ids()) {
      const std::size_t parts = flooded_parts(shapes[c], k + 1, true, false);
      EXPECT_EQ(
          static_cast<std::size_t>(std::count(section.class_of.begin(), section.class_of.end(), c)),
          parts);
      regions += parts;
      contours += parts + flooded_parts(shapes[c], k + 1, false, true) - 1;
      const motion::LatticeWindow& w = shapes[c].window;
      for (std::int64_t j = w.j0; j < w.j1; j += 3) {
        for (std::int64_t i = w.i0; i < w.i1; i += 3) {
          if (!(shapes[c].value[k + 1][w.place(i, j)] < -1.5)) continue;
          EXPECT_EQ(class_at(section, {static_cast<double>(i) * step + 1e-9,
                                       static_cast<double>(j) * step + 1e-9}),
                    c);
        }
      }
    }
    EXPECT_EQ(section.nesting.outer.size(), regions);
    EXPECT_EQ(section.section.contours.size(), contours);
  }
}

using LayerRegion = std::pair<std::size_t, RegionId>;

// All regions that links among the layers first … last connect with this one.
std::vector<LayerRegion> reached(const InnerSections& inner, LayerRegion from, std::size_t first,
                                 std::size_t last) {
  std::vector<LayerRegion> found{from};
  for (bool changed = true; changed;) {
    changed = false;
    for (std::size_t k = first; k < last; ++k) {
      for (const LayerLink& link : inner.links[k]) {
        const LayerRegion low{k, link.below};
        const LayerRegion high{k + 1, link.above};
        const bool has_low = std::find(found.begin(), found.end(), low) != found.end();
        const bool has_high = std::find(found.begin(), found.end(), high) != found.end();
        if (has_low == has_high) continue;
        found.push_back(has_low ? high : low);
        changed = true;
      }
    }
  }
  std::sort(found.begin(), found.end());
  return found;
}

// Every class is one set, and no other is linked with it.
void expect_whole_classes(const SlabShape& slab, const InnerSections& inner) {
  std::vector<std::vector<LayerRegion>> regions(slab.classes.size());
  for (const ClassId c : slab.classes.ids()) {
    for (const RegionId r : slab.classes[c].lower) regions[c.index()].emplace_back(0, r);
    for (std::size_t k = 0; k < inner.sections.size(); ++k) {
      for (const RegionId r : inner.sections[k].class_of.ids()) {
        if (inner.sections[k].class_of[r] == c) regions[c.index()].emplace_back(k + 1, r);
      }
    }
    for (const RegionId r : slab.classes[c].upper) {
      regions[c.index()].emplace_back(inner.sections.size() + 1, r);
    }
    EXPECT_EQ(reached(inner, regions[c.index()].front(), 0, inner.links.size()),
              regions[c.index()]);
  }
}

// Pairs of regions in one layer that are connected both below and above it.
std::size_t parted_pairs(const InnerSections& inner) {
  std::size_t pairs = 0;
  for (std::size_t k = 1; k <= inner.sections.size(); ++k) {
    const std::size_t n = inner.sections[k - 1].class_of.size();
    for (std::size_t a = 0; a < n; ++a) {
      const auto below = reached(inner, {k, RegionId(a)}, 0, k);
      const auto above = reached(inner, {k, RegionId(a)}, k, inner.links.size());
      for (std::size_t b = a + 1; b < n; ++b) {
        const LayerRegion other{k, RegionId(b)};
        if (std::binary_search(below.begin(), below.end(), other) &&
            std::binary_search(above.begin(), above.end(), other)) {
          ++pairs;
        }
      }
    }
  }
  return pairs;
}

SectionStack stack_of(const SlabShape& slab, const InnerSections& inner) {
  SectionStack stack;
  stack.sections.push_back(slab.lower);
  for (const InnerSection& section : inner.sections) stack.sections.push_back(section.section);
  stack.sections.push_back(slab.upper);
  return stack;
}

TEST(TracedFields, AConeBetweenTwoOctagonsHasRoundSections) {
  const FieldSlab slab({{{octagon(0, 0, 2)},
                         {octagon(0, 0, 1)},
                         [](double x, double y, std::size_t layer) {
                           return to_disc(x, y, 0, 0, 2 - static_cast<double>(layer) / 4);
                         }}},
                       0.1, 3);
  ClassShapes shapes = slab.shapes();
  const TracedShapes traced = trace_shapes(slab.slab(), shapes);
  ASSERT_EQ(traced.inner.sections.size(), 3U);
  ASSERT_EQ(traced.inner.links.size(), 4U);
  for (std::size_t k = 0; k < 3; ++k) {
    const InnerSection& section = traced.inner.sections[k];
    ASSERT_EQ(section.section.contours.size(), 1U);
    EXPECT_EQ(section.section.z, static_cast<double>(k + 1) / 4);
    const double r = 2 - static_cast<double>(k + 1) / 4;
    const Contour& contour = section.section.contours[ContourId(0)];
    EXPECT_NEAR(twice_area(contour) / 2 / (3.14159265 * r * r), 1, 2e-3);
    EXPECT_LT(contour.vertices.size(), 40U);
  }
  for (const auto& links : traced.inner.links) {
    EXPECT_EQ(links, std::vector<LayerLink>({{RegionId(0), RegionId(0)}}));
  }
}

TEST(TracedFields, RandomOnesGiveValidSectionsThatShowThem) {
  std::size_t whole = 0;
  std::size_t bridged = 0;
  std::size_t layers = 0;
  std::size_t parted = 0;
  for (std::uint64_t seed = 1; seed <= 100; ++seed) {
    SCOPED_TRACE(seed);
    const RandomSlab random(seed);
    const FieldSlab slab(random.classes, random.step, random.layers);
    ClassShapes shapes = slab.shapes();
    TracedShapes traced = trace_shapes(slab.slab(), shapes);
    if (!traced.left_apart.empty()) {
      EXPECT_TRUE(traced.inner.sections.empty());
      shapes = slab.shapes();
      traced = trace_shapes(slab.slab(), shapes, traced.left_apart);
      bridged += traced.left_apart.empty() ? 1U : 0U;
    } else {
      ++whole;
    }
    if (!traced.left_apart.empty()) continue;
    ASSERT_EQ(traced.inner.sections.size(), random.layers);
    layers += random.layers;
    EXPECT_TRUE(validate(stack_of(slab.slab(), traced.inner)).ok());
    expect_sections_of(shapes, traced.inner, random.step);
    expect_whole_classes(slab.slab(), traced.inner);
    parted += parted_pairs(traced.inner);
  }
  EXPECT_GT(whole, 0U);
  EXPECT_GT(bridged, 80U);
  // Links by overlap alone, and other classes in the way, would leave some.
  EXPECT_LE(parted, layers / 50);
}

TEST(TracedFields, NothingDependsOnTheOrderOfContoursNorOnWhereTheyStart) {
  std::size_t compared = 0;
  for (std::uint64_t seed = 1; seed <= 30; ++seed) {
    SCOPED_TRACE(seed);
    RandomSlab random(seed);
    const FieldSlab slab(random.classes, random.step, random.layers);
    Prng prng(seed);
    for (FieldClass& c : random.classes) {
      for (std::vector<Contour>* contours : {&c.lower, &c.upper}) {
        prng.shuffle(*contours);
        for (Contour& contour : *contours) {
          const auto first = static_cast<std::ptrdiff_t>(prng.below(contour.vertices.size()));
          std::rotate(contour.vertices.begin(), contour.vertices.begin() + first,
                      contour.vertices.end());
          if (prng.chance(0.5)) std::reverse(contour.vertices.begin(), contour.vertices.end());
        }
      }
    }
    const FieldSlab other(random.classes, random.step, random.layers);
    const std::vector<ClassId> all{ClassId(0), ClassId(1), ClassId(2)};
    ClassShapes shapes = slab.shapes();
    ClassShapes other_shapes = other.shapes();
    const TracedShapes a = trace_shapes(slab.slab(), shapes, all);
    const TracedShapes b = trace_shapes(other.slab(), other_shapes, all);
    EXPECT_EQ(a.left_apart, b.left_apart);
    EXPECT_EQ(a.inner.links, b.inner.links);
    ASSERT_EQ(a.inner.sections.size(), b.inner.sections.size());
    for (std::size_t k = 0; k < a.inner.sections.size(); ++k) {
      ++compared;
      const Section& s = a.inner.sections[k].section;
      const Section& t = b.inner.sections[k].section;
      ASSERT_EQ(s.contours.size(), t.contours.size());
      for (const ContourId c : s.contours.ids()) {
        EXPECT_EQ(s.contours[c].vertices, t.contours[c].vertices);
      }
      EXPECT_EQ(a.inner.sections[k].class_of, b.inner.sections[k].class_of);
    }
  }
  EXPECT_GT(compared, 20U);
}

TEST(TracedFields, HeightsThatDoublesDoNotHoldApartGiveNothing) {
  const auto disc = [](double x, double y, std::size_t) { return to_disc(x, y, 0, 0, 1); };
  const FieldSlab slab({{{octagon(0, 0, 1)}, {octagon(0, 0, 1)}, disc}}, 0.1, 2);
  for (const auto& [low, high, made] :
       {std::tuple{1.0, std::nextafter(1.0, 2.0), false}, {1.0, 1 + 0x1p-50, true}}) {
    Section lower = slab.slab().lower;
    Section upper = slab.slab().upper;
    lower.z = low;
    upper.z = high;
    const SlabShape shape{lower,
                          upper,
                          slab.slab().lower_nesting,
                          slab.slab().upper_nesting,
                          slab.slab().classes,
                          slab.slab().step,
                          slab.slab().at};
    ClassShapes shapes = slab.shapes();
    EXPECT_EQ(!trace_shapes(shape, shapes).inner.sections.empty(), made);
  }
}

TEST(TracedFields, ClassesThatFadeOutLeaveEmptySections) {
  const auto tip = [](double x, double y, std::size_t layer) {
    return layer == 1 ? to_disc(x, y, 0, 0, 0.5) : 1.0;
  };
  const FieldSlab slab({{{octagon(0, 0, 1)}, {}, tip}}, 0.1, 3);
  ClassShapes shapes = slab.shapes();
  const InnerSections inner = trace_shapes(slab.slab(), shapes).inner;
  ASSERT_EQ(inner.sections.size(), 3U);
  EXPECT_EQ(inner.sections[0].section.contours.size(), 1U);
  EXPECT_TRUE(inner.sections[1].section.contours.empty());
  EXPECT_EQ(inner.links[0].size(), 1U);
  EXPECT_TRUE(inner.links[1].empty());
}

}  // namespace
}  // namespace tetloft::testing

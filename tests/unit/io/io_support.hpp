// What the tests of readers and writers share: files of their own, hard numbers, a model.
#pragma once

#include <gtest/gtest.h>

#include <bit>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

#include <tetloft/model.hpp>

#include "support/same_rows.hpp"
#include "support/temp_files.hpp"

namespace tetloft::test {

inline std::uint64_t bits(double value) { return std::bit_cast<std::uint64_t>(value); }

inline bool same_bits(const Point3& a, const Point3& b) {
  return bits(a.x) == bits(b.x) && bits(a.y) == bits(b.y) && bits(a.z) == bits(b.z);
}

/// Doubles that careless formatting loses.
inline std::vector<double> hard_doubles() {
  return {0.0,
          -0.0,
          0.1,
          1.0 / 3,
          0x1.fffffffffffffp0,
          0x1.0000000000001p0,
          1e22,
          1e23,
          1e-5,
          5e-324,
          -5e-324,
          0x1.fffffffffffffp-1023,
          0x1p-1022,
          1e300,
          -1e308,
          123456,
          1e15,
          -4.35e-7,
          9007199254740993.0,
          2.2250738585072011e-308};
}

inline double hard_number(int i) {
  const std::vector<double> hard = hard_doubles();
  return hard[static_cast<std::size_t>(i) % hard.size()];
}

/// Links of hard numbers, with every evidence and fate.
inline std::vector<RegionLink> hard_links(int count) {
  const auto number = [](int i) { return hard_number(i); };
  std::vector<RegionLink> links;
  for (int i = 0; i < count; ++i) {
    RegionLink link{SlabId(i),
                    ContourId(3 * i),
                    ContourId(i == 2 ? 0x7FFFFFFF : 1),
                    static_cast<Evidence>(i % kEvidences),
                    static_cast<LinkFate>(i % kLinkFates),
                    number(i),
                    number(i + 5),
                    number(i + 9),
                    number(i + 13),
                    {}};
    if (i % 3 != 1) link.lead = number(i + 1);
    links.push_back(link);
  }
  return links;
}

/// Rows of all tables, of unequal number, each with the hardest values of its columns.
inline void add_hard_rows(Model& model) {
  const auto number = [](int i) { return hard_number(i); };
  model.links = hard_links(kEvidences);
  for (const RegionLink& link : hard_links(kEvidences + 1)) model.void_links.push_back({link});
  model.void_links[0].lower = ContourId();
  model.void_links[1].upper = ContourId();
  constexpr std::int32_t kLargest = std::numeric_limits<std::int32_t>::max();
  model.deviations = {{SlabId(0), false, ContourId(2), -1, kLargest},
                      {SlabId(0), true, ContourId(0), -kLargest - 1, 0},
                      {SlabId(9), true, ContourId(0x7FFFFFFF), 3, -7}};
  for (int i = 0; i < 5; ++i) {
    model.motions.push_back({SlabId(i), i % 2 == 1, ContourId(7 - i), {number(i), number(i + 8)}});
  }
}

/// Two tets on hard points, with every label and all tables.
inline Model hard_model() {
  Model model;
  const std::vector<double> hard = hard_doubles();
  for (std::size_t i = 0; i + 2 < hard.size(); ++i) {
    model.points.push_back({hard[i], hard[i + 1], hard[i + 2]});
    model.section.push_back(i % 3 == 0 ? SectionId() : SectionId(i % 3 - 1));
    model.contour.push_back(i % 5 == 0 ? ContourId() : ContourId(i % 5 - 1));
    model.origin.push_back(static_cast<PointOrigin>(i % 5));
  }
  const auto tet = [](int a, int b, int c, int d) {
    return TetVertices{VertexId(a), VertexId(b), VertexId(c), VertexId(d)};
  };
  model.tets.push_back(tet(0, 1, 2, 3));
  model.tets.push_back(tet(4, 5, 6, 17));
  model.component.push_back(ComponentId(0));
  model.component.push_back(ComponentId(1));
  model.slab.push_back(SlabId(7));
  model.slab.push_back(SlabId(0));
  model.kind.push_back(TetKind::prism);
  model.kind.push_back(TetKind::t1_internal);
  model.component_count = 2;
  add_hard_rows(model);
  return model;
}

/// What every file of a solid has.
inline void expect_same_solid(const Model& a, const Model& b) {
  ASSERT_EQ(a.points.size(), b.points.size());
  for (VertexId v(0); v < a.points.end_id(); v = VertexId(v.index() + 1)) {
    EXPECT_TRUE(same_bits(a.points[v], b.points[v])) << v.index();
  }
  EXPECT_EQ(a.tets, b.tets);
  EXPECT_EQ(a.component, b.component);
  EXPECT_EQ(a.component_count, b.component_count);
}

inline void expect_same(const Model& a, const Model& b) {
  expect_same_solid(a, b);
  EXPECT_EQ(a.slab, b.slab);
  EXPECT_EQ(a.kind, b.kind);
  EXPECT_EQ(a.section, b.section);
  EXPECT_EQ(a.contour, b.contour);
  EXPECT_EQ(a.origin, b.origin);
  EXPECT_EQ(a.about, b.about);
  EXPECT_EQ(a.component_names, b.component_names);
  EXPECT_TRUE(same_rows(a.links, b.links));
  EXPECT_TRUE(same_rows(a.motions, b.motions));
  EXPECT_TRUE(same_rows(a.void_links, b.void_links));
  EXPECT_TRUE(same_rows(a.deviations, b.deviations));
}

}  // namespace tetloft::test

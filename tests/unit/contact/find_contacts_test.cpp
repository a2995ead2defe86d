// find_contacts() against all pairs.
#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

#include <gtest/gtest.h>

#include "contact/contact.hpp"
#include "core/prng.hpp"

namespace tetloft::contact_test {

using namespace internal;
namespace {

struct Soup {
  std::vector<Point3> points;
  std::vector<TriangleVertices> triangles;
};

std::vector<Contact> all_pairs(const Soup& soup, const std::vector<std::uint8_t>& active = {}) {
  std::vector<Contact> result;
  const auto& t = soup.triangles;
  for (std::uint32_t i = 0; i < t.size(); ++i) {
    for (std::uint32_t j = i + 1; j < t.size(); ++j) {
      if (!active.empty() && active[i] == 0 && active[j] == 0) continue;
      if (triangles_touch(soup.points, t[i], t[j])) result.push_back({i, j});
    }
  }
  return result;
}

/// Small triangles with vertices near a random place, some vertices shared.
Soup random_soup(std::size_t count, double size, bool lattice, Prng& random) {
  Soup soup;
  const auto snap = [&](double x) {
    return lattice ? static_cast<double>(static_cast<int>(x)) : x;
  };
  for (std::size_t i = 0; i < count; ++i) {
    const Point3 at{random.between(0, 20), random.between(0, 20), random.between(0, 5)};
    TriangleVertices t;
    for (std::size_t k = 0; k < 3; ++k) {
      if (!soup.points.empty() && random.chance(0.3)) {
        const std::size_t back = std::min<std::size_t>(soup.points.size(), 6);
        t[k] = VertexId(soup.points.size() - 1 - random.below(back));
        continue;
      }
      t[k] = VertexId(soup.points.size());
      soup.points.push_back({snap(at.x + random.between(0, size)),
                             snap(at.y + random.between(0, size)),
                             snap(at.z + random.between(0, size))});
    }
    soup.triangles.push_back(t);
  }
  return soup;
}

/// The closed surface of a box of n × n × n squares, each cut in two.
void append_box(int n, const Point3& corner, Soup& soup) {
  const std::size_t first = soup.points.size();
  std::vector<std::size_t> id(static_cast<std::size_t>((n + 1) * (n + 1) * (n + 1)), 0);
  const auto vertex = [&](const std::array<int, 3>& at) {
    std::size_t& v = id[static_cast<std::size_t>(at[0] + (n + 1) * (at[1] + (n + 1) * at[2]))];
    if (v == 0) {
      soup.points.push_back({corner.x + at[0], corner.y + at[1], corner.z + at[2]});
      v = soup.points.size() - first;
    }
    return VertexId(first + v - 1);
  };
  for (std::size_t a = 0; a < 3; ++a) {
    for (const int side : {0, n}) {
      for (int i = 0; i < n; ++i) {
        for (int j = 0; j < n; ++j) {
          const auto at = [&](int u, int v) {
            std::array<int, 3> p{};
            p[a] = side;
            p[(a + 1) % 3] = u;
            p[(a + 2) % 3] = v;
            return vertex(p);
          };
          soup.triangles.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1)});
          soup.triangles.push_back({at(i, j), at(i + 1, j + 1), at(i, j + 1)});
        }
      }
    }
  }
}

/// Fans of long triangles about few vertices, among small triangles; some through an apex.
Soup fans_soup(std::size_t fans, std::size_t blades, std::size_t small, bool flat, Prng& random) {
  Soup soup = random_soup(small, 0.5, false, random);
  for (std::size_t f = 0; f < fans; ++f) {
    const VertexId apex(soup.points.size());
    soup.points.push_back({random.between(0, 20), random.between(0, 20), flat ? 1 : 2.5});
    const Point3 at = soup.points.back();
    const auto rim = [&](double angle) {
      const double length = random.between(2, 9);
      const double tilt = flat ? 0 : random.between(-0.3, 0.3);
      return Point3{at.x + length * std::cos(angle), at.y + length * std::sin(angle),
                    at.z + length * tilt};
    };
    for (std::size_t k = 0; k < blades; ++k) {
      const double angle = 6.28 * static_cast<double>(k) / static_cast<double>(blades);
      // Now and then a blade as wide as the next ones, or half of the circle.
      const double width = random.below(8) == 0 ? random.between(0.02, 3.5) : 4 / 1e3;
      const VertexId first(soup.points.size());
      soup.points.push_back(rim(angle));
      soup.points.push_back(rim(angle + width));
      soup.triangles.push_back({apex, first, VertexId(first.index() + 1)});
    }
    // Triangles that hold the apex without having it as their vertex, inside and at a corner.
    for (const double back : {-1.0, 0.0}) {
      const VertexId first(soup.points.size());
      soup.points.push_back({at.x + back, at.y + back, at.z});
      soup.points.push_back({at.x + 2, at.y + 0.5, at.z});
      soup.points.push_back({at.x + 0.5, at.y + 2, at.z});
      soup.triangles.push_back({first, VertexId(first.index() + 1), VertexId(first.index() + 2)});
    }
  }
  return soup;
}

TEST(FindContacts, OfFansAgreesWithAllPairs) {
  Prng random(11);
  for (int round = 0; round < 12; ++round) {
    const Soup soup = fans_soup(2, 90, 150, round % 2 == 0, random);
    const std::vector<Contact> expected = all_pairs(soup);
    EXPECT_GT(expected.size(), 20U);
    EXPECT_EQ(find_contacts(soup.points, soup.triangles), expected);
    std::vector<std::uint8_t> active(soup.triangles.size());
    for (std::uint8_t& flag : active) flag = random.below(3) != 0 ? 1 : 0;
    EXPECT_EQ(find_contacts(soup.points, soup.triangles, static_cast<std::size_t>(-1), active),
              all_pairs(soup, active));
    const std::vector<Contact> lowest(expected.begin(), expected.begin() + 10);
    EXPECT_EQ(find_contacts(soup.points, soup.triangles, 10), lowest);
  }
}

/// Strips of slivers that lie one above the other and cross, `gap` apart: each as long as 100 of
/// them are wide at `slivers` = 100. Triangles of a strip share vertices; at some places one pokes
/// through.
Soup crossing_strips(std::size_t slivers, double gap, std::size_t pokes, Prng& random) {
  Soup soup;
  for (std::size_t layer = 0; layer < 2; ++layer) {
    const double angle = layer == 0 ? 0.6 : 1.3;
    const double x = std::cos(angle), y = std::sin(angle);
    const std::size_t first = soup.points.size();
    for (std::size_t k = 0; k <= slivers; ++k) {
      const double aside = 1.0 / 3 * static_cast<double>(k) / static_cast<double>(slivers);
      for (const double along : {-1.0, 1.0}) {
        soup.points.push_back({along * x - aside * y, along * y + aside * x,
                               gap * static_cast<double>(layer) + 0.02 * along});
      }
    }
    for (std::size_t k = first; k + 2 < soup.points.size(); ++k) {
      soup.triangles.push_back({VertexId(k), VertexId(k + 1), VertexId(k + 2)});
    }
  }
  const std::size_t half = soup.points.size() / 2;
  for (; pokes > 0; --pokes) soup.points[random.below(half)].z += 4 * gap;
  return soup;
}

TEST(FindContacts, OfCrossingStripsAgreesWithAllPairs) {
  Prng random(12);
  for (const std::size_t pokes : {0U, 1U, 3U}) {
    const Soup soup = crossing_strips(150, 0.02, pokes, random);
    const std::vector<Contact> expected = all_pairs(soup);
    EXPECT_EQ(expected.empty(), pokes == 0);
    EXPECT_EQ(find_contacts(soup.points, soup.triangles), expected);
    // Some active and many, and very few.
    for (const std::size_t one_in : {3U, 100U}) {
      std::vector<std::uint8_t> active(soup.triangles.size());
      for (std::uint8_t& flag : active) flag = random.below(one_in) == 0 ? 1 : 0;
      EXPECT_EQ(find_contacts(soup.points, soup.triangles, static_cast<std::size_t>(-1), active),
                all_pairs(soup, active));
    }
  }
}

// All boxes of one strip meet most of the other's; by pairs the work would grow with the square.
TEST(FindContacts, OfCrossingStripsTestsAboutAsManyPairsAsThereAreTriangles) {
  Prng random(13);
  for (const std::size_t slivers : {500U, 2000U}) {
    const Soup soup = crossing_strips(slivers, 0.02, 0, random);
    std::uint64_t tested = 0;
    EXPECT_TRUE(
        find_contacts(soup.points, soup.triangles, static_cast<std::size_t>(-1), {}, &tested)
            .empty());
    EXPECT_LT(tested, 20 * soup.triangles.size());
  }
}

// A fan alone, its blades far from each other but at the apex: the pairs tested grow with the
// blades, not with their square.
TEST(FindContacts, OfAFanTestsFewPairs) {
  for (const std::size_t blades : {1000U, 8000U}) {
    Soup soup;
    soup.points.push_back({0, 0, 0});
    for (std::size_t k = 0; k < 2 * blades; ++k) {
      const double angle = 6.28 * static_cast<double>(k) / static_cast<double>(2 * blades);
      soup.points.push_back({std::cos(angle), std::sin(angle), 0.1 * std::cos(9 * angle)});
    }
    for (std::size_t k = 0; k < blades; ++k) {
      soup.triangles.push_back({VertexId(0), VertexId(2 * k + 1), VertexId(2 * k + 2)});
    }
    std::uint64_t tested = 0;
    EXPECT_TRUE(find_contacts(soup.points, soup.triangles, 10, {}, &tested).empty());
    EXPECT_LT(tested, 4 * blades);
  }
}

/// Triangles as long as the soup is wide and as thin as they are many, in any direction of the
/// plane, some of which share a vertex, at heights that differ little.
Soup slivers(std::size_t count, double height, Prng& random) {
  Soup soup;
  for (std::size_t i = 0; i < count; ++i) {
    const Point3 at{random.between(-1, 1), random.between(-1, 1), height * random.unit()};
    const double angle = random.between(0, 6.283185307179586);
    const Point3 along{0.5 * std::cos(angle), 0.5 * std::sin(angle), height * random.unit()};
    TriangleVertices t;
    for (std::size_t k = 0; k < 3; ++k) {
      if (k == 0 && i > 0 && random.chance(0.2)) {
        t[k] = VertexId(random.below(soup.points.size()));
        continue;
      }
      const double far = static_cast<double>(k % 2);
      t[k] = VertexId(soup.points.size());
      soup.points.push_back({at.x + far * along.x + random.between(0, 1e-3),
                             at.y + far * along.y + random.between(0, 1e-3), at.z + far * along.z});
    }
    soup.triangles.push_back(t);
  }
  return soup;
}

TEST(FindContacts, OfSliversAgreesWithAllPairs) {
  Prng random(31);
  std::size_t contacts = 0;
  for (const double height : {0.0, 1e-3, 1.0}) {
    for (const double far : {0.0, 1e9, 1e300}) {
      Soup soup = slivers(150, height, random);
      for (Point3& p : soup.points) {
        p.x += far;
        p.y -= far;
      }
      const std::vector<Contact> found = find_contacts(soup.points, soup.triangles);
      ASSERT_EQ(found, all_pairs(soup));
      contacts += found.size();
    }
  }
  EXPECT_GT(contacts, 100U);
}

// Side by side and askew: all of their boxes along the axes meet.
TEST(FindContacts, OfParallelSliversTestsFewPairs) {
  for (const Point2 along : {Point2{1, 1}, Point2{1, -1}, Point2{2, 1}, Point2{1, -2}}) {
    Soup soup;
    constexpr int kCount = 1000;
    for (int k = 0; k < kCount; ++k) {
      const double x = -along.y * k / kCount;
      const double y = along.x * k / kCount;
      TriangleVertices t;
      for (std::size_t i = 0; i < 3; ++i) t[i] = VertexId(soup.points.size() + i);
      soup.points.push_back({x, y, 0});
      soup.points.push_back({x + 9 * along.x, y + 9 * along.y, 1});
      soup.points.push_back({x + 9 * along.x, y + 9 * along.y, 1.5});
      soup.triangles.push_back(t);
    }
    std::uint64_t tested = 0;
    EXPECT_TRUE(find_contacts(soup.points, soup.triangles, 9, {}, &tested).empty());
    EXPECT_LT(tested, 10U * kCount);
  }
}

TEST(FindContacts, AgreesWithAllPairsOnRandomSoups) {
  Prng random(31);
  std::size_t found = 0;
  for (int round = 0; round < 30; ++round) {
    const Soup soup =
        random_soup(20 + random.below(300), random.between(0.5, 4), round % 2 == 0, random);
    const std::vector<Contact> expected = all_pairs(soup);
    ASSERT_EQ(find_contacts(soup.points, soup.triangles), expected) << "round " << round;
    found += expected.size();
  }
  EXPECT_GT(found, 1000U);
}

TEST(FindContacts, ReportsTheLowestUpToTheLimit) {
  Prng random(32);
  const Soup soup = random_soup(300, 4, true, random);
  const std::vector<Contact> all = all_pairs(soup);
  ASSERT_GT(all.size(), 200U);
  for (const std::size_t limit : {0UL, 1UL, 2UL, 50UL, all.size() - 1, all.size(), 9999999UL}) {
    std::vector<Contact> expected = all;
    expected.resize(std::min(limit, all.size()));
    EXPECT_EQ(find_contacts(soup.points, soup.triangles, limit), expected) << limit;
  }
}

TEST(FindContacts, TestsOnlyPairsWithAnActiveTriangle) {
  Prng random(33);
  for (const double share : {0.0, 0.01, 0.3, 1.0}) {
    const Soup soup = random_soup(400, 3, true, random);
    std::vector<std::uint8_t> active(soup.triangles.size());
    for (std::uint8_t& flag : active) flag = random.chance(share) ? 2 : 0;
    EXPECT_EQ(find_contacts(soup.points, soup.triangles, static_cast<std::size_t>(-1), active),
              all_pairs(soup, active))
        << share;
  }
}

TEST(FindContacts, ClosedSurfaceHasNone) {
  Soup soup;
  append_box(6, {0, 0, 0}, soup);
  EXPECT_TRUE(find_contacts(soup.points, soup.triangles).empty());
}

TEST(FindContacts, BoxesThatTouchAtACornerHaveContactsThere) {
  Soup soup;
  append_box(3, {0, 0, 0}, soup);
  append_box(3, {3, 3, 3}, soup);
  const std::vector<Contact> contacts = find_contacts(soup.points, soup.triangles);
  EXPECT_EQ(contacts, all_pairs(soup));
  ASSERT_FALSE(contacts.empty());
  for (const Contact& c : contacts) {
    EXPECT_LT(c.first, soup.triangles.size() / 2);
    EXPECT_GE(c.second, soup.triangles.size() / 2);
  }
}

TEST(FindContacts, BoxesThatShareAWallAreInContactAllOverIt) {
  Soup soup;
  append_box(4, {0, 0, 0}, soup);
  append_box(4, {4, 0, 0}, soup);
  const std::vector<Contact> contacts = find_contacts(soup.points, soup.triangles);
  EXPECT_EQ(contacts, all_pairs(soup));
  EXPECT_GE(contacts.size(), 32U);
}

TEST(FindContacts, SurvivesTheWholeRangeOfDoubles) {
  Prng random(34);
  for (const double scale : {0x1p1020, 0x1p-1074, 0x1p-1030}) {
    Soup soup = random_soup(100, 4, true, random);
    for (Point3& p : soup.points) p = {(p.x - 10) * scale, (p.y - 10) * scale, p.z * scale};
    EXPECT_EQ(find_contacts(soup.points, soup.triangles), all_pairs(soup)) << scale;
  }
}

TEST(FindContacts, AllTrianglesAtOnePlace) {
  // Identical boxes: the tree cannot separate them, and must still end.
  Soup soup;
  for (int i = 0; i < 40; ++i) {
    const std::size_t v = soup.points.size();
    soup.points.insert(soup.points.end(), {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}});
    soup.triangles.push_back({VertexId(v), VertexId(v + 1), VertexId(v + 2)});
  }
  EXPECT_EQ(find_contacts(soup.points, soup.triangles).size(), 40U * 39U / 2U);
}

TEST(FindContacts, NothingTouchesInASoupOfNoneOrOne) {
  Soup soup;
  EXPECT_TRUE(find_contacts(soup.points, soup.triangles).empty());
  soup.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  soup.triangles = {{VertexId(0), VertexId(1), VertexId(2)}};
  EXPECT_TRUE(find_contacts(soup.points, soup.triangles).empty());
}

}  // namespace
}  // namespace tetloft::contact_test

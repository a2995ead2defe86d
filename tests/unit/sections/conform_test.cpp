// conform(): the triangulation and every label against definitions.
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>

#include "sections/conforming_section.hpp"
#include "support/exact/predicates.hpp"
#include "support/stacks/generate.hpp"
#include "unit/sections/shapes.hpp"

namespace tetloft::testing {
namespace {

using oracle::Rational;

// The contours as they are after splitting, from next and contour alone.
std::vector<Contour> bent_contours(const ConformingSection& s, std::size_t contours) {
  std::vector<Contour> result(contours);
  std::vector<bool> seen(s.vertex_count(), false);
  for (std::size_t v = 0; v < s.vertex_count(); ++v) {
    for (PlaneVertexId u(v); !seen[u.index()]; u = s.next[u]) {
      seen[u.index()] = true;
      result[s.contour[u].index()].vertices.push_back(s.point(u));
    }
  }
  return result;
}

void expect_canonical_delaunay(const ConformingSection& s) {
  const Triangulation2& t = s.triangulation;
  for (std::size_t v = 1; v < s.vertex_count(); ++v) {
    ASSERT_TRUE(canonical_less(s.point(PlaneVertexId(v - 1)), s.point(PlaneVertexId(v))));
  }
  ASSERT_TRUE(std::is_sorted(t.triangles.begin(), t.triangles.end()));
  for (std::size_t k = 0; k < t.triangles.size(); ++k) {
    const PlaneTriangleVertices& v = t.triangles[TriangleId(k)];
    ASSERT_EQ(oracle::orient2d(s.point(v[0]), s.point(v[1]), s.point(v[2])), 1);
    ASSERT_TRUE(v[0] < v[1] && v[0] < v[2]);
    for (std::size_t i = 0; i < 3; ++i) {
      const TriangleId other = t.neighbours[TriangleId(k)][i];
      if (!other.valid()) continue;
      const PlaneTriangleVertices& w = t.triangles[other];
      std::size_t j = 0;
      while (j < 3 && t.neighbours[other][j] != TriangleId(k)) ++j;
      ASSERT_LT(j, 3U);
      ASSERT_EQ(w[(j + 1) % 3], v[(i + 2) % 3]);
      ASSERT_EQ(w[(j + 2) % 3], v[(i + 1) % 3]);
      ASSERT_EQ(
          oracle::incircle_perturbed(s.point(v[0]), s.point(v[1]), s.point(v[2]), s.point(w[j])),
          -1);
    }
  }
}

void expect_edges_and_look_ups(const ConformingSection& s) {
  const auto edges = internal::sections::edges_of_sides(s);
  std::map<std::pair<PlaneVertexId, PlaneVertexId>, std::pair<TriangleId, TriangleId>> sides;
  for (std::size_t k = 0; k < s.triangulation.triangles.size(); ++k) {
    const PlaneTriangleVertices& v = s.triangulation.triangles[TriangleId(k)];
    for (std::size_t i = 0; i < 3; ++i) {
      const PlaneVertexId a = v[i];
      const PlaneVertexId b = v[(i + 1) % 3];
      auto& side = sides[{std::min(a, b), std::max(a, b)}];
      (a < b ? side.first : side.second) = TriangleId(k);
    }
    for (std::size_t i = 0; i < 3; ++i) {
      ASSERT_EQ(edges[TriangleId(k)][i], s.find_edge(v[(i + 1) % 3], v[(i + 2) % 3]));
    }
    ASSERT_EQ(s.find_triangle(v[1], v[2], v[0]), TriangleId(k));
    ASSERT_EQ(s.find_triangle(v[2], v[1], v[0]), TriangleId(k));
  }
  ASSERT_EQ(s.edges.size(), sides.size());
  std::size_t e = 0;
  for (const auto& [ends, side] : sides) {
    const ConformingSection::Edge& edge = s.edges[EdgeId(e)];
    ASSERT_EQ(edge.a, ends.first);
    ASSERT_EQ(edge.b, ends.second);
    ASSERT_EQ(edge.left, side.first);
    ASSERT_EQ(edge.right, side.second);
    ASSERT_EQ(s.find_edge(edge.b, edge.a), EdgeId(e));
    ++e;
  }
  for (std::size_t u = 0; u < std::min<std::size_t>(s.vertex_count(), 12); ++u) {
    for (std::size_t v = u + 1; v < s.vertex_count(); ++v) {
      const bool is_edge = sides.count({PlaneVertexId(u), PlaneVertexId(v)}) != 0;
      ASSERT_EQ(s.find_edge(PlaneVertexId(u), PlaneVertexId(v)).valid(), is_edge);
    }
  }
}

void expect_contours(const Section& section, const ConformingSection& s) {
  const std::size_t n = s.vertex_count();
  std::set<std::pair<PlaneVertexId, PlaneVertexId>> pieces;
  std::size_t inputs = 0;
  for (std::size_t k = 0; k < n; ++k) {
    const PlaneVertexId v(k);
    ASSERT_EQ(s.previous[s.next[v]], v);
    ASSERT_EQ(s.contour[s.next[v]], s.contour[v]);
    ASSERT_EQ(s.region[v], s.nesting.region[s.contour[v]]);
    pieces.insert({std::min(v, s.next[v]), std::max(v, s.next[v])});
    const EdgeId id = s.find_edge(v, s.next[v]);
    ASSERT_TRUE(id.valid());
    const ConformingSection::Edge& edge = s.edges[id];
    const TriangleId left = v < s.next[v] ? edge.left : edge.right;
    const TriangleId right = v < s.next[v] ? edge.right : edge.left;
    ASSERT_TRUE(left.valid() && s.internal[left] != 0);
    ASSERT_TRUE(!right.valid() || s.internal[right] == 0);

    const std::vector<Point2>& input = section.contours[s.contour[v]].vertices;
    if (s.input_vertex[v] != ConformingSection::kNotInput) {
      ++inputs;
      ASSERT_EQ(s.point(v), input[s.input_vertex[v]]);
      ASSERT_EQ(s.edge_of[v], s.input_vertex[v]);
    } else {
      // Off its input edge by 8 ulps of its coordinates at most.
      const Point2& a = input[s.edge_of[v]];
      const Point2& b = input[(s.edge_of[v] + 1) % input.size()];
      const double size =
          std::max(std::max(std::abs(a.x), std::abs(a.y)), std::max(std::abs(b.x), std::abs(b.y)));
      const Rational dx = Rational::exactly(b.x) - Rational::exactly(a.x);
      const Rational dy = Rational::exactly(b.y) - Rational::exactly(a.y);
      const Rational off = dx * (Rational::exactly(s.point(v).y) - Rational::exactly(a.y)) -
                           dy * (Rational::exactly(s.point(v).x) - Rational::exactly(a.x));
      const Rational reach = dx.abs() + dy.abs();
      ASSERT_LE(off.abs(), reach * Rational::exactly(size) * Rational::exactly(0x1p-49));
    }
  }
  std::size_t expected = 0;
  for (const Contour& c : section.contours) expected += c.vertices.size();
  ASSERT_EQ(inputs, expected);
  for (std::size_t e = 0; e < s.edges.size(); ++e) {
    const ConformingSection::Edge& edge = s.edges[EdgeId(e)];
    ASSERT_EQ(edge.kind == EdgeKind::contour, pieces.count({edge.a, edge.b}) != 0);
  }
}

void expect_labels(const ConformingSection& s, const std::vector<Contour>& bent) {
  const Rational third = Rational(1) / Rational(3);
  for (std::size_t k = 0; k < s.triangulation.triangles.size(); ++k) {
    Rational x;
    Rational y;
    for (const PlaneVertexId v : s.triangulation.triangles[TriangleId(k)]) {
      x = x + Rational::exactly(s.point(v).x) * third;
      y = y + Rational::exactly(s.point(v).y) * third;
    }
    int around = 0;
    for (const Contour& c : bent) around += is_inside(c, x, y) ? 1 : 0;
    ASSERT_EQ(s.internal[TriangleId(k)] != 0, around % 2 != 0);
  }
  for (const ConformingSection::Edge& edge : s.edges) {
    const bool left = edge.left.valid() && s.internal[edge.left] != 0;
    const bool right = edge.right.valid() && s.internal[edge.right] != 0;
    ASSERT_EQ(edge.kind == EdgeKind::contour, left != right);
    if (edge.kind != EdgeKind::contour) {
      ASSERT_EQ(edge.kind == EdgeKind::internal, left);
    }
  }
}

void expect_conforming(const Section& section, const ConformingSection& s) {
  expect_canonical_delaunay(s);
  expect_edges_and_look_ups(s);
  expect_contours(section, s);
  const std::vector<Contour> bent = bent_contours(s, section.contours.size());
  expect_labels(s, bent);
  Section again = section;
  again.contours = IdVector<ContourId, Contour>(bent);
  ASSERT_TRUE(validate(stack({again})).ok());
  ASSERT_EQ(nest(again).parent, s.nesting.parent);
  ASSERT_EQ(nest(section).parent, s.nesting.parent);
}

TEST(Conform, HoldsItsContractOnGeneratedSections) {
  std::size_t splits = 0;
  for (const StackKind kind : all_kinds()) {
    for (std::uint64_t seed = 1; seed < 2; ++seed) {
      const SectionStack stack = generate(kind, seed).stack;
      const SectionId id(seed % stack.sections.size());
      const Section& section = stack.sections[id];
      const Result<ConformingSection> s = conform(section, id);
      if (!s && is_near_coincident(kind)) continue;
      ASSERT_TRUE(s.ok()) << name_of(kind) << ' ' << seed << ' ' << to_string(s.error());
      expect_conforming(section, *s);
      if (HasFatalFailure()) FAIL() << name_of(kind) << " seed " << seed;
      splits += static_cast<std::size_t>(
          std::count(s->input_vertex.begin(), s->input_vertex.end(), ConformingSection::kNotInput));
    }
  }
  EXPECT_GT(splits, 0U);
}

TEST(Conform, HoldsItsContractWhereManyEdgesAreSplit) {
  Prng prng(8);
  std::size_t splits = 0;
  for (int round = 0; round < 8; ++round) {
    // Narrow arms of stars, holes close to the boundary.
    const double tall = round % 2 == 0 ? 1 : 0.1;
    Contour star = random_star(prng, 0, 0, 60, 16);
    for (Point2& p : star.vertices) p.y *= tall;
    const Contour hole = rectangle(-0.5, -0.01, 0.25, 0.0078125);
    const Section section = testing::section(1, {star, hole});
    ASSERT_TRUE(validate(stack({section})).ok());
    const Result<ConformingSection> s = conform(section, SectionId(0));
    ASSERT_TRUE(s.ok());
    expect_conforming(section, *s);
    if (HasFatalFailure()) FAIL() << "round " << round;
    splits += s->vertex_count() - star.vertices.size() - 4;
  }
  EXPECT_GT(splits, 100U);
}

TEST(Conform, SplitsEdgesThatAreNotDelaunay) {
  // A long thin box with a vertex close to its long side.
  const Section section =
      testing::section(2, {rectangle(0, 0, 32, 1), contour({{16, 1.5}, {17, 3}, {15, 3}})});
  const Result<ConformingSection> s = conform(section, SectionId(0));
  ASSERT_TRUE(s.ok());
  EXPECT_GT(s->vertex_count(), 7U);
  EXPECT_EQ(s->z, 2);
  EXPECT_EQ(s->point3(PlaneVertexId(0)), (Point3{0, 0, 2}));
  expect_conforming(section, *s);
}

TEST(Conform, TakesAnEmptySection) {
  const Result<ConformingSection> s = conform(section(3, {}), SectionId(1));
  ASSERT_TRUE(s.ok());
  EXPECT_EQ(s->z, 3);
  EXPECT_EQ(s->vertex_count(), 0U);
  EXPECT_EQ(s->first_edge.size(), 1U);
  EXPECT_FALSE(s->find_edge(PlaneVertexId(0), PlaneVertexId(1)).valid());
  EXPECT_FALSE(s->find_triangle(PlaneVertexId(0), PlaneVertexId(1), PlaneVertexId(2)).valid());
}

TEST(Conform, DoesNotDependOnOrderStartOrDirection) {
  Prng prng(5);
  for (const StackKind kind : all_kinds()) {
    const Section section = generate(kind, 11).stack.sections[SectionId(0)];
    const Result<ConformingSection> s = conform(section, SectionId(0));
    if (!s) continue;
    std::vector<std::size_t> order(section.contours.size());
    for (std::size_t k = 0; k < order.size(); ++k) order[k] = k;
    prng.shuffle(order);
    std::vector<Contour> contours;
    for (const std::size_t c : order) {
      const Contour& original = section.contours[ContourId(c)];
      contours.push_back(rotated(prng.chance(0.5) ? reversed(original) : original,
                                 prng.below(original.vertices.size())));
    }
    const Result<ConformingSection> t =
        conform(testing::section(section.z, contours), SectionId(0));
    ASSERT_TRUE(t.ok());
    ASSERT_EQ(s->triangulation.points, t->triangulation.points) << name_of(kind);
    ASSERT_EQ(s->triangulation.triangles, t->triangulation.triangles) << name_of(kind);
    ASSERT_EQ(s->triangulation.neighbours, t->triangulation.neighbours);
    ASSERT_EQ(s->internal, t->internal);
    ASSERT_EQ(s->next, t->next);
    ASSERT_EQ(s->previous, t->previous);
    ASSERT_EQ(s->region, t->region);
    for (std::size_t e = 0; e < s->edges.size(); ++e) {
      ASSERT_EQ(s->edges[EdgeId(e)].kind, t->edges[EdgeId(e)].kind);
    }
    for (std::size_t v = 0; v < s->vertex_count(); ++v) {
      ASSERT_EQ(s->contour[PlaneVertexId(v)].index(), order[t->contour[PlaneVertexId(v)].index()]);
    }
  }
}

TEST(Conform, MakesTheEdgesOfGivenContoursGabriel) {
  const auto is_gabriel = [](const ConformingSection& s, PlaneVertexId a, PlaneVertexId b) {
    for (std::size_t k = 0; k < s.vertex_count(); ++k) {
      const PlaneVertexId v(k);
      if (v == a || v == b) continue;
      const auto part = [&](double p, double q, double r) {
        return (Rational::exactly(p) - Rational::exactly(r)) *
               (Rational::exactly(q) - Rational::exactly(r));
      };
      const Rational dot = part(s.point(a).x, s.point(b).x, s.point(v).x) +
                           part(s.point(a).y, s.point(b).y, s.point(v).y);
      if (dot.sign() <= 0) return false;
    }
    return true;
  };
  const Section section =
      testing::section(0, {contour({{0, 0}, {16, 0}, {8, 2}}), rectangle(0, 5, 16, 40)});
  const Result<ConformingSection> plain = conform(section, SectionId(0));
  const Result<ConformingSection> s =
      conform(section, SectionId(0),
              {.gabriel = IdVector<ContourId, bool>(std::vector<bool>{true, false})});
  ASSERT_TRUE(plain.ok() && s.ok());
  bool some_not = false;
  for (std::size_t k = 0; k < plain->vertex_count(); ++k) {
    some_not = some_not || !is_gabriel(*plain, PlaneVertexId(k), plain->next[PlaneVertexId(k)]);
  }
  EXPECT_TRUE(some_not);
  for (std::size_t k = 0; k < s->vertex_count(); ++k) {
    if (s->contour[PlaneVertexId(k)] == ContourId(0)) {
      EXPECT_TRUE(is_gabriel(*s, PlaneVertexId(k), s->next[PlaneVertexId(k)]));
    }
  }
  expect_conforming(section, *s);
  EXPECT_EQ(conform(section, SectionId(0), {.gabriel = IdVector<ContourId, bool>(3)}).error().code,
            ErrorCode::usage);
}

TEST(Conform, NamesWhereThereIsNoRoomToSplit) {
  // Two long sides one unit in the last place apart: no double lies between to split at.
  const double y = 0x1p52;
  const Section thin =
      testing::section(7, {contour({{y, y}, {y + 1, y + 8}, {y + 2, y + 15}, {y + 1, y + 7}})});
  ASSERT_TRUE(validate(stack({thin})).ok());
  const Result<ConformingSection> s = conform(thin, SectionId(4));
  if (s) {
    expect_conforming(thin, *s);
    return;
  }
  EXPECT_EQ(s.error().code, ErrorCode::unrepresentable);
  EXPECT_EQ(s.error().where.section, 4U);
  EXPECT_EQ(s.error().where.contour, 0U);
  EXPECT_TRUE(s.error().where.vertex.has_value());
  ASSERT_TRUE(s.error().where.point.has_value());
  EXPECT_EQ(s.error().where.point->z, 7);
}

TEST(Conform, RefusesWhereRoundingTurnsAContour) {
  const double s = 0x1p52;
  const Contour thin = moved(contour({{10, 11}, {13, 1}, {12, 5}}), 1, {s, s});
  const Contour near = moved(contour({{4, 12}, {2, 2}, {10, 2}}), 1, {s, s});
  const Section section = testing::section(0, {thin, near});
  ASSERT_TRUE(validate(stack({section})).ok());
  const Result<ConformingSection> result = conform(section, SectionId(0));
  ASSERT_FALSE(result.ok());
  EXPECT_EQ(result.error().code, ErrorCode::unrepresentable);
  EXPECT_EQ(result.error().where.contour, 0U);
}

// Slivers of a few units in the last place: whatever is delivered is valid.
TEST(Conform, IsValidOrRefusesOnCoarseLattices) {
  Prng prng(99);
  int delivered = 0;
  int refused = 0;
  for (int round = 0; round < 3000; ++round) {
    std::vector<Contour> contours(1 + prng.below(2));
    for (Contour& c : contours) {
      c.vertices.resize(3 + prng.below(3));
      for (Point2& p : c.vertices) {
        p = {0x1p52 + static_cast<double>(prng.below(40)),
             0x1p52 + static_cast<double>(prng.below(8))};
      }
    }
    const Section section = testing::section(0, contours);
    if (!validate(stack({section})).ok()) continue;
    const Result<ConformingSection> s = conform(section, SectionId(0));
    if (!s) {
      ++refused;
      ASSERT_EQ(s.error().code, ErrorCode::unrepresentable) << to_string(s.error());
      continue;
    }
    ++delivered;
    std::vector<Contour> bent = bent_contours(*s, contours.size());
    ASSERT_TRUE(validate(one(bent)).ok());
    ASSERT_EQ(nest(testing::section(0, bent)).parent, nest(section).parent);
    for (std::size_t c = 0; c < contours.size(); ++c) {
      // next keeps the region on the left, whatever way the input ran.
      const bool outer = s->nesting.depth[ContourId(c)] % 2 == 0;
      ASSERT_EQ(area_sign(bent[c]), outer ? Sign::positive : Sign::negative);
    }
  }
  EXPECT_GT(delivered, 100);
  EXPECT_GT(refused, 10);
}

TEST(ConformInterior, VerticesInsideBelongToTheirRegionAndToNoContour) {
  Section section;
  for (const Contour& c :
       {Contour{{{0, 0}, {9, 0}, {9, 9}, {0, 9}}}, Contour{{{3, 3}, {6, 3}, {6, 6}, {3, 6}}},
        Contour{{{20, 0}, {24, 0}, {24, 4}, {20, 4}}}}) {
    section.contours.push_back(c);
  }
  // The second is so near an edge of the hole that the edge must be split.
  const std::vector<Point2> interior{{1.5, 4.5}, {4.5, 2.9}, {22, 2}};
  const auto conforming = conform(section, SectionId(0), {.interior = interior});
  ASSERT_TRUE(conforming) << to_string(conforming.error());
  expect_canonical_delaunay(*conforming);
  std::size_t inside = 0;
  for (std::size_t k = 0; k < conforming->vertex_count(); ++k) {
    const PlaneVertexId v(k);
    if (conforming->contour[v].valid()) continue;
    ++inside;
    const Point2& p = conforming->point(v);
    EXPECT_NE(std::find(interior.begin(), interior.end(), p), interior.end());
    EXPECT_EQ(conforming->region[v], conforming->nesting.region[ContourId(p.x > 10 ? 2 : 0)]);
    EXPECT_FALSE(conforming->next[v].valid());
  }
  EXPECT_EQ(inside, 3U);
  EXPECT_GT(conforming->vertex_count(), 15U);
}

TEST(ConformInterior, RefusesVerticesThatAreNotInside) {
  Section section;
  section.contours.push_back(Contour{{{0, 0}, {9, 0}, {9, 9}, {0, 9}}});
  section.contours.push_back(Contour{{{3, 3}, {6, 3}, {6, 6}, {3, 6}}});
  for (const Point2 p : {Point2{4.5, 4.5}, Point2{-1, 3}, Point2{3, 3}}) {
    const auto refused = conform(section, SectionId(2), {.interior = {p}});
    ASSERT_FALSE(refused) << p.x;
    EXPECT_EQ(refused.error().code, ErrorCode::invalid_input);
    EXPECT_EQ(refused.error().where.section, 2U);
  }
}

}  // namespace
}  // namespace tetloft::testing

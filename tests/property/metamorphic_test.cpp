// What must not matter, or matter in a known way: mirrors, quarter turns, the direction of z, exact
// translation, and cutting a stack in two. (Powers of two: scale_test.cpp. Order, start and
// direction of contours, threads and engines: tests/unit/reconstruct/determinism_test.cpp.)
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <map>
#include <set>
#include <string>
#include <tuple>
#include <vector>

#include <tetloft/check.hpp>
#include <tetloft/delaunay.hpp>
#include <tetloft/reconstruct.hpp>

#include "core/prng.hpp"
#include "support/stacks/generate.hpp"

namespace tetloft::testing {

using namespace internal;
namespace {

constexpr std::uint64_t kFirstSeed = 700;
constexpr std::uint64_t kSeeds = 3;

Result<Reconstruction> run(const SectionStack& stack, const CorrespondenceOptions& correspondence) {
  ReconstructOptions options;
  options.execution.threads = 1;
  options.correspondence = correspondence;
  return reconstruct(stack, options);
}

SectionStack moved(SectionStack stack, const std::function<Point3(Point3)>& map) {
  for (Section& section : stack.sections) {
    const double z = section.z;
    section.z = map({0, 0, z}).z;
    for (Contour& contour : section.contours) {
      for (Point2& p : contour.vertices) {
        const Point3 q = map({p.x, p.y, z});
        p = {q.x, q.y};
      }
    }
  }
  return stack;
}

void for_each_stack(const std::function<void(StackKind, const GeneratedStack&)>& body) {
  for (const StackKind kind : all_kinds()) {
    for (std::uint64_t seed = kFirstSeed; seed < kFirstSeed + kSeeds; ++seed) {
      SCOPED_TRACE(std::string(name_of(kind)) + " seed " + std::to_string(seed));
      body(kind, generate(kind, seed));
    }
  }
}

// The classes as sets of contours, sections counted from the other end where `reversed`.
std::set<std::set<std::pair<std::size_t, std::size_t>>> classes_of(
    const ContourPartition& partition, bool reversed) {
  std::map<ComponentId, std::set<std::pair<std::size_t, std::size_t>>> classes;
  for (std::size_t s = 0; s < partition.size(); ++s) {
    const auto& contours = partition[SectionId(s)];
    for (std::size_t c = 0; c < contours.size(); ++c) {
      classes[contours[ContourId(c)]].insert({reversed ? partition.size() - 1 - s : s, c});
    }
  }
  std::set<std::set<std::pair<std::size_t, std::size_t>>> result;
  for (auto& [id, contours] : classes) result.insert(contours);
  return result;
}

struct Motion {
  const char* name;
  std::function<Point3(Point3)> map;
  bool reverses = false;
};

std::vector<Motion> motions() {
  return {{"mirror",
           [](Point3 p) {
             return Point3{-p.x, p.y, p.z};
           }},
          {"quarter turn",
           [](Point3 p) {
             return Point3{-p.y, p.x, p.z};
           }},
          {"swap",
           [](Point3 p) {
             return Point3{p.y, p.x, p.z};
           }},
          {"reversal",
           [](Point3 p) {
             return Point3{p.x, p.y, -p.z};
           },
           true},
          {"translation", [](Point3 p) {
             return Point3{p.x + 1024, p.y - 512, p.z + 64};
           }}};
}

SectionStack reversed(SectionStack stack) {
  std::reverse(stack.sections.begin(), stack.sections.end());
  return stack;
}

bool is_exact(const SectionStack& before, const SectionStack& after) {
  const SectionStack back = moved(after, [](Point3 p) {
    return Point3{p.x - 1024, p.y + 512, p.z - 64};
  });
  for (std::size_t s = 0; s < before.sections.size(); ++s) {
    const Section& a = before.sections[SectionId(s)];
    const Section& b = back.sections[SectionId(s)];
    if (a.z != b.z) return false;
    for (std::size_t c = 0; c < a.contours.size(); ++c) {
      if (a.contours[ContourId(c)].vertices != b.contours[ContourId(c)].vertices) return false;
    }
  }
  return true;
}

// Rules that look at no more than one slab, and at nothing that depends on where axes lie.
CorrespondenceOptions overlap_alone() {
  CorrespondenceOptions options;
  options.criterion = Criterion::overlap;
  options.chain = options.lone = false;
  return options;
}

TEST(Metamorphic, MotionsKeepGuaranteesAndPartition) {
  std::map<std::string, std::size_t> compared;
  for_each_stack([&](StackKind kind, const GeneratedStack& generated) {
    // Labels: of several paths of the same length the lowest is taken, which a motion changes.
    if (kind == StackKind::random_labels || is_near_coincident(kind)) return;
    const auto before = run(generated.stack, overlap_alone());
    ASSERT_TRUE(before.ok()) << to_string(before.error());
    for (const Motion& motion : motions()) {
      SCOPED_TRACE(motion.name);
      SectionStack stack = moved(generated.stack, motion.map);
      if (std::string(motion.name) == "translation" && !is_exact(generated.stack, stack)) continue;
      if (motion.reverses) stack = reversed(std::move(stack));
      const auto after = run(stack, overlap_alone());
      ASSERT_TRUE(after.ok()) << to_string(after.error());
      const auto report = check(after->model, stack, {.correspondence = overlap_alone()});
      ASSERT_TRUE(report.ok());
      EXPECT_TRUE(report->pass());
      EXPECT_EQ(classes_of(before->partition, false),
                classes_of(after->partition, motion.reverses));
      ++compared[motion.name];
    }
  });
  for (const Motion& motion : motions()) EXPECT_GT(compared[motion.name], 10U) << motion.name;
}

using Corners = std::array<std::tuple<double, double, double>, 4>;

std::multiset<Corners> tets_by_points(const Model& model) {
  std::multiset<Corners> tets;
  for (const TetVertices& t : model.tets) {
    Corners corners;
    for (std::size_t i = 0; i < 4; ++i) {
      const Point3& p = model.points[t[i]];
      corners[i] = {p.x, p.y, p.z};
    }
    std::sort(corners.begin(), corners.end());
    tets.insert(corners);
  }
  return tets;
}

// Which contours are divided, and what is put between, depends on the sections beyond: not here.
TEST(Metamorphic, AStackCutInTwoAndGluedGivesTheSameTets) {
  const auto run = [](const SectionStack& stack, const CorrespondenceOptions& correspondence) {
    return reconstruct(stack,
                       {.correspondence = correspondence, .between = 0, .divide_coarse = false});
  };
  std::size_t compared = 0;
  for_each_stack([&](StackKind, const GeneratedStack& generated) {
    const std::size_t n = generated.stack.sections.size();
    // Labels act over the whole stack; refused stacks have nothing to compare.
    if (n < 3 || !generated.correspondence.labels.empty()) return;
    const auto whole = run(generated.stack, overlap_alone());
    if (!whole.ok()) return;
    // Refinement of a section reaches both of its slabs.
    if (whole->report.rules[static_cast<std::size_t>(Rule::gabriel_refinement)] != 0) return;
    // Chains of holes look beyond their slab.
    const auto& of_voids = whole->model.void_links;
    if (std::any_of(of_voids.begin(), of_voids.end(),
                    [](const VoidLink& link) { return link.evidence == Evidence::chain; })) {
      return;
    }
    const std::size_t cut = n / 2;
    SectionStack lower;
    SectionStack upper;
    for (std::size_t s = 0; s < n; ++s) {
      const Section& section = generated.stack.sections[SectionId(s)];
      if (s <= cut) lower.sections.push_back(section);
      if (s >= cut) upper.sections.push_back(section);
    }
    const auto below = run(lower, overlap_alone());
    const auto above = run(upper, overlap_alone());
    ASSERT_TRUE(below.ok() && above.ok());
    std::multiset<Corners> glued = tets_by_points(below->model);
    glued.merge(tets_by_points(above->model));
    EXPECT_TRUE(glued == tets_by_points(whole->model));
    ++compared;
  });
  EXPECT_GT(compared, 20U);
}

std::set<std::set<std::size_t>> tets_by_index(const Delaunay3& d) {
  std::set<std::set<std::size_t>> tets;
  for (std::size_t t = 0; t < d.mesh.tet_slots(); ++t) {
    std::set<std::size_t> tet;
    for (const VertexId v : d.mesh.vertices(TetId(t))) tet.insert(v.index());
    tets.insert(tet);
  }
  return tets;
}

TEST(Metamorphic, MotionsKeepTheDelaunayTriangulationOfPointsWithoutTies) {
  Prng prng(5);
  for (int round = 0; round < 5; ++round) {
    // Of 30 bits, so that translation is exact; without five on a sphere but for a miracle.
    std::vector<Point3> points(150);
    const auto coordinate = [&] {
      return std::ldexp(static_cast<double>(prng.below(1U << 30)), -30);
    };
    for (Point3& p : points) p = {coordinate(), coordinate(), coordinate()};
    const auto before = delaunay3(points);
    ASSERT_TRUE(before.ok());
    for (const Motion& motion : motions()) {
      std::vector<Point3> there = points;
      for (Point3& p : there) p = motion.map(p);
      const auto after = delaunay3(there);
      ASSERT_TRUE(after.ok());
      EXPECT_EQ(tets_by_index(*before), tets_by_index(*after)) << motion.name;
    }
  }
}

}  // namespace
}  // namespace tetloft::testing

// Verdicts against brute force in rational arithmetic, on valid models and on models
// corrupted at random.
#include <tetloft/check.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <string>
#include <utility>

#include "support/guarantee_oracle.hpp"
#include "support/refine/refine_model.hpp"
#include "unit/check/columns.hpp"
#include "unit/check/verdict_text.hpp"

namespace tetloft {

using namespace internal;

namespace {

using testing::Case;

// A guarantee is compared where what it builds on holds: the proof that tets do not overlap
// (3) needs a manifold (1), and contours lie in components (4) only where they lie in the
// model (2). Whether all hold must agree always.
oracle::GuaranteeVerdicts compare(const Case& c, const CheckOptions& options,
                                  const std::string& what) {
  const auto report = check(c.model, c.stack, options);
  oracle::GuaranteeVerdicts truth = oracle::guarantees(c.model, c.stack, options);
  EXPECT_TRUE(report.ok()) << what;
  if (!report.ok()) return truth;
  const auto message = [&] {
    return what + "\ncheck:\n" + testing::text(*report) + "oracle:\n" + truth.reasons;
  };
  const auto pass = [&](std::size_t g) { return report->guarantees[g].pass; };
  const auto same = [&](std::size_t g) { return !truth.holds[g] || *truth.holds[g] == pass(g); };
  const bool manifold = truth.holds[0].value_or(false);
  const bool resampled = truth.holds[1].value_or(false);
  EXPECT_TRUE(same(0)) << message();
  EXPECT_TRUE(same(1)) << message();
  EXPECT_TRUE(!manifold || same(2)) << message();
  EXPECT_TRUE(!manifold || !resampled || same(3)) << message();
  const bool all = std::all_of(truth.holds.begin(), truth.holds.end(),
                               [](const auto& h) { return h.value_or(true); });
  EXPECT_EQ(report->pass(), all) << message();
  return truth;
}

TEST(CheckAgainstOracle, AgreesOnValidCases) {
  std::size_t i = 0;
  for (const Case& c : testing::all_cases()) compare(c, {}, "case " + std::to_string(i++));
}

Case random_case(Prng& prng) {
  std::vector<testing::Column> columns;
  for (int k = 0; k < 2; ++k) {
    const testing::Shape shape = testing::moved(testing::random_shape(prng, 6, 4), 5 * k, 0);
    switch (prng.below(4)) {
      case 0: columns.push_back({shape, {0, 1, 2}}); break;
      case 1: columns.push_back({shape, {0, 1, 1.25}}); break;
      case 2: columns.push_back({shape, {0.5, 1, 1.5}}); break;
      default: columns.push_back({shape, {0, 0.25}}); columns.push_back({shape, {0.75, 1, 2}});
    }
  }
  return testing::extrude(columns, {0, 1, 2});
}

VertexId random_vertex(Prng& prng, const Case& c) {
  return VertexId(prng.below(c.model.points.size()));
}

// One small change of any kind; many leave the model valid.
std::string corrupt(Prng& prng, Case& c, CheckOptions& options) {
  auto& tets = c.model.tets.raw();
  auto& points = c.model.points.raw();
  const std::size_t t = prng.below(tets.size());
  const VertexId v = random_vertex(prng, c);
  Point3& p = points[v.index()];
  switch (prng.below(16)) {
    case 0: tets.erase(tets.begin() + static_cast<std::ptrdiff_t>(t)); return "tet removed";
    case 1: tets.push_back(tets[t]); return "tet doubled";
    case 2: std::swap(tets[t][0], tets[t][1]); return "tet inverted";
    case 3: tets[t][prng.below(4)] = v; return "vertex replaced";
    case 4: p.x = std::nextafter(p.x, 100.0); return "moved by an ulp";
    case 5: p.x += 1; return "moved by one in x";
    case 6: p.z += 0.25; return "moved up";
    case 7: p = points[random_vertex(prng, c).index()]; return "vertex onto another";
    case 8: {
      const VertexId w = random_vertex(prng, c);
      for (TetVertices& tet : tets) std::replace(tet.begin(), tet.end(), v, w);
      return "vertex identified with another";
    }
    case 9: {
      const double dx = static_cast<double>(prng.below(6));
      for (Point3& q : points) q.x -= q.x >= 5 ? dx : 0;
      return "halves moved together";
    }
    case 10: {
      tets.push_back({random_vertex(prng, c), random_vertex(prng, c), random_vertex(prng, c), v});
      return "tet added";
    }
    case 11: {
      const TetVertices tet = tets[t];
      points.push_back({(points[tet[0].index()].x + points[tet[1].index()].x) / 2,
                        (points[tet[0].index()].y + points[tet[1].index()].y) / 2,
                        (points[tet[0].index()].z + points[tet[1].index()].z) / 2});
      std::vector<TetVertices> split;
      for (const TetVertices& old : tets) {
        if (std::count(old.begin(), old.end(), tet[0]) +
                std::count(old.begin(), old.end(), tet[1]) !=
            2) {
          split.push_back(old);
          continue;
        }
        for (const VertexId end : {tet[0], tet[1]}) {
          TetVertices half = old;
          std::replace(half.begin(), half.end(), end, VertexId(points.size() - 1));
          split.push_back(half);
        }
      }
      tets = split;
      return "edge split";
    }
    case 12: {
      auto& contours = c.stack.sections[SectionId(prng.below(3))].contours.raw();
      if (!contours.empty()) contours.pop_back();
      return "contour removed";
    }
    case 13: options.correspondence.tau = 0x1.fffffffffffffp-1; return "tau below 1";
    case 14: {
      for (Point3& q : points) q.x += q.z > 1 ? 1 : 0;
      return "top sheared";
    }
    default: {
      for (TetVertices& tet : tets) {
        const bool high = std::any_of(tet.begin(), tet.end(),
                                      [&](VertexId w) { return points[w.index()].z > 1; });
        if (high && std::count(tet.begin(), tet.end(), v) != 0) {
          std::replace(tet.begin(), tet.end(), v, VertexId(points.size()));
        }
      }
      points.push_back(Point3(points[v.index()]));
      return "vertex doubled";
    }
  }
}

// Inserts vertices into edges, faces and tets: those of one height at that height.
void refine(Prng& prng, Case& c, int times) {
  for (int k = 0; k < times; ++k) {
    TetVertices tet = c.model.tets[TetId(prng.below(c.model.tets.size()))];
    for (std::size_t i = 3; i > 0; --i) std::swap(tet[i], tet[prng.below(i + 1)]);
    if (prng.below(3) != 0) {  // what lies in a plane first
      std::stable_sort(tet.begin(), tet.end(), [&](VertexId a, VertexId b) {
        const auto alike = [&](VertexId v) {
          return std::count_if(tet.begin(), tet.end(), [&](VertexId w) {
            return c.model.points[v].z == c.model.points[w].z;
          });
        };
        return alike(a) > alike(b);
      });
    }
    const std::span<const VertexId> simplex(tet.data(), 2 + prng.below(3));
    Point3 sum{0, 0, 0};
    for (const VertexId v : simplex) {
      const Point3& p = c.model.points[v];
      sum = {sum.x + p.x, sum.y + p.y, sum.z + p.z};
    }
    const auto n = static_cast<double>(simplex.size());
    testing::insert_vertex(c.model, simplex, {sum.x / n, sum.y / n, sum.z / n});
  }
}

// Sanitizers slow rational arithmetic down tenfold, and it is not what they look for.
#if defined(__SANITIZE_ADDRESS__)
constexpr int kTrials = 150;
#elif defined(__has_feature)
#if __has_feature(address_sanitizer)
constexpr int kTrials = 150;
#else
constexpr int kTrials = 1000;
#endif
#else
constexpr int kTrials = 1000;
#endif

TEST(CheckAgainstOracle, AgreesOnRandomCorruptions) {
  constexpr std::uint64_t kSeed = 20240607;
  Prng prng(kSeed);
  std::array<int, 4> held{};
  std::array<int, 4> failed{};
  for (int trial = 0; trial < kTrials; ++trial) {
    Case c = random_case(prng);
    CheckOptions options;
    std::string what = "seed " + std::to_string(kSeed) + ", trial " + std::to_string(trial);
    const std::size_t changes = prng.below(3);
    for (std::size_t k = 0; k < changes; ++k) what += ", " + corrupt(prng, c, options);
    const oracle::GuaranteeVerdicts truth = compare(c, options, what);
    for (std::size_t g = 0; g < 4; ++g) {
      if (truth.holds[g].has_value()) ++(*truth.holds[g] ? held : failed)[g];
    }
  }
  // The comparison means something only where both answers occur.
  for (std::size_t g = 0; g < 4; ++g) {
    EXPECT_GT(held[g], kTrials / 10) << "guarantee " << g + 1;
    EXPECT_GT(failed[g], kTrials / 20) << "guarantee " << g + 1;
  }
}

TEST(CheckAgainstOracle, AgreesOnRefinedModels) {
  constexpr std::uint64_t kSeed = 20261128;
  Prng prng(kSeed);
  int held = 0;
  int failed = 0;
  std::size_t inner = 0;
  for (int trial = 0; trial < kTrials / 10; ++trial) {
    Case c = random_case(prng);
    CheckOptions options;
    refine(prng, c, 4);
    std::string what = "seed " + std::to_string(kSeed) + ", trial " + std::to_string(trial);
    if (trial % 2 == 1) what += ", " + corrupt(prng, c, options);
    const oracle::GuaranteeVerdicts truth = compare(c, options, what);
    if (truth.holds[1].has_value()) ++(*truth.holds[1] ? held : failed);
    const auto report = check(c.model, c.stack, options);
    if (report.ok() && report->pass()) inner += report->inner_vertices;
  }
  EXPECT_GT(held, kTrials / 20);
  EXPECT_GT(failed, kTrials / 100);
  EXPECT_GT(inner, static_cast<std::size_t>(kTrials / 100));
}

}  // namespace
}  // namespace tetloft

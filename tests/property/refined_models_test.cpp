// Right models stay right when they are refined, and refined ones are told from broken ones.
// (Against the oracle: tests/unit/check/oracle_test.cpp.)
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include <tetloft/check.hpp>
#include <tetloft/reconstruct.hpp>

#include "core/prng.hpp"
#include "support/refine/refine_model.hpp"
#include "support/stacks/generate.hpp"

namespace tetloft::testing {

using namespace internal;
namespace {

constexpr std::uint64_t kSeed = 20261128;
constexpr std::size_t kMostTets = 1500;

struct RefinedModel {
  Model model;
  std::vector<VertexId> inside;      // inserted into sections
  std::vector<VertexId> on_contour;  // inserted into contour edges
  std::vector<VertexId> elsewhere;   // inserted into tets
};

std::string text(const CheckReport& report) {
  std::string result;
  for (const GuaranteeVerdict& g : report.guarantees) {
    for (const CheckFailure& f : g.failures) {
      result += f.what + ": " + (f.places.empty() ? "" : f.places.front()) + "\n";
    }
  }
  return result;
}

// A section's z, or nothing, of vertices that lie in one section plane together.
bool in_one_plane(const Model& model, const SectionStack& stack,
                  const std::vector<VertexId>& vertices) {
  const double z = model.points[vertices[0]].z;
  return std::all_of(vertices.begin(), vertices.end(),
                     [&](VertexId v) { return model.points[v].z == z; }) &&
         std::any_of(stack.sections.begin(), stack.sections.end(),
                     [&](const Section& s) { return s.z == z; });
}

// Neighbours along a contour: how many in-plane faces have the edge decides what it is.
std::size_t faces_at(const Model& model, const std::vector<VertexId>& edge) {
  std::vector<VertexId> thirds;
  const double z = model.points[edge[0]].z;
  for (const TetVertices& tet : model.tets) {
    if (std::count(tet.begin(), tet.end(), edge[0]) + std::count(tet.begin(), tet.end(), edge[1]) !=
        2) {
      continue;
    }
    for (const VertexId v : tet) {
      if (v != edge[0] && v != edge[1] && model.points[v].z == z) thirds.push_back(v);
    }
  }
  std::sort(thirds.begin(), thirds.end());
  return static_cast<std::size_t>(std::unique(thirds.begin(), thirds.end()) - thirds.begin());
}

Point3 random_mean(Prng& prng, const Model& model, const std::vector<VertexId>& vertices) {
  double sum = 0;
  Point3 p{0, 0, 0};
  for (const VertexId v : vertices) {
    const double weight = 1 + static_cast<double>(prng.below(4));
    const Point3& q = model.points[v];
    p = {p.x + weight * q.x, p.y + weight * q.y, p.z + weight * q.z};
    sum += weight;
  }
  return {p.x / sum, p.y / sum, p.z / sum};
}

void refine_once(Prng& prng, const SectionStack& stack, RefinedModel& refined) {
  Model& model = refined.model;
  TetVertices tet = model.tets[TetId(prng.below(model.tets.size()))];
  for (std::size_t i = 3; i > 0; --i) std::swap(tet[i], tet[prng.below(i + 1)]);
  for (const std::size_t corners : {2U, 3U, 4U}) {
    const std::vector<VertexId> simplex(tet.begin(), tet.begin() + static_cast<int>(corners));
    Point3 p = random_mean(prng, model, simplex);
    if (corners == 4) {
      if (const auto v = insert_vertex(model, simplex, p)) refined.elsewhere.push_back(*v);
      return;
    }
    if (!in_one_plane(model, stack, simplex)) continue;
    p.z = model.points[simplex[0]].z;
    const bool contour = corners == 2 && faces_at(model, simplex) == 1;
    const auto v = insert_vertex(model, simplex, p);
    if (v) (contour ? refined.on_contour : refined.inside).push_back(*v);
    return;
  }
}

// Kinds of small models whose vertices have room around them.
bool is_suitable(StackKind kind) {
  return !is_near_coincident(kind) && kind != StackKind::large_contours &&
         kind != StackKind::extreme_gaps && kind != StackKind::far_apart &&
         kind != StackKind::scale_offset && kind != StackKind::near_touching;
}

template <class Body>
void for_each_refined_model(const Body& body) {
  Prng prng(kSeed);
  for (const StackKind kind : all_kinds()) {
    if (!is_suitable(kind)) continue;
    for (std::uint64_t seed = 1; seed <= 3; ++seed) {
      SCOPED_TRACE(std::string(name_of(kind)) + " seed " + std::to_string(seed));
      const GeneratedStack generated = generate(kind, seed);
      ReconstructOptions options;
      options.execution.threads = 1;
      options.correspondence = generated.correspondence;
      auto made = reconstruct(generated.stack, options);
      if (!made.ok() || made->model.tets.empty() || made->model.tets.size() > kMostTets) continue;
      RefinedModel refined;
      refined.model.points = made->model.points;
      refined.model.tets = made->model.tets;
      // What guarantee 5 has to know of: a mesher keeps it.
      refined.model.void_links = made->model.void_links;
      refined.model.deviations = made->model.deviations;
      for (int k = 0; k < 60; ++k) refine_once(prng, generated.stack, refined);
      CheckOptions check_options;
      check_options.correspondence = generated.correspondence;
      body(prng, generated.stack, refined, check_options);
    }
  }
}

TEST(RefinedModels, PassAndTellOfVerticesInsideSections) {
  std::size_t inside = 0;
  std::size_t on_contour = 0;
  for_each_refined_model([&](Prng&, const SectionStack& stack, const RefinedModel& refined,
                             const CheckOptions& options) {
    const auto report = check(refined.model, stack, options);
    ASSERT_TRUE(report.ok());
    EXPECT_TRUE(report->pass()) << text(*report);
    EXPECT_EQ(report->inner_vertices, refined.inside.size());
    inside += refined.inside.size();
    on_contour += refined.on_contour.size();
  });
  EXPECT_GT(inside, 300U);
  EXPECT_GT(on_contour, 100U);
}

// Every edge in two, contour edges too.
TEST(RefinedModels, PassWithAllEdgesHalved) {
  std::size_t halved = 0;
  std::size_t inner = 0;  // none where regions are triangles
  for (const StackKind kind : all_kinds()) {
    if (!is_suitable(kind)) continue;
    const GeneratedStack generated = generate(kind, 1);
    SCOPED_TRACE(name_of(kind));
    CheckOptions options;
    options.correspondence = generated.correspondence;
    ReconstructOptions made_by;
    made_by.execution.threads = 1;
    made_by.correspondence = generated.correspondence;
    const auto made = reconstruct(generated.stack, made_by);
    if (!made.ok() || made->model.tets.empty() || made->model.tets.size() > kMostTets / 2) continue;
    std::set<std::pair<VertexId, VertexId>> edges;
    for (const TetVertices& tet : made->model.tets) {
      for (const VertexId a : tet) {
        for (const VertexId b : tet) {
          if (a < b) edges.emplace(a, b);
        }
      }
    }
    Model model;
    model.points = made->model.points;
    model.tets = made->model.tets;
    model.void_links = made->model.void_links;
    model.deviations = made->model.deviations;
    for (const auto& [a, b] : edges) {
      const Point3& p = model.points[a];
      const Point3& q = model.points[b];
      const Point3 middle{p.x + (q.x - p.x) / 2, p.y + (q.y - p.y) / 2, p.z + (q.z - p.z) / 2};
      if (insert_vertex(model, std::array{a, b}, middle)) ++halved;
    }
    const auto report = check(model, generated.stack, options);
    ASSERT_TRUE(report.ok());
    EXPECT_TRUE(report->pass()) << text(*report);
    inner += report->inner_vertices;
  }
  EXPECT_GT(inner, 200U);
  EXPECT_GT(halved, 2000U);
}

// What breaks a refined model, by the vertices it had inserted. False: nothing to break.
struct Breach {
  const char* name;
  bool (*apply)(Prng&, RefinedModel&);
};

VertexId any(Prng& prng, const std::vector<VertexId>& of) { return of[prng.below(of.size())]; }

bool has(const TetVertices& tet, VertexId v) {
  return std::find(tet.begin(), tet.end(), v) != tet.end();
}

// Has the tet v and a face in its plane?
bool lies_on_plane_at(const Model& model, const TetVertices& tet, VertexId v) {
  return has(tet, v) && std::count_if(tet.begin(), tet.end(), [&](VertexId w) {
                          return model.points[w].z == model.points[v].z;
                        }) == 3;
}

constexpr std::array kBreaches{
    Breach{"an inner vertex a little above its plane",
           [](Prng& prng, RefinedModel& r) {
             if (r.inside.empty()) return false;
             double& z = r.model.points[any(prng, r.inside)].z;
             z = std::nextafter(z, std::numeric_limits<double>::infinity());
             return true;
           }},
    Breach{"an inner vertex across the plane",
           [](Prng& prng, RefinedModel& r) {
             if (r.inside.empty()) return false;
             Point3& p = r.model.points[any(prng, r.inside)];
             p.x += 1000;
             return true;
           }},
    Breach{"an inner vertex onto an input vertex",
           [](Prng& prng, RefinedModel& r) {
             if (r.inside.empty()) return false;
             Point3& p = r.model.points[any(prng, r.inside)];
             const auto same = [&](const Point3& q) { return q.z == p.z; };
             p = *std::find_if(r.model.points.begin(), r.model.points.end(), same);
             return true;
           }},
    Breach{"a tet at an inner vertex missing",
           [](Prng& prng, RefinedModel& r) {
             if (r.inside.empty()) return false;
             const VertexId v = any(prng, r.inside);
             auto& tets = r.model.tets.raw();
             tets.erase(std::find_if(tets.begin(), tets.end(), [&](const TetVertices& tet) {
               return lies_on_plane_at(r.model, tet, v);
             }));
             return true;
           }},
    Breach{"all tets at an inner vertex missing",
           [](Prng& prng, RefinedModel& r) {
             if (r.inside.empty()) return false;
             const VertexId v = any(prng, r.inside);
             std::erase_if(r.model.tets.raw(), [&](const TetVertices& t) { return has(t, v); });
             return true;
           }},
    Breach{"all tets at a contour vertex missing",
           [](Prng& prng, RefinedModel& r) {
             if (r.on_contour.empty()) return false;
             const VertexId v = any(prng, r.on_contour);
             std::erase_if(r.model.tets.raw(), [&](const TetVertices& t) { return has(t, v); });
             return true;
           }},
    Breach{"a contour vertex off its edge",
           [](Prng& prng, RefinedModel& r) {
             if (r.on_contour.empty()) return false;
             Point3& p = r.model.points[any(prng, r.on_contour)];
             const double ulps = 1e6 * std::ldexp(std::max(std::abs(p.x), std::abs(p.y)), -52);
             // A direction that no edge of a generated stack has.
             p.x += ulps;
             p.y += 2.718281828 * ulps;
             return true;
           }},
    Breach{"a spare vertex in a section",
           [](Prng& prng, RefinedModel& r) {
             if (r.inside.empty()) return false;
             Point3 p = r.model.points[any(prng, r.inside)];
             p.x = std::nextafter(p.x, std::numeric_limits<double>::infinity());
             r.model.points.push_back(p);
             return true;
           }},
    Breach{"a face of inner vertices covered twice",
           [](Prng& prng, RefinedModel& r) {
             if (r.inside.empty()) return false;
             const VertexId v = any(prng, r.inside);
             const auto& tets = r.model.tets;
             TetVertices tet = *std::find_if(tets.begin(), tets.end(), [&](const TetVertices& t) {
               return lies_on_plane_at(r.model, t, v);
             });
             std::replace(tet.begin(), tet.end(), v, r.model.points.push_back(r.model.points[v]));
             r.model.tets.push_back(tet);
             return true;
           }},
};

TEST(RefinedModels, BrokenFail) {
  std::map<std::string, std::size_t> broken;
  for_each_refined_model([&](Prng& prng, const SectionStack& stack, const RefinedModel& refined,
                             const CheckOptions& options) {
    for (const Breach& breach : kBreaches) {
      SCOPED_TRACE(breach.name);
      RefinedModel copy = refined;
      if (!breach.apply(prng, copy)) continue;
      const auto report = check(copy.model, stack, options);
      ASSERT_TRUE(report.ok());
      EXPECT_FALSE(report->pass());
      EXPECT_FALSE(report->guarantees[1].pass) << text(*report);
      ++broken[breach.name];
    }
  });
  for (const Breach& breach : kBreaches) EXPECT_GT(broken[breach.name], 15U) << breach.name;
}

}  // namespace
}  // namespace tetloft::testing

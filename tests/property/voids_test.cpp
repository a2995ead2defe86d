// What is promised of voids, on every kind of stack about them: topology does not change when
// contours are refined, but where that is told; models depend on no order and no threads.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <numeric>
#include <optional>
#include <string>
#include <vector>

#include <tetloft/check.hpp>
#include <tetloft/reconstruct.hpp>

#include "core/prng.hpp"
#include "property/same_model.hpp"
#include "support/stacks/generate.hpp"

namespace tetloft::testing {

using namespace internal;
namespace {

constexpr std::uint64_t kSeeds = 8;

// Each edge in four. Quarters of small coordinates; what is rounded stays valid or is left out.
std::optional<SectionStack> in_four(const SectionStack& stack) {
  SectionStack fine = stack;
  for (Section& section : fine.sections) {
    for (Contour& contour : section.contours) {
      const std::vector<Point2> coarse = std::move(contour.vertices);
      contour.vertices.clear();
      for (std::size_t i = 0; i < coarse.size(); ++i) {
        const Point2& p = coarse[i];
        const Point2& q = coarse[(i + 1) % coarse.size()];
        for (const double t : {0.0, 0.25, 0.5, 0.75}) {
          contour.vertices.push_back({p.x + t * (q.x - p.x), p.y + t * (q.y - p.y)});
        }
      }
    }
  }
  if (!validate(fine)) return std::nullopt;
  return fine;
}

struct Topology {
  std::size_t components = 0, cavities = 0;
  long genus = 0;
  std::size_t told = 0;   // deviations, forced and unrealisable links
  bool of_range = false;  // regions touch
  friend bool operator==(const Topology& a, const Topology& b) {
    return a.components == b.components && a.cavities == b.cavities && a.genus == b.genus;
  }
};

std::optional<Topology> topology_of(const SectionStack& stack) {
  ReconstructOptions options;
  options.execution.threads = 1;
  const auto made = reconstruct(stack, options);
  if (!made.ok()) {
    ADD_FAILURE() << to_string(made.error());
    return std::nullopt;
  }
  const auto report = check(made->model, stack);
  EXPECT_TRUE(report.ok() && report->pass());
  if (!report.ok()) return std::nullopt;
  Topology result;
  result.components = report->components;
  result.cavities = report->cavities.value_or(0);
  result.genus = std::accumulate(report->genus.begin(), report->genus.end(), 0L);
  result.told = report->deviations + report->forced_voids + report->unrealisable_voids;
  result.of_range = report->least_genus != report->most_genus;
  return result;
}

template <class Body>
void for_each_stack(std::uint64_t seeds, const Body& body) {
  for (const StackKind kind : kinds_with_voids()) {
    for (std::uint64_t seed = 1; seed <= seeds; ++seed) {
      SCOPED_TRACE(std::string(name_of(kind)) + " seed " + std::to_string(seed));
      body(generate(kind, seed));
    }
  }
}

TEST(Voids, RefiningContoursChangesNoTopology) {
  std::size_t compared = 0, cavities = 0, handles = 0, touching = 0, told = 0;
  for_each_stack(kSeeds, [&](const GeneratedStack& generated) {
    const std::optional<SectionStack> finer = in_four(generated.stack);
    if (!finer) return;
    const auto coarse = topology_of(generated.stack);
    const auto fine = topology_of(*finer);
    ASSERT_TRUE(coarse && fine);
    ++compared;
    cavities += coarse->cavities;
    handles += static_cast<std::size_t>(coarse->genus);
    if (*coarse == *fine) return;
    // Of touches either is right; what is told of is no secret.
    if (coarse->told + fine->told > 0) {
      ++told;
    } else if (coarse->of_range || fine->of_range) {
      ++touching;
    } else {
      ADD_FAILURE() << coarse->components << ", " << coarse->cavities << ", " << coarse->genus
                    << " became " << fine->components << ", " << fine->cavities << ", "
                    << fine->genus;
    }
  });
  std::printf(
      "voids: %zu stacks with %zu cavities and %zu handles; changed %zu that touch, %zu told\n",
      compared, cavities, handles, touching, told);
  EXPECT_GT(compared, 60U);
  EXPECT_GT(cavities, 20U);
  EXPECT_GT(handles, 40U);
  EXPECT_LE(touching, 4U);
  EXPECT_LE(told, 3U);
}

// Contours in another order, each from another vertex and the other way round or not.
SectionStack listed_otherwise(Prng& prng, const SectionStack& stack) {
  SectionStack result = stack;
  for (Section& section : result.sections) {
    for (Contour& contour : section.contours) {
      auto& v = contour.vertices;
      std::rotate(v.begin(), v.begin() + static_cast<std::ptrdiff_t>(prng.below(v.size())),
                  v.end());
      if (prng.chance(0.5)) std::reverse(v.begin(), v.end());
    }
    prng.shuffle(section.contours.raw());
  }
  return result;
}

// Points, tets and what depends on no contour's number.
Model unnumbered(const Model& model) {
  Model result;
  result.points = model.points;
  result.tets = model.tets;
  result.kind = model.kind;
  result.origin = model.origin;
  return result;
}

TEST(Voids, ModelsDependOnNoOrderOfContoursAndNoThreads) {
  Prng prng(6300);
  std::size_t walls = 0, filled = 0, opened = 0;
  for_each_stack(kSeeds, [&](const GeneratedStack& generated) {
    const auto run = [](const SectionStack& stack, unsigned threads) {
      ReconstructOptions options;
      options.execution.threads = threads;
      return reconstruct(stack, options);
    };
    const auto one = run(generated.stack, 1);
    const auto four = run(generated.stack, 4);
    const auto other = run(listed_otherwise(prng, generated.stack), 4);
    ASSERT_TRUE(one.ok() && four.ok() && other.ok());
    EXPECT_TRUE(same_bits(one->model, four->model));
    EXPECT_EQ(one->model.tets, other->model.tets);
    EXPECT_EQ(one->model.kind, other->model.kind);
    EXPECT_EQ(one->model.origin, other->model.origin);
    EXPECT_TRUE(same_bits(unnumbered(one->model), unnumbered(other->model)));
    EXPECT_EQ(one->report.rules, four->report.rules);
    EXPECT_EQ(one->report.rules, other->report.rules);
    EXPECT_EQ(one->model.deviations.size(), other->model.deviations.size());
    EXPECT_EQ(one->model.void_links.size(), other->model.void_links.size());
    const auto fired = [&](Rule rule) { return one->report.rules[static_cast<std::size_t>(rule)]; };
    walls += fired(Rule::closed_passage);
    filled += fired(Rule::filled_handle) + fired(Rule::bridged_face);
    opened += fired(Rule::opened_face);
  });
  std::printf("voids: %zu passages closed, %zu handles and faces filled, %zu opened\n", walls,
              filled, opened);
  EXPECT_GT(walls, 20U);
  EXPECT_GT(filled, 0U);
}

}  // namespace
}  // namespace tetloft::testing

// Euler characteristics of what is attached, by sets of simplices, and of whole solids.
#include "completion/attached_chi.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <set>
#include <string>
#include <vector>

#include "unit/completion/void_slab.hpp"

namespace tetloft::testing {
namespace {

using Simplex = std::vector<SlabVertexId>;

// By definition: each set of corners that is attached in one tet, to one class.
IdVector<ClassId, std::int32_t> chi_by_sets(const VoidSlab& s) {
  std::vector<std::set<Simplex>> closed(s.classes().class_count());
  for (const TetId t : s.slab().tets()) {
    for (unsigned corners = 1; corners < 16; ++corners) {
      Simplex simplex;
      std::set<ClassId> classes;
      bool attached = true;
      for (int i = 0; i < 4; ++i) {
        if ((corners >> i & 1U) == 0) continue;
        simplex.push_back(s.slab().vertex(t, i));
        classes.insert(s.classes().of(simplex.back()));
        attached = attached && s.completion.complex().is_attached(t, i);
      }
      if (!attached || classes.size() != 1) continue;
      std::sort(simplex.begin(), simplex.end());
      closed[classes.begin()->index()].insert(simplex);
    }
  }
  IdVector<ClassId, std::int32_t> chi(closed.size(), 0);
  for (const ClassId c : chi.ids()) {
    for (const Simplex& simplex : closed[c.index()]) chi[c] += simplex.size() % 2 == 1 ? 1 : -1;
  }
  return chi;
}

TEST(AttachedChi, IsThatOfTheSimplicesAttached) {
  std::set<std::int32_t> met;
  for (const bool linked : {false, true}) {
    for_each_void_slab(6, linked, [&](const VoidSlab& s) {
      const auto chi = attached_chi(s.slab(), s.classes(), s.active, s.completion.complex());
      EXPECT_EQ(chi, chi_by_sets(s));
      for (const std::int32_t of_class : chi) met.insert(of_class);
    });
  }
  for (std::int32_t chi = -2; chi <= 1; ++chi) EXPECT_TRUE(met.contains(chi)) << chi;
}

// Of tets and all their faces.
std::int32_t chi_of(const Model& model) {
  std::set<std::vector<VertexId>> simplices;
  for (const TetVertices& tet : model.tets) {
    for (unsigned corners = 1; corners < 16; ++corners) {
      std::vector<VertexId> simplex;
      for (unsigned i = 0; i < 4; ++i) {
        if ((corners >> i & 1U) != 0) simplex.push_back(tet[i]);
      }
      std::sort(simplex.begin(), simplex.end());
      simplices.insert(simplex);
    }
  }
  std::int32_t chi = 0;
  for (const auto& simplex : simplices) chi += simplex.size() % 2 == 1 ? 1 : -1;
  return chi;
}

std::int32_t region_chi(const ConformingSection& section, RegionId r) {
  const auto& of_contour = section.nesting.region;
  return 2 - static_cast<std::int32_t>(std::count(of_contour.begin(), of_contour.end(), r));
}

TEST(AttachedChi, IsThatOfTheSolid) {
  std::size_t compared = 0;
  std::size_t holed = 0;
  for (const StackKind kind : all_kinds()) {
    if (is_near_coincident(kind) || kind == StackKind::large_contours) continue;
    for (std::uint64_t seed = 1; seed <= 4; ++seed) {
      SCOPED_TRACE(std::string(name_of(kind)) + " seed " + std::to_string(seed));
      SectionStack stack = generate(kind, seed).stack;
      stack.sections.raw().resize(2);
      const auto s = void_slab(stack, false);
      if (!s || !s->apart.empty()) continue;
      ReconstructOptions options;
      options.correspondence.criterion = Criterion::overlap;
      options.correspondence.chain = options.correspondence.lone = false;
      options.correspondence.voids.rule = VoidRule::free;
      options.divide_coarse = false;
      const auto made = reconstruct(stack, options);
      if (!made.ok() ||
          fired(*made, Rule::opened_pit) + fired(*made, Rule::gabriel_refinement) > 0) {
        continue;
      }
      const auto chi = attached_chi(s->slab(), s->classes(), s->active, s->completion.complex());
      std::int32_t sum = 0;
      for (const ClassId c : chi.ids()) {
        if (s->active[c] != 0) {
          sum += chi[c];
          continue;
        }
        EXPECT_EQ(chi[c], 0);
        for (const SlabRegionId r : s->classes().regions(c)) {
          const SlabRegions& regions = s->classes().regions();
          sum += region_chi(s->slab().section(regions.is_upper(r)), regions.in_section(r));
        }
      }
      EXPECT_EQ(sum, chi_of(made->model));
      ++compared;
      holed += sum <= 0 ? 1U : 0U;
    }
  }
  EXPECT_GT(compared, 70U);
  EXPECT_GT(holed, 10U);
}

}  // namespace
}  // namespace tetloft::testing

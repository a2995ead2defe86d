// Conforming sections as bytes.
#include "sections/section_record.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "core/prng.hpp"
#include "support/signed_record.hpp"
#include "support/stacks/generate.hpp"

namespace tetloft::testing {

using namespace internal;
namespace {

bool same_edges(const ConformingSection& a, const ConformingSection& b) {
  return std::equal(a.edges.begin(), a.edges.end(), b.edges.begin(), b.edges.end(),
                    [](const auto& e, const auto& f) {
                      return e.a == f.a && e.b == f.b && e.kind == f.kind && e.left == f.left &&
                             e.right == f.right;
                    });
}

bool same_nesting(const Nesting& a, const Nesting& b) {
  return a.parent == b.parent && a.depth == b.depth && a.region == b.region && a.outer == b.outer;
}

// Calls visit(conforming section) for sections of all kinds, some of their contours Gabriel.
template <class Visit>
void for_each_section(std::uint64_t seed, const Visit& visit) {
  for (const StackKind kind : all_kinds()) {
    SCOPED_TRACE(name_of(kind));
    const SectionStack stack = generate(kind, seed).stack;
    for (const SectionId s : stack.sections.ids()) {
      IdVector<ContourId, bool> gabriel;
      if (s.value() % 2 == 1) gabriel.assign(stack.sections[s].contours.size(), true);
      const Result<ConformingSection> section = conform(stack.sections[s], s, {.gabriel = gabriel});
      if (section && section->vertex_count() < 3000) visit(*section);
    }
  }
}

TEST(SectionRecord, ReadsBackEverySection) {
  for_each_section(900, [](const ConformingSection& section) {
    const std::string bytes = sections::to_record(section);
    const Result<ConformingSection> read = sections::section_from_record(bytes, "name");
    ASSERT_TRUE(read) << to_string(read.error());
    EXPECT_EQ(read->z, section.z);
    EXPECT_EQ(read->triangulation.points, section.triangulation.points);
    EXPECT_EQ(read->triangulation.triangles, section.triangulation.triangles);
    EXPECT_EQ(read->triangulation.neighbours, section.triangulation.neighbours);
    EXPECT_EQ(read->internal, section.internal);
    EXPECT_TRUE(same_edges(*read, section));
    EXPECT_EQ(read->first_edge, section.first_edge);
    EXPECT_EQ(read->contour, section.contour);
    EXPECT_EQ(read->region, section.region);
    EXPECT_EQ(read->next, section.next);
    EXPECT_EQ(read->previous, section.previous);
    EXPECT_EQ(read->input_vertex, section.input_vertex);
    EXPECT_EQ(read->edge_of, section.edge_of);
    EXPECT_EQ(read->gabriel, section.gabriel);
    EXPECT_TRUE(same_nesting(read->nesting, section.nesting));
    EXPECT_EQ(sections::to_record(*read), bytes);
  });
}

TEST(SectionRecord, WhatIsSignedButWrongIsRefusedOrReadAsASectionOfItsOwn) {
  Prng prng(901);
  std::size_t refused = 0;
  std::size_t read = 0;
  for_each_section(902, [&](const ConformingSection& section) {
    if (section.vertex_count() > 200) return;
    const std::string bytes = sections::to_record(section);
    for (int trial = 0; trial < 100; ++trial) {
      std::string damaged = bytes;
      const std::size_t at = 24 + static_cast<std::size_t>(prng.below(bytes.size() - 32));
      damaged[at] = static_cast<char>(damaged[at] ^ (1 << prng.below(8)));
      damaged = signed_again(std::move(damaged));
      const Result<ConformingSection> result = sections::section_from_record(damaged, "name");
      if (result) {
        EXPECT_EQ(sections::to_record(*result).size(), bytes.size());
        ++read;
      } else {
        EXPECT_EQ(result.error().code, ErrorCode::invalid_input) << to_string(result.error());
        ++refused;
      }
    }
  });
  EXPECT_GT(refused, 1000U);
  EXPECT_GT(read, 100U);
}

}  // namespace
}  // namespace tetloft::testing

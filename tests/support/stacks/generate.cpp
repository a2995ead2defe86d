#include "support/stacks/generate.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include "core/guard.hpp"
#include "support/stacks/kinds.hpp"
#include "support/stacks/shapes.hpp"

namespace tetloft::testing {

using namespace internal;
namespace {

SectionStack draft_for_labels(Prng& prng) {
  switch (number(prng, 0, 4)) {
    case 0: return draft_branching_one_to_many(prng);
    case 1: return draft_crossing_bars(prng);
    case 2: return draft_isolated_contours(prng);
    case 3: return draft_checkerboard(prng);
    default: return draft_branching_many_to_many(prng);
  }
}

struct Kind {
  StackKind kind;
  const char* name;
  SectionStack (*draft)(Prng&);
  bool near_coincident = false;
};

// In the order of the enumeration.
constexpr std::array kKinds{
    Kind{StackKind::lattice_marching_squares, "lattice_marching_squares",
         draft_lattice_marching_squares},
    Kind{StackKind::lattice_staircase, "lattice_staircase", draft_lattice_staircase},
    Kind{StackKind::small_grid, "small_grid", draft_small_grid},
    Kind{StackKind::checkerboard, "checkerboard", draft_checkerboard},
    Kind{StackKind::identical_sections, "identical_sections", draft_identical_sections},
    Kind{StackKind::nesting, "nesting", draft_nesting},
    Kind{StackKind::branching_one_to_many, "branching_one_to_many", draft_branching_one_to_many},
    Kind{StackKind::branching_many_to_many, "branching_many_to_many", draft_branching_many_to_many},
    Kind{StackKind::holes, "holes", draft_holes},
    Kind{StackKind::triangular_holes, "triangular_holes", draft_triangular_holes},
    Kind{StackKind::isolated_contours, "isolated_contours", draft_isolated_contours},
    Kind{StackKind::empty_sections, "empty_sections", draft_empty_sections},
    Kind{StackKind::far_apart, "far_apart", draft_far_apart},
    Kind{StackKind::extreme_gaps, "extreme_gaps", draft_extreme_gaps},
    Kind{StackKind::scale_offset, "scale_offset", draft_scale_offset},
    Kind{StackKind::near_coincident, "near_coincident", draft_near_coincident, true},
    Kind{StackKind::near_touching, "near_touching", draft_near_touching, true},
    Kind{StackKind::stars_combs, "stars_combs", draft_stars_combs},
    Kind{StackKind::slivers, "slivers", draft_slivers},
    Kind{StackKind::u_over_blobs, "u_over_blobs", draft_u_over_blobs},
    Kind{StackKind::crossing_bars, "crossing_bars", draft_crossing_bars},
    Kind{StackKind::interlocking, "interlocking", draft_interlocking},
    Kind{StackKind::split_runs, "split_runs", draft_split_runs},
    Kind{StackKind::few_ulps, "few_ulps", draft_few_ulps, true},
    Kind{StackKind::oblique, "oblique", draft_oblique},
    Kind{StackKind::random_labels, "random_labels", draft_for_labels},
    Kind{StackKind::complementary_sections, "complementary_sections", draft_complementary_sections},
    Kind{StackKind::changing_classes, "changing_classes", draft_changing_classes},
    Kind{StackKind::large_contours, "large_contours", draft_large_contours},
    Kind{StackKind::islands, "islands", draft_islands},
    Kind{StackKind::nested_ngons, "nested_ngons", draft_nested_ngons},
    Kind{StackKind::concentric_ngons, "concentric_ngons", draft_concentric_ngons, true},
    Kind{StackKind::tight_spirals, "tight_spirals", draft_tight_spirals, true},
    Kind{StackKind::tiny_gaps, "tiny_gaps", draft_tiny_gaps, true},
    Kind{StackKind::ulp_combs, "ulp_combs", draft_ulp_combs, true},
    Kind{StackKind::ulp_lattices, "ulp_lattices", draft_ulp_lattices, true},
    Kind{StackKind::needles, "needles", draft_needles, true},
    Kind{StackKind::pores, "pores", draft_pores},
    Kind{StackKind::hole_islands, "hole_islands", draft_hole_islands},
    Kind{StackKind::channels, "channels", draft_channels},
    Kind{StackKind::open_pits, "open_pits", draft_open_pits},
    Kind{StackKind::touching_holes, "touching_holes", draft_touching_holes},
    Kind{StackKind::rings, "rings", draft_rings},
    Kind{StackKind::lattice_pores, "lattice_pores", draft_lattice_pores},
    Kind{StackKind::coarse_lofts, "coarse_lofts", draft_coarse_lofts},
    Kind{StackKind::thin_parts, "thin_parts", draft_thin_parts},
    Kind{StackKind::height_fields, "height_fields", draft_height_fields},
    Kind{StackKind::mended_overlaps, "mended_overlaps", draft_mended_overlaps},
    Kind{StackKind::mended_copies, "mended_copies", draft_mended_copies},
    Kind{StackKind::mended_keyholes, "mended_keyholes", draft_mended_keyholes},
    Kind{StackKind::arranged_planes, "arranged_planes", draft_arranged_planes},
};

constexpr auto kAllKinds = [] {
  std::array<StackKind, kKinds.size()> kinds{};
  for (std::size_t i = 0; i < kinds.size(); ++i) kinds[i] = kKinds[i].kind;
  return kinds;
}();

static_assert([] {
  for (std::size_t i = 0; i < kKinds.size(); ++i) {
    if (kKinds[i].kind != static_cast<StackKind>(i)) return false;
  }
  return true;
}());

const Kind& entry(StackKind kind) { return kKinds[static_cast<std::size_t>(kind)]; }

// Nothing may depend on the direction of a contour, its first vertex or its number.
void scramble(Prng& prng, SectionStack& stack) {
  for (Section& section : stack.sections) {
    for (Contour& contour : section.contours) {
      auto& vertices = contour.vertices;
      if (vertices.empty()) continue;
      if (prng.chance(0.5)) std::reverse(vertices.begin(), vertices.end());
      const auto first = static_cast<std::ptrdiff_t>(prng.below(vertices.size()));
      std::rotate(vertices.begin(), vertices.begin() + first, vertices.end());
    }
    prng.shuffle(section.contours.raw());
  }
}

}  // namespace

std::span<const StackKind> all_kinds() { return kAllKinds; }

std::span<const StackKind> kinds_with_voids() {
  static constexpr std::array kKindsWithVoids{
      StackKind::holes,          StackKind::triangular_holes,
      StackKind::pores,          StackKind::hole_islands,
      StackKind::channels,       StackKind::open_pits,
      StackKind::touching_holes, StackKind::rings,
      StackKind::lattice_pores,
  };
  return kKindsWithVoids;
}

const char* name_of(StackKind kind) { return entry(kind).name; }

std::optional<StackKind> kind_named(std::string_view name) {
  for (const Kind& kind : kKinds) {
    if (name == kind.name) return kind.kind;
  }
  return std::nullopt;
}

bool is_near_coincident(StackKind kind) { return entry(kind).near_coincident; }

bool has_large_triangulations(StackKind kind) {
  return kind == StackKind::large_contours || kind == StackKind::concentric_ngons;
}

GeneratedStack generate(StackKind kind, std::uint64_t seed) {
  // Streams of different kinds with the same seed have nothing in common.
  Prng prng(seed ^ (0xD1B54A32D192ED03ULL * (static_cast<std::uint64_t>(kind) + 1)));
  // More than nine drafts in ten of the worst kind would have to fail for this bound to be
  // reached once in 10^9 stacks.
  constexpr int kDrafts = 200;
  for (int draft = 1; draft <= kDrafts; ++draft) {
    GeneratedStack generated;
    generated.drafts = draft;
    generated.stack = entry(kind).draft(prng);
    scramble(prng, generated.stack);
    if (generated.stack.contour_count() == 0 || !validate(generated.stack)) continue;
    if (kind == StackKind::random_labels) {
      generated.correspondence.labels = random_labels(prng, generated.stack);
    }
    return generated;
  }
  fail_check("a valid draft", __FILE__, __LINE__);
}

}  // namespace tetloft::testing

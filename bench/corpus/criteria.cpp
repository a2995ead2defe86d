// How well criteria of correspondence find the pieces of random solids: missing and false
// unions, by criterion, threshold and guard.
//
//   tetloft_criteria [--solids N] [--size N] [--seed S]
//
// In each slab the regions are parted by the solid itself (the pieces between the two planes)
// and by the criterion. Missing: unions to be added until no piece is in two classes; false:
// unions that the criterion made and the solid does not.
#include <algorithm>
#include <array>
#include <cstdio>
#include <cstdlib>
#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <tetloft/sections.hpp>

#include "core/union_find.hpp"
#include "corpus/solids.hpp"
#include "correspondence/reverse_links.hpp"
#include "slab/delaunay.hpp"
#include "slab/slab.hpp"
#include "words.hpp"

namespace {

using namespace tetloft;
using namespace tetloft::bench;

// A rule under test.
struct Rule {
  std::string name;
  double tau = 0;
  double strong = 2;  // guard: a weak link yields where both have one of this ratio; > 1: none
  bool reverse = false;
  double relative =
      0;             // guard: a link yields where both have one this many times as strong; 0: none
  double drift = 2;  // regions without partner are matched where moved on by their drift; > 1: not
};

std::string named(const char* form, double a, double b = 0) {
  std::array<char, 64> name{};
  std::snprintf(name.data(), name.size(), form, a, b);
  return name.data();
}

std::vector<Rule> all_rules() {
  std::vector<Rule> rules{{"reverse", 0, 2, true}};
  for (const double tau : {0.0, 0.005, 0.01, 0.02, 0.05, 0.1, 0.2}) {
    rules.push_back({named("overlap %g, no guard", tau), tau});
    for (const double strong : {0.5, 0.3, 0.25, 0.2, 0.15, 0.1}) {
      if (strong <= tau) continue;
      rules.push_back({named("overlap %g, guard %g", tau, strong), tau, strong});
    }
    for (const double times : {1.5, 2.0, 4.0, 8.0}) {
      rules.push_back({named("overlap %g, guard %g times", tau, times), tau, 2, false, times});
    }
  }
  for (const double drift : {0.5, 0.3, 0.1, 0.02, 0.0}) {
    rules.push_back(
        {named("overlap 0.02, guard 0.5, drift %g", drift), 0.02, 0.5, false, 0, drift});
  }
  return rules;
}

struct Errors {
  std::size_t missing = 0, wrong = 0;
};

// A section, nested, with its regions' centroids.
struct Regions {
  Section section;
  Nesting nesting;
  std::vector<Point2> centroid;
  [[nodiscard]] std::size_t size() const { return nesting.outer.size(); }
  [[nodiscard]] RegionOutline outline_of(std::size_t r) const {
    return outline(section, nesting, RegionId(r));
  }
};

Regions regions_of(const Section& section) {
  Regions result{section, nest(section), {}};
  for (const ContourId outer : result.nesting.outer) {
    Point2 sum;
    const auto& v = section.contours[outer].vertices;
    for (const Point2& p : v) sum = {sum.x + p.x, sum.y + p.y};
    const auto n = static_cast<double>(v.size());
    result.centroid.push_back({sum.x / n, sum.y / n});
  }
  return result;
}

// Of one slab: ratios of all pairs, and links of reverse tets.
struct SlabFacts {
  std::size_t lows = 0, highs = 0;
  std::vector<double> ratio;  // lows × highs
  std::vector<Link> reverse;
  std::vector<std::size_t> piece;
  [[nodiscard]] double at(std::size_t i, std::size_t j) const { return ratio[i * highs + j]; }
};

struct StackFacts {
  std::vector<Regions> sections;
  std::vector<SlabFacts> slabs;
};

using Pairs = std::vector<std::pair<std::size_t, std::size_t>>;

Pairs overlap_pairs(const Rule& rule, const SlabFacts& slab) {
  std::vector<bool> strong(slab.lows + slab.highs, false);
  std::vector<double> best(slab.lows + slab.highs, 0);
  for (std::size_t i = 0; i < slab.lows; ++i) {
    for (std::size_t j = 0; j < slab.highs; ++j) {
      if (slab.at(i, j) >= rule.strong) strong[i] = strong[slab.lows + j] = true;
      best[i] = std::max(best[i], slab.at(i, j));
      best[slab.lows + j] = std::max(best[slab.lows + j], slab.at(i, j));
    }
  }
  Pairs pairs;
  for (std::size_t i = 0; i < slab.lows; ++i) {
    for (std::size_t j = 0; j < slab.highs; ++j) {
      const double r = slab.at(i, j);
      if (r <= rule.tau || (r < rule.strong && strong[i] && strong[slab.lows + j])) continue;
      if (r * rule.relative > 0 && std::min(best[i], best[slab.lows + j]) >= r * rule.relative) {
        continue;
      }
      pairs.emplace_back(i, j);
    }
  }
  return pairs;
}

// Region r moved by d against region q of another section.
double moved_ratio(const Regions& a, std::size_t r, const Point2& d, const Regions& b,
                   std::size_t q) {
  Section moved;
  for (const Contour* c : a.outline_of(r).contours) {
    Contour contour = *c;
    for (Point2& p : contour.vertices) p = {p.x + d.x, p.y + d.y};
    moved.contours.push_back(std::move(contour));
  }
  const Nesting nesting = nest(moved);
  return overlap_ratio(outline(moved, nesting, RegionId(0)), b.outline_of(q));
}

// How a region moved from its only partner in the section before (or after) it, per unit of z.
std::optional<Point2> drift_of(const Regions& here, std::size_t r, const Regions& there,
                               const Pairs& pairs, bool there_is_below) {
  std::optional<std::size_t> partner;
  for (const auto& [low, high] : pairs) {
    if ((there_is_below ? high : low) != r) continue;
    if (partner) return std::nullopt;
    partner = there_is_below ? low : high;
  }
  if (!partner) return std::nullopt;
  const double dz = here.section.z - there.section.z;
  const Point2& p = here.centroid[r];
  const Point2& q = there.centroid[*partner];
  return Point2{(p.x - q.x) / dz, (p.y - q.y) / dz};
}

void add_drifting(const Rule& rule, const StackFacts& stack, std::size_t s, Pairs& pairs) {
  const Regions& below = stack.sections[s];
  const Regions& above = stack.sections[s + 1];
  const double gap = above.section.z - below.section.z;
  std::vector<bool> taken(below.size() + above.size(), false);
  for (const auto& [i, j] : pairs) taken[i] = taken[below.size() + j] = true;
  Pairs before, after;
  if (s > 0) before = overlap_pairs(rule, stack.slabs[s - 1]);
  if (s + 1 < stack.slabs.size()) after = overlap_pairs(rule, stack.slabs[s + 1]);
  for (std::size_t i = 0; i < below.size(); ++i) {
    for (std::size_t j = 0; j < above.size(); ++j) {
      if (taken[i] || taken[below.size() + j]) continue;
      double best = -1;
      if (s > 0) {
        if (const auto d = drift_of(below, i, stack.sections[s - 1], before, true)) {
          best = moved_ratio(below, i, {d->x * gap, d->y * gap}, above, j);
        }
      }
      if (s + 1 < stack.slabs.size()) {
        if (const auto d = drift_of(above, j, stack.sections[s + 2], after, false)) {
          best = std::max(best, moved_ratio(above, j, {-d->x * gap, -d->y * gap}, below, i));
        }
      }
      if (best > rule.drift) pairs.emplace_back(i, j);
    }
  }
}

UnionFind united_by(const Rule& rule, const StackFacts& stack, std::size_t s) {
  const SlabFacts& slab = stack.slabs[s];
  UnionFind sets(slab.lows + slab.highs);
  if (rule.reverse) {
    for (const Link& l : slab.reverse) sets.unite(l.lower.index(), slab.lows + l.upper.index());
    return sets;
  }
  Pairs pairs = overlap_pairs(rule, slab);
  if (rule.drift <= 1) add_drifting(rule, stack, s, pairs);
  for (const auto& [i, j] : pairs) sets.unite(i, slab.lows + j);
  return sets;
}

std::size_t class_count(const UnionFind& sets, std::size_t n) {
  std::size_t count = 0;
  for (std::size_t k = 0; k < n; ++k) count += sets.find(k) == k ? 1U : 0U;
  return count;
}

Errors errors_of(const Rule& rule, const StackFacts& stack, std::size_t s) {
  const SlabFacts& slab = stack.slabs[s];
  const std::size_t n = slab.lows + slab.highs;
  const UnionFind got = united_by(rule, stack, s);
  UnionFind want(n);
  UnionFind joint(n);
  for (std::size_t a = 0; a < n; ++a) {
    joint.unite(a, got.find(a));
    for (std::size_t b = 0; b < a; ++b) {
      if (slab.piece[a] != slab.piece[b]) continue;
      want.unite(a, b);
      joint.unite(a, b);
    }
  }
  const std::size_t both = class_count(joint, n);
  return {class_count(got, n) - both, class_count(want, n) - both};
}

StackFacts facts_of(const SlicedSolid& sliced) {
  StackFacts facts;
  std::vector<ConformingSection> conformed;
  for (const Section& section : sliced.stack.sections) {
    facts.sections.push_back(regions_of(section));
    conformed.push_back(conform(section, SectionId(conformed.size()), {}).value());
  }
  for (std::size_t s = 0; s + 1 < conformed.size(); ++s) {
    const Regions& below = facts.sections[s];
    const Regions& above = facts.sections[s + 1];
    SlabFacts slab{below.size(), above.size(), {}, {}, sliced.piece[s]};
    for (std::size_t i = 0; i < slab.lows; ++i) {
      for (std::size_t j = 0; j < slab.highs; ++j) {
        slab.ratio.push_back(overlap_ratio(below.outline_of(i), above.outline_of(j)));
      }
    }
    TetMesh mesh = slab_delaunay(SlabId(s), conformed[s], conformed[s + 1], DelaunayEngine::slab,
                                 std::numeric_limits<double>::infinity())
                       .value();
    slab.reverse = reverse_links(SlabId(s), Slab(conformed[s], conformed[s + 1], std::move(mesh)));
    facts.slabs.push_back(std::move(slab));
  }
  return facts;
}

}  // namespace

int main(int argc, char** argv) {
  constexpr const char* kUsage = "usage: tetloft_criteria [--solids N] [--seed S] [--size N]\n";
  std::uint64_t solids = 20, seed = 1, size = 96;
  for (int i = 1; i < argc; i += 2) {
    const std::string option = argv[i];
    std::uint64_t* const target = option == "--solids" ? &solids
                                  : option == "--seed" ? &seed
                                  : option == "--size" ? &size
                                                       : nullptr;
    if (target == nullptr) return usage_failure("unknown option " + option, kUsage);
    if (i + 1 == argc || !parse_number(argv[i + 1], *target)) {
      return usage_failure(option + " has no value that it can take", kUsage);
    }
  }
  const std::vector<Rule> rules = all_rules();
  const std::array<std::size_t, 3> spacings{2, 6, 12};
  // By spacing, contouring and rule.
  std::vector<Errors> total(spacings.size() * 2 * rules.size());
  std::array<std::size_t, 6> unions{};
  for (const SolidKind kind : kSolidKinds) {
    std::vector<Errors> of_kind(rules.size());
    for (std::uint64_t k = 0; k < solids; ++k) {
      const SampledSolid solid = sample_solid(kind, seed + k, size);
      for (std::size_t column = 0; column < 6; ++column) {
        const SlicedSolid sliced =
            slice(solid, spacings[column / 2],
                  column % 2 == 0 ? Contouring::smooth : Contouring::lattice);
        const StackFacts facts = facts_of(sliced);
        for (std::size_t s = 0; s < facts.slabs.size(); ++s) {
          for (std::size_t r = 0; r < rules.size(); ++r) {
            const Errors errors = errors_of(rules[r], facts, s);
            total[column * rules.size() + r].missing += errors.missing;
            total[column * rules.size() + r].wrong += errors.wrong;
            of_kind[r].missing += errors.missing;
            of_kind[r].wrong += errors.wrong;
          }
          unions[column] += facts.slabs[s].piece.size();
        }
      }
    }
    std::fprintf(stderr, "%s:", std::string(name_of(kind)).c_str());
    for (std::size_t r = 0; r < rules.size(); ++r) {
      std::fprintf(stderr, " [%s] %zu+%zu", rules[r].name.c_str(), of_kind[r].missing,
                   of_kind[r].wrong);
    }
    std::fprintf(stderr, "\n");
  }
  std::printf("missing + false unions | ");
  for (std::size_t column = 0; column < 6; ++column) {
    std::printf("%s, every %zu | ", column % 2 == 0 ? "smooth" : "lattice", spacings[column / 2]);
  }
  std::printf("sum |\n|---|---|---|---|---|---|---|---|\n");
  for (std::size_t r = 0; r < rules.size(); ++r) {
    std::printf("| %s | ", rules[r].name.c_str());
    std::size_t sum = 0;
    for (std::size_t column = 0; column < 6; ++column) {
      const Errors& e = total[column * rules.size() + r];
      std::printf("%zu + %zu | ", e.missing, e.wrong);
      sum += e.missing + e.wrong;
    }
    std::printf("%zu |\n", sum);
  }
  std::printf("| regions | ");
  for (const std::size_t n : unions) std::printf("%zu | ", n);
  std::printf(" |\n");
  return 0;
}

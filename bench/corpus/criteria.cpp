// How well criteria of correspondence find the pieces of random solids: missing and false unions,
// by criterion; and of sliced meshes, the components.
//
//   tetloft_criteria [--solids N] [--size N] [--seed S] [--spacing N] [--contours C] [FILE.cnt …]
//
// In each slab the regions are parted by the solid itself (the pieces between the two planes)
// and by the criterion. Missing: unions to be added until no piece is in two classes; false:
// unions that the criterion made and the solid does not.
#include <array>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

#include <tetloft/io.hpp>
#include <tetloft/sections.hpp>

#include "core/union_find.hpp"
#include "corpus/link_facts.hpp"
#include "corpus/link_rules.hpp"
#include "corpus/solids.hpp"
#include "stack_truth.hpp"
#include "words.hpp"

namespace {

using namespace tetloft;
using namespace tetloft::bench;

std::vector<LinkRule> all_rules() {
  std::vector<LinkRule> rules{
      {"overlap 0.02, guard 0.25", Evidence::plain, 0.02, 0, 0.25},
      {"the same + lone", Evidence::plain, 0.02, 0, 0.25, true},
      {"overlap 0.1 + lone", Evidence::plain, 0.1, 1, 2, true},
  };
  const std::pair<const char*, Evidence> forms[] = {{"max", Evidence::max},
                                                    {"mean", Evidence::mean},
                                                    {"joint", Evidence::joint},
                                                    {"jmax", Evidence::joint_max},
                                                    {"three", Evidence::three}};
  for (const auto& [name, evidence] : forms) {
    const std::string form = std::string("moved ") + name;
    rules.push_back({form, evidence, 0.1, 1, 2, false});
    rules.push_back({form + " + lone", evidence, 0.1, 1, 2, true});
    rules.push_back({form + " + lone 0.08", evidence, 0.08, 1, 2, true});
    rules.push_back({form + " + lone 0.12", evidence, 0.12, 1, 2, true});
  }
  return rules;
}

struct Errors {
  std::size_t missing = 0, wrong = 0;
};

std::size_t class_count(const UnionFind& sets) {
  std::size_t count = 0;
  for (std::size_t k = 0; k < sets.size(); ++k) count += sets.find(k) == k ? 1U : 0U;
  return count;
}

Errors errors_of(const SlabFacts& slab, const std::vector<std::size_t>& piece,
                 const std::vector<std::pair<std::size_t, std::size_t>>& links) {
  const std::size_t lows = slab.low_area.size();
  const std::size_t n = piece.size();
  UnionFind got(n), want(n), joint(n);
  for (const auto& [i, j] : links) {
    got.unite(i, lows + j);
    joint.unite(i, lows + j);
  }
  for (std::size_t a = 0; a < n; ++a) {
    for (std::size_t b = 0; b < a; ++b) {
      if (piece[a] != piece[b]) continue;
      want.unite(a, b);
      joint.unite(a, b);
    }
  }
  const std::size_t both = class_count(joint);
  return {class_count(got) - both, class_count(want) - both};
}

std::size_t component_count(const std::vector<SlabFacts>& slabs, const StackLinks& links) {
  std::vector<std::size_t> first{0};
  for (const SlabFacts& slab : slabs) first.push_back(first.back() + slab.low_area.size());
  UnionFind sets(first.back() + (slabs.empty() ? 0 : slabs.back().high_area.size()));
  for (std::size_t s = 0; s < slabs.size(); ++s) {
    for (const auto& [i, j] : links[s]) sets.unite(first[s] + i, first[s + 1] + j);
  }
  return class_count(sets);
}

struct Options {
  std::uint64_t solids = 6, seed = 1, size = 96, spacing = 0;
  std::string contours = "smooth";
  std::string only;
  std::vector<std::string> files;
};

struct Tally {
  std::array<Errors, 6> kind{};
  std::size_t exact = 0, components = 0, moving = 0, regions = 0;
};

int survey(const Options& options, const std::vector<LinkRule>& rules) {
  std::vector<long> sum(rules.size(), 0);
  for (const std::string& file : options.files) {
    const auto read = read_cnt(file);
    const auto truth = read_stack_truth(file).components;
    if (!read || !truth) continue;
    const std::vector<SlabFacts> slabs = facts_of(read->stack, 0.7);
    std::printf("%s %g:", file.substr(file.rfind('/') + 1).c_str(), *truth);
    for (std::size_t r = 0; r < rules.size(); ++r) {
      const auto got = static_cast<long>(component_count(slabs, links_by(rules[r], slabs)));
      std::printf(" %ld", got);
      sum[r] += std::labs(got - static_cast<long>(*truth));
    }
    std::printf("\n");
    std::fflush(stdout);
  }
  for (std::size_t r = 0; r < rules.size(); ++r)
    std::printf("%-36s %ld\n", rules[r].name.c_str(), sum[r]);
  return 0;
}

void corpus(const Options& options, const std::vector<LinkRule>& rules, std::size_t spacing) {
  std::vector<Tally> tally(rules.size());
  std::size_t stacks = 0;
  for (std::size_t kind = 0; kind < 6; ++kind) {
    if (!options.only.empty() && name_of(kSolidKinds[kind]) != options.only) continue;
    for (std::uint64_t k = 0; k < options.solids; ++k) {
      const SampledSolid solid = sample_solid(kSolidKinds[kind], options.seed + k, options.size);
      const SlicedSolid sliced = slice(
          solid, spacing, options.contours == "smooth" ? Contouring::smooth : Contouring::lattice);
      const std::vector<SlabFacts> slabs = facts_of(sliced.stack, 0.7);
      ++stacks;
      for (std::size_t r = 0; r < rules.size(); ++r) {
        const StackLinks links = links_by(rules[r], slabs);
        bool exact = true;
        for (std::size_t s = 0; s < slabs.size(); ++s) {
          const Errors e = errors_of(slabs[s], sliced.piece[s], links[s]);
          tally[r].kind[kind].missing += e.missing;
          tally[r].kind[kind].wrong += e.wrong;
          if (e.missing + e.wrong > 0) exact = false;
        }
        if (exact) ++tally[r].exact;
        for (const SlabFacts& f : slabs) tally[r].moving += f.moving, tally[r].regions += f.regions;
      }
    }
  }
  std::printf("every %zu, %s, seeds %llu to %llu, %zu stacks\n", spacing, options.contours.c_str(),
              static_cast<unsigned long long>(options.seed),
              static_cast<unsigned long long>(options.seed + options.solids - 1), stacks);
  for (std::size_t r = 0; r < rules.size(); ++r) {
    Errors sum;
    for (const Errors& e : tally[r].kind) sum.missing += e.missing, sum.wrong += e.wrong;
    std::printf("%-32s %4zu + %4zu = %4zu  exact %3zu moving %4.1f %% |", rules[r].name.c_str(),
                sum.missing, sum.wrong, sum.missing + sum.wrong, tally[r].exact,
                100.0 * double(tally[r].moving) / double(tally[r].regions));
    for (const Errors& e : tally[r].kind) std::printf(" %3zu+%-3zu", e.missing, e.wrong);
    std::printf("\n");
  }
}

}  // namespace

int main(int argc, char** argv) {
  constexpr const char* kUsage =
      "usage: tetloft_criteria [--solids N] [--seed S] [--size N] [--spacing N] [--contours "
      "smooth|lattice] [FILE.cnt …]\n";
  Options options;
  for (int i = 1; i < argc; ++i) {
    const std::string option = argv[i];
    if (option.compare(0, 2, "--") != 0) {
      options.files.push_back(option);
      continue;
    }
    if (option == "--contours" || option == "--only") {
      if (i + 1 == argc) return usage_failure(option + " has no value that it can take", kUsage);
      (option == "--only" ? options.only : options.contours) = argv[++i];
      continue;
    }
    std::uint64_t* const target = option == "--solids"    ? &options.solids
                                  : option == "--seed"    ? &options.seed
                                  : option == "--size"    ? &options.size
                                  : option == "--spacing" ? &options.spacing
                                                          : nullptr;
    if (target == nullptr) return usage_failure("unknown option " + option, kUsage);
    if (i + 1 == argc || !parse_number(argv[i + 1], *target)) {
      return usage_failure(option + " has no value that it can take", kUsage);
    }
    ++i;
  }
  const std::vector<LinkRule> rules = all_rules();
  if (!options.files.empty()) return survey(options, rules);
  for (const std::size_t spacing : {std::size_t{2}, std::size_t{6}, std::size_t{12}}) {
    if (options.spacing == 0 || options.spacing == spacing) corpus(options, rules, spacing);
  }
  return 0;
}

// How well the rules of correspondence find the pieces of random solids: missing and false unions,
// by rule; and of stacks of known truth, the components.
//
//   tetloft_criteria [--solids N] [--size N] [--seed S] [--spacing N] [--contours smooth|lattice]
//                    [FILE.cnt …]
#include <algorithm>
#include <array>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <vector>

#include <tetloft/io.hpp>
#include <tetloft/links.hpp>

#include "corpus/solids.hpp"
#include "corpus/union_errors.hpp"
#include "stack_truth.hpp"
#include "value_of.hpp"
#include "words.hpp"

namespace {

using namespace tetloft;
using namespace tetloft::bench;

constexpr const char* kUsage =
    "usage: tetloft_criteria [--solids N] [--seed S] [--size N] [--spacing N]\n"
    "                        [--contours smooth|lattice] [FILE.cnt ...]\n";
constexpr std::size_t kKinds = std::size(kSolidKinds);
constexpr std::array<std::size_t, 3> kSpacings{2, 6, 12};

struct Rule {
  std::string name;
  CorrespondenceOptions options;
};

std::vector<Rule> all_rules() {
  const auto rule = [](Criterion criterion, bool chain, bool lone) {
    CorrespondenceOptions options;
    options.criterion = criterion;
    options.chain = chain;
    options.lone = lone;
    return options;
  };
  return {{"reverse", rule(Criterion::reverse, false, false)},
          {"overlap", rule(Criterion::overlap, false, false)},
          {"overlap, lone", rule(Criterion::overlap, false, true)},
          {"overlap, chain, lone", rule(Criterion::overlap, true, true)},
          {"moved", rule(Criterion::moved, false, false)},
          {"moved, lone", rule(Criterion::moved, false, true)},
          {"moved, chain, lone", rule(Criterion::moved, true, true)}};
}

struct Options {
  std::uint64_t solids = 6, seed = 1, size = 96, spacing = 0;
  Contouring contours = Contouring::smooth;
  std::vector<std::filesystem::path> files;
};

struct Tally {
  std::array<UnionErrors, kKinds> of_kind{};
  std::size_t exact = 0;
};

StackLinks links_by(const Rule& rule, const SectionStack& stack) {
  return value_of(find_links(stack, {rule.options, {.threads = 1}}));
}

void print_corpus(const std::vector<Rule>& rules, const std::vector<Tally>& tallies) {
  std::printf("| rule | missing + false | sum | exact |");
  for (const SolidKind kind : kSolidKinds) std::printf(" %s |", std::string(name_of(kind)).c_str());
  std::printf("\n|---|---|---|---|---|---|---|---|---|---|\n");
  for (std::size_t r = 0; r < rules.size(); ++r) {
    UnionErrors sum;
    for (const UnionErrors& errors : tallies[r].of_kind) sum += errors;
    std::printf("| %s | %zu + %zu | %zu | %zu |", rules[r].name.c_str(), sum.missing, sum.wrong,
                sum.sum(), tallies[r].exact);
    for (const UnionErrors& e : tallies[r].of_kind) std::printf(" %zu + %zu |", e.missing, e.wrong);
    std::printf("\n");
  }
}

void survey_corpus(const Options& options, std::size_t spacing) {
  const std::vector<Rule> rules = all_rules();
  std::vector<Tally> tallies(rules.size());
  std::size_t stacks = 0;
  for (std::size_t kind = 0; kind < kKinds; ++kind) {
    for (std::uint64_t k = 0; k < options.solids; ++k) {
      const SampledSolid solid = sample_solid(kSolidKinds[kind], options.seed + k, options.size);
      const SlicedSolid sliced = slice(solid, spacing, options.contours);
      if (sliced.stack.sections.empty()) continue;
      ++stacks;
      for (std::size_t r = 0; r < rules.size(); ++r) {
        const StackLinks links = links_by(rules[r], sliced.stack);
        const UnionErrors errors = union_errors(sliced.stack, links.links, sliced.piece);
        tallies[r].of_kind[kind] += errors;
        tallies[r].exact += errors.sum() == 0 ? 1U : 0U;
      }
    }
  }
  std::printf("\nEvery %zu, seeds %llu to %llu: %zu stacks.\n\n", spacing,
              static_cast<unsigned long long>(options.seed),
              static_cast<unsigned long long>(options.seed + options.solids - 1), stacks);
  print_corpus(rules, tallies);
}

int survey_files(const Options& options) {
  const std::vector<Rule> rules = all_rules();
  std::vector<std::size_t> wrong(rules.size(), 0);
  std::printf("| stack | true |");
  for (const Rule& rule : rules) std::printf(" %s |", rule.name.c_str());
  std::printf("\n|---|---|");
  for (std::size_t r = 0; r < rules.size(); ++r) std::printf("---|");
  std::printf("\n");
  for (const std::filesystem::path& path : options.files) {
    const StackTruth truth = read_stack_truth(path);
    if (!truth.components) continue;
    const Result<ReadStack> read = read_cnt(path.string());
    if (!read) return usage_failure(to_string(read.error()), kUsage);
    const auto want = static_cast<std::size_t>(*truth.components);
    std::printf("| %s | %zu |", path.stem().string().c_str(), want);
    for (std::size_t r = 0; r < rules.size(); ++r) {
      const std::size_t got = links_by(rules[r], read->stack).components;
      std::printf(" %zu |", got);
      wrong[r] += got > want ? got - want : want - got;
    }
    std::printf("\n");
  }
  std::printf("| wrong | |");
  for (const std::size_t n : wrong) std::printf(" %zu |", n);
  std::printf("\n");
  return 0;
}

// False where the word after an option is no value of it.
bool take_value(const std::string& option, const std::string& word, Options& options) {
  if (option == "--solids") return parse_number(word, options.solids);
  if (option == "--seed") return parse_number(word, options.seed);
  if (option == "--size") return parse_number(word, options.size);
  if (option == "--spacing") return parse_number(word, options.spacing) && options.spacing > 0;
  options.contours = word == "lattice" ? Contouring::lattice : Contouring::smooth;
  return word == "lattice" || word == "smooth";
}

}  // namespace

int main(int argc, char** argv) {
  const std::vector<std::string> known{"--solids", "--seed", "--size", "--spacing", "--contours"};
  Options options;
  for (int i = 1; i < argc; ++i) {
    const std::string word = argv[i];
    if (word.rfind("--", 0) != 0) {
      options.files.emplace_back(word);
      continue;
    }
    if (std::find(known.begin(), known.end(), word) == known.end()) {
      return usage_failure("unknown option " + word, kUsage);
    }
    if (i + 1 == argc || !take_value(word, argv[++i], options)) {
      return usage_failure(word + " has no value that it can take", kUsage);
    }
  }
  if (!options.files.empty()) return survey_files(options);
  if (options.spacing > 0) {
    survey_corpus(options, options.spacing);
  } else {
    for (const std::size_t spacing : kSpacings) survey_corpus(options, spacing);
  }
  return 0;
}

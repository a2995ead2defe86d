// tetloft_campaign: as many random stacks as you have patience for.
#include <charconv>
#include <cstdio>
#include <string>
#include <string_view>
#include <vector>

#include "core/spelling.hpp"
#include "property/run_campaign.hpp"

namespace {

using namespace tetloft::testing;

constexpr const char* kUsage =
    "usage: tetloft_campaign [--count N] [--seed S] [--kind NAME]… [--threads N] [--out DIR]\n"
    "  --count N    stacks of each kind (default 10)\n"
    "  --seed S     first seed (default 1)\n"
    "  --kind NAME  only this kind; may be repeated\n"
    "  --between N  sections put between two: a number, or auto (default 0)\n"
    "  --threads N  stacks tried at the same time (default 0: all processors)\n"
    "  --out DIR    where shrunk failing stacks go (default campaign_failures)\n"
    "Exit code 0: no wrong model and no rule without use; 1: otherwise.\n";

bool parse_number(std::string_view text, auto& value) {
  const char* const end = text.data() + text.size();
  const auto [stopped, failed] = std::from_chars(text.data(), end, value);
  return failed == std::errc() && stopped == end;
}

std::string meant_kind(std::string_view value) {
  std::vector<std::string_view> names;
  for (const StackKind kind : all_kinds()) names.emplace_back(name_of(kind));
  return tetloft::internal::did_you_mean(value, names);
}

// What is wrong with the command line, or nothing.
std::string parse(int argc, char** argv, CampaignOptions& options) {
  for (int i = 1; i < argc; i += 2) {
    const std::string_view name = argv[i];
    const std::string_view value = i + 1 < argc ? argv[i + 1] : "";
    bool good = i + 1 < argc;
    if (name == "--count") {
      good = good && parse_number(value, options.count) && options.count > 0;
    } else if (name == "--seed") {
      good = good && parse_number(value, options.seed);
    } else if (name == "--between") {
      if (value == "auto") {
        options.between = std::nullopt;
      } else {
        good = good && parse_number(value, options.between.emplace());
      }
    } else if (name == "--threads") {
      good = good && parse_number(value, options.threads);
    } else if (name == "--out") {
      options.folder = value;
    } else if (name == "--kind") {
      const auto kind = kind_named(value);
      if (!kind) return "--kind " + std::string(value) + ": no such kind" + meant_kind(value);
      options.kinds.push_back(*kind);
    } else {
      return "unknown option " + std::string(name);
    }
    if (!good) return std::string(name) + " has no value that it can take";
  }
  return {};
}

}  // namespace

int main(int argc, char** argv) {
  CampaignOptions options;
  options.threads = 0;
  options.folder = "campaign_failures";
  options.shrink_trials = 2000;
  if (const std::string wrong = parse(argc, argv, options); !wrong.empty()) {
    std::fprintf(stderr, "error: %s\n%s", wrong.c_str(), kUsage);
    std::fputs("kinds:", stderr);
    for (const StackKind kind : all_kinds()) std::fprintf(stderr, " %s", name_of(kind));
    std::fputs("\n", stderr);
    return 2;
  }
  const CampaignResult result = run_campaign(options);
  std::fputs(table(result).c_str(), stdout);
  for (const Failure& failure : result.failures) std::printf("\n%s\n", to_string(failure).c_str());
  // A campaign over some kinds need not reach every rule.
  const bool all_rules = !options.kinds.empty() || rare_rules(result, 10).empty();
  if (!all_rules) std::puts("\nsome rules fired fewer than ten times");
  return result.failures.empty() && all_rules ? 0 : 1;
}

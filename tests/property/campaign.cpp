// tetloft_campaign: as many random stacks as you have patience for.
#include <charconv>
#include <cstdio>
#include <string>
#include <string_view>

#include "property/run_campaign.hpp"

namespace {

using namespace tetloft::testing;

constexpr const char* kUsage =
    "usage: tetloft_campaign [--count N] [--seed S] [--kind NAME]… [--threads N] [--out DIR]\n"
    "  --count N    stacks of each kind (default 10)\n"
    "  --seed S     first seed (default 1)\n"
    "  --kind NAME  only this kind; may be repeated\n"
    "  --threads N  stacks tried at the same time (default 0: all processors)\n"
    "  --out DIR    where shrunk failing stacks go (default campaign_failures)\n"
    "Exit code 0: no wrong model and no rule without use; 1: otherwise.\n";

bool parse_number(std::string_view text, auto& value) {
  const char* const end = text.data() + text.size();
  const auto [stopped, failed] = std::from_chars(text.data(), end, value);
  return failed == std::errc() && stopped == end;
}

bool parse(int argc, char** argv, CampaignOptions& options) {
  for (int i = 1; i + 1 < argc; i += 2) {
    const std::string_view name = argv[i];
    const std::string_view value = argv[i + 1];
    bool good = true;
    if (name == "--count") {
      good = parse_number(value, options.count) && options.count > 0;
    } else if (name == "--seed") {
      good = parse_number(value, options.seed);
    } else if (name == "--threads") {
      good = parse_number(value, options.threads);
    } else if (name == "--out") {
      options.folder = value;
    } else if (name == "--kind") {
      const auto kind = kind_named(value);
      good = kind.has_value();
      if (good) options.kinds.push_back(*kind);
    } else {
      good = false;
    }
    if (!good) return false;
  }
  return argc % 2 == 1;
}

}  // namespace

int main(int argc, char** argv) {
  CampaignOptions options;
  options.threads = 0;
  options.folder = "campaign_failures";
  options.shrink_trials = 2000;
  if (!parse(argc, argv, options)) {
    std::fputs(kUsage, stderr);
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

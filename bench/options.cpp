#include "options.hpp"

#include <algorithm>
#include <string_view>
#include <thread>

#include <tetloft/execution.hpp>

#include "words.hpp"

namespace tetloft::bench {

const char* const kBenchUsage =
    "tetloft_bench [--only PART-OF-NAME] [--repeat K] [--peers "
    "CGAL,TetGen,Qhull,HXT,geogram,Voro++|none]\n"
    "              [--sizes 10k,100k,1M] [--threads 1,2,4|all] [--points FILE …] [--stack FILE.cnt "
    "…]\n"
    "              [--queries 200k] [--limit SECONDS] [--json FILE] [--markdown FILE] [--plot "
    "FILE.svg] [--list]\n"
    "Each case runs K times (5), its contestants in turns, each run no longer than the limit "
    "(120);\n"
    "sizes are those of the cases by distribution, dynamic and periodic ones, threads of the "
    "first; see bench/README.md.\n";

namespace {

std::vector<std::string_view> split(std::string_view list) {
  std::vector<std::string_view> words;
  for (std::size_t first = 0; first <= list.size();) {
    const std::size_t end = std::min(list.find(',', first), list.size());
    words.push_back(list.substr(first, end - first));
    first = end + 1;
  }
  return words;
}

// "1200", "10k", "1M".
bool parse_size(std::string_view word, std::size_t& size) {
  constexpr std::size_t kMost = 100'000'000;
  std::size_t unit = 1;
  if (!word.empty() && (word.back() == 'k' || word.back() == 'M')) {
    unit = word.back() == 'k' ? 1000 : 1'000'000;
    word.remove_suffix(1);
  }
  if (!parse_number(word, size) || size == 0 || size > kMost / unit) return false;
  size *= unit;
  return true;
}

template <class Number, class Parse>
bool parse_ascending(std::string_view list, std::vector<Number>& numbers, Parse parse_one) {
  numbers.clear();
  for (const std::string_view word : split(list)) {
    Number number = 0;
    if (!parse_one(word, number)) return false;
    numbers.push_back(number);
  }
  std::sort(numbers.begin(), numbers.end());
  numbers.erase(std::unique(numbers.begin(), numbers.end()), numbers.end());
  return true;
}

// 1, 2, 4 … and as many as the machine has.
std::vector<unsigned> all_threads() {
  const unsigned most = std::clamp(std::thread::hardware_concurrency(), 1U, kMostThreads);
  std::vector<unsigned> threads;
  for (unsigned t = 1; t < most; t *= 2) threads.push_back(t);
  threads.push_back(most);
  return threads;
}

bool parse_threads(std::string_view list, std::vector<unsigned>& threads) {
  if (list == "all") {
    threads = all_threads();
    return true;
  }
  return parse_ascending(list, threads, [](std::string_view word, unsigned& number) {
    return parse_number(word, number) && number > 0 && number <= kMostThreads;
  });
}

// False: the option is none, or has a value that it cannot take.
bool take(const std::string& word, const std::string& value, BenchOptions& options, bool& known) {
  if (word == "--only") {
    options.only = value;
  } else if (word == "--repeat") {
    return parse_number(value, options.rounds) && options.rounds > 0;
  } else if (word == "--limit") {
    return parse_number(value, options.limit) && options.limit > 0;
  } else if (word == "--peers") {
    options.peers.clear();
    for (const std::string_view peer : split(value)) options.peers.emplace_back(peer);
  } else if (word == "--sizes") {
    if (!parse_ascending(value, options.distributions.sizes, parse_size)) return false;
    options.dynamic.sizes = options.distributions.sizes;
  } else if (word == "--queries") {
    return parse_size(value, options.dynamic.queries);
  } else if (word == "--threads") {
    return parse_threads(value, options.distributions.threads);
  } else if (word == "--points") {
    options.distributions.files.push_back(value);
  } else if (word == "--stack") {
    options.stacks.push_back(value);
  } else if (word == "--json") {
    options.json = value;
  } else if (word == "--markdown") {
    options.markdown = value;
  } else if (word == "--plot") {
    options.plot = value;
  } else {
    known = false;
  }
  return known;
}

}  // namespace

std::string parse(int argc, char** argv, BenchOptions& options) {
  for (int i = 1; i < argc; ++i) {
    const std::string word = argv[i];
    if (word == "--list") {
      options.list = true;
      continue;
    }
    const bool has_value = i + 1 < argc;
    bool known = true;
    const bool taken = take(word, has_value ? argv[i + 1] : "", options, known);
    if (!known) return "unknown option " + word;
    if (!has_value || !taken) return word + " has no value that it can take";
    ++i;
  }
  return {};
}

}  // namespace tetloft::bench

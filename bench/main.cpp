// tetloft_bench: the library's engines, alone and against others, on a table of cases.
#include <algorithm>
#include <fstream>
#include <iostream>
#include <string>
#include <vector>

#include "cases.hpp"
#include "report.hpp"
#include "words.hpp"

namespace {

using namespace tetloft::bench;

constexpr const char* kUsage =
    "tetloft_bench [--only PART-OF-NAME] [--repeat K] [--peers CGAL,TetGen,Qhull|none] [--stack "
    "FILE.cnt …]\n"
    "              [--limit SECONDS] [--json FILE] [--markdown FILE] [--list]\n"
    "Each case runs K times (5), its contestants in turns, each run no longer than the limit "
    "(120);\n"
    "see bench/README.md.\n";

struct Options {
  std::string only;
  int rounds = 5;
  double limit = 120;
  std::string peers = "CGAL,TetGen,Qhull";
  bool list = false;
  std::vector<std::string> stacks;
  std::string json;
  std::string markdown;
};

// What is wrong with the words, or nothing.
std::string parse(int argc, char** argv, Options& options) {
  for (int i = 1; i < argc; ++i) {
    const std::string word = argv[i];
    if (word == "--list") {
      options.list = true;
      continue;
    }
    const std::string value = i + 1 < argc ? argv[i + 1] : "";
    bool good = i + 1 < argc;
    ++i;
    if (word == "--only") {
      options.only = value;
    } else if (word == "--repeat") {
      good = good && parse_number(value, options.rounds) && options.rounds > 0;
    } else if (word == "--limit") {
      good = good && parse_number(value, options.limit) && options.limit > 0;
    } else if (word == "--peers") {
      options.peers = value;
    } else if (word == "--stack") {
      options.stacks.push_back(value);
    } else if (word == "--json") {
      options.json = value;
    } else if (word == "--markdown") {
      options.markdown = value;
    } else {
      return "unknown option " + word;
    }
    if (!good) return word + " has no value that it can take";
  }
  return {};
}

constexpr const char* kPredicates = "predicates";

std::vector<Peer> installed_peers() {
  std::vector<Peer> peers;
#ifdef TETLOFT_BENCH_CGAL
  peers.push_back(cgal());
#endif
#ifdef TETLOFT_BENCH_TETGEN
  peers.push_back(tetgen());
#endif
#ifdef TETLOFT_BENCH_QHULL
  peers.push_back(qhull());
#endif
  return peers;
}

// Names that nothing here has; "none" and peers that are not installed are no mistakes.
std::string unknown_name(const Options& options, const std::vector<Case>& cases) {
  std::vector<std::string> names{kPredicates};
  for (const Case& one : cases) names.push_back(one.name);
  if (!any_has(names, options.only)) return no_such("--only", options.only, names);
  const std::vector<std::string> peers{"CGAL", "TetGen", "Qhull", "none"};
  for (std::size_t first = 0; first <= options.peers.size();) {
    const std::size_t end = std::min(options.peers.find(',', first), options.peers.size());
    const std::string peer = options.peers.substr(first, end - first);
    if (std::find(peers.begin(), peers.end(), peer) == peers.end()) {
      return no_such("--peers", peer, peers);
    }
    first = end + 1;
  }
  return {};
}

// Those that are installed and named in the list.
std::vector<Peer> chosen_peers(const std::string& names) {
  std::vector<Peer> peers = installed_peers();
  std::erase_if(peers,
                [&](const Peer& peer) { return names.find(peer.name) == std::string::npos; });
  return peers;
}

bool put(const std::string& path, const std::string& text) {
  if (path.empty()) return true;
  std::ofstream file(path);
  file << text;
  return file.good();
}

}  // namespace

int main(int argc, char** argv) {
  Options options;
  std::string wrong = parse(argc, argv, options);
  if (!wrong.empty()) return usage_failure(wrong, kUsage);
  const std::vector<Case> cases = all_cases(options.stacks);
  wrong = unknown_name(options, cases);
  if (!wrong.empty()) return usage_failure(wrong, kUsage);
  Report report;
  report.rounds = options.rounds;
  report.limit = options.limit;
  const std::vector<Peer> peers = chosen_peers(options.peers);
  for (const Peer& peer : peers) report.versions.push_back(peer.name + ' ' + peer.version);
  for (const std::string& version : report.versions) std::cout << version << '\n';

  bool failed = false;
  for (const Case& one : cases) {
    if (one.name.find(options.only) == std::string::npos) continue;
    if (options.list) {
      std::cout << one.name << ": " << one.what << '\n';
      continue;
    }
    const Case::Field field = one.make(peers);
    std::vector<Contestant> all = field.own;
    all.insert(all.end(), field.peers.begin(), field.peers.end());
    std::vector<Measurement> measured = measure(all, options.rounds, options.limit);
    CaseReport result{one.name, one.what, field.points, {}, {}};
    for (std::size_t i = 0; i < measured.size(); ++i) {
      failed |= i < field.own.size() && !measured[i].failure.empty();
      (i < field.own.size() ? result.own : result.peers).push_back(std::move(measured[i]));
    }
    std::cout << text_of(result) << std::flush;
    report.cases.push_back(std::move(result));
  }
  if (std::string(kPredicates).find(options.only) != std::string::npos && !options.list) {
    report.predicates = time_predicates(options.rounds);
    std::cout << text_of(report.predicates);
  }
  if (!put(options.json, json_of(report)) || !put(options.markdown, markdown_of(report))) {
    std::cerr << "cannot write the report\n";
    return 4;
  }
  return failed ? 1 : 0;
}

// tetloft_bench: the library's engines, alone and against others, on a table of cases.
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <iostream>
#include <string>
#include <vector>

#include "cases.hpp"
#include "report.hpp"

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

bool parse(int argc, char** argv, Options& options) {
  for (int i = 1; i < argc; ++i) {
    const std::string word = argv[i];
    if (word == "--list") {
      options.list = true;
      continue;
    }
    if (i + 1 == argc) return false;
    const std::string value = argv[++i];
    if (word == "--only") {
      options.only = value;
    } else if (word == "--repeat") {
      options.rounds = std::atoi(value.c_str());
    } else if (word == "--limit") {
      options.limit = std::atof(value.c_str());
    } else if (word == "--peers") {
      options.peers = value;
    } else if (word == "--stack") {
      options.stacks.push_back(value);
    } else if (word == "--json") {
      options.json = value;
    } else if (word == "--markdown") {
      options.markdown = value;
    } else {
      return false;
    }
  }
  return options.rounds > 0 && options.limit > 0;
}

// Those that are installed and named in the list.
std::vector<Peer> chosen_peers(const std::string& names) {
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
  if (!parse(argc, argv, options)) {
    std::cerr << kUsage;
    return 2;
  }
  Report report;
  report.rounds = options.rounds;
  report.limit = options.limit;
  const std::vector<Peer> peers = chosen_peers(options.peers);
  for (const Peer& peer : peers) report.versions.push_back(peer.name + ' ' + peer.version);
  for (const std::string& version : report.versions) std::cout << version << '\n';

  bool failed = false;
  for (const Case& one : all_cases(options.stacks)) {
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
  if (std::string("predicates").find(options.only) != std::string::npos && !options.list) {
    report.predicates = time_predicates(options.rounds);
    std::cout << text_of(report.predicates);
  }
  if (!put(options.json, json_of(report)) || !put(options.markdown, markdown_of(report))) {
    std::cerr << "cannot write the report\n";
    return 4;
  }
  return failed ? 1 : 0;
}

// tetloft_bench: the library's engines, alone and against others, on a table of cases.
#include <algorithm>
#include <exception>
#include <fstream>
#include <iostream>
#include <string>
#include <vector>

#include "cases.hpp"
#include "distributions.hpp"
#include "options.hpp"
#include "periodic_cases.hpp"
#include "plane_cases.hpp"
#include "plot.hpp"
#include "report.hpp"
#include "words.hpp"

namespace {

using namespace tetloft::bench;

constexpr const char* kPredicates = "predicates";

// As CMake has found them: "cgal(), tetgen()".
std::vector<Peer> installed_peers() { return {TETLOFT_BENCH_PEERS}; }

// Names that nothing here has; "none" and peers that are not installed are no mistakes.
std::string unknown_name(const BenchOptions& options, const std::vector<Case>& cases) {
  std::vector<std::string> names{kPredicates};
  for (const Case& one : cases) names.push_back(one.name);
  if (!any_has(names, options.only)) return no_such("--only", options.only, names);
  std::vector<std::string> peers = BenchOptions().peers;
  peers.emplace_back("none");
  for (const std::string& peer : options.peers) {
    if (std::find(peers.begin(), peers.end(), peer) == peers.end()) {
      return no_such("--peers", peer, peers);
    }
  }
  return {};
}

// Those that are installed and named.
std::vector<Peer> chosen_peers(const std::vector<std::string>& names) {
  std::vector<Peer> peers = installed_peers();
  std::erase_if(peers, [&](const Peer& peer) {
    return std::find(names.begin(), names.end(), peer.name) == names.end();
  });
  return peers;
}

bool put(const std::string& path, const std::string& text) {
  if (path.empty()) return true;
  std::ofstream file(path);
  file << text;
  return file.good();
}

// Runs the case and adds it to the report. False if one of ours failed.
bool run_case(const Case& one, const std::vector<Peer>& peers, const BenchOptions& options,
              Report& report) {
  const Case::Field field = one.make(peers);
  std::vector<Contestant> all = field.own;
  all.insert(all.end(), field.peers.begin(), field.peers.end());
  std::vector<Measurement> measured = measure(all, options.rounds, options.limit);
  CaseReport result{one.name, one.what, field.points, {}, {}, one.distribution};
  bool good = true;
  for (std::size_t i = 0; i < measured.size(); ++i) {
    good = good && (i >= field.own.size() || measured[i].failure.empty());
    (i < field.own.size() ? result.own : result.peers).push_back(std::move(measured[i]));
  }
  std::cout << text_of(result) << std::flush;
  report.cases.push_back(std::move(result));
  return good;
}

int run(const BenchOptions& options, const std::vector<Case>& cases) {
  Report report;
  report.rounds = options.rounds;
  report.limit = options.limit;
  const std::vector<Peer> peers = chosen_peers(options.peers);
  for (const Peer& peer : peers) report.versions.push_back(peer.name + ' ' + peer.version);
  for (const std::string& version : report.versions) std::cout << version << '\n';

  bool good = true;
  for (const Case& one : cases) {
    if (one.name.find(options.only) == std::string::npos) continue;
    if (options.list) {
      std::cout << one.name << ": " << one.what << '\n';
      continue;
    }
    good = run_case(one, peers, options, report) && good;
  }
  if (std::string(kPredicates).find(options.only) != std::string::npos && !options.list) {
    report.predicates = time_predicates(options.rounds);
    std::cout << text_of(report.predicates);
  }
  if (!put(options.json, json_of(report)) || !put(options.markdown, markdown_of(report)) ||
      !put(options.plot, plot_of(report))) {
    std::cerr << "cannot write the report\n";
    return 4;
  }
  return good ? 0 : 1;
}

}  // namespace

int main(int argc, char** argv) {
  BenchOptions options;
  std::string wrong = parse(argc, argv, options);
  if (!wrong.empty()) return usage_failure(wrong, kBenchUsage);
  std::vector<Case> cases = all_cases(options.stacks);
  for (Case& one : distribution_cases(options.distributions)) cases.push_back(std::move(one));
  for (Case& one : dynamic_cases(options.dynamic)) cases.push_back(std::move(one));
  for (Case& one : plane_cases(options.dynamic)) cases.push_back(std::move(one));
  for (Case& one : periodic_cases(options.dynamic.sizes)) cases.push_back(std::move(one));
  wrong = unknown_name(options, cases);
  if (!wrong.empty()) return usage_failure(wrong, kBenchUsage);
  try {
    return run(options, cases);
  } catch (const std::exception& e) {  // a file that cannot be read
    std::cerr << "error: " << e.what() << '\n';
    return 1;
  }
}

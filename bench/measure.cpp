#include "measure.hpp"

#include <algorithm>
#include <sstream>

#include "child.hpp"

namespace tetloft::bench {

namespace {

double median_of(std::vector<double> values) {
  if (values.empty()) return 0;
  std::sort(values.begin(), values.end());
  const std::size_t n = values.size();
  return n % 2 == 1 ? values[n / 2] : 0.5 * (values[n / 2 - 1] + values[n / 2]);
}

// "seconds simplices", then "step seconds" for each; names of steps have no blanks.
std::string to_text(const Run& run) {
  std::ostringstream text;
  text.precision(12);
  text << run.seconds << ' ' << run.simplices << '\n';
  for (const auto& [name, seconds] : run.steps) text << name << ' ' << seconds << '\n';
  return text.str();
}

Run run_from(const std::string& text) {
  std::istringstream in(text);
  Run run;
  in >> run.seconds >> run.simplices;
  std::string name;
  for (double seconds = 0; in >> name >> seconds;) run.steps.emplace_back(name, seconds);
  return run;
}

std::vector<std::uint64_t*> numbers_of(PredicateCounters& counters) {
  std::vector<std::uint64_t*> all;
  for (PredicateCounters::Stages* s :
       {&counters.orient2d, &counters.orient3d, &counters.incircle, &counters.insphere}) {
    all.insert(all.end(), {&s->filter, &s->expansion, &s->integer, &s->symbolic, &s->lattice});
  }
  return all;
}

std::string counted_run(const Contestant& contestant) {
  PredicateCounters counters;
  {
    const PredicateCounting counting(counters);
    contestant.run();
  }
  std::ostringstream text;
  for (const std::uint64_t* number : numbers_of(counters)) text << *number << ' ';
  return text.str();
}

void run_once(const Contestant& contestant, double limit, Measurement& result) {
  const Child child = run_in_child([&] { return to_text(contestant.run()); }, limit);
  result.failure = child.failure;
  if (!result.failure.empty()) return;
  Run run = run_from(child.output);
  if (result.seconds.empty() || run.seconds < result.best()) result.steps = std::move(run.steps);
  result.seconds.push_back(run.seconds);
  result.simplices = run.simplices;
  result.peak_megabytes = std::max(result.peak_megabytes, child.peak_megabytes);
}

void count_stages(const Contestant& contestant, double limit, Measurement& result) {
  const Child child = run_in_child([&] { return counted_run(contestant); }, limit);
  if (!child.failure.empty()) return;
  std::istringstream in(child.output);
  for (std::uint64_t* number : numbers_of(result.counters.emplace())) in >> *number;
}

}  // namespace

double Measurement::best() const {
  return seconds.empty() ? 0 : *std::min_element(seconds.begin(), seconds.end());
}

double Measurement::median() const { return median_of(seconds); }

double median_ratio(const Measurement& a, const Measurement& b) {
  std::vector<double> ratios;
  for (std::size_t k = 0; k < std::min(a.seconds.size(), b.seconds.size()); ++k) {
    ratios.push_back(a.seconds[k] / b.seconds[k]);
  }
  return median_of(ratios);
}

std::vector<Measurement> measure(const std::vector<Contestant>& contestants, int rounds,
                                 double limit) {
  std::vector<Measurement> result(contestants.size());
  for (std::size_t i = 0; i < contestants.size(); ++i) {
    result[i].name = contestants[i].name;
    result[i].left_out = contestants[i].left_out;
    result[i].engine = contestants[i].engine;
    result[i].threads = contestants[i].threads;
  }
  const auto runs = [&](std::size_t i) {
    return result[i].left_out.empty() && result[i].failure.empty();
  };
  for (int round = 0; round < rounds; ++round) {
    for (std::size_t i = 0; i < contestants.size(); ++i) {
      if (runs(i)) run_once(contestants[i], limit, result[i]);
    }
  }
  for (std::size_t i = 0; i < contestants.size(); ++i) {
    if (runs(i) && contestants[i].counted) count_stages(contestants[i], limit, result[i]);
  }
  return result;
}

}  // namespace tetloft::bench

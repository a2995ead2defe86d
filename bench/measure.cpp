#include "measure.hpp"

#include <algorithm>
#include <exception>
#include <sstream>

#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

namespace tetloft::bench {

namespace {

double median_of(std::vector<double> values) {
  if (values.empty()) return 0;
  std::sort(values.begin(), values.end());
  const std::size_t n = values.size();
  return n % 2 == 1 ? values[n / 2] : 0.5 * (values[n / 2 - 1] + values[n / 2]);
}

struct Child {
  std::string output;
  double peak_megabytes = 0;
  bool ended_well = false;
};

// Runs `work` in a child process and returns what it returned.
Child run_in_child(const std::function<std::string()>& work) {
  int ends[2];
  if (pipe(ends) != 0) return {};
  const pid_t pid = fork();
  if (pid < 0) return {};
  if (pid == 0) {
    close(ends[0]);
    const std::string text = work();
    for (std::size_t sent = 0; sent < text.size();) {
      const ssize_t n = write(ends[1], text.data() + sent, text.size() - sent);
      if (n <= 0) _exit(1);
      sent += static_cast<std::size_t>(n);
    }
    _exit(0);
  }
  close(ends[1]);
  Child child;
  char buffer[4096];
  for (ssize_t n; (n = read(ends[0], buffer, sizeof buffer)) > 0;) {
    child.output.append(buffer, static_cast<std::size_t>(n));
  }
  close(ends[0]);
  int status = 0;
  rusage usage{};
  wait4(pid, &status, 0, &usage);
  child.peak_megabytes = static_cast<double>(usage.ru_maxrss) / 1024;
  child.ended_well = WIFEXITED(status) && WEXITSTATUS(status) == 0;
  return child;
}

// "index seconds simplices" a line; "index ! reason" for a failure.
std::string run_once(std::size_t index, const Contestant& contestant) {
  std::ostringstream line;
  line.precision(9);
  try {
    const Run run = contestant.run();
    line << index << ' ' << run.seconds << ' ' << run.simplices << '\n';
  } catch (const std::exception& e) {
    line << index << " ! " << e.what() << '\n';
  }
  return line.str();
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

std::vector<Measurement> measure(const std::vector<Contestant>& contestants, int rounds) {
  std::vector<Measurement> result(contestants.size());
  for (std::size_t i = 0; i < contestants.size(); ++i) result[i].name = contestants[i].name;
  const Child timed = run_in_child([&] {
    std::string lines;
    for (int round = 0; round < rounds; ++round) {
      for (std::size_t i = 0; i < contestants.size(); ++i) lines += run_once(i, contestants[i]);
    }
    return lines;
  });
  std::istringstream lines(timed.output);
  for (std::string line; std::getline(lines, line);) {
    std::istringstream words(line);
    std::size_t i = 0;
    std::string first;
    words >> i >> first;
    if (i >= result.size()) continue;
    if (first == "!") {
      std::getline(words >> std::ws, result[i].failure);
      continue;
    }
    result[i].seconds.push_back(std::stod(first));
    words >> result[i].simplices;
  }
  for (std::size_t i = 0; i < contestants.size(); ++i) {
    if (!timed.ended_well && result[i].failure.empty()) result[i].failure = "crashed";
    if (!result[i].failure.empty()) continue;
    result[i].peak_megabytes =
        run_in_child([&] { return run_once(i, contestants[i]); }).peak_megabytes;
  }
  return result;
}

}  // namespace tetloft::bench

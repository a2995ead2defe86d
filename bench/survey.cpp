// Survey: reconstructs and checks many stacks, and prints one table row each: sizes,
// components and genus against the truth where a .json beside the stack tells it, the
// verdict of check, overshoot, time.
//
//   tetloft_survey [options] FILE.cnt|FOLDER …
//     --split N         split every contour edge in N before reconstructing
//     --criterion C     overlap (default) or reverse
//     --threads N       threads within one reconstruction (default 1)
//     --compare N       also reconstruct with N threads and compare all bits
//     --snap BITS       snap the input first
//     --no-check        leave check out
//     --jobs N          stacks at a time (default 1)
#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <iostream>
#include <numeric>
#include <optional>
#include <sstream>
#include <string>
#include <thread>
#include <vector>

#include <tetloft/tetloft.hpp>

#include "stack_truth.hpp"
#include "words.hpp"

namespace {

using namespace tetloft;
using namespace tetloft::bench;

struct Options {
  std::vector<std::filesystem::path> files;
  std::size_t split = 1;
  ReconstructOptions reconstruct;
  std::optional<unsigned> compare;
  std::optional<int> snap;
  bool check = true;
  unsigned jobs = 1;
};

SectionStack split_edges(const SectionStack& stack, std::size_t parts) {
  SectionStack result = stack;
  for (Section& section : result.sections) {
    for (Contour& contour : section.contours) {
      std::vector<Point2> fine;
      for (std::size_t i = 0; i < contour.vertices.size(); ++i) {
        const Point2 a = contour.vertices[i];
        const Point2 b = contour.vertices[(i + 1) % contour.vertices.size()];
        for (std::size_t k = 0; k < parts; ++k) {
          const double t = static_cast<double>(k) / static_cast<double>(parts);
          fine.push_back({a.x + t * (b.x - a.x), a.y + t * (b.y - a.y)});
        }
      }
      contour.vertices = std::move(fine);
    }
  }
  return result;
}

bool same_model(const Model& a, const Model& b) {
  return a.points == b.points && a.tets == b.tets && a.component == b.component &&
         a.slab == b.slab && a.kind == b.kind && a.origin == b.origin;
}

std::string show(const std::optional<double>& value) {
  if (!value) return "–";
  std::ostringstream out;
  out << *value;
  return out.str();
}

std::string survey(const std::filesystem::path& path, const Options& options) {
  std::ostringstream row;
  row << "| " << path.stem().string() << " | ";
  Result<ReadStack> read = read_cnt(path.string());
  if (!read) {
    row << "READ: " << to_string(read.error()) << " |";
    return row.str();
  }
  SectionStack stack = split_edges(read->stack, options.split);
  if (options.snap) {
    Result<Snapped> snapped = snap(stack, *options.snap);
    if (!snapped) {
      row << "SNAP: " << to_string(snapped.error()) << " |";
      return row.str();
    }
    stack = std::move(snapped->stack);
  }
  const auto start = std::chrono::steady_clock::now();
  const Result<Reconstruction> made = reconstruct(stack, options.reconstruct);
  const double seconds =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  if (!made) {
    row << "REFUSED: " << name_of(made.error().code) << ": " << to_string(made.error()) << " |";
    return row.str();
  }
  const ReconstructReport& report = made->report;
  const StackTruth truth = read_stack_truth(path);
  row << report.input_vertices << " | " << report.tets << " | ";
  if (options.check) {
    CheckOptions check_options;
    check_options.correspondence = options.reconstruct.correspondence;
    const Result<CheckReport> checked = check(made->model, stack, check_options);
    if (!checked) {
      row << "CHECK: " << to_string(checked.error()) << " |";
      return row.str();
    }
    const long genus = std::accumulate(checked->genus.begin(), checked->genus.end(), 0L);
    const auto surfaces = static_cast<long>(checked->genus.size());
    row << checked->components << " / " << show(truth.components) << " | " << genus << " / "
        << show(truth.genus) << " | " << surfaces - static_cast<long>(checked->components) << " / "
        << show(truth.cavities) << " | ";
    if (checked->pass()) {
      row << "PASS";
    } else {
      row << "FAIL";
      for (const GuaranteeVerdict& verdict : checked->guarantees) {
        for (const CheckFailure& failure : verdict.failures) {
          row << ' ' << verdict.number << ": " << failure.what << " ×" << failure.count;
          if (!failure.places.empty()) row << " at " << failure.places.front();
          row << ';';
        }
      }
    }
    row << " | " << checked->overshoot << " | ";
  } else {
    row << report.components << " / " << show(truth.components) << " | – | – | – | – | ";
  }
  if (options.compare) {
    ReconstructOptions other = options.reconstruct;
    other.execution.threads = *options.compare;
    const Result<Reconstruction> again = reconstruct(stack, other);
    row << (again.ok() && same_model(made->model, again->model) ? "same" : "DIFFERENT") << " | ";
  }
  row << report.smallest_lift << " | " << seconds << " |";
  return row.str();
}

constexpr const char* kUsage =
    "usage: tetloft_survey FOLDER-OR-FILE… [--criterion overlap|reverse] [--threads N] [--jobs N]\n"
    "                      [--split N] [--snap BITS] [--compare THREADS] [--no-check]\n";

// What is wrong with an option, or nothing. Takes its value where it has one.
std::string take_option(const std::string& name, const std::string& value, Options& options) {
  unsigned threads = 0;
  bool good = true;
  if (name == "--split") {
    good = parse_number(value, options.split) && options.split > 0;
  } else if (name == "--criterion") {
    const bool reverse = value == "reverse";
    if (!reverse && value != "overlap") return no_such(name, value, {"overlap", "reverse"});
    options.reconstruct.correspondence.criterion =
        reverse ? Criterion::reverse : Criterion::overlap;
  } else if (name == "--threads") {
    good = parse_number(value, options.reconstruct.execution.threads);
  } else if (name == "--compare") {
    good = parse_number(value, threads);
    options.compare = threads;
  } else if (name == "--snap") {
    int bits = 0;
    good = parse_number(value, bits);
    options.snap = bits;
  } else if (name == "--jobs") {
    good = parse_number(value, options.jobs) && options.jobs > 0;
  } else {
    return "unknown option " + name;
  }
  return good ? std::string() : name + " has no value that it can take";
}

std::string parse(int argc, char** argv, Options& options) {
  options.reconstruct.execution.threads = 1;
  for (int i = 1; i < argc; ++i) {
    const std::string arg = argv[i];
    if (arg == "--no-check") {
      options.check = false;
    } else if (arg.starts_with("--")) {
      const std::string wrong = take_option(arg, i + 1 < argc ? argv[i + 1] : "", options);
      if (!wrong.empty()) return wrong;
      ++i;
    } else if (std::filesystem::is_directory(arg)) {
      for (const auto& entry : std::filesystem::directory_iterator(arg)) {
        if (entry.path().extension() == ".cnt") options.files.push_back(entry.path());
      }
    } else if (std::filesystem::exists(arg)) {
      options.files.emplace_back(arg);
    } else {
      return "there is no " + arg;
    }
  }
  if (options.files.empty()) return "no stacks (.cnt) to survey";
  std::sort(options.files.begin(), options.files.end());
  return {};
}

}  // namespace

int main(int argc, char** argv) try {
  Options options;
  const std::string wrong = parse(argc, argv, options);
  if (!wrong.empty()) return usage_failure(wrong, kUsage);
  std::cout << "| stack | vertices | tets | components got / true | genus got / true | cavities "
               "got / true | check | overshoot | "
            << (options.compare ? "threads | " : "") << "smallest lift | seconds |\n";
  std::cout << "|---|---|---|---|---|---|---|---|---|---|" << (options.compare ? "---|" : "")
            << '\n'
            << std::flush;

  // Rows are printed in order, as soon as all before them are done.
  std::vector<std::string> rows(options.files.size());
  std::vector<std::atomic<bool>> done(options.files.size());
  std::atomic<std::size_t> next{0};
  const auto work = [&] {
    for (std::size_t i = next++; i < rows.size(); i = next++) {
      rows[i] = survey(options.files[i], options);
      done[i] = true;
      done[i].notify_one();
    }
  };
  std::vector<std::thread> pool;
  for (unsigned k = 0; k < options.jobs; ++k) pool.emplace_back(work);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    done[i].wait(false);
    std::cout << rows[i] << '\n' << std::flush;
  }
  for (std::thread& t : pool) t.join();
  return 0;
} catch (const std::exception& e) {
  std::cerr << e.what() << '\n';
  return 70;
}

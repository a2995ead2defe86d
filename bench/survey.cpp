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
    other.threads = *options.compare;
    const Result<Reconstruction> again = reconstruct(stack, other);
    row << (again.ok() && same_model(made->model, again->model) ? "same" : "DIFFERENT") << " | ";
  }
  row << report.smallest_lift << " | " << seconds << " |";
  return row.str();
}

std::optional<Options> parse(int argc, char** argv) {
  Options options;
  options.reconstruct.threads = 1;
  for (int i = 1; i < argc; ++i) {
    const std::string arg = argv[i];
    const auto value = [&] { return i + 1 < argc ? std::string(argv[++i]) : std::string(); };
    if (arg == "--split") {
      options.split = std::max<std::size_t>(1, std::stoul(value()));
    } else if (arg == "--criterion") {
      options.reconstruct.correspondence.criterion =
          value() == "reverse" ? Criterion::reverse : Criterion::overlap;
    } else if (arg == "--threads") {
      options.reconstruct.threads = static_cast<unsigned>(std::stoul(value()));
    } else if (arg == "--compare") {
      options.compare = static_cast<unsigned>(std::stoul(value()));
    } else if (arg == "--snap") {
      options.snap = std::stoi(value());
    } else if (arg == "--no-check") {
      options.check = false;
    } else if (arg == "--jobs") {
      options.jobs = std::max(1U, static_cast<unsigned>(std::stoul(value())));
    } else if (std::filesystem::is_directory(arg)) {
      for (const auto& entry : std::filesystem::directory_iterator(arg)) {
        if (entry.path().extension() == ".cnt") options.files.push_back(entry.path());
      }
    } else if (arg.starts_with("--")) {
      std::cerr << "unknown option " << arg << '\n';
      return std::nullopt;
    } else {
      options.files.emplace_back(arg);
    }
  }
  std::sort(options.files.begin(), options.files.end());
  return options;
}

}  // namespace

int main(int argc, char** argv) try {
  const std::optional<Options> options = parse(argc, argv);
  if (!options) return 2;
  std::cout << "| stack | vertices | tets | components got / true | genus got / true | cavities "
               "got / true | check | overshoot | "
            << (options->compare ? "threads | " : "") << "smallest lift | seconds |\n";
  std::cout << "|---|---|---|---|---|---|---|---|---|---|" << (options->compare ? "---|" : "")
            << '\n'
            << std::flush;

  // Rows are printed in order, as soon as all before them are done.
  std::vector<std::string> rows(options->files.size());
  std::vector<std::atomic<bool>> done(options->files.size());
  std::atomic<std::size_t> next{0};
  const auto work = [&] {
    for (std::size_t i = next++; i < rows.size(); i = next++) {
      rows[i] = survey(options->files[i], *options);
      done[i] = true;
      done[i].notify_one();
    }
  };
  std::vector<std::thread> pool;
  for (unsigned k = 0; k < options->jobs; ++k) pool.emplace_back(work);
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

// tetloft_compare: methods against each other, on solids of known truth and on folders of stacks.
// See bench/comparison/README.md.
#include <algorithm>
#include <array>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <iostream>
#include <string>
#include <utility>
#include <vector>

#include <tetloft/io.hpp>

#include "comparison/methods.hpp"
#include "comparison/metrics.hpp"
#include "comparison/options.hpp"
#include "comparison/report.hpp"
#include "comparison/truth.hpp"
#include "corpus/solids.hpp"
#include "words.hpp"

namespace {

using namespace tetloft;
using namespace tetloft::bench;

constexpr const char* kUsage =
    "tetloft_compare [--solids N] [--size N] [--seed S] [--stacks FOLDER]... [--largest VERTICES]\n"
    "                [--samples N] [--between N]... [--only METHOD] [--json OUT.json] [--markdown "
    "OUT.md]\n"
    "N random solids of each kind (10) in SIZE^3 samples (96), and all .cnt below the folders "
    "with\n"
    "no more than VERTICES (60000); see bench/comparison/README.md.\n";

class Comparison {
 public:
  explicit Comparison(const CompareOptions& options) : options_(options) {}

  void run_corpus() {
    for (const SolidKind kind : kSolidKinds) {
      for (std::size_t k = 0; k < options_.solids; ++k) run_solid(kind, options_.seed + k);
    }
  }

  void run_folder(const std::filesystem::path& folder) {
    std::vector<std::filesystem::path> files;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(folder)) {
      const std::filesystem::path& path = entry.path();
      if (path.extension() == ".cnt" && path.parent_path().filename() != "invalid") {
        files.push_back(path);
      }
    }
    std::sort(files.begin(), files.end());
    for (const std::filesystem::path& file : files) run_file(file);
  }

  [[nodiscard]] const std::vector<Row>& rows() const { return rows_; }

 private:
  void run_solid(SolidKind kind, std::uint64_t seed) {
    const SampledSolid solid = sample_solid(kind, seed, options_.size);
    for (const std::size_t spacing : {2U, 6U, 12U}) {
      std::optional<Reference> reference;  // both contourings have the same sections
      for (const Contouring contouring : {Contouring::smooth, Contouring::lattice}) {
        Subject subject;
        subject.set = "corpus";
        subject.kind = name_of(kind);
        subject.spacing = spacing;
        subject.contouring = contouring == Contouring::smooth ? "smooth" : "lattice";
        subject.name = subject.kind + '-' + std::to_string(seed) + '-' + std::to_string(spacing) +
                       '-' + subject.contouring;
        SlicedSolid sliced = slice(solid, spacing, contouring);
        subject.stack = std::move(sliced.stack);
        subject.piece = std::move(sliced.piece);
        if (subject.stack.sections.size() < 2) continue;
        if (!reference) reference.emplace(truth_between_sections(solid, subject.stack));
        run(std::move(subject), *reference);
      }
    }
  }

  void run_file(const std::filesystem::path& path) {
    Result<ReadStack> read = read_cnt(path.string());
    if (!read) {
      std::cerr << path.string() << " left out: " << to_string(read.error()) << '\n';
      return;
    }
    if (read->stack.vertex_count() > options_.largest) {
      std::cerr << path.string() << " left out: " << read->stack.vertex_count() << " vertices\n";
      return;
    }
    Subject subject;
    subject.name = path.stem().string();
    subject.set = path.parent_path().filename().string();
    subject.stack = std::move(read->stack);
    run(std::move(subject), Reference(truth_beside(path)));
  }

  void run(Subject subject, const Reference& reference) {
    Row row;
    row.sections = subject.stack.sections.size();
    row.contours = subject.stack.contour_count();
    row.vertices = subject.stack.vertex_count();
    std::cerr << subject.name << ", " << row.vertices << " vertices:" << std::flush;
    for (const Method& method : methods_) {
      if (method.name.find(options_.only) == std::string::npos) continue;
      row.runs.push_back(measure_run(method, subject, reference, options_.samples));
      const Run& last = row.runs.back();
      std::cerr << ' ' << last.seconds << " s" << (last.refusal.empty() ? "" : " (refused)")
                << std::flush;
    }
    std::cerr << '\n';
    subject.stack = {};
    row.subject = std::move(subject);
    rows_.push_back(std::move(row));
  }

  const CompareOptions& options_;
  std::vector<Method> methods_ = all_methods(options_.between);
  std::vector<Row> rows_;
};

bool put(const std::string& path, const std::string& text) {
  if (path.empty()) return true;
  const Result<void> written = write_file(path, text);
  if (!written) std::cerr << to_string(written.error()) << '\n';
  return written.ok();
}

}  // namespace

int main(int argc, char** argv) try {
  CompareOptions options;
  std::string wrong = parse_options(argc, argv, options);
  std::vector<std::string> methods;
  for (const Method& method : all_methods(options.between)) methods.push_back(method.name);
  if (wrong.empty() && !any_has(methods, options.only)) {
    wrong = no_such("--only", options.only, methods);
  }
  if (!wrong.empty()) return usage_failure(wrong, kUsage);
  Comparison comparison(options);
  comparison.run_corpus();
  for (const std::filesystem::path& folder : options.folders) comparison.run_folder(folder);
  const std::vector<Table> tables = tables_of(comparison.rows());
  const std::string markdown = markdown_of(tables);
  std::cout << markdown;
  const bool written = put(options.markdown, markdown) &&
                       put(options.json, json_of(options, comparison.rows(), tables));
  return written ? 0 : 4;
} catch (const std::exception& e) {
  std::cerr << e.what() << '\n';
  return 70;
}

#include "reconstruction.hpp"

#include <cstdio>
#include <system_error>

#include <unistd.h>

#include <tetloft/tetloft.hpp>

#include "measure.hpp"
#include "value_of.hpp"

namespace tetloft::bench {

namespace {

std::filesystem::path temporary(const std::string& ending) {
  return std::filesystem::temp_directory_path() /
         ("tetloft_bench_" + std::to_string(getpid()) + ending);
}

// The steps that the library tells, CPU seconds summed over threads.
void add_steps(const ReconstructReport& report, Run& run) {
  for (std::size_t s = 0; s < report.seconds.size(); ++s) {
    run.steps.emplace_back(name_of(static_cast<Step>(s)), report.seconds[s]);
  }
}

ReconstructOptions options_of(Between between, unsigned threads) {
  ReconstructOptions options;
  if (between == Between::nothing) options.between = 0;
  options.execution.threads = threads;
  return options;
}

}  // namespace

Run reconstruct_file(const std::string& path, Between between, unsigned threads) {
  const std::string output = temporary(".vtu").string();
  const Clock clock;
  const auto input = value_of(read_cnt(path));
  Run run;
  run.steps.emplace_back("read", clock.seconds());
  const Reconstruction solid = value_of(reconstruct(input.stack, options_of(between, threads)));
  add_steps(solid.report, run);
  const Clock writing;
  const Result<void> written = write_vtu(output, solid.model);
  run.steps.emplace_back("write", writing.seconds());
  run.seconds = clock.seconds();
  std::remove(output.c_str());
  throw_if_failed(written);
  run.simplices = solid.model.tets.size();
  return run;
}

Run reconstruct_stack(const SectionStack& stack, Between between, unsigned threads) {
  const Clock clock;
  const Reconstruction solid = value_of(reconstruct(stack, options_of(between, threads)));
  Run run{clock.seconds(), solid.model.tets.size()};
  add_steps(solid.report, run);
  return run;
}

void append_vertices(const Section& section, std::vector<Point3>& points) {
  for (const Contour& contour : section.contours) {
    for (const Point2& p : contour.vertices) points.push_back({p.x, p.y, section.z});
  }
}

std::vector<std::vector<Point3>> slabs_of(const SectionStack& stack) {
  std::vector<std::vector<Point3>> slabs;
  for (std::size_t k = 0; k + 1 < stack.sections.size(); ++k) {
    std::vector<Point3>& points = slabs.emplace_back();
    append_vertices(stack.sections[SectionId(k)], points);
    append_vertices(stack.sections[SectionId(k + 1)], points);
  }
  return slabs;
}

StackFile::StackFile(const SectionStack& stack) : path_(temporary(".cnt")) {
  throw_if_failed(write_cnt(path_.string(), stack));
}

StackFile::~StackFile() {
  std::error_code ignored;
  std::filesystem::remove(path_, ignored);
}

}  // namespace tetloft::bench

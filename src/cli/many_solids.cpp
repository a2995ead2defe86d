// See many_solids.hpp.
#include "cli/many_solids.hpp"

#include <algorithm>
#include <atomic>
#include <exception>
#include <new>
#include <system_error>
#include <thread>
#include <utility>

#include "cli/label_input.hpp"
#include "cli/repaired_output.hpp"

namespace tetloft::cli {

using namespace internal;

namespace {

Result<void> make_and_write(const Arguments& arguments, const ReconstructRequest& request,
                            SolidOutcome& outcome, Console& console, std::mutex& staging) {
  const auto input = read_stack_input(request.input, request.preparation, console);
  if (!input) return input.error();
  ReconstructOptions options = request.options;
  const Result<void> labelled = read_label_option(arguments, *input, options.correspondence);
  if (!labelled) return labelled.error();
  Result<Reconstruction> result =
      std::visit([&](const auto& stack) { return reconstruct(stack, options); }, input->given);
  if (!result) return result.error();
  console.warn_of(request.input, result->warnings);
  if (request.verify) {
    if (Result<void> fine = verify(result->model, input->stack(), options); !fine) return fine;
  }
  outcome.report = result->report;
  outcome.tets = result->model.tets.size();
  outcome.vertices = result->model.points.size();
  outcome.components = result->model.component_count;
  // Whoever ends the program learns of temporaries one at a time.
  const std::scoped_lock lock(staging);
  auto files = stage_model(result->model, request.outputs, console, Tets::proven);
  if (!files) return files.error();
  const Result<void> staged =
      stage_repaired(request.outputs.repaired, input->stack(), *files, console);
  if (!staged) return staged.error();
  return io::commit_all(*files);
}

}  // namespace

SolidOutcome make_solid(const Arguments& arguments, const ReconstructRequest& request,
                        std::mutex& staging) {
  SolidOutcome outcome;
  outcome.outputs = request.outputs;
  Console console = Console::keeping();
  Result<void> made;
  try {
    made = make_and_write(arguments, request, outcome, console, staging);
  } catch (const std::bad_alloc&) {
    made = Error{ErrorCode::out_of_memory, "out of memory", {}};
  } catch (const std::exception& e) {
    made = Error{ErrorCode::internal, e.what(), {}};
  }
  if (!made) outcome.error = in_file(made.error(), request.input);
  outcome.warnings = console.warnings();
  return outcome;
}

void share_out(std::size_t n, unsigned threads,
               const std::function<bool(std::size_t i, unsigned threads)>& make,
               const std::function<void(std::size_t done, std::size_t all)>& progress) {
  if (threads == 0) threads = std::max(1U, std::thread::hardware_concurrency());
  const auto workers = static_cast<unsigned>(std::min<std::size_t>(threads, n));
  const unsigned threads_each = threads / std::max(1U, workers);
  std::atomic<std::size_t> next = 0;
  std::atomic<bool> ended = false;
  std::mutex telling;
  std::size_t done = 0;
  std::exception_ptr thrown;
  const auto work = [&] {
    try {
      for (std::size_t i = next++; i < n && !ended; i = next++) {
        if (!make(i, threads_each)) ended = true;
        const std::scoped_lock lock(telling);
        ++done;
        if (progress) progress(done, n);
      }
    } catch (...) {
      ended = true;
      const std::scoped_lock lock(telling);
      thrown = std::current_exception();
    }
  };
  {
    std::vector<std::jthread> others;
    try {
      for (unsigned w = 1; w < workers; ++w) others.emplace_back(work);
    } catch (const std::system_error&) {
      // Those that there are do all.
    }
    work();
  }
  if (thrown) std::rethrow_exception(thrown);
}

void write_counts(JsonWriter& json, const SolidOutcome& outcome) {
  json.member("slices", outcome.report.slices);
  json.member("contours", outcome.report.contours);
  json.member("vertices", outcome.vertices);
  json.member("tets", outcome.tets);
  json.member("components", outcome.components);
  json.member("volume", outcome.report.volume);
}

std::string described_counts(const SolidOutcome& outcome) {
  return counted(outcome.report.slices, "section") + ", " + counted(outcome.tets, "tet") + ", " +
         counted(outcome.components, "component") + ", volume " + readable(outcome.report.volume);
}

}  // namespace tetloft::cli

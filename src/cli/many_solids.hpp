// Many solids by one command: each of its own file or structure, several at once.
#pragma once

#include <cstddef>
#include <functional>
#include <mutex>
#include <optional>
#include <vector>

#include "cli/arguments.hpp"
#include "cli/console.hpp"
#include "cli/reconstruct_request.hpp"

namespace tetloft::cli {

/// What became of one.
struct SolidOutcome {
  std::optional<Error> error;
  std::vector<Warning> warnings;
  ModelOutputs outputs;
  ReconstructReport report;
  std::size_t tets = 0;
  std::size_t vertices = 0;
  std::size_t components = 0;
};

/// From reading to files that have appeared: the request's outputs. What is staged is told to the
/// signals one at a time, by `staging`. Throws where even the error finds no memory.
[[nodiscard]] SolidOutcome make_solid(const Arguments& arguments, const ReconstructRequest& request,
                                      std::mutex& staging);

/// Calls make(i, threads) for 0 … n − 1, started in this order, on so many threads at once as there
/// are (0: as many as the machine offers); with fewer than that to make, each has several. Ends
/// early where make() returns false, or throws: that is thrown on, once all have ended.
void share_out(std::size_t n, unsigned threads,
               const std::function<bool(std::size_t i, unsigned threads)>& make,
               const std::function<void(std::size_t done, std::size_t all)>& progress);

/// Members slices, contours, vertices, tets, components and volume.
void write_counts(JsonWriter& json, const SolidOutcome& outcome);
/// "3 sections, 12 tets, 1 component, volume 4".
[[nodiscard]] std::string described_counts(const SolidOutcome& outcome);

}  // namespace tetloft::cli

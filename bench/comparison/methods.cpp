#include "comparison/methods.hpp"

#include <chrono>
#include <cmath>
#include <utility>

#include <tetloft/geiger.hpp>
#include <tetloft/reconstruct.hpp>

#include "comparison/distance_field.hpp"
#include "comparison/marching.hpp"

namespace tetloft::bench {

namespace {

// Vertices of a model of tets are the contours' own; the search rounds.
constexpr double kTetTolerance = 1e-9;  // of the mean contour edge

// Times `make` and hands its value to `keep`.
template <class Make, class Keep>
Outcome timed(Make&& make, Keep&& keep) {
  Outcome outcome;
  const auto start = std::chrono::steady_clock::now();
  auto made = make();
  outcome.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  if (made) {
    keep(std::move(*made), outcome);
  } else {
    outcome.refusal = to_string(made.error());
  }
  return outcome;
}

struct Marched {
  TriangleMesh surface;
  double step = 0;
};

Method distance_field_method() {
  const auto run = [](const SectionStack& stack) {
    const auto make = [&]() -> Result<Marched> {
      const Result<ScalarGrid> grid = distance_field(stack);
      if (!grid) return grid.error();
      return Marched{marching_tets(*grid), grid->step};
    };
    return timed(make, [](Marched&& made, Outcome& outcome) {
      outcome.surface = std::move(made.surface);
      outcome.tolerance = made.step;
    });
  };
  return {"distance field", std::nullopt, run};
}

}  // namespace

Method tetloft_by(std::string name, const CorrespondenceOptions& correspondence,
                  std::optional<std::size_t> between) {
  const auto run = [correspondence, between](const SectionStack& stack) {
    ReconstructOptions options;
    options.correspondence = correspondence;
    options.between = between;
    options.execution.threads = 1;
    return timed([&] { return reconstruct(stack, options); },
                 [&](Reconstruction&& made, Outcome& outcome) {
                   outcome.model = std::move(made.model);
                   outcome.tolerance = kTetTolerance * mean_edge_length(stack);
                 });
  };
  return {std::move(name), correspondence, run};
}

Method geiger() {
  const auto run = [](const SectionStack& stack) {
    return timed([&] { return reconstruct_geiger(stack, {.execution = {.threads = 1}}); },
                 [&](GeigerModel&& made, Outcome& outcome) {
                   outcome.model = std::move(made.model);
                   outcome.tolerance = kTetTolerance * mean_edge_length(stack);
                 });
  };
  return {"geiger", std::nullopt, run};
}

std::vector<Method> all_methods(const std::vector<std::size_t>& between) {
  CorrespondenceOptions plain;
  plain.criterion = Criterion::overlap;
  plain.chain = plain.lone = false;
  std::vector<Method> methods{
      tetloft_by("tetloft moved", {.criterion = Criterion::moved}),
      tetloft_by("tetloft between", {.criterion = Criterion::moved}, std::nullopt),
      tetloft_by("tetloft overlap", {.criterion = Criterion::overlap}),
      tetloft_by("tetloft plain overlap", plain),
      tetloft_by("tetloft reverse", {.criterion = Criterion::reverse}),
      geiger(),
      distance_field_method()};
  for (const std::size_t count : between) {
    methods.push_back(tetloft_by("tetloft between " + std::to_string(count),
                                 {.criterion = Criterion::moved}, count));
  }
  return methods;
}

}  // namespace tetloft::bench

// Memory that ends while solids are made, checked and drawn.
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include <tetloft/tetloft.hpp>

#include "robustness/inputs.hpp"
#include "robustness/sweep.hpp"

namespace tetloft::test {
namespace {

void sweep_reconstruct(const std::string& name, const SectionStack& stack,
                       const ReconstructOptions& options) {
  sweep("reconstruct, " + name, [&] { return ended(reconstruct(stack, options)); });
}

TEST(MemoryEnds, WhileReconstructing) {
  for (const char* file : {"fork", "nested_hole", "joined_by_midpoint", "pit", "parallel_edges",
                           "two_slivers", "crossed_bars"}) {
    sweep_reconstruct(file, case_stack(file), {.execution = {.threads = 1}});
  }
}

TEST(MemoryEnds, WhileReconstructingWithOptions) {
  const SectionStack ring = case_stack("ring");
  ReconstructOptions options;
  options.execution.threads = 1;
  options.ends = Ends::half;
  options.delaunay = DelaunayEngine::incremental;
  options.execution.progress = [](std::size_t, std::size_t) {};
  sweep_reconstruct("ends half, incremental", ring, options);
  options = {.execution = {.threads = 1}};
  options.correspondence.criterion = Criterion::reverse;
  sweep_reconstruct("reverse", ring, options);
  options = {.execution = {.threads = 1}};
  options.correspondence.labels = fork_labels();
  sweep_reconstruct("labels", case_stack("fork"), options);
  options = {.execution = {.threads = 1}};
  options.correspondence.criterion = Criterion::overlap;
  sweep_reconstruct("overlap, chains", leaning_stack(), options);
  options = {.execution = {.threads = 1}};
  options.correspondence.criterion = Criterion::moved;
  options.correspondence.decisions = {{SlabId(0), ContourId(0), ContourId(0)}};
  sweep_reconstruct("moved, decisions", leaning_stack(), options);
  sweep_reconstruct("single section", single_section(), {.execution = {.threads = 1}});
}

TEST(MemoryEnds, WhileSectionsArePutBetween) {
  for (const char* file : {"fork", "ring"}) {
    const SectionStack stack = case_stack(file);
    sweep_reconstruct(std::string(file) + ", between", stack,
                      {.between = 1, .execution = {.threads = 1}});
    BetweenOptions options;
    options.sections = 1;
    options.execution.threads = 1;
    options.correspondence.decisions = {{SlabId(0), ContourId(0), ContourId(0)}};
    sweep(std::string("between, ") + file, [&] { return ended(between(stack, options)); });
  }
}

TEST(MemoryEnds, WhileReconstructingIsRefused) {
  SectionStack crossing = case_stack("fork");
  std::swap(crossing.sections[SectionId(0)].contours[ContourId(0)].vertices[0],
            crossing.sections[SectionId(0)].contours[ContourId(0)].vertices[1]);
  sweep_reconstruct("invalid stack", crossing, {.execution = {.threads = 1}});
  ReconstructOptions options{.execution = {.threads = 1}};
  options.correspondence.tau = 2;
  sweep_reconstruct("invalid options", case_stack("fork"), options);
  options = {.execution = {.threads = 1}};
  options.execution.progress = [](std::size_t, std::size_t) {
    throw std::string("not an exception");
  };
  sweep_reconstruct("callback that throws", case_stack("fork"), options);
}

TEST(MemoryEnds, OnSeveralThreads) {
  const SectionStack stack = tower(9);
  for (const unsigned threads : {2U, 4U}) {
    const std::string name = std::to_string(threads) + " threads";
    sweep_reconstruct(name, stack, {.execution = {.threads = threads}});
    sweep("geiger, " + name,
          [&] { return ended(reconstruct_geiger(stack, {.execution = {.threads = threads}})); });
    sweep("validate, " + name, [&] { return ended(validate(stack, {.threads = threads})); });
    const Model model = model_of(stack);
    CheckOptions options;
    options.execution.threads = threads;
    sweep("check, " + name, [&] { return ended(check(model, stack, options)); });
  }
}

TEST(MemoryEnds, InGeigersAlgorithm) {
  for (const char* file : {"fork", "nested_hole", "ring"}) {
    const SectionStack stack = case_stack(file);
    sweep("geiger, " + std::string(file),
          [&] { return ended(reconstruct_geiger(stack, {.execution = {.threads = 1}})); });
  }
}

TEST(MemoryEnds, WhileChecking) {
  CheckOptions options;
  options.execution.threads = 1;
  const auto sweep_check = [&](const std::string& name, const Model& model,
                               const SectionStack& stack) {
    sweep("check, " + name, [&] { return ended(check(model, stack, options)); });
  };
  const SectionStack ring = case_stack("ring");
  const SectionStack fork = case_stack("fork");
  sweep_check("ring", model_of(ring), ring);
  sweep_check("of another stack", model_of(ring), fork);
  options.correspondence.criterion = Criterion::reverse;
  sweep_check("reverse", model_of(fork), fork);
  options.correspondence = {};
  options.correspondence.labels = fork_labels();
  sweep_check("labels", model_of(fork), fork);
  options.correspondence = {};
  options.correspondence.criterion = Criterion::overlap;
  sweep_check("overlap, chains", model_of(leaning_stack()), leaning_stack());
  options.correspondence.criterion = Criterion::moved;
  options.correspondence.decisions = {{SlabId(0), ContourId(0), ContourId(0)}};
  options.recompute_motions = true;
  sweep_check("moved, decisions", model_of(leaning_stack()), leaning_stack());
}

TEST(MemoryEnds, WhileDrawing) {
  const SectionStack stack = case_stack("nested_hole");
  const Model model = model_of(stack);
  RenderOptions options;
  options.width = 60;
  options.height = 40;
  options.edges = true;
  for (const SectionStack* contours : {static_cast<const SectionStack*>(nullptr), &stack}) {
    const std::string name = contours == nullptr ? "" : ", contours";
    sweep("render_png" + name, [&] { return ended(render_png(model, contours, options)); });
    sweep("render_svg" + name, [&] { return ended(render_svg(model, contours, options)); });
    sweep("render_html" + name, [&] { return ended(render_html(model, contours, options)); });
  }
  options.cut = PictureCut{0, 0.1};
  options.colour = ColourBy::dihedral;
  sweep("render_png, cut", [&] { return ended(render_png(model, nullptr, options)); });
  options.width = 0;
  sweep("render_png, refused", [&] { return ended(render_png(model, nullptr, options)); });
}

TEST(MemoryEnds, InABoundarySurface) {
  const Model model = model_of(case_stack("ring"));
  sweep("boundary_surface",
        [&] { return ended_throwing([&] { static_cast<void>(boundary_surface(model)); }); });
  const Surface surface = boundary_surface(model);
  sweep("surface_components", [&] {
    return ended_throwing([&] { static_cast<void>(surface_components(surface.triangles)); });
  });
}

}  // namespace
}  // namespace tetloft::test

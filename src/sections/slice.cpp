// Surface meshes cut by parallel planes: heights, loops, and what makes of them a valid stack.
#include <tetloft/slice.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "core/enums.hpp"
#include "core/guard.hpp"
#include "core/option_rules.hpp"
#include "core/parallel.hpp"
#include "core/watched_work.hpp"
#include "sections/closed_mesh.hpp"
#include "sections/slice_loops.hpp"

namespace tetloft {

using namespace internal;

namespace {

using sections::ClosedMesh;
using sections::LoopSweep;

Error refusal(ErrorCode code, std::string message) { return {code, std::move(message), {}}; }

Result<void> check_slice_options(const SliceOptions& options) {
  if (options.axis < 0 || options.axis > 2) {
    return refusal(ErrorCode::usage, "the axis of planes is 0, 1 or 2");
  }
  if (!is_enumerator(options.fill, FillRule::winding)) {
    return refusal(ErrorCode::usage, "there is no such fill rule");
  }
  if (options.step.has_value() == (options.planes > 0)) {
    return refusal(ErrorCode::usage, "planes are given by their number or by a step: one of them");
  }
  if (options.planes > kMostSlicePlanes) {
    return refusal(ErrorCode::usage, std::to_string(options.planes) +
                                         " planes are more than 2^20, the most there are");
  }
  return options.step ? check_length(*options.step, "the step of planes") : Result<void>();
}

Result<void> check_mesh(const TriangleMesh& mesh) {
  if (mesh.triangles.empty()) return refusal(ErrorCode::invalid_input, "there are no triangles");
  constexpr std::size_t kMost = UINT32_MAX / 3;
  if (mesh.triangles.size() > kMost || mesh.points.size() > UINT32_MAX) {
    return refusal(ErrorCode::invalid_input, "more than 2^32 corners of triangles");
  }
  for (std::size_t v = 0; v < mesh.points.size(); ++v) {
    const Point3& p = mesh.points[v];
    for (const double c : {p.x, p.y, p.z}) {
      if (std::abs(c) < kLargestCoordinate) continue;
      Error error = refusal(ErrorCode::invalid_input,
                            "a coordinate is not finite, or its magnitude reaches 2^1000");
      error.where.vertex = v;
      return error;
    }
  }
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    for (const std::uint32_t v : mesh.triangles[t]) {
      if (v < mesh.points.size()) continue;
      return refusal(ErrorCode::invalid_input, "triangle " + std::to_string(t) +
                                                   " refers to point " + std::to_string(v) +
                                                   " of " + std::to_string(mesh.points.size()));
    }
  }
  return {};
}

// Cyclic, so that the turn is positive: the axis becomes the last one.
Frame frame_of(int axis) {
  constexpr std::array<Point3, 3> kUnits{Point3{1, 0, 0}, Point3{0, 1, 0}, Point3{0, 0, 1}};
  const auto unit = [&](int i) { return kUnits[static_cast<std::size_t>(i % 3)]; };
  return {{unit(axis + 1), unit(axis + 2), unit(axis)}, {}};
}

Point3 turned(const Point3& p, int axis) {
  if (axis == 0) return {p.y, p.z, p.x};
  return axis == 1 ? Point3{p.z, p.x, p.y} : p;
}

Result<std::vector<double>> heights_of(double low, double high, const SliceOptions& options) {
  if (!(low < high)) {
    return refusal(ErrorCode::invalid_input, "the mesh has no extent along this axis");
  }
  std::vector<double> heights;
  const double extent = high - low;
  const auto planes = static_cast<double>(options.planes);
  for (std::size_t k = 0; options.step || k < options.planes; ++k) {
    const double middle = static_cast<double>(k) + 0.5;
    const double z = low + (options.step ? middle * *options.step : middle * extent / planes);
    if (options.step && !(z < high)) break;
    if (heights.size() == kMostSlicePlanes) {
      return refusal(ErrorCode::usage, "the step gives more than 2^20 planes, the most there are");
    }
    if (!(z > (heights.empty() ? low : heights.back()) && z <= high)) {
      return refusal(
          ErrorCode::invalid_input,
          "the planes are nearer together than doubles are: move the mesh to the origin");
    }
    heights.push_back(z);
  }
  if (!heights.empty()) return heights;
  return refusal(ErrorCode::usage,
                 "no plane crosses the mesh: half of the step is more than its extent");
}

// Loops of all planes, unchecked.
SectionStack stack_of(LoopSweep& sweep, const std::vector<double>& heights,
                      std::vector<Warning>& warnings, WatchedWork& work) {
  SectionStack stack;
  for (std::size_t k = 0; k < heights.size(); ++k) {
    work.go_on();
    LoopSweep::Loops loops = sweep.next();
    if (loops.without_area > 0) {
      Warning warning{"left out: " + std::to_string(loops.without_area) +
                          (loops.without_area == 1 ? " loop" : " loops") + " without area",
                      {}};
      warning.where.section = k;
      warnings.push_back(std::move(warning));
    }
    stack.sections.push_back({heights[k], IdVector<ContourId, Contour>(std::move(loops.contours))});
    work.step_done();
  }
  return stack;
}

Result<void> make_valid(Sliced& sliced, const SliceOptions& options, const Execution& execution) {
  const Result<void> valid = validate(sliced.stack, untold(execution));
  if (accepted(valid) && options.fill == FillRule::odd) return {};
  if (sliced.stack.contour_count() == 0) {
    return refusal(ErrorCode::invalid_input, "no plane meets the inside of the mesh");
  }
  RepairOptions repairing;
  repairing.fill = options.fill;
  repairing.execution = untold(execution);
  Result<Repaired> repaired = repair(sliced.stack, repairing);
  if (!repaired) return repaired.error();
  if (!valid) {
    Warning warning{"loops of the mesh touch or cross, and were repaired: " + valid.error().message,
                    valid.error().where};
    sliced.warnings.push_back(std::move(warning));
  }
  sliced.repaired = repaired->changes.size();
  for (Warning& change : repaired->changes) sliced.warnings.push_back(std::move(change));
  sliced.stack = std::move(repaired->stack);
  if (sliced.stack.contour_count() > 0) return {};
  return refusal(ErrorCode::invalid_input,
                 "the loops of the mesh cancel each other: nothing is left");
}

Result<Sliced> slice_all(const TriangleMesh& given, const SliceOptions& options,
                         const Execution& execution) {
  if (Result<void> good = check_slice_options(options); !good) return good.error();
  if (Result<void> good = check_mesh(given); !good) return good.error();
  std::vector<Point3> points;
  points.reserve(given.points.size());
  for (const Point3& p : given.points) points.push_back(turned(p, options.axis));
  Result<ClosedMesh> mesh =
      sections::close_mesh(std::move(points), given.triangles, frame_of(options.axis));
  if (!mesh) return mesh.error();
  if (mesh->triangles.empty()) {
    return refusal(ErrorCode::invalid_input,
                   "the triangles bound nothing: all stand both ways "
                   "round, or have equal corners");
  }
  const Result<std::vector<double>> heights =
      heights_of(mesh->points.front().z, mesh->points.back().z, options);
  if (!heights) return heights.error();
  LoopSweep sweep(*mesh, *heights);
  if (sweep.crossings() > kMostSliceCrossings) {
    return refusal(ErrorCode::invalid_input, "the planes cross triangles " +
                                                 std::to_string(sweep.crossings()) +
                                                 " times, more than 2^28: take fewer planes");
  }
  WatchedWork work(execution, heights->size());
  Sliced sliced;
  sliced.warnings = std::move(mesh->warnings);
  sliced.vertices = mesh->points.size();
  sliced.triangles = mesh->triangles.size();
  sliced.stack = stack_of(sweep, *heights, sliced.warnings, work);
  if (Result<void> good = make_valid(sliced, options, execution); !good) return good.error();
  sliced.stack.frame = frame_of(options.axis);
  return sliced;
}

}  // namespace

Result<Sliced> slice(const TriangleMesh& mesh, const SliceOptions& given) {
  return guard_threads(given.execution, [&](const Execution& execution) {
    return slice_all(mesh, given, execution);
  });
}

}  // namespace tetloft

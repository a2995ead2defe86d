#include "comparison/metrics.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <utility>

#include <tetloft/check.hpp>
#include <tetloft/tet_mesh.hpp>

#include "comparison/section_cut.hpp"

namespace tetloft::bench {

namespace {

constexpr std::uint64_t kSampleSeed = 1;

// An edge that is singular has singular ends: its link is part of theirs.
std::size_t count_singular_edges(const TetMesh& mesh,
                                 const std::vector<std::pair<VertexId, LinkKind>>& vertices) {
  std::vector<bool> singular(mesh.vertex_count(), false);
  for (const auto& [v, kind] : vertices) singular[v.index()] = true;
  std::vector<std::pair<VertexId, VertexId>> edges;
  for (const auto& [v, kind] : vertices) {
    for (const TetId t : mesh.star(v)) {
      for (const VertexId w : mesh.vertices(t)) {
        if (v < w && singular[w.index()]) edges.emplace_back(v, w);
      }
    }
  }
  std::sort(edges.begin(), edges.end());
  edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
  return static_cast<std::size_t>(std::count_if(edges.begin(), edges.end(), [&](const auto& e) {
    return !is_regular(mesh.classify_link(e.first, e.second));
  }));
}

// Fills in what a model of tets has beside its surface, and returns that.
TriangleMesh measure_tets(const Model& model, const Method& method, const SectionStack& stack,
                          Run& run) {
  CheckOptions options;
  if (method.correspondence) options.correspondence = *method.correspondence;
  const CheckReport checked = check(model, stack, options).value();
  std::array<bool, 5> verdicts{};
  for (const GuaranteeVerdict& verdict : checked.guarantees) {
    verdicts[static_cast<std::size_t>(verdict.number - 1)] = verdict.pass;
  }
  run.guarantees = verdicts;
  run.valid = verdicts[0] && verdicts[1] && verdicts[2];
  if (method.correspondence) {
    run.valid = *run.valid && verdicts[3] && verdicts[4];
    run.exceptions =
        static_cast<long>(checked.deviations + checked.forced_voids + checked.unrealisable_voids);
  }
  const TetMesh mesh = TetMesh::from_tets(model.points.size(), model.tets.raw()).value();
  const auto vertices = mesh.singular_vertices();
  run.singular_vertices = vertices.size();
  run.singular_edges = count_singular_edges(mesh, vertices);
  return boundary_of(mesh, model.points);
}

void compare_with(const Reference& reference, const TriangleMesh& surface,
                  const SurfaceSearch& search, const SectionStack& stack, std::size_t samples,
                  Run& run) {
  const auto error = [](long got, const std::optional<long>& want) -> std::optional<long> {
    if (!want) return std::nullopt;
    return std::labs(got - *want);
  };
  const Truth& truth = reference.truth;
  run.component_error = error(run.topology.components, truth.components);
  run.cavity_error = error(run.topology.cavities, truth.cavities);
  run.genus_error = error(run.topology.genus, truth.genus);
  if (truth.volume && *truth.volume > 0) {
    run.volume_error = std::abs(run.volume - *truth.volume) / *truth.volume;
  }
  if (!reference.search) return;
  const double low = stack.sections[SectionId(0)].z;
  const double high = stack.sections[SectionId(stack.sections.size() - 1)].z;
  const auto ours = sample_surface(surface, low, high, samples, kSampleSeed);
  const auto true_ones = sample_surface(*truth.surface, low, high, samples, kSampleSeed);
  run.distance = surface_distance({search, ours}, {*reference.search, true_ones});
}

// The mean of what is known; nothing if nothing is.
class Mean {
 public:
  void add(const std::optional<double>& value) {
    if (!value) return;
    sum_ += *value;
    ++count_;
  }
  [[nodiscard]] std::optional<double> value() const {
    if (count_ == 0) return std::nullopt;
    return sum_ / static_cast<double>(count_);
  }

 private:
  double sum_ = 0;
  std::size_t count_ = 0;
};

// 1 if all that is known of the topology is met, else 0.
std::optional<double> topology_is_right(const Run& run) {
  if (!run.component_error && !run.cavity_error && !run.genus_error) return std::nullopt;
  const long errors =
      run.component_error.value_or(0) + run.cavity_error.value_or(0) + run.genus_error.value_or(0);
  return errors == 0 ? 1 : 0;
}

void add(std::optional<long>& sum, const std::optional<long>& value) {
  if (value) sum = sum.value_or(0) + *value;
}

}  // namespace

Reference::Reference(Truth known) : truth(std::move(known)) {
  if (truth.surface) search.emplace(*truth.surface);
}

Run measure_run(const Method& method, const Subject& subject, const Reference& reference,
                std::size_t samples) {
  Outcome outcome = method.run(subject.stack);
  Run run;
  run.method = method.name;
  run.refusal = outcome.refusal;
  run.seconds = outcome.seconds;
  if (!run.refusal.empty()) return run;
  TriangleMesh surface = std::move(outcome.surface);
  if (outcome.model) {
    if (method.correspondence && !subject.piece.empty()) {
      run.links = union_errors(subject.stack, outcome.model->links, subject.piece);
    }
    run.tets = outcome.model->tets.size();
    surface = measure_tets(*outcome.model, method, subject.stack, run);
  } else {
    const SurfaceFaults faults = faults_of(surface);
    run.singular_vertices = faults.vertices;
    run.singular_edges = faults.edges;
  }
  const SurfaceSearch search(surface);
  run.deviation = section_deviation(surface, subject.stack);
  run.lost = lost_contours(search, subject.stack, outcome.tolerance);
  run.topology = topology_of(surface);
  run.volume = enclosed_volume(surface);
  compare_with(reference, surface, search, subject.stack, samples, run);
  return run;
}

Aggregate aggregate(const std::vector<SizedRun>& runs) {
  Aggregate result;
  Mean deviation, topology, volume, distance, hausdorff;
  std::size_t judged = 0, valid = 0, resampled = 0, asked = 0, defined = 0, vertices = 0;
  double seconds = 0;
  for (const SizedRun& sized : runs) {
    const Run& run = *sized.run;
    ++result.stacks;
    if (!run.refusal.empty()) {
      ++result.refused;
      continue;
    }
    if (run.guarantees) {
      ++judged;
      valid += *run.valid ? 1U : 0U;
      resampled += (*run.guarantees)[1] ? 1U : 0U;
    }
    if (run.exceptions) {
      ++asked;
      defined += (*run.guarantees)[4] ? 1U : 0U;
    }
    add(result.exceptions, run.exceptions);
    result.singular_vertices += run.singular_vertices;
    result.singular_edges += run.singular_edges;
    result.lost += run.lost;
    if (run.links) {
      if (!result.links) result.links.emplace();
      *result.links += *run.links;
    }
    add(result.component_errors, run.component_error);
    add(result.cavity_errors, run.cavity_error);
    add(result.genus_errors, run.genus_error);
    deviation.add(run.deviation);
    topology.add(topology_is_right(run));
    volume.add(run.volume_error);
    if (run.distance) {
      distance.add(run.distance->mean);
      hausdorff.add(run.distance->hausdorff);
    }
    seconds += run.seconds;
    result.tets += run.tets;
    vertices += sized.vertices;
  }
  const auto share = [&](std::size_t count) {
    return static_cast<double>(count) / static_cast<double>(result.stacks);
  };
  if (judged > 0) {
    result.valid = share(valid);
    result.resampled = share(resampled);
  }
  if (asked > 0) result.defined = share(defined);
  result.deviation = deviation.value().value_or(0);
  result.right_topology = topology.value();
  result.volume_error = volume.value();
  result.mean_distance = distance.value();
  result.hausdorff = hausdorff.value();
  if (vertices > 0) result.seconds_per_10k = 1e4 * seconds / static_cast<double>(vertices);
  return result;
}

}  // namespace tetloft::bench

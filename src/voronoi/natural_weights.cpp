#include "voronoi/natural_weights.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

#include "core/enums.hpp"
#include "core/vector.hpp"
#include "voronoi/cut_polyhedron.hpp"
#include "voronoi/moderate.hpp"

namespace tetloft::internal::voronoi {

void Surroundings::put_offsets_from(const Point3& p) {
  using namespace vectors;
  double largest = 0;
  for (const Point3& q : points) {
    offsets.push_back(q - p);
    const Point3& r = offsets.back();
    largest = std::max({largest, std::abs(r.x), std::abs(r.y), std::abs(r.z)});
  }
  exponent = std::ilogb(largest);
  for (Point3& r : offsets) r = times_power_of_two(r, -exponent);
}

std::vector<double> weights_between(const Surroundings& ends) {
  return {nearer_to_origin(ends.offsets[1]).offset, nearer_to_origin(ends.offsets[0]).offset};
}

NaturalNeighbours of_sum_one(const Surroundings& around, std::vector<double> weights) {
  double sum = 0;
  for (const double w : weights) sum += w;
  if (!(sum > 0 && std::isfinite(sum))) {
    const auto nearest = std::min_element(
        around.offsets.begin(), around.offsets.end(),
        [](const Point3& a, const Point3& b) { return vectors::dot(a, a) < vectors::dot(b, b); });
    weights.assign(around.offsets.size(), 0);
    weights[static_cast<std::size_t>(nearest - around.offsets.begin())] = sum = 1;
  }
  for (double& w : weights) w /= sum;
  return {around.vertices, std::move(weights)};
}

Error refused_at(const char* why, const Point3& p) {
  Error error{ErrorCode::invalid_input, why, {}};
  error.where.point = p;
  return error;
}

Result<void> check_weights(NaturalWeights weights) {
  if (is_enumerator(weights, NaturalWeights::laplace)) return {};
  return Error{ErrorCode::usage, "there are no such weights of natural neighbours", {}};
}

Result<void> check_asked(const Point3& p) {
  if (is_moderate(p)) return {};
  return refused_at("a coordinate is not finite, or beyond 2^300", p);
}

Result<void> check_neighbours(const Surroundings& around) {
  for (const Point3& p : around.points) {
    if (!is_moderate(p)) return refused_at("a neighbour's coordinate is beyond 2^300", p);
  }
  return {};
}

}  // namespace tetloft::internal::voronoi

#include "model/volume.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include <tetloft/frame.hpp>

#include "core/parallel.hpp"
#include "core/unit_of_length.hpp"
#include "model/well_formed.hpp"

namespace tetloft {

using namespace internal;

namespace {

// Of the points that tets use.
int exponent_to_one(const Model& model) {
  IdVector<VertexId, std::uint8_t> used(model.points.size(), 0);
  for (const TetVertices& tet : model.tets) {
    if (!is_sound(model, tet)) continue;
    for (const VertexId v : tet) used[v] = 1;
  }
  UnitOfLength unit;
  for (const VertexId v : used.ids()) {
    if (used[v] != 0) unit.include(model.points[v]);
  }
  return unit.largest_to_one();
}

}  // namespace

double internal::scaled_volume(const std::array<Point3, 4>& corners, int exponent) {
  const Point3 d = scaled(corners[3], exponent);
  const auto from_d = [&](std::size_t i) {
    const Point3 p = scaled(corners[i], exponent);
    return Point3{p.x - d.x, p.y - d.y, p.z - d.z};
  };
  const Point3 a = from_d(0);
  const Point3 b = from_d(1);
  const Point3 c = from_d(2);
  // a · (b × c) is minus the orientation determinant of (a, b, c, d).
  return -(a.x * (b.y * c.z - b.z * c.y) + a.y * (b.z * c.x - b.x * c.z) +
           a.z * (b.x * c.y - b.y * c.x)) /
         6;
}

double internal::volume_of(const Model& model, unsigned threads) {
  constexpr std::size_t kTets = std::size_t{1} << 14;  // of a step: far more work than to start it
  const int exponent = exponent_to_one(model);
  const auto& tets = model.tets.raw();
  std::vector<double> terms(tets.size(), 0);
  parallel_for((tets.size() + kTets - 1) / kTets, threads, [&](std::size_t step) {
    const std::size_t end = std::min(tets.size(), (step + 1) * kTets);
    for (std::size_t t = step * kTets; t < end; ++t) {
      if (!is_sound(model, tets[t])) continue;
      const auto& [p, q, r, u] = tets[t];
      terms[t] = scaled_volume({model.points[p], model.points[q], model.points[r], model.points[u]},
                               exponent);
    }
  });
  CompensatedSum sum;
  for (const double term : terms) sum.add(term);
  return std::ldexp(sum.value(), -3 * exponent) * volume_factor(model.frame);
}

double volume(const Model& model) { return volume_of(model, 1); }

}  // namespace tetloft

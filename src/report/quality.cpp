#include "report/quality.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>

#include <tetloft/tet_mesh.hpp>

#include "check/dihedral.hpp"
#include "core/sort_distinct.hpp"
#include "render/vector.hpp"

namespace tetloft::internal::report {

namespace {

using render::dot;
using render::operator-;

constexpr std::size_t kAngleBins = 36;
constexpr std::size_t kLengthBins = 40;

std::vector<std::uint64_t> distinct_edges(const std::vector<TetVertices>& tets) {
  std::vector<std::uint64_t> edges;
  edges.reserve(6 * tets.size());
  for (const TetVertices& tet : tets) {
    for (const auto& [i, j] : kEdgeVertex) {
      edges.push_back(edge_key(tet[static_cast<std::size_t>(i)], tet[static_cast<std::size_t>(j)]));
    }
  }
  sort_distinct(edges);
  return edges;
}

double mean_ratio(const std::array<Point3, 4>& p) {
  const double volume = tet_volume(p);
  double squares = 0;
  for (const auto& [i, j] : kEdgeVertex) {
    const Point3 d = p[static_cast<std::size_t>(j)] - p[static_cast<std::size_t>(i)];
    squares += dot(d, d);
  }
  if (!(volume > 0)) return 0;
  const double root = std::cbrt(3 * volume);
  return 12 * root * root / squares;
}

void measure_tets(const Subject& subject, const MeasuringPoints& points, ReportQuality& quality) {
  const auto& tets = subject.view.tets;
  std::vector<double> all, smallest, ratio;
  all.reserve(6 * tets.size());
  smallest.reserve(tets.size());
  ratio.reserve(tets.size());
  for (const TetVertices& tet : tets) {
    const std::array<Point3, 4> p = points.corners(tet);
    const std::array<double, 6> angles = checking::dihedral_degrees(p);
    all.insert(all.end(), angles.begin(), angles.end());
    smallest.push_back(*std::min_element(angles.begin(), angles.end()));
    ratio.push_back(mean_ratio(p));
  }
  quality.dihedrals = linear_histogram(all, 0, 180, kAngleBins);
  quality.dihedral = spread_of(all);
  quality.smallest_dihedral = spread_of(smallest);
  quality.mean_ratio = spread_of(ratio);
}

void measure_edges(const Subject& subject, const MeasuringPoints& points, ReportQuality& quality) {
  std::vector<double> lengths;
  for (const std::uint64_t edge : distinct_edges(subject.view.tets)) {
    const Point3 d = points[VertexId(edge & 0xFFFFFFFFU)] - points[VertexId(edge >> 32)];
    lengths.push_back(points.back(std::sqrt(dot(d, d)), 1));
  }
  quality.edges = lengths.size();
  quality.edge_lengths = logarithmic_histogram(lengths, kLengthBins);
  quality.edge_length = spread_of(lengths);
}

// Values beyond the edges count in the bins at the ends.
void count_values(const std::vector<double>& values, ReportHistogram& histogram) {
  const std::vector<double>& edges = histogram.edges;
  histogram.counts.assign(edges.size() - 1, 0);
  for (const double value : values) {
    const auto after = std::upper_bound(edges.begin(), edges.end(), value) - edges.begin();
    const auto bin = static_cast<std::size_t>(std::max<std::ptrdiff_t>(1, after)) - 1;
    ++histogram.counts[std::min(bin, histogram.counts.size() - 1)];
  }
}

}  // namespace

ReportHistogram linear_histogram(const std::vector<double>& values, double low, double high,
                                 std::size_t bins) {
  ReportHistogram histogram;
  for (std::size_t k = 0; k <= bins; ++k) {
    const double part = static_cast<double>(k) / static_cast<double>(bins);
    histogram.edges.push_back(low + part * (high - low));
  }
  count_values(values, histogram);
  return histogram;
}

ReportHistogram logarithmic_histogram(const std::vector<double>& values, std::size_t bins) {
  double least = std::numeric_limits<double>::infinity();
  double most = 0;
  for (const double value : values) {
    if (!(value > 0) || !std::isfinite(value)) continue;
    least = std::min(least, value);
    most = std::max(most, value);
  }
  if (!(least <= most)) return {};
  // Nearly equal values would be told apart by rounding alone.
  constexpr double kSame = 1e-9;
  const double range = std::log(most) - std::log(least);
  if (range < kSame) return {{least / 1.1, most * 1.1}, {values.size()}};
  ReportHistogram histogram;
  for (std::size_t k = 0; k <= bins; ++k) {
    const double part = static_cast<double>(k) / static_cast<double>(bins);
    histogram.edges.push_back(std::exp(std::log(least) + part * range));
  }
  histogram.edges.front() = least;
  histogram.edges.back() = most;
  count_values(values, histogram);
  return histogram;
}

ReportSpread spread_of(std::vector<double>& values) {
  // Of points that the frame throws beyond the largest double.
  std::erase_if(values, [](double value) { return std::isnan(value); });
  if (values.empty()) return {};
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>((values.size() - 1) / 2);
  std::nth_element(values.begin(), middle, values.end());
  const auto [least, most] = std::minmax_element(values.begin(), values.end());
  return {*least, *middle, *most};
}

ReportQuality quality_of(const Subject& subject, const MeasuringPoints& points) {
  ReportQuality quality;
  measure_tets(subject, points, quality);
  measure_edges(subject, points, quality);
  return quality;
}

}  // namespace tetloft::internal::report

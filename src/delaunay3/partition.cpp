// See partition.hpp.
#include "delaunay3/partition.hpp"

#include <algorithm>
#include <array>

namespace tetloft::internal::delaunay3_detail {

namespace {

constexpr std::array<double Point3::*, 3> kAxes{&Point3::x, &Point3::y, &Point3::z};

// Points on fewer planes than this across an axis are not cut across it, as tets between two of
// the planes would all be in both parts.
constexpr std::size_t kFewPlanes = 8;
// Points of the sample that one cut is found by.
constexpr std::size_t kMostOfSample = 1024;
// Of these, the share on each side of a cut by which sparse it is there.
constexpr std::size_t kBandsOfSample = 32;

// Some points, by their coordinates along one axis, sorted.
struct Profile {
  std::uint32_t axis = 3;  // 3: along none are there enough planes
  double extent = 0;
  std::vector<double> values;
};

// Along the axis of largest extent, of those with enough planes across.
Profile longest(std::span<const Point3> points) {
  Profile profile;
  const std::size_t count = std::min(points.size(), kMostOfSample);
  std::vector<double> values(count);
  for (std::uint32_t axis = 0; axis < 3; ++axis) {
    for (std::size_t i = 0; i < count; ++i) {
      values[i] = points[i * points.size() / count].*kAxes[axis];
    }
    std::sort(values.begin(), values.end());
    std::size_t planes = 1;
    for (std::size_t i = 1; i < count; ++i) planes += values[i] != values[i - 1] ? 1U : 0U;
    if (count == 0 || planes < kFewPlanes) continue;
    // Halved, so that it does not overflow.
    const double extent = 0.5 * values.back() - 0.5 * values.front();
    if (extent > profile.extent) profile = {axis, extent, values};
  }
  return profile;
}

// The one of the values from `first` to `last` whose neighbourhood extends furthest; of several the
// first.
double sparsest(std::span<const double> values, std::size_t first, std::size_t last) {
  const std::size_t band = values.size() / kBandsOfSample;
  std::size_t best = first;
  double widest = -1;
  for (std::size_t i = first; i <= last; ++i) {
    const std::size_t low = i - std::min(i, band);
    const std::size_t high = std::min(i + band, values.size() - 1);
    const double width = 0.5 * values[high] - 0.5 * values[low];
    if (width > widest) {
      best = i;
      widest = width;
    }
  }
  return values[best];
}

}  // namespace

Partition::Partition(std::span<Point3> sample, std::size_t parts, Cuts cuts) : nodes_(1) {
  divide(0, sample, parts, cuts);
}

// Recursive as deep as the logarithm of the parts.
void Partition::divide(std::size_t node, std::span<Point3> sample, std::size_t parts, Cuts cuts) {
  const Profile profile = parts > 1 ? longest(sample) : Profile{};
  if (profile.axis == 3) {
    nodes_[node].child = static_cast<std::uint32_t>(parts_++);
    return;
  }
  const std::size_t below = parts / 2;
  const std::size_t count = profile.values.size();
  const std::size_t middle = count * below / parts;
  const double cut = cuts == Cuts::even
                         ? profile.values[middle]
                         : sparsest(profile.values, middle / 2, (count + middle) / 2);
  const auto coordinate = kAxes[profile.axis];
  const auto above = std::partition(sample.begin(), sample.end(),
                                    [&](const Point3& p) { return p.*coordinate < cut; });
  const auto at = static_cast<std::size_t>(above - sample.begin());
  const std::size_t child = nodes_.size();
  nodes_[node] = {profile.axis, static_cast<std::uint32_t>(child), cut};
  nodes_.resize(child + 2);
  divide(child, sample.first(at), below, cuts);
  divide(child + 1, sample.subspan(at), parts - below, cuts);
}

}  // namespace tetloft::internal::delaunay3_detail

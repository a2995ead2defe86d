// A triangle that a plane crosses has two half-edges crossed, and each is paired with one of
// another triangle that is crossed as well: so the triangles form rings.
#include "sections/slice_loops.hpp"

#include <algorithm>
#include <iterator>
#include <utility>

#include "core/guard.hpp"
#include "sections/edge_crossing.hpp"

namespace tetloft::internal::sections {

namespace {

// The planes that cross a triangle: above its lowest corner, not above its highest one.
std::pair<std::size_t, std::size_t> planes_of(const ClosedMesh& mesh,
                                              const std::array<std::uint32_t, 3>& triangle,
                                              const std::vector<double>& heights) {
  // Points are numbered by height.
  const auto [low, high] = std::minmax_element(triangle.begin(), triangle.end());
  const auto beyond = [&](std::uint32_t v) {
    return static_cast<std::size_t>(
        std::upper_bound(heights.begin(), heights.end(), mesh.points[v].z) - heights.begin());
  };
  return {beyond(*low), beyond(*high)};
}

}  // namespace

LoopSweep::LoopSweep(const ClosedMesh& mesh, const std::vector<double>& heights)
    : mesh_(mesh),
      heights_(heights),
      begin_(heights.size() + 1, 0),
      seen_(mesh.triangles.size(), 0) {
  std::vector<std::size_t> first;
  first.reserve(mesh.triangles.size());
  for (const auto& triangle : mesh.triangles) {
    const auto [from, to] = planes_of(mesh, triangle, heights);
    crossings_ += to - from;
    first.push_back(from < to ? from : heights.size());
    if (from < to) ++begin_[from + 1];
  }
  for (std::size_t k = 0; k < heights.size(); ++k) begin_[k + 1] += begin_[k];
  starting_.resize(begin_.back());
  std::vector<std::size_t> end(begin_.begin(), begin_.end() - 1);
  for (std::uint32_t t = 0; t < first.size(); ++t) {
    if (first[t] < heights.size()) starting_[end[first[t]]++] = t;
  }
}

std::uint32_t LoopSweep::crossed(std::uint32_t triangle, bool upwards) const {
  for (std::uint32_t h = 3 * triangle; h < 3 * triangle + 3; ++h) {
    if (climbs(h, upwards)) return h;
  }
  fail_check("a triangle on a loop is crossed twice", __FILE__, __LINE__);
}

Contour LoopSweep::follow(std::uint32_t first) {
  Contour contour;
  const auto stamp = static_cast<std::uint32_t>(plane_ + 1);
  const std::uint32_t start = crossed(first, false);
  std::uint32_t entry = start;
  do {
    const std::uint32_t triangle = entry / 3;
    seen_[triangle] = stamp;
    const std::uint32_t low = std::min(mesh_.from(entry), mesh_.to(entry));
    const std::uint32_t high = std::max(mesh_.from(entry), mesh_.to(entry));
    const Point2 p = crossing_at(mesh_.points[low], mesh_.points[high], heights_[plane_]);
    if (contour.vertices.empty() || contour.vertices.back() != p) contour.vertices.push_back(p);
    entry = mesh_.mate[crossed(triangle, climbs(entry, false))];
  } while (entry != start);
  while (contour.vertices.size() > 1 && contour.vertices.back() == contour.vertices.front()) {
    contour.vertices.pop_back();
  }
  return contour;
}

LoopSweep::Loops LoopSweep::next() {
  const auto from = starting_.begin() + static_cast<std::ptrdiff_t>(begin_[plane_]);
  const auto to = starting_.begin() + static_cast<std::ptrdiff_t>(begin_[plane_ + 1]);
  const double z = heights_[plane_];
  std::vector<std::uint32_t> active;
  std::merge(active_.begin(), active_.end(), from, to, std::back_inserter(active));
  active_.clear();
  Loops loops;
  for (const std::uint32_t t : active) {
    const auto& corners = mesh_.triangles[t];
    if (mesh_.points[*std::max_element(corners.begin(), corners.end())].z < z) continue;
    active_.push_back(t);
    if (seen_[t] == plane_ + 1) continue;
    Contour contour = follow(t);
    if (contour.vertices.size() > 2 && area_sign(contour) != Sign::zero) {
      loops.contours.push_back(std::move(contour));
    } else {
      ++loops.without_area;
    }
  }
  ++plane_;
  return loops;
}

}  // namespace tetloft::internal::sections

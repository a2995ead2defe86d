#include "voronoi/cut_polyhedron.hpp"

#include <algorithm>
#include <bit>
#include <cmath>

#include "core/guard.hpp"
#include "core/vector.hpp"
#include "voronoi/moderate.hpp"
#include "voronoi/polygon_area.hpp"

namespace tetloft::internal::voronoi {

using namespace vectors;

namespace {

// By correctly rounded steps alone, without overflow or underflow.
double length_of(const Point3& p) {
  const double square = dot(p, p);
  if (square > 0x1p-900 && square < 0x1p900) return std::sqrt(square);
  const double largest = std::max({std::abs(p.x), std::abs(p.y), std::abs(p.z)});
  if (largest == 0 || !std::isfinite(largest)) return largest;  // as of planes that are parallel
  const int exponent = std::ilogb(largest);
  const Point3 scaled = times_power_of_two(p, -exponent);
  return std::ldexp(std::sqrt(dot(scaled, scaled)), exponent);
}

Point3 divided(const Point3& p, double by) { return {p.x / by, p.y / by, p.z / by}; }

}  // namespace

HalfSpace nearer_to_origin(const Point3& p) {
  const double length = length_of(p);
  return {divided(p, length), 0.5 * length};
}

HalfSpace nearer_to_first(const Point3& a, const Point3& b, const Point3& difference) {
  const Point3 normal = divided(difference, length_of(difference));
  return {normal, 0.5 * (dot(normal, a) + dot(normal, b))};
}

void CutPolyhedron::start_again(const Point3& low, const Point3& high) {
  corner_count_ = 8;
  corners_.clear();
  free_.clear();
  for (std::uint32_t i = 0; i < 8; ++i) {
    Corner corner;
    corner.point = {(i & 1) != 0 ? high.x : low.x, (i & 2) != 0 ? high.y : low.y,
                    (i & 4) != 0 ? high.z : low.z};
    corner.spread = length_of(corner.point);
    // At the highest corner x, y, z turn counter-clockwise; each reflection turns them round.
    std::array<std::uint32_t, 3> axes{0, 1, 2};
    if (std::popcount(i) % 2 == 0) std::swap(axes[1], axes[2]);
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t normal = axes[(k + 2) % 3];
      corner.next[k] = i ^ (1U << axes[k]);
      corner.face[k] = 2 * normal + ((i >> normal) & 1U);
    }
    corners_.push_back(corner);
  }
  part_.assign(8, Part::unknown);
  planes_ = {{{-1, 0, 0}, -low.x}, {{1, 0, 0}, high.x},  {{0, -1, 0}, -low.y},
             {{0, 1, 0}, high.y},  {{0, 0, -1}, -low.z}, {{0, 0, 1}, high.z}};
}

std::uint32_t CutPolyhedron::edge_to(std::uint32_t from, std::uint32_t to) const {
  const std::array<std::uint32_t, 3>& next = corners_[from].next;
  return next[0] == to ? 0U : next[1] == to ? 1U : 2U;
}

void CutPolyhedron::flood(std::uint32_t start, Part part, bool outside) {
  stack_.assign(1, start);
  part_[start] = part;
  while (!stack_.empty()) {
    const std::uint32_t at = stack_.back();
    stack_.pop_back();
    for (const std::uint32_t next : corners_[at].next) {
      if (part_[next] != Part::unknown || (outside && height_[next] <= 0)) continue;
      part_[next] = part;
      stack_.push_back(next);
    }
  }
}

bool CutPolyhedron::divide(const HalfSpace& half_space) {
  height_.resize(corners_.size());
  std::uint32_t lowest = 0, highest = 0;
  bool first = true;
  for (std::uint32_t i = 0; i < corners_.size(); ++i) {
    if (part_[i] == Part::gone) continue;
    part_[i] = Part::unknown;
    height_[i] = dot(half_space.normal, corners_[i].point) - half_space.offset;
    if (first || height_[i] < height_[lowest]) lowest = i;
    if (first || height_[i] > height_[highest]) highest = i;
    first = false;
  }
  if (first || height_[highest] <= 0) return false;
  if (height_[lowest] > 0) {
    part_.assign(part_.size(), Part::gone);
    corner_count_ = 0;
    return false;
  }
  flood(highest, Part::cut_off, true);
  flood(lowest, Part::kept, false);
  for (Part& part : part_) {
    if (part == Part::unknown) part = Part::cut_off;
  }
  return true;
}

CutPolyhedron::Crossing CutPolyhedron::first_crossing() const {
  for (std::uint32_t i = 0; i < corners_.size(); ++i) {
    if (part_[i] != Part::kept) continue;
    for (std::uint32_t k = 0; k < 3; ++k) {
      if (part_[corners_[i].next[k]] == Part::cut_off) return {i, k};
    }
  }
  TETLOFT_CHECK(false);
  return {};
}

// Along the face to the left, through what is cut off and out of it.
CutPolyhedron::Crossing CutPolyhedron::next_crossing(Crossing at) const {
  std::uint32_t corner = at.corner, edge = at.edge;
  do {
    const std::uint32_t next = corners_[corner].next[edge];
    edge = (edge_to(next, corner) + 2) % 3;
    corner = next;
  } while (part_[corners_[corner].next[edge]] == Part::cut_off);
  const std::uint32_t kept = corners_[corner].next[edge];
  return {kept, edge_to(kept, corner)};
}

// On the edge, or where its three planes meet, whichever has the smaller error: in a large box
// edges that pass near the origin may have both ends far from it; and planes may be nearly
// parallel.
CutPolyhedron::Corner CutPolyhedron::crossing_point(Crossing at, std::uint32_t right_face) const {
  const std::uint32_t outside = corners_[at.corner].next[at.edge];
  const Corner& a = corners_[at.corner];
  const Corner& b = corners_[outside];
  const double below = std::min(height_[at.corner], 0.0), above = std::max(height_[outside], 0.0);
  const double share = above > below ? below / (below - above) : 0.5;
  Corner made;
  made.point = a.point + share * (b.point - a.point);
  made.spread = std::max(a.spread, b.spread);

  const HalfSpace& f = planes_[a.face[at.edge]];
  const HalfSpace& g = planes_[right_face];
  const HalfSpace& h = planes_.back();
  const Point3 gh = cross(g.normal, h.normal), hf = cross(h.normal, f.normal),
               fg = cross(f.normal, g.normal);
  const double determinant = dot(f.normal, gh);
  const Point3 met = divided(f.offset * gh + g.offset * hf + h.offset * fg, determinant);
  const double spread =
      (std::max({std::abs(f.offset), std::abs(g.offset), std::abs(h.offset)}) + length_of(met)) /
      std::abs(determinant);
  if (spread < made.spread) {  // false for no number
    made.point = met;
    made.spread = spread;
  }
  return made;
}

// The new corners stand where edges cross the plane, in a cycle, counter-clockwise as seen from
// what is kept.
void CutPolyhedron::join(const std::vector<Crossing>& cycle) {
  const std::size_t n = cycle.size();
  const auto new_face = static_cast<std::uint32_t>(planes_.size() - 1);
  std::vector<std::uint32_t> place(n);
  for (std::uint32_t& p : place) {
    if (free_.empty()) {
      p = static_cast<std::uint32_t>(corners_.size());
      corners_.emplace_back();
      part_.push_back(Part::kept);
      continue;
    }
    p = free_.back();
    free_.pop_back();
    part_[p] = Part::kept;
  }
  std::vector<Corner> made(n);
  for (std::size_t k = 0; k < n; ++k) {
    const Crossing before = cycle[(k + n - 1) % n];
    const std::uint32_t left = corners_[cycle[k].corner].face[cycle[k].edge];
    const std::uint32_t right = corners_[before.corner].face[before.edge];
    made[k] = crossing_point(cycle[k], right);
    made[k].next = {cycle[k].corner, place[(k + n - 1) % n], place[(k + 1) % n]};
    made[k].face = {right, new_face, left};
  }
  for (std::size_t k = 0; k < n; ++k) {
    corners_[place[k]] = made[k];
    corners_[cycle[k].corner].next[cycle[k].edge] = place[k];
  }
  corner_count_ += n;
}

void CutPolyhedron::remove_cut_off() {
  for (std::uint32_t i = 0; i < part_.size(); ++i) {
    if (part_[i] != Part::cut_off) continue;
    part_[i] = Part::gone;
    free_.push_back(i);
    --corner_count_;
  }
}

void CutPolyhedron::cut(const HalfSpace& half_space) {
  planes_.push_back(half_space);
  if (!divide(half_space)) return;
  std::vector<Crossing> cycle{first_crossing()};
  for (;;) {
    const Crossing next = next_crossing(cycle.back());
    if (next.corner == cycle[0].corner && next.edge == cycle[0].edge) break;
    cycle.push_back(next);
    TETLOFT_CHECK(cycle.size() <= 3 * corners_.size());
  }
  join(cycle);
  remove_cut_off();
}

std::vector<Point3> CutPolyhedron::corners() const {
  std::vector<Point3> result;
  result.reserve(corner_count_);
  for (std::size_t i = 0; i < corners_.size(); ++i) {
    if (part_[i] != Part::gone) result.push_back(corners_[i].point);
  }
  return result;
}

template <class Visit>
void CutPolyhedron::for_each_face(const Visit& visit) const {
  std::vector<bool> seen(planes_.size(), false);
  std::vector<std::uint32_t> loop;
  for (std::uint32_t i = 0; i < corners_.size(); ++i) {
    if (part_[i] == Part::gone) continue;
    for (std::uint32_t k = 0; k < 3; ++k) {
      const std::uint32_t face = corners_[i].face[k];
      if (seen[face]) continue;
      seen[face] = true;
      loop.clear();
      std::uint32_t corner = i, edge = k;
      do {
        loop.push_back(corner);
        const std::uint32_t next = corners_[corner].next[edge];
        edge = (edge_to(next, corner) + 2) % 3;
        corner = next;
      } while (corner != i);
      visit(face, loop);
    }
  }
}

std::vector<CutFace> CutPolyhedron::faces() const {
  std::vector<std::uint32_t> number(corners_.size());
  std::uint32_t count = 0;
  for (std::size_t i = 0; i < corners_.size(); ++i) {
    number[i] = count;
    if (part_[i] != Part::gone) ++count;
  }
  std::vector<CutFace> result(planes_.size());
  for_each_face([&](std::uint32_t face, const std::vector<std::uint32_t>& loop) {
    CutFace& made = result[face];
    const Point3 area =
        twice_area(loop, [&](std::uint32_t i) -> const Point3& { return corners_[i].point; });
    made.area = std::max(0.0, 0.5 * dot(area, planes_[face].normal));
    for (const std::uint32_t i : loop) made.corners.push_back(number[i]);
  });
  return result;
}

bool CutPolyhedron::reaches_box() const {
  for (std::size_t i = 0; i < corners_.size(); ++i) {
    if (part_[i] == Part::gone) continue;
    for (const std::uint32_t face : corners_[i].face) {
      if (face < kBoxFaces) return true;
    }
  }
  return false;
}

// Pyramids over the faces from one of the corners: the divergence theorem for any closed surface.
double CutPolyhedron::volume() const {
  if (empty()) return 0;
  const auto some =
      std::find_if(part_.begin(), part_.end(), [](Part p) { return p != Part::gone; });
  const Point3 apex = corners_[static_cast<std::size_t>(some - part_.begin())].point;
  double sum = 0;
  for_each_face([&](std::uint32_t /*face*/, const std::vector<std::uint32_t>& loop) {
    const auto point = [&](std::uint32_t i) -> const Point3& { return corners_[i].point; };
    sum += dot(point(loop[0]) - apex, twice_area(loop, point));
  });
  return std::max(0.0, sum / 6);
}

}  // namespace tetloft::internal::voronoi

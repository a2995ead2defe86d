// The API boundary of the 3D Delaunay triangulation: input checks, canonical ranks and
// duplicates, then order, insertion and canonical output.
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include <tetloft/delaunay.hpp>
#include <tetloft/predicates.hpp>

#include "core/check.hpp"
#include "delaunay3/affine_basis.hpp"
#include "delaunay3/canonical_mesh.hpp"
#include "delaunay3/incremental.hpp"
#include "delaunay3/spatial_order.hpp"

namespace tetloft {

namespace {

// Of 32-bit vertex ids two values are reserved, and marks take two values for each
// insertion. The limit of 2^30 tets comes first for all but degenerate input.
constexpr std::size_t kMaxPoints = std::size_t{1} << 30;

Result<void> check_points(std::span<const Point3> points) {
  if (points.size() >= kMaxPoints) {
    return Error{ErrorCode::invalid_input, "more than 2^30 points", {}};
  }
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Point3& p = points[i];
    if (std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z)) continue;
    Error error{ErrorCode::invalid_input, "a coordinate is not finite", {}};
    error.where.vertex = i;
    error.where.point = p;
    return error;
  }
  return {};
}

// The distinct points in canonical order.
struct RankedPoints {
  std::vector<Point3> point;       // by rank
  std::vector<VertexId> input_of;  // input_of[rank]: lowest input index of the point
};

// Also fills the representatives and the number of duplicates of `out`.
RankedPoints rank_points(std::span<const Point3> points, Delaunay3& out) {
  struct Indexed {
    Point3 point;
    VertexId input;
  };
  std::vector<Indexed> sorted(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) sorted[i] = {points[i], VertexId(i)};
  std::sort(sorted.begin(), sorted.end(), [](const Indexed& a, const Indexed& b) {
    return a.point == b.point ? a.input < b.input : canonical_less(a.point, b.point);
  });
  RankedPoints ranked;
  ranked.point.reserve(points.size());
  ranked.input_of.reserve(points.size());
  out.representative.resize(points.size());
  for (const Indexed& s : sorted) {
    if (ranked.point.empty() || ranked.point.back() != s.point) {
      ranked.point.push_back(s.point);
      ranked.input_of.push_back(s.input);
    }
    out.representative[s.input] = ranked.input_of.back();
  }
  out.duplicates = points.size() - ranked.point.size();
  return ranked;
}

// Brings the places of `basis`, which increase, to the front of `order`; the others keep
// their order.
void move_to_front(std::vector<std::uint32_t>& order, const std::array<std::size_t, 4>& basis) {
  for (std::size_t k = 0; k < basis.size(); ++k) {
    const auto begin = order.begin();
    const auto at = begin + static_cast<std::ptrdiff_t>(basis[k]);
    std::rotate(begin + static_cast<std::ptrdiff_t>(k), at, at + 1);
  }
}

template <class T>
std::vector<T> picked(const std::vector<T>& items, std::span<const std::uint32_t> places) {
  std::vector<T> result;
  result.reserve(places.size());
  for (const std::uint32_t place : places) result.push_back(items[place]);
  return result;
}

Result<Delaunay3> triangulate(std::span<const Point3> points) {
  if (Result<void> checked = fp_self_check(); !checked) return checked.error();
  if (Result<void> checked = check_points(points); !checked) return checked.error();

  Delaunay3 out;
  RankedPoints ranked = rank_points(points, out);
  // order[v]: rank of the vertex inserted as v-th.
  std::vector<std::uint32_t> order = delaunay3_detail::insertion_order(ranked.point);
  std::vector<Point3> inserted = picked(ranked.point, order);
  const delaunay3_detail::AffineBasis basis = delaunay3_detail::affine_basis(inserted);
  out.dimension = basis.dimension;
  if (basis.dimension < 3) {
    out.mesh = TetMesh::from_adjacency(points.size(), {}, {});
    return out;
  }
  move_to_front(order, basis.place);
  inserted = picked(ranked.point, order);
  ranked.point = {};

  delaunay3_detail::Delaunay3Builder builder{IdVector<VertexId, Point3>(std::move(inserted))};
  if (!builder.insert_all()) {
    return Error{ErrorCode::invalid_input, "the triangulation takes 2^30 tets or more", {}};
  }
  out.mesh = delaunay3_detail::canonical_mesh(
      builder, {.rank_of = order, .input_of = ranked.input_of, .input_count = points.size()});
  return out;
}

}  // namespace

Result<Delaunay3> delaunay3(std::span<const Point3> points) {
  return guard_internal([&] { return triangulate(points); });
}

}  // namespace tetloft

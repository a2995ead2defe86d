// See batch.hpp.
#include "delaunay3/batch.hpp"

#include <array>
#include <stdexcept>

#include "core/guard.hpp"
#include "core/pages.hpp"
#include "core/watched_work.hpp"
#include "delaunay3/affine_basis.hpp"
#include "delaunay3/canonical_order.hpp"
#include "delaunay3/incremental.hpp"
#include "delaunay3/spatial_order.hpp"

namespace tetloft::internal::delaunay3_detail {

namespace {

// The first four places of `order` whose points are affinely independent.
AffineBasis basis_of(std::span<const Point3> points, std::span<const std::uint32_t> order,
                     unsigned threads) {
  // Almost always among the first few.
  constexpr std::size_t kFew = 64;
  AffineBasis basis;
  for (const std::size_t count : {std::min(kFew, order.size()), order.size()}) {
    basis = affine_basis(picked<Point3>(points, order.first(count), threads));
    if (basis.dimension == 3) break;
  }
  return basis;
}

// Brings the places of a basis, which increase, to the front of `order`; the others keep their
// order.
void move_to_front(std::vector<std::uint32_t>& order, std::span<const std::size_t> basis) {
  for (std::size_t k = 0; k < basis.size(); ++k) {
    const auto begin = order.begin();
    const auto at = begin + static_cast<std::ptrdiff_t>(basis[k]);
    std::rotate(begin + static_cast<std::ptrdiff_t>(k), at, at + 1);
  }
}

}  // namespace

BatchOrder batch_order(std::span<const Point3> points, unsigned threads) {
  BatchOrder order;
  order.places = insertion_order(points, threads);
  const AffineBasis basis = basis_of(points, order.places, threads);
  order.dimension = basis.dimension;
  move_to_front(order.places,
                std::span(basis.place).first(static_cast<std::size_t>(basis.dimension + 1)));
  return order;
}

// Points are given back as soon as they have been copied on.
OwnedSlots batch_tets(std::vector<Point3> points, const Execution& execution) {
  const std::vector<std::uint32_t> canonical = canonical_order(points, execution.threads);
  std::vector<Point3> ranked = picked<Point3>(points, canonical, execution.threads);
  core::release(points);
  const BatchOrder order = batch_order(ranked, execution.threads);
  TETLOFT_CHECK(order.dimension == 3);
  WatchedWork work(execution, ranked.size() / Delaunay3Builder::kPointsOfStep + 1);
  work.go_on();
  Delaunay3Builder builder(ranked, order.places, {.threads = execution.threads});
  core::release(ranked);
  if (!builder.insert_all(work)) throw std::length_error("2^30 tets or more");
  OwnedSlots slots = builder.release_slots();
  for (TetSlot& slot : slots.all()) {
    if (!slot.vertices[0].valid()) continue;
    for (VertexId& v : slot.vertices) {
      if (v != kGhost) v = VertexId(canonical[order.places[v.index()]]);
    }
  }
  work.step_done();
  return slots;
}

}  // namespace tetloft::internal::delaunay3_detail

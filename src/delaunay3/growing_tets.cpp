// See growing_tets.hpp.
#include "delaunay3/growing_tets.hpp"

#include <algorithm>
#include <type_traits>

#include "core/pages.hpp"
#include "core/parallel.hpp"
#include "delaunay3/stretches.hpp"

namespace tetloft::internal::delaunay3_detail {

namespace {

// So many at a time by a thread.
constexpr std::size_t kVerticesGathered = std::size_t{1} << 15;

// Half-faces are 4 t + i in 32 bits, none of them the invalid one.
constexpr std::size_t kMostSlots = (std::size_t{1} << 30) - 1;

// Slots are copied as bytes and never destroyed.
static_assert(std::is_trivially_copyable_v<TetSlot> && std::is_trivially_destructible_v<TetSlot>);

}  // namespace

GrowingTets::GrowingTets(std::span<const Point3> points, std::span<const std::uint32_t> order,
                         std::size_t tets_of_point, unsigned threads)
    : vertices_(order.size()), filter_(points) {
  const Stretches all = Stretches::of(order.size(), kVerticesGathered, order.size());
  parallel_for(all.count, threads, [&](std::size_t k) {
    for (std::size_t i = all.begin(k); i < all.end(k); ++i) {
      vertices_[i] = {.point = points[order[i]], .rank = order[i], .part = 0, .on_horizon = 0};
    }
  });
  reserve(tets_of_point * vertices_.size());
}

std::size_t GrowingTets::take(std::size_t count) {
  const std::size_t first = taken();
  if (first + count > marks_.size()) reserve(count);
  taken_.store(first + count, std::memory_order_relaxed);
  return first;
}

bool GrowingTets::take_of_room(std::size_t count, std::size_t& first) {
  first = taken();
  do {
    if (first + count > marks_.size()) return false;
  } while (!taken_.compare_exchange_weak(first, first + count, std::memory_order_relaxed));
  return true;
}

void GrowingTets::reserve(std::size_t more) {
  if (taken() + more <= marks_.size()) return;
  const std::size_t capacity = std::max(taken() + more, std::min(2 * marks_.size(), kMostSlots));
  std::unique_ptr<TetSlot[], FreeSlots> slots(std::allocator<TetSlot>().allocate(capacity),
                                              FreeSlots{capacity});
  marks_.resize(capacity, Mark::unvisited);
  std::copy_n(slots_.get(), taken(), slots.get());
  slots_ = std::move(slots);
}

void GrowingTets::keep_slots_only() {
  core::release(vertices_);
  core::release(marks_);
}

}  // namespace tetloft::internal::delaunay3_detail

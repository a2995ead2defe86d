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

// Slots are copied as bytes and never destroyed.
static_assert(std::is_trivially_copyable_v<TetSlot> && std::is_trivially_destructible_v<TetSlot>);

}  // namespace

GrowingTets::GrowingTets(std::span<const Point3> points, std::span<const std::uint32_t> order,
                         std::size_t tets_of_point, unsigned threads)
    : vertices_(order.size()), filter_(points), is_ranked_(true) {
  const Stretches all = Stretches::of(order.size(), kVerticesGathered, order.size());
  parallel_for(all.count, threads, [&](std::size_t k) {
    for (std::size_t i = all.begin(k); i < all.end(k); ++i) {
      vertices_[i] = {.point = points[order[i]], .rank = order[i], .part = 0, .on_horizon = 0};
    }
  });
  reserve(tets_of_point * vertices_.size());
}

GrowingTets::GrowingTets(const GrowingTets& other)
    : vertices_(other.vertices_), filter_(other.filter_), is_ranked_(other.is_ranked_) {
  reserve(other.taken());
  std::copy_n(other.slots_.get(), other.taken(), slots_.get());
  taken_.store(other.taken(), std::memory_order_relaxed);
}

OwnedSlots GrowingTets::release_slots() {
  core::release(marks_);
  return {std::move(slots_), taken_.exchange(0, std::memory_order_relaxed)};
}

void GrowingTets::take_over(OwnedSlots slots, const predicates::SetFilter& filter) {
  marks_ = std::vector<Mark>(slots.slots.get_deleter().capacity, Mark::unvisited);
  slots_ = std::move(slots.slots);
  taken_.store(slots.taken, std::memory_order_relaxed);
  filter_ = filter;
}

VertexId GrowingTets::add_vertex(const Point3& point) {
  vertices_.push_back({.point = point, .rank = 0, .part = 0, .on_horizon = 0});
  filter_.add(point);
  return VertexId(vertices_.size() - 1);
}

void GrowingTets::replace_vertex(VertexId v, const Point3& point) {
  vertex(v).point = point;
  filter_.add(point);
}

void GrowingTets::unmark_all() { std::fill(marks_.begin(), marks_.end(), Mark::unvisited); }

void GrowingTets::start_again(const predicates::SetFilter& filter) {
  vertices_.clear();
  filter_ = filter;
  is_ranked_ = false;
  taken_.store(0, std::memory_order_relaxed);
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
  const std::size_t capacity = std::max(taken() + more, std::min(2 * marks_.size(), kMostTetSlots));
  std::unique_ptr<TetSlot[], FreeSlots> slots(std::allocator<TetSlot>().allocate(capacity),
                                              FreeSlots{capacity});
  marks_.resize(capacity, Mark::unvisited);
  TetSlot* next = slots.get();
  core::hand_over(this->slots(), [&](std::span<const TetSlot> some) {
    next = std::copy(some.begin(), some.end(), next);
  });
  slots_ = std::move(slots);
}

void GrowingTets::keep_slots_only() {
  core::release(vertices_);
  core::release(marks_);
}

}  // namespace tetloft::internal::delaunay3_detail

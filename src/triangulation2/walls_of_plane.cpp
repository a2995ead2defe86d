#include "triangulation2/walls_of_plane.hpp"

#include <bit>
#include <utility>

#include "core/provide_room.hpp"

namespace tetloft::internal::triangulation2 {

PlaneWall::PlaneWall(const Edge& edge, std::vector<ConstraintId> constraints) : edge_(edge) {
  std::sort(constraints.begin(), constraints.end());
  lowest_ = constraints.front();
  constraints.erase(constraints.begin());
  if (!constraints.empty()) others_ = std::move(constraints);
}

std::vector<ConstraintId> PlaneWall::constraints() const {
  std::vector<ConstraintId> result{lowest_};
  result.insert(result.end(), others_.begin(), others_.end());
  return result;
}

// Multiplicative (Knuth, "The Art of Computer Programming" 3, section 6.4), by the golden ratio.
std::size_t Walls::home_of(const PlaneWall::Edge& edge) const {
  const std::uint64_t key = std::uint64_t{edge[0].value()} << 32 | edge[1].value();
  const int bits = std::countr_zero(table_.size());
  return static_cast<std::size_t>((key * 0x9E3779B97F4A7C15U) >> (64 - bits));
}

std::size_t Walls::slot_of(const PlaneWall::Edge& edge) const {
  std::size_t slot = home_of(edge);
  while (table_[slot] != kFree && walls_[table_[slot]].edge() != edge) {
    slot = (slot + 1) & (table_.size() - 1);
  }
  return slot;
}

void Walls::provide_room_for_one() {
  provide_room(walls_, 1);
  if (2 * (walls_.size() + 1) <= table_.size()) return;
  std::vector<std::uint32_t> larger(std::max<std::size_t>(4 * table_.size(), 16), kFree);
  table_.swap(larger);
  for (std::uint32_t k = 0; k < walls_.size(); ++k) table_[slot_of(walls_[k].edge())] = k;
}

void Walls::append(PlaneWall wall) noexcept {
  table_[slot_of(wall.edge())] = static_cast<std::uint32_t>(walls_.size());
  walls_.push_back(std::move(wall));
}

// What is behind and would be no longer found moves up (Knuth, algorithm R).
void Walls::free_slot(std::size_t slot) noexcept {
  const std::size_t mask = table_.size() - 1;
  table_[slot] = kFree;
  for (std::size_t k = (slot + 1) & mask; table_[k] != kFree; k = (k + 1) & mask) {
    const std::size_t home = home_of(walls_[table_[k]].edge());
    if (((k - home) & mask) < ((k - slot) & mask)) continue;
    table_[slot] = std::exchange(table_[k], kFree);
    slot = k;
  }
}

void Walls::add(VertexId a, VertexId b, std::span<const ConstraintId> constraints) {
  const PlaneWall::Edge edge = PlaneWall::edge_of(a, b);
  provide_room_for_one();
  const std::size_t slot = slot_of(edge);
  if (table_[slot] != kFree) {
    PlaneWall& wall = walls_[table_[slot]];
    std::vector<ConstraintId> all = wall.constraints();
    all.insert(all.end(), constraints.begin(), constraints.end());
    wall = PlaneWall(edge, std::move(all));
    return;
  }
  if (constraints.size() == 1) {
    append(PlaneWall(edge, constraints.front()));
  } else {
    append(PlaneWall(edge, std::vector<ConstraintId>(constraints.begin(), constraints.end())));
  }
}

bool Walls::take(VertexId a, VertexId b, ConstraintId c) noexcept {
  PlaneWall& wall = walls_[table_[slot_of(PlaneWall::edge_of(a, b))]];
  std::erase(wall.others_, c);
  if (wall.lowest_ != c) return false;
  if (wall.others_.empty()) {
    remove(a, b);
    return true;
  }
  wall.lowest_ = wall.others_.front();
  wall.others_.erase(wall.others_.begin());
  return false;
}

// The last one takes its place.
void Walls::remove(VertexId a, VertexId b) noexcept {
  const std::size_t slot = slot_of(PlaneWall::edge_of(a, b));
  const std::uint32_t place = table_[slot];
  free_slot(slot);
  if (place + 1 != walls_.size()) {
    table_[slot_of(walls_.back().edge())] = place;
    walls_[place] = std::move(walls_.back());
  }
  walls_.pop_back();
}

Walls::Division Walls::prepare(VertexId a, VertexId b, VertexId middle) {
  provide_room_for_one();
  Division result{PlaneWall::edge_of(a, b), {}};
  const PlaneWall& whole = *find(a, b);
  for (const VertexId end : {a, b}) {
    result.halves.push_back(whole);
    result.halves.back().edge_ = PlaneWall::edge_of(end, middle);
  }
  return result;
}

void Walls::divide(Division& division) noexcept {
  if (division.halves.empty()) return;
  remove(division.whole[0], division.whole[1]);
  for (PlaneWall& half : division.halves) append(std::move(half));
}

void Walls::rename(VertexId w, VertexId v, VertexId other) noexcept {
  if (walls_.empty()) return;
  const std::size_t slot = slot_of(PlaneWall::edge_of(w, other));
  const std::uint32_t place = table_[slot];
  if (place == kFree) return;
  free_slot(slot);
  walls_[place].edge_ = PlaneWall::edge_of(v, other);
  table_[slot_of(walls_[place].edge())] = place;
}

}  // namespace tetloft::internal::triangulation2

// See incremental.hpp.
#include "delaunay3/incremental.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include <tetloft/predicates.hpp>

#include "core/guard.hpp"
#include "core/parallel.hpp"
#include "delaunay3/spatial_order.hpp"

namespace tetloft::internal::delaunay3_detail {

namespace {

// Points of a part in the sample that the cuts are made by.
constexpr std::size_t kSampleOfPart = 256;
// Points tried for each part, to find one in a tet of the part.
constexpr std::size_t kTriesOfPart = 32;
// A thread that gave up all but a quarter of this share of its points, gives up the others untried.
// The first ones may all lie in one corner of the part, as points follow a curve.
constexpr std::size_t kTrialOfShare = 4;

}  // namespace

Delaunay3Builder::Delaunay3Builder(std::span<const Point3> points,
                                   std::span<const std::uint32_t> order, const Sharing& sharing,
                                   std::size_t tets_of_point)
    : tets_(points, order, tets_of_point, sharing.threads), alone_(tets_), sharing_(sharing) {
  sharing_.threads = thread_count(sharing.threads);
  alone_.start_with({VertexId(0), VertexId(1), VertexId(2), VertexId(3)});
}

bool Delaunay3Builder::insert_all(WatchedWork& work, std::size_t most_tets) {
  work_ = &work;
  most_tets_ = most_tets;
  untold_ = 4;
  // As insertion_order() makes rounds, but for their exact ends: the vertices of each lie all over
  // those of the rounds before.
  std::vector<std::size_t> ends{tets_.vertex_count()};
  while (ends.back() / kRoundRatio > 4) ends.push_back(ends.back() / kRoundRatio);
  bool complete = true;
  for (std::size_t first = 4; complete && !ends.empty(); ends.pop_back()) {
    complete = insert_round(first, ends.back());
    first = ends.back();
  }
  alone_.mark_dead_slots();
  for (Inserter& inserter : within_) inserter.mark_dead_slots();
  tets_.keep_slots_only();
  return complete;
}

bool Delaunay3Builder::insert_alone(std::span<const VertexId> vertices) {
  for (const VertexId v : vertices) {
    if (!alone_.insert(v, most_tets_)) return false;
    count_steps(1);
  }
  return true;
}

void Delaunay3Builder::count_steps(std::size_t inserted) {
  untold_ += inserted;
  for (; untold_ >= kPointsOfStep; untold_ -= kPointsOfStep) work_->step_done_go_on();
}

bool Delaunay3Builder::insert_round(std::size_t first, std::size_t end) {
  std::vector<VertexId> left;
  left.reserve(end - first);
  for (std::size_t v = first; v < end; ++v) left.emplace_back(v);
  // What is left of a pass is dense near its cuts: cut where it is sparse, most of it lies well
  // within the parts of the next.
  for (Cuts cuts = Cuts::even;; cuts = Cuts::sparse) {
    const std::size_t parts = worthwhile_parts(end, left.size());
    if (parts < 2) break;
    const Partition partition = cut(left, parts, cuts);
    if (partition.parts() < 2) break;
    const std::size_t before = left.size();
    left = insert_within_parts(left, Shares(tets_, end, left, partition, sharing_.threads));
    inserted_within_parts_ += before - left.size();
    // Tets reach from part to part, wherever they are cut: as of points on a sphere.
    if (left.size() > before - before / 4) break;
  }
  return insert_alone(left);
}

std::size_t Delaunay3Builder::worthwhile_parts(std::size_t end, std::size_t left) const {
  // With as many slots as this at least, no thread comes to the last one there may be.
  const std::size_t inserted = end - left;
  if (tets_.taken() + sharing_.room_of_point * left + kMostThreads * Inserter::kSlotsAtATime >
      most_tets_) {
    return 1;
  }
  return std::min({std::size_t{sharing_.threads}, left / sharing_.least_points,
                   4 * inserted / sharing_.least_points});
}

Partition Delaunay3Builder::cut(std::span<const VertexId> vertices, std::size_t parts,
                                Cuts cuts) const {
  const std::size_t count = std::min(vertices.size(), parts * kSampleOfPart);
  std::vector<Point3> sample;
  sample.reserve(count);
  for (std::size_t i = 0; i < count; ++i) {
    sample.push_back(tets_.point(vertices[i * vertices.size() / count]));
  }
  return {sample, parts, cuts};
}

std::vector<VertexId> Delaunay3Builder::insert_within_parts(std::span<const VertexId> vertices,
                                                            const Shares& shares) {
  tets_.reserve(sharing_.room_of_point * vertices.size() + shares.size() * Inserter::kSlotsAtATime);
  while (within_.size() < shares.size()) within_.emplace_back(tets_);
  for (Part part = 0; part < shares.size(); ++part) find_start(shares[part], part);
  std::vector<std::vector<VertexId>> left(shares.size());
  std::vector<std::size_t> inserted(shares.size());
  parallel_for(shares.size(), sharing_.threads, [&](std::size_t k) {
    const Part part = static_cast<Part>(k);
    try {
      inserted[k] = insert_share(shares[part], part, left[k]);
    } catch (...) {
      failed_.store(true, std::memory_order_relaxed);
      throw;
    }
  });
  std::vector<VertexId> all_left;
  for (std::size_t k = 0; k < shares.size(); ++k) {
    count_steps(inserted[k]);
    all_left.insert(all_left.end(), left[k].begin(), left[k].end());
    if (within_[k].hint().valid()) alone_.start_at(within_[k].hint());
  }
  std::sort(all_left.begin(), all_left.end());
  return all_left;
}

void Delaunay3Builder::find_start(std::span<const VertexId> share, Part part) {
  within_[part].start_at(TetId());
  const std::size_t tries = std::min(share.size(), kTriesOfPart);
  for (std::size_t i = 0; i < tries; ++i) {
    const TetId found = alone_.locate(tets_.point(share[i * share.size() / tries]));
    if (tets_.is_ghost(found)) continue;
    alone_.start_at(found);
    if (!alone_.is_inside(found, part)) continue;
    within_[part].start_at(found);
    return;
  }
}

std::size_t Delaunay3Builder::insert_share(std::span<const VertexId> share, Part part,
                                           std::vector<VertexId>& left) {
  Inserter& inserter = within_[part];
  std::size_t inserted = 0;
  std::size_t tried = 0;
  for (bool going_on = inserter.hint().valid(); going_on && tried < share.size(); ++tried) {
    const Inserter::Outcome outcome = inserter.insert_within(share[tried], part);
    if (outcome == Inserter::Outcome::inserted) {
      if (++inserted % kPointsOfStep != 0) continue;
      work_->step_done_go_on();
      if (failed_.load(std::memory_order_relaxed)) return 0;
      continue;
    }
    left.push_back(share[tried]);
    going_on = outcome == Inserter::Outcome::given_up &&
               (tried < share.size() / kTrialOfShare || inserted > tried / 4);
  }
  const std::span<const VertexId> untried = share.subspan(tried);
  left.insert(left.end(), untried.begin(), untried.end());
  return inserted % kPointsOfStep;
}

}  // namespace tetloft::internal::delaunay3_detail

// All contacts of a soup: boxes first, exact tests on the pairs that remain.
#include <algorithm>
#include <numeric>
#include <utility>

#include "contact/contact.hpp"
#include "contact/fans.hpp"
#include "contact/separation.hpp"
#include "contact/triangle_pair.hpp"
#include "contact/triangle_tree.hpp"

namespace tetloft::internal {

namespace {

using contact_detail::Box;
using contact_detail::Facing;
using contact_detail::Fans;
using contact_detail::TriangleTree;

/// Keeps the lowest `limit` of the contacts it is given, in memory linear in `limit`.
class LowestContacts {
 public:
  explicit LowestContacts(std::size_t limit) : limit_(limit) {}

  /// False if c would not be kept, whether it is a contact or not.
  [[nodiscard]] bool wants(const Contact& c) const { return !full_ || c < bound_; }

  void add(const Contact& c) {
    kept_.push_back(c);
    if (kept_.size() >= (full_ ? 2 * limit_ : limit_)) trim();
  }

  [[nodiscard]] std::vector<Contact> sorted() {
    std::sort(kept_.begin(), kept_.end());
    if (kept_.size() > limit_) kept_.resize(limit_);
    return std::move(kept_);
  }

 private:
  void trim() {
    const auto last = kept_.begin() + static_cast<std::ptrdiff_t>(limit_ - 1);
    std::nth_element(kept_.begin(), last, kept_.end());
    kept_.resize(limit_);
    bound_ = kept_.back();
    full_ = true;
  }

  std::size_t limit_;
  std::vector<Contact> kept_;
  bool full_ = false;  // bound_ is the highest of limit_ contacts
  Contact bound_;
};

// Tests the pairs it is given; knows the facing of every triangle that it has met.
class Tester {
 public:
  Tester(std::span<const Point3> points, std::span<const TriangleVertices> triangles,
         std::span<const std::uint32_t> members, std::size_t limit)
      : points_(points),
        triangles_(triangles),
        separation_(points, triangles, members),
        facing_(triangles.size()),
        faced_(triangles.size(), 0),
        lowest_(limit) {}

  void test(std::uint32_t i, std::uint32_t j) {
    const Contact pair{std::min(i, j), std::max(i, j)};
    if (!lowest_.wants(pair)) return;
    ++tested_;
    const contact_detail::Meeting meeting(triangles_[i], triangles_[j]);
    if (meeting.shared == 0 && separation_.apart(meeting.a, meeting.b)) return;
    const Facing& of_a = facing(i);
    const Facing& of_b = facing(j);
    const bool degenerate =
        of_a.axis == contact_detail::Axis::none || of_b.axis == contact_detail::Axis::none;
    if (meeting.shared == 1 && !degenerate &&
        separation_.meet_in_first_alone(meeting.a, meeting.b)) {
      return;
    }
    if (contact_detail::touch(points_, meeting, of_a, of_b)) lowest_.add(pair);
  }

  [[nodiscard]] std::vector<Contact> sorted() { return lowest_.sorted(); }
  [[nodiscard]] std::uint64_t tested() const { return tested_; }

 private:
  const Facing& facing(std::uint32_t i) {
    if (faced_[i] == 0) {
      facing_[i] = contact_detail::facing_of(contact_detail::corners(points_, triangles_[i]));
      faced_[i] = 1;
    }
    return facing_[i];
  }

  std::span<const Point3> points_;
  std::span<const TriangleVertices> triangles_;
  contact_detail::Separation separation_;
  std::vector<Facing> facing_;
  std::vector<std::uint8_t> faced_;
  LowestContacts lowest_;
  std::uint64_t tested_ = 0;
};

// The pairs of a fan's members with each other, and with all triangles but those of fans before.
void test_fans(std::span<const Point3> points, std::span<const TriangleVertices> triangles,
               const Fans& fans, Tester& tester) {
  if (fans.fans.empty()) return;
  std::vector<std::uint32_t> all(triangles.size());
  std::iota(all.begin(), all.end(), 0U);
  const TriangleTree everything(points, triangles, all);
  for (std::uint32_t f = 0; f < fans.fans.size(); ++f) {
    const VertexId apex = fans.fans[f].apex;
    const std::vector<std::uint32_t>& members = fans.fans[f].members;
    if (members.empty()) continue;
    std::vector<TriangleTree::Item> directions;
    Box box = contact_detail::box_of(points, triangles[members.front()]);
    for (const std::uint32_t i : members) {
      directions.push_back({contact_detail::directions_of(points, apex, triangles[i]), i});
      box.extend(contact_detail::box_of(points, triangles[i]));
    }
    TriangleTree fan(points, triangles, directions);
    fan.for_each_pair([&](std::uint32_t i, std::uint32_t j) { tester.test(i, j); });
    everything.for_each_meeting(box, [&](std::uint32_t j) {
      if (fans.fan_of[j] != Fans::kNone && fans.fan_of[j] <= f) return;
      const Box around = contact_detail::box_of(points, triangles[j]);
      fan.for_each_meeting(contact_detail::directions_of(points, apex, triangles[j]), around,
                           [&](std::uint32_t i) {
                             if (around.meets(contact_detail::box_of(points, triangles[i]))) {
                               tester.test(i, j);
                             }
                           });
    });
  }
}

// Of others that are more times as many as the rest, most meet nothing of it: that is found one by
// one before a tree of them is made.
constexpr std::size_t kLookUps = 8;

// The pairs of the rest, and those with triangles that are not active, where some are not.
void test_rest(std::span<const Point3> points, std::span<const TriangleVertices> triangles,
               std::span<const std::uint32_t> rest, std::span<const std::uint8_t> active,
               Tester& tester) {
  if (rest.empty()) return;
  const auto test = [&](std::uint32_t i, std::uint32_t j) { tester.test(i, j); };
  TriangleTree tree(points, triangles, rest);
  tree.for_each_pair(test);
  std::vector<std::uint32_t> others;
  for (std::uint32_t j = 0; j < active.size(); ++j) {
    if (active[j] == 0) others.push_back(j);
  }
  if (others.size() <= kLookUps * rest.size()) {
    TriangleTree tree_of_others(points, triangles, others);
    tree.for_each_pair_with(tree_of_others, test);
    return;
  }
  // One by one: most meet nothing there.
  for (const std::uint32_t j : others) {
    tree.for_each_meeting(contact_detail::box_of(points, triangles[j]),
                          [&](std::uint32_t i) { tester.test(i, j); });
  }
}

}  // namespace

std::vector<Contact> find_contacts(std::span<const Point3> points,
                                   std::span<const TriangleVertices> triangles, std::size_t limit,
                                   std::span<const std::uint8_t> active, std::uint64_t* tested) {
  if (limit == 0) return {};
  std::vector<std::uint32_t> members;
  members.reserve(triangles.size());
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    if (active.empty() || active[i] != 0) members.push_back(static_cast<std::uint32_t>(i));
  }
  if (members.empty()) return {};
  const bool all_active = members.size() == triangles.size();

  Tester tester(points, triangles, members, limit);
  const Fans fans = contact_detail::gather_fans(points.size(), triangles, members);
  test_fans(points, triangles, fans, tester);
  test_rest(points, triangles, fans.rest, all_active ? std::span<const std::uint8_t>() : active,
            tester);
  if (tested != nullptr) *tested += tester.tested();
  return tester.sorted();
}

}  // namespace tetloft::internal

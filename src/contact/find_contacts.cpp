// All contacts of a soup: boxes first, exact tests on the pairs that remain.
#include <algorithm>
#include <utility>

#include "contact/box_tree.hpp"
#include "contact/contact.hpp"
#include "contact/triangle_pair.hpp"

namespace tetloft {

namespace {

using contact_detail::Facing;

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

}  // namespace

std::vector<Contact> find_contacts(std::span<const Point3> points,
                                   std::span<const TriangleVertices> triangles, std::size_t limit,
                                   std::span<const std::uint8_t> active) {
  if (limit == 0) return {};
  std::vector<std::uint32_t> members;
  members.reserve(triangles.size());
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    if (active.empty() || active[i] != 0) members.push_back(static_cast<std::uint32_t>(i));
  }
  if (members.empty()) return {};
  const auto facing_of = [&](std::size_t i) {
    return contact_detail::facing_of(contact_detail::corners(points, triangles[i]));
  };
  std::vector<Facing> facing(triangles.size());  // of members only
  for (const std::uint32_t i : members) facing[i] = facing_of(i);

  LowestContacts lowest(limit);
  const contact_detail::BoxTree tree(points, triangles, members);
  tree.for_each_pair([&](std::uint32_t i, std::uint32_t j) {
    const Contact pair{std::min(i, j), std::max(i, j)};
    if (!lowest.wants(pair)) return;
    if (contact_detail::touch(points, triangles[i], facing[i], triangles[j], facing[j])) {
      lowest.add(pair);
    }
  });
  if (members.size() == triangles.size()) return lowest.sorted();

  // The others against the tree, one by one: most meet nothing there.
  for (std::uint32_t j = 0; j < triangles.size(); ++j) {
    if (active[j] != 0) continue;
    bool faced = false;
    tree.for_each_meeting(contact_detail::box_of(points, triangles[j]), [&](std::uint32_t i) {
      const Contact pair{std::min(i, j), std::max(i, j)};
      if (!lowest.wants(pair)) return;
      if (!faced) facing[j] = facing_of(j);
      faced = true;
      if (contact_detail::touch(points, triangles[i], facing[i], triangles[j], facing[j])) {
        lowest.add(pair);
      }
    });
  }
  return lowest.sorted();
}

}  // namespace tetloft

#include "contact/triangle_tree.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <limits>

#include "contact/narrowed.hpp"

namespace tetloft::internal::contact_detail {

Box::Box(const Point3& p)
    : low(p),
      high(p),
      oblique_low{narrowed(p.x + p.y),     narrowed(p.x - p.y),     narrowed(p.x + 2 * p.y),
                  narrowed(p.x - 2 * p.y), narrowed(2 * p.x + p.y), narrowed(2 * p.x - p.y)},
      oblique_high(oblique_low) {}

Box box_of(std::span<const Point3> points, const TriangleVertices& t) {
  Box box(points[t[0].index()]);
  box.extend(Box(points[t[1].index()]));
  box.extend(Box(points[t[2].index()]));
  return box;
}

void Box::extend(const Box& b) {
  low = {std::min(low.x, b.low.x), std::min(low.y, b.low.y), std::min(low.z, b.low.z)};
  high = {std::max(high.x, b.high.x), std::max(high.y, b.high.y), std::max(high.z, b.high.z)};
  for (std::size_t k = 0; k < kOblique; ++k) {
    oblique_low[k] = std::min(oblique_low[k], b.oblique_low[k]);
    oblique_high[k] = std::max(oblique_high[k], b.oblique_high[k]);
  }
}

TriangleTree::TriangleTree(std::span<const Point3> points,
                           std::span<const TriangleVertices> triangles,
                           std::span<const std::uint32_t> members)
    : points_(points), triangles_(triangles) {
  std::vector<Item> items;
  items.reserve(members.size());
  for (const std::uint32_t i : members) items.push_back({box_of(points, triangles[i]), i});
  order(items);
}

TriangleTree::TriangleTree(std::span<const Point3> points,
                           std::span<const TriangleVertices> triangles,
                           const std::vector<Item>& items)
    : points_(points), triangles_(triangles) {
  order(items);
  around_.resize(nodes_.size(), Box({}, {}));
  for (std::size_t k = nodes_.size(); k-- > 0;) {
    const Node& node = nodes_[k];
    if (node.left != 0) {
      around_[k] = around_[node.left];
      around_[k].extend(around_[node.left + 1]);
      continue;
    }
    around_[k] = box_of(points, triangles[items_[node.begin].triangle]);
    for (std::uint32_t i = node.begin; i < node.end; ++i) {
      around_[k].extend(box_of(points, triangles[items_[i].triangle]));
    }
  }
}

void TriangleTree::order(const std::vector<Item>& unordered) {
  const std::size_t n = unordered.size();
  if (n == 0) return;
  Box all = unordered.front().box;
  for (const Item& item : unordered) all.extend(item.box);

  // Centres in units of the whole extent, lest they leave the range of float. Halved before
  // subtracting, lest the extent overflow.
  const double extent =
      std::max({all.high.x / 2 - all.low.x / 2, all.high.y / 2 - all.low.y / 2,
                all.high.z / 2 - all.low.z / 2, std::numeric_limits<double>::min()});
  const auto centre = [extent](double low, double high, double origin) {
    return static_cast<float>(((low / 2 - origin / 2) + (high / 2 - origin / 2)) / extent);
  };
  std::vector<Centre> centres(n);
  for (std::size_t i = 0; i < n; ++i) {
    const Box& b = unordered[i].box;
    centres[i] = {{centre(b.low.x, b.high.x, all.low.x), centre(b.low.y, b.high.y, all.low.y),
                   centre(b.low.z, b.high.z, all.low.z)},
                  static_cast<std::uint32_t>(i)};
  }
  build(centres);
  items_.reserve(n);
  for (const Centre& c : centres) items_.push_back(unordered[c.triangle]);
  fit_boxes();
}

void TriangleTree::build(std::vector<Centre>& centres) {
  nodes_.reserve(2 * (centres.size() / (kLeafSize / 2) + 1));
  nodes_.emplace_back();
  nodes_[0].end = static_cast<std::uint32_t>(centres.size());
  // Children are appended, so this visits every node.
  for (std::size_t k = 0; k < nodes_.size(); ++k) {
    const std::uint32_t begin = nodes_[k].begin;
    const std::uint32_t end = nodes_[k].end;
    if (end - begin <= kLeafSize) continue;
    std::array<float, 3> low{centres[begin].at[0], centres[begin].at[1], centres[begin].at[2]};
    std::array<float, 3> high = low;
    for (std::uint32_t i = begin; i < end; ++i) {
      for (std::size_t d = 0; d < 3; ++d) {
        low[d] = std::min(low[d], centres[i].at[d]);
        high[d] = std::max(high[d], centres[i].at[d]);
      }
    }
    std::size_t axis = 0;
    for (std::size_t d = 1; d < 3; ++d) {
      if (high[d] - low[d] > high[axis] - low[axis]) axis = d;
    }
    // A total order: which triangles come before the median is then determined, and with
    // it the set of every node.
    const std::uint32_t middle = begin + (end - begin) / 2;
    std::nth_element(centres.begin() + begin, centres.begin() + middle, centres.begin() + end,
                     [axis](const Centre& a, const Centre& b) {
                       return a.at[axis] != b.at[axis] ? a.at[axis] < b.at[axis]
                                                       : a.triangle < b.triangle;
                     });
    const auto left = static_cast<std::uint32_t>(nodes_.size());
    nodes_[k].left = left;
    nodes_.emplace_back();
    nodes_.emplace_back();
    nodes_[left].begin = begin;
    nodes_[left].end = nodes_[left + 1].begin = middle;
    nodes_[left + 1].end = end;
  }
}

void TriangleTree::fit_boxes() {
  for (std::size_t k = nodes_.size(); k-- > 0;) {
    Node& node = nodes_[k];
    if (node.left != 0) {
      node.box = nodes_[node.left].box;
      node.box.extend(nodes_[node.left + 1].box);
      continue;
    }
    node.box = items_[node.begin].box;
    for (std::uint32_t i = node.begin; i < node.end; ++i) {
      node.box.extend(items_[i].box);
    }
  }
}

// Those whose boxes meet, as bits kLeafSize i + j for triangles i of a and j of b, but for what
// sheets tell apart. Leaves that have met in a crowd are likely to be in another one.
std::uint64_t TriangleTree::close_pairs(Node& a, TriangleTree& other, Node& b) {
  const bool known = a.sheets != kNoSheets && b.sheets != kNoSheets;
  const auto apart = [&] { return sheets_[a.sheets].apart(other.sheets_[b.sheets]); };
  if (known && apart()) return 0;
  std::uint64_t pairs = meeting_pairs(a, other, b);
  if (std::popcount(pairs) <= kFewPairs) return pairs;
  if (!known) {
    need_sheets(a);
    other.need_sheets(b);
    if (apart()) return 0;
  }
  sift(a, other, b, pairs);
  return pairs;
}

std::uint64_t TriangleTree::meeting_pairs(const Node& a, const TriangleTree& other,
                                          const Node& b) const {
  static_assert(kLeafSize * kLeafSize <= 64);
  std::uint64_t pairs = 0;
  for (std::uint32_t i = a.begin; i < a.end; ++i) {
    const Box& box = items_[i].box;
    if (!box.meets(b.box)) continue;
    const std::uint32_t row = kLeafSize * (i - a.begin);
    for (std::uint32_t j = b.begin; j < b.end; ++j) {
      if (box.meets(other.items_[j].box)) pairs |= std::uint64_t{1} << (row + j - b.begin);
    }
  }
  return pairs;
}

void TriangleTree::sift(const Node& a, const TriangleTree& other, const Node& b,
                        std::uint64_t& pairs) const {
  const Sheet& of_b = other.sheets_[b.sheets];
  for (std::uint32_t i = 0; i < a.end - a.begin; ++i) {
    const std::uint32_t first = kLeafSize * i;
    const std::uint64_t row = ((std::uint64_t{1} << kLeafSize) - 1) << first;
    if ((pairs & row) == 0) continue;
    const Sheet& sheet = sheets_[a.sheets + 1 + i];
    if (sheet.apart(of_b)) {
      pairs &= ~row;
      continue;
    }
    for (std::uint32_t j = 0; j < b.end - b.begin; ++j) {
      const std::uint64_t pair = std::uint64_t{1} << (first + j);
      if ((pairs & pair) != 0 && sheet.apart(other.sheets_[b.sheets + 1 + j])) pairs &= ~pair;
    }
  }
}

void TriangleTree::need_sheets(Node& leaf) {
  if (leaf.sheets != kNoSheets) return;
  leaf.sheets = static_cast<std::uint32_t>(sheets_.size());
  std::array<Triangle3, kLeafSize> about;
  std::size_t n = 0;
  for (std::uint32_t i = leaf.begin; i < leaf.end; ++i) {
    about[n++] = corners(points_, triangles_[items_[i].triangle]);
  }
  sheets_.emplace_back(std::span(about).first(n));
  for (std::size_t k = 0; k < n; ++k) sheets_.emplace_back(std::span(about).subspan(k, 1));
}

}  // namespace tetloft::internal::contact_detail

// A balanced tree of axis-parallel boxes over the triangles of a soup, in flat arrays.
//
// Apart from spatial/box_tree: contacts ask for the pairs within one tree, and for boxes of another
// kind that are near in space besides; both want a binary tree whose nodes are runs of triangles.
//
// Each node halves its triangles at the median of their box centres along the longest
// extent of these. Everything but exact box comparisons, and what sheets tell, is a matter of
// speed, not of truth.
#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include <tetloft/point.hpp>
#include <tetloft/tet_mesh.hpp>

#include "contact/sheet.hpp"

namespace tetloft::internal::contact_detail {

/// Bounds of points along the axes, and along six lines between x and y: triangles between section
/// planes are long and thin in all directions, but low.
///
/// The oblique coordinates x ± y, x ± 2 y and 2 x ± y are rounded, once to double and once to
/// float. Rounding is monotone: that of a point of a triangle lies between the least and the
/// largest of its vertices, as rounded. So boxes that do not meet hold triangles that do not
/// either, exactly.
struct Box {
  static constexpr std::size_t kOblique = 6;
  static constexpr float kUnbounded = std::numeric_limits<float>::infinity();

  Point3 low;
  Point3 high;
  std::array<float, kOblique> oblique_low;
  std::array<float, kOblique> oblique_high;

  /// Of one point.
  explicit Box(const Point3& p);
  /// Unbounded along oblique lines.
  constexpr Box(const Point3& lowest, const Point3& highest) : low(lowest), high(highest) {
    for (float& least : oblique_low) least = -kUnbounded;
    for (float& most : oblique_high) most = kUnbounded;
  }

  [[nodiscard]] bool meets(const Box& b) const {
    return low.x <= b.high.x && b.low.x <= high.x && low.y <= b.high.y && b.low.y <= high.y &&
           low.z <= b.high.z && b.low.z <= high.z && meets_obliquely(b);
  }
  void extend(const Box& b);

 private:
  // Without branches: boxes that meet along the axes mostly meet.
  [[nodiscard]] bool meets_obliquely(const Box& b) const {
    unsigned apart = 0;
    for (std::size_t k = 0; k < kOblique; ++k) {
      apart |= static_cast<unsigned>(oblique_low[k] > b.oblique_high[k]) |
               static_cast<unsigned>(b.oblique_low[k] > oblique_high[k]);
    }
    return apart == 0;
  }
};

[[nodiscard]] Box box_of(std::span<const Point3> points, const TriangleVertices& t);

class TriangleTree {
 public:
  /// A tree over the given triangles of a soup.
  TriangleTree(std::span<const Point3> points, std::span<const TriangleVertices> triangles,
               std::span<const std::uint32_t> members);

  struct Item {
    Box box;
    std::uint32_t triangle;
  };
  /// A tree over triangles of a soup by boxes of any kind, finite along the axes. Nodes know their
  /// boxes in space as well.
  TriangleTree(std::span<const Point3> points, std::span<const TriangleVertices> triangles,
               const std::vector<Item>& items);

  /// Calls visit(i, j) once for each unordered pair of members, i != j, whose closed boxes
  /// meet, but for some whose sheets have no common point. The order depends on the input alone.
  template <class Visit>
  void for_each_pair(Visit&& visit);

  /// The same for each pair of a member i and a member j of another tree over the same soup.
  template <class Visit>
  void for_each_pair_with(TriangleTree& other, Visit&& visit);

  /// Calls visit(i) for every member i whose closed box meets `box`. The order depends on
  /// the input alone.
  template <class Visit>
  void for_each_meeting(const Box& box, Visit&& visit) const;

  /// The same for members that are in addition in nodes whose boxes in space meet `around`.
  template <class Visit>
  void for_each_meeting(const Box& box, const Box& around, Visit&& visit) const;

 private:
  // Measured: 4 to 12 are equally fast; fewer nodes take less memory. The pairs of two leaves are
  // the bits of a mask.
  static constexpr std::uint32_t kLeafSize = 8;
  // As many pairs of two leaves are as soon told apart one by one as by sheets.
  static constexpr int kFewPairs = 24;
  static constexpr std::uint32_t kNoSheets = 0xFFFFFFFFU;

  /// Triangles items_[begin … end − 1], one at least. A leaf iff left is 0, else the
  /// children are left and left + 1. Of a leaf sheets_[sheets] is about all its triangles, and
  /// those of each follow.
  struct Node {
    Box box{{}, {}};
    std::uint32_t begin = 0;
    std::uint32_t end = 0;
    std::uint32_t left = 0;
    std::uint32_t sheets = kNoSheets;
  };
  struct Centre {
    float at[3];
    std::uint32_t triangle;
  };

  void order(const std::vector<Item>& unordered);
  void build(std::vector<Centre>& centres);
  void fit_boxes();

  [[nodiscard]] std::uint64_t close_pairs(Node& a, TriangleTree& other, Node& b);
  [[nodiscard]] std::uint64_t meeting_pairs(const Node& a, const TriangleTree& other,
                                            const Node& b) const;
  void sift(const Node& a, const TriangleTree& other, const Node& b, std::uint64_t& pairs) const;
  void need_sheets(Node& leaf);

  template <class Enters, class Visit>
  void for_each_meeting_where(const Box& box, const Enters& enters, Visit& visit) const;
  template <class Visit>
  void visit_leaf(const Node& a, Visit& visit) const;
  template <class Visit>
  void visit_pairs(std::uint32_t of_this, TriangleTree& other, std::uint32_t of_other,
                   Visit& visit);

  std::span<const Point3> points_;
  std::span<const TriangleVertices> triangles_;
  std::vector<Node> nodes_;    // root first, children after their parent
  std::vector<Item> items_;    // the triangles in the order of the leaves
  std::vector<Box> around_;    // by node, in space, where the boxes are of another kind
  std::vector<Sheet> sheets_;  // of leaves that have needed theirs
};

template <class Visit>
void TriangleTree::visit_leaf(const Node& a, Visit& visit) const {
  for (std::uint32_t i = a.begin; i < a.end; ++i) {
    for (std::uint32_t j = i + 1; j < a.end; ++j) {
      const Item& p = items_[i];
      const Item& q = items_[j];
      if (p.box.meets(q.box)) visit(p.triangle, q.triangle);
    }
  }
}

template <class Visit>
void TriangleTree::visit_pairs(std::uint32_t of_this, TriangleTree& other, std::uint32_t of_other,
                               Visit& visit) {
  struct Pair {
    std::uint32_t a, b;
  };
  std::vector<Pair> stack{{of_this, of_other}};
  while (!stack.empty()) {
    const Pair pair = stack.back();
    stack.pop_back();
    Node& a = nodes_[pair.a];
    Node& b = other.nodes_[pair.b];
    if (!a.box.meets(b.box)) continue;
    if (a.left == 0 && b.left == 0) {
      for (std::uint64_t pairs = close_pairs(a, other, b); pairs != 0; pairs &= pairs - 1) {
        const auto k = static_cast<std::uint32_t>(std::countr_zero(pairs));
        visit(items_[a.begin + k / kLeafSize].triangle,
              other.items_[b.begin + k % kLeafSize].triangle);
      }
    } else if (b.left == 0 || (a.left != 0 && a.end - a.begin >= b.end - b.begin)) {
      stack.push_back({a.left, pair.b});
      stack.push_back({a.left + 1, pair.b});
    } else {
      stack.push_back({pair.a, b.left});
      stack.push_back({pair.a, b.left + 1});
    }
  }
}

template <class Visit>
void TriangleTree::for_each_pair(Visit&& visit) {
  for (std::uint32_t k = 0; k < nodes_.size(); ++k) {
    const Node& node = nodes_[k];
    if (node.left == 0) {
      visit_leaf(node, visit);
    } else {
      visit_pairs(node.left, *this, node.left + 1, visit);
    }
  }
}

template <class Visit>
void TriangleTree::for_each_pair_with(TriangleTree& other, Visit&& visit) {
  if (!nodes_.empty() && !other.nodes_.empty()) visit_pairs(0, other, 0, visit);
}

template <class Visit>
void TriangleTree::for_each_meeting(const Box& box, Visit&& visit) const {
  for_each_meeting_where(
      box, [](std::uint32_t) { return true; }, visit);
}

template <class Visit>
void TriangleTree::for_each_meeting(const Box& box, const Box& around, Visit&& visit) const {
  for_each_meeting_where(
      box, [&](std::uint32_t k) { return around_[k].meets(around); }, visit);
}

template <class Enters, class Visit>
void TriangleTree::for_each_meeting_where(const Box& box, const Enters& enters,
                                          Visit& visit) const {
  if (nodes_.empty()) return;
  // Depth first: at most one sibling waits at each of fewer than 32 levels.
  std::array<std::uint32_t, 33> stack;
  std::size_t waiting = 0;
  stack[waiting++] = 0;
  while (waiting > 0) {
    const std::uint32_t k = stack[--waiting];
    const Node& node = nodes_[k];
    if (!node.box.meets(box) || !enters(k)) continue;
    if (node.left != 0) {
      stack[waiting++] = node.left + 1;
      stack[waiting++] = node.left;
      continue;
    }
    for (std::uint32_t i = node.begin; i < node.end; ++i) {
      if (items_[i].box.meets(box)) visit(items_[i].triangle);
    }
  }
}

}  // namespace tetloft::internal::contact_detail

// Finding contacts: a sweep tells whether there is any, and only then a search in the order
// of the vertices finds the first one and says what it is.
//
// The sweep stops at the first vertex where something is wrong. Up to there the order of
// its status is that of disjoint edges: edges that cross are neighbours in it before they
// do, and a vertex that lies on an edge is found when the sweep reaches the vertex.
#include "sections/contacts.hpp"

#include <algorithm>
#include <cstdint>
#include <span>
#include <utility>

#include "sections/nesting.hpp"
#include "sections/segments.hpp"
#include "sections/sweep.hpp"
#include "spatial/box_tree.hpp"

namespace tetloft::internal::sections {

namespace {

// Contacts between the vertices and edges of the usable contours of one section. Vertices
// are numbered through; edge i starts at vertex i.
class ContactSearch {
 public:
  explicit ContactSearch(const Section& section, const std::vector<bool>& usable) {
    std::vector<Box2> boxes;
    for (std::size_t c = 0; c < section.contours.size(); ++c) {
      if (!usable[c]) continue;
      const std::vector<Point2>& vertices = section.contours[ContourId(c)].vertices;
      const std::size_t first = corners_.size();
      for (std::size_t v = 0; v < vertices.size(); ++v) {
        const std::size_t next = v + 1 == vertices.size() ? 0 : v + 1;
        const std::size_t previous = (v == 0 ? vertices.size() : v) - 1;
        corners_.push_back({vertices[v], c, v, first + next, first + previous});
        boxes.push_back(box_of(vertices[v], vertices[next]));
      }
    }
    tree_.emplace(boxes);
  }

  // The first contact before `limit`.
  [[nodiscard]] std::optional<Defect> first(const std::optional<Defect>& limit) const {
    for (std::size_t i = 0; i < corners_.size(); ++i) {
      const Corner& corner = corners_[i];
      if (limit && !Defect{corner.contour, corner.vertex, {}}.before(limit->contour, limit->vertex))
        return std::nullopt;
      const Contact contact = contact_at(i);
      if (contact.kind != ContactKind::none) {
        return Defect{corner.contour, corner.vertex, reason(i, contact)};
      }
    }
    return std::nullopt;
  }

 private:
  struct Corner {
    Point2 point;
    std::size_t contour, vertex;
    std::size_t next, previous;
  };
  enum class ContactKind { vertex, edge, crossing, none };
  struct Contact {
    ContactKind kind = ContactKind::none;
    std::size_t other = 0;
  };

  // What vertex i and edge i touch: of several things the first kind, the lowest number.
  [[nodiscard]] Contact contact_at(std::size_t i) const {
    Contact best;
    const Corner& p = corners_[i];
    tree_->query(box_of(p.point, corners_[p.next].point), [&](std::size_t j) {
      const ContactKind kind = classify(i, j);
      if (kind < best.kind || (kind == best.kind && j < best.other)) best = {kind, j};
    });
    return best;
  }

  [[nodiscard]] ContactKind classify(std::size_t i, std::size_t j) const {
    const Corner& p = corners_[i];
    if (j == i || j == p.previous) return ContactKind::none;
    const Corner& q = corners_[j];
    const Point2& r = corners_[q.next].point;
    if (p.point == q.point) {
      // Neighbours that coincide, or coincide around a spike, are defects of their own.
      const bool local = j == p.next || p.next == q.previous || p.previous == q.next;
      return local ? ContactKind::none : ContactKind::vertex;
    }
    if (!(q.point == r) && in_segment(q.point, r, p.point)) {
      const bool spike = j == p.next || q.next == p.previous;
      return spike ? ContactKind::none : ContactKind::edge;
    }
    if (j > i && cross(p.point, corners_[p.next].point, q.point, r)) return ContactKind::crossing;
    return ContactKind::none;
  }

  [[nodiscard]] std::string reason(std::size_t i, const Contact& contact) const {
    const Corner& p = corners_[i];
    const Corner& q = corners_[contact.other];
    const bool same = p.contour == q.contour;
    const std::string other = "contour " + std::to_string(q.contour);
    const std::string from = "from vertex " + std::to_string(q.vertex);
    switch (contact.kind) {
      case ContactKind::vertex: {
        const std::string at = other + ", vertex " + std::to_string(q.vertex);
        if (same) {
          return "contour passes twice through one point (again at vertex " +
                 std::to_string(q.vertex) + ')';
        }
        if (repeats(i, contact.other)) return "the same contour twice (again as " + other + ')';
        if (shares_edge(p, q)) return "two contours share an edge (at " + at + ')';
        return "two contours share a vertex (with " + at + ')';
      }
      case ContactKind::edge: {
        const std::string of = same ? "its own contour" : other;
        const char* what =
            overlaps_edge(p, q) ? "edge overlaps an edge of " : "vertex lies on an edge of ";
        return what + of + " (the edge " + from + ')';
      }
      case ContactKind::crossing:
        return (same ? "contour crosses itself" : "contour crosses " + other) + " (the edge " +
               from + (same ? ")" : " there)");
      case ContactKind::none: break;
    }
    return {};
  }

  [[nodiscard]] bool shares_edge(const Corner& p, const Corner& q) const {
    for (const std::size_t a : {p.next, p.previous}) {
      for (const std::size_t b : {q.next, q.previous}) {
        if (corners_[a].point == corners_[b].point) return true;
      }
    }
    return false;
  }

  // Does an edge at p run along the edge that starts at q and contains p?
  [[nodiscard]] bool overlaps_edge(const Corner& p, const Corner& q) const {
    const Point2& r = corners_[q.next].point;
    return orient2d(q.point, r, corners_[p.next].point) == Sign::zero ||
           orient2d(q.point, r, corners_[p.previous].point) == Sign::zero;
  }

  // Are the contours of i and j the same from these coinciding vertices on, in either
  // direction?
  [[nodiscard]] bool repeats(std::size_t i, std::size_t j) const {
    bool along = true;
    bool against = true;
    std::size_t a = i;
    std::size_t b = j;
    std::size_t c = j;
    do {
      along = along && corners_[a].point == corners_[b].point;
      against = against && corners_[a].point == corners_[c].point;
      a = corners_[a].next;
      b = corners_[b].next;
      c = corners_[c].previous;
    } while (a != i && b != j && (along || against));
    return a == i && b == j && (along || against);
  }

  std::vector<Corner> corners_;
  std::optional<BoxTree2> tree_;
};

// Do the edges, neighbours in the sweep's status, cross? Most lie at different heights.
bool collide(const SweepEdge& below, const SweepEdge& above) {
  if (std::max(below.low.y, below.high.y) < std::min(above.low.y, above.high.y)) return false;
  return cross(below.low, below.high, above.low, above.high);
}

bool contains(const SweepEdge& edge, const Point2& p) {
  if (std::max(edge.low.y, edge.high.y) < p.y || p.y < std::min(edge.low.y, edge.high.y)) {
    return false;
  }
  return orient2d(edge.low, edge.high, p) == Sign::zero;
}

// Does something meet at this vertex, or do edges cross that become neighbours there?
bool has_contact(std::span<const SweepEdge> edges, const SweepEvent& event) {
  const std::span<const std::uint32_t> outgoing = event.outgoing;
  if (event.incoming.size() + outgoing.size() != 2) return true;
  const bool is_below = event.below != kNoEdge;
  const bool is_above = event.above != kNoEdge;
  if (is_below && contains(edges[event.below], event.at)) return true;
  if (is_above && contains(edges[event.above], event.at)) return true;
  if (outgoing.empty())
    return is_below && is_above && collide(edges[event.below], edges[event.above]);
  const bool spike = outgoing.size() == 2 && orient2d(event.at, edges[outgoing[0]].high,
                                                      edges[outgoing[1]].high) == Sign::zero;
  return spike || (is_below && collide(edges[event.below], edges[outgoing.front()])) ||
         (is_above && collide(edges[outgoing.back()], edges[event.above]));
}

}  // namespace

std::optional<Nesting> nest_without_contact(const Section& section) {
  Nester nester(section);
  const std::span<const SweepEdge> edges = nester.edges();
  bool contact = false;
  Sweep(edges).run([&](const SweepEvent& event) {
    contact = has_contact(edges, event);
    if (!contact) nester.see(event);
    return !contact;
  });
  if (contact) return std::nullopt;
  return nester.take();
}

std::optional<Defect> first_contact(const Section& section, const std::vector<bool>& usable,
                                    const std::optional<Defect>& limit) {
  return ContactSearch(section, usable).first(limit);
}

}  // namespace tetloft::internal::sections

// Exact validation of a stack of sections.
//
// Every vertex is looked at in the order (section, contour, vertex), and the first that is
// part of a defect is reported, so the search stops there. A contact belongs to the vertex
// that lies on something, a crossing to the start of the earlier edge. Contours without an
// interior and contours with bad coordinates are defects themselves; they take part in no
// contact.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <optional>
#include <string>
#include <vector>

#include <tetloft/sections.hpp>

#include "core/check.hpp"
#include "sections/box_tree.hpp"
#include "sections/segments.hpp"

namespace tetloft {

namespace {

using sections::Box;
using sections::box_of;
using sections::BoxTree;
using sections::cross;
using sections::in_segment;

constexpr std::size_t kWholeContour = static_cast<std::size_t>(-1);

// A defect of one section; a defect of a whole contour comes before those of its vertices.
struct Defect {
  std::size_t contour;
  std::size_t vertex;  // or kWholeContour
  std::string reason;

  [[nodiscard]] bool before(std::size_t c, std::size_t v) const {
    return contour != c ? contour < c : vertex + 1 < v + 1;  // kWholeContour + 1 is 0
  }
};

const char* coordinate_reason(double x) {
  if (!std::isfinite(x)) return "coordinate is not finite";
  if (!(std::abs(x) < kLargestCoordinate)) return "coordinate is not below 2^1000";
  return nullptr;
}

const char* coordinate_reason(const Point2& p) {
  const char* reason = coordinate_reason(p.x);
  return reason != nullptr ? reason : coordinate_reason(p.y);
}

// Are all vertices on one line? A simple contour has zero area in no other case.
bool is_collinear(const std::vector<Point2>& vertices) {
  const Point2& a = vertices.front();
  const auto b =
      std::find_if(vertices.begin(), vertices.end(), [&](const Point2& p) { return !(p == a); });
  return std::all_of(b, vertices.end(),
                     [&](const Point2& p) { return p == a || orient2d(a, *b, p) == Sign::zero; });
}

// Is the contour usable for contact tests? If not, why.
std::optional<Defect> whole_contour_defect(const Contour& contour, std::size_t c) {
  const std::vector<Point2>& vertices = contour.vertices;
  if (vertices.size() < 3) return Defect{c, kWholeContour, "contour has fewer than three vertices"};
  for (std::size_t v = 0; v < vertices.size(); ++v) {
    if (const char* reason = coordinate_reason(vertices[v])) return Defect{c, v, reason};
  }
  if (is_collinear(vertices)) return Defect{c, kWholeContour, "contour has zero area"};
  return std::nullopt;
}

// Do a → b and b → c overlap, turning back at b?
bool folds_back(const Point2& a, const Point2& b, const Point2& c) {
  return !(a == b) && !(b == c) && canonical_less(a, b) == canonical_less(c, b) &&
         orient2d(a, b, c) == Sign::zero;
}

// The first vertex of the contour that is wrong among its neighbours.
std::optional<Defect> local_defect(const Contour& contour, std::size_t c) {
  const std::vector<Point2>& vertices = contour.vertices;
  const std::size_t n = vertices.size();
  for (std::size_t v = 0; v < n; ++v) {
    const Point2& p = vertices[v];
    if (v > 0 && p == vertices[v - 1]) return Defect{c, v, "vertex repeats its predecessor"};
    if (v + 1 == n && p == vertices[0]) {
      return Defect{c, v, "first vertex is repeated at the end"};
    }
    if (folds_back(vertices[v == 0 ? n - 1 : v - 1], p, vertices[v + 1 == n ? 0 : v + 1])) {
      return Defect{c, v, "edge folds back on itself (spike)"};
    }
  }
  return std::nullopt;
}

// Contacts between the vertices and edges of the usable contours of one section. Vertices
// are numbered through; edge i starts at vertex i.
class ContactSearch {
 public:
  explicit ContactSearch(const Section& section, const std::vector<bool>& usable) {
    std::vector<Box> boxes;
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
  std::optional<BoxTree> tree_;
};

std::optional<Defect> contour_defect(const Section& section) {
  std::optional<Defect> first;
  std::vector<bool> usable(section.contours.size(), true);
  for (std::size_t c = 0; c < section.contours.size(); ++c) {
    const Contour& contour = section.contours[ContourId(c)];
    std::optional<Defect> defect = whole_contour_defect(contour, c);
    if (defect) {
      usable[c] = false;
    } else if (!first) {
      defect = local_defect(contour, c);
    }
    if (defect && !first) first = std::move(defect);
  }
  std::optional<Defect> contact = ContactSearch(section, usable).first(first);
  return contact ? contact : first;
}

std::string number(double value) {
  char text[40];
  std::snprintf(text, sizeof text, "%.17g", value);
  return text;
}

std::optional<std::string> height_defect(const SectionStack& stack, std::size_t s) {
  const double z = stack.sections[SectionId(s)].z;
  if (const char* reason = coordinate_reason(z)) {
    return std::string("z: ") + reason + " (" + number(z) + ')';
  }
  if (s == 0) return std::nullopt;
  const double below = stack.sections[SectionId(s - 1)].z;
  if (z > below) return std::nullopt;
  return "z does not increase (" + number(z) + " after " + number(below) + ')';
}

Error error_at(const Section& section, std::size_t s, const Defect& defect) {
  Error error{ErrorCode::invalid_input, defect.reason, {}};
  error.where.section = s;
  error.where.contour = defect.contour;
  if (defect.vertex != kWholeContour) {
    const Point2& p = section.contours[ContourId(defect.contour)].vertices[defect.vertex];
    error.where.vertex = defect.vertex;
    error.where.point = Point3{p.x, p.y, section.z};
  }
  return error;
}

}  // namespace

std::size_t SectionStack::contour_count() const {
  std::size_t count = 0;
  for (const Section& section : sections) count += section.contours.size();
  return count;
}

std::size_t SectionStack::vertex_count() const {
  std::size_t count = 0;
  for (const Section& section : sections) {
    for (const Contour& contour : section.contours) count += contour.vertices.size();
  }
  return count;
}

Result<void> validate(const SectionStack& stack) {
  return guard_internal([&]() -> Result<void> {
    if (Result<void> sound = fp_self_check(); !sound) return sound;
    if (stack.sections.empty()) {
      return Error{ErrorCode::invalid_input, "the stack has no section", {}};
    }
    for (std::size_t s = 0; s < stack.sections.size(); ++s) {
      const Section& section = stack.sections[SectionId(s)];
      if (const auto reason = height_defect(stack, s)) {
        Error error{ErrorCode::invalid_input, *reason, {}};
        error.where.section = s;
        return error;
      }
      if (const auto defect = contour_defect(section)) return error_at(section, s, *defect);
    }
    return {};
  });
}

}  // namespace tetloft

// Repair: the region of odd crossing number of contours that are not simple or touch, as
// contours that are and do not.
//
// Of each section the contours that have a contact are taken apart into their arrangement, with
// pieces that lie on each other cancelled in pairs. What is left has even degree everywhere and is
// the boundary of the region.
// At a vertex of degree four or more the boundary would touch itself: pieces of the region are
// parted there, by cutting off corners.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <tetloft/repair.hpp>

#include "core/guard.hpp"
#include "core/option_rules.hpp"
#include "core/parallel.hpp"
#include "core/watched_work.hpp"
#include "sections/arrangement.hpp"
#include "sections/scaling.hpp"
#include "sections/segments.hpp"

namespace tetloft {

using namespace internal;

namespace {

using sections::Arrangement;
using sections::ArrangementPiece;
using sections::NodeId;

class SectionRepair {
 public:
  /// Of the section times 2^exponent: what run() returns is, too; what is told is not.
  SectionRepair(const Section& section, std::size_t number, double distance, int exponent)
      : section_(sections::scaled_in_plane(section, exponent)),
        number_(number),
        distance_(std::ldexp(distance, exponent)),
        exponent_(exponent),
        arrangement_(distance_ / 32, distance_) {}

  Result<Section> run() {
    find_dirty();
    if (std::find(dirty_.begin(), dirty_.end(), true) == dirty_.end()) return section_;
    for_each_edge(true, [&](const Point2& a, const Point2& b, ContourId contour) {
      arrangement_.add_edge(a, b, contour);
    });
    switch (arrangement_.settle()) {
      case Arrangement::Outcome::endless:
        return refusal("splitting its edges where they meet does not end");
      case Arrangement::Outcome::moved_too_far:
        return refusal("a crossing would move by more than the distance allowed");
      case Arrangement::Outcome::settled: break;
    }
    tell_events();
    moved_ = arrangement_.moved();
    connect();
    // Corners cut off too far may reach what is near; each try cuts off less.
    double cut = distance_ - moved_;
    constexpr int kTries = 6;
    for (int k = 0; k < kTries; ++k, cut /= 16) {
      Section repaired = trace(cut);
      SectionStack alone;
      alone.sections.push_back(repaired);
      alone.sections[SectionId(0)].z = 0;
      if (!repaired.contours.empty() && !accepted(validate(alone))) continue;
      if (!touching_.empty()) moved_ += cut;
      tell_parted(cut);
      return repaired;
    }
    return refusal("its contours cannot be parted within the distance allowed");
  }

  [[nodiscard]] double moved() const { return std::ldexp(moved_, -exponent_); }
  [[nodiscard]] std::vector<Warning>& changes() { return changes_; }

 private:
  struct NodeEdges {
    std::vector<std::size_t> pieces;   // all at the node; by angle where it is a touching one
    std::vector<std::size_t> partner;  // partner[k]: place in `pieces` where the boundary goes on
    std::vector<bool> cut;             // cut[k]: the corner of pieces[k] and its partner
  };

  [[nodiscard]] const Point2& at(NodeId n) const { return arrangement_.at(n); }

  Error refusal(const std::string& why) const {
    Error error{ErrorCode::invalid_input, "cannot be repaired: " + why, {}};
    error.where.section = number_;
    for (std::size_t c = 0; c < dirty_.size() && !error.where.contour; ++c) {
      if (dirty_[c]) error.where.contour = c;
    }
    return error;
  }

  void tell(const std::string& message, ContourId contour, std::optional<Point2> p) {
    Warning change{message, {}};
    change.where.section = number_;
    change.where.contour = contour.index();
    if (p) {
      const Point2 at = scaled(*p, -exponent_);
      change.where.point = Point3{at.x, at.y, section_.z};
    }
    changes_.push_back(std::move(change));
  }

  // The contours that take part in a contact, or have no area.
  void find_dirty() {
    struct Edge {
      ContourId contour;
      std::size_t place;
    };
    std::vector<Edge> edges;
    dirty_.assign(section_.contours.size(), false);
    for (std::size_t c = 0; c < section_.contours.size(); ++c) {
      const auto& v = section_.contours[ContourId(c)].vertices;
      for (std::size_t k = 0; k < v.size(); ++k) edges.push_back({ContourId(c), k});
      if (v.size() >= 3) continue;
      dirty_[c] = true;
      tell("contour without area removed", ContourId(c), std::nullopt);
    }
    const auto edge = [&](std::size_t i) {
      const auto& v = section_.contours[edges[i].contour].vertices;
      return std::array<Point2, 2>{v[edges[i].place], v[(edges[i].place + 1) % v.size()]};
    };
    sections::for_each_near_pair(edges.size(), edge, [&](std::size_t i, std::size_t j) {
      const auto [a, b] = edge(i);
      const auto [c, d] = edge(j);
      const std::size_t n = section_.contours[edges[i].contour].vertices.size();
      const bool same = edges[i].contour == edges[j].contour;
      const bool consecutive = same && (edges[i].place + 1 == edges[j].place ||
                                        (edges[i].place == 0 && edges[j].place + 1 == n));
      const bool touch = sections::in_segment(c, d, a) || sections::in_segment(c, d, b) ||
                         sections::in_segment(a, b, c) || sections::in_segment(a, b, d) ||
                         sections::cross(a, b, c, d);
      const bool share = a == c || a == d || b == c || b == d;
      if (!touch && (!share || (consecutive && !(a == c && b == d) && !(a == d && b == c)))) return;
      dirty_[edges[i].contour.index()] = true;
      dirty_[edges[j].contour.index()] = true;
    });
  }

  // Calls edge(a, b, contour) for the contours that are dirty, or for the others.
  template <class Edge>
  void for_each_edge(bool dirty, const Edge& edge) const {
    for (std::size_t c = 0; c < section_.contours.size(); ++c) {
      if (dirty_[c] != dirty) continue;
      const auto& v = section_.contours[ContourId(c)].vertices;
      for (std::size_t k = 0; k < v.size(); ++k) {
        edge(v[k], v[(k + 1) % v.size()], ContourId(c));
      }
    }
  }

  void tell_events() {
    for (const sections::ArrangementEvent& event : arrangement_.events()) {
      const bool crossing = event.kind == sections::ArrangementEvent::Kind::crossing;
      tell(crossing ? "crossing resolved" : "pieces of edges that lie on each other removed",
           event.contour, event.at);
    }
  }

  [[nodiscard]] NodeId other_end(std::size_t piece, NodeId n) const {
    return pieces_[piece].a == n ? pieces_[piece].b : pieces_[piece].a;
  }

  // The pieces at each node, and how the boundary goes on there.
  void connect() {
    // Input order, not that of cancelling, decides where contours begin.
    pieces_ = arrangement_.pieces();
    std::stable_sort(
        pieces_.begin(), pieces_.end(),
        [](const ArrangementPiece& p, const ArrangementPiece& q) { return p.contour < q.contour; });
    edges_at_.resize(arrangement_.node_count());
    for (std::size_t i = 0; i < pieces_.size(); ++i) {
      edges_at_[pieces_[i].a].pieces.push_back(i);
      edges_at_[pieces_[i].b].pieces.push_back(i);
    }
    for (std::size_t k = 0; k < arrangement_.node_count(); ++k) {
      const NodeId n(k);
      NodeEdges& here = edges_at_[n];
      const std::size_t m = here.pieces.size();
      TETLOFT_CHECK(m % 2 == 0);
      here.partner.assign(m, 0);
      here.cut.assign(m, false);
      if (m == 2) here.partner = {1, 0};
      if (m > 2) part(n, here);
    }
  }

  // Directions around a node start at −x and turn counter-clockwise.
  [[nodiscard]] int sector(NodeId n, NodeId to) const {
    const Point2& p = at(n);
    const Point2& q = at(to);
    if (q.y == p.y) return q.x < p.x ? 0 : 2;
    return q.y < p.y ? 1 : 3;
  }

  // Pairs the pieces that bound a wedge of the region; all but one wedge lose their corner.
  void part(NodeId n, NodeEdges& here) {
    touching_.push_back(n);
    std::sort(here.pieces.begin(), here.pieces.end(), [&](std::size_t i, std::size_t j) {
      const NodeId u = other_end(i, n);
      const NodeId v = other_end(j, n);
      if (sector(n, u) != sector(n, v)) return sector(n, u) < sector(n, v);
      return orient2d(at(n), at(u), at(v)) == Sign::positive;
    });
    const std::size_t m = here.pieces.size();
    // The wedge from the last piece to the first contains the direction just above −x.
    const std::size_t first = is_inside_above_left(n) ? m - 1 : 0;
    // A wedge of a half turn or more keeps its corner: cut off, it would reach into the others.
    std::size_t whole = first;
    for (std::size_t k = 0; k < m / 2; ++k) {
      const std::size_t i = (first + 2 * k) % m;
      const std::size_t j = (i + 1) % m;
      here.partner[i] = j;
      here.partner[j] = i;
      here.cut[i] = here.cut[j] = true;
      const Sign turn =
          orient2d(at(n), at(other_end(here.pieces[i], n)), at(other_end(here.pieces[j], n)));
      if (turn != Sign::positive) whole = i;
    }
    here.cut[whole] = here.cut[here.partner[whole]] = false;
  }

  // Is a point infinitely near the node, in the direction just above −x, in the region? By the
  // edges that a ray from there crosses; those at the node are not.
  [[nodiscard]] bool is_inside_above_left(NodeId n) const {
    const Point2& p = at(n);
    bool inside = false;
    const auto count = [&](const Point2& a, const Point2& b) {
      const Point2& low = a.y <= b.y ? a : b;
      const Point2& high = a.y <= b.y ? b : a;
      if (!(low.y <= p.y && p.y < high.y) || low == p || high == p) return;
      if (orient2d(low, high, p) == Sign::negative) inside = !inside;
    };
    for (const ArrangementPiece& piece : pieces_) count(at(piece.a), at(piece.b));
    for_each_edge(false, [&](const Point2& a, const Point2& b, ContourId) { count(a, b); });
    return inside;
  }

  // The point of the piece near its node, `cut` away or a quarter of it.
  [[nodiscard]] Point2 near_node(NodeId n, std::size_t piece, double cut) const {
    const Point2& p = at(n);
    const Point2& q = at(other_end(piece, n));
    const double t = std::min(0.25, cut / std::hypot(q.x - p.x, q.y - p.y));
    return {p.x + t * (q.x - p.x), p.y + t * (q.y - p.y)};
  }

  // The section with its boundary as contours: those without contact where they were, pieces
  // at the place of the contour they begin with.
  [[nodiscard]] Section trace(double cut) const {
    std::vector<std::pair<std::size_t, Contour>> contours;
    for (std::size_t c = 0; c < section_.contours.size(); ++c) {
      if (!dirty_[c]) contours.emplace_back(c, section_.contours[ContourId(c)]);
    }
    std::vector<bool> done(pieces_.size(), false);
    for (std::size_t start = 0; start < pieces_.size(); ++start) {
      if (done[start]) continue;
      Contour contour;
      std::size_t piece = start;
      NodeId n = pieces_[start].b;
      do {
        done[piece] = true;
        const NodeEdges& here = edges_at_[n];
        const auto in = static_cast<std::size_t>(
            std::find(here.pieces.begin(), here.pieces.end(), piece) - here.pieces.begin());
        const std::size_t next = here.pieces[here.partner[in]];
        if (here.cut[in]) {
          contour.vertices.push_back(near_node(n, piece, cut));
          contour.vertices.push_back(near_node(n, next, cut));
        } else {
          contour.vertices.push_back(at(n));
        }
        piece = next;
        n = other_end(piece, n);
      } while (piece != start);
      contours.emplace_back(pieces_[start].contour.index(), std::move(contour));
    }
    std::stable_sort(contours.begin(), contours.end(),
                     [](const auto& a, const auto& b) { return a.first < b.first; });
    Section repaired;
    repaired.z = section_.z;
    for (auto& [origin, contour] : contours) repaired.contours.push_back(std::move(contour));
    return repaired;
  }

  void tell_parted(double cut) {
    for (const NodeId n : touching_) {
      char text[80];
      std::snprintf(text, sizeof text, "contact parted by cutting corners off, %.3g deep at most",
                    std::ldexp(cut, -exponent_));
      tell(text, pieces_[edges_at_[n].pieces.front()].contour, at(n));
    }
  }

  Section section_;
  std::size_t number_;
  double distance_;
  int exponent_;
  double moved_ = 0;
  std::vector<bool> dirty_;  // by contour
  Arrangement arrangement_;
  std::vector<ArrangementPiece> pieces_;
  IdVector<NodeId, NodeEdges> edges_at_;
  std::vector<NodeId> touching_;
  std::vector<Warning> changes_;
};

double extent(const Section& section) {
  double largest = 0;
  for (const Contour& contour : section.contours) {
    for (const Point2& p : contour.vertices) {
      largest = std::max({largest, std::abs(p.x), std::abs(p.y)});
    }
  }
  return largest;
}

// The first coordinate that is not usable is left to validate() to name.
bool is_usable(const Section& section) {
  return extent(section) < kLargestCoordinate &&
         std::all_of(section.contours.begin(), section.contours.end(), [](const Contour& c) {
           return std::all_of(c.vertices.begin(), c.vertices.end(), [](const Point2& p) {
             return std::isfinite(p.x) && std::isfinite(p.y);
           });
         });
}

// In a unit of length of its own, unless what is made has finer bits than the one given.
Result<Section> repair_section(const Section& section, std::size_t number, double distance,
                               Repaired& result) {
  UnitOfLength unit;
  for (const Contour& contour : section.contours) {
    for (const Point2& p : contour.vertices) unit.include(p);
  }
  unit.include(distance);
  for (const int exponent : {unit.exponent(), 0}) {
    SectionRepair repair(section, number, distance, exponent);
    Result<Section> repaired = repair.run();
    if (!repaired) return repaired;
    const bool exact = std::all_of(
        repaired->contours.begin(), repaired->contours.end(), [&](const Contour& contour) {
          return std::all_of(contour.vertices.begin(), contour.vertices.end(),
                             [&](const Point2& p) { return is_scaled_exactly(p, -exponent); });
        });
    if (!exact) continue;
    result.moved = std::max(result.moved, repair.moved());
    result.changes.insert(result.changes.end(), repair.changes().begin(), repair.changes().end());
    return sections::scaled_in_plane(*repaired, -exponent);
  }
  TETLOFT_CHECK(false);
}

Result<Repaired> repair_all(const SectionStack& stack, const RepairOptions& options) {
  if (options.distance) {
    const Result<void> good = check_length(*options.distance, "the repair distance");
    if (!good) return good.error();
  }
  WatchedWork work(options.execution, stack.sections.size() + 1);
  Repaired result;
  result.stack = stack;
  result.changes = mend(result.stack);
  for (std::size_t s = 0; s < stack.sections.size(); ++s) {
    work.go_on();
    Section& section = result.stack.sections[SectionId(s)];
    if (is_usable(section)) {
      const double distance = options.distance.value_or(0x1p-20 * extent(section));
      Result<Section> repaired = repair_section(section, s, distance, result);
      if (!repaired) return repaired.error();
      section = std::move(repaired.value());
    }
    work.step_done();
  }
  // Where contours cancel nothing may be left, which only who wants a solid must refuse.
  const bool nothing_left = result.stack.contour_count() == 0 && stack.contour_count() > 0;
  if (!nothing_left) {
    const Result<void> valid = validate(result.stack, untold(options.execution));
    if (!valid) return valid.error();
  }
  work.step_done();
  return result;
}

}  // namespace

Result<Repaired> repair(const SectionStack& stack, const RepairOptions& given) {
  return guard_threads(given,
                       [&](const RepairOptions& options) { return repair_all(stack, options); });
}

}  // namespace tetloft

#include "completion/passages.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <deque>

#include "core/flow_network.hpp"
#include "core/guard.hpp"
#include "core/sort_distinct.hpp"

namespace tetloft::internal {

namespace {

constexpr unsigned kFourCorners = 0xF;
constexpr std::uint32_t kNowhere = 0xFFFFFFFFU;

[[nodiscard]] constexpr unsigned corners_of_face(int i) { return kFourCorners & ~(1U << i); }

}  // namespace

// The network of one part: a node on either side of each tet, and arcs that say what it takes to
// close a tet, a face between two, or what a tet shares with a plane.
class PassageCut {
 public:
  PassageCut(const Passages& passages, const std::vector<TetId>& part, VoidClassId from)
      : passages_(passages), part_(part), from_(from), network_(2 * part.size() + 2) {
    find_prices();
    for (std::uint32_t k = 0; k < part_.size(); ++k) {
      const TetId t = part_[k];
      add(in(k), out(k), t, kFourCorners);
      for (int i = 0; i < 4; ++i) {
        const TetId across = space().next(t, i);
        if (across.valid()) add_face(k, i, passages_.place_[across]);
      }
      space().for_each_contact(t, [&](const VoidContact& contact) {
        const bool source = space().voids().class_of(contact.with) == from_;
        add(source ? kSource() : out(k), source ? in(k) : kSink(), t, contact.corners);
      });
    }
  }

  // The walls of the least cut; or nothing if there is none, and a void that cannot be parted from
  // the class.
  struct Outcome {
    std::vector<Wall> walls;
    std::optional<Inseparable> inseparable;
  };
  [[nodiscard]] Outcome find() {
    const std::vector<bool> reached = network_.uncuttably_reached(kSource());
    Outcome outcome;
    if (reached[kSink()]) {
      outcome.inseparable = inseparable(reached);
      return outcome;
    }
    for (const std::size_t arc : network_.least_cut(kSource(), kSink())) {
      const auto& [tet, corners] = closing_[arc];
      const ClassId c =
          passages_.classes_.of(passages_.slab_.vertex(tet, std::countr_zero(corners)));
      outcome.walls.push_back({tet, static_cast<std::uint8_t>(corners), c});
    }
    return outcome;
  }

 private:
  using Node = FlowNetwork::Node;
  struct Closing {
    TetId tet;
    unsigned corners;
  };

  [[nodiscard]] const VoidSpace& space() const { return passages_.space_; }
  [[nodiscard]] static Node in(std::uint32_t k) { return 2 * k; }
  [[nodiscard]] static Node out(std::uint32_t k) { return 2 * k + 1; }
  [[nodiscard]] Node kSource() const { return static_cast<Node>(2 * part_.size()); }
  [[nodiscard]] Node kSink() const { return kSource() + 1; }

  // Prices are half the area of a tet's open faces, as integers that add up exactly.
  void find_prices() {
    std::vector<double> area;
    area.reserve(part_.size());
    double largest = 0;
    for (const TetId t : part_) {
      area.push_back(passages_.open_area(t));
      largest = std::max(largest, area.back());
    }
    price_.reserve(part_.size());
    for (const double a : area) {
      const double share = largest > 0 ? a / largest : 0;
      price_.push_back(static_cast<FlowNetwork::Amount>(share * 0x1p34) + 1);
    }
  }

  [[nodiscard]] bool can_close(TetId t, unsigned corners) const {
    if (passages_.is_protected_[t] != 0 || !space().of_one_class(t, corners)) return false;
    return passages_.active_[passages_.classes_.of(
               passages_.slab_.vertex(t, std::countr_zero(corners)))] != 0;
  }

  void add(Node from, Node to, TetId t, unsigned corners) {
    closing_.push_back({t, corners});
    network_.add_arc(
        from, to, can_close(t, corners) ? price_[passages_.place_[t]] : FlowNetwork::kUncuttable);
  }

  // Either tet may close the face between: the cheaper one, then the first.
  void add_face(std::uint32_t k, int i, std::uint32_t other) {
    const TetId t = part_[k];
    const TetId across = part_[other];
    const HalfFaceId h = passages_.slab_.mesh().opposite(TetMesh::half_face(t, i));
    const bool theirs = std::pair(price_[other], across) < std::pair(price_[k], t);
    if (passages_.is_protected_[t] != 0 && passages_.is_protected_[across] != 0) {
      closing_.push_back({t, 0});
      network_.add_arc(out(k), in(other), FlowNetwork::kUncuttable);
    } else if ((theirs && passages_.is_protected_[across] == 0) ||
               passages_.is_protected_[t] != 0) {
      add(out(k), in(other), across, corners_of_face(TetMesh::face_of(h)));
    } else {
      add(out(k), in(other), t, corners_of_face(i));
    }
  }

  // The lowest void of the class, and the lowest that cannot be parted from it.
  [[nodiscard]] Inseparable inseparable(const std::vector<bool>& reached) const {
    Inseparable pair;
    for (std::uint32_t k = 0; k < part_.size(); ++k) {
      space().for_each_contact(part_[k], [&](const VoidContact& contact) {
        const bool own = space().voids().class_of(contact.with) == from_;
        if (!own && (!reached[out(k)] || can_close(contact.tet, contact.corners))) return;
        SlabVoidId& lowest = pair[own ? 0 : 1];
        if (!lowest.valid() || contact.with < lowest) lowest = contact.with;
      });
    }
    return pair;
  }

  const Passages& passages_;
  const std::vector<TetId>& part_;
  VoidClassId from_;
  FlowNetwork network_;
  std::vector<FlowNetwork::Amount> price_;  // by place in the part
  std::vector<Closing> closing_;            // by arc
};

Passages::Passages(const Slab& slab, const SlabClasses& classes,
                   const IdVector<ClassId, std::uint8_t>& active, const SlabVoids& voids,
                   Completion& completion)
    : slab_(slab),
      classes_(classes),
      active_(active),
      voids_(voids),
      completion_(completion),
      space_(slab, classes, voids, completion.complex()),
      place_(slab.tet_count(), kNowhere),
      is_protected_(slab.tet_count(), 0) {}

std::optional<Inseparable> Passages::close() {
  if (voids_.class_count() < 2) return std::nullopt;
  // Tets that hung together; walls only part them further.
  std::deque<std::vector<TetId>> parts;
  IdVector<TetId, std::uint8_t> seen(slab_.tet_count(), 0);
  for (const TetId t : slab_.tets()) {
    if (seen[t] != 0 || !space_.is_void(t)) continue;
    parts.push_back(space_.part_of(t, seen));
    if (classes_at(parts.back()).size() < 2) parts.pop_back();
  }
  while (!parts.empty()) {
    std::vector<TetId> before = std::move(parts.front());
    parts.pop_front();
    std::sort(before.begin(), before.end());
    for (const TetId t : before) seen[t] = 0;
    for (const TetId t : before) {
      if (seen[t] != 0 || !space_.is_void(t)) continue;
      std::vector<TetId> part = space_.part_of(t, seen);
      const std::vector<VoidClassId> at = classes_at(part);
      if (at.size() < 2) continue;
      std::sort(part.begin(), part.end());
      if (auto stuck = part_off(part, at.back())) return stuck;
      ++closed_;
      parts.push_back(std::move(part));
    }
  }
  return std::nullopt;
}

std::vector<VoidClassId> Passages::classes_at(const std::vector<TetId>& part) const {
  std::vector<VoidClassId> at;
  for (const TetId t : part) {
    space_.for_each_contact(t, [&](const VoidContact& contact) {
      const VoidClassId c = voids_.class_of(contact.with);
      if (std::find(at.begin(), at.end(), c) == at.end()) at.push_back(c);
    });
  }
  std::sort(at.begin(), at.end());
  return at;
}

// Walls between the class and all others. What links its voids and those of others with each other
// stays open if that is possible.
std::optional<Inseparable> Passages::part_off(const std::vector<TetId>& part, VoidClassId from) {
  for (std::uint32_t k = 0; k < part.size(); ++k) place_[part[k]] = k;
  std::optional<Inseparable> stuck;
  for (const Protect protect : {Protect::linked, Protect::nothing}) {
    if (protect == Protect::linked) protect_linked(part);
    const PassageCut::Outcome outcome = PassageCut(*this, part, from).find();
    for (const TetId t : part) is_protected_[t] = 0;
    stuck = outcome.inseparable;
    if (stuck) continue;
    completion_.build(outcome.walls);
    for (const Wall& wall : outcome.walls) {
      TETLOFT_CHECK(space_.is_closed(wall.tet, wall.corners));
    }
    break;
  }
  for (const TetId t : part) place_[t] = kNowhere;
  return stuck;
}

void Passages::protect_linked(const std::vector<TetId>& part) {
  for (const VoidClassId c : classes_at(part)) protect_class(part, c);
}

// The tets of shortest paths from the lowest void of a class to each other that the part touches.
void Passages::protect_class(const std::vector<TetId>& part, VoidClassId c) {
  SlabVoidId lowest;
  const auto of_class = [&](TetId t, const auto& visit) {
    space_.for_each_contact(t, [&](const VoidContact& contact) {
      if (voids_.class_of(contact.with) == c) visit(contact.with);
    });
  };
  for (const TetId t : part) {
    of_class(t, [&](SlabVoidId v) { lowest = lowest.valid() ? std::min(lowest, v) : v; });
  }
  std::vector<std::uint32_t> from(part.size(), kNowhere);
  std::vector<std::uint32_t> order;
  for (std::uint32_t k = 0; k < part.size(); ++k) {
    of_class(part[k], [&](SlabVoidId v) {
      if (v != lowest || from[k] != kNowhere) return;
      from[k] = k;
      order.push_back(k);
    });
  }
  std::vector<SlabVoidId> met{lowest};
  for (std::size_t at = 0; at < order.size(); ++at) {
    const std::uint32_t k = order[at];
    of_class(part[k], [&](SlabVoidId v) {
      if (std::find(met.begin(), met.end(), v) != met.end()) return;
      met.push_back(v);
      for (std::uint32_t back = k;; back = from[back]) {
        is_protected_[part[back]] = 1;
        if (from[back] == back) break;
      }
    });
    for (int i = 0; i < 4; ++i) {
      const TetId across = space_.next(part[k], i);
      if (!across.valid() || from[place_[across]] != kNowhere) continue;
      from[place_[across]] = k;
      order.push_back(place_[across]);
    }
  }
}

// Half of that of the faces across which the tet hangs together with something.
double Passages::open_area(TetId t) const {
  double area = 0;
  for (int i = 0; i < 4; ++i) {
    if (space_.next(t, i).valid()) area += face_area(t, i);
  }
  space_.for_each_contact(t, [&](const VoidContact& contact) {
    if (std::popcount(unsigned{contact.corners}) != 3) return;
    area += face_area(t, std::countr_zero(kFourCorners & ~unsigned{contact.corners}));
  });
  return area / 2;
}

double Passages::face_area(TetId t, int face) const {
  std::array<Point3, 3> p;
  for (std::size_t i = 0; i < 3; ++i) {
    p[i] = slab_.point(slab_.vertex(t, kFaceVertex[static_cast<std::size_t>(face)][i]));
  }
  const Point3 u{p[1].x - p[0].x, p[1].y - p[0].y, p[1].z - p[0].z};
  const Point3 v{p[2].x - p[0].x, p[2].y - p[0].y, p[2].z - p[0].z};
  const double x = u.y * v.z - u.z * v.y;
  const double y = u.z * v.x - u.x * v.z;
  const double z = u.x * v.y - u.y * v.x;
  return std::sqrt(x * x + y * y + z * z) / 2;
}

}  // namespace tetloft::internal

#include "reconstruct/embedding.hpp"

#include <algorithm>
#include <cmath>

#include <tetloft/predicates.hpp>

#include "core/check.hpp"
#include "core/cpu_clock.hpp"
#include "reconstruct/cut_squeezing.hpp"

namespace tetloft {

namespace {

// Every round halves what is at fault; after this many nothing is left of a double.
constexpr int kRounds = 200;
// A cut nearer to its kept corner than this share of its first distance is useless.
constexpr double kSmallestCut = 0x1p-30;
// A cut that has come this near is not what is at fault.
constexpr double kStubborn = 0x1p-3;

void sort_unique(std::vector<std::size_t>& items) {
  std::sort(items.begin(), items.end());
  items.erase(std::unique(items.begin(), items.end()), items.end());
}

}  // namespace

Embedding::Embedding(const Slab& slab, const SlabClasses& classes, const Subdivision& subdivision,
                     Lifting& lifting, Truncation& truncation, std::vector<LoneEnd>& lone,
                     RuleCounts& rules)
    : slab_(slab),
      classes_(classes),
      subdivision_(subdivision),
      truncation_(truncation),
      lone_(lone),
      rules_(rules),
      lifting_(lifting),
      first_cut_(slab.vertex_count() + subdivision.lifted.size()),
      first_cap_(first_cut_ + truncation.cuts.size()),
      pieces_(truncation.pieces) {
  add_prisms();
  collect_boundary();
}

void Embedding::add_prisms() {
  for (const bool upper : {false, true}) {
    const ConformingSection& section = upper ? slab_.upper() : slab_.lower();
    const std::size_t first_base = upper ? slab_.lower().vertex_count() : 0;
    const auto triangles = triangles_by_region(section);
    const auto vertices = vertices_by_region(section);
    for (std::size_t k = 0; k < lone_.size(); ++k) {
      const SlabRegionId region = lone_[k].region;
      if (!lone_[k].is_prism() || classes_.is_upper(region) != upper) continue;
      const RegionId r = classes_.in_section(region);
      extrude(section, triangles[r], vertices[r], region, first_base, first_cap_ + caps_.size(),
              !upper, pieces_);
      for (const VertexId v : vertices[r]) caps_.push_back({VertexId(first_base + v.index()), k});
    }
  }
}

// The faces that one piece alone has, oriented outwards, by their sorted nodes. Faces are put
// into the bucket of their lowest node, and buckets are no larger than stars: near-linear.
void Embedding::collect_boundary() {
  struct Face {
    VertexId middle, high;
    std::uint32_t half_face;
  };
  const auto oriented = [&](std::size_t h) {
    const auto& f = kFaceVertex[h % 4];
    const auto& node = pieces_[h / 4].node;
    return TriangleVertices{node[static_cast<std::size_t>(f[0])],
                            node[static_cast<std::size_t>(f[1])],
                            node[static_cast<std::size_t>(f[2])]};
  };
  const std::size_t face_count = 4 * pieces_.size();
  std::vector<std::uint32_t> first(first_cap_ + caps_.size() + 1, 0);
  for (std::size_t h = 0; h < face_count; ++h) {
    const TriangleVertices t = oriented(h);
    ++first[std::min({t[0], t[1], t[2]}).index() + 1];
  }
  for (std::size_t v = 1; v < first.size(); ++v) first[v] += first[v - 1];
  std::vector<Face> faces(face_count);
  std::vector<std::uint32_t> next(first.begin(), first.end() - 1);
  for (std::size_t h = 0; h < face_count; ++h) {
    TriangleVertices t = oriented(h);
    std::sort(t.begin(), t.end());
    faces[next[t[0].index()]++] = {t[1], t[2], static_cast<std::uint32_t>(h)};
  }
  const auto same = [](const Face& a, const Face& b) {
    return a.middle == b.middle && a.high == b.high;
  };
  for (std::size_t v = 0; v + 1 < first.size(); ++v) {
    const std::size_t end = first[v + 1];
    std::sort(faces.begin() + first[v], faces.begin() + first[v + 1],
              [](const Face& a, const Face& b) {
                return a.middle != b.middle ? a.middle < b.middle : a.high < b.high;
              });
    for (std::size_t i = first[v]; i < end;) {
      std::size_t j = i + 1;
      while (j < end && same(faces[i], faces[j])) ++j;
      TETLOFT_CHECK(j - i <= 2);
      if (j - i == 1) boundary_.push_back(oriented(faces[i].half_face));
      i = j;
    }
  }
}

PointOrigin Embedding::origin(std::size_t node) const {
  if (node < first_cut_) return PointOrigin::lifted;
  return node < first_cap_ ? PointOrigin::cut : PointOrigin::cap;
}

void Embedding::place() {
  points_ = lifting_.points();
  points_.reserve(first_cap_ + caps_.size());
  for (const Cut& cut : truncation_.cuts) {
    points_.push_back(
        place_cut(cut, points_[cut.kept.index()], points_[cut.away.index()], slab_.gap()));
  }
  for (const Cap& cap : caps_) {
    Point3 p = slab_.point(cap.of);
    const double towards = slab_.is_upper(cap.of) ? slab_.lower().z : slab_.upper().z;
    double height = 0.5;
    for (int l = 0; l < lone_[cap.lone].level; ++l) height *= 0.5;
    p.z += height * (towards - p.z);
    points_.push_back(p);
  }
}

void Embedding::squeeze_bad_cuts() {
  std::vector<std::size_t> bad;
  for (std::size_t k = 0; k < truncation_.pieces.size(); ++k) {
    const Piece& piece = truncation_.pieces[k];
    if (!is_positive(piece)) bad.push_back(k);
  }
  if (bad.empty()) return;
  squeeze_cuts(
      points_, first_cut_, classes_, subdivision_, truncation_, bad,
      {std::nextafter(slab_.lower().z, HUGE_VAL), std::nextafter(slab_.upper().z, -HUGE_VAL)});
}

bool Embedding::is_positive(const Piece& piece) const {
  const auto& [a, b, c, d] = piece.node;
  return orient3d(points_[a.index()], points_[b.index()], points_[c.index()], points_[d.index()]) ==
         Sign::positive;
}

void Embedding::blame_node(VertexId node, Blame& blame) const {
  const std::size_t k = node.index();
  if (k < slab_.vertex_count()) return;
  if (k < first_cut_) {
    blame.lifted.push_back(k - slab_.vertex_count());
  } else if (k < first_cap_) {
    blame.cuts.push_back(k - first_cut_);
  } else {
    blame.prisms.push_back(caps_[k - first_cap_].lone);
  }
}

Embedding::Blame Embedding::find_fault() {
  Blame blame;
  // Rounding must not have put anything into a section plane.
  for (std::size_t k = slab_.vertex_count(); k < points_.size(); ++k) {
    if (slab_.lower().z < points_[k].z && points_[k].z < slab_.upper().z) continue;
    at_ = points_[k];
    blame_node(VertexId(k), blame);
  }
  work_ += pieces_.size();
  for (const Piece& piece : pieces_) {
    if (is_positive(piece)) continue;
    at_ = points_[piece.node[0].index()];
    for (const VertexId v : piece.node) blame_node(v, blame);
  }
  if (!blame.empty()) return blame;

  const WorkStopwatch watch;
  const std::vector<Contact> contacts = boundary_contacts();
  contact_seconds_ += watch.seconds();
  for (const Contact& contact : contacts) {
    at_ = points_[boundary_[contact.first][0].index()];
    Blame pair;
    for (const VertexId v : boundary_[contact.first]) blame_node(v, pair);
    for (const VertexId v : boundary_[contact.second]) blame_node(v, pair);
    // A prism gives way before anything else does.
    if (pair.prisms.empty()) {
      blame.lifted.insert(blame.lifted.end(), pair.lifted.begin(), pair.lifted.end());
      blame.cuts.insert(blame.cuts.end(), pair.cuts.begin(), pair.cuts.end());
      TETLOFT_CHECK(!pair.empty());
    }
    blame.prisms.insert(blame.prisms.end(), pair.prisms.begin(), pair.prisms.end());
  }
  return blame;
}

// All contacts of the boundary. Of triangles without a constructed node no two are in contact
// (embedding.hpp, lemma); and once looked for, a pair that had none cannot have got one
// unless a vertex of it moved.
std::vector<Contact> Embedding::boundary_contacts() {
  std::vector<std::uint8_t> active;
  if (tested_.empty()) {
    active.resize(boundary_.size());
    const auto constructed = [&](VertexId v) { return v.index() >= slab_.vertex_count(); };
    for (std::size_t k = 0; k < boundary_.size(); ++k) {
      const TriangleVertices& t = boundary_[k];
      active[k] = constructed(t[0]) || constructed(t[1]) || constructed(t[2]) ? 1 : 0;
    }
  } else {
    active = std::move(in_contact_);
    const auto moved = [&](VertexId v) { return points_[v.index()] != tested_[v.index()]; };
    for (std::size_t k = 0; k < boundary_.size(); ++k) {
      const TriangleVertices& t = boundary_[k];
      if (moved(t[0]) || moved(t[1]) || moved(t[2])) active[k] = 1;
    }
  }
  std::vector<Contact> contacts =
      find_contacts(points_, boundary_, static_cast<std::size_t>(-1), active, &work_);
  tested_ = points_;
  in_contact_.assign(boundary_.size(), 0);
  for (const Contact& contact : contacts)
    in_contact_[contact.first] = in_contact_[contact.second] = 1;
  return contacts;
}

Embedding::Outcome Embedding::give_way(Blame blame) {
  sort_unique(blame.cuts);
  sort_unique(blame.prisms);
  bool truncated = false;
  for (const std::size_t k : blame.prisms) {
    ++lone_[k].level;
    truncated = truncated || !lone_[k].is_prism();
  }
  if (truncated) return Outcome::more_truncated;
  for (const std::size_t k : blame.cuts) {
    Cut& cut = truncation_.cuts[k];
    count(rules_, Rule::moved_cut);
    cut.scale *= 0.5;
    if (cut.scale < kSmallestCut) return Outcome::failed;
    // A cut lies on the line of its edge: where coming nearer does not help, the edge's
    // lifted ends are at fault.
    if (cut.scale <= kStubborn) {
      blame_node(cut.kept, blame);
      blame_node(cut.away, blame);
    }
  }
  sort_unique(blame.lifted);
  for (const std::size_t k : blame.lifted) {
    count(rules_, Rule::halved_lift);
    if (!lifting_.halve(k)) {
      at_ = lifting_.at();
      return Outcome::failed;
    }
  }
  return Outcome::embedded;
}

Embedding::Outcome Embedding::settle() {
  for (int round = 0; round < kRounds; ++round) {
    if (!lifting_.settle(rules_)) {
      at_ = lifting_.at();
      return Outcome::failed;
    }
    place();
    squeeze_bad_cuts();
    Blame blame = find_fault();
    if (blame.empty()) return Outcome::embedded;
    const Outcome outcome = give_way(std::move(blame));
    if (outcome != Outcome::embedded) return outcome;
  }
  return Outcome::failed;
}

}  // namespace tetloft

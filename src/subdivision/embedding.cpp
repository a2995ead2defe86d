#include "subdivision/embedding.hpp"

#include <algorithm>
#include <cmath>

#include <tetloft/predicates.hpp>

#include "core/cpu_clock.hpp"
#include "core/guard.hpp"
#include "core/sort_distinct.hpp"
#include "mesh/face_groups.hpp"
#include "subdivision/cut_squeezing.hpp"

namespace tetloft::internal {

namespace {

// Every round halves what is at fault, so this ends what smaller bounds do not: kSmallestLift
// allows 35 halvings of a vertex on its way to each target, kSmallestCut 30 of a cut. A guard, well
// above what one fault after another at the same nodes takes; neither 100 nor 400 changes a sample.
constexpr int kRounds = 200;
// A cut nearer to its kept corner than this share of its first distance is useless. A choice: what
// is left of a first distance of one gap is then 2^22 ulps of it, and halving has failed 30 times.
constexpr double kSmallestCut = 0x1p-30;
// A cut that has come this near is not what is at fault. A choice: three halvings are given to a
// cut alone, before they cost lift as well.
constexpr double kStubborn = 0x1p-3;

}  // namespace

Embedding::Embedding(const Slab& slab, const SlabClasses& classes, const Complex& complex,
                     const Subdivision& subdivision, Lifting& lifting, Truncation& truncation,
                     std::vector<LoneEnd>& lone, RuleCounts& rules)
    : slab_(slab),
      classes_(classes),
      complex_(complex),
      subdivision_(subdivision),
      truncation_(truncation),
      lone_(lone),
      rules_(rules),
      lifting_(lifting),
      nodes_(truncation.nodes),
      pieces_(truncation.pieces) {
  add_prisms();
  collect_boundary();
}

void Embedding::add_prisms() {
  for (const bool upper : {false, true}) {
    const ConformingSection& section = slab_.section(upper);
    const bool any = std::any_of(lone_.begin(), lone_.end(), [&](const LoneEnd& end) {
      return end.is_prism() && classes_.regions().is_upper(end.region) == upper;
    });
    if (!any) continue;
    const auto triangles = triangles_by_region(section);
    const auto vertices = vertices_by_region(section);
    for (std::size_t k = 0; k < lone_.size(); ++k) {
      const SlabRegionId region = lone_[k].region;
      if (!lone_[k].is_prism() || classes_.regions().is_upper(region) != upper) continue;
      const RegionId r = classes_.regions().in_section(region);
      extrude(section, triangles[r], vertices[r], region,
              {slab_.numbering(), upper, nodes_, caps_.end_id()}, pieces_);
      for (const PlaneVertexId v : vertices[r])
        caps_.push_back({slab_.numbering().in_slab(upper, v), k});
    }
  }
}

// Whole tets know from D which of their faces another one has, or nothing; only faces towards a
// tet that was split or cut are matched with those of all other pieces.
void Embedding::collect_boundary() {
  struct Matched {
    std::array<NodeId, 4> node;
    TetId whole;  // invalid: a piece
  };
  std::vector<Matched> matched;
  for (const Piece& piece : pieces_) matched.push_back({piece.node, TetId()});
  for (const TetId t : slab_.tets()) {
    if (subdivision_.whole[t] == 0) continue;
    const std::array<NodeId, 4> node = Nodes::of(slab_.vertices(t));
    bool matches = false;
    for (int i = 0; i < 4; ++i) {
      const TetId across = slab_.mesh().neighbour(t, i);
      if (!across.valid() || complex_.attached[across] == 0) {
        add_to_boundary(node, i);
      } else {
        matches = matches || subdivision_.whole[across] == 0;
      }
    }
    if (matches) matched.push_back({node, t});
  }
  const auto node = [&](std::size_t k) -> const std::array<NodeId, 4>& { return matched[k].node; };
  mesh_detail::for_each_boundary_face(
      nodes_.size_without_caps() + caps_.size(), matched.size(), node, mesh_detail::kAllSound,
      [&](HalfFaceId h) {
        const std::size_t k = TetMesh::tet_of(h).index();
        const TetId whole = matched[k].whole;
        if (whole.valid() && !may_meet_pieces(whole, TetMesh::face_of(h))) return;
        add_to_boundary(node(k), TetMesh::face_of(h));
      });
}

// Is there a tet across that is attached and not whole?
bool Embedding::may_meet_pieces(TetId t, int face) const {
  const TetId across = slab_.mesh().neighbour(t, face);
  return across.valid() && complex_.attached[across] != 0 && subdivision_.whole[across] == 0;
}

void Embedding::add_to_boundary(const std::array<NodeId, 4>& tet, int face) {
  const auto [a, b, c] = face_of(tet, face);
  boundary_.push_back({VertexId(a.value()), VertexId(b.value()), VertexId(c.value())});
}

std::vector<Piece> Embedding::all_pieces() const {
  std::vector<Piece> all;
  const auto whole = std::count(subdivision_.whole.begin(), subdivision_.whole.end(), 1);
  all.reserve(static_cast<std::size_t>(whole) + pieces_.size());
  std::size_t next = 0;
  for (const TetId t : slab_.tets()) {
    if (subdivision_.whole[t] != 0) {
      const SlabRegionId region = classes_.regions(classes_.of(slab_.vertex(t, 0))).front();
      const auto& [i, j, k, l] = corners_by_plane(slab_.upper_corners(t));
      all.push_back({Nodes::of({slab_.vertex(t, i), slab_.vertex(t, j), slab_.vertex(t, k),
                                slab_.vertex(t, l)}),
                     region, slab_.kind(t)});
      continue;
    }
    while (next < truncation_.parent.size() && truncation_.parent[next] == t) {
      all.push_back(pieces_[next++]);
    }
  }
  all.insert(all.end(), pieces_.begin() + static_cast<std::ptrdiff_t>(next), pieces_.end());
  return all;
}

PointOrigin Embedding::origin(NodeId node) const {
  if (nodes_.is_lifted(node)) return PointOrigin::lifted;
  return nodes_.is_cut(node) ? PointOrigin::cut : PointOrigin::cap;
}

void Embedding::place() {
  points_ = lifting_.points();
  points_.reserve(nodes_.size_without_caps() + caps_.size());
  for (const Cut& cut : truncation_.cuts) {
    points_.push_back(place_cut(cut, points_[cut.kept], points_[cut.away], slab_.gap()));
  }
  for (const Cap& cap : caps_) {
    Point3 p = slab_.point(cap.of);
    const double towards = slab_.section(!slab_.is_upper(cap.of)).z;
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
      points_, classes_, subdivision_, truncation_, bad,
      {std::nextafter(slab_.lower().z, HUGE_VAL), std::nextafter(slab_.upper().z, -HUGE_VAL)});
}

bool Embedding::is_positive(const Piece& piece) const {
  const auto& [a, b, c, d] = piece.node;
  return orient3d(points_[a], points_[b], points_[c], points_[d]) == Sign::positive;
}

void Embedding::blame_node(NodeId node, Blame& blame) const {
  if (nodes_.is_slab_vertex(node)) return;
  if (nodes_.is_lifted(node)) {
    blame.lifted.push_back(nodes_.lifted(node));
  } else if (nodes_.is_cut(node)) {
    blame.cuts.push_back(nodes_.cut(node));
  } else {
    blame.prisms.push_back(caps_[nodes_.cap(node)].lone);
  }
}

Embedding::Blame Embedding::find_fault() {
  Blame blame;
  // Rounding must not have put anything into a section plane.
  for (const NodeId n : points_.ids()) {
    if (nodes_.is_slab_vertex(n)) continue;
    if (slab_.lower().z < points_[n].z && points_[n].z < slab_.upper().z) continue;
    at_ = points_[n];
    blame_node(n, blame);
  }
  work_ += pieces_.size();
  for (const Piece& piece : pieces_) {
    if (is_positive(piece)) continue;
    at_ = points_[piece.node[0]];
    for (const NodeId n : piece.node) blame_node(n, blame);
  }
  if (!blame.empty()) return blame;

  const WorkStopwatch watch;
  const std::vector<Contact> contacts = boundary_contacts();
  contact_seconds_ += watch.seconds();
  place_of(contacts);
  for (const Contact& contact : contacts) {
    Blame pair;
    for (const VertexId v : boundary_[contact.first]) blame_node(node_of(v), pair);
    for (const VertexId v : boundary_[contact.second]) blame_node(node_of(v), pair);
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

// The place told is that of the last contact, triangles in the order of their sorted nodes.
void Embedding::place_of(const std::vector<Contact>& contacts) {
  using Key = std::array<VertexId, 3>;
  const auto key = [&](std::uint32_t k) {
    Key nodes = boundary_[k];
    std::sort(nodes.begin(), nodes.end());
    return std::pair(nodes, k);
  };
  std::pair<Key, std::uint32_t> last;
  for (std::size_t i = 0; i < contacts.size(); ++i) {
    const auto first = std::min(key(contacts[i].first), key(contacts[i].second));
    if (i == 0 || last < first) last = first;
  }
  if (!contacts.empty()) at_ = points_[node_of(boundary_[last.second][0])];
}

// All contacts of the boundary. Of triangles without a constructed node no two are in contact
// (embedding.hpp, lemma); and once looked for, a pair that had none cannot have got one
// unless a vertex of it moved.
std::vector<Contact> Embedding::boundary_contacts() {
  std::vector<std::uint8_t> active;
  if (tested_.empty()) {
    active.resize(boundary_.size());
    const auto constructed = [&](VertexId v) { return nodes_.is_constructed(node_of(v)); };
    for (std::size_t k = 0; k < boundary_.size(); ++k) {
      const TriangleVertices& t = boundary_[k];
      active[k] = constructed(t[0]) || constructed(t[1]) || constructed(t[2]) ? 1 : 0;
    }
  } else {
    active = std::move(in_contact_);
    const auto moved = [&](VertexId v) { return points_[node_of(v)] != tested_[node_of(v)]; };
    for (std::size_t k = 0; k < boundary_.size(); ++k) {
      const TriangleVertices& t = boundary_[k];
      if (moved(t[0]) || moved(t[1]) || moved(t[2])) active[k] = 1;
    }
  }
  std::vector<Contact> contacts =
      find_contacts(points_.raw(), boundary_, static_cast<std::size_t>(-1), active, &work_);
  tested_ = points_;
  in_contact_.assign(boundary_.size(), 0);
  for (const Contact& contact : contacts)
    in_contact_[contact.first] = in_contact_[contact.second] = 1;
  return contacts;
}

Embedding::Outcome Embedding::give_way(Blame blame) {
  sort_distinct(blame.cuts);
  sort_distinct(blame.prisms);
  bool truncated = false;
  for (const std::size_t k : blame.prisms) {
    ++lone_[k].level;
    truncated = truncated || !lone_[k].is_prism();
  }
  if (truncated) return Outcome::more_truncated;
  for (const CutId k : blame.cuts) {
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
  sort_distinct(blame.lifted);
  for (const LiftedId k : blame.lifted) {
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

}  // namespace tetloft::internal

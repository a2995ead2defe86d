// The validity conditions of the mesh, checked from the arrays alone and in bounds even
// when they hold nonsense.
#include <tetloft/tet_mesh.hpp>

#include <algorithm>
#include <string>

#include "mesh/face_groups.hpp"

namespace tetloft {

using namespace internal;

using namespace mesh_detail;

namespace {

/// Keeps the first offender of one condition and counts the others.
class Offences {
 public:
  void add(const std::string& what) {
    if (count_++ == 0) first_ = what;
  }
  void report(int condition, std::vector<MeshViolation>& out) const {
    if (count_ == 0) return;
    out.push_back({condition, count_ == 1
                                  ? first_
                                  : first_ + " (and " + std::to_string(count_ - 1) + " more)"});
  }

 private:
  std::string first_;
  std::size_t count_ = 0;
};

std::string half_face_text(HalfFaceId h) {
  return "half-face " + std::to_string(h.value()) + " (tet " +
         std::to_string(TetMesh::tet_of(h).value()) + ", face " +
         std::to_string(TetMesh::face_of(h)) + ")";
}

// Condition 1.
void check_vertices(const TetMesh& mesh, std::vector<MeshViolation>& violations) {
  Offences bad;
  for (const TetId t : IdRange<TetId>(mesh.tet_slots())) {
    if (!mesh.is_live(t)) continue;
    const TetVertices& tet = mesh.vertices(t);
    const auto named = [&](std::size_t i) {
      return "tet " + std::to_string(t.value()) + ": vertex " + std::to_string(tet[i].value());
    };
    for (std::size_t i = 0; i < 4; ++i) {
      if (tet[i].index() >= mesh.vertex_count()) bad.add(named(i) + " out of range");
      for (std::size_t j = 0; j < i; ++j) {
        if (tet[j] == tet[i]) bad.add(named(i) + " repeated");
      }
    }
  }
  bad.report(1, violations);
}

// Conditions 2 and 3.
void check_opposites(const TetMesh& mesh, std::vector<MeshViolation>& violations) {
  const std::size_t half_faces = 4 * mesh.tet_slots();
  const auto live = [&](HalfFaceId h) {
    return h.index() < half_faces && mesh.is_live(TetMesh::tet_of(h));
  };
  Offences not_involution;
  Offences not_same_face;
  for (const HalfFaceId h : IdRange<HalfFaceId>(half_faces)) {
    const HalfFaceId o = mesh.opposite(h);
    if (!o.valid()) continue;
    if (!live(h) || !live(o) || o == h || mesh.opposite(o) != h) {
      not_involution.add(half_face_text(h) + ": opposite " + std::to_string(o.value()) +
                         " does not answer");
      continue;
    }
    const SortedFace a = sorted_face(mesh.vertices(TetMesh::tet_of(h)), h.index() % 4);
    const SortedFace b = sorted_face(mesh.vertices(TetMesh::tet_of(o)), o.index() % 4);
    if (a.vertex != b.vertex) {
      not_same_face.add(half_face_text(h) + " and its opposite have different vertices");
    } else if (a.even == b.even) {
      not_same_face.add(half_face_text(h) + " and its opposite have the same orientation");
    }
  }
  not_involution.report(2, violations);
  not_same_face.report(3, violations);
}

// Condition 4.
void check_faces(const TetMesh& mesh, std::vector<MeshViolation>& violations) {
  const auto corners = [&](std::size_t t) -> const TetVertices& { return mesh.vertices(TetId(t)); };
  const auto sound = [&](std::size_t t) {
    return std::all_of(corners(t).begin(), corners(t).end(),
                       [&](VertexId v) { return v.index() < mesh.vertex_count(); });
  };
  Offences not_glued;
  const auto check = [&](std::size_t, std::span<const FaceMember> members) {
    const HalfFaceId first = members[0].half_face;
    if (members.size() > 2) {
      not_glued.add(half_face_text(first) + ": its face belongs to " +
                    std::to_string(members.size()) + " tets");
    } else if (members.size() == 2 && mesh.opposite(first) != members[1].half_face) {
      not_glued.add(half_face_text(first) + " and " + half_face_text(members[1].half_face) +
                    " share a face but are not glued");
    }
  };
  for_each_face_group(mesh.vertex_count(), mesh.tet_slots(), corners, sound, check);
  not_glued.report(4, violations);
}

}  // namespace

std::vector<MeshViolation> TetMesh::validate() const {
  std::vector<MeshViolation> violations;
  check_vertices(*this, violations);
  check_opposites(*this, violations);
  check_faces(*this, violations);
  check_corner_lists(violations);
  check_free_list(violations);
  return violations;
}

void TetMesh::check_corner_lists(std::vector<MeshViolation>& violations) const {
  Offences bad;
  const CornerLists& lists = corner_lists();
  std::vector<char> listed(4 * tets_.size(), 0);
  for (std::size_t v = 0; v < vertex_count(); ++v) {
    const HalfFaceId first = lists.first[v];
    if (!first.valid()) continue;
    HalfFaceId c = first;
    do {
      // A corner met twice before coming round means a list that never does.
      if (c.index() >= listed.size() || listed[c.index()] != 0 || corner_vertex(c) != VertexId(v) ||
          next_corner(c).index() >= listed.size() || lists.previous[next_corner(c).index()] != c) {
        bad.add("vertex " + std::to_string(v) + ": broken corner list at " +
                std::to_string(c.value()));
        break;
      }
      listed[c.index()] = 1;
      c = next_corner(c);
    } while (c != first);
  }
  for (std::size_t i = 0; i < listed.size(); ++i) {
    if (is_live(TetId(i / 4)) && tets_[i / 4][i % 4].index() < vertex_count() && listed[i] == 0) {
      bad.add(half_face_text(HalfFaceId(i)) + " is in no corner list");
    }
  }
  bad.report(5, violations);
}

void TetMesh::check_free_list(std::vector<MeshViolation>& violations) const {
  Offences bad;
  std::vector<char> freed(tets_.size(), 0);
  for (const TetId t : free_) {
    if (t.index() >= freed.size() || freed[t.index()] != 0 || is_live(t)) {
      bad.add("tet " + std::to_string(t.value()) + " is wrongly in the free list");
      continue;
    }
    freed[t.index()] = 1;
  }
  for (std::size_t t = 0; t < tets_.size(); ++t) {
    if (!is_live(TetId(t)) && freed[t] == 0) {
      bad.add("dead slot " + std::to_string(t) + " is missing in the free list");
    }
  }
  bad.report(6, violations);
}

}  // namespace tetloft

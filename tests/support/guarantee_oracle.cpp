// Guarantees 1 and 3: sets of faces, links as surfaces, tets in pairs.
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <set>

#include "support/guarantee_oracle_parts.hpp"

namespace tetloft::oracle {

namespace {

bool same_rotation(const Face& a, const Face& b) {
  return a == b || a == Face{b[1], b[2], b[0]} || a == Face{b[2], b[0], b[1]};
}

}  // namespace

GuaranteeVerdicts Oracle::run() {
  bool well_formed = true;
  for (const TetVertices& tet : model_.tets) {
    std::set<std::size_t> distinct;
    for (const VertexId v : tet) distinct.insert(v.index());
    well_formed = well_formed && distinct.size() == 4 && *distinct.rbegin() < model_.points.size();
  }
  bool finite = true;
  for (const Point3& p : model_.points) {
    finite = finite && std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z);
  }
  if (!well_formed) violate(1, "malformed tet");
  if (!finite) violate(3, "not finite");
  if (!well_formed || !finite) {
    verdict_.holds[1] = verdict_.holds[3] = std::nullopt;
    verdict_.holds[well_formed ? 0 : 2] = std::nullopt;
    return verdict_;
  }
  for (const Point3& p : model_.points) points_.push_back(exactly(p));
  for (const TetVertices& tet : model_.tets) {
    tets_.push_back({tet[0].index(), tet[1].index(), tet[2].index(), tet[3].index()});
  }
  for (std::size_t t = 0; t < tets_.size(); ++t) {
    for (const std::size_t v : tets_[t]) star_[v].push_back(t);
    for (const Face& face : faces(t)) uses_[sorted(face)].push_back({t, face});
  }
  manifold();
  for (std::size_t s = 0; s < stack_.sections.size(); ++s) resample(s);
  crossing();
  embedded();
  components();
  return verdict_;
}

void Oracle::manifold() {
  bool faces_good = true;
  for (const auto& [face, uses] : uses_) {
    if (uses.size() > 2 || (uses.size() == 2 && same_rotation(uses[0].outward, uses[1].outward))) {
      faces_good = false;
    }
  }
  if (!faces_good) violate(1, "face");
  for (std::size_t v = 0; v < points_.size(); ++v) {
    bool in_plane = false;
    for (std::size_t s = 0; s < stack_.sections.size(); ++s) in_plane |= height(v) == z(s);
    if (star_.count(v) == 0) {
      if (!in_plane) violate(1, "spare vertex");
    } else if (faces_good && !has_regular_link(v)) {
      violate(1, "link of " + std::to_string(v));
    }
  }
}

bool Oracle::has_regular_link(std::size_t v) const {
  std::vector<Face> triangles;
  for (const std::size_t t : star_.at(v)) {
    for (const Face& face : faces(t)) {
      if (std::count(face.begin(), face.end(), v) == 0) triangles.push_back(face);
    }
  }
  std::map<Edge, std::vector<std::size_t>> sides;
  std::map<std::size_t, std::vector<std::size_t>> around;
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    const Face& f = triangles[i];
    for (std::size_t k = 0; k < 3; ++k) {
      sides[sorted(Edge{f[k], f[(k + 1) % 3]})].push_back(i);
      around[f[k]].push_back(i);
    }
  }
  // Connected as a whole, and around each of its vertices, through shared edges.
  const auto connected = [&](const std::vector<std::size_t>& among, const auto& counts) {
    std::set<std::size_t> reached{among[0]};
    for (bool grown = true; grown;) {
      grown = false;
      for (const auto& [edge, two] : sides) {
        if (two.size() != 2 || !counts(edge)) continue;
        if (reached.count(two[0]) != reached.count(two[1])) {
          reached.insert(two[0]);
          reached.insert(two[1]);
          grown = true;
        }
      }
    }
    return reached.size() == among.size();
  };
  std::vector<std::size_t> all(triangles.size());
  for (std::size_t i = 0; i < all.size(); ++i) all[i] = i;
  bool good = connected(all, [](const Edge&) { return true; });
  for (const auto& [w, fan] : around) {
    good = good && connected(fan, [w = w](const Edge& e) { return e[0] == w || e[1] == w; });
  }
  bool closed = true;
  for (const auto& [edge, two] : sides) {
    good = good && two.size() <= 2;
    closed = closed && two.size() == 2;
  }
  const auto euler = static_cast<long>(around.size()) - static_cast<long>(sides.size()) +
                     static_cast<long>(triangles.size());
  return good && euler == (closed ? 2 : 1);
}

void Oracle::embedded() {
  bool positive = true;
  for (const auto& tet : tets_) {
    const auto& [a, b, c, d] = corners(points_, tet);
    positive =
        positive && dot(cross(difference(b, a), difference(c, a)), difference(d, a)).sign() > 0;
  }
  if (!positive) {
    violate(3, "tet not positive");
  } else if (const auto small = small_points(); !small.empty()) {
    find_overlaps(small);
  } else {
    find_overlaps(points_);
  }
}

// Four times the coordinates, if those are all integers below 2^10: then every value in
// tets_overlap() and is_beside() stays below 3 · 2^11 · (2 · 2^11 · (2 · 2^11 · 2^11)) < 2^50.
std::vector<Vector3<std::int64_t>> Oracle::small_points() const {
  std::vector<Vector3<std::int64_t>> small;
  const auto is_small = [](double x) { return std::fabs(x) < 0x1p8 && 4 * x == std::floor(4 * x); };
  const auto scaled = [](double x) { return static_cast<std::int64_t>(4 * x); };
  for (const Point3& p : model_.points) {
    if (!is_small(p.x) || !is_small(p.y) || !is_small(p.z)) return {};
    small.push_back({scaled(p.x), scaled(p.y), scaled(p.z)});
  }
  return small;
}

template <class Number>
void Oracle::find_overlaps(const std::vector<Vector3<Number>>& points) {
  for (std::size_t i = 0; i < tets_.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      if (boxes_meet(tets_[i], tets_[j]) &&
          tets_overlap(corners(points, tets_[i]), corners(points, tets_[j]))) {
        violate(3, "tets overlap");
      }
    }
  }
  std::vector<Face> boundary;
  for (const auto& [face, uses] : uses_) {
    if (uses.size() == 1) boundary.push_back(face);
  }
  for (std::size_t i = 0; i < boundary.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      const Face& a = boundary[i];
      const Face& b = boundary[j];
      // Distinct vertices at one place are a contact: only shared ids may be equal.
      if (!boxes_meet(a, b)) continue;
      if (!have_coincident(a, b) && (is_beside(corners(points, a), corners(points, b)) ||
                                     is_beside(corners(points, b), corners(points, a)))) {
        continue;
      }
      if (in_contact(a, b)) violate(3, "boundary contact");
    }
  }
}

bool Oracle::have_coincident(const Face& a, const Face& b) const {
  for (const std::size_t v : a) {
    for (const std::size_t w : b) {
      if (v != w && model_.points[VertexId(v)] == model_.points[VertexId(w)]) return true;
    }
  }
  return false;
}

bool Oracle::in_contact(const Face& a, const Face& b) const {
  std::vector<std::size_t> shared;
  std::set_intersection(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(shared));
  for (const Point3Q& p : triangle_intersection(corners(points_, a), corners(points_, b))) {
    if (shared.empty()) return true;
    if (!on_segment(p, points_[shared.front()], points_[shared.back()])) return true;
  }
  return false;
}

GuaranteeVerdicts guarantees(const Model& model, const SectionStack& stack,
                             const CheckOptions& options) {
  return Oracle(model, stack, options).run();
}

}  // namespace tetloft::oracle

// Sorts a model's tets into sound and malformed ones and matches the faces of the sound.
#include "check/view.hpp"

#include <algorithm>
#include <cmath>
#include <span>
#include <utility>

#include <tetloft/result.hpp>

#include "core/guard.hpp"
#include "core/union_find.hpp"
#include "model/well_formed.hpp"

namespace tetloft::internal::checking {

namespace {

void collect_sound_tets(const Model& model, ModelView& view) {
  const auto number = [&](std::size_t t) {
    return view.part.tet.empty() ? TetId(t) : view.part.tet[t];
  };
  std::vector<std::uint8_t> finite(model.points.size());
  for (std::size_t v = 0; v < finite.size(); ++v) {
    finite[v] = is_finite(model.points[VertexId(v)]) ? 1 : 0;
    if (finite[v] == 0) view.not_finite.push_back(VertexId(v));
  }
  view.used.assign(model.points.size(), 0);
  view.tets.reserve(model.tets.size());
  view.id.reserve(model.tets.size());
  for (std::size_t t = 0; t < model.tets.size(); ++t) {
    const TetVertices& tet = model.tets[TetId(t)];
    bool well_formed = true;
    bool all_finite = true;
    for (std::size_t i = 0; i < 4; ++i) {
      well_formed = well_formed && tet[i].index() < model.points.size();
      for (std::size_t j = i + 1; j < 4; ++j) well_formed = well_formed && tet[i] != tet[j];
      all_finite = all_finite && well_formed && finite[tet[i].index()] != 0;
    }
    if (!well_formed) {
      view.malformed.push_back(number(t));
    } else if (all_finite) {
      view.tets.push_back(tet);
      view.id.push_back(number(t));
      for (const VertexId v : tet) view.used[v.index()] = 1;
    }
  }
}

void find_levels(const SectionStack& stack, ModelView& view) {
  const std::vector<Section>& planes = stack.sections.raw();
  view.level.assign(view.points.size(), -1);
  for (std::size_t v = 0; v < view.points.size(); ++v) {
    const Point3& p = view.points[v];
    if (!is_finite(p)) continue;
    const auto at =
        std::lower_bound(planes.begin(), planes.end(), p.z,
                         [](const Section& section, double z) { return section.z < z; });
    const auto plane = static_cast<Level>(at - planes.begin());
    view.level[v] = at != planes.end() && at->z == p.z ? 2 * plane : 2 * plane - 1;
  }
}

struct Corner {
  std::uint32_t middle = 0, high = 0;
  std::uint32_t half_face = 0;
  bool even = true;  // the outward order is an even permutation of the sorted one
};

TriangleVertices outward_face(const ModelView& view, std::size_t half_face) {
  const TetVertices& tet = view.tets[half_face / 4];
  const auto& local = kFaceVertex[half_face % 4];
  return {tet[static_cast<std::size_t>(local[0])], tet[static_cast<std::size_t>(local[1])],
          tet[static_cast<std::size_t>(local[2])]};
}

// Sorts the three and tells whether the permutation was even.
bool sort_face(TriangleVertices& f) {
  bool even = true;
  const auto order = [&](std::size_t i, std::size_t j) {
    if (f[j] < f[i]) {
      std::swap(f[i], f[j]);
      even = !even;
    }
  };
  order(0, 1);
  order(1, 2);
  order(0, 1);
  return even;
}

// Half-faces by their lowest vertex: those of vertex v are corner[first[v] … first[v + 1]].
struct FacesByVertex {
  std::vector<std::uint32_t> first;
  std::vector<Corner> corner;
};

FacesByVertex faces_by_lowest_vertex(const ModelView& view) {
  const std::size_t half_faces = 4 * view.tets.size();
  FacesByVertex faces;
  faces.first.assign(view.points.size() + 1, 0);
  for (std::size_t h = 0; h < half_faces; ++h) {
    const TriangleVertices f = outward_face(view, h);
    ++faces.first[std::min({f[0], f[1], f[2]}).index() + 1];
  }
  for (std::size_t v = 1; v < faces.first.size(); ++v) faces.first[v] += faces.first[v - 1];
  faces.corner.resize(half_faces);
  std::vector<std::uint32_t> next(faces.first.begin(), faces.first.end() - 1);
  for (std::size_t h = 0; h < half_faces; ++h) {
    TriangleVertices f = outward_face(view, h);
    const bool even = sort_face(f);
    faces.corner[next[f[0].index()]++] = {f[1].value(), f[2].value(), static_cast<std::uint32_t>(h),
                                          even};
  }
  return faces;
}

// Are all tets of a face shown?
bool is_all_shown(const ModelView& view, const TriangleVertices& face) {
  switch (view.part.scope) {
    case Scope::whole: return true;
    case Scope::segment: return !view.in_seam(face);
    case Scope::seam: break;
  }
  return view.in_seam(face[0]) || view.in_seam(face[1]) || view.in_seam(face[2]);
}

// The half-faces of one face: opposite each other if they are two, on the two sides of it.
void match_face(std::span<const Corner> group, const TriangleVertices& face,
                std::vector<std::uint8_t>& on_boundary, ModelView& view) {
  const bool reports = view.part.scope != Scope::seam || view.in_seam(face);
  if (group.size() == 1) {
    on_boundary[group[0].half_face] = 1;
  } else if (group.size() > 2) {
    if (reports) view.crowded_faces.push_back(face);
  } else if (group[0].even == group[1].even) {
    if (reports) view.doubled_faces.push_back(face);
  } else {
    view.opposite[group[0].half_face] = HalfFaceId(group[1].half_face);
    view.opposite[group[1].half_face] = HalfFaceId(group[0].half_face);
  }
}

void number_components(const UnionFind& connected, ModelView& view) {
  view.component.assign(view.tets.size(), 0);
  for (std::size_t t = 0; t < view.tets.size(); ++t) {
    // The representative is the lowest tet, so it has its number already.
    const std::size_t root = connected.find(t);
    view.component[t] =
        root == t ? static_cast<std::uint32_t>(view.component_count++) : view.component[root];
  }
}

// The faces of each vertex are sorted by the other two there: linear for bounded stars.
void match_faces(ModelView& view) {
  FacesByVertex faces = faces_by_lowest_vertex(view);
  view.opposite.assign(faces.corner.size(), HalfFaceId());
  UnionFind connected(view.tets.size());
  std::vector<std::uint8_t> on_boundary(faces.corner.size(), 0);
  for (std::size_t v = 0; v + 1 < faces.first.size(); ++v) {
    const auto begin = faces.corner.begin() + faces.first[v];
    const auto end = faces.corner.begin() + faces.first[v + 1];
    std::sort(begin, end, [](const Corner& a, const Corner& b) {
      if (a.middle != b.middle) return a.middle < b.middle;
      return a.high != b.high ? a.high < b.high : a.half_face < b.half_face;
    });
    for (auto group = begin; group != end;) {
      auto group_end = group + 1;
      while (group_end != end && group_end->middle == group->middle &&
             group_end->high == group->high) {
        ++group_end;
      }
      const TriangleVertices face{VertexId(v), VertexId(group->middle), VertexId(group->high)};
      if (is_all_shown(view, face)) {
        for (auto other = group + 1; other != group_end; ++other) {
          connected.unite(group->half_face / 4, other->half_face / 4);
        }
        match_face({group, group_end}, face, on_boundary, view);
      }
      group = group_end;
    }
  }
  for (std::size_t h = 0; h < on_boundary.size(); ++h) {
    if (on_boundary[h] == 0) continue;
    view.boundary.push_back(outward_face(view, h));
    view.boundary_face.push_back(HalfFaceId(h));
  }
  number_components(connected, view);
}

}  // namespace

bool is_finite(const Point3& p) {
  return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z);
}

ModelView look_at(const Model& model, const SectionStack& stack, PartOfWhole part) {
  if (model.tets.size() >= kMostModelTets) {
    throw Failed({ErrorCode::invalid_input, "2^30 tets or more are to be checked together", {}});
  }
  ModelView view;
  view.part = std::move(part);
  view.points = model.points.raw();
  collect_sound_tets(model, view);
  find_levels(stack, view);
  match_faces(view);
  return view;
}

std::string vertex_text(const ModelView& view, VertexId v) {
  Place place;
  place.vertex = view.number(v).index();
  if (v.index() < view.points.size()) place.point = view.points[v.index()];
  return to_string(place);
}

std::string tet_text(TetId t) { return "tet " + std::to_string(t.value()); }

std::string edge_text(const ModelView& view, VertexId a, VertexId b) {
  return "edge " + std::to_string(view.number(a).value()) + " " +
         std::to_string(view.number(b).value());
}

std::string face_text(const ModelView& view, const TriangleVertices& face) {
  return "face " + std::to_string(view.number(face[0]).value()) + " " +
         std::to_string(view.number(face[1]).value()) + " " +
         std::to_string(view.number(face[2]).value());
}

std::string contour_text(std::size_t section, std::size_t contour) {
  Place place;
  place.section = section;
  place.contour = contour;
  return to_string(place);
}

}  // namespace tetloft::internal::checking

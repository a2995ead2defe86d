// Names of what a model's tets and points come from, its boundary surface and its volume.
#include <tetloft/model.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

#include "core/entry.hpp"
#include "core/unit_of_length.hpp"

namespace tetloft {

const char* name_of(TetKind kind) {
  switch (kind) {
    case TetKind::t1_internal: return "t1_internal";
    case TetKind::t1_external: return "t1_external";
    case TetKind::ii: return "ii";
    case TetKind::ie: return "ie";
    case TetKind::ic: return "ic";
    case TetKind::ee: return "ee";
    case TetKind::ec: return "ec";
    case TetKind::cc: return "cc";
    case TetKind::prism: return "prism";
  }
  return "unknown";
}

const char* name_of(PointOrigin origin) {
  switch (origin) {
    case PointOrigin::input: return "input";
    case PointOrigin::contour_split: return "contour_split";
    case PointOrigin::lifted: return "lifted";
    case PointOrigin::cut: return "cut";
    case PointOrigin::cap: return "cap";
    case PointOrigin::projected: return "projected";
  }
  return "unknown";
}

namespace {

TriangleVertices face_of_tet(const TetVertices& tet, std::size_t face) {
  const auto& local = kFaceVertex[face];
  return {tet[static_cast<std::size_t>(local[0])], tet[static_cast<std::size_t>(local[1])],
          tet[static_cast<std::size_t>(local[2])]};
}

// Its vertices are the model's.
bool is_sound(const Model& model, const TetVertices& tet) {
  return std::all_of(tet.begin(), tet.end(),
                     [&](VertexId v) { return v.index() < model.points.size(); });
}

std::vector<TetId> sound_tets(const Model& model) {
  std::vector<TetId> sound;
  sound.reserve(model.tets.size());
  for (std::size_t t = 0; t < model.tets.size(); ++t) {
    if (is_sound(model, model.tets[TetId(t)])) sound.emplace_back(t);
  }
  return sound;
}

}  // namespace

Surface boundary_surface(const Model& model) {
  // A face is put into the bucket of its lowest vertex; buckets are as small as vertex
  // stars, so that sorting them is linear in all for bounded stars.
  struct Face {
    VertexId middle, high;
    std::uint32_t half_face;
  };
  const std::vector<TetId> sound = sound_tets(model);
  require_fit(sound.size() < std::size_t{1} << 30, "2^30 tets or more");
  const std::size_t face_count = 4 * sound.size();
  std::vector<std::uint32_t> first(model.points.size() + 1, 0);
  const auto sorted_face = [&](std::size_t h) {
    TriangleVertices f = face_of_tet(model.tets[sound[h / 4]], h % 4);
    std::sort(f.begin(), f.end());
    return f;
  };
  for (std::size_t h = 0; h < face_count; ++h) ++first[sorted_face(h)[0].index() + 1];
  for (std::size_t v = 1; v < first.size(); ++v) first[v] += first[v - 1];
  std::vector<Face> faces(face_count);
  std::vector<std::uint32_t> next(first.begin(), first.end() - 1);
  for (std::size_t h = 0; h < face_count; ++h) {
    const TriangleVertices f = sorted_face(h);
    faces[next[f[0].index()]++] = {f[1], f[2], static_cast<std::uint32_t>(h)};
  }

  std::vector<std::uint8_t> on_boundary(face_count, 0);
  const auto less = [](const Face& a, const Face& b) {
    return std::pair(a.middle, a.high) < std::pair(b.middle, b.high);
  };
  const auto same = [](const Face& a, const Face& b) {
    return a.middle == b.middle && a.high == b.high;
  };
  for (std::size_t v = 0; v + 1 < first.size(); ++v) {
    std::sort(faces.begin() + first[v], faces.begin() + first[v + 1], less);
    for (std::size_t i = first[v]; i < first[v + 1];) {
      std::size_t end = i + 1;
      while (end < first[v + 1] && same(faces[i], faces[end])) ++end;
      if (end == i + 1) on_boundary[faces[i].half_face] = 1;
      i = end;
    }
  }

  Surface surface;
  for (std::size_t h = 0; h < face_count; ++h) {
    if (on_boundary[h] == 0) continue;
    surface.triangles.push_back(face_of_tet(model.tets[sound[h / 4]], h % 4));
    surface.tet.push_back(sound[h / 4]);
  }
  return surface;
}

double volume(const Model& model) {
  UnitOfLength unit;
  for (const TetVertices& tet : model.tets) {
    if (!is_sound(model, tet)) continue;
    for (const VertexId v : tet) unit.include(model.points[v]);
  }
  const int exponent = unit.largest_to_one();
  // Neumaier's compensated sum: a stack has many tets far smaller than the whole.
  double sum = 0;
  double lost = 0;
  for (const TetVertices& tet : model.tets) {
    if (!is_sound(model, tet)) continue;
    const Point3 d = scaled(model.points[tet[3]], exponent);
    const auto from_d = [&](int i) {
      const Point3 p = scaled(model.points[tet[static_cast<std::size_t>(i)]], exponent);
      return Point3{p.x - d.x, p.y - d.y, p.z - d.z};
    };
    const Point3 a = from_d(0);
    const Point3 b = from_d(1);
    const Point3 c = from_d(2);
    // a · (b × c) is minus the orientation determinant of (a, b, c, d).
    const double term = -(a.x * (b.y * c.z - b.z * c.y) + a.y * (b.z * c.x - b.x * c.z) +
                          a.z * (b.x * c.y - b.y * c.x)) /
                        6;
    const double next = sum + term;
    lost += std::fabs(sum) >= std::fabs(term) ? (sum - next) + term : (term - next) + sum;
    sum = next;
  }
  return std::ldexp(sum + lost, -3 * exponent);
}

}  // namespace tetloft

#include "render/scene.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "render/vector.hpp"

namespace tetloft::internal::render {

namespace {

// The half-space that is kept: where excess() ≤ 0.
struct HalfSpace {
  int axis = 2;
  double position = 0;
  double sign = 1;

  [[nodiscard]] double excess(const Point3& p) const {
    return sign * (coordinate(p, axis) - position);
  }
  [[nodiscard]] Point3 normal() const {
    return {axis == 0 ? sign : 0.0, axis == 1 ? sign : 0.0, axis == 2 ? sign : 0.0};
  }
};

std::optional<HalfSpace> half_space(const RenderOptions& options, const Point3& toward,
                                    int exponent) {
  if (!options.cut) return std::nullopt;
  const int axis = options.cut->axis;
  const double position = std::ldexp(options.cut->position, -exponent);
  if (axis == 2) return HalfSpace{2, options.stretch * position, 1};
  return HalfSpace{axis, position, coordinate(toward, axis) < 0 ? -1.0 : 1.0};
}

struct Corner {
  Point3 point, normal;
  bool outlined = false;  // the side from here to the next corner
};

// The kept part of a triangle (Sutherland and Hodgman 1974).
std::vector<Corner> clipped(const std::array<Corner, 3>& triangle, const HalfSpace& kept) {
  std::vector<Corner> polygon;
  for (std::size_t i = 0; i < 3; ++i) {
    const Corner& a = triangle[i];
    const Corner& b = triangle[(i + 1) % 3];
    const double da = kept.excess(a.point);
    const double db = kept.excess(b.point);
    if (da <= 0) polygon.push_back(a);
    if ((da <= 0) == (db <= 0)) continue;
    const double t = da / (da - db);
    polygon.push_back({a.point + t * (b.point - a.point),
                       unit(a.normal + t * (b.normal - a.normal)), da <= 0 || a.outlined});
  }
  return polygon;
}

class Builder {
 public:
  Builder(const Subject& subject, const Point3& toward, const RenderOptions& options)
      : subject_(subject),
        options_(options),
        kept_(half_space(options, toward, subject.exponent)) {}

  Scene build() {
    for (std::size_t k = 0; k < subject_.boundary.size(); ++k) {
      add_face(subject_.boundary[k], subject_.normals[k]);
    }
    if (options_.explode > 0) {
      for (const HalfFaceId h : subject_.walls) {
        const auto p = subject_.corners(h);
        const Point3 normal = unit(cross(p[1] - p[0], p[2] - p[0]));
        add_face(h, {normal, normal, normal});
      }
    }
    if (kept_) {
      for (std::size_t t = 0; t < subject_.tets.size(); ++t) add_cut(t);
    }
    if (options_.contours) {
      for (const ContourPiece& piece : subject_.contours) {
        add_line(piece, piece.slab_below);
        if (options_.explode > 0 && piece.slab_above != piece.slab_below) {
          add_line(piece, piece.slab_above);
        }
      }
    }
    scene_.line_gap = subject_.mean_gap * (1 + options_.explode);
    scene_.exponent = subject_.exponent;
    return std::move(scene_);
  }

 private:
  [[nodiscard]] Point3 shift(std::uint32_t slab) const {
    return {0, 0, options_.explode * subject_.mean_gap * slab};
  }

  void add_polygon(const std::vector<Corner>& polygon, std::size_t tet) {
    const Point3 moved = shift(subject_.slab[tet]);
    const Rgb colour = subject_.colour(tet, options_.colour);
    for (std::size_t i = 2; i < polygon.size(); ++i) {
      const Corner& a = polygon[0];
      const Corner& b = polygon[i - 1];
      const Corner& c = polygon[i];
      const bool last = i + 1 == polygon.size();
      const auto outline = static_cast<std::uint8_t>(
          (i == 2 && a.outlined ? 1 : 0) | (b.outlined ? 2 : 0) | (last && c.outlined ? 4 : 0));
      scene_.triangles.push_back({{a.point + moved, b.point + moved, c.point + moved},
                                  {a.normal, b.normal, c.normal},
                                  colour,
                                  outline});
    }
  }

  void add_face(HalfFaceId h, const std::array<Point3, 3>& normal) {
    const auto p = subject_.corners(h);
    const std::array<Corner, 3> triangle{
        {{p[0], normal[0], true}, {p[1], normal[1], true}, {p[2], normal[2], true}}};
    if (kept_) {
      add_polygon(clipped(triangle, *kept_), h.index() / 4);
    } else {
      add_polygon({triangle.begin(), triangle.end()}, h.index() / 4);
    }
  }

  // The face that cutting a tet lays open.
  void add_cut(std::size_t tet) {
    std::array<Point3, 4> p;
    std::array<double, 4> excess{};
    std::vector<std::size_t> inside, outside;
    for (std::size_t i = 0; i < 4; ++i) {
      p[i] = subject_.points[subject_.tets[tet][i].index()];
      excess[i] = kept_->excess(p[i]);
      (excess[i] <= 0 ? inside : outside).push_back(i);
    }
    if (inside.empty() || outside.empty()) return;
    const Point3 normal = kept_->normal();
    std::vector<Corner> polygon;
    const auto crossing = [&](std::size_t a, std::size_t b) {
      const double t = excess[a] / (excess[a] - excess[b]);
      polygon.push_back({p[a] + t * (p[b] - p[a]), normal, true});
    };
    if (inside.size() == 2) {
      crossing(inside[0], outside[0]);
      crossing(inside[0], outside[1]);
      crossing(inside[1], outside[1]);
      crossing(inside[1], outside[0]);
    } else {
      for (const std::size_t a : inside) {
        for (const std::size_t b : outside) crossing(a, b);
      }
    }
    // Of the whole polygon: corners coincide where the plane goes through vertices.
    Point3 turned;
    for (std::size_t i = 2; i < polygon.size(); ++i) {
      turned = turned +
               cross(polygon[i - 1].point - polygon[0].point, polygon[i].point - polygon[0].point);
    }
    if (dot(turned, normal) < 0) std::reverse(polygon.begin(), polygon.end());
    add_polygon(polygon, tet);
  }

  void add_line(const ContourPiece& piece, std::uint32_t slab) {
    Point3 a = piece.a;
    Point3 b = piece.b;
    if (kept_) {
      const double da = kept_->excess(a);
      const double db = kept_->excess(b);
      if (da > 0 && db > 0) return;
      if (da > 0) a = b + (db / (db - da)) * (a - b);
      if (db > 0) b = a + (da / (da - db)) * (b - a);
    }
    scene_.lines.push_back({a + shift(slab), b + shift(slab)});
  }

  const Subject& subject_;
  const RenderOptions& options_;
  std::optional<HalfSpace> kept_;
  Scene scene_;
};

}  // namespace

Result<Scene> scene_of(const Model& model, const SectionStack* contours, const Point3& toward,
                       const RenderOptions& options) {
  const Result<Subject> subject = subject_of(model, contours, options);
  if (!subject) return subject.error();
  return Builder(*subject, toward, options).build();
}

}  // namespace tetloft::internal::render

// Where the Voronoi skeletons of two neighbouring sections cross in projection, and which
// contours are geometrically well positioned (Nonato et al. 2000, Definition 1).
//
// Let ab be a Delaunay edge below with the third corners c, d of its triangles, pq one above with
// r, s. The bisectors of ab and of pq meet in one point x unless they are parallel; the sphere
// through a, b, p, q is centred above x, so a vertex of either plane is nearer to x than the ends
// of that plane's edge iff it is inside the sphere. A point on the bisector of ab belongs to its
// Voronoi edge iff neither c nor d is nearer, and is inside the edge iff both are farther (on the
// convex hull one is missing, and there is no condition). Hence the predicate in-sphere decides,
// unperturbed, and x is never computed. The gap cancels: any two heights will do.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <tuple>
#include <vector>

#include <tetloft/skeleton.hpp>

#include "arithmetic/interval.hpp"
#include "sections/conforming_section.hpp"
#include "spatial/box_tree.hpp"

namespace tetloft {

using namespace internal;

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr Interval kAnywhere{-kInfinity, kInfinity};

// Boxes are compared in units of a power of two in which no coordinate exceeds 1, as intervals
// require. What underflows then is covered by the width that every operation adds.
int common_exponent(const ConformingSection& below, const ConformingSection& above) {
  double largest = 0;
  for (const ConformingSection* section : {&below, &above}) {
    for (const Point2& p : section->triangulation.points) {
      largest = std::max({largest, std::abs(p.x), std::abs(p.y)});
    }
  }
  return largest > 0 ? std::ilogb(largest) + 1 : 0;
}

struct Centre {
  Interval x = kAnywhere;
  Interval y = kAnywhere;
};

// The circumcentre; anywhere if the triangle is too thin to tell. Numerators stay below 2^6, so
// that quotients by more than 2^-900 are far from overflow.
Centre circumcentre_range(const Point2& a, const Point2& b, const Point2& c) {
  const Interval bx = difference(b.x, a.x);
  const Interval by = difference(b.y, a.y);
  const Interval cx = difference(c.x, a.x);
  const Interval cy = difference(c.y, a.y);
  const Interval turn = bx * cy - by * cx;
  const Interval divisor = turn + turn;
  if (divisor.lo <= 0x1p-900) return {};
  const Interval b2 = bx * bx + by * by;
  const Interval c2 = cx * cx + cy * cy;
  return {Interval{a.x, a.x} + quotient(cy * b2 - by * c2, divisor),
          Interval{a.y, a.y} + quotient(bx * c2 - cx * b2, divisor)};
}

int compare(double a, double b) { return a < b ? -1 : (a > b ? 1 : 0); }

// One coordinate of what runs from `from` to `to`, forwards, backwards, or along the middle
// between a and b.
Interval range(int direction, const Interval& from, const Interval& to, double a, double b) {
  if (direction > 0) return {from.lo, to.hi};
  if (direction < 0) return {to.lo, from.hi};
  return (Interval{a, a} + Interval{b, b}) * Interval{0.5, 0.5};
}

// The edges of one kind in a section, and boxes around their Voronoi edges.
struct Skeleton {
  std::vector<EdgeId> edges;
  std::vector<Box2> boxes;
};

class Skeletons {
 public:
  Skeletons(const ConformingSection& section, int exponent)
      : section_(section), exponent_(exponent) {
    centre_.reserve(section.triangulation.triangles.size());
    for (const PlaneTriangleVertices& v : section.triangulation.triangles) {
      centre_.push_back(circumcentre_range(scaled(v[0]), scaled(v[1]), scaled(v[2])));
    }
  }

  [[nodiscard]] Skeleton of_kind(EdgeKind kind) const {
    Skeleton skeleton;
    for (std::size_t e = 0; e < section_.edges.size(); ++e) {
      const ConformingSection::Edge& edge = section_.edges[EdgeId(e)];
      if (edge.kind != kind) continue;
      skeleton.edges.push_back(EdgeId(e));
      skeleton.boxes.push_back(box_of(edge));
    }
    return skeleton;
  }

 private:
  [[nodiscard]] Point2 scaled(PlaneVertexId v) const {
    const Point2& p = section_.point(v);
    return {std::ldexp(p.x, -exponent_), std::ldexp(p.y, -exponent_)};
  }

  [[nodiscard]] Centre centre(TriangleId t) const {
    return t.valid() ? centre_[t.index()] : Centre{};
  }

  // A Voronoi edge runs from the centre left of a → b to the one right of it, so at right angles
  // to the right. This holds for rays too, which lack one end, and for an end that is not known.
  [[nodiscard]] Box2 box_of(const ConformingSection::Edge& edge) const {
    const Centre from = centre(edge.left);
    const Centre to = centre(edge.right);
    const Point2 a = scaled(edge.a);
    const Point2 b = scaled(edge.b);
    const int right_x = compare(section_.point(edge.b).y, section_.point(edge.a).y);
    const int right_y = compare(section_.point(edge.a).x, section_.point(edge.b).x);
    const Interval x = range(right_x, from.x, to.x, a.x, b.x);
    const Interval y = range(right_y, from.y, to.y, a.y, b.y);
    return {x.lo, y.lo, x.hi, y.hi};
  }

  const ConformingSection& section_;
  int exponent_;
  std::vector<Centre> centre_;  // by TriangleId, scaled
};

// A Delaunay edge, lifted, with the third corners of its one or two triangles.
struct Dual {
  Point3 a, b;
  std::array<Point3, 2> apex;
  std::size_t apexes = 0;
};

Dual dual_of(const ConformingSection& section, EdgeId id, double height) {
  const auto lifted = [&](PlaneVertexId v) {
    return Point3{section.point(v).x, section.point(v).y, height};
  };
  const ConformingSection::Edge& edge = section.edges[id];
  Dual dual{lifted(edge.a), lifted(edge.b), {}, 0};
  for (const TriangleId t : {edge.left, edge.right}) {
    if (!t.valid()) continue;
    for (const PlaneVertexId v : section.triangulation.triangles[t]) {
      if (v != edge.a && v != edge.b) dual.apex[dual.apexes++] = lifted(v);
    }
  }
  return dual;
}

// Where a point lies to the sphere through four points, in any order: positive inside.
class Sphere {
 public:
  Sphere(const Point3& a, const Point3& b, const Point3& c, const Point3& d)
      : a_(a), b_(b), c_(c), d_(d), orientation_(orient3d(a, b, c, d)) {}

  [[nodiscard]] bool exists() const { return orientation_ != Sign::zero; }
  [[nodiscard]] Sign side(const Point3& p) const {
    const Sign s = insphere(a_, b_, c_, d_, p);
    return orientation_ == Sign::positive ? s : -s;
  }
  /// The greatest side of the apexes; negative without any.
  [[nodiscard]] Sign innermost(const Dual& dual) const {
    Sign result = Sign::negative;
    for (std::size_t k = 0; k < dual.apexes && result != Sign::positive; ++k) {
      result = std::max(result, side(dual.apex[k]));
    }
    return result;
  }

 private:
  const Point3& a_;
  const Point3& b_;
  const Point3& c_;
  const Point3& d_;
  Sign orientation_;
};

// Of parallel Delaunay edges: does an end of p's Voronoi edge lie on q's? An end is the centre
// of a triangle (a, b, c); spheres centred above it that hold a hold b and c. The one through q.a
// holds q.b iff the end is on the bisector of q.
bool has_end_on(const Dual& p, const Dual& q) {
  for (std::size_t k = 0; k < p.apexes; ++k) {
    const Sphere sphere(p.a, p.b, p.apex[k], q.a);
    if (sphere.side(q.b) == Sign::zero && sphere.innermost(q) != Sign::positive) return true;
  }
  return false;
}

enum class Meeting : std::uint8_t { apart, touch, cross };

Meeting meeting_of(const Dual& p, const Dual& q) {
  const Sphere sphere(p.a, p.b, q.a, q.b);
  if (!sphere.exists()) {
    // Parallel. On one line two segments or rays, each with an end, meet iff one's end is on the
    // other.
    return has_end_on(p, q) || has_end_on(q, p) ? Meeting::touch : Meeting::apart;
  }
  const Sign innermost = std::max(sphere.innermost(p), sphere.innermost(q));
  if (innermost == Sign::positive) return Meeting::apart;
  return innermost == Sign::zero ? Meeting::touch : Meeting::cross;
}

}  // namespace

std::vector<SkeletonCrossing> skeleton_crossings(const ConformingSection& below,
                                                 const ConformingSection& above) {
  sections::require_consistent(below);
  sections::require_consistent(above);
  const int exponent = common_exponent(below, above);
  const Skeletons lower(below, exponent);
  const Skeletons upper(above, exponent);
  std::vector<SkeletonCrossing> result;
  for (const EdgeKind kind_above : {EdgeKind::internal, EdgeKind::external}) {
    const Skeleton skeleton_above = upper.of_kind(kind_above);
    const BoxTree2 tree(skeleton_above.boxes);
    for (const EdgeKind kind_below : {EdgeKind::internal, EdgeKind::external}) {
      if (kind_below == EdgeKind::external && kind_above == EdgeKind::external) continue;
      const Skeleton skeleton_below = lower.of_kind(kind_below);
      for (std::size_t k = 0; k < skeleton_below.edges.size(); ++k) {
        const EdgeId e = skeleton_below.edges[k];
        const Dual dual = dual_of(below, e, 0);
        tree.query(skeleton_below.boxes[k], [&](std::size_t i) {
          const EdgeId f = skeleton_above.edges[i];
          const Meeting meeting = meeting_of(dual, dual_of(above, f, 1));
          if (meeting != Meeting::apart) result.push_back({e, f, meeting == Meeting::cross});
        });
      }
    }
  }
  std::sort(result.begin(), result.end());
  return result;
}

std::vector<WellPositioned> well_positioned(const ConformingSection& below,
                                            const ConformingSection& above) {
  std::vector<WellPositioned> result;
  for (const SkeletonCrossing& crossing : skeleton_crossings(below, above)) {
    const ConformingSection::Edge& lower = below.edges[crossing.below];
    const ConformingSection::Edge& upper = above.edges[crossing.above];
    for (const PlaneVertexId v : {lower.a, lower.b}) {
      for (const PlaneVertexId w : {upper.a, upper.b}) {
        const ContourId c = below.contour[v];
        const ContourId d = above.contour[w];
        if (c.valid() && d.valid()) result.push_back({c, d, crossing.proper});
      }
    }
  }
  // One of each pair, a proper one if there is one.
  std::sort(result.begin(), result.end(), [](const WellPositioned& a, const WellPositioned& b) {
    return std::tuple(a.below, a.above, b.proper) < std::tuple(b.below, b.above, a.proper);
  });
  const auto same_pair = [](const WellPositioned& a, const WellPositioned& b) {
    return a.below == b.below && a.above == b.above;
  };
  result.erase(std::unique(result.begin(), result.end(), same_pair), result.end());
  return result;
}

}  // namespace tetloft

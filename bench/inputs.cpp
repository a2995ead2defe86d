#include "inputs.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/prng.hpp"

namespace tetloft::bench {

using namespace internal;

namespace {

constexpr double kTurn = 6.283185307179586;

// n vertices of concentric wiggly rings, about 5000 to a ring, each plane a little different.
std::vector<Point2> rings(std::size_t n, std::size_t plane, Prng& prng) {
  const std::size_t count = std::max<std::size_t>(1, n / 5000);
  const std::size_t each = n / count;
  std::vector<Point2> points;
  points.reserve(n);
  for (std::size_t ring = 0; ring < count; ++ring) {
    for (std::size_t i = 0; i < each; ++i) {
      const double angle =
          kTurn * (static_cast<double>(i) + 0.5 * prng.unit()) / static_cast<double>(each);
      const double radius = 10 * static_cast<double>(ring + 1) +
                            2 * std::sin(7 * angle + static_cast<double>(ring)) +
                            0.4 * std::sin(23 * angle + static_cast<double>(plane));
      points.push_back({radius * std::cos(angle), radius * std::sin(angle)});
    }
  }
  return points;
}

void append(std::vector<Point3>& points, const std::vector<Point2>& plane, double z) {
  for (const Point2& p : plane) points.push_back({p.x, p.y, z});
}

Point3 in_cube(Prng& prng) {
  const double x = prng.unit();
  const double y = prng.unit();
  const double z = prng.unit();
  return {x, y, z};
}

// The sum of twelve uniform numbers is nearly Gaussian, and the same everywhere.
double nearly_gaussian(Prng& prng) {
  double sum = -6;
  for (int k = 0; k < 12; ++k) sum += prng.unit();
  return sum;
}

// n points of `count` curves a + t (b − a) + bend t² c.
std::vector<Point3> bent(std::size_t n, std::size_t count, double bend, std::uint64_t seed) {
  Prng prng(seed);
  std::vector<std::array<Point3, 3>> curve(count);
  for (auto& c : curve) {
    for (Point3& p : c) p = in_cube(prng);
  }
  std::vector<Point3> points(n);
  for (std::size_t i = 0; i < n; ++i) {
    const auto& [a, b, c] = curve[i % count];
    const double t = prng.unit();
    points[i] = {a.x + t * (b.x - a.x) + bend * t * t * c.x,
                 a.y + t * (b.y - a.y) + bend * t * t * c.y,
                 a.z + t * (b.z - a.z) + bend * t * t * c.z};
  }
  return points;
}

std::vector<Point2> wiggly(double x, double y, double radius, double phase, std::size_t n) {
  std::vector<Point2> points(n);
  for (std::size_t i = 0; i < n; ++i) {
    const double angle = kTurn * static_cast<double>(i) / static_cast<double>(n);
    const double r =
        radius * (1 + 0.04 * std::sin(7 * angle + phase) + 0.01 * std::sin(23 * angle - 2 * phase));
    points[i] = {x + r * std::cos(angle), y + r * std::sin(angle)};
  }
  return points;
}

// 2^levels radii around a circle of radius 1, by midpoint displacement: each level displaces less,
// by a factor that leaves the finest radii about as rough as they are apart.
std::vector<double> displaced_radii(int levels, Prng& prng) {
  constexpr double kFirst = 0.2;
  constexpr double kEachLevel = 0.6;
  std::vector<double> radius{1};
  double most = kFirst;
  for (int level = 0; level < levels; ++level, most *= kEachLevel) {
    std::vector<double> finer;
    for (std::size_t k = 0; k < radius.size(); ++k) {
      const double next = radius[(k + 1) % radius.size()];
      finer.push_back(radius[k]);
      finer.push_back(0.5 * (radius[k] + next) + prng.between(-most, most));
    }
    radius = std::move(finer);
  }
  return radius;
}

Point3 direction(Prng& prng) {
  for (;;) {
    const double x = prng.between(-1, 1);
    const double y = prng.between(-1, 1);
    const double z = prng.between(-1, 1);
    const double length = std::sqrt(x * x + y * y + z * z);
    if (length > 0.1 && length < 1) return {x / length, y / length, z / length};
  }
}

}  // namespace

std::vector<Point3> uniform3(std::size_t n) {
  Prng prng(1);
  std::vector<Point3> points(n);
  for (Point3& p : points) {
    p.x = prng.unit();
    p.y = prng.unit();
    p.z = prng.unit();
  }
  return points;
}

std::vector<Point3> grid3(std::size_t side) {
  std::vector<Point3> points;
  for (std::size_t x = 0; x < side; ++x) {
    for (std::size_t y = 0; y < side; ++y) {
      for (std::size_t z = 0; z < side; ++z) {
        points.push_back({static_cast<double>(x), static_cast<double>(y), static_cast<double>(z)});
      }
    }
  }
  Prng prng(2);
  prng.shuffle(points);
  return points;
}

std::vector<Point3> sphere(std::size_t n) {
  Prng prng(3);
  std::vector<Point3> points(n);
  for (Point3& p : points) p = direction(prng);
  return points;
}

std::vector<Point3> bumpy_sphere(std::size_t n) {
  Prng prng(4);
  std::vector<Point3> points(n);
  for (Point3& p : points) {
    const Point3 d = direction(prng);
    const double radius = 1 + 0.1 * std::sin(9 * d.x) * std::sin(8 * d.y) * std::sin(7 * d.z);
    p = {radius * d.x, radius * d.y, radius * d.z};
  }
  return points;
}

std::vector<Point3> two_planes(std::size_t n) {
  Prng prng(5);
  std::vector<Point3> points;
  for (std::size_t plane = 0; plane < 2; ++plane) {
    append(points, rings(n, plane, prng), static_cast<double>(plane));
  }
  return points;
}

std::vector<Point3> two_pixel_planes(std::size_t n) {
  std::vector<Point3> points = two_planes(n);
  for (Point3& p : points) {
    p.x = std::floor(32 * p.x) / 2;
    p.y = std::floor(32 * p.y) / 2;
  }
  std::sort(points.begin(), points.end(),
            [](const Point3& a, const Point3& b) { return canonical_less(a, b); });
  points.erase(std::unique(points.begin(), points.end()), points.end());
  Prng prng(6);
  prng.shuffle(points);
  return points;
}

std::vector<Point3> thin_slab(std::size_t n, std::size_t k) {
  Prng prng(7 + k);
  std::vector<Point3> points;
  append(points, rings(n, k, prng), static_cast<double>(k));
  append(points, rings(n, k + 1, prng), static_cast<double>(k + 1));
  return points;
}

std::vector<Point2> uniform2(std::size_t n) {
  Prng prng(8);
  std::vector<Point2> points(n);
  for (Point2& p : points) {
    p.x = prng.unit();
    p.y = prng.unit();
  }
  return points;
}

std::vector<Point3> clusters(std::size_t n, std::size_t count) {
  Prng prng(10);
  std::vector<Point3> centres(count);
  for (Point3& p : centres) p = in_cube(prng);
  const auto near = [&](double centre) { return centre + 1e-3 * nearly_gaussian(prng); };
  std::vector<Point3> points(n);
  for (std::size_t i = 0; i < n; ++i) {
    const Point3& c = centres[i % count];
    points[i].x = near(c.x);
    points[i].y = near(c.y);
    points[i].z = near(c.z);
  }
  prng.shuffle(points);
  return points;
}

std::vector<Point3> around_line(std::size_t n) {
  Prng prng(13);
  std::vector<Point3> points(n);
  for (Point3& p : points) {
    const double along = prng.unit();
    p.x = along + 1e-3 * nearly_gaussian(prng);
    p.y = 0.5 * along + 1e-3 * nearly_gaussian(prng);
    p.z = 0.25 * along + 1e-3 * nearly_gaussian(prng);
  }
  return points;
}

std::vector<Point3> moment_curve(std::size_t n) {
  Prng prng(14);
  std::vector<Point3> points(n);
  for (Point3& p : points) {
    const double t = prng.between(-1, 1);
    p = {t, t * t, t * t * t};
  }
  return points;
}

std::vector<Point3> lines(std::size_t n, std::size_t count) { return bent(n, count, 0, 11); }

std::vector<Point3> curves(std::size_t n, std::size_t count) { return bent(n, count, 1, 12); }

SectionStack branching(std::size_t vertices, std::size_t sections) {
  SectionStack stack;
  for (std::size_t k = 0; k < sections; ++k) {
    Section section;
    section.z = static_cast<double>(k);
    const std::size_t parts = std::size_t{1} << (3 * k / sections);
    // Half as long around a hole as outside; circles of a section share its vertices.
    const std::size_t outer = std::max<std::size_t>(12, 2 * vertices / (3 * sections * parts));
    for (std::size_t part = 0; part < parts; ++part) {
      const double x = parts == 1 ? 0 : (part % 2 == 0 ? -5.0 : 5.0);
      const double y = parts < 4 ? 0 : (part < 2 ? -5.0 : 5.0);
      const double radius = parts == 1 ? 10 : 4.5;
      const double phase = 0.05 * static_cast<double>(k) + static_cast<double>(part);
      section.contours.push_back({wiggly(x, y, radius, phase, outer)});
      section.contours.push_back({wiggly(x, y, 0.5 * radius, -phase, outer / 2)});
    }
    stack.sections.push_back(std::move(section));
  }
  return stack;
}

SectionStack coasts(std::size_t vertices, std::size_t sections) {
  int levels = 0;
  while ((std::size_t{1} << levels) < vertices) ++levels;
  SectionStack stack;
  for (std::size_t k = 0; k < sections; ++k) {
    Prng prng(15 + k);
    const std::vector<double> radius = displaced_radii(levels, prng);
    Section section;
    section.z = 10 * static_cast<double>(k);
    Contour contour;
    for (std::size_t i = 0; i < vertices; ++i) {
      const double angle = kTurn * static_cast<double>(i) / static_cast<double>(vertices);
      const double r = 100 * radius[i * radius.size() / vertices];
      contour.vertices.push_back({r * std::cos(angle), r * std::sin(angle)});
    }
    section.contours.push_back(std::move(contour));
    stack.sections.push_back(std::move(section));
  }
  return stack;
}

SectionStack tube(std::size_t vertices) {
  constexpr std::size_t kEach = 200;
  SectionStack stack;
  for (std::size_t k = 0; k < std::max<std::size_t>(2, vertices / kEach); ++k) {
    Prng prng(9 + k);
    Section section;
    section.z = static_cast<double>(k);
    Contour contour;
    contour.vertices = rings(kEach, k, prng);
    section.contours.push_back(std::move(contour));
    stack.sections.push_back(std::move(section));
  }
  return stack;
}

}  // namespace tetloft::bench

#include "corpus/solids.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>

#include "core/prng.hpp"
#include "core/union_find.hpp"
#include "corpus/marching_squares.hpp"

namespace tetloft::bench {

using namespace internal;

namespace {

double distance(const Point3& p, const Point3& q) {
  return std::hypot(p.x - q.x, p.y - q.y, p.z - q.z);
}

// The smaller of two distances, with the crease rounded over a width of k (polynomial smooth
// minimum).
double melt(double a, double b, double k) {
  const double h = std::clamp(0.5 + 0.5 * (b - a) / k, 0.0, 1.0);
  return b + h * (a - b) - k * h * (1 - h);
}

// Signed distances, to some approximation; coordinates in the unit cube.
using Field = std::function<double(const Point3&)>;

Field ball(const Point3& centre, double radius) {
  return [=](const Point3& p) { return distance(p, centre) - radius; };
}

// A segment thickened from radius r at a to radius s at b.
Field bone(const Point3& a, const Point3& b, double r, double s) {
  return [=](const Point3& p) {
    const Point3 d{b.x - a.x, b.y - a.y, b.z - a.z};
    const double dot = (p.x - a.x) * d.x + (p.y - a.y) * d.y + (p.z - a.z) * d.z;
    const double t = std::clamp(dot / (d.x * d.x + d.y * d.y + d.z * d.z), 0.0, 1.0);
    return distance(p, {a.x + t * d.x, a.y + t * d.y, a.z + t * d.z}) - (r + t * (s - r));
  };
}

Field torus(const Point3& centre, const Point3& axis, double large, double small) {
  return [=](const Point3& p) {
    const Point3 q{p.x - centre.x, p.y - centre.y, p.z - centre.z};
    const double along = q.x * axis.x + q.y * axis.y + q.z * axis.z;
    const double square = q.x * q.x + q.y * q.y + q.z * q.z;
    const double across = std::sqrt(std::max(0.0, square - along * along));
    return std::hypot(across - large, along) - small;
  };
}

Field plate(double low, double high) {
  return [=](const Point3& p) {
    const double dx = std::abs(p.x - 0.5) - 0.38, dy = std::abs(p.y - 0.5) - 0.38;
    const double dz = std::max(low - p.z, p.z - high);
    return std::max({dx, dy, dz});
  };
}

Point3 random_point(Prng& prng, double low, double high) {
  const double x = prng.between(low, high), y = prng.between(low, high);
  return {x, y, prng.between(low, high)};
}

Point3 random_direction(Prng& prng) {
  for (;;) {
    const Point3 p = random_point(prng, -1, 1);
    const double length = distance(p, {});
    if (length > 0.1 && length < 1) return {p.x / length, p.y / length, p.z / length};
  }
}

Field joined(std::vector<Field> parts, double softness) {
  return [parts = std::move(parts), softness](const Point3& p) {
    double value = parts.front()(p);
    for (std::size_t k = 1; k < parts.size(); ++k) value = melt(value, parts[k](p), softness);
    return value;
  };
}

Field without(Field whole, std::vector<Field> parts) {
  return [whole = std::move(whole), parts = std::move(parts)](const Point3& p) {
    double value = whole(p);
    for (const Field& part : parts) value = -melt(-value, part(p), 0.02);
    return value;
  };
}

Field random_blobs(Prng& prng) {
  std::vector<Field> parts;
  for (std::uint64_t n = 4 + prng.below(8); n > 0; --n) {
    const Point3 centre = random_point(prng, 0.2, 0.8);
    parts.push_back(ball(centre, prng.between(0.05, 0.16)));
  }
  return joined(std::move(parts), 0.06);
}

Field random_tubes(Prng& prng) {
  std::vector<Field> parts;
  for (std::uint64_t n = 2 + prng.below(3); n > 0; --n) {
    Point3 a = random_point(prng, 0.15, 0.85);
    double r = prng.between(0.03, 0.07);
    for (std::uint64_t bends = 2 + prng.below(3); bends > 0; --bends) {
      const Point3 b = random_point(prng, 0.15, 0.85);
      const double s = prng.between(0.03, 0.07);
      parts.push_back(bone(a, b, r, s));
      a = b;
      r = s;
    }
  }
  return joined(std::move(parts), 0.03);
}

Field random_rings(Prng& prng) {
  std::vector<Field> parts;
  for (std::uint64_t n = 1 + prng.below(3); n > 0; --n) {
    const Point3 centre = random_point(prng, 0.35, 0.65);
    const Point3 axis = random_direction(prng);
    const double large = prng.between(0.13, 0.25);
    parts.push_back(torus(centre, axis, large, prng.between(0.04, 0.07)));
  }
  return joined(std::move(parts), 0.04);
}

Field random_plates(Prng& prng) {
  std::vector<Field> holes;
  for (std::uint64_t n = 3 + prng.below(6); n > 0; --n) {
    const Point3 a = random_point(prng, 0.15, 0.85);
    if (prng.chance(0.5)) {
      holes.push_back(ball(a, prng.between(0.05, 0.15)));
    } else {
      const Point3 b = random_point(prng, 0.1, 0.9);
      const double r = prng.between(0.03, 0.08);
      holes.push_back(bone(a, b, r, prng.between(0.03, 0.08)));
    }
  }
  const double low = prng.between(0.15, 0.35);
  return without(plate(low, prng.between(0.6, 0.85)), std::move(holes));
}

Field random_horns(Prng& prng) {
  const Point3 centre = random_point(prng, 0.4, 0.6);
  std::vector<Field> parts{ball(centre, prng.between(0.12, 0.18))};
  for (std::uint64_t n = 2 + prng.below(5); n > 0; --n) {
    const Point3 d = random_direction(prng);
    const double length = prng.between(0.25, 0.35);
    const Point3 tip{centre.x + length * d.x, centre.y + length * d.y, centre.z + length * d.z};
    parts.push_back(bone(centre, tip, 0.05, 0.015));
  }
  return joined(std::move(parts), 0.03);
}

Field random_bundles(Prng& prng) {
  std::vector<Field> parts;
  const double lean = prng.between(0, 0.8), turn = prng.between(0, 6.28);
  const double pitch = prng.between(0.1, 0.16);
  for (int i = -2; i <= 2; ++i) {
    for (int j = -2; j <= 2; ++j) {
      if (prng.chance(0.3)) continue;
      const auto near = [&](double z) {
        return Point3{
            0.5 + pitch * i + 0.2 * pitch * prng.between(-1, 1) + lean * (z - 0.5) * std::cos(turn),
            0.5 + pitch * j + 0.2 * pitch * prng.between(-1, 1) + lean * (z - 0.5) * std::sin(turn),
            z};
      };
      const double r = pitch * prng.between(0.2, 0.42);
      const Point3 low = near(prng.between(0.1, 0.4));
      parts.push_back(bone(low, near(prng.between(0.6, 0.9)), r, pitch * prng.between(0.2, 0.42)));
    }
  }
  if (parts.empty()) parts.push_back(ball({0.5, 0.5, 0.5}, 0.2));
  return joined(std::move(parts), 1e-9);
}

Field random_field(SolidKind kind, Prng& prng) {
  switch (kind) {
    case SolidKind::blobs: return random_blobs(prng);
    case SolidKind::tubes: return random_tubes(prng);
    case SolidKind::rings: return random_rings(prng);
    case SolidKind::plates: return random_plates(prng);
    case SolidKind::horns: return random_horns(prng);
    case SolidKind::bundles: return random_bundles(prng);
  }
  return {};
}

}  // namespace

std::string_view name_of(SolidKind kind) {
  constexpr std::array<std::string_view, 6> names{"blobs",  "tubes", "rings",
                                                  "plates", "horns", "bundles"};
  return names[static_cast<std::size_t>(kind)];
}

SampledSolid sample_solid(SolidKind kind, std::uint64_t seed, std::size_t size) {
  Prng prng(seed * 8 + static_cast<std::uint64_t>(kind));
  const Field field = random_field(kind, prng);
  SampledSolid solid{size, size, size, std::vector<float>(size * size * size, 1.0F)};
  const double step = 1 / static_cast<double>(size - 1);
  for (std::size_t z = 1; z + 1 < size; ++z) {
    for (std::size_t y = 1; y + 1 < size; ++y) {
      for (std::size_t x = 1; x + 1 < size; ++x) {
        auto value =
            static_cast<float>(field({static_cast<double>(x) * step, static_cast<double>(y) * step,
                                      static_cast<double>(z) * step}) /
                               step);
        if (value == 0) value = -1e-3F;  // contours do not pass through samples
        solid.value[(z * size + y) * size + x] = value;
      }
    }
  }
  return solid;
}

SolidTruth truth_of(const SampledSolid& solid) {
  // Inside samples with their six neighbours are the vertices and edges of a cell complex whose
  // squares and cubes have all corners inside.
  SolidTruth truth;
  const std::size_t nx = solid.nx, ny = solid.ny, nz = solid.nz;
  const auto id = [&](std::size_t x, std::size_t y, std::size_t z) {
    return (z * ny + y) * nx + x;
  };
  UnionFind inside(solid.value.size());
  UnionFind outside(solid.value.size());
  long euler = 0;
  for (std::size_t z = 0; z < nz; ++z) {
    for (std::size_t y = 0; y < ny; ++y) {
      for (std::size_t x = 0; x < nx; ++x) {
        // Corners of the cell from here on, bit by bit x, y, z.
        const auto corner = [&](unsigned k) {
          return std::array{x + (k & 1U), y + (k >> 1U & 1U), z + (k >> 2U & 1U)};
        };
        unsigned here = 0, within = 0;
        for (unsigned k = 0; k < 8; ++k) {
          const auto [cx, cy, cz] = corner(k);
          if (cx >= nx || cy >= ny || cz >= nz) continue;
          within |= 1U << k;
          if (solid.inside(cx, cy, cz)) here |= 1U << k;
        }
        const auto all = [&](unsigned mask) { return (here & mask) == mask; };
        if ((here & 1U) != 0) {
          euler += 1 - (all(0x03) ? 1 : 0) - (all(0x05) ? 1 : 0) - (all(0x11) ? 1 : 0) +
                   (all(0x0F) ? 1 : 0) + (all(0x33) ? 1 : 0) + (all(0x55) ? 1 : 0) -
                   (all(0xFF) ? 1 : 0);
          truth.volume += 1;
        }
        for (const unsigned k : {1U, 2U, 4U}) {
          if ((here & 1U) == 0 || (here >> k & 1U) == 0) continue;
          const auto [cx, cy, cz] = corner(k);
          inside.unite(id(x, y, z), id(cx, cy, cz));
        }
        // Two outside samples are connected where no inside ones part them: in a common cell.
        std::size_t first = SIZE_MAX;
        for (unsigned k = 0; k < 8; ++k) {
          if ((within >> k & 1U) == 0 || (here >> k & 1U) != 0) continue;
          const auto [cx, cy, cz] = corner(k);
          if (first == SIZE_MAX) first = id(cx, cy, cz);
          outside.unite(first, id(cx, cy, cz));
        }
      }
    }
  }
  long outsides = 0;
  for (std::size_t k = 0; k < solid.value.size(); ++k) {
    if (solid.value[k] < 0 && inside.find(k) == k) ++truth.components;
    if (solid.value[k] >= 0 && outside.find(k) == k) ++outsides;
  }
  truth.cavities = outsides - 1;
  truth.genus = truth.components + truth.cavities - euler;
  return truth;
}

SlicedSolid slice(const SampledSolid& solid, std::size_t spacing, Contouring contouring) {
  SlicedSolid result;
  const std::size_t layer = solid.nx * solid.ny;
  const auto occupied = [&](std::size_t z) {
    const auto begin = solid.value.begin() + static_cast<std::ptrdiff_t>(z * layer);
    return std::any_of(begin, begin + static_cast<std::ptrdiff_t>(layer),
                       [](float v) { return v < 0; });
  };
  std::vector<std::size_t> layers;
  // Regions of a section, in order, each by a sample inside it.
  std::vector<std::vector<std::size_t>> samples;
  for (std::size_t z = spacing / 2; z < solid.nz; z += spacing) {
    if (!occupied(z)) {
      if (layers.empty()) continue;
      break;  // a solid in two parts: the lower one
    }
    const MaskedSection traced =
        marching_squares(solid.value.data() + z * layer, solid.nx, solid.ny, contouring);
    Section section = traced.section;
    section.z = static_cast<double>(z);
    const Nesting nesting = nest(section);
    std::vector<std::size_t> of_region;
    for (const ContourId outer : nesting.outer) {
      of_region.push_back(traced.sample[outer] + z * layer);
    }
    samples.push_back(std::move(of_region));
    layers.push_back(z);
    result.stack.sections.push_back(std::move(section));
  }
  for (std::size_t s = 0; s + 1 < layers.size(); ++s) {
    const std::size_t first = layers[s] * layer;
    UnionFind sets((layers[s + 1] - layers[s] + 1) * layer);
    for (std::size_t z = layers[s]; z <= layers[s + 1]; ++z) {
      for (std::size_t k = z * layer; k < (z + 1) * layer; ++k) {
        if (solid.value[k] >= 0) continue;
        // No sample of the outermost ring is inside.
        if (solid.value[k + 1] < 0) sets.unite(k - first, k + 1 - first);
        if (solid.value[k + solid.nx] < 0) sets.unite(k - first, k + solid.nx - first);
        if (z < layers[s + 1] && solid.value[k + layer] < 0) {
          sets.unite(k - first, k + layer - first);
        }
      }
    }
    std::vector<std::size_t> pieces;
    for (const std::size_t k : samples[s]) pieces.push_back(sets.find(k - first));
    for (const std::size_t k : samples[s + 1]) pieces.push_back(sets.find(k - first));
    result.piece.push_back(std::move(pieces));
  }
  return result;
}

}  // namespace tetloft::bench

#include "support/stacks/broken.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "support/stacks/bitmap.hpp"
#include "support/stacks/shapes.hpp"

namespace tetloft::testing {

namespace {

Contour turned_round(Contour contour) {
  std::reverse(contour.vertices.begin(), contour.vertices.end());
  return contour;
}

Contour trace_at(Prng& prng, Point2 centre, double radius) {
  switch (number(prng, 0, 2)) {
    case 0: return blob(prng, centre, 0.7 * radius, radius, number(prng, 5, 24));
    case 1: return regular_polygon(centre, radius, number(prng, 3, 12), prng.between(0, kPi));
    default:
      return rectangle({centre.x - radius, centre.y - radius / 2},
                       {centre.x + radius, centre.y + radius * prng.between(0.3, 1)});
  }
}

BrokenStack draft_overlaps(Prng& prng) {
  BrokenStack broken;
  broken.repair.fill = static_cast<FillRule>(prng.below(3));
  std::vector<Layer> layers(number(prng, 2, 3));
  const std::size_t traces = number(prng, 2, 4);
  for (Layer& layer : layers) {
    layer.push_back(blob(prng, {0, 0}, 3, 4, number(prng, 8, 24)));
    for (std::size_t k = 1; k < traces; ++k) {
      const double way = prng.between(0, 2 * kPi);
      const double far = prng.between(0.5, 5);
      layer.push_back(trace_at(prng, {far * std::cos(way), far * std::sin(way)}, 3));
    }
    if (prng.chance(0.5)) layer.push_back(turned_round(regular_polygon({0, 0}, 0.5, 7, 0.1)));
    if (prng.chance(0.3)) layer.push_back(regular_polygon({20, 0}, 1, 6, 0));
  }
  broken.stack = stack_of(layers, heights(prng, layers.size()));
  return broken;
}

double with_digits(double x, double unit) { return std::round(x / unit) * unit; }

BrokenStack draft_copies(Prng& prng) {
  BrokenStack broken;
  std::vector<Layer> layers(number(prng, 2, 4));
  broken.holes = number(prng, 0, 1);
  for (Layer& layer : layers) {
    layer.push_back(blob(prng, {0, 0}, 6, 9, number(prng, 6, 30)));
    if (broken.holes == 1U) layer.push_back(regular_polygon({0, 0}, 2, number(prng, 5, 12), 0.2));
    const std::size_t given = layer.size();
    for (std::size_t k = 0; k < given; ++k) {
      Contour copy = layer[k];
      if (prng.chance(0.7)) {
        for (Point2& p : copy.vertices) p = {with_digits(p.x, 0.001), with_digits(p.y, 0.001)};
        copy.vertices.front() = layer[k].vertices.front();  // they touch
      }
      std::rotate(copy.vertices.begin(), copy.vertices.begin() + 1, copy.vertices.end());
      layer.push_back(prng.chance(0.5) ? copy : turned_round(copy));
      if (prng.chance(0.2)) layer.push_back(layer[k]);
    }
  }
  broken.stack = stack_of(layers, heights(prng, layers.size()));
  return broken;
}

Point2 towards(const Point2& p, const Point2& q, double by) {
  const double all = std::hypot(q.x - p.x, q.y - p.y);
  return {p.x + by / all * (q.x - p.x), p.y + by / all * (q.y - p.y)};
}

// A hole as a channel from direction `angle` comes to it: clockwise, from beside its vertex there
// back to that vertex; and on to `beyond` from the vertex opposite.
std::vector<Point2> hole_walk(Point2 centre, double radius, double angle, double width,
                              const std::vector<Point2>& beyond) {
  constexpr std::size_t kSides = 10;
  const Contour hole = regular_polygon(centre, radius, kSides, angle);
  const auto at = [&](std::size_t k) { return hole.vertices[k % kSides]; };
  std::vector<Point2> walk{towards(at(0), at(kSides - 1), width)};
  for (std::size_t k = kSides - 1; k > 0; --k) {
    if (k == kSides / 2 && !beyond.empty()) {
      walk.push_back(towards(at(k), at(k + 1), width));
      walk.insert(walk.end(), beyond.begin(), beyond.end());
    }
    walk.push_back(at(k));
  }
  walk.push_back(at(0));
  return walk;
}

Layer keyholed(Prng& prng, std::size_t holes, double width, double angle) {
  const Contour outline = regular_polygon({0, 0}, 12, number(prng, 12, 40), angle);
  const auto on_way = [&](double from_centre) {
    return Point2{from_centre * std::cos(angle), from_centre * std::sin(angle)};
  };
  std::vector<Point2> far;
  if (holes == 2) far = hole_walk(on_way(-3), prng.between(1, 2), angle, width, {});
  const std::vector<Point2> near = hole_walk(on_way(5), prng.between(1.5, 3), angle, width, far);
  Contour contour = outline;
  contour.vertices.push_back(towards(outline.vertices.front(), outline.vertices.back(), width));
  contour.vertices.insert(contour.vertices.end(), near.begin(), near.end());
  return {contour};
}

// A disc with a hole and a channel of one pixel.
Layer pinholed(Prng& prng, bool smooth) {
  constexpr int kSize = 25;
  Bitmap bitmap(kSize, kSize);
  const double outer = prng.between(9.5, 11.5);
  const double inner = prng.between(3, 5);
  for (int y = 0; y < kSize; ++y) {
    for (int x = 0; x < kSize; ++x) {
      const int square = (x - 12) * (x - 12) + (y - 12) * (y - 12);
      const bool in_channel = y == 12 && x >= 12;
      bitmap.set(x, y, square < outer * outer && square > inner * inner && !in_channel);
    }
  }
  bitmap = without_diagonals(bitmap);
  return smooth ? marching_squares(bitmap, false) : staircase(bitmap, prng.chance(0.5));
}

BrokenStack draft_keyholes(Prng& prng) {
  BrokenStack broken;
  std::vector<Layer> layers(number(prng, 2, 4));
  if (prng.chance(0.3)) {
    broken.holes = 1;
    broken.repair.keyholes = 1.0;
    const bool smooth = prng.chance(0.5);
    for (Layer& layer : layers) layer = pinholed(prng, smooth);
  } else {
    constexpr std::array kWidths{0.0, 1e-9, 0.001, 0.05, 0.3};
    const double width = kWidths[prng.below(kWidths.size())];
    broken.holes = number(prng, 1, 2);
    if (width > 0 || prng.chance(0.5)) broken.repair.keyholes = std::max(1.001 * width, 1e-6);
    const double angle = prng.between(0, 2 * kPi);
    for (Layer& layer : layers) layer = keyholed(prng, *broken.holes, width, angle);
  }
  broken.stack = stack_of(layers, heights(prng, layers.size()));
  return broken;
}

// Puts a contour of some sections into one of its own, in the same plane or `apart` above.
SectionStack split_planes(Prng& prng, const SectionStack& stack, double apart) {
  SectionStack result;
  for (Section section : stack.sections) {
    Section other;
    if (prng.chance(0.5)) {
      other.z = section.z + apart;
      other.contours.push_back(section.contours.raw().back());
      section.contours.raw().pop_back();
    }
    result.sections.push_back(section);
    if (!other.contours.empty()) result.sections.push_back(other);
  }
  return result;
}

BrokenStack draft_planes(Prng& prng) {
  BrokenStack broken;
  std::vector<Layer> layers(number(prng, 2, 4));
  for (Layer& layer : layers) {
    layer = {blob(prng, {0, 0}, 3, 4, number(prng, 8, 20)), regular_polygon({0, 0}, 1, 8, 0),
             blob(prng, {12, 0}, 2, 3, number(prng, 6, 12))};
  }
  broken.holes = 1;
  broken.ordered = stack_of(layers, heights(prng, layers.size()));
  broken.planes = PlaneOptions{static_cast<PlaneRule>(prng.below(3)), 0};
  broken.stack = *broken.ordered;
  auto& sections = broken.stack.sections.raw();
  if (broken.planes->rule == PlaneRule::merge) {
    broken.planes->tolerance = 1e-3;
    broken.stack = split_planes(prng, *broken.ordered, prng.between(1e-6, 1e-3));
    prng.shuffle(sections);
  } else if (broken.planes->rule == PlaneRule::sort) {
    broken.stack = split_planes(prng, *broken.ordered, 0);
    prng.shuffle(sections);
  } else {
    std::reverse(sections.begin(), sections.end());
  }
  return broken;
}

}  // namespace

BrokenStack draft_broken(BrokenKind kind, Prng& prng) {
  switch (kind) {
    case BrokenKind::overlaps: return draft_overlaps(prng);
    case BrokenKind::copies: return draft_copies(prng);
    case BrokenKind::keyholes: return draft_keyholes(prng);
    case BrokenKind::planes: break;
  }
  return draft_planes(prng);
}

BrokenStack broken(BrokenKind kind, std::uint64_t seed) {
  Prng prng(seed ^ (0x9FB21C651E98DF25ULL * (static_cast<std::uint64_t>(kind) + 1)));
  return draft_broken(kind, prng);
}

SectionStack mended(const BrokenStack& broken) {
  SectionStack stack = broken.stack;
  if (broken.planes) {
    auto arranged = arrange_planes(stack, *broken.planes);
    if (!arranged) return {};
    stack = std::move(arranged->stack);
  }
  auto repaired = repair(stack, broken.repair);
  return repaired ? std::move(repaired->stack) : SectionStack{};
}

}  // namespace tetloft::testing

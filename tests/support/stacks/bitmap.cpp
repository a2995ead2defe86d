#include "support/stacks/bitmap.hpp"

#include <array>

namespace tetloft::testing {
namespace {

constexpr std::int32_t kNone = -1;

// Directed segments between points of a lattice, each point with at most one successor.
class Loops {
 public:
  Loops(int width, int height)
      : width_(width), next_(static_cast<std::size_t>(width * height), kNone) {}

  void connect(int x0, int y0, int x1, int y1) {
    next_[static_cast<std::size_t>(y0 * width_ + x0)] = y1 * width_ + x1;
  }

  // The closed chains, by lowest lattice point; (x, y) goes through `place`.
  [[nodiscard]] Layer trace(const std::function<Point2(int, int)>& place) {
    Layer layer;
    for (std::size_t start = 0; start < next_.size(); ++start) {
      if (next_[start] == kNone) continue;
      Contour contour;
      for (auto at = static_cast<std::int32_t>(start);
           next_[static_cast<std::size_t>(at)] != kNone;) {
        contour.vertices.push_back(place(at % width_, at / width_));
        const std::int32_t successor = next_[static_cast<std::size_t>(at)];
        next_[static_cast<std::size_t>(at)] = kNone;
        at = successor;
      }
      layer.push_back(std::move(contour));
    }
    return layer;
  }

 private:
  int width_;
  std::vector<std::int32_t> next_;
};

Contour without_straight_vertices(const Contour& contour) {
  Contour result;
  const std::size_t n = contour.vertices.size();
  for (std::size_t i = 0; i < n; ++i) {
    const Point2& p = contour.vertices[(i + n - 1) % n];
    const Point2& q = contour.vertices[i];
    const Point2& r = contour.vertices[(i + 1) % n];
    const bool straight = (p.x == q.x && q.x == r.x) || (p.y == q.y && q.y == r.y);
    if (!straight) result.vertices.push_back(q);
  }
  return result;
}

Bitmap majority(const Bitmap& bitmap) {
  Bitmap result = bitmap;
  for (int y = 0; y < bitmap.height(); ++y) {
    for (int x = 0; x < bitmap.width(); ++x) {
      int votes = 0;
      for (int dy = -1; dy <= 1; ++dy) {
        for (int dx = -1; dx <= 1; ++dx) votes += bitmap.at(x + dx, y + dy) ? 1 : 0;
      }
      result.set(x, y, votes >= 5);
    }
  }
  return result;
}

}  // namespace

Bitmap random_bitmap(Prng& prng, int width, int height, double density, int smoothing) {
  Bitmap bitmap(width, height);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) bitmap.set(x, y, prng.chance(density));
  }
  for (int i = 0; i < smoothing; ++i) bitmap = majority(bitmap);
  return bitmap;
}

Bitmap flipped(Prng& prng, const Bitmap& bitmap, double p) {
  Bitmap result = bitmap;
  for (int y = 0; y < bitmap.height(); ++y) {
    for (int x = 0; x < bitmap.width(); ++x) {
      if (prng.chance(p)) result.set(x, y, !bitmap.at(x, y));
    }
  }
  return result;
}

Bitmap without_diagonals(Bitmap bitmap) {
  for (bool changed = true; changed;) {
    changed = false;
    for (int y = 0; y + 1 < bitmap.height(); ++y) {
      for (int x = 0; x + 1 < bitmap.width(); ++x) {
        const bool a = bitmap.at(x, y);
        const bool b = bitmap.at(x + 1, y);
        const bool c = bitmap.at(x + 1, y + 1);
        const bool d = bitmap.at(x, y + 1);
        if (a != c || b != d || a == b) continue;
        bitmap.set(a ? x + 1 : x, y, true);
        changed = true;
      }
    }
  }
  return bitmap;
}

Layer marching_squares(const Bitmap& bitmap, bool join_diagonals,
                       const std::function<Point2(int, int)>& place) {
  // Cell (x, y) has the pixel centres (x, y) … (x + 1, y + 1) as corners, counter-clockwise;
  // its side k runs from corner k to k + 1. In doubled coordinates, shifted by 2, the
  // midpoint of side k is 2 (x, y) + kMiddle[k].
  constexpr std::array<std::array<int, 2>, 4> kCorner{{{0, 0}, {1, 0}, {1, 1}, {0, 1}}};
  constexpr std::array<std::array<int, 2>, 4> kMiddle{{{3, 2}, {4, 3}, {3, 4}, {2, 3}}};
  Loops loops(2 * bitmap.width() + 4, 2 * bitmap.height() + 4);
  for (int y = -1; y < bitmap.height(); ++y) {
    for (int x = -1; x < bitmap.width(); ++x) {
      const auto set = [&](std::size_t k) {
        return bitmap.at(x + kCorner[k % 4][0], y + kCorner[k % 4][1]);
      };
      const bool ambiguous = set(0) == set(2) && set(1) == set(3) && set(0) != set(1);
      for (std::size_t k = 0; k < 4; ++k) {
        if (!set(k) || set(k + 1)) continue;
        // The outline enters at side k, set pixels on its left, and leaves where the walk
        // around the cell finds set pixels again: around the unset corners, or, to part
        // the set pixels of an ambiguous cell, right behind corner k.
        std::size_t out = k + 1;
        while (set(out) || !set(out + 1)) ++out;
        if (ambiguous && !join_diagonals) out = k + 3;
        loops.connect(2 * x + kMiddle[k][0], 2 * y + kMiddle[k][1], 2 * x + kMiddle[out % 4][0],
                      2 * y + kMiddle[out % 4][1]);
      }
    }
  }
  return loops.trace([&](int x, int y) { return place(x - 2, y - 2); });
}

Layer marching_squares(const Bitmap& bitmap, bool join_diagonals) {
  return marching_squares(bitmap, join_diagonals, [](int x2, int y2) {
    return Point2{0.5 * x2, 0.5 * y2};
  });
}

Layer staircase(const Bitmap& bitmap, bool merge_collinear) {
  Loops loops(bitmap.width() + 1, bitmap.height() + 1);
  for (int y = 0; y < bitmap.height(); ++y) {
    for (int x = 0; x < bitmap.width(); ++x) {
      if (!bitmap.at(x, y)) continue;
      if (!bitmap.at(x, y - 1)) loops.connect(x, y, x + 1, y);
      if (!bitmap.at(x + 1, y)) loops.connect(x + 1, y, x + 1, y + 1);
      if (!bitmap.at(x, y + 1)) loops.connect(x + 1, y + 1, x, y + 1);
      if (!bitmap.at(x - 1, y)) loops.connect(x, y + 1, x, y);
    }
  }
  Layer layer = loops.trace([](int x, int y) {
    return Point2{static_cast<double>(x), static_cast<double>(y)};
  });
  if (merge_collinear) {
    for (Contour& contour : layer) contour = without_straight_vertices(contour);
  }
  return layer;
}

}  // namespace tetloft::testing

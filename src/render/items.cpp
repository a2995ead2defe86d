#include "render/items.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace tetloft::internal::render {

namespace {

constexpr float kNowhere = -std::numeric_limits<float>::infinity();

// A linear form on pixels with whole coefficients.
struct Form {
  double x = 0, y = 0;

  [[nodiscard]] double of(const Projected& p) const { return x * p.x + y * p.y; }
};

struct Range {
  std::size_t first = 0, end = 0;
};

// Pixels of a row or column with centres between two positions, and some more.
Range pixels_between(double low, double high, std::size_t size) {
  const auto clamped = [size](double value) {
    return static_cast<std::size_t>(std::clamp(value, 0.0, static_cast<double>(size)));
  };
  return {clamped(std::floor(low - 0.5)), clamped(std::ceil(high + 0.5))};
}

class Painter {
 public:
  explicit Painter(ItemBuffer& buffer)
      : buffer_(buffer),
        squares_across_(buffer.pyramid.levels()[0].width),
        written_(buffer.pyramid.levels()[0].farthest.size(), 0) {}

  void paint(const std::array<Projected, 3>& corner, std::uint32_t number, float nearest) {
    p_ = corner;
    number_ = number;
    nearest_ = nearest;
    area_ = (p_[1].x - p_[0].x) * (p_[2].y - p_[0].y) - (p_[2].x - p_[0].x) * (p_[1].y - p_[0].y);
    const auto [left, right] = std::minmax({p_[0].x, p_[1].x, p_[2].x});
    const auto [top, bottom] = std::minmax({p_[0].y, p_[1].y, p_[2].y});
    columns_ = pixels_between(left, right, buffer_.width);
    rows_ = pixels_between(top, bottom, buffer_.height);
    ++buffer_.visits;
    if (columns_.first >= columns_.end || rows_.first >= rows_.end) return;
    if (buffer_.pyramid.hides(columns_.first, rows_.first, columns_.end, rows_.end, nearest_)) {
      return;
    }
    // Squares are worth while where the triangle fills most of those it meets: by its mean width.
    constexpr double kBroad = 2 * DepthPyramid::kSide;
    if (-area_ > 2 * kBroad * std::max(right - left, bottom - top)) {
      paint_squares(buffer_.pyramid.levels().size() - 1, 0, 0);
    } else {
      paint_thin();
    }
  }

 private:
  // Twice the area, with sign, of the triangle of a side and a pixel, by the area.
  [[nodiscard]] double weight(std::size_t from, std::size_t to, double px, double py) const {
    const Projected& a = p_[from];
    const Projected& b = p_[to];
    return ((b.x - a.x) * (py - a.y) - (b.y - a.y) * (px - a.x)) / area_;
  }

  void paint_pixel(std::size_t x, std::size_t y) {
    ++buffer_.visits;
    const double px = static_cast<double>(x) + 0.5;
    const double py = static_cast<double>(y) + 0.5;
    const double w0 = weight(1, 2, px, py);
    if (w0 < 0) return;
    const double w1 = weight(2, 0, px, py);
    if (w1 < 0) return;
    const double w2 = weight(0, 1, px, py);
    if (w2 < 0) return;
    const float depth = std::min(
        static_cast<float>(w0 * p_[0].depth + w1 * p_[1].depth + w2 * p_[2].depth), nearest_);
    const std::size_t at = buffer_.at(x, y);
    if (buffer_.depth[at] >= depth) return;
    buffer_.item[at] = number_;
    buffer_.depth[at] = depth;
    constexpr std::size_t kSide = DepthPyramid::kSide;
    std::uint8_t& written = written_[y / kSide * squares_across_ + x / kSide];
    if (++written < kSide * kSide) return;
    written = 0;
    measure_square(x / kSide, y / kSide);
  }

  void measure_square(std::size_t column, std::size_t row) {
    constexpr std::size_t kSide = DepthPyramid::kSide;
    float farthest = std::numeric_limits<float>::infinity();
    for (std::size_t y = row * kSide; y < std::min((row + 1) * kSide, buffer_.height); ++y) {
      for (std::size_t x = column * kSide; x < std::min((column + 1) * kSide, buffer_.width); ++x) {
        farthest = std::min(farthest, buffer_.depth[buffer_.at(x, y)]);
      }
    }
    buffer_.pyramid.raise(column, row, farthest);
  }

  // Whether a side of the triangle has all pixels of a rectangle on its outer side.
  [[nodiscard]] bool misses(const Range& columns, const Range& rows) const {
    for (std::size_t from = 0; from < 3; ++from) {
      const std::size_t to = (from + 1) % 3;
      // The corner of the rectangle that lies farthest to the inner side (y runs downwards).
      const bool right = p_[to].y > p_[from].y;
      const bool bottom = p_[to].x < p_[from].x;
      const double px =
          right ? static_cast<double>(columns.end) : static_cast<double>(columns.first);
      const double py = bottom ? static_cast<double>(rows.end) : static_cast<double>(rows.first);
      if (weight(from, to, px, py) < 0) return true;
    }
    return false;
  }

  void paint_squares(std::size_t level, std::size_t column, std::size_t row) {
    const DepthPyramid::Level& squares = buffer_.pyramid.levels()[level];
    if (column >= squares.width || row >= squares.height) return;
    ++buffer_.visits;
    if (squares.farthest[row * squares.width + column] >= nearest_) return;
    const std::size_t side = DepthPyramid::kSide << level;
    const Range columns{std::max(columns_.first, column * side),
                        std::min(columns_.end, (column + 1) * side)};
    const Range rows{std::max(rows_.first, row * side), std::min(rows_.end, (row + 1) * side)};
    if (columns.first >= columns.end || rows.first >= rows.end || misses(columns, rows)) return;
    if (level > 0) {
      for (std::size_t k = 0; k < 4; ++k) {
        paint_squares(level - 1, 2 * column + k % 2, 2 * row + k / 2);
      }
      return;
    }
    for (std::size_t y = rows.first; y < rows.end; ++y) {
      for (std::size_t x = columns.first; x < columns.end; ++x) paint_pixel(x, y);
    }
  }

  // The two forms that vary least over the triangle, by reduction of their lattice (Lagrange,
  // Gauss): few lines form = integer meet the triangle, and these along their pixels. A needle
  // that slips between the pixels is done with at once, however long it is.
  [[nodiscard]] std::array<Form, 2> least_forms() const {
    const auto product = [this](const Form& f, const Form& g) {
      double sum = 0;
      for (std::size_t i = 0; i < 3; ++i) {
        const Projected& a = p_[i];
        const Projected& b = p_[(i + 1) % 3];
        sum += (f.of(b) - f.of(a)) * (g.of(b) - g.of(a));
      }
      return sum;
    };
    Form f{0, 1}, g{1, 0};
    // Each round but the last shortens the longer one: their number goes with its logarithm.
    for (;;) {
      if (product(f, f) > product(g, g)) std::swap(f, g);
      const double square = product(f, f);
      if (square < 1) break;
      const double times = std::round(product(f, g) / square);
      if (times == 0) break;
      const Form shorter{g.x - times * f.x, g.y - times * f.y};
      if (!(product(shorter, shorter) < product(g, g))) break;
      g = shorter;
    }
    return {f, g};
  }

  // Lines of one form, and on each the pixels by the other.
  void paint_thin() {
    constexpr double kSlack = 1e-5;  // forms are rounded by less
    const auto [f, g] = least_forms();
    const double determinant = f.x * g.y - f.y * g.x;  // 1 or −1
    std::array<double, 3> along{}, across{};
    for (std::size_t i = 0; i < 3; ++i) {
      const Projected from_centre{p_[i].x - 0.5, p_[i].y - 0.5, 0};
      across[i] = f.of(from_centre);
      along[i] = g.of(from_centre);
    }
    const auto [low, high] = std::minmax({across[0], across[1], across[2]});
    for (double k = std::ceil(low - kSlack); k <= high + kSlack; ++k) {
      ++buffer_.visits;
      // The part of the triangle in a narrow strip around the line.
      double first = std::numeric_limits<double>::infinity();
      double last = -first;
      for (std::size_t i = 0; i < 3; ++i) {
        const std::size_t j = (i + 1) % 3;
        const double rise = across[j] - across[i];
        for (const double side : {k - kSlack, k + kSlack}) {
          const double t = rise == 0 ? 0 : std::clamp((side - across[i]) / rise, 0.0, 1.0);
          if (std::abs(across[i] + t * rise - k) > 2 * kSlack) continue;
          first = std::min(first, along[i] + t * (along[j] - along[i]));
          last = std::max(last, along[i] + t * (along[j] - along[i]));
        }
      }
      for (double j = std::ceil(first - kSlack); j <= last + kSlack; ++j) {
        const double x = (k * g.y - j * f.y) / determinant;
        const double y = (j * f.x - k * g.x) / determinant;
        if (x < 0 || y < 0 || x >= static_cast<double>(buffer_.width) ||
            y >= static_cast<double>(buffer_.height)) {
          continue;
        }
        paint_pixel(static_cast<std::size_t>(x), static_cast<std::size_t>(y));
      }
    }
  }

  ItemBuffer& buffer_;
  std::size_t squares_across_;
  std::vector<std::uint8_t> written_;  // by square of level 0: pixels since it was measured
  std::array<Projected, 3> p_;
  std::uint32_t number_ = 0;
  float nearest_ = 0;
  double area_ = 0;
  Range columns_, rows_;
};

}  // namespace

DepthPyramid::DepthPyramid(std::size_t width, std::size_t height) {
  for (std::size_t side = kSide;; side *= 2) {
    const std::size_t across = (width + side - 1) / side;
    const std::size_t along = (height + side - 1) / side;
    level_.push_back({across, along, std::vector<float>(across * along, kNowhere)});
    if (across <= 1 && along <= 1) return;
  }
}

bool DepthPyramid::hides(std::size_t x0, std::size_t y0, std::size_t x1, std::size_t y1,
                         float nearest) const {
  std::size_t level = 0;
  const auto square = [&](std::size_t pixel) { return pixel / kSide >> level; };
  while (square(x1 - 1) - square(x0) > 1 || square(y1 - 1) - square(y0) > 1) ++level;
  for (std::size_t y = square(y0); y <= square(y1 - 1); ++y) {
    for (std::size_t x = square(x0); x <= square(x1 - 1); ++x) {
      if (level_[level].farthest[y * level_[level].width + x] < nearest) return false;
    }
  }
  return true;
}

void DepthPyramid::raise(std::size_t x, std::size_t y, float farthest) {
  for (std::size_t k = 0;; ++k) {
    Level& level = level_[k];
    float& known = level.farthest[y * level.width + x];
    if (farthest <= known) return;
    known = farthest;
    if (k + 1 == level_.size()) return;
    x /= 2;
    y /= 2;
    for (std::size_t j = 2 * y; j < std::min(2 * y + 2, level.height); ++j) {
      for (std::size_t i = 2 * x; i < std::min(2 * x + 2, level.width); ++i) {
        farthest = std::min(farthest, level.farthest[j * level.width + i]);
      }
    }
  }
}

ItemBuffer::ItemBuffer(std::size_t w, std::size_t h)
    : width(w), height(h), item(w * h, kNothing), depth(w * h, kNowhere), pyramid(w, h) {}

ItemBuffer draw_items(const Scene& scene, const View& view, std::size_t width, std::size_t height) {
  struct Facing {
    float nearest;
    std::uint32_t triangle;
  };
  const auto projected = [&](std::size_t k) {
    const auto& corner = scene.triangles[k].corner;
    return std::array{view.project(corner[0]), view.project(corner[1]), view.project(corner[2])};
  };
  std::vector<Facing> facing;
  for (std::size_t k = 0; k < scene.triangles.size(); ++k) {
    const auto p = projected(k);
    const double area =
        (p[1].x - p[0].x) * (p[2].y - p[0].y) - (p[2].x - p[0].x) * (p[1].y - p[0].y);
    if (!(area < 0)) continue;  // y runs downwards
    facing.push_back({static_cast<float>(std::max({p[0].depth, p[1].depth, p[2].depth})),
                      static_cast<std::uint32_t>(k)});
  }
  std::sort(facing.begin(), facing.end(), [](const Facing& a, const Facing& b) {
    return a.nearest != b.nearest ? a.nearest > b.nearest : a.triangle < b.triangle;
  });
  ItemBuffer buffer(width, height);
  Painter painter(buffer);
  for (const Facing& f : facing) painter.paint(projected(f.triangle), f.triangle, f.nearest);
  return buffer;
}

}  // namespace tetloft::internal::render

// Far from all outlines, which is most of a window, there is nothing to look up: whole tiles are
// told by what the fields can be where their samples are moved to.
#include "between/layer_values.hpp"

#include <algorithm>
#include <cstdint>
#include <utility>

namespace tetloft::internal::between {

namespace {

using motion::LatticeWindow;

// Samples on an outline count as this far from it, in steps.
constexpr double kOnOutline = 0x1p-30;
// Samples of a tile along each axis: as of fields.
constexpr std::int64_t kTileSide = 8;

class Layer {
 public:
  Layer(const FieldsAround& around, const LatticeWindow& window, double share)
      : around_(around),
        window_(window),
        cubic_(share, around.beside),
        overgrown_(kOvergrowth * around.reach),
        value_(window.size()) {
    for (std::size_t s = 0; s < 4; ++s) by_[s] = around.share[s] - share;
  }

  void fill_at_rest() {
    std::array<std::vector<double>, 4> rows;
    std::array<const double*, 4> row{};
    for (std::int64_t j = window_.j0; j < window_.j1; ++j) {
      for (std::size_t s = 0; s < 4; ++s) {
        row[s] = around_.field[s].row(window_.i0, window_.i1, j, rows[s]);
      }
      double* const out = value_.data() + window_.place(window_.i0, j);
      for (std::size_t i = 0; i < window_.nx(); ++i) {
        out[i] = value([&](Around s) { return row[s][i]; });
      }
    }
  }

  void fill(const WindowMotion& motion) {
    for (const WindowMotion::Tile& tile : motion.tiles()) fill_tile(tile, motion.of_samples());
  }

  [[nodiscard]] std::vector<double> take() && { return std::move(value_); }

 private:
  // The value where the sections have these distances; fields behind and beyond are asked only
  // where they count.
  template <class Moved>
  [[nodiscard]] double value(const Moved& moved) const {
    const double low = moved(lower);
    const double high = moved(upper);
    if (std::min(low, high) >= overgrown_) return std::min(low, high);
    if (std::max(low, high) <= -around_.reach) return -around_.reach;
    const double v = cubic_.at({moved(behind), low, high, moved(beyond)});
    // What both sections share is not given up.
    return never_zero(low < 0 && high < 0 ? std::min(v, 0.5 * std::max(low, high)) : v);
  }

  // Where the samples of a tile are moved to in a section: rounding keeps order, so what is
  // computed from the ends of ranges bounds all between.
  [[nodiscard]] Box2 moved_to(const LatticeWindow& tile, const Box2& motion, std::size_t s) const {
    const auto [x0, x1] = std::minmax({by_[s] * motion.x0, by_[s] * motion.x1});
    const auto [y0, y1] = std::minmax({by_[s] * motion.y0, by_[s] * motion.y1});
    Box2 box;
    box.add(Point2{static_cast<double>(tile.i0) + x0, static_cast<double>(tile.j0) + y0});
    box.add(Point2{static_cast<double>(tile.i1 - 1) + x1, static_cast<double>(tile.j1 - 1) + y1});
    return box;
  }

  void fill_tile(const WindowMotion::Tile& moved, const std::vector<Point2>& motion) {
    const LatticeWindow& tile = moved.window;
    std::array<Box2, 4> box;
    for (std::size_t s = 0; s < 4; ++s) box[s] = moved_to(tile, moved.motions, s);
    const Depth depth = around_.field[lower].depth(box[lower]);
    if (depth != Depth::near && depth == around_.field[upper].depth(box[upper])) {
      fill_tile(tile, depth == Depth::far_outside ? around_.reach : -around_.reach);
      return;
    }
    bool sampled = true;
    for (std::size_t s = 0; s < 4; ++s) sampled = sampled && around_.field[s].samples_all(box[s]);
    if (sampled) {
      fill_tile(tile, motion,
                [&](Around s, double x, double y) { return around_.field[s].at_sampled(x, y); });
    } else {
      fill_tile(tile, motion,
                [&](Around s, double x, double y) { return around_.field[s].at(x, y); });
    }
  }

  void fill_tile(const LatticeWindow& tile, double value) {
    visit_rows(tile, [&](std::int64_t, std::size_t first) {
      std::fill_n(value_.begin() + static_cast<std::ptrdiff_t>(first), tile.nx(), value);
    });
  }

  // at(section, x, y): the distance there.
  template <class At>
  void fill_tile(const LatticeWindow& tile, const std::vector<Point2>& motion, const At& at) {
    visit_rows(tile, [&](std::int64_t j, std::size_t first) {
      const auto y = static_cast<double>(j);
      for (std::size_t k = 0; k < tile.nx(); ++k) {
        const auto x = static_cast<double>(tile.i0 + static_cast<std::int64_t>(k));
        const Point2& u = motion[first + k];
        value_[first + k] =
            value([&](Around s) { return at(s, x + by_[s] * u.x, y + by_[s] * u.y); });
      }
    });
  }

  // Calls visit(j, place of the first sample) for the rows of a tile.
  template <class Visit>
  void visit_rows(const LatticeWindow& tile, const Visit& visit) const {
    for (std::int64_t j = tile.j0; j < tile.j1; ++j) visit(j, window_.place(tile.i0, j));
  }

  const FieldsAround& around_;
  const LatticeWindow& window_;
  SectionCubic cubic_;
  double overgrown_;
  std::array<double, 4> by_{};  // of the motion, to each section
  std::vector<double> value_;
};

}  // namespace

WindowMotion::WindowMotion(const LatticeWindow& window, std::vector<Point2> of_samples)
    : of_samples_(std::move(of_samples)) {
  for (std::int64_t j0 = window.j0; j0 < window.j1; j0 += kTileSide) {
    for (std::int64_t i0 = window.i0; i0 < window.i1; i0 += kTileSide) {
      Tile tile{{i0, j0, std::min(i0 + kTileSide, window.i1), std::min(j0 + kTileSide, window.j1)},
                {}};
      for (std::int64_t j = j0; j < tile.window.j1; ++j) {
        const Point2* const row = of_samples_.data() + window.place(i0, j);
        for (std::size_t k = 0; k < tile.window.nx(); ++k) tile.motions.add(row[k]);
      }
      tiles_.push_back(tile);
    }
  }
}

double never_zero(double value) { return value == 0 ? kOnOutline : value; }

std::vector<double> layer_values(const FieldsAround& around, const LatticeWindow& window,
                                 const WindowMotion* motion, double share) {
  Layer layer(around, window, share);
  if (motion != nullptr) {
    layer.fill(*motion);
  } else {
    layer.fill_at_rest();
  }
  return std::move(layer).take();
}

}  // namespace tetloft::internal::between

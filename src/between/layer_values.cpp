// Far from all outlines, which is most of a window, there is nothing to look up: whole tiles are
// told by what the fields can be where their samples are moved to.
#include "between/layer_values.hpp"

#include <algorithm>
#include <cstdint>
#include <utility>

namespace tetloft::internal::between {

namespace {

using motion::LatticeWindow;

// Samples of a tile along each axis.
constexpr std::size_t kTileSide = 8;
constexpr auto kTileStep = static_cast<std::int64_t>(kTileSide);
using TileRow = std::array<double, kTileSide>;

class LayerFiller {
 public:
  LayerFiller(const FieldsAround& around, const LatticeWindow& window, double share)
      : around_(around),
        window_(window),
        cubic_(share, around.beside),
        overgrown_(kOvergrowth * around.reach),
        value_(window.size(), around.reach) {
    for (std::size_t s = 0; s < 4; ++s) by_[s] = around.share[s] - share;
  }

  // All at rest.
  void fill() {
    std::array<std::vector<double>, 4> rows;
    std::array<const double*, 4> row{};
    for (std::int64_t j0 = window_.j0; j0 < window_.j1; j0 += kTileStep) {
      const std::vector<LatticeWindow> near = fill_far(j0);
      for (std::int64_t j = j0; !near.empty() && j < near.front().j1; ++j) {
        for (std::size_t s = 0; s < 4; ++s) {
          row[s] = around_.field[s].row(window_.i0, window_.i1, j, rows[s]);
        }
        for (const LatticeWindow& tile : near) fill_row(tile, j, row);
      }
    }
  }

  void fill(const WindowMotion& motion) {
    for (const WindowMotion::Tile& tile : motion.tiles()) fill_tile(tile, motion.of_samples());
  }

  [[nodiscard]] std::vector<double> take() && { return std::move(value_); }

 private:
  // Fills the tiles of a row at rest that are far from all outlines, and returns the others.
  std::vector<LatticeWindow> fill_far(std::int64_t j) {
    std::vector<LatticeWindow> near;
    for (std::int64_t i = window_.i0; i < window_.i1; i += kTileStep) {
      const LatticeWindow tile{i, j, std::min(i + kTileStep, window_.i1),
                               std::min(j + kTileStep, window_.j1)};
      const Box2 box{static_cast<double>(tile.i0), static_cast<double>(tile.j0),
                     static_cast<double>(tile.i1 - 1), static_cast<double>(tile.j1 - 1)};
      if (!fill_far(tile, box, box)) near.push_back(tile);
    }
    return near;
  }

  // Fills a tile whose samples are moved into these boxes if that is far from all outlines.
  bool fill_far(const LatticeWindow& tile, const Box2& in_lower, const Box2& in_upper) {
    const Depth depth = around_.field[lower].depth(in_lower);
    if (depth == Depth::near || depth != around_.field[upper].depth(in_upper)) return false;
    if (depth == Depth::far_outside) return true;  // as all are from the beginning
    for (std::int64_t j = tile.j0; j < tile.j1; ++j) {
      std::fill_n(value_.begin() + static_cast<std::ptrdiff_t>(window_.place(tile.i0, j)),
                  tile.nx(), -around_.reach);
    }
    return true;
  }

  // Where the samples of a tile are moved to in a section: rounding keeps order, so what is
  // computed from the ends of ranges bounds all between.
  [[nodiscard]] Box2 moved_to(const LatticeWindow& tile, const Box2& motion, std::size_t s) const {
    const auto [x0, x1] = std::minmax({by_[s] * motion.x0, by_[s] * motion.x1});
    const auto [y0, y1] = std::minmax({by_[s] * motion.y0, by_[s] * motion.y1});
    return {static_cast<double>(tile.i0) + x0, static_cast<double>(tile.j0) + y0,
            static_cast<double>(tile.i1 - 1) + x1, static_cast<double>(tile.j1 - 1) + y1};
  }

  void fill_tile(const WindowMotion::Tile& moved, const std::vector<Point2>& motion) {
    const LatticeWindow& tile = moved.window;
    std::array<Box2, 4> box;
    for (std::size_t s = 0; s < 4; ++s) box[s] = moved_to(tile, moved.motions, s);
    if (fill_far(tile, box[lower], box[upper])) return;
    bool sampled = true;
    for (std::size_t s = 0; s < 4; ++s) sampled = sampled && around_.field[s].samples_all(box[s]);
    for (std::int64_t j = tile.j0; j < tile.j1; ++j) {
      const Point2* const u = motion.data() + window_.place(tile.i0, j);
      if (sampled) {
        fill_row(tile, j, u, [](const DistanceField& field) { return field.sampled(); });
      } else {
        fill_row(tile, j, u, [](const DistanceField& field) { return Anywhere{field}; });
      }
    }
  }

  // Row j of a tile at rest; `row`: of the window, in each section.
  void fill_row(const LatticeWindow& tile, std::int64_t j, std::array<const double*, 4> row) {
    const std::size_t n = tile.nx();
    for (const double*& p : row) p += tile.i0 - window_.i0;
    std::array<TileRow, 4> padded;
    if (n < kTileSide) {
      for (std::size_t s = 0; s < 4; ++s) {
        padded[s].fill(around_.reach);
        std::copy_n(row[s], n, padded[s].begin());
        row[s] = padded[s].data();
      }
    }
    put(tile, j,
        cubic_counts(row[lower], row[upper]) ? values(row) : far_values(row[lower], row[upper]));
  }

  struct Anywhere {
    const DistanceField& field;
    [[nodiscard]] double at(double x, double y) const { return field.at(x, y); }
  };

  // Row j of a tile, of these motions; of(field).at(x, y): the distance there.
  template <class Of>
  void fill_row(const LatticeWindow& tile, std::int64_t j, const Point2* motion, const Of& of) {
    const std::size_t n = tile.nx();
    const auto y = static_cast<double>(j);
    std::array<TileRow, 4> p;
    const auto look_up = [&](std::size_t s) {
      const auto distance = of(around_.field[s]);
      const double by = by_[s];
      TileRow& row = p[s];
      if (n < kTileSide) row.fill(around_.reach);
      for (std::size_t k = 0; k < n; ++k) {
        const auto x = static_cast<double>(tile.i0 + static_cast<std::int64_t>(k));
        row[k] = distance.at(x + by * motion[k].x, y + by * motion[k].y);
      }
    };
    look_up(lower);
    look_up(upper);
    if (!cubic_counts(p[lower].data(), p[upper].data())) {
      put(tile, j, far_values(p[lower].data(), p[upper].data()));
      return;
    }
    look_up(behind);
    look_up(beyond);
    put(tile, j, values({p[behind].data(), p[lower].data(), p[upper].data(), p[beyond].data()}));
  }

  void put(const LatticeWindow& tile, std::int64_t j, const TileRow& row) {
    std::copy_n(row.begin(), tile.nx(),
                value_.begin() + static_cast<std::ptrdiff_t>(window_.place(tile.i0, j)));
  }

  // Is one of a row not far from both sections?
  [[nodiscard]] bool cubic_counts(const double* low, const double* high) const {
    for (std::size_t k = 0; k < kTileSide; ++k) {
      if (std::min(low[k], high[k]) < overgrown_ && std::max(low[k], high[k]) > -around_.reach) {
        return true;
      }
    }
    return false;
  }
  [[nodiscard]] TileRow far_values(const double* low, const double* high) const {
    TileRow v;
    for (std::size_t k = 0; k < kTileSide; ++k) {
      const double least = std::min(low[k], high[k]);
      v[k] = least >= overgrown_ ? least : -around_.reach;
    }
    return v;
  }

  // From the distances in the four sections; without branches, which differ from sample to sample.
  [[nodiscard]] TileRow values(const std::array<const double*, 4>& p) const {
    const double far_inside = -around_.reach;
    const double overgrown = overgrown_;
    TileRow v = cubic_.at<kTileSide>(p);
    for (std::size_t k = 0; k < kTileSide; ++k) {
      const double low = p[lower][k];
      const double high = p[upper][k];
      const double cubic = v[k];
      const double least = high < low ? high : low;
      const double most = low < high ? high : low;
      // What both sections share is not given up.
      const double half = 0.5 * most;
      const double shared = half < cubic ? half : cubic;
      const double beside = most < 0 ? shared : cubic;
      const double within = most <= far_inside ? far_inside : beside;
      v[k] = least >= overgrown ? least : within;
    }
    for (double& value : v) value = never_zero(value);
    return v;
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
  for (std::int64_t j0 = window.j0; j0 < window.j1; j0 += kTileStep) {
    for (std::int64_t i0 = window.i0; i0 < window.i1; i0 += kTileStep) {
      Tile tile{{i0, j0, std::min(i0 + kTileStep, window.i1), std::min(j0 + kTileStep, window.j1)},
                {}};
      for (std::int64_t j = j0; j < tile.window.j1; ++j) {
        const Point2* const row = of_samples_.data() + window.place(i0, j);
        for (std::size_t k = 0; k < tile.window.nx(); ++k) tile.motions.add(row[k]);
      }
      tiles_.push_back(tile);
    }
  }
}

std::vector<double> layer_values(const FieldsAround& around, const LatticeWindow& window,
                                 const WindowMotion* motion, double share) {
  LayerFiller layer(around, window, share);
  if (motion != nullptr) {
    layer.fill(*motion);
  } else {
    layer.fill();
  }
  return std::move(layer).take();
}

}  // namespace tetloft::internal::between

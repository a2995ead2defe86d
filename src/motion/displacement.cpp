#include "motion/displacement.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace tetloft::internal::motion {

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
// In lattice units: displacements within a gap are tried, and samples count up to three gaps from
// the region. In gaps, squared, for each of displacement: 1/64. All three settled by measurement,
// and flat: README.
constexpr std::int64_t kRadius = kStepsPerGap;
constexpr double kSearchReach = 3 * kStepsPerGap;
constexpr double kStiffness = 1.0 / 64;
// Samples count a gap apart along each axis.
constexpr std::int64_t kStride = kStepsPerGap;

struct Step {
  std::int64_t i = 0, j = 0;
  [[nodiscard]] constexpr std::int64_t length2() const { return i * i + j * j; }
};

constexpr std::size_t count_steps() {
  std::size_t n = 0;
  for (std::int64_t i = -kRadius; i <= kRadius; ++i) {
    for (std::int64_t j = -kRadius; j <= kRadius; ++j) {
      if (Step{i, j}.length2() <= kRadius * kRadius) ++n;
    }
  }
  return n;
}

// All displacements within the radius, by length and then by (i, j).
constexpr auto kSteps = [] {
  std::array<Step, count_steps()> steps;
  std::size_t n = 0;
  for (std::int64_t length2 = 0; length2 <= kRadius * kRadius; ++length2) {
    for (std::int64_t i = -kRadius; i <= kRadius; ++i) {
      for (std::int64_t j = -kRadius; j <= kRadius; ++j) {
        if (Step{i, j}.length2() == length2) steps[n++] = {i, j};
      }
    }
  }
  return steps;
}();

// Weights along one axis: 1 within [low, high], falling to 0 at kSearchReach outside.
struct Weights {
  std::int64_t first = 0;  // the index of the first sample; the next ones are kStride apart
  std::vector<double> value;
  double sum = 0;

  Weights(double low, double high) {
    const double before = std::ceil((low - kSearchReach) / static_cast<double>(kStride));
    first = static_cast<std::int64_t>(before) * kStride;
    for (std::int64_t i = first; static_cast<double>(i) <= high + kSearchReach; i += kStride) {
      const auto x = static_cast<double>(i);
      const double t = std::max({low - x, x - high, 0.0}) / kSearchReach;
      const double s = 1 - t * t;
      value.push_back(s * s);
      sum += value.back();
    }
  }
};

// Samples displaced by any vector: at whole steps themselves, between them bilinear.
class Displaced {
 public:
  Displaced(const DistanceSamples& samples, double i, double j)
      : samples_(samples),
        i_(static_cast<std::int64_t>(std::floor(i))),
        j_(static_cast<std::int64_t>(std::floor(j))),
        fx_(i - std::floor(i)),
        fy_(j - std::floor(j)) {}

  // Calls take(k, value) for n samples of a row from i on, kStride apart.
  template <class Take>
  void visit_row(std::int64_t i, std::int64_t j, std::size_t n, const Take& take) const {
    const double* row = samples_.at(i + i_, j + j_);
    if (fx_ == 0 && fy_ == 0) {
      for (std::size_t k = 0; k < n; ++k, row += kStride) take(k, row[0]);
      return;
    }
    const std::size_t nx = samples_.window.nx();
    for (std::size_t k = 0; k < n; ++k, row += kStride) {
      const double low = row[0] + fx_ * (row[1] - row[0]);
      const double high = row[nx] + fx_ * (row[nx + 1] - row[nx]);
      take(k, low + fy_ * (high - low));
    }
  }

 private:
  const DistanceSamples& samples_;
  std::int64_t i_, j_;
  double fx_, fy_;
};

class Fit {
 public:
  Fit(const SectionsAround& around, const Box2& region)
      : around_(around),
        columns_(region.x0, region.x1),
        rows_(region.y0, region.y1),
        scale_(1 / (columns_.sum * rows_.sum * (kStepsPerGap * kStepsPerGap))),
        there_(columns_.value.size()),
        squares_(columns_.value.size()) {}

  // How badly a displacement fits; infinity where it is `most` or more.
  double misfit(const Step& by, double most) {
    const auto i = static_cast<double>(by.i);
    const auto j = static_cast<double>(by.j);
    const double bent = kStiffness * (i * i + j * j) / (kStepsPerGap * kStepsPerGap);
    double sum = 0;
    for (std::size_t y = 0; y < rows_.value.size(); ++y) {
      const std::int64_t row = rows_.first + static_cast<std::int64_t>(y) * kStride;
      square_row(row, i, j);
      double of_row = 0;
      for (std::size_t k = 0; k < squares_.size(); ++k) {
        of_row += columns_.value[k] * squares_[k];
      }
      sum += rows_.value[y] * of_row;
      if (sum * scale_ + bent >= most) return kInfinity;  // sums only grow
    }
    return sum * scale_ + bent;
  }

 private:
  // The squared differences of a row of samples, summed over the slabs.
  void square_row(std::int64_t row, double i, double j) {
    const std::int64_t first = columns_.first;
    const std::size_t n = squares_.size();
    const double* const here = around_.here->at(first, row);
    const auto here_at = [here](std::size_t k) {
      return here[static_cast<std::size_t>(kStride) * k];
    };
    Displaced(*around_.there, i, j).visit_row(first, row, n, [&](std::size_t k, double value) {
      there_[k] = value;
      const double e = value - here_at(k);
      squares_[k] = e * e;
    });
    if (around_.behind != nullptr) {
      Displaced(*around_.behind, -around_.back * i, -around_.back * j)
          .visit_row(first, row, n, [&](std::size_t k, double value) {
            const double e = here_at(k) - value;
            squares_[k] += e * e;
          });
    }
    if (around_.beyond != nullptr) {
      Displaced(*around_.beyond, (1 + around_.on) * i, (1 + around_.on) * j)
          .visit_row(first, row, n, [&](std::size_t k, double value) {
            const double e = value - there_[k];
            squares_[k] += e * e;
          });
    }
  }

  const SectionsAround& around_;
  Weights columns_, rows_;
  double scale_;
  std::vector<double> there_, squares_;  // of one row
};

// Where the parabola through the values at -1, 0 and 1 is least, at half a step at most.
double vertex(double before, double at, double after) {
  const double bend = before + after - 2 * at;
  return bend > 0 ? std::clamp((before - after) / (2 * bend), -0.5, 0.5) : 0.0;
}

}  // namespace

LatticeWindow window_of(const Box2& region) {
  return {static_cast<std::int64_t>(std::floor(region.x0 - kSearchReach)),
          static_cast<std::int64_t>(std::floor(region.y0 - kSearchReach)),
          static_cast<std::int64_t>(std::floor(region.x1 + kSearchReach)) + 1,
          static_cast<std::int64_t>(std::floor(region.y1 + kSearchReach)) + 1};
}

std::int64_t margin_of(double gaps) {
  // One step more for the neighbours of the best displacement, and one to interpolate.
  return static_cast<std::int64_t>(std::ceil(static_cast<double>(kRadius + 1) * gaps)) + 1;
}

Point2 displacement(const SectionsAround& around, const Box2& region) {
  Fit fit(around, region);
  Step best;
  double least = kInfinity;
  for (const Step& step : kSteps) {
    const double misfit = fit.misfit(step, least);
    if (misfit < least) {
      least = misfit;
      best = step;
    }
  }
  const auto beside = [&](std::int64_t i, std::int64_t j) {
    return fit.misfit({best.i + i, best.j + j}, kInfinity);
  };
  return {static_cast<double>(best.i) + vertex(beside(-1, 0), least, beside(1, 0)),
          static_cast<double>(best.j) + vertex(beside(0, -1), least, beside(0, 1))};
}

}  // namespace tetloft::internal::motion

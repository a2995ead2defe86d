#include "between/class_motion.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

#include "motion/distance_samples.hpp"

namespace tetloft::internal::between {

namespace {

using motion::DistanceSamples;
using motion::kFarthest;
using motion::kStepsPerGap;
using motion::LatticeEdges;
using motion::LatticeWindow;

// Nodes are every second sample; misfits count as far as this around a node; displacements of half
// of what is tried are whole numbers of samples. In samples, a quarter of a gap each.
constexpr std::int64_t kStride = 2;
constexpr double kSigma = 0.6;  // in gaps
constexpr double kStiffness = 0.005;
constexpr double kNeighbour = 0.5;
constexpr double kRest = 0.9;
constexpr double kSmooth = 0.3;
constexpr std::int64_t kRadius2 = 5;  // of half displacements
constexpr bool kParabola = true;
constexpr double kSoft = 0;
// A section farther beyond the slab, in gaps, says nothing of it.
constexpr double kFarthestNeighbour = 2;

struct Step {
  std::int64_t i = 0, j = 0;
};

std::vector<Step> all_steps() {
  std::vector<Step> steps;
  for (std::int64_t length2 = 0; length2 <= kRadius2; ++length2) {
    for (std::int64_t i = -kRadius2; i <= kRadius2; ++i) {
      for (std::int64_t j = -kRadius2; j <= kRadius2; ++j) {
        if (i * i + j * j == length2) steps.push_back({i, j});
      }
    }
  }
  return steps;
}

// Weights around 0, of variance sigma² roughly, with sum 1.
std::vector<double> kernel(double sigma) {
  const double reach = std::sqrt(7.0) * sigma;
  const auto n = static_cast<std::size_t>(reach);
  std::vector<double> w(n + 1);
  double sum = 0;
  for (std::size_t k = 0; k <= n; ++k) {
    const double t = static_cast<double>(k) / reach;
    w[k] = (1 - t * t) * (1 - t * t);
    sum += k == 0 ? w[k] : 2 * w[k];
  }
  for (double& x : w) x /= sum;
  return w;
}

// Values on a window of nodes, smoothed along both axes; 0 or the border's value outside.
class Smoother {
 public:
  Smoother(std::size_t nx, std::size_t ny, double sigma, bool extend)
      : nx_(nx), ny_(ny), weight_(kernel(sigma)), extend_(extend) {}

  void smooth(std::vector<double>& value) {
    const std::size_t r = weight_.size() - 1;
    line_.assign(nx_ + 2 * r, 0);
    for (std::size_t y = 0; y < ny_; ++y) {
      double* const row = value.data() + y * nx_;
      std::copy(row, row + nx_, line_.begin() + static_cast<std::ptrdiff_t>(r));
      if (extend_) {
        for (std::size_t k = 0; k < r; ++k) {
          line_[k] = row[0];
          line_[r + nx_ + k] = row[nx_ - 1];
        }
      }
      const double* const at = line_.data() + r;
      for (std::size_t x = 0; x < nx_; ++x) row[x] = weight_[0] * at[x];
      for (std::size_t k = 1; k <= r; ++k) {
        const double w = weight_[k];
        for (std::size_t x = 0; x < nx_; ++x) row[x] += w * (at[x - k] + at[x + k]);
      }
    }
    from_ = value;
    const auto row_of = [&](std::size_t y, std::int64_t by) -> const double* {
      std::int64_t to = static_cast<std::int64_t>(y) + by;
      const auto last = static_cast<std::int64_t>(ny_) - 1;
      if (to < 0 || to > last) {
        if (!extend_) return nullptr;
        to = to < 0 ? 0 : last;
      }
      return from_.data() + static_cast<std::size_t>(to) * nx_;
    };
    for (std::size_t y = 0; y < ny_; ++y) {
      double* const row = value.data() + y * nx_;
      for (std::size_t x = 0; x < nx_; ++x) row[x] *= weight_[0];
      for (std::size_t k = 1; k <= r; ++k) {
        const double w = weight_[k];
        const double* const a = row_of(y, -static_cast<std::int64_t>(k));
        const double* const b = row_of(y, static_cast<std::int64_t>(k));
        for (std::size_t x = 0; x < nx_; ++x) {
          row[x] += w * ((a != nullptr ? a[x] : 0.0) + (b != nullptr ? b[x] : 0.0));
        }
      }
    }
  }

 private:
  std::size_t nx_, ny_;
  std::vector<double> weight_, line_, from_;
  bool extend_;
};

struct Sampled {
  bool present = false;
  DistanceSamples samples;

  // n samples of a row, kStride apart, displaced by (x, y).
  void take_row(double i, double j, std::size_t n, double* out) const {
    const double fi = std::floor(i);
    const double fj = std::floor(j);
    const double fx = i - fi;
    const double fy = j - fj;
    const double* row = samples.at(static_cast<std::int64_t>(fi), static_cast<std::int64_t>(fj));
    if (fx == 0 && fy == 0) {
      for (std::size_t k = 0; k < n; ++k) out[k] = row[static_cast<std::size_t>(kStride) * k];
      return;
    }
    const std::size_t nx = samples.window.nx();
    for (std::size_t k = 0; k < n; ++k, row += kStride) {
      const double low = row[0] + fx * (row[1] - row[0]);
      const double high = row[nx] + fx * (row[nx + 1] - row[nx]);
      out[k] = low + fy * (high - low);
    }
  }
};

class Fit {
 public:
  Fit(const ClassOutlines& outlines, double gap) {
    const double step = gap / kStepsPerGap;
    std::array<LatticeEdges, 4> edges{LatticeEdges(outlines.contours[behind], step),
                                      LatticeEdges(outlines.contours[lower], step),
                                      LatticeEdges(outlines.contours[upper], step),
                                      LatticeEdges(outlines.contours[beyond], step)};
    back_ = outlines.z[behind] ? (*outlines.z[lower] - *outlines.z[behind]) / gap : 0;
    on_ = outlines.z[beyond] ? (*outlines.z[beyond] - *outlines.z[upper]) / gap : 0;
    Box2 box = edges[lower].box();
    box.add(edges[upper].box());
    // Nodes: where the class may be between its sections, and a gap around it.
    const double around = 2 * kStepsPerGap;
    nodes_ = {static_cast<std::int64_t>(std::floor((box.x0 - around) / kStride)),
              static_cast<std::int64_t>(std::floor((box.y0 - around) / kStride)),
              static_cast<std::int64_t>(std::floor((box.x1 + around) / kStride)) + 2,
              static_cast<std::int64_t>(std::floor((box.y1 + around) / kStride)) + 2};
    for (std::size_t s = 0; s < 4; ++s) {
      sampled_[s].present = !outlines.contours[s].empty();
      if (s == behind && !(back_ > 0 && back_ <= kFarthestNeighbour)) sampled_[s].present = false;
      if (s == beyond && !(on_ > 0 && on_ <= kFarthestNeighbour)) sampled_[s].present = false;
      if (!sampled_[s].present) continue;
      const double far = s == behind ? 1 + 2 * back_ : s == beyond ? 1 + 2 * on_ : 1;
      const auto margin =
          static_cast<std::int64_t>(std::ceil(far * std::sqrt(static_cast<double>(kRadius2)))) + 1;
      const LatticeWindow w{nodes_.i0 * kStride, nodes_.j0 * kStride, nodes_.i1 * kStride,
                            nodes_.j1 * kStride};
      sampled_[s].samples = sample_distances(edges[s], w.widened(margin));
    }
  }

  [[nodiscard]] const LatticeWindow& nodes() const { return nodes_; }

  [[nodiscard]] bool at_rest() const {
    if (!sampled_[lower].present || !sampled_[upper].present) return false;
    const std::vector<double>& a = sampled_[lower].samples.value;
    const std::vector<double>& b = sampled_[upper].samples.value;
    std::size_t both = 0;
    std::size_t either = 0;
    for (std::size_t k = 0; k < a.size(); ++k) {
      both += a[k] < 0 && b[k] < 0 ? 1U : 0U;
      either += a[k] < 0 || b[k] < 0 ? 1U : 0U;
    }
    return static_cast<double>(both) >= kRest * static_cast<double>(either);
  }

  // Whether anything tells the motion.
  [[nodiscard]] bool told() const {
    return (sampled_[lower].present && (sampled_[upper].present || sampled_[behind].present)) ||
           (sampled_[upper].present && sampled_[beyond].present);
  }

  // The squared differences at all nodes for a motion of 2 (i, j).
  void squares(const Step& by, std::vector<double>& square) {
    const std::size_t nx = nodes_.nx();
    square.assign(nodes_.size(), 0);
    for (std::size_t s = 0; s < 4; ++s) row_[s].resize(nx);
    const std::array<double, 4> share{-1 - 2 * back_, -1, 1, 1 + 2 * on_};
    for (std::int64_t j = nodes_.j0; j < nodes_.j1; ++j) {
      for (std::size_t s = 0; s < 4; ++s) {
        if (!sampled_[s].present) continue;
        sampled_[s].take_row(
            static_cast<double>(nodes_.i0 * kStride) + share[s] * static_cast<double>(by.i),
            static_cast<double>(j * kStride) + share[s] * static_cast<double>(by.j), nx,
            row_[s].data());
      }
      double* const out = square.data() + nodes_.place(nodes_.i0, j);
      for (std::size_t s = 0; s < 3; ++s) {
        if (!sampled_[s].present || !sampled_[s + 1].present) continue;
        const double weight = s == lower ? 1.0 : kNeighbour;
        const double* const a = row_[s].data();
        const double* const b = row_[s + 1].data();
        for (std::size_t k = 0; k < nx; ++k) {
          const double e = b[k] - a[k];
          out[k] += weight * (e * e);
        }
      }
    }
  }

 private:
  std::array<Sampled, 4> sampled_;
  std::array<std::vector<double>, 4> row_;
  LatticeWindow nodes_;
  double back_ = 0, on_ = 0;
};

// Where the parabola through the values at -1, 0 and 1 is least, at half a step at most.
double vertex(double before, double at, double after) {
  const double bend = before + after - 2 * at;
  return bend > 0 ? std::clamp((before - after) / (2 * bend), -0.5, 0.5) : 0.0;
}

// The step of least misfit at every node, between steps by parabolas.
class Least {
 public:
  Least(const std::vector<Step>& steps, const std::vector<std::vector<double>>& misfit)
      : steps_(steps), misfit_(misfit) {}

  [[nodiscard]] Point2 at(std::size_t k) const {
    std::size_t best = 0;
    for (std::size_t c = 1; c < steps_.size(); ++c) {
      if (misfit_[c][k] < misfit_[best][k]) best = c;
    }
    if (kSoft > 0) {
      double sum = 0;
      Point2 mean;
      for (std::size_t c = 0; c < steps_.size(); ++c) {
        const double e = (misfit_[c][k] - misfit_[best][k]) / kSoft;
        const double w = 1 / ((1 + e) * (1 + e) * (1 + e) * (1 + e));
        sum += w;
        mean.x += w * static_cast<double>(steps_[c].i);
        mean.y += w * static_cast<double>(steps_[c].j);
      }
      return {mean.x / sum, mean.y / sum};
    }
    const Step at = steps_[best];
    const auto along = [&](std::int64_t i, std::int64_t j) {
      const auto before = find({at.i - i, at.j - j});
      const auto after = find({at.i + i, at.j + j});
      if (!kParabola || before == steps_.size() || after == steps_.size()) return 0.0;
      return vertex(misfit_[before][k], misfit_[best][k], misfit_[after][k]);
    };
    return {static_cast<double>(at.i) + along(1, 0), static_cast<double>(at.j) + along(0, 1)};
  }

 private:
  [[nodiscard]] std::size_t find(const Step& s) const {
    std::size_t c = 0;
    while (c < steps_.size() && !(steps_[c].i == s.i && steps_[c].j == s.j)) ++c;
    return c;
  }
  const std::vector<Step>& steps_;
  const std::vector<std::vector<double>>& misfit_;
};

}  // namespace

double MotionField::longest() const {
  double most = 0;
  for (const Point2& u : node) most = std::max({most, std::abs(u.x), std::abs(u.y)});
  return most;
}

Point2 MotionField::at(const Point2& p) const {
  const auto split = [](double at, std::int64_t low, std::int64_t high) {
    const double clamped = std::clamp(at, static_cast<double>(low), static_cast<double>(high - 1));
    const double whole = std::min(std::floor(clamped), static_cast<double>(high - 2));
    return std::pair(static_cast<std::int64_t>(whole), clamped - whole);
  };
  const auto [i, fx] = split(p.x / spacing, window.i0, window.i1);
  const auto [j, fy] = split(p.y / spacing, window.j0, window.j1);
  const Point2* const low = node.data() + window.place(i, j);
  const Point2* const high = low + window.nx();
  const Point2 a{low[0].x + fx * (low[1].x - low[0].x), low[0].y + fx * (low[1].y - low[0].y)};
  const Point2 b{high[0].x + fx * (high[1].x - high[0].x),
                 high[0].y + fx * (high[1].y - high[0].y)};
  return {a.x + fy * (b.x - a.x), a.y + fy * (b.y - a.y)};
}

std::optional<MotionField> estimate_motion(const ClassOutlines& outlines) {
  const double gap = *outlines.z[upper] - *outlines.z[lower];
  Fit fit(outlines, gap);
  if (!fit.told() || fit.at_rest()) return std::nullopt;
  const std::vector<Step> steps = all_steps();
  const LatticeWindow& nodes = fit.nodes();
  constexpr double kNodesPerGap = static_cast<double>(kStepsPerGap) / kStride;
  Smoother gather(nodes.nx(), nodes.ny(), kSigma * kNodesPerGap, false);
  std::vector<std::vector<double>> misfit(steps.size());
  for (std::size_t c = 0; c < steps.size(); ++c) {
    fit.squares(steps[c], misfit[c]);
    gather.smooth(misfit[c]);
    const auto i = static_cast<double>(2 * steps[c].i);
    const auto j = static_cast<double>(2 * steps[c].j);
    const double bent = kStiffness * (i * i + j * j);
    for (double& e : misfit[c]) e += bent;
  }
  std::vector<double> x(nodes.size()), y(nodes.size());
  const Least least(steps, misfit);
  const double unit = 2 * (gap / kStepsPerGap);
  for (std::size_t k = 0; k < nodes.size(); ++k) {
    const Point2 u = least.at(k);
    x[k] = u.x * unit;
    y[k] = u.y * unit;
  }
  Smoother even(nodes.nx(), nodes.ny(), kSmooth * kNodesPerGap, true);
  even.smooth(x);
  even.smooth(y);
  MotionField field{nodes, gap / kNodesPerGap, std::vector<Point2>(nodes.size())};
  for (std::size_t k = 0; k < nodes.size(); ++k) field.node[k] = {x[k], y[k]};
  return field;
}

}  // namespace tetloft::internal::between

#include "between/marching.hpp"

#include <algorithm>
#include <cstddef>
#include <utility>

#include "between/inside_runs.hpp"

namespace tetloft::internal::between {

namespace {

constexpr double kLeastShare = 1.0 / 64;

// Where a contour crosses a lattice edge: an inside sample on its left, an outside one beside it.
struct Crossing {
  std::int64_t in, out;
};

class Tracer {
 public:
  Tracer(const motion::LatticeWindow& window, const std::vector<double>& value, double step)
      : window_(window),
        value_(value),
        step_(step),
        nx_(static_cast<std::int64_t>(window.nx())),
        seen_(window.size(), 0) {}

  [[nodiscard]] std::vector<TracedContour> trace() {
    std::vector<TracedContour> contours;
    // Every contour has a crossing with its inside to the west: it turns about its insides.
    visit_sign_runs(window_, value_, true, [&](std::uint32_t, std::uint32_t end) {
      if (seen_[end - 1] == 0) contours.push_back(follow({std::int64_t{end} - 1, end}));
    });
    std::sort(contours.begin(), contours.end(), [](const auto& a, const auto& b) {
      return canonical_less(a.contour.vertices.front(), b.contour.vertices.front());
    });
    return contours;
  }

 private:
  [[nodiscard]] bool inside(std::int64_t at) const {
    return value_[static_cast<std::size_t>(at)] < 0;
  }

  [[nodiscard]] TracedContour follow(const Crossing& start) {
    TracedContour traced;
    traced.sample = static_cast<std::uint32_t>(start.in);
    Crossing at = start;
    do {
      traced.contour.vertices.push_back(point(at));
      if (at.out == at.in + 1) seen_[static_cast<std::size_t>(at.in)] = 1;
      at = next(at);
    } while (at.in != start.in || at.out != start.out);
    std::vector<Point2>& vertices = traced.contour.vertices;
    std::rotate(vertices.begin(),
                std::min_element(vertices.begin(), vertices.end(),
                                 [](const auto& a, const auto& b) { return canonical_less(a, b); }),
                vertices.end());
    return traced;
  }

  // Ahead are the samples beside the two, a quarter turn to the left of the way from in to out.
  [[nodiscard]] Crossing next(const Crossing& at) const {
    const std::int64_t across = at.out - at.in;
    const std::int64_t ahead = across == 1 ? nx_ : across == -1 ? -nx_ : across == nx_ ? -1 : 1;
    if (!inside(at.in + ahead)) return {at.in, at.in + ahead};
    if (!inside(at.out + ahead)) return {at.in + ahead, at.out + ahead};
    return {at.out + ahead, at.out};
  }

  [[nodiscard]] Point2 point(const Crossing& at) const {
    const std::int64_t low = std::min(at.in, at.out);
    const double v = value_[static_cast<std::size_t>(low)];
    const double w = value_[static_cast<std::size_t>(std::max(at.in, at.out))];
    const double share = std::clamp(v / (v - w), kLeastShare, 1 - kLeastShare);
    const bool along_x = at.in - at.out == 1 || at.out - at.in == 1;
    const auto x = static_cast<double>(window_.i0 + low % nx_);
    const auto y = static_cast<double>(window_.j0 + low / nx_);
    return {(along_x ? x + share : x) * step_, (along_x ? y : y + share) * step_};
  }

  const motion::LatticeWindow& window_;
  const std::vector<double>& value_;
  double step_;
  std::int64_t nx_;
  std::vector<std::uint8_t> seen_;  // the crossing east of an inside sample
};

}  // namespace

std::vector<TracedContour> trace_contours(const motion::LatticeWindow& window,
                                          const std::vector<double>& value, double step) {
  return Tracer(window, value, step).trace();
}

}  // namespace tetloft::internal::between

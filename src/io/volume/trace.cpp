// Following cracks.
#include "io/volume/trace.hpp"

#include <array>

namespace tetloft::internal::io {

namespace {

/// Ahead along a crack: right, up, left, down in (column, row).
using Heading = std::size_t;
constexpr std::array<double, 4> kColumnStep{1, 0, -1, 0};
constexpr std::array<double, 4> kRowStep{0, 1, 0, -1};
constexpr Heading left_of(Heading h) { return (h + 1) % 4; }
constexpr Heading right_of(Heading h) { return (h + 3) % 4; }

/// Of a pixel inside, the side that is to the right of `heading`.
struct Crack {
  std::size_t place = 0;
  double column = 0;
  double row = 0;
  Heading heading = 0;
};

enum class CrackTurn { none, right, left, left_past_touching };

class Tracer {
 public:
  Tracer(Slice& slice, VolumeContours way) : slice_(slice), way_(way) {
    const std::size_t stride = slice.stride();
    offset_ = {1, stride, std::size_t{0} - 1, std::size_t{0} - stride};
  }

  // Every loop has cracks that head right.
  [[nodiscard]] bool starts_at(std::size_t place) const {
    return slice_.inside(place) && !slice_.inside(place + offset_[3]) && !slice_.passed(place);
  }

  const std::vector<PixelPoint>& loop_from(const Crack& start) {
    loop_.clear();
    Crack at = start;
    do {
      if (at.heading == 0) slice_.pass(at.place);
      if (way_ == VolumeContours::sub_pixel) put_between(at);
      const Crack before = at;
      const CrackTurn turn = go_on(at);
      if (way_ == VolumeContours::lattice && turn != CrackTurn::none) put_corner(before, at, turn);
    } while (at.place != start.place || at.heading != start.heading);
    return loop_;
  }

 private:
  void step(Crack& at, Heading heading) const {
    at.place += offset_[heading];
    at.column += kColumnStep[heading];
    at.row += kRowStep[heading];
  }

  CrackTurn go_on(Crack& at) const {
    const std::size_t ahead = at.place + offset_[at.heading];
    const std::size_t ahead_right = ahead + offset_[right_of(at.heading)];
    if (!slice_.inside(ahead)) {
      at.heading = left_of(at.heading);
      return slice_.inside(ahead_right) ? CrackTurn::left_past_touching : CrackTurn::left;
    }
    step(at, at.heading);
    if (!slice_.inside(ahead_right)) return CrackTurn::none;
    step(at, right_of(at.heading));
    at.heading = right_of(at.heading);
    return CrackTurn::right;
  }

  void put_between(const Crack& at) {
    const Heading out = right_of(at.heading);
    const double share = slice_.share(at.place, at.place + offset_[out]);
    loop_.push_back({at.column + share * kColumnStep[out], at.row + share * kRowStep[out]});
  }

  // At the end of `crack`, whose successor is `next`.
  void put_corner(const Crack& crack, const Crack& next, CrackTurn turn) {
    const Heading h = crack.heading;
    const Heading out = right_of(h);
    const PixelPoint corner{crack.column + 0.5 * (kColumnStep[h] + kColumnStep[out]),
                            crack.row + 0.5 * (kRowStep[h] + kRowStep[out])};
    if (turn != CrackTurn::left_past_touching) {
      loop_.push_back(corner);
      return;
    }
    const Heading n = next.heading;
    loop_.push_back(
        {corner.column - kCutCorner * kColumnStep[h], corner.row - kCutCorner * kRowStep[h]});
    loop_.push_back(
        {corner.column + kCutCorner * kColumnStep[n], corner.row + kCutCorner * kRowStep[n]});
  }

  Slice& slice_;
  VolumeContours way_;
  std::array<std::size_t, 4> offset_{};  ///< of places, by heading; modulo 2^64
  std::vector<PixelPoint> loop_;
};

}  // namespace

void trace_contours(Slice& slice, VolumeContours way,
                    const std::function<void(const std::vector<PixelPoint>&)>& take) {
  if (slice.empty()) return;
  Tracer tracer(slice, way);
  for (std::size_t row = 0; row < slice.height(); ++row) {
    for (std::size_t column = 0; column < slice.width(); ++column) {
      const std::size_t place = row * slice.stride() + column;
      if (!tracer.starts_at(place)) continue;
      take(tracer.loop_from({place, static_cast<double>(column), static_cast<double>(row), 0}));
    }
  }
}

}  // namespace tetloft::internal::io

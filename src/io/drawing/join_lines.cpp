#include "io/drawing/join_lines.hpp"

#include <algorithm>
#include <limits>
#include <tuple>
#include <utility>

namespace tetloft::internal::io {

namespace {

constexpr std::size_t kNoEnd = std::numeric_limits<std::size_t>::max();

// End 2 i is the first point of line i, end 2 i + 1 its last.
class Joiner {
 public:
  explicit Joiner(std::vector<DrawnLine>& lines)
      : lines_(lines), other_(2 * lines.size(), kNoEnd) {}

  std::size_t join() {
    pair_ends();
    std::size_t taken = 0;
    std::vector<bool> done(lines_.size(), false);
    for (std::size_t i = 0; i < lines_.size(); ++i) {
      if (done[i] || (other_[2 * i] == kNoEnd && other_[2 * i + 1] == kNoEnd)) continue;
      taken += join_from(i, done);
    }
    return taken;
  }

 private:
  [[nodiscard]] const Point3& point(std::size_t end) const {
    const std::vector<Point3>& points = lines_[end / 2].points;
    return end % 2 == 0 ? points.front() : points.back();
  }

  void pair_ends() {
    std::vector<std::size_t> ends;
    for (std::size_t i = 0; i < lines_.size(); ++i) {
      if (lines_[i].kind != LineKind::open || lines_[i].left_out || lines_[i].points.size() < 2)
        continue;
      ends.push_back(2 * i);
      ends.push_back(2 * i + 1);
    }
    const auto key = [&](std::size_t end) {
      const Point3& p = point(end);
      return std::tuple(p.z, p.x, p.y);
    };
    std::sort(ends.begin(), ends.end(), [&](std::size_t a, std::size_t b) {
      return std::tuple(key(a), a) < std::tuple(key(b), b);
    });
    for (std::size_t i = 0; i < ends.size();) {
      std::size_t end = i + 1;
      while (end < ends.size() && point(ends[end]) == point(ends[i])) ++end;
      if (end - i == 2) {
        other_[ends[i]] = ends[i + 1];
        other_[ends[i + 1]] = ends[i];
      }
      i = end;
    }
  }

  std::size_t join_from(std::size_t first, std::vector<bool>& done) {
    // Back to where the line begins, or around.
    std::size_t begin = 2 * first;
    while (other_[begin] != kNoEnd && other_[begin] / 2 != first) begin = other_[begin] ^ 1U;
    const bool closes = other_[begin] != kNoEnd;
    if (closes) begin = 2 * first;
    DrawnLine joined = lines_[first];
    joined.points.clear();
    std::size_t taken = 0;
    for (std::size_t end = begin; end != kNoEnd;) {
      DrawnLine& piece = lines_[end / 2];
      done[end / 2] = true;
      if (end / 2 != first) ++taken;
      if (end % 2 == 1) std::reverse(piece.points.begin(), piece.points.end());
      const auto from = piece.points.begin() + (joined.points.empty() ? 0 : 1);
      joined.points.insert(joined.points.end(), from, piece.points.end());
      piece.points = {};
      piece.left_out = true;
      end = other_[end ^ 1U];
      if (closes && end / 2 == first) break;
    }
    if (closes) {
      joined.points.pop_back();
      joined.kind = LineKind::closed;
    }
    lines_[first] = std::move(joined);
    return taken;
  }

  std::vector<DrawnLine>& lines_;
  std::vector<std::size_t> other_;  // the end that an end is joined to
};

}  // namespace

std::size_t join_open_lines(std::vector<DrawnLine>& lines) { return Joiner(lines).join(); }

}  // namespace tetloft::internal::io

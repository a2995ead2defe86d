// Pairs, triples, decimal commas: nothing in a .cnt says which, but the announced counts, the
// heights and validity tell.
#include "io/cnt_contents.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include <tetloft/repair.hpp>

#include "io/numbers.hpp"

namespace tetloft::internal::io {

namespace {

// The numbers of a contour, one after the other.
class Numbers {
 public:
  explicit Numbers(const Contour& contour) : vertices_(contour.vertices) {
    size_ = 2 * vertices_.size();
    if (size_ > 0 && std::isnan(vertices_.back().y)) --size_;
  }
  [[nodiscard]] std::size_t size() const { return size_; }
  double operator[](std::size_t i) const {
    return i % 2 == 0 ? vertices_[i / 2].x : vertices_[i / 2].y;
  }

 private:
  const std::vector<Point2>& vertices_;
  std::size_t size_;
};

// The third number of a vertex, where it is not the section's height.
struct OffPlane {
  std::size_t section = 0;
  std::size_t contour = 0;
  std::size_t vertex = 0;
  double value = 0;
};

struct Reading {
  bool in_threes = true;              // every contour has a multiple of three numbers, one has some
  bool counts_are_twos = true;        // the announced counts are those of pairs
  bool counts_are_threes = true;      // … of triples
  bool counts_are_fours = true;       // … of two pairs of digits around a decimal comma each
  std::optional<OffPlane> off_plane;  // the first
};

// Calls take(section, contour, numbers) for every contour.
template <class Take>
void for_each_contour(const CntContents& contents, Take&& take) {
  for (std::size_t s = 0; s < contents.stack.sections.size(); ++s) {
    const Section& section = contents.stack.sections[SectionId(s)];
    for (std::size_t c = 0; c < section.contours.size(); ++c) {
      take(s, c, Numbers(section.contours[ContourId(c)]));
    }
  }
}

Reading look_at(const CntContents& contents) {
  Reading reading;
  std::vector<std::size_t> numbers(contents.stack.sections.size(), 0);
  for_each_contour(contents, [&](std::size_t s, std::size_t c, const Numbers& in) {
    numbers[s] += in.size();
    if (in.size() % 3 != 0) reading.in_threes = false;
    const double z = contents.stack.sections[SectionId(s)].z;
    for (std::size_t i = 2; i < in.size() && !reading.off_plane; i += 3) {
      if (in[i] != z) reading.off_plane = OffPlane{s, c, i / 3, in[i]};
    }
  });
  std::size_t all = 0;
  for (std::size_t s = 0; s < numbers.size(); ++s) {
    const double announced = contents.announced[SectionId(s)];
    const auto total = static_cast<double>(numbers[s]);
    if (total != 2 * announced) reading.counts_are_twos = false;
    if (total != 3 * announced) reading.counts_are_threes = false;
    if (total != 4 * announced) reading.counts_are_fours = false;
    all += numbers[s];
  }
  if (all == 0) reading.in_threes = reading.counts_are_threes = reading.counts_are_fours = false;
  return reading;
}

bool valid_pairs(const CntContents& contents) {
  SectionStack copy = contents.stack;
  static_cast<void>(mend(copy));
  return validate(copy, {.threads = 1}).ok();
}

void take_threes(CntContents& contents) {
  SectionStack stack;
  for (const Section& section : contents.stack.sections.raw()) {
    stack.sections.push_back({section.z, {}});
  }
  for_each_contour(contents, [&](std::size_t s, std::size_t, const Numbers& in) {
    Contour contour;
    contour.vertices.reserve(in.size() / 3);
    for (std::size_t i = 0; i < in.size(); i += 3) contour.vertices.push_back({in[i], in[i + 1]});
    stack.sections[SectionId(s)].contours.push_back(std::move(contour));
  });
  contents.stack = std::move(stack);
  contents.odd.reset();
}

std::string text_of(double value) {
  std::string text;
  append_number(text, value);
  return text;
}

std::optional<std::size_t> first_contour_line(const CntContents& contents) {
  for (const auto& lines : contents.lines.raw()) {
    if (!lines.empty()) return lines[ContourId(0)];
  }
  return std::nullopt;
}

Error off_plane_error(const CntContents& contents, const OffPlane& off) {
  Error error{ErrorCode::invalid_input,
              "three numbers to a vertex, of which the third (" + text_of(off.value) +
                  ") is not the height of its section (" +
                  text_of(contents.stack.sections[SectionId(off.section)].z) +
                  "): sections are planar; write x and y, or the height as third",
              {}};
  error.where.line = contents.lines[SectionId(off.section)][ContourId(off.contour)];
  error.where.section = off.section;
  error.where.vertex = off.vertex;
  return error;
}

Error odd_error(const CntContents::Odd& odd, const std::string& remark = {}) {
  Error error{ErrorCode::invalid_input,
              "the contour opened in line " + std::to_string(odd.opened) +
                  " has an odd number of coordinates" + remark,
              {}};
  error.where.line = odd.closed;
  return error;
}

}  // namespace

Result<std::optional<Warning>> settle_vertices(CntContents& contents) {
  using Settled = std::optional<Warning>;
  const Reading reading = look_at(contents);
  const bool odd = contents.odd.has_value();
  if (!odd && reading.counts_are_twos) return Settled();
  if (contents.commas && reading.counts_are_fours) {
    Error error{ErrorCode::invalid_input,
                "twice as many numbers as the announced vertices have: the commas seem to be "
                "decimal ones; write decimal points",
                {}};
    error.where.line = first_contour_line(contents);
    return error;
  }
  if (!reading.in_threes) {
    if (odd) return odd_error(*contents.odd);
    return Settled();
  }
  // An odd number of numbers, or three times the announced vertices: no pairs, unless they are
  // valid as such. The height at every third place of an invalid stack: neither.
  const bool evident = odd || reading.counts_are_threes;
  if (reading.off_plane || !evident) {
    if (!odd && valid_pairs(contents)) return Settled();
    if (reading.off_plane) {
      if (!reading.counts_are_threes && odd) {
        return odd_error(*contents.odd,
                         "; if it has three numbers to a vertex, leave out the third");
      }
      if (evident) return off_plane_error(contents, *reading.off_plane);
      return Settled();
    }
  }
  take_threes(contents);
  Warning warning{
      "three numbers to a vertex: the third is the height of the section and is left out", {}};
  warning.where.line = first_contour_line(contents);
  return Settled(std::move(warning));
}

std::optional<double> conspicuous_closing(const Contour& contour) {
  constexpr std::size_t kFewest = 4;  // a triangle's longest edge says nothing
  constexpr double kTimes = 4;
  const std::vector<Point2>& v = contour.vertices;
  if (v.size() < kFewest) return std::nullopt;
  double longest = 0;
  for (std::size_t i = 1; i < v.size(); ++i) {
    longest = std::max(longest, std::hypot(v[i].x - v[i - 1].x, v[i].y - v[i - 1].y));
  }
  const double closing = std::hypot(v.back().x - v.front().x, v.back().y - v.front().y);
  if (!(closing > kTimes * longest) || !std::isfinite(closing / longest)) return std::nullopt;
  return closing / longest;
}

namespace {

// The box of all contours.
class FrameOfAll {
 public:
  explicit FrameOfAll(const SectionStack& stack) {
    for (const Section& section : stack.sections.raw()) {
      for (const Contour& contour : section.contours.raw()) {
        for (const Point2& p : contour.vertices) {
          low_ = {std::min(low_.x, p.x), std::min(low_.y, p.y)};
          high_ = {std::max(high_.x, p.x), std::max(high_.y, p.y)};
        }
      }
    }
  }

  // The sides that hold a point, a bit each.
  [[nodiscard]] unsigned sides(const Point2& p) const {
    return (p.x == low_.x ? 1U : 0U) | (p.x == high_.x ? 2U : 0U) | (p.y == low_.y ? 4U : 0U) |
           (p.y == high_.y ? 8U : 0U);
  }

 private:
  static constexpr double kInfinity = std::numeric_limits<double>::infinity();
  Point2 low_{kInfinity, kInfinity};
  Point2 high_{-kInfinity, -kInfinity};
};

}  // namespace

std::vector<ContourOfSection> lines_to_the_frame(const SectionStack& stack) {
  const FrameOfAll frame(stack);
  std::vector<ContourOfSection> lines;
  for (const SectionId s : stack.sections.ids()) {
    for (const ContourId c : stack.sections[s].contours.ids()) {
      const Contour& contour = stack.sections[s].contours[c];
      if (contour.vertices.size() < 2) continue;
      const unsigned first = frame.sides(contour.vertices.front());
      const unsigned last = frame.sides(contour.vertices.back());
      if (first == 0 || last == 0) continue;
      if ((first & last) != 0 && !conspicuous_closing(contour)) continue;
      lines.push_back({s, c});
    }
  }
  return lines;
}

std::vector<Warning> open_lines(const SectionStack& stack, std::size_t most) {
  const FrameOfAll frame(stack);
  std::vector<Warning> warnings;
  for (std::size_t s = 0; s < stack.sections.size(); ++s) {
    const auto& contours = stack.sections[SectionId(s)].contours;
    for (std::size_t c = 0; c < contours.size() && warnings.size() < most; ++c) {
      const std::vector<Point2>& v = contours[ContourId(c)].vertices;
      if (v.empty()) continue;
      const unsigned first = frame.sides(v.front());
      const unsigned last = frame.sides(v.back());
      // Along one side of the frame is how such a line is to be closed.
      if (first == 0 || last == 0 || (first & last) != 0) continue;
      const auto times = conspicuous_closing(contours[ContourId(c)]);
      if (!times) continue;
      Warning warning{
          "the contour may be an open line, cut off at the frame of all sections: it is closed by "
          "an edge from one side of the frame to another, " +
              std::to_string(static_cast<long long>(std::min(*times, 1e9))) +
              " times as long as its longest other; if so, close it along the frame "
              "(--close-on-frame)",
          {}};
      warning.where.section = s;
      warning.where.contour = c;
      warnings.push_back(std::move(warning));
    }
  }
  return warnings;
}

}  // namespace tetloft::internal::io

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

Error off_plane_error(const CntContents& contents, const CntReading::OffPlane& off) {
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

void CntReading::add(const CntContents& part) {
  odd_ = odd_ || part.odd;
  commas_ = commas_ || part.commas;
  std::vector<std::size_t> numbers(part.stack.sections.size(), 0);
  for_each_contour(part, [&](std::size_t s, std::size_t c, const Numbers& in) {
    numbers[s] += in.size();
    if (in.size() % 3 != 0) in_threes_ = false;
    const double z = part.stack.sections[SectionId(s)].z;
    for (std::size_t i = 2; i < in.size() && !off_plane_; i += 3) {
      if (in[i] != z) off_plane_ = OffPlane{part.first + s, c, i / 3, in[i]};
    }
  });
  for (std::size_t s = 0; s < numbers.size(); ++s) {
    const double announced = part.announced[SectionId(s)];
    const auto total = static_cast<double>(numbers[s]);
    if (total != 2 * announced) counts_are_twos_ = false;
    if (total != 3 * announced) counts_are_threes_ = false;
    if (total != 4 * announced) counts_are_fours_ = false;
    numbers_ += numbers[s];
  }
}

bool CntReading::plain_pairs() const {
  return !odd_ && (counts_are_twos_ || !(decimal_commas() || in_threes()));
}

Result<std::optional<Warning>> settle_vertices(CntContents& contents) {
  using Settled = std::optional<Warning>;
  CntReading reading;
  reading.add(contents);
  if (reading.plain_pairs()) return Settled();
  const bool odd = reading.odd();
  if (reading.decimal_commas()) {
    Error error{ErrorCode::invalid_input,
                "twice as many numbers as the announced vertices have: the commas seem to be "
                "decimal ones; write decimal points",
                {}};
    error.where.line = first_contour_line(contents);
    return error;
  }
  if (!reading.in_threes()) return odd_error(*contents.odd);
  // An odd number of numbers, or three times the announced vertices: no pairs, unless they are
  // valid as such. The height at every third place of an invalid stack: neither.
  const std::optional<CntReading::OffPlane>& off_plane = reading.off_plane();
  const bool evident = odd || reading.counts_are_threes();
  if (off_plane || !evident) {
    if (!odd && valid_pairs(contents)) return Settled();
    if (off_plane) {
      if (!reading.counts_are_threes() && odd) {
        return odd_error(*contents.odd,
                         "; if it has three numbers to a vertex, leave out the third");
      }
      if (evident) return off_plane_error(contents, *off_plane);
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

void FrameOfAll::add(const Section& section) {
  for (const Contour& contour : section.contours.raw()) {
    for (const Point2& p : contour.vertices) {
      low_ = {std::min(low_.x, p.x), std::min(low_.y, p.y)};
      high_ = {std::max(high_.x, p.x), std::max(high_.y, p.y)};
    }
  }
}

std::vector<ContourOfSection> lines_to_the_frame(const SectionStack& stack) {
  FrameOfAll frame;
  for (const Section& section : stack.sections.raw()) frame.add(section);
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

// Along one side of the frame is how such a line is to be closed.
bool OpenLines::crosses_frame(const Point2& front, const Point2& back) const {
  const unsigned first = frame_.sides(front);
  const unsigned last = frame_.sides(back);
  return first != 0 && last != 0 && (first & last) == 0;
}

// The box grows: what lies inside of it will not come to lie on a side again.
void OpenLines::add(const CntContents& part) {
  for (const Section& section : part.stack.sections.raw()) frame_.add(section);
  for (const SectionId s : part.stack.sections.ids()) {
    const auto& contours = part.stack.sections[s].contours;
    for (const ContourId c : contours.ids()) {
      const std::vector<Point2>& v = contours[c].vertices;
      if (v.empty() || !crosses_frame(v.front(), v.back())) continue;
      const auto times = conspicuous_closing(contours[c]);
      if (!times) continue;
      lines_.push_back(
          {part.first + s.index(), c.index(), part.lines[s][c], v.front(), v.back(), *times});
    }
  }
  constexpr std::size_t kFew = 1024;
  if (lines_.size() < 2 * kept_ + kFew) return;
  const auto inside = [&](const Line& line) { return !crosses_frame(line.front, line.back); };
  lines_.erase(std::remove_if(lines_.begin(), lines_.end(), inside), lines_.end());
  kept_ = lines_.size();
}

std::vector<Warning> OpenLines::warnings(std::size_t most) const {
  std::vector<Warning> warnings;
  for (const Line& line : lines_) {
    if (warnings.size() == most) break;
    if (!crosses_frame(line.front, line.back)) continue;
    Warning warning{
        "the contour may be an open line, cut off at the frame of all sections: it is closed by "
        "an edge from one side of the frame to another, " +
            std::to_string(static_cast<long long>(std::min(line.times, 1e9))) +
            " times as long as its longest other; if so, close it along the frame "
            "(--close-on-frame)",
        {}};
    warning.where.section = line.section;
    warning.where.contour = line.contour;
    warning.where.line = line.line;
    warnings.push_back(std::move(warning));
  }
  return warnings;
}

}  // namespace tetloft::internal::io

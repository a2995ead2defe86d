// Path data (SVG 1.1, section 8.3) and transforms (7.6). Only sums, products, quotients and roots
// reach a result.
#include "io/drawing/svg_shapes.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "io/cursor.hpp"
#include "io/numbers.hpp"

namespace tetloft::internal::io {

namespace {

// Numbers may follow each other without blanks: "1-2.5.5" is 1, −2.5, 0.5.
class NumberScanner {
 public:
  explicit NumberScanner(std::string_view text) : text_(text) {}

  void skip() {
    while (at_ < text_.size() && (is_white(text_[at_]) || text_[at_] == ',')) ++at_;
  }
  [[nodiscard]] bool at_end() const { return at_ >= text_.size(); }
  [[nodiscard]] char peek() const { return at_end() ? '\0' : text_[at_]; }
  char take() { return text_[at_++]; }

  std::optional<double> number() {
    skip();
    const std::size_t from = at_;
    const auto here = [&] { return peek(); };
    if (here() == '-' || here() == '+') ++at_;
    while (is_digit(here())) ++at_;
    if (here() == '.') ++at_;
    while (is_digit(here())) ++at_;
    const std::size_t mantissa = at_;
    if (here() == 'e' || here() == 'E') {
      ++at_;
      if (here() == '-' || here() == '+') ++at_;
      if (!is_digit(here())) at_ = mantissa;
      while (is_digit(here())) ++at_;
    }
    const ParsedNumber parsed = parse_number(text_.substr(from, at_ - from));
    if (!parsed.ok()) return std::nullopt;
    return parsed.value;
  }

 private:
  std::string_view text_;
  std::size_t at_ = 0;
};

Point2 sum(const Point2& p, const Point2& q) { return {p.x + q.x, p.y + q.y}; }

double second_difference(const Point2& p, const Point2& q, const Point2& r) {
  return std::max(std::abs(p.x - 2 * q.x + r.x), std::abs(p.y - 2 * q.y + r.y));
}

// Appends a cubic without its first point. A chord of a step h deviates by at most h²/8 times the
// largest second derivative, which is 6 times a second difference of the control points.
void flatten(const std::array<Point2, 4>& p, std::vector<Point2>& points) {
  constexpr double kPart = 512;
  constexpr int kMostSegments = 16;
  const auto [left, right] = std::minmax({p[0].x, p[1].x, p[2].x, p[3].x});
  const auto [low, high] = std::minmax({p[0].y, p[1].y, p[2].y, p[3].y});
  const double extent = std::max(right - left, high - low);
  const double bend =
      std::max(second_difference(p[0], p[1], p[2]), second_difference(p[1], p[2], p[3]));
  const double wanted = extent > 0 ? std::sqrt(6.0 / 8.0 * kPart * (bend / extent)) : 1;
  int n = 1;
  while (n < kMostSegments && n < wanted) ++n;
  for (int i = 1; i < n; ++i) {
    const double t = static_cast<double>(i) / n;
    const double s = 1 - t;
    const double w0 = s * s * s, w1 = 3 * s * s * t, w2 = 3 * s * t * t, w3 = t * t * t;
    points.push_back({w0 * p[0].x + w1 * p[1].x + w2 * p[2].x + w3 * p[3].x,
                      w0 * p[0].y + w1 * p[1].y + w2 * p[2].y + w3 * p[3].y});
  }
  points.push_back(p[3]);
}

class PathReader {
 public:
  PathReader(std::string_view data, std::size_t most) : in_(data), most_(most) {}

  SvgLines read() {
    for (in_.skip(); !in_.at_end(); in_.skip()) {
      if (is_letter(in_.peek())) {
        command_ = in_.take();
        fresh_ = true;
      } else if (command_ == '\0' || command_ == 'Z' || command_ == 'z') {
        return fail("the path has numbers without a command");
      }
      if (!step()) return std::move(out_);
      fresh_ = false;
    }
    finish(false);
    return std::move(out_);
  }

 private:
  SvgLines fail(const std::string& problem) {
    out_.problem = problem;
    return std::move(out_);
  }

  bool step() {
    const bool relative = command_ >= 'a';
    const char kind = relative ? static_cast<char>(command_ - 'a' + 'A') : command_;
    const Point2 base = relative ? at_ : Point2{};
    if (kind == 'Z') {
      finish(true);
      at_ = start_;
      return true;
    }
    if (kind == 'M') return move(base);
    if (line_.points.empty()) line_.points.push_back(at_);
    if (kind == 'L') return numbers(2) && line_to(sum(base, point(0)));
    if (kind == 'H') return numbers(1) && line_to({base.x + value_[0], at_.y});
    if (kind == 'V') return numbers(1) && line_to({at_.x, base.y + value_[0]});
    return curve(kind, base);
  }

  // Behind a move, further pairs are lines.
  bool move(const Point2& base) {
    if (!numbers(2)) return false;
    if (!fresh_) {
      if (line_.points.empty()) line_.points.push_back(at_);
      return line_to(sum(base, point(0)));
    }
    finish(false);
    at_ = start_ = sum(base, point(0));
    handle_kind_ = 'M';
    return true;
  }

  bool line_to(const Point2& p) {
    line_.points.push_back(p);
    at_ = p;
    handle_kind_ = 'L';
    return true;
  }

  bool curve(char kind, const Point2& base) {
    const bool cubic = kind == 'C' || kind == 'S';
    const bool quadratic = kind == 'Q' || kind == 'T';
    if (!cubic && !quadratic) {
      out_.problem = kind == 'A' ? "elliptic arcs of paths are not read: convert them to lines"
                                 : "unknown path command " + in_quotes(std::string(1, command_));
      return false;
    }
    const bool smooth = kind == 'S' || kind == 'T';
    if (!numbers((cubic ? 6 : 4) - (smooth ? 2U : 0U))) return false;
    // A smooth curve goes on as one of its degree before it came.
    const bool follows = cubic ? handle_kind_ == 'C' : handle_kind_ == 'Q';
    const Point2 mirrored = follows ? Point2{2 * at_.x - handle_.x, 2 * at_.y - handle_.y} : at_;
    const Point2 first = smooth ? mirrored : sum(base, point(0));
    const std::size_t next = smooth ? 0 : 1;
    const Point2 last = sum(base, point(next + (cubic ? 1U : 0U)));
    std::array<Point2, 4> control{at_, first, cubic ? sum(base, point(next)) : first, last};
    handle_ = control[2];
    if (quadratic) {
      control[1] = {(at_.x + 2 * first.x) / 3, (at_.y + 2 * first.y) / 3};
      control[2] = {(last.x + 2 * first.x) / 3, (last.y + 2 * first.y) / 3};
    }
    const std::size_t before = line_.points.size();
    flatten(control, line_.points);
    ++out_.curves;
    out_.curve_points += line_.points.size() - before;
    if (out_.curve_points > most_) {
      out_.problem = "more curves than can be turned into lines: convert them to line segments";
      return false;
    }
    at_ = last;
    handle_kind_ = cubic ? 'C' : 'Q';
    return true;
  }

  bool numbers(std::size_t count) {
    for (std::size_t i = 0; i < count; ++i) {
      const std::optional<double> number = in_.number();
      if (!number) {
        out_.problem = "the path command " + in_quotes(std::string(1, command_)) +
                       " lacks a number, or has one that is none";
        return false;
      }
      value_[i] = *number;
    }
    return true;
  }
  [[nodiscard]] Point2 point(std::size_t i) const { return {value_[2 * i], value_[2 * i + 1]}; }

  void finish(bool closed) {
    if (line_.points.size() > 1) {
      line_.closed = closed;
      out_.lines.push_back(std::move(line_));
    }
    line_ = {};
  }

  NumberScanner in_;
  std::size_t most_;  // points of curves
  SvgLines out_;
  SvgLine line_;
  Point2 at_;
  Point2 start_;            // of the subpath
  Point2 handle_;           // the last control point
  char handle_kind_ = 'M';  // of which degree
  char command_ = '\0';
  bool fresh_ = false;  // the command letter stands right before
  std::array<double, 6> value_{};
};

std::optional<SvgTransform> transform_of(std::string_view name, const std::vector<double>& v) {
  if (name == "matrix" && v.size() == 6) return SvgTransform{v[0], v[1], v[2], v[3], v[4], v[5]};
  if (name == "translate" && (v.size() == 1 || v.size() == 2)) {
    return SvgTransform{1, 0, 0, 1, v[0], v.size() == 2 ? v[1] : 0};
  }
  if (name == "scale" && (v.size() == 1 || v.size() == 2)) {
    return SvgTransform{v[0], 0, 0, v.size() == 2 ? v[1] : v[0], 0, 0};
  }
  if (name != "rotate" || (v.size() != 1 && v.size() != 3)) return std::nullopt;
  const double quarters = v[0] / 90;
  if (quarters != std::floor(quarters) || std::abs(quarters) > 1e9) return std::nullopt;
  const auto turn = static_cast<std::size_t>(((static_cast<long long>(quarters) % 4) + 4) % 4);
  constexpr std::array<double, 4> kCosine{1, 0, -1, 0};
  constexpr std::array<double, 4> kSine{0, 1, 0, -1};
  SvgTransform turned{kCosine[turn], kSine[turn], -kSine[turn], kCosine[turn], 0, 0};
  if (v.size() == 1) return turned;
  const SvgTransform there{1, 0, 0, 1, v[1], v[2]};
  const SvgTransform back{1, 0, 0, 1, -v[1], -v[2]};
  return there.after(turned.after(back));
}

}  // namespace

SvgTransform SvgTransform::after(const SvgTransform& inner) const {
  const Point2 at = apply({inner.e, inner.f});
  return {a * inner.a + c * inner.b,
          b * inner.a + d * inner.b,
          a * inner.c + c * inner.d,
          b * inner.c + d * inner.d,
          at.x,
          at.y};
}

std::optional<std::vector<double>> svg_numbers(std::string_view text) {
  NumberScanner scanner(text);
  std::vector<double> numbers;
  for (scanner.skip(); !scanner.at_end(); scanner.skip()) {
    const std::optional<double> number = scanner.number();
    if (!number) return std::nullopt;
    numbers.push_back(*number);
  }
  return numbers;
}

std::optional<SvgTransform> svg_transform(std::string_view text) {
  SvgTransform all;
  for (;;) {
    while (!text.empty() && (is_white(text.front()) || text.front() == ',')) text.remove_prefix(1);
    if (text.empty()) return all;
    const std::size_t open = text.find('(');
    const std::size_t close = text.find(')');
    if (open == std::string_view::npos || close == std::string_view::npos || close < open) {
      return std::nullopt;
    }
    std::string_view name = text.substr(0, open);
    while (!name.empty() && is_white(name.back())) name.remove_suffix(1);
    const auto numbers = svg_numbers(text.substr(open + 1, close - open - 1));
    const auto next = numbers ? transform_of(name, *numbers) : std::nullopt;
    if (!next) return std::nullopt;
    all = all.after(*next);
    text.remove_prefix(close + 1);
  }
}

SvgLines svg_path(std::string_view data, std::size_t most) { return PathReader(data, most).read(); }

}  // namespace tetloft::internal::io

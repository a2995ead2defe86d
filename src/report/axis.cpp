#include "report/axis.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <limits>

namespace tetloft::internal::report {

namespace {

constexpr double kLargest = std::numeric_limits<double>::max();
// Numbers of fewer digits are read as they are.
constexpr std::size_t kGroupedDigits = 5;
// Quotients and logarithms of doubles are off by a few units in the last place where they are
// whole: what is so near to a whole number stands for it. It decides whether there is a tick at the
// end.
constexpr double kWhole = 1e-9;
// Multiples of a step are told apart by doubles up to 2^53, near this.
constexpr double kMostSteps = 1e15;

// mantissa · 10^exponent, as near as the decimal number is read.
double decimal(int mantissa, int exponent) {
  const std::string text = std::to_string(mantissa) + 'e' + std::to_string(exponent);
  double value = 0;
  std::from_chars(text.data(), text.data() + text.size(), value);
  return value;
}

struct RoundNumber {
  int mantissa = 1;  // 1, 2 or 5
  int exponent = 0;

  [[nodiscard]] double value() const { return decimal(mantissa, exponent); }
  [[nodiscard]] RoundNumber next() const {
    return mantissa == 5 ? RoundNumber{1, exponent + 1}
                         : RoundNumber{mantissa == 1 ? 2 : 5, exponent};
  }
};

RoundNumber round_number_below(double length) {
  // The logarithm may be off by one where it is nearly whole, and small numbers have no such power.
  constexpr int kLeastExponent = -323;
  RoundNumber number{
      1, std::max(kLeastExponent, static_cast<int>(std::floor(std::log10(length))) - 1)};
  while (number.exponent < 308 || number.mantissa == 1) {
    const RoundNumber next = number.next();
    if (!(next.value() <= length) || next.value() == 0) break;
    number = next;
  }
  return number;
}

std::string superscript(int exponent) {
  constexpr std::array<const char*, 10> kDigits{"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};
  std::string text;
  for (const char c : std::to_string(exponent)) {
    text += c == '-' ? "⁻" : kDigits[static_cast<std::size_t>(c - '0')];
  }
  return text;
}

// The digits that the step needs.
std::string tick_label(double value, const RoundNumber& step) {
  if (value == 0) return "0";
  const int top = static_cast<int>(std::floor(std::log10(std::abs(value)) + kWhole));
  return number_text(value, std::clamp(top - step.exponent + 1, 1, 15));
}

}  // namespace

void group_thousands(std::string& digits, std::size_t whole) {
  for (std::size_t at = whole; at > 3;) {
    at -= 3;
    digits.insert(at, "\xE2\x80\xAF");
  }
}

double round_down(double length) { return round_number_below(length).value(); }

std::string number_text(double value, int digits) {
  if (std::isnan(value)) return "–";
  if (std::isinf(value)) return value > 0 ? "∞" : "−∞";
  char buffer[64];
  const auto general = std::to_chars(buffer, buffer + sizeof buffer, std::abs(value),
                                     std::chars_format::scientific, digits - 1);
  std::string text(buffer, general.ptr);
  const std::size_t e = text.find('e');
  std::string mantissa = text.substr(0, e);
  const int exponent = std::stoi(text.substr(e + 1));
  const bool plain = value == 0 || (exponent >= -4 && exponent < 7);
  if (plain) {
    const int behind = std::clamp(digits - 1 - exponent, 0, 40);
    mantissa.assign(buffer, std::to_chars(buffer, buffer + sizeof buffer, std::abs(value),
                                          std::chars_format::fixed, behind)
                                .ptr);
  }
  if (mantissa.find('.') != std::string::npos) {
    mantissa.erase(mantissa.find_last_not_of('0') + 1);
    if (mantissa.back() == '.') mantissa.pop_back();
  }
  const std::size_t whole = std::min(mantissa.find('.'), mantissa.size());
  if (whole >= kGroupedDigits) group_thousands(mantissa, whole);
  const std::string sign = value < 0 && mantissa != "0" ? "−" : "";
  return plain ? sign + mantissa : sign + mantissa + "·10" + superscript(exponent);
}

Axis::Axis(double low, double high, Scale scale, std::size_t wanted, bool to_ticks)
    : low_(std::clamp(low, -kLargest / 4, kLargest / 4)),
      high_(std::clamp(high, -kLargest / 4, kLargest / 4)),
      scale_(scale) {
  if (!(low_ < high_)) {
    // One value stands in the middle. A part of it may be too little to tell doubles apart.
    const double around = std::max({std::abs(low_) / 10, std::numeric_limits<double>::min() * 8});
    if (scale == Scale::logarithmic) {
      high_ = low_ * 2;
      low_ /= 2;
    } else if (low_ == 0) {
      high_ = 1;
    } else {
      high_ = low_ + around;
      low_ -= around;
    }
  }
  if (scale_ == Scale::logarithmic) make_logarithmic_ticks(wanted);
  if (scale_ == Scale::logarithmic && ticks_.size() >= 2) return;
  // Too short for round ones.
  ticks_.clear();
  if (scale_ == Scale::logarithmic) scale_ = Scale::linear;
  make_linear_ticks(wanted, to_ticks);
}

void Axis::make_linear_ticks(std::size_t wanted, bool to_ticks) {
  const double rough = (high_ - low_) / static_cast<double>(std::max<std::size_t>(wanted, 1));
  RoundNumber step = rough > 0 ? round_number_below(rough) : RoundNumber{1, -323};
  while ((high_ - low_) / step.value() > 1.5 * static_cast<double>(wanted)) step = step.next();
  const double width = step.value();
  // Far from 0 the step may be less than what doubles tell apart: then the ends are all that is.
  const double first = to_ticks ? std::floor(low_ / width) : std::ceil(low_ / width - kWhole);
  const double last = to_ticks ? std::ceil(high_ / width) : std::floor(high_ / width + kWhole);
  if (std::abs(first) > kMostSteps || std::abs(last) > kMostSteps || last < first) {
    ticks_ = {{low_, number_text(low_, 6)}, {high_, number_text(high_, 6)}};
    return;
  }
  for (double k = first; k <= last; ++k) {
    ticks_.push_back({k * width, tick_label(k * width, step)});
  }
  if (!to_ticks) return;
  low_ = std::min(low_, ticks_.front().value);
  high_ = std::max(high_, ticks_.back().value);
}

void Axis::make_logarithmic_ticks(std::size_t wanted) {
  const double decades = std::log10(high_) - std::log10(low_);
  const auto limit = static_cast<double>(wanted);
  const bool all = decades * 3 <= limit + 1;
  const int every = std::max(1, static_cast<int>(std::ceil(decades / limit)));
  for (int e = static_cast<int>(std::floor(std::log10(low_))) - 1; e <= 308; ++e) {
    if (decimal(1, e) > high_) break;
    for (const int mantissa : {1, 2, 5}) {
      if (mantissa != 1 && !all) break;
      if (!all && e % every != 0) break;
      const double value = decimal(mantissa, e);
      if (value >= low_ && value <= high_) ticks_.push_back({value, number_text(value, 1)});
    }
  }
}

double Axis::position(double value) const {
  const double at = scale_ == Scale::logarithmic
                        ? (std::log(value) - std::log(low_)) / (std::log(high_) - std::log(low_))
                        : (value - low_) / (high_ - low_);
  return std::isnan(at) ? 0 : std::clamp(at, 0.0, 1.0);
}

}  // namespace tetloft::internal::report

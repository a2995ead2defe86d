// Missing planes and uneven gaps.
#include "io/drawing/plane_gaps.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "io/numbers.hpp"

namespace tetloft::internal::io {

namespace {

constexpr double kSlack = 0.1;  // of the usual gap, within which a gap counts as that

std::string gap_text(double value) {
  std::string text;
  append_number(text, value);
  return text;
}

// The gap that most gaps are like; of two as frequent the smaller.
double most_frequent(std::vector<double> gaps) {
  std::sort(gaps.begin(), gaps.end());
  double best = gaps.front();
  std::size_t most = 0;
  std::size_t first = 0;
  for (std::size_t i = 0; i < gaps.size(); ++i) {
    while (gaps[i] - gaps[first] > kSlack * gaps[first]) ++first;
    if (i - first + 1 > most) {
      most = i - first + 1;
      best = gaps[first + (i - first) / 2];
    }
  }
  return best;
}

}  // namespace

std::vector<Warning> plane_gaps(const PlanesOfLines& planes) {
  constexpr std::size_t kFew = 5;
  if (planes.height.size() < 3) return {};
  std::vector<double> gaps;
  for (std::size_t i = 1; i < planes.height.size(); ++i) {
    gaps.push_back(planes.height[i] - planes.height[i - 1]);
  }
  const double usual = most_frequent(gaps);
  std::size_t missing = 0;
  std::size_t places = 0;
  std::string where;
  std::size_t uneven = 0;
  for (std::size_t i = 0; i < gaps.size(); ++i) {
    const double multiple = std::round(gaps[i] / usual);
    if (std::abs(gaps[i] - multiple * usual) > kSlack * usual || multiple < 1) {
      ++uneven;
    } else if (multiple >= 2) {
      missing += static_cast<std::size_t>(std::min(multiple - 1, 1e9));
      if (++places <= kFew) {
        where += (places == 1 ? "" : ", ") + gap_text(planes.height[i]) + " and " +
                 gap_text(planes.height[i + 1]);
      }
    }
  }
  std::vector<Warning> warnings;
  if (missing > 0) {
    warnings.push_back({std::to_string(missing) + (missing == 1 ? " plane seems" : " planes seem") +
                            " to be missing: planes are " + gap_text(usual) +
                            " apart, but not between " + where +
                            (places > kFew ? " and elsewhere" : ""),
                        {}});
  }
  if (uneven > 0) {
    warnings.push_back({"gaps between planes are uneven: from " +
                            gap_text(*std::min_element(gaps.begin(), gaps.end())) + " to " +
                            gap_text(*std::max_element(gaps.begin(), gaps.end())) + ", most are " +
                            gap_text(usual),
                        {}});
  }
  return warnings;
}

}  // namespace tetloft::internal::io

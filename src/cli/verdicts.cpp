#include "cli/verdicts.hpp"

namespace tetloft::cli {

std::string describe(const GuaranteeVerdict& verdict, const CheckFailure& failure) {
  std::string text = "guarantee " + std::to_string(verdict.number) + " (" + verdict.name +
                     "): " + failure.what + ", " + std::to_string(failure.count) + " times";
  if (!failure.places.empty()) text += ", first at " + failure.places.front();
  return text;
}

}  // namespace tetloft::cli

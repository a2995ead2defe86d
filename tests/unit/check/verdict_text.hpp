// Reports in words, for messages of failing tests.
#pragma once

#include <set>
#include <string>

#include <tetloft/check.hpp>

namespace tetloft::testing {

inline std::string text(const CheckReport& report) {
  std::string result;
  for (const GuaranteeVerdict& verdict : report.guarantees) {
    for (const CheckFailure& failure : verdict.failures) {
      result += failure.what + " (" + std::to_string(failure.count) + ")";
      for (const std::string& place : failure.places) result += "; " + place;
      result += "\n";
    }
  }
  return result;
}

/// The numbers of the conditions that fail: "2.8".
inline std::set<std::string> failed_conditions(const CheckReport& report) {
  std::set<std::string> result;
  for (const GuaranteeVerdict& verdict : report.guarantees) {
    for (const CheckFailure& failure : verdict.failures) {
      result.insert(failure.what.substr(0, failure.what.find(' ')));
    }
  }
  return result;
}

}  // namespace tetloft::testing

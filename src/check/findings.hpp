// What the check of one guarantee found, by numbered condition.
#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <utility>

#include <tetloft/check.hpp>

namespace tetloft::internal::checking {

class Findings {
 public:
  Findings(int number, std::string name, std::size_t places)
      : number_(number), name_(std::move(name)), places_(places) {}

  /// Counts `count` violations of condition number.condition. `place` makes the text that
  /// says where; it is called for the first few only.
  template <class Place>
  void fail(int condition, const char* what, Place&& place, std::size_t count = 1) {
    CheckFailure& failure = failures_[condition];
    if (failure.count == 0) {
      failure.what = std::to_string(number_) + "." + std::to_string(condition) + " " + what;
    }
    failure.count += count;
    if (failure.places.size() < places_) failure.places.push_back(place());
  }

  /// Those of a part, whose places are named with this in front.
  void add(const Findings& part, const std::string& in_front) {
    for (const auto& [condition, failure] : part.failures_) {
      CheckFailure& sum = failures_[condition];
      sum.what = failure.what;
      sum.count += failure.count;
      for (const std::string& place : failure.places) {
        if (sum.places.size() < places_) sum.places.push_back(in_front + place);
      }
    }
  }
  /// As if it had not been asked.
  void forget(int condition) { failures_.erase(condition); }

  [[nodiscard]] bool pass() const { return failures_.empty(); }
  [[nodiscard]] bool failed(int condition) const { return failures_.count(condition) != 0; }

  /// That nothing was asked, and why: of a guarantee that then does or does not hold.
  [[nodiscard]] GuaranteeVerdict not_asked(std::string why, bool pass) const {
    GuaranteeVerdict result;
    result.number = number_;
    result.name = name_;
    result.pass = pass;
    result.not_asked = std::move(why);
    return result;
  }

  /// Failures by condition.
  [[nodiscard]] GuaranteeVerdict verdict() const {
    GuaranteeVerdict result;
    result.number = number_;
    result.name = name_;
    result.pass = pass();
    for (const auto& [condition, failure] : failures_) result.failures.push_back(failure);
    return result;
  }

 private:
  int number_;
  std::string name_;
  std::size_t places_;
  std::map<int, CheckFailure> failures_;
};

}  // namespace tetloft::internal::checking

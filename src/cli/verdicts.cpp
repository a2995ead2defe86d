#include "cli/verdicts.hpp"

namespace tetloft::cli {

std::string describe(const GuaranteeVerdict& verdict, const CheckFailure& failure) {
  std::string text = "guarantee " + std::to_string(verdict.number) + " (" + verdict.name +
                     "): " + failure.what + ", " + std::to_string(failure.count) + " times";
  if (!failure.places.empty()) text += ", first at " + failure.places.front();
  return text;
}

std::string failed_guarantees(const std::vector<GuaranteeVerdict>& verdicts) {
  std::string text = "check failed:";
  for (const GuaranteeVerdict& verdict : verdicts) {
    if (verdict.pass) continue;
    text += text.back() == ':' ? " guarantee " : ", ";
    text += std::to_string(verdict.number) + " (" + verdict.name + ')';
  }
  return text;
}

void write_failures(JsonWriter& json, const std::vector<CheckFailure>& failures) {
  json.key("failures");
  json.begin_array();
  for (const CheckFailure& failure : failures) {
    json.begin_object();
    json.member("what", failure.what);
    json.member("count", failure.count);
    json.member("places", failure.places);
    json.end_object();
  }
  json.end_array();
}

}  // namespace tetloft::cli

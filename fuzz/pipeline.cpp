// The whole pipeline, and the baseline: bytes become a stack on a tiny grid, where degeneracy is
// the normal case; what is reconstructed keeps all guarantees, by brute force and by check().
#include <tetloft/check.hpp>
#include <tetloft/geiger.hpp>
#include <tetloft/reconstruct.hpp>

#include "fuzz/decode_stack.hpp"
#include "fuzz/target.hpp"
#include "support/guarantee_oracle.hpp"

namespace tetloft::fuzz {
namespace {

void check_model(const Reconstruction& made, const SectionStack& stack,
                 const CorrespondenceOptions& correspondence) {
  CheckOptions options;
  options.correspondence = correspondence;
  const auto report = check(made.model, stack, options);
  require(report.ok(), "check() refuses a model of reconstruct()");
  for (const GuaranteeVerdict& verdict : report->guarantees) {
    if (verdict.pass) continue;
    require(false,
            "guarantee " + std::to_string(verdict.number) + ": " + verdict.failures.front().what);
  }
  // Brute force is quadratic and in rationals; larger models are left to check().
  if (made.model.tets.size() > 40) return;
  const oracle::GuaranteeVerdicts verdicts = oracle::guarantees(made.model, stack, options);
  for (const std::optional<bool>& holds : verdicts.holds) {
    require(holds.value_or(true), "brute force: " + verdicts.reasons);
  }
}

// The baseline keeps guarantee 3 and no other.
void check_baseline(const SectionStack& stack) {
  const auto made = reconstruct_geiger(stack);
  if (!made) {
    require_clean(made.error());
    return;
  }
  if (made->model.tets.empty()) return;
  const auto report = check(made->model, stack);
  require(report.ok() && report->guarantees[2].pass, "tets of the baseline overlap");
}

}  // namespace
}  // namespace tetloft::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace tetloft;
  using namespace tetloft::fuzz;
  if (size > 160) return 0;
  Bytes bytes(data, size);
  const DecodedStack decoded = decode_stack(bytes);
  const Result<void> valid = validate(decoded.stack);
  const auto made = reconstruct(decoded.stack, decoded.options);
  if (!made) {
    require_clean(made.error());
    require(made.error().code != ErrorCode::invalid_input || !valid || decoded.is_labelled(),
            "a valid stack is refused as invalid: " + to_string(made.error()));
    require(made.error().code != ErrorCode::unrepresentable || decoded.is_labelled(),
            "a stack on a coarse grid is refused: " + to_string(made.error()));
    require(!to_string(made.error().where).empty() || decoded.is_labelled(),
            "a refusal without a place");
    return 0;
  }
  require(valid.ok(), "a stack that is not valid is reconstructed");
  check_model(*made, decoded.stack, decoded.options.correspondence);
  check_baseline(decoded.stack);
  return 0;
}

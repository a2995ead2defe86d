// The five guarantees: what was checked, and what came of it.
#pragma once

#include <string>
#include <vector>

#include <tetloft/report_page.hpp>

namespace tetloft::internal::report {

[[nodiscard]] std::vector<ReportGuarantee> guarantees_of(
    const std::vector<GuaranteeVerdict>& verdicts);

[[nodiscard]] std::string guarantee_table(const std::vector<ReportGuarantee>& guarantees);

/// "5 of 5 guarantees hold", or how many fail, and how many were not checked.
[[nodiscard]] std::string verdict_sentence(const std::vector<ReportGuarantee>& guarantees);

}  // namespace tetloft::internal::report

// The page: what stands where.
#pragma once

#include <string>

#include <tetloft/report_page.hpp>

#include "report/subject.hpp"

namespace tetloft::internal::report {

/// `report` but its page; `pictures` as that function gives them.
[[nodiscard]] std::string page_of(const Subject& subject, const Report& report,
                                  const std::string& pictures, const ReportOptions& options);

/// As the model or the stack tells it, or "".
[[nodiscard]] const std::string& unit_of(const Model& model, const SectionStack* stack);

}  // namespace tetloft::internal::report

// The page: what stands where.
#pragma once

#include <string>

#include <tetloft/report_page.hpp>

#include "report/subject.hpp"

namespace tetloft::internal::report {

/// `report` but its page; `pictures` as that function gives them.
[[nodiscard]] std::string page_of(const Subject& subject, const Report& report,
                                  const std::string& pictures, const ReportOptions& options);

}  // namespace tetloft::internal::report

// Shapes of tets and lengths of edges. In plain doubles.
#pragma once

#include <vector>

#include <tetloft/report_page.hpp>

#include "report/measures.hpp"
#include "report/subject.hpp"

namespace tetloft::internal::report {

[[nodiscard]] ReportQuality quality_of(const Subject& subject, const MeasuringPoints& points);

/// Bins of width (high − low) / bins from low to high; values beyond count in the last ones.
[[nodiscard]] ReportHistogram linear_histogram(const std::vector<double>& values, double low,
                                               double high, std::size_t bins);
/// Bins of one factor, from the least positive value to the largest; one bin around a single value.
/// Empty without positive values.
[[nodiscard]] ReportHistogram logarithmic_histogram(const std::vector<double>& values,
                                                    std::size_t bins);
/// Reorders the values, and leaves out what is no number. All 0 of none.
[[nodiscard]] ReportSpread spread_of(std::vector<double>& values);

}  // namespace tetloft::internal::report

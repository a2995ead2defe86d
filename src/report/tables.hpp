// The tables of a report.
#pragma once

#include <string>
#include <vector>

#include <tetloft/report_page.hpp>

namespace tetloft::internal::report {

/// `unit`, here and below: of lengths.
[[nodiscard]] std::string component_table(const ReportFigures& figures, const std::string& unit);
/// What kinds of tets there are; empty where the model does not tell.
[[nodiscard]] std::string kind_table(const std::vector<std::size_t>& kinds);
[[nodiscard]] std::string quality_table(const ReportQuality& quality, const std::string& unit);
/// What the check found beside the guarantees, as a list.
[[nodiscard]] std::string check_figures(const CheckReport& check);
/// The links of regions and voids that were nearly decided otherwise.
[[nodiscard]] std::string decision_tables(const Model& model);
/// Where the topology is not as defined; empty where there is no such place.
[[nodiscard]] std::string deviation_table(const std::vector<Deviation>& deviations);
[[nodiscard]] std::string warning_table(const std::vector<Warning>& warnings);

}  // namespace tetloft::internal::report

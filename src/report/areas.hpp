// Area by height: of the solid, and of the sections that it was made of.
#pragma once

#include <tetloft/report_page.hpp>

#include "report/measures.hpp"
#include "report/subject.hpp"

namespace tetloft::internal::report {

/// Fills `solid`, `sections`, `volume_between` and `frustum_volume`.
void measure_areas(const Subject& subject, const MeasuringPoints& points, ReportFigures& figures);

}  // namespace tetloft::internal::report

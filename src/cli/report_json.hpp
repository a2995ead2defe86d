// The numbers of a report as JSON.
#pragma once

#include <tetloft/report_page.hpp>

#include "cli/json.hpp"

namespace tetloft::cli {

/// Members "title", "pass", "guarantees", and all of Report::figures.
void write_report(JsonWriter& json, const Report& report);

}  // namespace tetloft::cli

// Measures, checks and draws a model, and puts it all on a page.
#include <tetloft/report_page.hpp>

#include <string>
#include <utility>

#include "check/alone.hpp"
#include "core/guard.hpp"
#include "core/watched_work.hpp"
#include "report/areas.hpp"
#include "report/guarantees.hpp"
#include "report/measures.hpp"
#include "report/page.hpp"
#include "report/pictures.hpp"
#include "report/quality.hpp"
#include "report/subject.hpp"

namespace tetloft {

using namespace internal;

namespace {

// Subject, check, measures, quality, areas, and the page.
constexpr std::size_t kReportSteps = 6 + report::kPictureSteps;

// Fills guarantees and check.
Result<void> check_for_report(const report::Subject& subject, const ReportOptions& options,
                              Report& report) {
  CheckOptions asked = options.check;
  asked.execution = untold(options.execution);
  if (subject.stack == nullptr) {
    report.guarantees =
        report::guarantees_of(checking::check_alone(subject.view, subject.surface, asked));
    return {};
  }
  auto checked = check(subject.model, *subject.stack, asked);
  if (!checked) return checked.error();
  report.guarantees = report::guarantees_of(checked->guarantees);
  report.check = *std::move(checked);
  return {};
}

void measure_for_report(const report::Subject& subject, WatchedWork& work, ReportFigures& figures) {
  const report::MeasuringPoints points(subject);
  report::measure(subject, points, figures);
  work.step_done_go_on();
  figures.quality = report::quality_of(subject, points);
  work.step_done_go_on();
  report::measure_areas(subject, points, figures);
  work.step_done_go_on();
}

}  // namespace

Result<Report> render_report(const Model& model, const SectionStack* stack,
                             const ReportOptions& options) {
  return guard_internal([&]() -> Result<Report> {
    if (options.sections < 1 || options.sections > kMostReportSections) {
      return Error{ErrorCode::usage,
                   "a report shows 1 to " + std::to_string(kMostReportSections) + " sections",
                   {}};
    }
    WatchedWork work(options.execution, kReportSteps);
    work.go_on();
    if (stack != nullptr) {
      Result<void> valid = validate(*stack, untold(options.execution));
      if (!valid) return valid.error();
    }
    const auto subject = report::subject_of(model, stack);
    if (!subject) return subject.error();
    work.step_done_go_on();
    Report report;
    Result<void> checked = check_for_report(*subject, options, report);
    if (!checked) return checked.error();
    work.step_done_go_on();
    measure_for_report(*subject, work, report.figures);
    report.title = options.title.empty() ? subject->about.name : options.title;
    if (report.title.empty()) report.title = "Solid";
    const std::string pictures = report::pictures(*subject, work);
    report.html = report::page_of(*subject, report, pictures, options);
    work.step_done();
    return report;
  });
}

}  // namespace tetloft

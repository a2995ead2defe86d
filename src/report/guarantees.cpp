#include "report/guarantees.hpp"

#include <array>
#include <cstddef>

#include "report/markup.hpp"

namespace tetloft {

const char* name_of(ReportVerdict verdict) {
  switch (verdict) {
    case ReportVerdict::holds: return "holds";
    case ReportVerdict::fails: return "fails";
    case ReportVerdict::unchecked: return "unchecked";
  }
  return "unknown";
}

bool Report::pass() const {
  for (const ReportGuarantee& guarantee : guarantees) {
    if (guarantee.verdict == ReportVerdict::fails) return false;
  }
  return true;
}

}  // namespace tetloft

namespace tetloft::internal::report {

namespace {

// By number, from 1.
constexpr std::array<const char*, 5> kChecked{
    "Every face belongs to one or two tetrahedra, and what surrounds a vertex is a ball or half a "
    "ball: the solid can be meshed, simulated and printed as it is.",
    "Cut by each section plane, the solid gives back the input region exactly: every input vertex "
    "bit for bit, nothing added, nothing lost.",
    "All tetrahedra are positive, and no two overlap: the surface does not cross itself.",
    "The parts of the solid are those that the rule of correspondence, recomputed from the "
    "sections, asks for: none is joined or parted by chance.",
    "Cavities and tunnels are those that follow from the sections: no handle, bubble or hole that "
    "they do not show."};

std::string failure_list(const std::vector<CheckFailure>& failures) {
  if (failures.empty()) return "";
  std::string items;
  for (const CheckFailure& failure : failures) {
    std::string text = escaped(failure.what) + ": " + count_text(failure.count);
    for (std::size_t k = 0; k < failure.places.size(); ++k) {
      text += (k == 0 ? " (first at " : "; ") + escaped(failure.places[k]);
    }
    if (!failure.places.empty()) text += ')';
    items += element("li", text);
  }
  return element("ul", items);
}

std::size_t how_many(const std::vector<ReportGuarantee>& guarantees, ReportVerdict verdict) {
  std::size_t count = 0;
  for (const ReportGuarantee& guarantee : guarantees) {
    if (guarantee.verdict == verdict) ++count;
  }
  return count;
}

}  // namespace

std::vector<ReportGuarantee> guarantees_of(const std::vector<GuaranteeVerdict>& verdicts) {
  std::vector<ReportGuarantee> guarantees;
  for (const GuaranteeVerdict& verdict : verdicts) {
    ReportGuarantee guarantee{verdict.number, verdict.name, ReportVerdict::holds, {}, {}};
    if (!verdict.not_asked.empty()) {
      guarantee.verdict = ReportVerdict::unchecked;
      guarantee.why = verdict.not_asked;
    } else if (!verdict.pass) {
      guarantee.verdict = ReportVerdict::fails;
      guarantee.failures = verdict.failures;
    }
    guarantees.push_back(std::move(guarantee));
  }
  return guarantees;
}

std::string guarantee_table(const std::vector<ReportGuarantee>& guarantees) {
  std::string rows;
  for (const ReportGuarantee& guarantee : guarantees) {
    const auto at = static_cast<std::size_t>(guarantee.number) - 1;
    std::string text = at < kChecked.size() ? kChecked[at] : "";
    if (!guarantee.why.empty()) text += " Not checked: " + escaped(guarantee.why) + '.';
    text += failure_list(guarantee.failures);
    const std::string verdict = name_of(guarantee.verdict);
    rows += element(
        "tr", element("td", std::to_string(guarantee.number), "class=\"n\"") +
                  element("th", escaped(guarantee.name), "scope=\"row\"") + element("td", text) +
                  element("td", element("span", verdict, "class=\"verdict " + verdict + "\"")));
  }
  return element("table", element("tbody", rows), "class=\"guarantees\"");
}

std::string verdict_sentence(const std::vector<ReportGuarantee>& guarantees) {
  const std::size_t fail = how_many(guarantees, ReportVerdict::fails);
  const std::size_t unchecked = how_many(guarantees, ReportVerdict::unchecked);
  const std::string of_all = " of " + std::to_string(guarantees.size()) + " guarantees ";
  const std::string rest = unchecked == 0 ? "" : ", " + std::to_string(unchecked) + " not checked";
  if (fail > 0) return std::to_string(fail) + of_all + (fail == 1 ? "fails" : "fail") + rest;
  return std::to_string(guarantees.size() - unchecked) + of_all + "hold" + rest;
}

}  // namespace tetloft::internal::report

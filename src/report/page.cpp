#include "report/page.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

#include <tetloft/version.hpp>

#include "render/vector.hpp"
#include "report/axis.hpp"
#include "report/guarantees.hpp"
#include "report/markup.hpp"
#include "report/panels.hpp"
#include "report/plot.hpp"
#include "report/style.hpp"
#include "report/tables.hpp"

namespace tetloft::internal::report {

namespace {

// More points than this are closer than the plot can show.
constexpr std::size_t kMostPlotted = 1200;

std::string part(const char* title, const std::string& content) {
  if (content.empty()) return "";
  return element("section", element("h2", title) + content) + '\n';
}

std::vector<Point2> plotted(const std::vector<ReportArea>& areas) {
  const std::size_t step = (areas.size() + kMostPlotted - 1) / kMostPlotted;
  std::vector<Point2> points;
  for (std::size_t k = 0; k < areas.size(); k += step)
    points.push_back({areas[k].z, areas[k].area});
  return points;
}

// The sides of the box around the points in use, where they lie in their file.
Point3 extent_in_file(const Subject& subject) {
  Box3 box;
  for (std::size_t v = 0; v < subject.view.points.size(); ++v) {
    if (subject.view.used[v] != 0) box.include(place(subject.model.frame, subject.view.points[v]));
  }
  using render::operator-;
  return box.high - box.low;
}

class Page {
 public:
  Page(const Subject& subject, const Report& report, const ReportOptions& options)
      : subject_(subject), report_(report), options_(options), unit_(subject.about.unit) {}

  [[nodiscard]] std::string text(const std::string& pictures) const {
    std::string page =
        "<!DOCTYPE html>\n<html lang=\"en\" xmlns=\"http://www.w3.org/1999/xhtml\">\n<head>\n"
        "<meta charset=\"utf-8\"/>\n"
        "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\"/>\n"
        "<meta name=\"generator\" content=\"tetloft " +
        std::string(version()) + "\"/>\n<link rel=\"icon\" href=\"data:,\"/>\n" +
        element("title", escaped(report_.title)) + '\n' + element("style", kStyle) +
        "\n</head>\n<body>\n";
    page += header();
    page += part("Pictures", pictures);
    page += part("Guarantees", guarantees());
    page += part("Components", components());
    page += part("Sections over the solid", section_panels(subject_, options_.sections));
    page += part("Area by height", areas());
    page += part("Shapes of the tetrahedra", quality());
    page += part("Decisions", decisions());
    page += part("Warnings of reading", warning_table(options_.warnings));
    page += part("How this was made", provenance());
    return page + "</body>\n</html>\n";
  }

 private:
  [[nodiscard]] std::string header() const {
    const std::string class_of_all = !report_.pass()             ? "fails"
                                     : report_.check.has_value() ? "holds"
                                                                 : "unchecked";
    std::string sub = options_.model_file.empty() ? "" : "solid " + escaped(options_.model_file);
    if (!options_.stack_file.empty()) sub += " of the sections " + escaped(options_.stack_file);
    if (!options_.date.empty()) sub += (sub.empty() ? "" : ", ") + escaped(options_.date);
    return "<header>" + element("h1", escaped(report_.title)) +
           (sub.empty() ? "" : element("p", sub, "class=\"sub\"")) +
           element("div", verdict_sentence(report_.guarantees),
                   "class=\"banner " + class_of_all + '"') +
           tiles() + "</header>\n";
  }

  [[nodiscard]] std::string tiles() const {
    const ReportFigures& figures = report_.figures;
    const Point3 size = extent_in_file(subject_);
    std::vector<std::pair<const char*, std::string>> all{
        {"volume", with_unit(figures.all.volume, unit_, 3)},
        {"surface area", with_unit(figures.all.surface_area, unit_, 2)},
        {"components", count_text(figures.components.size())},
        {"genus", known_text(figures.all.genus)},
        {"cavities", known_text(figures.all.cavities)},
        {"sections", subject_.planes.empty() ? "–" : count_text(subject_.planes.size())},
        {"tetrahedra", count_text(figures.all.tets)},
        {"smallest dihedral angle", number_text(figures.quality.dihedral.least, 3) + "°"}};
    all.push_back({"extent, x × y × z", number_text(size.x, 4) + " × " + number_text(size.y, 4) +
                                            " × " + number_text(size.z, 4) +
                                            (unit_.empty() ? "" : " " + unit_text(unit_, 1))});
    std::string out;
    for (const auto& [name, value] : all) {
      out += element("div", element("dt", name) + element("dd", value));
    }
    return element("dl", out, "class=\"tiles\"");
  }

  [[nodiscard]] std::string guarantees() const {
    std::string out = guarantee_table(report_.guarantees);
    if (report_.check) out += check_figures(*report_.check);
    return out;
  }

  [[nodiscard]] std::string components() const {
    std::string out = component_table(report_.figures, unit_);
    out += element("p",
                   "Genus counts handles: tunnels through the solid. A cavity is a closed hollow. "
                   "Sections count from 0.",
                   "class=\"note\"");
    if (report_.figures.components_touch) {
      out += element("p",
                     "Components touch each other: surface area, genus and cavities are those of "
                     "the boundary of all, without the faces that two of them share.",
                     "class=\"note\"");
    }
    return out;
  }

  [[nodiscard]] std::string areas() const {
    const ReportFigures& figures = report_.figures;
    const std::array<Curve, 2> curves{
        {{plotted(figures.solid), "solid", false}, {plotted(figures.sections), "given", true}}};
    const std::string length = unit_.empty() ? "" : ", " + unit_;
    const std::string square = unit_.empty() ? "" : ", " + unit_ + "²";
    std::string text = element("p", "The line is the area in which planes cut the solid.");
    if (!figures.sections.empty()) {
      text = element("p",
                     "Line: the area in which planes cut the solid. Dots: the areas of the "
                     "sections. A line that sags between dots is a dent; one that rises above "
                     "them, a bulge.");
    }
    if (figures.volume_between && figures.frustum_volume) {
      text += volumes(*figures.volume_between, *figures.frustum_volume);
    }
    return "<div class=\"plots\"><figure>" +
           line_plot_svg(curves, {"area by height", "z" + length, "area" + square}) +
           "</figure><div>" + text + "</div></div>";
  }

  [[nodiscard]] std::string volumes(double solid, double frusta) const {
    const double percent = 100 * (solid - frusta) / frusta;
    std::string text =
        "Between the first and the last section the solid has " + with_unit(solid, unit_, 3) +
        "; the areas of the sections alone, taken for frusta, give " + with_unit(frusta, unit_, 3);
    if (std::isfinite(percent)) {
      text += " (" + std::string(percent < 0 ? "" : "+") + number_text(percent, 3) + " %)";
    }
    return element("p", text + ".");
  }

  [[nodiscard]] std::string quality() const {
    const ReportQuality& quality = report_.figures.quality;
    const std::string length = unit_.empty() ? "" : ", " + unit_;
    return "<div class=\"plots\"><figure>" +
           histogram_svg(quality.dihedrals, Scale::linear,
                         {"histogram of dihedral angles", "dihedral angle, degrees", "angles"}) +
           "</figure><figure>" +
           histogram_svg(quality.edge_lengths, Scale::logarithmic,
                         {"histogram of edge lengths", "edge length" + length, "edges"}) +
           "</figure></div><div class=\"plots\"><div>" + quality_table(quality, unit_) +
           element("p",
                   "Mean ratio (Liu and Joe 1994): 1 of a regular tetrahedron, 0 of a flat one.",
                   "class=\"note\"") +
           "</div><div>" + kind_table(report_.figures.kinds) + "</div></div>";
  }

  [[nodiscard]] std::string decisions() const {
    const std::string out =
        decision_tables(subject_.model) + deviation_table(subject_.model.deviations);
    return out.empty() ? out : element("div", out, "class=\"decisions\"");
  }

  [[nodiscard]] std::string provenance() const {
    std::string out;
    const auto add = [&out](const char* name, const std::string& value) {
      if (!value.empty()) out += element("dt", name) + element("dd", value);
    };
    const std::string& orientation = subject_.about.orientation;
    add("solid", escaped(options_.model_file));
    add("sections", escaped(options_.stack_file));
    add("unit of length", unit_.empty() ? "not told by the files" : escaped(unit_));
    add("orientation", orientation.empty()
                           ? ""
                           : escaped(orientation) + " (where x, y and z of the file grow towards)");
    if (subject_.stack != nullptr) add("correspondence", rule_text());
    add("mesh", counted_text(report_.figures.all.tets, "tet") + ", " +
                    count_text(report_.figures.vertices) + " vertices, " +
                    counted_text(report_.figures.quality.edges, "edge") + ", " +
                    counted_text(report_.figures.boundary_triangles, "boundary triangle"));
    add("tetloft", std::string("version ") + version());
    if (!options_.command.empty()) add("command", element("code", escaped(options_.command)));
    add("date", escaped(options_.date));
    return element("dl", out, "class=\"made\"");
  }

  [[nodiscard]] std::string rule_text() const {
    constexpr std::array<const char*, 3> kCriteria{"overlap", "reverse", "moved"};
    constexpr std::array<const char*, 3> kVoids{"overlap", "near", "free"};
    const CorrespondenceOptions& rule = options_.check.correspondence;
    std::string text = kCriteria[static_cast<std::size_t>(rule.criterion)];
    if (rule.criterion != Criterion::reverse) text += " above " + number_text(threshold_of(rule));
    if (!rule.chain) text += ", no chains";
    if (!rule.lone) text += ", lone regions left alone";
    text += std::string("; voids: ") + kVoids[static_cast<std::size_t>(rule.voids.rule)];
    const std::size_t given = rule.labels.size() + rule.decisions.size() +
                              rule.voids.labels.size() + rule.voids.decisions.size();
    if (given > 0) text += "; labels and decisions given: " + count_text(given);
    return text;
  }

  const Subject& subject_;
  const Report& report_;
  const ReportOptions& options_;
  const std::string& unit_;
};

}  // namespace

std::string page_of(const Subject& subject, const Report& report, const std::string& pictures,
                    const ReportOptions& options) {
  return Page(subject, report, options).text(pictures);
}

}  // namespace tetloft::internal::report

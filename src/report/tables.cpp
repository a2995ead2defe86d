#include "report/tables.hpp"

#include <algorithm>
#include <cstddef>
#include <initializer_list>
#include <string_view>

#include "model/sureness.hpp"
#include "render/palette.hpp"
#include "report/axis.hpp"
#include "report/markup.hpp"

namespace tetloft::internal::report {

namespace {

// What a page can show of a long list; --json and the figures have all.
constexpr std::size_t kMostRows = 100;
constexpr std::size_t kMostLinks = 10;
constexpr std::size_t kMostWarnings = 12;
// Links below this are worth a look: the scale is that of overlap ratios.
constexpr double kUnsure = 0.1;

std::string head_of(std::initializer_list<std::string_view> names) {
  std::string cells;
  for (const std::string_view name : names) cells += element("th", name, "scope=\"col\"");
  return element("thead", element("tr", cells));
}

std::string table_of(const std::string& head, const std::string& rows, std::string_view foot = {}) {
  std::string inner = head + element("tbody", rows);
  if (!foot.empty()) inner += element("tfoot", foot);
  return element("div", element("table", inner), "class=\"wide\"");
}

std::string number_cell(const std::string& text) { return element("td", text, "class=\"n\""); }
std::string text_cell(std::string_view text) { return element("td", escaped(text)); }

std::string rest_of(std::size_t all, std::size_t shown, const char* what) {
  if (all <= shown) return "";
  return element("p", "and " + counted_text(all - shown, what) + " more", "class=\"note\"");
}

std::string swatch(const render::Rgb& colour) {
  return "<span class=\"swatch\" style=\"background:" + render::hex(colour) + "\"></span>";
}

std::string section_range(const ReportMeasures& measures) {
  if (!measures.first || !measures.last) return "–";
  const std::string first = std::to_string(measures.first->index());
  if (*measures.first == *measures.last) return first;
  return first + "–" + std::to_string(measures.last->index());
}

std::string measure_cells(const ReportMeasures& measures) {
  return number_cell(number_text(measures.volume)) +
         number_cell(number_text(measures.surface_area)) + number_cell(known_text(measures.genus)) +
         number_cell(known_text(measures.cavities)) + number_cell(section_range(measures)) +
         number_cell(count_text(measures.tets));
}

std::string in_unit(const char* name, const std::string& unit, int power) {
  const std::string text = unit_text(unit, power);
  return text.empty() ? name : std::string(name) + ", " + text;
}

std::string spread_row(const char* name, const ReportSpread& spread, const char* unit = "") {
  std::string cells = element("th", name, "scope=\"row\"");
  for (const double value : {spread.least, spread.median, spread.most}) {
    cells += number_cell(number_text(value, 4) + unit);
  }
  return element("tr", cells);
}

std::string hole_text(ContourId contour) {
  return contour.valid() ? std::to_string(contour.index()) : "outside";
}

const char* remark_on(LinkFate fate) {
  if (fate == LinkFate::made) return "";
  return fate == LinkFate::forced ? "forced to be one" : name_of(fate);
}

std::string link_row(const RegionLink& link) {
  const std::string slab = std::to_string(link.slab.index());
  return element("tr", element("td", slab + "–" + std::to_string(link.slab.index() + 1)) +
                           number_cell(hole_text(link.lower)) + number_cell(hole_text(link.upper)) +
                           text_cell(link.fate == LinkFate::made ? "joined" : "parted") +
                           text_cell(name_of(link.evidence)) + text_cell(remark_on(link.fate)) +
                           number_cell(number_text(link.moved, 3)) +
                           number_cell(number_text(link.distance, 3)) +
                           number_cell(number_text(link.margin, 3)) +
                           number_cell(link.lead ? number_text(*link.lead, 3) : ""));
}

template <class Link>
std::string link_table(const std::vector<Link>& links, const char* what) {
  std::vector<const Link*> unsure;
  std::size_t made = 0;
  for (const Link& link : links) {
    if (link.fate == LinkFate::made) ++made;
    if (sureness(link) < kUnsure) unsure.push_back(&link);
  }
  std::stable_sort(unsure.begin(), unsure.end(),
                   [](const Link* a, const Link* b) { return sureness(*a) < sureness(*b); });
  std::string out = element("p", counted_text(made, "link") + " of " + what + " made, " +
                                     count_text(links.size() - made) + " nearly made; " +
                                     (unsure.empty() ? std::string("none was a close call")
                                                     : counted_text(unsure.size(), "close call")) +
                                     " (margin, or lead over the best rival, below " +
                                     number_text(kUnsure) + ").");
  if (unsure.empty()) return out;
  std::string rows;
  for (std::size_t k = 0; k < unsure.size() && k < kMostLinks; ++k) rows += link_row(*unsure[k]);
  return out +
         table_of(head_of({"sections", "contour below", "contour above", "decided", "by", "remark",
                           "overlap, moved", "distance, gaps", "margin", "lead"}),
                  rows) +
         rest_of(unsure.size(), kMostLinks, "close call");
}

}  // namespace

std::string component_table(const ReportFigures& figures, const std::string& unit) {
  const auto& components = figures.components;
  std::string rows;
  for (std::size_t c = 0; c < components.size() && c < kMostRows; ++c) {
    rows += element("tr",
                    element("th", swatch(render::component_colour(c)) + escaped(components[c].name),
                            "scope=\"row\"") +
                        measure_cells(components[c].measures));
  }
  const std::string total =
      components.size() < 2
          ? ""
          : element("tr", element("th", "all", "scope=\"row\"") + measure_cells(figures.all));
  return table_of(
             head_of({"component", in_unit("volume", unit, 3), in_unit("surface area", unit, 2),
                      "genus", "cavities", "sections", "tets"}),
             rows, total) +
         rest_of(components.size(), kMostRows, "component");
}

std::string kind_table(const std::vector<std::size_t>& kinds) {
  std::size_t all = 0;
  for (const std::size_t count : kinds) all += count;
  std::string rows;
  for (std::size_t k = 0; k < kinds.size(); ++k) {
    if (kinds[k] == 0) continue;
    const auto kind = static_cast<TetKind>(k);
    const double share = 100 * static_cast<double>(kinds[k]) / static_cast<double>(all);
    rows += element(
        "tr", element("th", swatch(render::kind_colour(kind)) + name_of(kind), "scope=\"row\"") +
                  number_cell(count_text(kinds[k])) +
                  number_cell(share < 0.01 ? "below 0.01 %" : number_text(share, 3) + " %"));
  }
  if (rows.empty()) return "";
  return table_of(head_of({"kind of tet", "count", "share"}), rows);
}

std::string quality_table(const ReportQuality& quality, const std::string& unit) {
  std::string length = unit_text(unit, 1);
  if (!length.empty()) length.insert(0, " ");
  return table_of(
      head_of({"", "least", "median", "most"}),
      spread_row("dihedral angles", quality.dihedral, "°") +
          spread_row("smallest dihedral angle of a tet", quality.smallest_dihedral, "°") +
          spread_row("mean ratio of a tet", quality.mean_ratio) +
          spread_row("edge length", quality.edge_length, length.c_str()));
}

std::string check_figures(const CheckReport& check) {
  std::vector<std::string> items;
  if (check.expected_cavities && check.least_genus && check.most_genus) {
    const std::string least = std::to_string(*check.least_genus);
    const std::string most = std::to_string(*check.most_genus);
    items.push_back("The sections imply " +
                    (*check.expected_cavities == 1
                         ? std::string("1 cavity")
                         : count_text(*check.expected_cavities) + " cavities") +
                    " and genus " + (least == most ? least : least + " to " + most) +
                    " of all surfaces together.");
  }
  items.push_back("Between sections the solid reaches sideways beyond both of them by " +
                  number_text(check.overshoot, 3) + " gaps at most.");
  items.push_back("Vertices inserted on contour edges lie at most " +
                  number_text(check.largest_split_ulps, 3) + " units in the last place off them.");
  if (check.inner_vertices > 0) {
    items.push_back(
        "Vertices in section planes off the contours: " + count_text(check.inner_vertices) + '.');
  }
  if (check.dropped_links > 0) {
    items.push_back("Links that the model says no tets could realise: " +
                    count_text(check.dropped_links) + '.');
  }
  if (check.forced_voids + check.unrealisable_voids > 0) {
    items.push_back("Links of voids, as the model says: " + count_text(check.forced_voids) +
                    " forced, " + count_text(check.unrealisable_voids) + " left out.");
  }
  std::string list;
  for (const std::string& item : items) list += element("li", item);
  return element("ul", list, "class=\"figures\"");
}

std::string decision_tables(const Model& model) {
  std::string out;
  if (!model.links.empty()) out += link_table(model.links, "regions");
  if (!model.void_links.empty()) out += link_table(model.void_links, "voids");
  return out;
}

std::string deviation_table(const std::vector<Deviation>& deviations) {
  if (deviations.empty()) return "";
  std::string rows;
  for (std::size_t k = 0; k < deviations.size() && k < kMostRows; ++k) {
    const Deviation& d = deviations[k];
    const std::size_t slab = d.slab.index();
    rows +=
        element("tr", element("td", std::to_string(slab) + "–" + std::to_string(slab + 1)) +
                          number_cell(std::to_string(slab + (d.upper ? 1 : 0))) +
                          number_cell(std::to_string(d.contour.index())) +
                          number_cell(std::to_string(d.least) +
                                      (d.least == d.most ? "" : " to " + std::to_string(d.most))) +
                          number_cell(std::to_string(d.got)));
  }
  return element("p",
                 "Where no tetrahedra give the topology that the sections imply, the model "
                 "says so:") +
         table_of(
             head_of({"sections", "section", "contour", "Euler characteristic implied", "got"}),
             rows) +
         rest_of(deviations.size(), kMostRows, "place");
}

std::string warning_table(const std::vector<Warning>& warnings) {
  if (warnings.empty()) return element("p", "None.");
  std::string items;
  for (std::size_t k = 0; k < warnings.size() && k < kMostWarnings; ++k) {
    items += element("li", escaped(to_string(warnings[k])));
  }
  return element("ul", items, "class=\"warnings\"") +
         rest_of(warnings.size(), kMostWarnings, "warning");
}

}  // namespace tetloft::internal::report

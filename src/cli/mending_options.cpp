// See mending_options.hpp.
#include "cli/mending_options.hpp"

#include <algorithm>
#include <string_view>
#include <utility>

#include "core/option_rules.hpp"
#include "core/spelling.hpp"
#include "io/numbers.hpp"

namespace tetloft::cli {

using namespace internal;

namespace {

constexpr const char* kMergeRemedy = " (--planes merge=TOL does that)";

using Lines = IdVector<SectionId, IdVector<ContourId, std::size_t>>;

const std::vector<std::string>& fill_words() {
  static const std::vector<std::string> words{"odd", "union", "winding"};
  return words;
}

}  // namespace

std::vector<Option> mending_options() {
  return {
      {"--planes",
       "RULE",
       "first put the sections in order: sort (by z; those of one z become one), flip (turn a "
       "stack over that descends), or merge=TOL (sort, and those at most TOL apart become one); "
       "--labels and all messages then number the sections so",
       {},
       {"sort", "flip", "merge"}},
      {"--repair", "",
       "then mend contours that cross or touch, spikes, contours without area and copies of "
       "others: the points of odd crossing number (or see --fill) stay the region; every change is "
       "told, and the area before and after"},
      {"--repair-distance", "D",
       "how far --repair may move the boundary (default 2^-20 of the largest coordinate)"},
      {"--fill",
       "RULE",
       "what --repair (implied) takes for the region: odd (default: points of odd crossing "
       "number), union (traces that overlap are united, contours wholly inside others stay holes), "
       "or winding (points that the contours wind around; holes must run the other way)",
       {},
       fill_words()},
      {"--keyholes", "WIDTH",
       "--repair (implied) also closes channels up to so wide, by which tools cut holes to the "
       "outline"},
  };
}

namespace {

// "merge=TOL", too.
Result<std::optional<PlaneOptions>> planes_option(const Arguments& arguments) {
  const auto given = arguments.text("--planes");
  if (!given) return std::optional<PlaneOptions>();
  const std::vector<std::string_view> rules{"sort", "flip", "merge"};
  const std::size_t equals = given->find('=');
  const std::string word = given->substr(0, equals);
  const auto rule = std::find(rules.begin(), rules.end(), word);
  if (rule == rules.end()) {
    return usage_error("option --planes: " + io::in_quotes(word) + " is not " + list_of(rules) +
                       did_you_mean(word, rules));
  }
  PlaneOptions options;
  options.rule = static_cast<PlaneRule>(rule - rules.begin());
  const bool merges = options.rule == PlaneRule::merge;
  if (merges != (equals != std::string::npos)) {
    return usage_error("option --planes: " +
                       (merges ? std::string("merge takes a tolerance, as in merge=0.01")
                               : word + " takes no tolerance, merge does"));
  }
  if (!merges) return std::optional(options);
  const std::string value = given->substr(equals + 1);
  const io::ParsedNumber number = io::parse_number(value);
  if (!number.ok()) {
    return usage_error("option --planes: " + io::complaint(value, number.status));
  }
  if (!is_length(number.value)) {
    return usage_error("option --planes: the tolerance " + io::in_quotes(value) +
                       " is not above 0");
  }
  options.tolerance = number.value;
  return std::optional(options);
}

Result<std::optional<double>> length_option(const Arguments& arguments, const char* name) {
  auto length = arguments.number(name);
  if (length && length->has_value() && !is_length(**length)) {
    return usage_error(std::string("option ") + name + ": " + io::in_quotes(*arguments.text(name)) +
                       " is not above 0");
  }
  return length;
}

}  // namespace

Result<Mending> mending_of(const Arguments& arguments) {
  Mending mending;
  const auto planes = planes_option(arguments);
  if (!planes) return planes.error();
  mending.planes = *planes;
  const auto fill = arguments.choice("--fill");
  if (!fill) return fill.error();
  const auto keyholes = length_option(arguments, "--keyholes");
  if (!keyholes) return keyholes.error();
  if (arguments.has("--repair") || fill->has_value() || keyholes->has_value()) {
    RepairOptions repair;
    repair.fill = static_cast<FillRule>(fill->value_or(0));
    repair.keyholes = *keyholes;
    mending.repair = repair;
  }
  const auto distance = length_option(arguments, "--repair-distance");
  if (!distance) return distance.error();
  if (distance->has_value()) {
    if (!mending.repair) return usage_error("option --repair-distance needs --repair");
    mending.repair->distance = **distance;
  }
  return mending;
}

Error with_remedy(Error error) {
  if (error.where.contour) {
    error.message += " (--repair may mend it)";
  } else if (error.where.section && error.message.rfind("z does not increase", 0) == 0) {
    const bool descends = error.message.find("descend") != std::string::npos;
    error.message += descends ? " (--planes flip does that)" : " (--planes sort does that)";
  }
  return error;
}

namespace {

// Where in the file a contour begins, or its section's first one.
void locate_in(Place& where, const std::string& path, const Lines& lines) {
  where.file = path;
  if (!where.section || *where.section >= lines.size()) return;
  const auto& contours = lines[SectionId(*where.section)];
  const std::size_t contour = where.contour.value_or(0);
  if (contour < contours.size() && contours[ContourId(contour)] != 0)
    where.line = contours[ContourId(contour)];
}

Error located(Error error, const std::string& path, const Lines& lines) {
  locate_in(error.where, path, lines);
  return error;
}

// Of contours that went where their sections did.
Lines moved_lines(const Lines& lines, const ArrangedPlanes& arranged) {
  Lines moved;
  for (const std::vector<SectionId>& sections : arranged.origin) {
    IdVector<ContourId, std::size_t> contours;
    for (const SectionId s : sections) {
      if (s.index() >= lines.size()) continue;
      for (const std::size_t line : lines[s]) contours.push_back(line);
    }
    moved.push_back(std::move(contours));
  }
  return moved;
}

RepairReport report_of(const Repaired& repaired, FillRule fill) {
  return {fill,
          repaired.changes.size(),
          repaired.moved,
          repaired.area_before,
          repaired.area_after,
          repaired.copies,
          repaired.channels,
          repaired.lost};
}

}  // namespace

void warn_of_reader(const std::vector<Warning>& warnings, const Mending& mending,
                    Console& console) {
  for (Warning warning : warnings) {
    const bool of_gap = is_of_gap(warning);
    if (of_gap && mending.planes) continue;
    if (of_gap) warning.message += kMergeRemedy;
    console.warn(warning);
  }
}

Result<MendedStack> mend_read(const ReadStack& read, const std::string& path,
                              const Mending& mending, Console& console) {
  MendedStack mended;
  mended.stack = read.stack;
  Lines lines = read.lines;
  warn_of_reader(read.warnings, mending, console);
  const auto warn_each = [&](const std::vector<Warning>& warnings, const char* what) {
    for (Warning warning : warnings) {
      locate_in(warning.where, path, lines);
      console.warn({what + warning.message, warning.where});
    }
  };
  if (mending.planes) {
    Result<ArrangedPlanes> arranged = arrange_planes(read.stack, *mending.planes);
    if (!arranged) return located(arranged.error(), path, lines);
    lines = moved_lines(lines, *arranged);
    mended.planes = PlanesReport{read.stack.sections.size(), arranged->stack.sections.size()};
    mended.stack = std::move(arranged->stack);
    warn_each(arranged->changes, "planes: ");
    std::vector<Warning> gaps = suspicious_gaps(mended.stack);
    for (Warning& gap : gaps) gap.message += kMergeRemedy;
    warn_each(gaps, "");
  }
  if (!mending.repair) {
    const Result<void> valid = validate(mended.stack);
    if (!valid) return with_remedy(located(valid.error(), path, lines));
    return mended;
  }
  Result<Repaired> repaired = repair(mended.stack, *mending.repair);
  if (!repaired) {
    const Error error = located(repaired.error(), path, lines);
    return error.where.contour ? error : with_remedy(error);
  }
  warn_each(repaired->changes, "repaired: ");
  mended.repair = report_of(*repaired, mending.repair->fill);
  mended.stack = std::move(repaired->stack);
  return mended;
}

void write_mending(JsonWriter& json, const std::optional<PlanesReport>& planes,
                   const std::optional<RepairReport>& repair) {
  if (planes) {
    json.key("planes");
    json.begin_object();
    json.member("sections_before", planes->sections_before);
    json.member("sections_after", planes->sections_after);
    json.end_object();
  }
  if (!repair) return;
  json.key("repair");
  json.begin_object();
  json.member("fill", fill_words()[static_cast<std::size_t>(repair->fill)].c_str());
  json.member("changes", repair->changes);
  json.member("moved", repair->moved);
  json.member("area_before", repair->area_before);
  json.member("area_after", repair->area_after);
  json.member("copies", repair->copies);
  json.member("channels", repair->channels);
  json.key("lost");
  json.begin_array();
  for (const LostBody& lost : repair->lost) {
    json.begin_object();
    json.member("section", lost.section.index());
    json.member("contour", lost.contour.index());
    json.member("area", lost.area);
    json.end_object();
  }
  json.end_array();
  json.end_object();
}

std::string describe_mending(const std::optional<PlanesReport>& planes,
                             const std::optional<RepairReport>& repair) {
  std::string text;
  if (planes) {
    text += "planes arranged: " + counted(planes->sections_before, "section") + " read, " +
            std::to_string(planes->sections_after) + " now\n";
  }
  if (!repair) return text;
  text += "repaired: " + counted(repair->changes, "change") + ", the boundary moved by " +
          readable(repair->moved) + " at most; area " + readable(repair->area_before) +
          " before, " + readable(repair->area_after) + " after\n";
  if (repair->copies > 0) {
    text += "  copies of other contours left out: " + std::to_string(repair->copies) + '\n';
  }
  if (repair->channels > 0) {
    text += "  channels closed: " + std::to_string(repair->channels) + '\n';
  }
  double lost = 0;
  for (const LostBody& body : repair->lost) lost += body.area;
  if (!repair->lost.empty()) {
    text += "  NOTHING IS LEFT of " + counted(repair->lost.size(), "contour") + " bounding " +
            readable(lost) + " in all\n";
  }
  return text;
}

}  // namespace tetloft::cli

// Plastimatch .cxt, structure sets as text: lines KEY VALUE; the structures, NUMBER|COLOUR|NAME,
// between ROI_NAMES and END_OF_ROI_NAMES; a line for each contour,
// NUMBER|THICKNESS|POINTS|SLICE|UID|x\y\z\x\y\z… Contours are closed; points are in millimetres of
// the patient, whatever OFFSET, DIMENSION and SPACING of the image say.
#include <algorithm>
#include <array>
#include <map>
#include <string>
#include <utility>

#include "io/drawing/text_lines.hpp"
#include "io/drawing/triples.hpp"
#include "io/format.hpp"
#include "io/numbers.hpp"
#include "io/rows.hpp"
#include "io/warning_list.hpp"

namespace tetloft::internal::io {

namespace {

constexpr std::string_view kNamesBegin = "ROI_NAMES";
constexpr std::string_view kNamesEnd = "END_OF_ROI_NAMES";

// Up to the next bar, which is cut off as well.
std::string_view cut_field(std::string_view& line) {
  const std::size_t bar = std::min(line.find('|'), line.size());
  const std::string_view field = without_padding(line.substr(0, bar));
  line.remove_prefix(std::min(bar + 1, line.size()));
  return field;
}

bool is_key(std::string_view word) {
  return !word.empty() && std::all_of(word.begin(), word.end(),
                                      [](char c) { return (c >= 'A' && c <= 'Z') || c == '_'; });
}

// Keys up to that of the names.
bool begins_as_cxt(std::string_view bytes) {
  constexpr std::size_t kMostKeys = 100;
  bytes = without_mark(bytes);
  for (std::size_t i = 0; i < kMostKeys && !bytes.empty(); ++i) {
    const std::string_view line = without_padding(cut_line(bytes));
    if (line == kNamesBegin) return true;
    if (!line.empty() && !is_key(line.substr(0, line.find_first_of(" \t")))) return false;
  }
  return false;
}

class CxtReader {
 public:
  explicit CxtReader(const Source& source) : source_(source), warnings_(source.name) {}

  Result<Drawing> read() {
    drawing_.apart = true;
    drawing_.chosen_by = "--roi";
    drawing_.may_touch = true;
    drawing_.leaves_out_open = true;
    drawing_.unit = "mm";
    drawing_.orientation = "LPS";
    std::string_view rest = without_mark(source_.bytes);
    for (line_ = 1; !rest.empty(); ++line_) {
      const std::string_view line = without_padding(cut_line(rest));
      if (line.empty() || line.front() == '#') continue;
      if (Result<void> taken = take(line); !taken) return taken.error();
    }
    if (part_ != Part::contours) {
      return wrong(std::string("the file ends before the line ") +
                   std::string(part_ == Part::header ? kNamesBegin : kNamesEnd));
    }
    warn_of_miscounted();
    drawing_.warnings = warnings_.take();
    return std::move(drawing_);
  }

 private:
  enum class Part { header, names, contours };

  Error wrong(const std::string& message) const { return row_error(source_.name, line_, message); }

  Result<void> take(std::string_view line) {
    if (part_ == Part::header) {
      if (line == kNamesBegin) part_ = Part::names;
      return {};
    }
    if (part_ == Part::names) {
      if (line != kNamesEnd) return take_structure(line);
      part_ = Part::contours;
      return {};
    }
    return take_contour(line);
  }

  // Old files have white space for the bars.
  Result<void> take_structure(std::string_view line) {
    std::string_view number, name;
    if (line.find('|') != std::string_view::npos) {
      number = cut_field(line);
      cut_field(line);
      name = line;
    } else {
      TextCursor cursor(line);
      number = cursor.token();
      cursor.skip_blanks();
      cursor.token();
      cursor.skip_blanks();
      name = cursor.rest();
    }
    const auto value = parse_integer(number);
    if (!value) {
      return wrong("expected a structure, \"NUMBER|COLOUR|NAME\", or " + std::string(kNamesEnd) +
                   ": " + in_quotes(number) + " is no integer");
    }
    const std::size_t s = drawing_.structures.size();
    drawing_.structures.push_back({*value, std::string(name), {}});
    if (!structure_of_number_.emplace(*value, s).second) {
      warnings_.add("ROI " + std::to_string(*value) + " " + in_quotes(name) +
                        " has the number of another: contours of this number are of the first",
                    line_);
    }
    return {};
  }

  Result<void> take_contour(std::string_view line) {
    if (std::count(line.begin(), line.end(), '|') != 5) {
      return wrong("expected a contour, \"NUMBER|THICKNESS|POINTS|SLICE|UID|x\\y\\z\\…\"");
    }
    const std::string_view number = cut_field(line);
    cut_field(line);
    const std::string_view count = cut_field(line);
    cut_field(line);
    cut_field(line);
    const auto value = parse_integer(number);
    if (!value) return wrong(in_quotes(number) + " is no number of a structure");
    DrawnStructure& structure = structure_of(*value);
    Triples triples = triples_of(line);
    if (!triples.wrong.empty()) {
      return wrong("ROI " + std::to_string(*value) + ", contour " +
                   std::to_string(structure.lines.size()) + ": " + triples.wrong);
    }
    structure.lines.emplace_back();
    structure.lines.back().points = std::move(triples.points);
    structure.lines.back().line = line_;
    const auto told = parse_integer(count);
    const auto points = static_cast<std::int64_t>(structure.lines.back().points.size());
    if (!count.empty() && told != points && miscounted_++ == 0) first_miscounted_ = line_;
    return {};
  }

  DrawnStructure& structure_of(std::int64_t number) {
    const auto [found, is_new] = structure_of_number_.emplace(number, drawing_.structures.size());
    if (is_new) {
      drawing_.structures.push_back({number, {}, {}});
      warnings_.add("there are contours of ROI " + std::to_string(number) +
                        ", which is not in the list of names",
                    line_);
    }
    return drawing_.structures[found->second];
  }

  void warn_of_miscounted() {
    if (miscounted_ == 0) return;
    warnings_.add(std::to_string(miscounted_) + (miscounted_ == 1 ? " contour" : " contours") +
                      " of another number of points than is told, the first here",
                  first_miscounted_);
  }

  const Source& source_;
  WarningList warnings_;
  Drawing drawing_;
  Part part_ = Part::header;
  std::size_t line_ = 1;
  std::map<std::int64_t, std::size_t> structure_of_number_;
  std::size_t miscounted_ = 0;
  std::size_t first_miscounted_ = 0;
};

Result<Drawing> read_cxt(const Source& source, const ReadOptions& /*options*/) {
  return CxtReader(source).read();
}

}  // namespace

extern constinit const Format cxt_format{
    .name = "cxt",
    .summary = "structure sets of plastimatch as text, one structure of several (--roi)",
    .extensions = {".cxt"},
    .recognise = begins_as_cxt,
    .read_drawing = read_cxt};

}  // namespace tetloft::internal::io

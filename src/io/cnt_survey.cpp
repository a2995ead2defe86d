#include "io/cnt_survey.hpp"

#include <cmath>
#include <utility>

#include <tetloft/repair.hpp>
#include <tetloft/section_stack.hpp>
#include <tetloft/valid_stack.hpp>

#include "core/watched_work.hpp"
#include "io/cnt_parser.hpp"
#include "io/cnt_slips.hpp"
#include "io/warning_list.hpp"

namespace tetloft::internal::io {

namespace {

// Sections are judged some at a time, as a stack of their own.
class Surveyor {
 public:
  Surveyor(const ByteSource& source, const std::string& name, const CntBlocks& blocks,
           const Execution& execution)
      : splitter_(source, name, blocks),
        name_(name),
        blocks_(blocks),
        execution_(untold(execution)),
        counts_(name),
        mended_(name) {}

  Result<std::optional<CntSurvey>> run() {
    Result<void> parsed = read_header();
    while (parsed) {
      const Result<std::optional<CntPart>> part = splitter_.next();
      if (!part) return part.error();
      if (!part->has_value()) break;
      parsed = add(**part);
      if (!parsed || some_bytes_ < blocks_.validated) continue;
      if (Result<void> judged = judge(); !judged) return judged.error();
      if (reading_.odd()) break;
    }
    // From the first odd contour on, all of the file tells what its numbers are.
    if (reading_.odd() || some_.odd) return std::optional<CntSurvey>();
    if (!parsed) return parsed.error();
    if (Result<void> judged = judge(); !judged) return judged.error();
    return finish();
  }

 private:
  Result<void> read_header() {
    const Result<std::optional<CntPart>> part = splitter_.next();
    if (!part) return part.error();
    const CntPart beginning = part->value_or(CntPart());
    CntParser parser(beginning.text, name_);
    const Result<CntParser::Header> header = parser.header();
    if (!header) return header.error();
    header_ = *header;
    if (parser.more() && parser.left() > beginning.follows) return parser.section(some_);
    return {};
  }

  Result<void> add(const CntPart& part) {
    if (Result<void> parsed = parse_part(part, name_, some_); !parsed) return parsed;
    const Section& section = some_.stack.sections.raw().back();
    // An order that a validated part of the stack cannot tell of.
    const bool rises = survey_.sections.empty() || section.z > survey_.sections.back().z;
    in_order_ = in_order_ && rises && std::abs(section.z) < kLargestCoordinate;
    survey_.sections.push_back({part.begin, section.z});
    filled_.push_back(!section.contours.empty());
    any_filled_ = any_filled_ || filled_.back();
    some_bytes_ += part.size();
    return {};
  }

  // The sections at hand, which are forgotten then.
  Result<void> judge() {
    reading_.add(some_);
    if (reading_.odd()) return {};
    tell_vertex_counts(some_, counts_);
    mend_contours(some_, mended_);
    open_lines_.add(some_);
    if (Result<void> valid = validate_some(); !valid) return valid;
    CntContents next;
    next.first = survey_.sections.size();
    some_ = std::move(next);
    some_bytes_ = 0;
    return {};
  }

  // The lowest fault counts: none is looked for above one.
  Result<void> validate_some() {
    if (refused_ || some_.stack.contour_count() == 0) return {};
    const auto nested = nest_if_valid(some_.stack, execution_);
    if (nested) return {};
    if (nested.error().code != ErrorCode::invalid_input) return nested.error();
    refused_ = cnt_refusal(nested.error(), some_, name_);
    return {};
  }

  Result<std::optional<CntSurvey>> finish() {
    if (!reading_.plain_pairs() || !any_filled_) return std::optional<CntSurvey>();
    if (Result<void> valid = verdict(); !valid) return valid.error();
    WarningList warnings(name_);
    warnings.append(std::move(counts_));
    tell_section_count(header_, survey_.sections.size(), warnings);
    warnings.append(std::move(mended_));
    for (Warning& warning : suspicious_gaps(heights())) {
      warnings.add(placed(std::move(warning)));
    }
    for (Warning& warning : open_lines_.warnings(WarningList::kMost)) {
      warnings.add(std::move(warning));
    }
    survey_.warnings = warnings.take();
    survey_.checksum = splitter_.checksum();
    return std::optional(std::move(survey_));
  }

  // Which of the heights is wrong, and what to do about it, all of them tell.
  Result<void> verdict() {
    if (!in_order_) {
      SectionStack planes;
      for (const CntSurvey::SectionAt& at : survey_.sections) planes.sections.push_back({at.z, {}});
      Error error = validate(planes, execution_).error();
      if (!error.where.section) return error;
      if (!refused_ || *error.where.section <= *refused_->where.section) {
        return placed(std::move(error));
      }
    }
    if (refused_) return *refused_;
    return {};
  }

  // Contours without vertices where there are any.
  [[nodiscard]] SectionStack heights() const {
    SectionStack stack;
    for (std::size_t s = 0; s < survey_.sections.size(); ++s) {
      Section section{survey_.sections[s].z, {}};
      if (filled_[s]) section.contours.push_back({});
      stack.sections.push_back(std::move(section));
    }
    return stack;
  }

  // Of a warning, or an error, about a section.
  template <class Told>
  Told placed(Told told) const {
    told.where.file = name_;
    told.where.line = survey_.sections[*told.where.section].begin.line;
    return told;
  }

  CntSplitter splitter_;
  const std::string& name_;
  const CntBlocks& blocks_;
  Execution execution_;
  CntParser::Header header_;
  CntContents some_;  // those that were not judged yet
  std::size_t some_bytes_ = 0;
  CntReading reading_;
  OpenLines open_lines_;
  WarningList counts_;
  WarningList mended_;
  std::vector<bool> filled_;  // sections with contours
  bool any_filled_ = false;
  bool in_order_ = true;
  std::optional<Error> refused_;  // of contours, or of heights
  CntSurvey survey_;
};

}  // namespace

Result<void> parse_part(const CntPart& part, const std::string& name, CntContents& contents) {
  CntParser parser(part.text, name, part.begin.line);
  while (parser.more() && parser.left() > part.follows) {
    if (Result<void> parsed = parser.section(contents); !parsed) return parsed;
  }
  return {};
}

Result<std::optional<CntSurvey>> survey_cnt(const ByteSource& source, const std::string& name,
                                            const CntBlocks& blocks, const Execution& execution) {
  return Surveyor(source, name, blocks, execution).run();
}

}  // namespace tetloft::internal::io

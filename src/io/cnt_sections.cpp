#include "io/cnt_sections.hpp"

#include <utility>

#include "io/cnt_slips.hpp"
#include "io/output_place.hpp"
#include "io/warning_list.hpp"

namespace tetloft::internal::io {

CntSections::CntSections(std::unique_ptr<ByteSource> file, std::string name, CntSurvey survey,
                         const CntBlocks& blocks)
    : file_(std::move(file)),
      name_(std::move(name)),
      survey_(std::move(survey)),
      blocks_(blocks),
      splitter_(*file_, name_, blocks_) {}

Result<std::optional<Section>> CntSections::next() {
  Result<std::optional<CntPart>> part = splitter_.next();
  const bool header = part && part->has_value() && (*part)->begin.offset == 0;
  if (header) part = splitter_.next();
  if (!part) return part.error();
  const bool ends = next_ == survey_.sections.size();
  if (part->has_value() == ends) return changed();
  if (ends) {
    if (splitter_.checksum() != survey_.checksum) return changed();
    return std::optional<Section>();
  }
  CntContents contents;
  contents.first = next_;
  if (Result<void> parsed = parse_part(**part, name_, contents); !parsed) return parsed.error();
  if (contents.odd || contents.stack.sections.size() != 1) return changed();
  WarningList told(name_);  // by the survey
  mend_contours(contents, told);
  ++next_;
  return std::optional(std::move(contents.stack.sections[SectionId(0)]));
}

Place CntSections::located(Place where) {
  where.file = name_;
  if (where.line || !where.section || *where.section >= survey_.sections.size()) return where;
  const CntPlace begin = survey_.sections[*where.section].begin;
  if (where.contour) {
    CntContents contents;
    contents.first = *where.section;
    CntSplitter splitter(*file_, name_, blocks_, begin);
    const Result<std::optional<CntPart>> part = splitter.next();
    // What it has become is for next() to say.
    if (part && part->has_value() && parse_part(**part, name_, contents)) {
      where = with_line(std::move(where), contents);
    }
  }
  if (!where.line) where.line = begin.line;
  return where;
}

Error CntSections::changed() const { return io_error(name_, "changes while it is read", 0); }

Result<std::optional<OpenedSections>> open_cnt_sections(std::unique_ptr<ByteSource>& file,
                                                        const std::string& name,
                                                        const ReadOptions& options) {
  if (options.close_on_frame || options.validity != Validity::required) {
    return std::optional<OpenedSections>();
  }
  const CntBlocks blocks;
  Result<std::optional<CntSurvey>> survey = survey_cnt(*file, name, blocks, options.execution);
  if (!survey) return survey.error();
  if (!survey->has_value()) return std::optional<OpenedSections>();
  OpenedSections opened;
  opened.count = (*survey)->sections.size();
  opened.warnings = std::move((*survey)->warnings);
  opened.sections =
      std::make_unique<CntSections>(std::move(file), name, *std::move(*survey), blocks);
  return std::optional(std::move(opened));
}

}  // namespace tetloft::internal::io

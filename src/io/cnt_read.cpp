// A .cnt as a whole, read in one pass. Both counts are redundant here: they are compared with what
// follows, and tell pairs from triples where that is open.
#include "io/cnt_read.hpp"

#include <string>
#include <utility>
#include <vector>

#include <tetloft/repair.hpp>
#include <tetloft/valid_stack.hpp>

#include "core/watched_work.hpp"
#include "io/cnt_contents.hpp"
#include "io/cnt_parser.hpp"
#include "io/cnt_slips.hpp"

namespace tetloft::internal::io {

namespace {

class CntReader {
 public:
  CntReader(std::string_view text, const std::string& name)
      : parser_(text, name), name_(name), warnings_(name) {}

  Result<StackOfFile> read(const ReadOptions& options) {
    Result<void> parsed = read_sections();
    // Nothing is wrong before the first odd contour, whatever follows.
    if (!parsed && !contents_.odd) return parsed.error();
    Result<std::optional<Warning>> settled = settle_vertices(contents_);
    if (!settled) return with_file(settled.error());
    if (!parsed) return parsed.error();
    tell_vertex_counts(contents_, warnings_);
    tell_section_count(header_, contents_.stack.sections.size(), warnings_);
    if (settled->has_value()) warnings_.add(**std::move(settled));
    mend_contours(contents_, warnings_);
    if (options.close_on_frame) {
      if (Result<void> closed = close_lines(); !closed) return closed.error();
    }
    for (Warning& warning : suspicious_gaps(contents_.stack)) warn(std::move(warning));
    OpenLines lines;
    lines.add(contents_);
    for (Warning& warning : lines.warnings(WarningList::kMost)) warn(std::move(warning));
    IdVector<SectionId, Nesting> nestings;
    if (options.validity == Validity::required) {
      auto nested = nest_if_valid(contents_.stack, untold(options.execution));
      if (!nested) return cnt_refusal(nested.error(), contents_, name_);
      nestings = *std::move(nested);
    }
    return StackOfFile{{std::move(contents_.stack), warnings_.take(), std::move(contents_.lines)},
                       std::move(nestings)};
  }

 private:
  Result<void> read_sections() {
    const Result<CntParser::Header> header = parser_.header();
    if (!header) return header.error();
    header_ = *header;
    while (parser_.more()) {
      if (Result<void> section = parser_.section(contents_); !section) return section;
    }
    return {};
  }

  Result<void> close_lines() {
    const std::vector<ContourOfSection> lines = lines_to_the_frame(contents_.stack);
    Result<ClosedOnFrame> closed = close_on_frame(contents_.stack, lines);
    if (!closed) {
      Error error = with_file(closed.error());
      error.where = with_line(std::move(error.where), contents_);
      return error;
    }
    for (Warning& change : closed->changes) warn(std::move(change));
    if (lines.empty()) warn({"no line is open: nothing is closed along a frame", {}});
    contents_.stack = std::move(closed->stack);
    for (const SectionId s : contents_.stack.sections.ids()) {
      IdVector<ContourId, std::size_t> of_contours;
      for (const ContourId of : closed->origin[s]) {
        of_contours.push_back(of.valid() ? contents_.lines[s][of] : contents_.header_lines[s]);
      }
      contents_.lines[s] = std::move(of_contours);
    }
    return {};
  }

  void warn(Warning warning) {
    warning.where = with_line(std::move(warning.where), contents_);
    warnings_.add(std::move(warning));
  }

  [[nodiscard]] Error with_file(Error error) const {
    error.where.file = name_;
    return error;
  }

  CntParser parser_;
  const std::string& name_;
  CntParser::Header header_;
  CntContents contents_;
  WarningList warnings_;
};

}  // namespace

Result<StackOfFile> read_cnt_source(const Source& source, const ReadOptions& options) {
  return CntReader(source.bytes, source.name).read(options);
}

}  // namespace tetloft::internal::io

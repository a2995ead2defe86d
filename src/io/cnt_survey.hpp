// What is of a whole .cnt, gathered by reading it section by section.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include <tetloft/execution.hpp>
#include <tetloft/result.hpp>

#include "io/cnt_contents.hpp"
#include "io/cnt_splitter.hpp"

namespace tetloft::internal::io {

struct CntSurvey {
  struct SectionAt {
    CntPlace begin;
    double z = 0;
  };
  std::vector<SectionAt> sections;
  std::vector<Warning> warnings;  ///< those of the reader of the whole
  std::uint32_t checksum = 0;     ///< of the file, as CntSplitter has it
};

/// Appends the sections of a part to `contents`, of which they are the next. Errors as of the
/// reader of the whole.
[[nodiscard]] Result<void> parse_part(const CntPart& part, const std::string& name,
                                      CntContents& contents);

/// Reads the file once. Memory: some sections, and 32 bytes for each. Refused as by the reader of
/// the whole, in its words. Nothing where the file must be read as a whole to tell what it holds:
/// an odd contour, three numbers to a vertex, decimal commas; or no contour at all.
[[nodiscard]] Result<std::optional<CntSurvey>> survey_cnt(const ByteSource& source,
                                                          const std::string& name,
                                                          const CntBlocks& blocks,
                                                          const Execution& execution);

}  // namespace tetloft::internal::io

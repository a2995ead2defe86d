// The sections of a .cnt, one after the other, of a file that is never held as a whole.
#pragma once

#include <memory>
#include <optional>
#include <string>

#include <tetloft/formats.hpp>

#include "io/bytes/byte_source.hpp"
#include "io/cnt_splitter.hpp"
#include "io/cnt_survey.hpp"

namespace tetloft::internal::io {

/// Reads what was surveyed again. Error io, at the latest at the end, where that is another file by
/// now; or what the parser says of it then.
class CntSections final : public SectionStream {
 public:
  CntSections(std::unique_ptr<ByteSource> file, std::string name, CntSurvey survey,
              const CntBlocks& blocks);

  [[nodiscard]] Result<std::optional<Section>> next() override;
  /// Reads the section again where a contour is named.
  [[nodiscard]] Place located(Place where) override;

 private:
  [[nodiscard]] Error changed() const;

  std::unique_ptr<ByteSource> file_;
  std::string name_;
  CntSurvey survey_;
  CntBlocks blocks_;
  CntSplitter splitter_;
  std::size_t next_ = 0;
};

/// As Format::open_sections.
[[nodiscard]] Result<std::optional<OpenedSections>> open_cnt_sections(
    std::unique_ptr<ByteSource>& file, const std::string& name, const ReadOptions& options);

}  // namespace tetloft::internal::io

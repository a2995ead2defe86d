// The elements of a DICOM data set (PS3.5, 7), one after the other: a pull parser. Sequences of
// interest are entered and so are those of undefined length, whose end nothing else tells; memory
// is a frame for each level of nesting.
#pragma once

#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <tetloft/result.hpp>

namespace tetloft::internal::io {

struct DicomTag {
  std::uint16_t group = 0;
  std::uint16_t element = 0;
  friend bool operator==(const DicomTag&, const DicomTag&) = default;
  friend auto operator<=>(const DicomTag&, const DicomTag&) = default;
};

/// "(3006,0050)".
[[nodiscard]] std::string to_string(DicomTag tag);

struct DicomEncoding {
  bool explicit_vr = true;
  bool big_endian = false;
  friend bool operator==(const DicomEncoding&, const DicomEncoding&) = default;
};

/// Whether these are the two letters of a value representation that there is.
[[nodiscard]] bool is_value_representation(std::string_view letters);

struct DicomEvent {
  enum class Kind : std::uint8_t { value, item_begin, item_end, end };
  Kind kind = Kind::end;
  DicomTag tag;            ///< of the value, or of the sequence that the item is of
  std::string_view value;  ///< as it stands there, padded
  std::uint64_t offset = 0;
};

class DicomElements {
 public:
  /// From `at` on in `bytes`, which must outlive it. Of sequences whose length is defined only
  /// those in `entered` are entered; others are values. `name` stands for the file in errors,
  /// `of_what` for what offsets count in ("the file").
  DicomElements(std::string_view bytes, std::size_t at, DicomEncoding encoding, std::string name,
                std::string of_what, std::initializer_list<DicomTag> entered);

  /// Error invalid_input, naming element and offset, where a length leads out of what holds the
  /// element, or the data end within it.
  [[nodiscard]] Result<DicomEvent> next();

  /// Ends after the elements of `group`, the first one.
  void stop_after_group(std::uint16_t group) { only_group_ = group; }
  /// Where the next element begins.
  [[nodiscard]] std::size_t position() const { return at_; }

  /// Whether we are directly in items of these sequences, one in the other.
  [[nodiscard]] bool within(std::initializer_list<DicomTag> sequences) const;

 private:
  enum class FrameKind : std::uint8_t { sequence, item, fragments };
  struct Frame {
    FrameKind kind = FrameKind::sequence;
    bool undefined = false;  ///< a delimiter ends it
    DicomEncoding encoding;
    DicomTag tag;
    std::size_t begin = 0;
    std::size_t end = 0;  ///< the latest that is possible
  };
  struct Header {
    DicomTag tag;
    bool is_sequence = false;  ///< by its representation
    bool unknown_vr = false;
    std::uint32_t length = 0;
    std::size_t size = 0;  ///< of the header
  };

  using Step = Result<std::optional<DicomEvent>>;

  [[nodiscard]] std::size_t limit() const;
  [[nodiscard]] DicomEncoding encoding() const;
  [[nodiscard]] DicomEncoding hidden_encoding(std::size_t end) const;
  [[nodiscard]] std::uint16_t load16(std::size_t at) const;
  [[nodiscard]] std::uint32_t load32(std::size_t at) const;
  [[nodiscard]] DicomTag tag_at(std::size_t at) const;
  [[nodiscard]] bool only_zeros_follow() const;
  [[nodiscard]] Result<Header> read_header() const;
  [[nodiscard]] Step step();
  [[nodiscard]] Step read_element();
  [[nodiscard]] Step read_item();
  [[nodiscard]] Step read_end();
  [[nodiscard]] bool take_delimiter(DicomTag tag);
  [[nodiscard]] DicomEvent pop_item();
  [[nodiscard]] Error error_at(std::size_t at, const std::string& message) const;
  [[nodiscard]] Error length_error(DicomTag tag, std::uint32_t length, std::size_t room) const;

  std::string_view bytes_;
  std::size_t at_;
  DicomEncoding encoding_;
  std::string name_;
  std::string of_what_;
  std::vector<DicomTag> entered_;
  std::vector<Frame> frames_;
  std::optional<std::uint16_t> only_group_;
};

}  // namespace tetloft::internal::io

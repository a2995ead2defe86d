// DICOM data elements, pulled one by one.
#include "io/drawing/dicom_elements.hpp"

#include <algorithm>
#include <array>
#include <cstdio>

#include "core/little_endian.hpp"

namespace tetloft::internal::io {

namespace {

constexpr std::uint32_t kUndefinedLength = 0xFFFFFFFF;
constexpr DicomTag kItem{0xFFFE, 0xE000};
constexpr DicomTag kItemEnd{0xFFFE, 0xE00D};
constexpr DicomTag kSequenceEnd{0xFFFE, 0xE0DD};
constexpr DicomTag kPixelData{0x7FE0, 0x0010};

constexpr std::array<std::string_view, 34> kRepresentations{
    "AE", "AS", "AT", "CS", "DA", "DS", "DT", "FD", "FL", "IS", "LO", "LT",
    "OB", "OD", "OF", "OL", "OV", "OW", "PN", "SH", "SL", "SQ", "SS", "ST",
    "SV", "TM", "UC", "UI", "UL", "UN", "UR", "US", "UT", "UV"};
// Those whose length has four bytes, behind two that are reserved (PS3.5, 7.1.2).
constexpr std::array<std::string_view, 13> kLongOnes{"OB", "OD", "OF", "OL", "OV", "OW", "SQ",
                                                     "SV", "UC", "UN", "UR", "UT", "UV"};

bool are_capitals(std::string_view letters) {
  return std::all_of(letters.begin(), letters.end(), [](char c) { return c >= 'A' && c <= 'Z'; });
}

std::string bytes_text(std::size_t count) {
  return std::to_string(count) + (count == 1 ? " byte" : " bytes");
}

}  // namespace

std::string to_string(DicomTag tag) {
  std::array<char, 16> text{};
  std::snprintf(text.data(), text.size(), "(%04x,%04x)", tag.group, tag.element);
  return text.data();
}

bool is_value_representation(std::string_view letters) {
  return std::find(kRepresentations.begin(), kRepresentations.end(), letters) !=
         kRepresentations.end();
}

DicomElements::DicomElements(std::string_view bytes, std::size_t at, DicomEncoding encoding,
                             std::string name, std::string of_what,
                             std::initializer_list<DicomTag> entered)
    : bytes_(bytes),
      at_(at),
      encoding_(encoding),
      name_(std::move(name)),
      of_what_(std::move(of_what)),
      entered_(entered) {}

std::size_t DicomElements::limit() const {
  return frames_.empty() ? bytes_.size() : frames_.back().end;
}

DicomEncoding DicomElements::encoding() const {
  return frames_.empty() ? encoding_ : frames_.back().encoding;
}

std::uint16_t DicomElements::load16(std::size_t at) const {
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(bytes_[at + i]); };
  return static_cast<std::uint16_t>(encoding().big_endian ? byte(0) << 8 | byte(1)
                                                          : byte(1) << 8 | byte(0));
}

std::uint32_t DicomElements::load32(std::size_t at) const {
  const std::uint32_t first = load16(at);
  const std::uint32_t second = load16(at + 2);
  return encoding().big_endian ? first << 16 | second : second << 16 | first;
}

DicomTag DicomElements::tag_at(std::size_t at) const { return {load16(at), load16(at + 2)}; }

bool DicomElements::within(std::initializer_list<DicomTag> sequences) const {
  if (frames_.size() != 2 * sequences.size()) return false;
  std::size_t i = 0;
  for (const DicomTag& tag : sequences) {
    if (frames_[i].tag != tag || frames_[i + 1].kind != FrameKind::item) return false;
    i += 2;
  }
  return true;
}

Error DicomElements::error_at(std::size_t at, const std::string& message) const {
  Error error{ErrorCode::invalid_input, {}, {}};
  error.message = "byte " + std::to_string(at) + " of " + of_what_ + ": " + message;
  error.where.file = name_;
  return error;
}

Error DicomElements::length_error(DicomTag tag, std::uint32_t length, std::size_t room) const {
  std::string message = "element " + to_string(tag) + " has a length of " + bytes_text(length) +
                        ", of which only " + bytes_text(room) + " are left in ";
  message += frames_.empty() || limit() == bytes_.size()
                 ? of_what_ + ": it is cut off, or a length before is wrong"
                 : "the item of " + to_string(frames_.back().tag) + " that holds it";
  return error_at(at_, message);
}

bool DicomElements::only_zeros_follow() const {
  return std::all_of(bytes_.begin() + static_cast<std::ptrdiff_t>(at_), bytes_.end(),
                     [](char c) { return c == '\0'; });
}

// Of elements that are no items or delimiters. Within explicit data some writers leave single
// elements implicit; that they lack the two letters tells.
Result<DicomElements::Header> DicomElements::read_header() const {
  const std::size_t room = limit() - at_;
  Header header;
  header.tag = tag_at(at_);
  header.size = 8;
  const std::string_view letters = bytes_.substr(at_ + 4, 2);
  if (!encoding().explicit_vr || !are_capitals(letters)) {
    header.length = load32(at_ + 4);
    return header;
  }
  if (!is_value_representation(letters)) {
    return error_at(at_, "element " + to_string(header.tag) + " has the representation '" +
                             std::string(letters) + "', which there is not");
  }
  header.is_sequence = letters == "SQ";
  header.unknown_vr = letters == "UN";
  if (std::find(kLongOnes.begin(), kLongOnes.end(), letters) == kLongOnes.end()) {
    header.length = load16(at_ + 6);
    return header;
  }
  header.size = 12;
  if (room < header.size) {
    return error_at(at_, "the header of element " + to_string(header.tag) + " is cut off");
  }
  header.length = load32(at_ + 8);
  return header;
}

// What is hidden as unknown is implicit, little endian (PS3.5, 6.2.2). Some writers leave it as it
// was: then there are letters behind the tag of the first item's first element, which taken for a
// length would lead out of all.
DicomEncoding DicomElements::hidden_encoding(std::size_t end) const {
  constexpr std::size_t kLetters = 8 + 4;
  if (end - at_ < kLetters + 4) return {false, false};
  const std::string_view letters = bytes_.substr(at_ + kLetters, 4);
  const bool known = is_value_representation(letters.substr(0, 2));
  const bool too_long = load_little<std::uint32_t>(letters.data()) > end - at_;
  return known && too_long ? encoding() : DicomEncoding{false, false};
}

DicomElements::Step DicomElements::read_element() {
  const std::size_t begin = at_;
  const Result<Header> header = read_header();
  if (!header) return header.error();
  const DicomTag tag = header->tag;
  const std::size_t room = limit() - begin - header->size;
  const bool undefined = header->length == kUndefinedLength;
  if (!undefined && header->length > room) return length_error(tag, header->length, room);
  const bool entered = std::find(entered_.begin(), entered_.end(), tag) != entered_.end();
  at_ = begin + header->size;
  if (!undefined && !entered) {
    const std::string_view value = bytes_.substr(at_, header->length);
    at_ += value.size();
    return std::optional(DicomEvent{DicomEvent::Kind::value, tag, value, begin});
  }
  Frame frame;
  frame.kind = tag == kPixelData ? FrameKind::fragments : FrameKind::sequence;
  frame.undefined = undefined;
  frame.tag = tag;
  frame.begin = begin;
  frame.end = undefined ? limit() : at_ + header->length;
  frame.encoding = header->unknown_vr ? hidden_encoding(frame.end) : encoding();
  frames_.push_back(frame);
  return std::optional<DicomEvent>();
}

DicomEvent DicomElements::pop_item() {
  const DicomEvent event{DicomEvent::Kind::item_end, frames_.back().tag, {}, at_};
  frames_.pop_back();
  return event;
}

// A delimiter of an item or a sequence. Those of frames that have a defined length end nothing;
// one of a sequence ends an item that lacks its own. Returns whether an item has ended.
bool DicomElements::take_delimiter(DicomTag tag) {
  const bool in_item = !frames_.empty() && frames_.back().kind == FrameKind::item;
  const bool undefined = !frames_.empty() && frames_.back().undefined;
  if (tag == kSequenceEnd && in_item && undefined && frames_[frames_.size() - 2].undefined) {
    return true;  // and is met again in the sequence
  }
  at_ += 8;
  if (tag == kItemEnd) return in_item && undefined;
  if (!in_item && undefined) frames_.pop_back();
  return false;
}

DicomElements::Step DicomElements::read_item() {
  const Frame& sequence = frames_.back();
  const DicomTag tag = tag_at(at_);
  const std::uint32_t length = load32(at_ + 4);
  if (tag != kItem) {
    return error_at(at_, "expected an item of the sequence " + to_string(sequence.tag) +
                             " that begins at byte " + std::to_string(sequence.begin) + ", found " +
                             to_string(tag));
  }
  const std::size_t room = limit() - at_ - 8;
  const bool undefined = length == kUndefinedLength;
  if (!undefined && length > room) return length_error(tag, length, room);
  const std::size_t begin = at_;
  at_ += 8;
  if (sequence.kind == FrameKind::fragments) {
    if (undefined) return error_at(begin, "a fragment of pixel data has no length");
    at_ += length;
    return std::optional<DicomEvent>();
  }
  Frame item = sequence;
  item.kind = FrameKind::item;
  item.undefined = undefined;
  item.begin = begin;
  item.end = undefined ? limit() : at_ + length;
  frames_.push_back(item);
  return std::optional(DicomEvent{DicomEvent::Kind::item_begin, item.tag, {}, begin});
}

// Where nothing but the end can follow.
DicomElements::Step DicomElements::read_end() {
  if (frames_.empty()) return std::optional(DicomEvent{DicomEvent::Kind::end, {}, {}, at_});
  const Frame& frame = frames_.back();
  return error_at(
      at_, std::string(limit() == bytes_.size() ? "it ends" : "what holds it ends") + " within " +
               (frame.kind == FrameKind::item ? "an item of the sequence " : "the sequence ") +
               to_string(frame.tag) + " that begins at byte " + std::to_string(frame.begin));
}

// An event, or none where only a frame has begun or ended.
DicomElements::Step DicomElements::step() {
  if (!frames_.empty() && !frames_.back().undefined && at_ == frames_.back().end) {
    if (frames_.back().kind == FrameKind::item) return std::optional(pop_item());
    frames_.pop_back();
    return std::optional<DicomEvent>();
  }
  const std::size_t room = limit() - at_;
  if (room == 0 || (frames_.empty() && room < 8 && only_zeros_follow())) return read_end();
  if (room < 8) return error_at(at_, "the header of an element is cut off");
  const DicomTag tag = tag_at(at_);
  if (frames_.empty() && only_group_ && tag.group != *only_group_) return read_end();
  if (tag == kItemEnd || tag == kSequenceEnd) {
    return take_delimiter(tag) ? std::optional(pop_item()) : std::nullopt;
  }
  if (!frames_.empty() && frames_.back().kind != FrameKind::item) return read_item();
  if (tag == kItem) return error_at(at_, "an item outside of a sequence");
  return read_element();
}

Result<DicomEvent> DicomElements::next() {
  while (true) {
    Step step = this->step();
    if (!step) return step.error();
    if (step->has_value()) return **step;
  }
}

}  // namespace tetloft::internal::io

// Preamble, meta information and transfer syntax of DICOM files.
#include "io/drawing/dicom_file.hpp"

#include <algorithm>
#include <optional>

#include "core/little_endian.hpp"
#include "io/bytes/inflate.hpp"
#include "io/drawing/triples.hpp"
#include "io/numbers.hpp"

namespace tetloft::internal::io {

namespace {

constexpr std::size_t kPreamble = 128;
constexpr std::uint16_t kMetaGroup = 0x0002;
constexpr DicomTag kMetaLength{kMetaGroup, 0x0000};
constexpr DicomTag kMediaClass{kMetaGroup, 0x0002};
constexpr DicomTag kTransferSyntax{kMetaGroup, 0x0010};

constexpr std::string_view kImplicitLittle = "1.2.840.10008.1.2";
constexpr std::string_view kExplicitLittle = "1.2.840.10008.1.2.1";
constexpr std::string_view kExplicitBig = "1.2.840.10008.1.2.2";
constexpr std::string_view kDeflated = "1.2.840.10008.1.2.1.99";
// Of these the pixels are packed; the data set around them is explicit, little endian (PS3.5, A.4).
constexpr std::string_view kEncapsulated[] = {"1.2.840.10008.1.2.4.", "1.2.840.10008.1.2.5"};

// Structure sets deflate to a quarter or a tenth; what becomes far larger is made to fill memory.
constexpr std::size_t kMostDeflatedRatio = 32;
constexpr std::size_t kUnpackedAnyway = std::size_t{1} << 20;
constexpr std::size_t kUnpackedPiece = std::size_t{1} << 14;

bool has_preamble(std::string_view bytes) {
  return bytes.substr(std::min(kPreamble, bytes.size()), 4) == "DICM";
}

// How the data set is encoded that begins with these bytes, as its first element tells: by two
// letters that are a representation, or a length that leads to a greater tag. None where it is
// no beginning of one.
std::optional<DicomEncoding> encoding_of(std::string_view bytes) {
  if (bytes.size() < 8) return std::nullopt;
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(bytes[i]); };
  const bool letters = is_value_representation(bytes.substr(4, 2));
  // The first groups are below 0x0100: of the two bytes the one that is 0 is the higher.
  if (letters && byte(0) == 0 && byte(1) != 0) return DicomEncoding{true, true};
  if (byte(1) != 0) return std::nullopt;
  if (letters) return DicomEncoding{true, false};
  const std::size_t length = load_little<std::uint32_t>(bytes.data() + 4);
  if (length > bytes.size() - 8) return std::nullopt;
  const std::string_view rest = bytes.substr(8 + length);
  if (rest.size() < 4)
    return rest.empty() ? std::optional(DicomEncoding{false, false}) : std::nullopt;
  const DicomTag first{load_little<std::uint16_t>(bytes.data()),
                       load_little<std::uint16_t>(bytes.data() + 2)};
  const DicomTag second{load_little<std::uint16_t>(rest.data()),
                        load_little<std::uint16_t>(rest.data() + 2)};
  if (second <= first) return std::nullopt;
  return DicomEncoding{false, false};
}

Error no_dicom(const std::string& name, const std::string& message) {
  Error error{ErrorCode::invalid_input, message, {}};
  error.where.file = name;
  return error;
}

}  // namespace

bool begins_as_dicom(std::string_view bytes) {
  if (has_preamble(bytes)) return true;
  if (bytes.size() < 8) return false;
  const auto little = load_little<std::uint16_t>(bytes.data());
  const bool group = little == kMetaGroup || little == 0x0008 || little == 0x0800;
  // The group has no elements of its own above this one that could stand first.
  const bool element = little == 0x0800 ? bytes[2] == 0 : bytes[3] == 0;
  return group && element && encoding_of(bytes).has_value();
}

Result<DicomFile> DicomFile::open(std::string_view bytes, const std::string& name,
                                  WarningList& warnings) {
  DicomFile file;
  file.bytes_ = bytes;
  file.name_ = name;
  const std::size_t at = has_preamble(bytes) ? kPreamble + 4 : 0;
  if (at == 0 && !begins_as_dicom(bytes)) {
    return no_dicom(name,
                    "this is no DICOM file: neither has it DICM at byte 128, nor does it "
                    "begin with a data element");
  }
  const std::string_view rest = bytes.substr(at);
  const bool meta = rest.size() >= 2 && load_little<std::uint16_t>(rest.data()) == kMetaGroup;
  file.begin_ = at;
  if (meta) {
    if (Result<void> taken = file.take_meta(at, warnings); !taken) return taken.error();
  }
  if (Result<void> taken = file.take_syntax(at, warnings); !taken) return taken.error();
  return file;
}

// Always explicit, little endian; its end is where another group begins. Behind it a deflated data
// set may begin with any byte: there the length that it tells of itself decides.
Result<void> DicomFile::take_meta(std::size_t at, WarningList& warnings) {
  DicomElements meta(bytes_, at, {true, false}, name_, "the file", {});
  meta.stop_after_group(kMetaGroup);
  std::size_t told_end = 0;
  while (true) {
    if (syntax_ == kDeflated && meta.position() == told_end) break;
    const Result<DicomEvent> event = meta.next();
    if (!event) return event.error();
    if (event->kind == DicomEvent::Kind::end) break;
    if (event->kind != DicomEvent::Kind::value) continue;
    if (event->tag == kMediaClass) media_class_ = without_padding(event->value);
    if (event->tag == kTransferSyntax) syntax_ = without_padding(event->value);
    if (event->tag == kMetaLength && event->value.size() == 4) {
      told_end = meta.position() + load_little<std::uint32_t>(event->value.data());
    }
  }
  begin_ = meta.position();
  if (syntax_.empty()) warnings.add("the meta information names no transfer syntax: it is guessed");
  return {};
}

Result<void> DicomFile::take_syntax(std::size_t at, WarningList& warnings) {
  if (syntax_ == kDeflated) {
    return unpack();
  }
  const std::optional<DicomEncoding> seen = encoding_of(bytes_.substr(begin_));
  std::optional<DicomEncoding> told;
  if (syntax_ == kImplicitLittle) told = DicomEncoding{false, false};
  if (syntax_ == kExplicitLittle) told = DicomEncoding{true, false};
  if (syntax_ == kExplicitBig) told = DicomEncoding{true, true};
  for (const std::string_view prefix : kEncapsulated) {
    if (!syntax_.starts_with(prefix)) continue;
    told = DicomEncoding{true, false};
    warnings.add("transfer syntax " + syntax_ +
                 " is one of packed images: the data set is read as explicit, little endian");
  }
  if (!syntax_.empty() && !told) {
    return no_dicom(name_, "transfer syntax " + in_quotes(syntax_) +
                               " is not read (implicit and explicit little endian, explicit big "
                               "endian and deflated are)");
  }
  if (!told && !seen) {
    return no_dicom(name_, "byte " + std::to_string(begin_) +
                               " of the file: no data element begins a data set here");
  }
  if (told && seen && *told != *seen && at != begin_) {
    warnings.add("transfer syntax " + syntax_ + " is not that of the data set, which is read as " +
                 (seen->explicit_vr ? "explicit, " : "implicit, ") +
                 (seen->big_endian ? "big endian" : "little endian"));
  }
  encoding_ = seen ? *seen : *told;
  return {};
}

// Piece by piece, so that errors tell the place in the file.
Result<void> DicomFile::unpack() {
  const std::size_t most = kMostDeflatedRatio * bytes_.size() + kUnpackedAnyway;
  const MemoryBytes source(bytes_);
  Inflater inflater(source, begin_, Wrapping::raw, name_);
  for (std::size_t piece = kUnpackedPiece; true; piece = std::max(piece, unpacked_.size())) {
    const std::size_t had = unpacked_.size();
    unpacked_.resize(had + piece);
    const Result<std::size_t> got = inflater.read(std::span(unpacked_).subspan(had));
    if (!got) return got.error();
    unpacked_.resize(had + *got);
    if (*got < piece) break;
    if (unpacked_.size() > most) {
      return no_dicom(name_, "the deflated data set unpacks to more than " + std::to_string(most) +
                                 " bytes, far beyond what structure sets do");
    }
  }
  deflated_ = true;
  return {};
}

DicomElements DicomFile::elements(std::initializer_list<DicomTag> entered) const {
  if (deflated_) {
    return {unpacked_, 0, {true, false}, name_, "the unpacked data set", entered};
  }
  return {bytes_, begin_, encoding_, name_, "the file", entered};
}

}  // namespace tetloft::internal::io

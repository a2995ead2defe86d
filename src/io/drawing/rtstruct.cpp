// DICOM RT structure sets (PS3.3, C.8.8.5 and C.8.8.6): structures by StructureSetROISequence,
// their contours by ROIContourSequence. First all is collected as it stands, for the number of an
// item's structure may stand behind its contours, and its name anywhere.
#include <algorithm>
#include <array>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "io/drawing/dicom_elements.hpp"
#include "io/drawing/dicom_file.hpp"
#include "io/drawing/dicom_text.hpp"
#include "io/drawing/triples.hpp"
#include "io/format.hpp"
#include "io/numbers.hpp"
#include "io/warning_list.hpp"

namespace tetloft::internal::io {

namespace {

constexpr DicomTag kCharacterSet{0x0008, 0x0005};
constexpr DicomTag kSopClass{0x0008, 0x0016};
constexpr DicomTag kModality{0x0008, 0x0060};
constexpr DicomTag kStructures{0x3006, 0x0020};
constexpr DicomTag kStructureNumber{0x3006, 0x0022};
constexpr DicomTag kStructureName{0x3006, 0x0026};
constexpr DicomTag kRoiContours{0x3006, 0x0039};
constexpr DicomTag kContours{0x3006, 0x0040};
constexpr DicomTag kGeometricType{0x3006, 0x0042};
constexpr DicomTag kPointCount{0x3006, 0x0046};
constexpr DicomTag kContourData{0x3006, 0x0050};
constexpr DicomTag kReferencedNumber{0x3006, 0x0084};

constexpr std::string_view kStructureSetClass = "1.2.840.10008.5.1.4.1.1.481.3";

struct NamedClass {
  std::string_view uid;
  std::string_view name;
};
// What people have beside structure sets.
constexpr std::array<NamedClass, 10> kOtherClasses{
    {{"1.2.840.10008.5.1.4.1.1.2", "a CT image"},
     {"1.2.840.10008.5.1.4.1.1.2.1", "an enhanced CT image"},
     {"1.2.840.10008.5.1.4.1.1.4", "an MR image"},
     {"1.2.840.10008.5.1.4.1.1.128", "a PET image"},
     {"1.2.840.10008.5.1.4.1.1.481.1", "an RT image"},
     {"1.2.840.10008.5.1.4.1.1.481.2", "an RT dose"},
     {"1.2.840.10008.5.1.4.1.1.481.5", "an RT plan"},
     {"1.2.840.10008.5.1.4.1.1.66.1", "a spatial registration"},
     {"1.2.840.10008.5.1.4.1.1.66.4", "a segmentation (DICOM SEG)"},
     {"1.2.840.10008.1.3.10", "a DICOMDIR"}}};

// As they stand in the file; views are of its bytes.
struct RawStructure {
  std::string_view number;
  std::string_view name;
  std::optional<std::string_view> characters;  // of its own
};
struct RawContour {
  std::string_view type;
  std::string_view count;
  std::string_view data;
  std::uint64_t offset = 0;
  std::size_t item = 0;  // of ROIContourSequence
};
struct RawSet {
  std::string_view characters;
  std::string_view sop_class;
  std::string_view modality;
  bool has_sequences = false;
  std::vector<RawStructure> structures;
  std::vector<std::string_view> referenced;  // by items of ROIContourSequence
  std::vector<RawContour> contours;
};

std::optional<std::int64_t> number_of(std::string_view value) {
  return parse_integer(without_padding(value));
}

class RawSetReader {
 public:
  explicit RawSetReader(DicomElements elements) : elements_(std::move(elements)) {}

  Result<RawSet> read() {
    while (true) {
      const Result<DicomEvent> event = elements_.next();
      if (!event) return event.error();
      if (event->kind == DicomEvent::Kind::end) return std::move(set_);
      if (event->kind == DicomEvent::Kind::item_begin) begin_item(*event);
      if (event->kind == DicomEvent::Kind::value) take(*event);
    }
  }

 private:
  void begin_item(const DicomEvent& event) {
    if (elements_.within({kStructures})) set_.structures.emplace_back();
    if (elements_.within({kRoiContours})) set_.referenced.emplace_back();
    if (elements_.within({kStructures}) || elements_.within({kRoiContours})) {
      set_.has_sequences = true;
    }
    if (elements_.within({kRoiContours, kContours})) {
      set_.contours.push_back({{}, {}, {}, event.offset, set_.referenced.size() - 1});
    }
  }

  void take(const DicomEvent& event) {
    if (elements_.within({})) {
      if (event.tag == kCharacterSet) set_.characters = event.value;
      if (event.tag == kSopClass) set_.sop_class = without_padding(event.value);
      if (event.tag == kModality) set_.modality = without_padding(event.value);
    } else if (elements_.within({kStructures})) {
      RawStructure& structure = set_.structures.back();
      if (event.tag == kCharacterSet) structure.characters = event.value;
      if (event.tag == kStructureNumber) structure.number = event.value;
      if (event.tag == kStructureName) structure.name = event.value;
    } else if (elements_.within({kRoiContours})) {
      if (event.tag == kReferencedNumber) set_.referenced.back() = event.value;
    } else if (elements_.within({kRoiContours, kContours})) {
      RawContour& contour = set_.contours.back();
      if (event.tag == kGeometricType) contour.type = without_padding(event.value);
      if (event.tag == kPointCount) contour.count = event.value;
      if (event.tag == kContourData) {
        contour.data = event.value;
        contour.offset = event.offset;
      }
    }
  }

  DicomElements elements_;
  RawSet set_;
};

// How many contours are odd in some way, and the first of them.
struct OddContours {
  std::size_t count = 0;
  std::size_t first = 0;

  void add(std::size_t contour) {
    if (count++ == 0) first = contour;
  }
  /// "3 contours", and which is the first.
  [[nodiscard]] std::string text() const {
    return std::to_string(count) + (count == 1 ? " contour" : " contours") + " (" +
           (count == 1 ? "" : "the first is ") + "contour " + std::to_string(first) + ")";
  }
};

struct OddOfStructure {
  OddContours without_data, without_type, miscounted;
  std::map<std::string, OddContours> unknown_type;
};

class StructureSet {
 public:
  StructureSet(RawSet raw, const std::string& name, WarningList& warnings)
      : raw_(std::move(raw)), name_(name), warnings_(warnings) {}

  Result<Drawing> drawing() {
    drawing_.apart = true;
    drawing_.chosen_by = "--roi";
    drawing_.may_touch = true;
    drawing_.leaves_out_open = true;
    drawing_.unit = "mm";
    drawing_.orientation = "LPS";
    add_structures();
    find_structures();
    reserve_lines();
    odd_.resize(drawing_.structures.size());
    for (const RawContour& contour : raw_.contours) {
      if (!structure_of_item_[contour.item]) continue;
      if (Result<void> added = add_contour(contour); !added) return added.error();
    }
    for (std::size_t s = 0; s < odd_.size(); ++s) warn_of(odd_[s], called(s));
    drawing_.warnings = warnings_.take();
    return std::move(drawing_);
  }

 private:
  [[nodiscard]] std::string called(std::size_t s) const {
    const DrawnStructure& structure = drawing_.structures[s];
    return "ROI " + std::to_string(structure.number) +
           (structure.name.empty() ? "" : " " + in_quotes(structure.name));
  }

  void add_structures() {
    const DicomCharacters characters(raw_.characters);
    drawing_.structures.reserve(raw_.structures.size());
    for (const RawStructure& raw : raw_.structures) {
      const std::size_t s = drawing_.structures.size();
      const DicomCharacters::Text name =
          (raw.characters ? DicomCharacters(*raw.characters) : characters).decode(raw.name);
      const std::optional<std::int64_t> number = number_of(raw.number);
      drawing_.structures.push_back({number.value_or(0), name.text, {}});
      if (!name.odd.empty()) warnings_.add(called(s) + ": its name is " + name.odd);
      if (!number) {
        warnings_.add(called(s) + " has no number: no contours can refer to it");
      } else if (!structure_of_number_.emplace(*number, s).second) {
        warnings_.add("the number of " + called(s) +
                      " is that of another: contours of this number are of the first");
      }
    }
  }

  // Of each item of ROIContourSequence; contours of none are kept under the number they refer to.
  void find_structures() {
    std::size_t nowhere = 0;
    std::map<std::size_t, std::size_t> items_of;
    for (const std::string_view referenced : raw_.referenced) {
      const std::optional<std::int64_t> number = number_of(referenced);
      structure_of_item_.emplace_back();
      if (!number) {
        ++nowhere;
        continue;
      }
      const auto [found, is_new] =
          structure_of_number_.emplace(*number, drawing_.structures.size());
      if (is_new) {
        drawing_.structures.push_back({*number, {}, {}});
        warnings_.add("there are contours of " + called(found->second) +
                      ", of which StructureSetROISequence does not tell");
      }
      structure_of_item_.back() = found->second;
      if (++items_of[found->second] == 2) {
        warnings_.add("several items of ROIContourSequence are of " + called(found->second) +
                      ": their contours are read together");
      }
    }
    if (nowhere > 0) {
      warnings_.add(std::to_string(nowhere) + (nowhere == 1 ? " item" : " items") +
                    " of ROIContourSequence with no number of a ROI left out");
    }
  }

  void reserve_lines() {
    std::vector<std::size_t> count(drawing_.structures.size());
    for (const RawContour& contour : raw_.contours) {
      if (const auto s = structure_of_item_[contour.item]) ++count[*s];
    }
    for (std::size_t s = 0; s < count.size(); ++s) drawing_.structures[s].lines.reserve(count[s]);
    std::string without;
    std::size_t some = 0;
    for (std::size_t s = 0; s < raw_.structures.size(); ++s) {
      if (count[s] != 0) continue;
      constexpr std::size_t kMostNamed = 10;
      if (some++ < kMostNamed) without += (without.empty() ? "" : ", ") + called(s);
    }
    if (some > 0) warnings_.add(std::to_string(some) + " without contours: " + without);
  }

  Result<void> add_contour(const RawContour& raw) {
    const std::size_t s = *structure_of_item_[raw.item];
    DrawnStructure& structure = drawing_.structures[s];
    const std::size_t index = structure.lines.size();
    OddOfStructure& odd = odd_[s];
    structure.lines.emplace_back();
    DrawnLine& line = structure.lines.back();
    line.type = DicomCharacters().decode(raw.type).text;
    line.offset = raw.offset;
    const std::optional<LineKind> kind = kind_of(raw.type);
    line.kind = kind.value_or(LineKind::points);
    if (raw.type.empty()) {
      odd.without_type.add(index);
    } else if (!kind) {
      odd.unknown_type[line.type].add(index);
    }
    Triples triples = triples_of(raw.data);
    if (!triples.wrong.empty()) return data_error(raw, s, index, triples.wrong);
    line.points = std::move(triples.points);
    if (line.points.empty()) {
      odd.without_data.add(index);
      return {};
    }
    const std::optional<std::int64_t> count = number_of(raw.count);
    const bool told = !without_padding(raw.count).empty();
    if (told && (!count || *count != static_cast<std::int64_t>(line.points.size()))) {
      odd.miscounted.add(index);
    }
    return {};
  }

  // None where there is no such type. Writers differ in blanks, underscores and case; a contour
  // without its type is what nearly all are.
  static std::optional<LineKind> kind_of(std::string_view type) {
    if (type.empty()) return LineKind::closed;
    std::string letters;
    for (const char c : type.substr(0, 40)) {
      if (c >= 'a' && c <= 'z') letters += static_cast<char>(c - 'a' + 'A');
      if (c >= 'A' && c <= 'Z') letters += c;
    }
    if (letters == "CLOSEDPLANAR" || letters == "CLOSEDPLANARXOR" ||
        letters == "INTERPOLATEDPLANAR") {
      return LineKind::closed;
    }
    if (letters == "OPENPLANAR" || letters == "OPENNONPLANAR") return LineKind::open;
    if (letters == "POINT") return LineKind::points;
    return std::nullopt;
  }

  Error data_error(const RawContour& raw, std::size_t s, std::size_t index,
                   const std::string& message) const {
    Error error{ErrorCode::invalid_input, {}, {}};
    error.message = called(s) + ", contour " + std::to_string(index) + " (element " +
                    to_string(kContourData) + " at byte " + std::to_string(raw.offset) +
                    "): " + message;
    error.where.file = name_;
    return error;
  }

  void warn_of(const OddOfStructure& odd, const std::string& structure) {
    const auto warn = [&](const OddContours& contours, const std::string& what) {
      if (contours.count > 0) warnings_.add(structure + ": " + contours.text() + what);
    };
    warn(odd.without_data, " without ContourData");
    warn(odd.without_type, " without ContourGeometricType, taken for closed");
    warn(odd.miscounted, " of another number of points than NumberOfContourPoints tells");
    for (const auto& [type, contours] : odd.unknown_type) {
      warn(contours, " of type " + in_quotes(type) + ", which is not known: left out");
    }
  }

  RawSet raw_;
  const std::string& name_;
  WarningList& warnings_;
  Drawing drawing_;
  std::map<std::int64_t, std::size_t> structure_of_number_;
  std::vector<std::optional<std::size_t>> structure_of_item_;
  std::vector<OddOfStructure> odd_;
};

// Other objects, and structure sets that do not say that they are.
Result<void> check_class(const RawSet& set, const std::string& name, WarningList& warnings) {
  if (set.sop_class == kStructureSetClass) return {};
  const auto known = std::find_if(kOtherClasses.begin(), kOtherClasses.end(),
                                  [&](const NamedClass& c) { return c.uid == set.sop_class; });
  std::string what = "modality " + (set.modality.empty() ? "none" : in_quotes(set.modality)) +
                     ", SOP class " + (set.sop_class.empty() ? "none" : in_quotes(set.sop_class));
  if (known != kOtherClasses.end()) what = std::string(known->name) + ": " + what;
  if (set.modality == "RTSTRUCT" || set.has_sequences) {
    warnings.add("read as a structure set, though it does not say that it is one (" + what + ")");
    return {};
  }
  Error error{
      ErrorCode::invalid_input, "this DICOM file holds no structure set (" + what + ")", {}};
  error.message += "; contours are read from RTSTRUCT files";
  error.where.file = name;
  return error;
}

Result<Drawing> read_rtstruct(const Source& source, const ReadOptions& /*options*/) {
  WarningList warnings(source.name);
  const Result<DicomFile> file = DicomFile::open(source.bytes, source.name, warnings);
  if (!file) return file.error();
  Result<RawSet> raw = RawSetReader(file->elements({kStructures, kRoiContours, kContours})).read();
  if (!raw) return raw.error();
  // A DICOMDIR names its class there alone.
  if (raw->sop_class.empty()) raw->sop_class = file->media_class();
  if (Result<void> checked = check_class(*raw, source.name, warnings); !checked) {
    return checked.error();
  }
  return StructureSet(*std::move(raw), source.name, warnings).drawing();
}

}  // namespace

extern constinit const Format rtstruct_format{
    .name = "rtstruct",
    .summary = "DICOM RT structure sets, one structure of several (--roi)",
    .extensions = {".dcm", ".dicom"},
    .recognise = begins_as_dicom,
    .read_drawing = read_rtstruct};

}  // namespace tetloft::internal::io

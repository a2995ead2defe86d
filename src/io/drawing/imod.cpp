// IMOD models, binary (IMODV1.2): a header, then pieces that begin with four letters, big-endian.
// An object (OBJT) has contours (CONT) behind it; other pieces tell their length and are passed
// over.
//
// Points are stored in pixels of the image. They are handed out as pixel size · (x, y, zscale · z)
// in the unit of the header, from the corner of the image (in z from the middle of the first
// section, which is where IMOD has 0); where the image itself lies (MINX) is left aside.
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "io/drawing/imod_text.hpp"
#include "io/drawing/triples.hpp"
#include "io/format.hpp"
#include "io/numbers.hpp"
#include "io/warning_list.hpp"

namespace tetloft::internal::io {

namespace {

constexpr std::string_view kImodVersion = "IMODV1.2";
constexpr std::size_t kImodHeader = 8 + 232;

// Bits of the flags of objects and contours.
constexpr std::uint32_t kOpenFlag = 1U << 3;
constexpr std::uint32_t kScatteredFlag = 1U << 9;

bool begins_as_imod(std::string_view bytes) {
  return bytes.starts_with("IMODV") || begins_as_imod_text(bytes);
}

// A power of ten of the metre, but for the first ones.
std::string imod_unit(std::int32_t code) {
  switch (code) {
    case 0: return "pixel";
    case 1: return "m";
    case 3: return "km";
    case -2: return "cm";
    case -3: return "mm";
    case -6: return "um";
    case -9: return "nm";
    case -10: return "angstrom";
    case -12: return "pm";
    default: return {};
  }
}

class ImodReader {
 public:
  explicit ImodReader(const Source& source)
      : source_(source), bytes_(source.bytes), warnings_(source.name) {}

  Result<Drawing> read() {
    drawing_.apart = true;
    drawing_.chosen_by = "--roi";
    drawing_.leaves_out_open = true;
    if (Result<void> done = read_header(); !done) return done.error();
    bool ended = false;
    while (!ended && at_ < bytes_.size()) {
      const Result<bool> piece = read_piece();
      if (!piece) return piece.error();
      ended = !*piece;
    }
    if (!ended) warnings_.add("the file has no mark at its end (IEOF): it may be cut off");
    warn_of_counts();
    drawing_.warnings = warnings_.take();
    return std::move(drawing_);
  }

 private:
  // What an object tells of itself.
  struct Told {
    std::int32_t contours = 0;
    bool open = false;
    bool scattered = false;
    std::int32_t time = 0;  // of its first contour
    bool several_times = false;
  };

  Error wrong(std::size_t at, const std::string& message) const {
    Error error{ErrorCode::invalid_input, "byte " + std::to_string(at) + ": " + message, {}};
    error.where.file = source_.name;
    return error;
  }

  [[nodiscard]] std::uint32_t unsigned_at(std::size_t at) const {
    std::uint32_t value = 0;
    for (std::size_t i = 0; i < 4; ++i) {
      value = value << 8U | static_cast<unsigned char>(bytes_[at + i]);
    }
    return value;
  }
  [[nodiscard]] std::int32_t integer_at(std::size_t at) const {
    return static_cast<std::int32_t>(unsigned_at(at));
  }
  [[nodiscard]] double float_at(std::size_t at) const {
    return std::bit_cast<float>(unsigned_at(at));
  }

  // Whether `count` pieces of `size` bytes follow at `at`.
  [[nodiscard]] bool fits(std::size_t at, std::int64_t count, std::size_t size) const {
    return count >= 0 && at <= bytes_.size() &&
           static_cast<std::uint64_t>(count) <= (bytes_.size() - at) / size;
  }

  Result<void> read_header() {
    if (!bytes_.starts_with(kImodVersion)) {
      return wrong(0, "this is no IMOD model of version 1.2: it begins with " +
                          in_quotes(bytes_.substr(0, kImodVersion.size())));
    }
    if (bytes_.size() < kImodHeader) {
      return wrong(bytes_.size(),
                   "the file ends within its header of " + std::to_string(kImodHeader) + " bytes");
    }
    told_objects_ = integer_at(148);
    const double zscale = float_at(192);
    const double pixel = float_at(216);
    drawing_.unit = imod_unit(integer_at(220));
    if (drawing_.unit.empty()) warnings_.add("the unit of the pixel size is not known");
    scale_ = take_scale(pixel, "pixel size");
    z_scale_ = scale_ * take_scale(zscale, "z scale");
    at_ = kImodHeader;
    return {};
  }

  double take_scale(double value, const std::string& what) {
    if (std::isfinite(value) && value > 0) return value;
    std::string message = "the " + what + " is ";
    append_number(message, value);
    warnings_.add(message + ": 1 is taken");
    return 1;
  }

  // False at the end mark.
  Result<bool> read_piece() {
    if (!fits(at_, 1, 4)) return wrong(at_, "the file ends within the name of a piece");
    const std::string_view name = bytes_.substr(at_, 4);
    if (name == "IEOF") return false;
    Result<void> done;
    if (name == "OBJT") {
      done = read_object();
    } else if (name == "CONT") {
      done = read_contour();
    } else if (name == "MESH") {
      done = pass_mesh();
    } else {
      done = pass_other(name);
    }
    if (!done) return done.error();
    return true;
  }

  Result<void> read_object() {
    constexpr std::size_t kSize = 4 + 176;
    if (!fits(at_, 1, kSize)) return wrong(at_, "the file ends within an object");
    const std::string_view name = bytes_.substr(at_ + 4, 64);
    const std::uint32_t flags = unsigned_at(at_ + 4 + 132);
    Told told;
    told.contours = integer_at(at_ + 4 + 128);
    told.open = (flags & kOpenFlag) != 0;
    told.scattered = (flags & kScatteredFlag) != 0;
    told_.push_back(told);
    const auto number = static_cast<std::int64_t>(told_.size());
    drawing_.structures.push_back(
        {number, std::string(without_padding(name.substr(0, name.find('\0')))), {}});
    at_ += kSize;
    return {};
  }

  Result<void> read_contour() {
    constexpr std::size_t kHeader = 4 + 16;
    if (!fits(at_, 1, kHeader)) return wrong(at_, "the file ends within the header of a contour");
    if (drawing_.structures.empty()) return wrong(at_, "a contour before any object");
    DrawnStructure& object = drawing_.structures.back();
    Told& told = told_.back();
    const std::string place = "object " + std::to_string(object.number) + ", contour " +
                              std::to_string(object.lines.size() + 1) + ": ";
    const std::int32_t count = integer_at(at_ + 4);
    const std::uint32_t flags = unsigned_at(at_ + 8);
    const std::int32_t time = integer_at(at_ + 12);
    if (!fits(at_ + kHeader, count, 12)) {
      return wrong(at_, place + "the file ends within its " + std::to_string(count) + " points");
    }
    if (object.lines.empty()) told.time = time;
    if (time != told.time) told.several_times = true;
    DrawnLine line;
    const bool open = told.open || (flags & kOpenFlag) != 0;
    line.kind = told.scattered ? LineKind::points : open ? LineKind::open : LineKind::closed;
    line.offset = at_;
    line.points.reserve(static_cast<std::size_t>(count));
    at_ += kHeader;
    for (std::int32_t i = 0; i < count; ++i, at_ += 12) {
      const Point3 p{scale_ * float_at(at_), scale_ * float_at(at_ + 4),
                     z_scale_ * float_at(at_ + 8)};
      if (!std::isfinite(p.x) || !std::isfinite(p.y) || !std::isfinite(p.z)) {
        return wrong(at_, place + "point " + std::to_string(i + 1) + " is not finite");
      }
      line.points.push_back(p);
    }
    object.lines.push_back(std::move(line));
    return {};
  }

  Result<void> pass_mesh() {
    constexpr std::size_t kHeader = 4 + 16;
    if (!fits(at_, 1, kHeader)) return wrong(at_, "the file ends within the header of a mesh");
    const std::int32_t vertices = integer_at(at_ + 4);
    const std::int32_t indices = integer_at(at_ + 8);
    const std::size_t list = at_ + kHeader + 12 * static_cast<std::size_t>(std::max(vertices, 0));
    if (!fits(at_ + kHeader, vertices, 12) || !fits(list, indices, 4)) {
      return wrong(at_, "the file ends within a mesh of " + std::to_string(vertices) +
                            " vertices and " + std::to_string(indices) + " indices");
    }
    at_ = list + 4 * static_cast<std::size_t>(indices);
    return {};
  }

  Result<void> pass_other(std::string_view name) {
    const bool told = fits(at_ + 4, 1, 4);
    const std::int32_t length = told ? integer_at(at_ + 4) : 0;
    if (!told || !fits(at_ + 8, length, 1)) {
      return wrong(at_, "the file ends within the piece " + in_quotes(name) +
                            (told ? " of " + std::to_string(length) + " bytes" : ""));
    }
    at_ += 8 + static_cast<std::size_t>(length);
    return {};
  }

  void warn_of_counts() {
    if (told_objects_ != static_cast<std::int64_t>(told_.size())) {
      warnings_.add("the header tells of " + std::to_string(told_objects_) +
                    " objects, the file has " + std::to_string(told_.size()));
    }
    for (std::size_t i = 0; i < told_.size(); ++i) {
      const DrawnStructure& object = drawing_.structures[i];
      const std::string name = "object " + std::to_string(object.number) +
                               (object.name.empty() ? "" : " " + in_quotes(object.name));
      if (told_[i].contours != static_cast<std::int64_t>(object.lines.size())) {
        warnings_.add(name + " tells of " + std::to_string(told_[i].contours) +
                      " contours and has " + std::to_string(object.lines.size()));
      }
      if (told_[i].several_times) {
        warnings_.add(name + " has contours of several times, which are read together");
      }
    }
  }

  const Source& source_;
  std::string_view bytes_;
  WarningList warnings_;
  Drawing drawing_;
  std::size_t at_ = 0;
  std::int32_t told_objects_ = 0;
  double scale_ = 1;
  double z_scale_ = 1;
  std::vector<Told> told_;
};

Result<Drawing> read_imod(const Source& source, const ReadOptions& /*options*/) {
  if (begins_as_imod_text(source.bytes)) return read_imod_text(source);
  return ImodReader(source).read();
}

}  // namespace

extern constinit const Format imod_format{.name = "imod",
                                          .summary = "IMOD models, one object of several (--roi)",
                                          .extensions = {".mod", ".imod"},
                                          .recognise = begins_as_imod,
                                          .read_drawing = read_imod};

}  // namespace tetloft::internal::io

#include "c/last_error.hpp"

#include <cstddef>
#include <cstring>
#include <optional>
#include <string_view>
#include <type_traits>

#include "c/call.hpp"
#include "c/structs.hpp"

namespace tetloft::internal::c {

namespace {

// A text of at most so many bytes; what is longer is cut, after a whole character of UTF-8.
class FixedText {
 public:
  void set(std::string_view text) noexcept {
    std::size_t size = text.size();
    if (size > kMost) {
      size = kMost;
      while (size > 0 && (static_cast<unsigned char>(text[size]) & 0xC0U) == 0x80) --size;
    }
    if (size > 0) std::memcpy(bytes_, text.data(), size);
    bytes_[size] = '\0';
  }
  [[nodiscard]] const char* c_str() const noexcept { return bytes_; }

 private:
  static constexpr std::size_t kMost = 4095;
  char bytes_[kMost + 1];
};

struct LastError {
  FixedText line;     // place and message
  FixedText message;  // without the place
  FixedText file;
  std::optional<std::size_t> place_line, section, slab, contour, vertex;
  std::optional<Point3> point;

  void set(std::string_view whole, std::string_view alone, const Place& where) noexcept {
    line.set(whole);
    message.set(alone);
    file.set(where.file);
    place_line = where.line;
    section = where.section;
    slab = where.slab;
    contour = where.contour;
    vertex = where.vertex;
    point = where.point;
  }
};

// All bytes 0: no failure yet. Trivially destructible, so that nothing has to be registered, which
// takes memory, when a thread fails for the first time.
thread_local constinit LastError last_error{};
static_assert(std::is_trivially_destructible_v<LastError>);

tetloft_status remember(const Error& error) {
  last_error.set(to_string(error), to_string(Error{error.code, error.message, {}}), error.where);
  return static_cast<tetloft_status>(error.code);
}

tetloft_status remember(const Refusal& refusal) {
  last_error.set(refusal.message, refusal.message, {});
  return refusal.status;
}

int64_t number_of(const std::optional<std::size_t>& value) {
  return value ? static_cast<int64_t>(*value) : -1;
}

tetloft_place place_of(const LastError& error) {
  tetloft_place place{};
  place.version = TETLOFT_PLACE_VERSION;
  place.file = *error.file.c_str() == '\0' ? nullptr : error.file.c_str();
  place.line = number_of(error.place_line);
  place.section = number_of(error.section);
  place.slab = number_of(error.slab);
  place.contour = number_of(error.contour);
  place.vertex = number_of(error.vertex);
  place.has_point = error.point ? 1 : 0;
  if (error.point) {
    place.point[0] = error.point->x;
    place.point[1] = error.point->y;
    place.point[2] = error.point->z;
  }
  return place;
}

}  // namespace

tetloft_status remember_exception() noexcept {
  try {
    try {
      throw;
    } catch (const Refusal& refusal) {
      return remember(refusal);
    } catch (...) {
      return remember(error_of_exception());
    }
  } catch (...) {  // the texts of an error take memory, too
    last_error.set("out of memory", "out of memory", {});
    return TETLOFT_OUT_OF_MEMORY;
  }
}

}  // namespace tetloft::internal::c

using namespace tetloft::internal::c;

const char* tetloft_last_error(void) { return last_error.line.c_str(); }

const char* tetloft_last_message(void) { return last_error.message.c_str(); }

tetloft_status tetloft_last_place(tetloft_place* place) {
  // Misuse here is not remembered: it would take the place of what was asked about.
  if (place == nullptr || place->version != TETLOFT_PLACE_VERSION) return TETLOFT_USAGE;
  *place = place_of(last_error);
  return TETLOFT_OK;
}

// Names of the library itself, of statuses and enumerators, and of formats.
#include <tetloft/correspondence.hpp>
#include <tetloft/formats.hpp>
#include <tetloft/model.hpp>
#include <tetloft/version.hpp>

#include "c/handles.hpp"
#include "c/structs.hpp"

namespace tetloft::internal::c {

namespace {

// The name of an enumerator, which count from 0.
template <class Enum>
const char* name_of_number(int value, int count) {
  return value >= 0 && value < count ? tetloft::name_of(static_cast<Enum>(value)) : "unknown";
}

std::uint32_t contents_bits(ContentsSet set) {
  std::uint32_t bits = 0;
  for (int k = 0; k < kContents; ++k) {
    if (set.has(static_cast<Contents>(k))) bits |= std::uint32_t{1} << k;
  }
  return bits;
}
static_assert(TETLOFT_CONTENTS_STACK == 1 << static_cast<int>(Contents::stack) &&
              TETLOFT_CONTENTS_MODEL == 1 << static_cast<int>(Contents::model) &&
              TETLOFT_CONTENTS_SURFACE == 1 << static_cast<int>(Contents::surface) &&
              TETLOFT_CONTENTS_POINTS == 1 << static_cast<int>(Contents::points) &&
              TETLOFT_CONTENTS_LABELS == 1 << static_cast<int>(Contents::labels) &&
              TETLOFT_CONTENTS_LINES == 1 << static_cast<int>(Contents::lines));

}  // namespace

}  // namespace tetloft::internal::c

using namespace tetloft::internal::c;

const char* tetloft_version(void) { return tetloft::version(); }

const char* tetloft_status_name(int status) {
  switch (status) {
    case TETLOFT_OK: return "ok";
    case TETLOFT_BAD_HANDLE: return "bad_handle";
    case TETLOFT_TOO_SMALL: return "too_small";
    case TETLOFT_USAGE:
    case TETLOFT_INVALID_INPUT:
    case TETLOFT_IO:
    case TETLOFT_UNREPRESENTABLE:
    case TETLOFT_CANCELLED:
    case TETLOFT_WORK_LIMIT:
    case TETLOFT_INTERNAL:
    case TETLOFT_OUT_OF_MEMORY:
    case TETLOFT_UNFIT_ARITHMETIC: return tetloft::name_of(static_cast<tetloft::ErrorCode>(status));
    default: return "unknown";
  }
}

const char* tetloft_evidence_name(int evidence) {
  return name_of_number<tetloft::Evidence>(evidence, tetloft::kEvidences);
}

const char* tetloft_fate_name(int fate) {
  return name_of_number<tetloft::LinkFate>(fate, tetloft::kLinkFates);
}

const char* tetloft_tet_kind_name(int kind) {
  return name_of_number<tetloft::TetKind>(kind, tetloft::kTetKinds);
}

const char* tetloft_point_origin_name(int origin) {
  return name_of_number<tetloft::PointOrigin>(origin, tetloft::kPointOrigins);
}

size_t tetloft_format_count(void) { return tetloft::formats().size(); }

tetloft_status tetloft_format_info(size_t index, tetloft_format* format) {
  return answer([&] {
    require_result(format, TETLOFT_FORMAT_VERSION, "format");
    require_index(index, tetloft::formats().size(), "format");
    const tetloft::FormatInfo& info = tetloft::formats()[index];
    // All are literals, which end with a zero byte.
    format->name = info.name.data();
    format->summary = info.summary.data();
    format->extension = info.extensions.front().data();
    format->reads = contents_bits(info.reads);
    format->writes = contents_bits(info.writes);
  });
}

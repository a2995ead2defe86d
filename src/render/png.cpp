// PNG (ISO/IEC 15948).
#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdlib>
#include <string>

#include <tetloft/render.hpp>

#include "core/guard.hpp"
#include "io/bytes/checksum.hpp"
#include "io/bytes/deflate.hpp"
#include "render/encoders.hpp"
#include "render/raster.hpp"

namespace tetloft::internal::render {

namespace {

void append_word(std::string& out, std::uint32_t word) {
  for (int shift = 24; shift >= 0; shift -= 8) out += static_cast<char>(word >> shift & 0xFFU);
}

void append_chunk(std::string& out, const std::string& type, const std::string& data) {
  append_word(out, static_cast<std::uint32_t>(data.size()));
  const std::string body = type + data;
  out += body;
  append_word(out, io::crc32(io::kCrcOfNothing, body));
}

// Each row by the filter of the least sum of magnitudes (section 12.8).
std::string filtered(const Picture& picture, std::size_t channels) {
  const std::size_t stride = channels * picture.width;
  std::string rows;
  rows.reserve((stride + 1) * picture.height);
  std::string row(stride, '\0'), before(stride, '\0'), best, trial(stride, '\0');
  for (std::size_t y = 0; y < picture.height; ++y) {
    for (std::size_t x = 0; x < picture.width; ++x) {
      for (std::size_t c = 0; c < channels; ++c) {
        row[channels * x + c] = static_cast<char>(picture.pixel[y * picture.width + x][c]);
      }
    }
    long least = -1;
    char chosen = 0;
    for (const char filter : {char{0}, char{1}, char{2}, char{4}}) {
      long sum = 0;
      for (std::size_t i = 0; i < stride; ++i) {
        const int a = i < channels ? 0 : static_cast<unsigned char>(row[i - channels]);
        const int b = static_cast<unsigned char>(before[i]);
        const int c = i < channels ? 0 : static_cast<unsigned char>(before[i - channels]);
        const int pa = std::abs(b - c), pb = std::abs(a - c), pc = std::abs(a + b - 2 * c);
        const int paeth = pa <= pb && pa <= pc ? a : pb <= pc ? b : c;
        const int predicted = filter == 0 ? 0 : filter == 1 ? a : filter == 2 ? b : paeth;
        trial[i] = static_cast<char>(static_cast<unsigned char>(row[i]) - predicted);
        sum += std::abs(static_cast<int>(static_cast<signed char>(trial[i])));
      }
      if (least < 0 || sum < least) {
        least = sum;
        chosen = filter;
        best = trial;
      }
    }
    rows += chosen;
    rows += best;
    std::swap(row, before);
  }
  return rows;
}

}  // namespace

std::string png_bytes(const Picture& picture, bool opaque) {
  std::string out("\x89PNG\r\n\x1a\n", 8);
  std::string header;
  append_word(header, static_cast<std::uint32_t>(picture.width));
  append_word(header, static_cast<std::uint32_t>(picture.height));
  header += std::string{'\x08', opaque ? '\x02' : '\x06', '\0', '\0', '\0'};
  append_chunk(out, "IHDR", header);
  append_chunk(out, "sRGB", std::string(1, '\0'));
  append_chunk(out, "IDAT", io::zlib_compressed(filtered(picture, opaque ? 3 : 4)));
  append_chunk(out, "IEND", {});
  return out;
}

}  // namespace tetloft::internal::render

namespace tetloft {

using namespace internal;

Result<std::string> render_png(const Model& model, const SectionStack* contours,
                               const RenderOptions& options) {
  return guard_internal([&]() -> Result<std::string> {
    WatchedWork work(options.execution, render::kDrawSteps + 2);
    work.go_on();
    const auto scene = render::scene_of(model, contours, render::View::toward(options), options);
    if (!scene) return scene.error();
    work.step_done_go_on();
    const render::Picture picture = render::draw(*scene, options, work);
    work.go_on();
    std::string bytes = render::png_bytes(picture, options.white);
    work.step_done();
    return bytes;
  });
}

}  // namespace tetloft

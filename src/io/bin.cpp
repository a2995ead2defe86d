// Points in space as little-endian float64 triples. Nothing but the extension tells them.
#include <cmath>
#include <string>

#include "core/little_endian.hpp"
#include "io/format.hpp"

namespace tetloft::internal::io {

namespace {

constexpr std::size_t kPointBytes = 3 * sizeof(double);

Result<ReadPoints> read_bin(const Source& source, const ReadOptions& /*options*/) {
  const std::string_view bytes = source.bytes;
  if (bytes.size() % kPointBytes != 0) {
    Error error{ErrorCode::invalid_input,
                std::to_string(bytes.size()) + " bytes are no whole number of points (" +
                    std::to_string(kPointBytes) + " bytes each)",
                {}};
    error.where.file = source.name;
    return error;
  }
  std::vector<Point3> points(bytes.size() / kPointBytes);
  for (std::size_t i = 0; i < points.size(); ++i) {
    const char* const at = bytes.data() + i * kPointBytes;
    Point3& p = points[i];
    p = {load_little<double>(at), load_little<double>(at + 8), load_little<double>(at + 16)};
    if (std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z)) continue;
    Error error{ErrorCode::invalid_input, "a coordinate is not finite", {}};
    error.where.file = source.name;
    error.where.vertex = i;
    error.where.point = p;
    return error;
  }
  return ReadPoints{std::move(points), {}};
}

Written write_bin(Sink& sink, const std::vector<Point3>& points, const Target& /*target*/) {
  Pieces pieces(sink);
  for (const Point3& p : points) {
    for (const double c : {p.x, p.y, p.z}) append_little(pieces.text(), c);
    pieces.next();
  }
  pieces.finish();
  return std::vector<Warning>();
}

}  // namespace

extern constinit const Format bin_format{.name = "bin",
                                         .summary = "little-endian float64 triples",
                                         .extensions = {".bin"},
                                         .read_points = read_bin,
                                         .write_points = write_bin};

}  // namespace tetloft::internal::io

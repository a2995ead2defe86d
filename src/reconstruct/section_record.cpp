#include "reconstruct/section_record.hpp"

#include <cstdint>

namespace tetloft::internal {

namespace {

constexpr std::size_t kPoint = 2 * sizeof(double);
// Of vectors of vectors: their counts.
constexpr std::size_t kInnerVector = sizeof(std::uint64_t);

}  // namespace

void put_section(const Section& section, RecordWriter& out) {
  out.put(section.z);
  out.put_count(section.contours.size());
  for (const Contour& contour : section.contours) {
    out.put_count(contour.vertices.size());
    for (const Point2& p : contour.vertices) {
      out.put(p.x);
      out.put(p.y);
    }
  }
}

Section get_section(RecordReader& in) {
  Section section;
  section.z = in.get<double>();
  section.contours.resize(in.get_count(kInnerVector));
  for (Contour& contour : section.contours) {
    contour.vertices.resize(in.get_count(kPoint));
    for (Point2& p : contour.vertices) {
      p.x = in.get<double>();
      p.y = in.get<double>();
    }
  }
  return section;
}

}  // namespace tetloft::internal

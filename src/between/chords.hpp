// A contour and the chords that stand for it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include <tetloft/section_stack.hpp>

namespace tetloft::internal::between {

class ContourChords {
 public:
  /// Chords from which no vertex between is farther than the tolerance, and which are no longer
  /// than `longest`, unless edges are. Contours of up to four vertices stay.
  ContourChords(const Contour& contour, double tolerance, double longest);

  /// Vertex v is the start of chord v.
  [[nodiscard]] const Contour& contour() const { return simplified_; }

  /// Divides a chord at the vertex farthest from it, and puts its ends to where they were. False if
  /// it was an edge of the contour as it was. contour() shows it after settle() only.
  bool divide(std::size_t chord);
  /// Gives back all vertices, at once. False if all were there.
  bool restore();
  void settle();

 private:
  [[nodiscard]] std::size_t next(std::size_t kept) const;
  /// The vertex farthest from the chord of the vertices `first` and `last`, strictly between them;
  /// `first` where there is none.
  [[nodiscard]] std::size_t farthest(std::size_t first, std::size_t last, double& squared) const;
  void divide_all(double tolerance, double longest);
  [[nodiscard]] double area_beyond(std::size_t first, std::size_t last) const;

  std::vector<Point2> vertices_;
  double tolerance_;
  std::vector<std::uint8_t> kept_, fixed_;  // by vertex
  std::vector<std::size_t> start_;          // of chord v: a vertex
  Contour simplified_;
  bool changed_ = false;
};

}  // namespace tetloft::internal::between

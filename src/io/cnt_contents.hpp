// What a .cnt holds as written, and judgements on it: what its numbers are, and whether a
// contour seems to be an open line.
#pragma once

#include <cstddef>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include <tetloft/io.hpp>
#include <tetloft/repair.hpp>
#include <tetloft/result.hpp>
#include <tetloft/section_stack.hpp>

namespace tetloft::internal::io {

/// All of a file, or some sections of it. Numbers taken in pairs. What remains of an odd number of
/// them is a last vertex of which y is NaN, until settle_vertices().
struct CntContents {
  std::size_t first = 0;  ///< the number of the first section in the file
  SectionStack stack;
  IdVector<SectionId, IdVector<ContourId, std::size_t>> lines;  ///< of the opening braces
  IdVector<SectionId, std::size_t> header_lines;                ///< of each "v"
  IdVector<SectionId, double> announced;                        ///< numbers of vertices
  /// Where the first odd contour begins and ends.
  struct Odd {
    std::size_t opened = 0;
    std::size_t closed = 0;
  };
  std::optional<Odd> odd;
  bool commas = false;  ///< there is one between two numbers
};

/// What the numbers of a file may be, as counts and heights tell: of all its sections, added part
/// by part.
class CntReading {
 public:
  void add(const CntContents& part);

  /// Every contour has a multiple of three numbers, and one has some.
  [[nodiscard]] bool in_threes() const { return in_threes_ && numbers_ > 0; }
  [[nodiscard]] bool counts_are_threes() const { return counts_are_threes_ && numbers_ > 0; }
  /// Pairs without question: settle_vertices() leaves them as they are, and says nothing.
  [[nodiscard]] bool plain_pairs() const;
  /// Twice the announced numbers, with commas.
  [[nodiscard]] bool decimal_commas() const { return commas_ && counts_are_fours_ && numbers_ > 0; }
  /// There is a contour with an odd number of numbers.
  [[nodiscard]] bool odd() const { return odd_; }

  /// The third number of a vertex, where it is not the section's height.
  struct OffPlane {
    std::size_t section = 0;
    std::size_t contour = 0;
    std::size_t vertex = 0;
    double value = 0;
  };
  /// The first.
  [[nodiscard]] const std::optional<OffPlane>& off_plane() const { return off_plane_; }

 private:
  bool odd_ = false;
  bool commas_ = false;
  bool in_threes_ = true;
  bool counts_are_twos_ = true;    // the announced counts are those of pairs
  bool counts_are_threes_ = true;  // … of triples
  bool counts_are_fours_ = true;   // … of two pairs of digits around a decimal comma each
  std::size_t numbers_ = 0;
  std::optional<OffPlane> off_plane_;
};

/// Makes vertices of the numbers: pairs; or the first two of every three, where three make a
/// vertex, with a warning. Never are pairs that make a valid stack of the announced counts taken
/// for anything else. Error invalid_input for odd contours, for three numbers of which the third
/// is not the height of the section, and for decimal commas; `where` lacks the file.
[[nodiscard]] Result<std::optional<Warning>> settle_vertices(CntContents& contents);

/// How many times longer the edge that closes a contour is than its longest other one; nothing
/// where it is not conspicuous.
[[nodiscard]] std::optional<double> conspicuous_closing(const Contour& contour);

/// The box of all contours that were added.
class FrameOfAll {
 public:
  void add(const Section& section);
  /// The sides that hold a point, a bit each.
  [[nodiscard]] unsigned sides(const Point2& p) const {
    return (p.x == low_.x ? 1U : 0U) | (p.x == high_.x ? 2U : 0U) | (p.y == low_.y ? 4U : 0U) |
           (p.y == high_.y ? 8U : 0U);
  }

 private:
  static constexpr double kInfinity = std::numeric_limits<double>::infinity();
  Point2 low_{kInfinity, kInfinity};
  Point2 high_{-kInfinity, -kInfinity};
};

/// Contours of a file, added part by part, that are closed conspicuously, from one side of the box
/// of all contours to another: lines cut off at a frame.
class OpenLines {
 public:
  void add(const CntContents& part);
  /// Once all were added. At most `most`.
  [[nodiscard]] std::vector<Warning> warnings(std::size_t most) const;

 private:
  struct Line {
    std::size_t section, contour, line;
    Point2 front, back;
    double times;
  };
  [[nodiscard]] bool crosses_frame(const Point2& front, const Point2& back) const;

  FrameOfAll frame_;
  std::vector<Line> lines_;  // that ended at the frame when they were added
  std::size_t kept_ = 0;     // of them, when those were left out that do so no longer
};

/// The contours that are lines, taken for such on request: the first and the last vertex lie on the
/// box of all contours, on different sides; or on one, and the edge between them is conspicuous.
[[nodiscard]] std::vector<ContourOfSection> lines_to_the_frame(const SectionStack& stack);

}  // namespace tetloft::internal::io

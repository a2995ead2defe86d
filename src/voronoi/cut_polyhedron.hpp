// A convex polyhedron, a box first, that is cut by planes.
//
// It is simple all the time: three edges at each corner, a graph that is planar and 3-connected.
// Where a corner lies is a double, and on which side of a plane it lies is decided by it; but what
// is cut off is made connected, and so is what stays. Between two connected parts of such a graph
// there is one cycle of faces, each cut once, whatever rounding said of single corners (Sugihara
// and Iri, "Construction of the Voronoi diagram for one million generators in single-precision
// arithmetic", Proc. IEEE 80, 1992). To contract what is cut off to a point leaves the graph
// 3-edge-connected, and so does the cycle that takes the point's place: a set of its edges that
// separates something has two of the cycle and one more, as what stays is connected, or three of
// the old graph. A cubic graph that is 3-edge-connected is 3-connected.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include <tetloft/point.hpp>

namespace tetloft::internal::voronoi {

/// normal · x <= offset; the normal has length 1.
struct HalfSpace {
  Point3 normal;
  double offset = 0;
};

/// All that is at least as near to the origin as to p, which is not the origin.
[[nodiscard]] HalfSpace nearer_to_origin(const Point3& p);
/// All that is at least as near to a as to b, where b − a is `difference`, in any unit; not zero,
/// though those of a and b as they are given, relative to something far away, may be.
[[nodiscard]] HalfSpace nearer_to_first(const Point3& a, const Point3& b, const Point3& difference);

/// A face as corners, counter-clockwise as seen from outside, and its measure.
struct CutFace {
  std::vector<std::uint32_t> corners;
  double area = 0;
};

class CutPolyhedron {
 public:
  /// Faces 0 to 5 of all: low x, high x, low y, … of the box.
  static constexpr std::uint32_t kBoxFaces = 6;

  CutPolyhedron(const Point3& low, const Point3& high) { start_again(low, high); }
  [[nodiscard]] static CutPolyhedron around_origin(double half) {
    return {{-half, -half, -half}, {half, half, half}};
  }
  /// Is the whole box again, and keeps the memory.
  void start_again(const Point3& low, const Point3& high);

  /// Keeps what is in the half-space; the face on its plane has the next number, whether anything
  /// of it is there or not.
  void cut(const HalfSpace& half_space);

  [[nodiscard]] bool empty() const { return corner_count_ == 0; }
  /// Where the corners are, in the order that faces() counts them.
  [[nodiscard]] std::vector<Point3> corners() const;
  /// By number; without corners where nothing of it is left.
  [[nodiscard]] std::vector<CutFace> faces() const;
  [[nodiscard]] double volume() const;
  /// Is anything left of the box's sides?
  [[nodiscard]] bool reaches_box() const;

 private:
  struct Corner {
    Point3 point;
    /// A measure of the numbers that it was computed from: its error is a few units of their last
    /// place. Chooses among two ways to compute points.
    double spread = 0;
    std::array<std::uint32_t, 3> next{};  // counter-clockwise as seen from outside
    std::array<std::uint32_t, 3> face{};  // to the left of the edge to next[i]
  };
  enum class Part : std::uint8_t { unknown, kept, cut_off, gone };
  // The edge from a corner that is kept to one that is not.
  struct Crossing {
    std::uint32_t corner = 0;
    std::uint32_t edge = 0;
  };

  [[nodiscard]] std::uint32_t edge_to(std::uint32_t from, std::uint32_t to) const;
  // True where some corners are cut off, and some are kept.
  [[nodiscard]] bool divide(const HalfSpace& half_space);
  void flood(std::uint32_t start, Part part, bool outside);
  [[nodiscard]] Crossing first_crossing() const;
  [[nodiscard]] Crossing next_crossing(Crossing at) const;
  [[nodiscard]] Corner crossing_point(Crossing at, std::uint32_t right_face) const;
  void join(const std::vector<Crossing>& cycle);
  void remove_cut_off();
  // Calls visit(face, its corners) for each face that is left.
  template <class Visit>
  void for_each_face(const Visit& visit) const;

  std::vector<Corner> corners_;
  std::vector<Part> part_;         // of corners_; gone: a free place
  std::vector<double> height_;     // over the plane of the cut
  std::vector<HalfSpace> planes_;  // by face
  std::vector<std::uint32_t> free_;
  std::vector<std::uint32_t> stack_;
  std::size_t corner_count_ = 0;
};

}  // namespace tetloft::internal::voronoi

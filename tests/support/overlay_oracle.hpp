// The faces of two sections laid over each other, by cutting the plane into trapezoids at every
// vertex and crossing, in rationals. Quadratic and slow; shares no code with the product.
#pragma once

#include <array>
#include <compare>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include <tetloft/nesting.hpp>
#include <tetloft/section_stack.hpp>

#include "support/rational_geometry.hpp"

namespace tetloft::oracle {

class CellOverlay {
 public:
  struct Side {
    bool solid = false;
    std::uint32_t id = 0;  ///< of the region, or the void: 0 outside, then holes by lowest vertex
    friend auto operator<=>(const Side&, const Side&) = default;
  };
  struct Border {
    std::size_t section = 0;
    std::uint32_t region = 0;
    friend auto operator<=>(const Border&, const Border&) = default;
  };
  struct Face {
    std::array<Side, 2> side;
    std::int32_t chi = 0;
    std::vector<Border> border;  ///< sorted, each once
    friend auto operator<=>(const Face&, const Face&) = default;
  };

  CellOverlay(const Section& lower, const Nesting& lower_nesting, const Section& upper,
              const Nesting& upper_nesting);

  [[nodiscard]] const std::vector<Face>& faces() const { return faces_; }
  /// The face that contains p; none on a contour.
  [[nodiscard]] std::optional<std::size_t> locate(const Point2& p) const;

 private:
  struct Edge {
    Point2Q low, high;  // by (x, y)
    std::size_t section = 0, contour = 0;
  };
  // What lies between two lines of edges, or beyond the outermost, over one range of x.
  struct Cell {
    std::vector<const Edge*> bottom, top;  // several where edges coincide; none: without bound
    std::size_t face = 0;
  };

  void collect(const Section& section, std::size_t s);
  void cut();
  void fill(std::size_t slab);
  void join(std::size_t slab);
  void describe(const std::array<const Nesting*, 2>& nestings);
  [[nodiscard]] Side side_of(std::size_t slab, const Cell& cell, std::size_t s,
                             const Nesting& nesting) const;
  [[nodiscard]] std::size_t root(std::size_t cell) const;

  std::array<const Section*, 2> sections_{};
  std::vector<Edge> edges_, vertical_;
  std::vector<Rational> xs_;              // slab i: from xs_[i − 1] to xs_[i]
  std::vector<std::vector<Cell>> slabs_;  // bottom up
  std::vector<std::size_t> first_cell_;   // of a slab, in parent_
  std::vector<std::size_t> parent_;       // union–find over cells
  // What openings and closed stretches between neighbouring slabs tell.
  std::vector<std::size_t> openings_;  // a cell at each
  struct Touch {
    std::size_t cell;
    const Edge* edge;
  };
  std::vector<Touch> touches_;  // cells along vertical edges
  std::vector<Face> faces_;
};

}  // namespace tetloft::oracle

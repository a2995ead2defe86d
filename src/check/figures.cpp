// Figures beside the guarantees, in plain doubles.
#include "check/figures.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include "check/box_tree.hpp"
#include "check/dihedral.hpp"
#include "core/unit_of_length.hpp"
#include "sections/scaling.hpp"

namespace tetloft::internal::checking {

namespace {

constexpr double kFarthest = std::numeric_limits<double>::infinity();

double distance_to_segment(const Point2& p, const Point2& a, const Point2& b) {
  const double dx = b.x - a.x;
  const double dy = b.y - a.y;
  const double length2 = dx * dx + dy * dy;
  const double along = length2 > 0 ? ((p.x - a.x) * dx + (p.y - a.y) * dy) / length2 : 0;
  const double t = std::clamp(along, 0.0, 1.0);
  return std::hypot(p.x - (a.x + t * dx), p.y - (a.y + t * dy));
}

// A section's region, for distances.
class RegionDistance {
 public:
  explicit RegionDistance(const Section& section) {
    std::vector<Box2> boxes;
    for (const Contour& contour : section.contours) {
      for (std::size_t i = 0; i < contour.vertices.size(); ++i) {
        const Point2& a = contour.vertices[i];
        const Point2& b = contour.vertices[(i + 1) % contour.vertices.size()];
        edges_.push_back({a, b});
        Box2 box{a, a};
        box.include({b, b});
        boxes.push_back(box);
      }
    }
    tree_ = BoxTree(std::move(boxes));
  }

  [[nodiscard]] bool empty() const { return edges_.empty(); }

  /// The distance of p, 0 inside; any value up to `enough` stands for all of them.
  [[nodiscard]] double operator()(const Point2& p, double enough) const {
    if (contains(p)) return 0;
    return tree_.nearest(p, enough, kFarthest, [&](std::uint32_t e) {
      return distance_to_segment(p, edges_[e][0], edges_[e][1]);
    });
  }

 private:
  // Even-odd rule along the ray to +x.
  [[nodiscard]] bool contains(const Point2& p) const {
    bool inside = false;
    tree_.meeting({p, {kFarthest, p.y}}, [&](std::uint32_t e) {
      const auto& [a, b] = edges_[e];
      if ((a.y > p.y) != (b.y > p.y)) {
        const double x = a.x + (p.y - a.y) / (b.y - a.y) * (b.x - a.x);
        if (x > p.x) inside = !inside;
      }
      return true;
    });
    return inside;
  }

  std::vector<std::array<Point2, 2>> edges_;
  BoxTree tree_;
};

}  // namespace

double overshoot(const ModelView& view, const SectionStack& stack, const SectionRange& sections) {
  SectionStack part;
  for (std::size_t s = sections.first; s < sections.end; ++s) {
    part.sections.push_back(stack.sections[SectionId(s)]);
  }
  UnitOfLength unit = sections::unit_of(part);
  for (std::size_t v = 0; v < view.points.size(); ++v) {
    if (view.used[v] != 0) unit.include(view.points[v]);
  }
  const int exponent = unit.largest_to_one();
  const SectionStack in_unit = sections::scaled(part, exponent);
  std::vector<RegionDistance> region;
  for (const Section& section : in_unit.sections) region.emplace_back(section);
  const auto z = [&](std::size_t s) { return in_unit.sections[SectionId(s - sections.first)].z; };
  const std::size_t n = stack.sections.size();

  double largest = 0;
  for (std::size_t v = 0; v < view.points.size(); ++v) {
    const Level level = view.level[v];
    if (view.used[v] == 0 || on_plane(level)) continue;
    // Between sections above − 1 and above, or beyond one end.
    const auto above = static_cast<std::size_t>((level + 1) / 2);
    const std::size_t low = above == 0 ? 0 : above - 1;
    const std::size_t high = above == n ? n - 1 : above;
    double gap = z(high) - z(low);
    if (low == high && n > 1) gap = low == 0 ? z(1) - z(0) : z(n - 1) - z(n - 2);
    const Point3 p = scaled(view.points[v], exponent);
    if (n == 1) gap = 2 * std::fabs(p.z - z(0));

    double distance = kFarthest;
    for (const std::size_t s : {low, high}) {
      const RegionDistance& of = region[s - sections.first];
      if (of.empty() || distance <= largest * gap) continue;
      distance = std::min(distance, of({p.x, p.y}, largest * gap));
    }
    if (distance < kFarthest) largest = std::max(largest, distance / gap);
  }
  return largest;
}

double smallest_dihedral_degrees(const ModelView& view) {
  UnitOfLength unit;
  for (const TetVertices& tet : view.tets) {
    for (const VertexId v : tet) unit.include(view.points[v.index()]);
  }
  const int exponent = unit.largest_to_one();
  double smallest = kFarthest;
  for (const TetVertices& tet : view.tets) {
    std::array<Point3, 4> corner;
    for (std::size_t i = 0; i < 4; ++i) corner[i] = scaled(view.points[tet[i].index()], exponent);
    for (const double angle : dihedral_degrees(corner)) smallest = std::min(smallest, angle);
  }
  return view.tets.empty() ? 180 : smallest;
}

void ViewFigures::add(const OnContours& on) {
  largest_split_ulps = std::max(largest_split_ulps, on.largest_split_ulps);
  inner_vertices += on.off_contours;
}

void ViewFigures::add(const ViewFigures& more) {
  volume += more.volume;
  overshoot = std::max(overshoot, more.overshoot);
  smallest_dihedral_degrees = std::min(smallest_dihedral_degrees, more.smallest_dihedral_degrees);
  largest_split_ulps = std::max(largest_split_ulps, more.largest_split_ulps);
  inner_vertices += more.inner_vertices;
}

void ViewFigures::tell(CheckReport& report) const {
  report.volume = volume;
  report.overshoot = overshoot;
  report.smallest_dihedral_degrees = smallest_dihedral_degrees;
  report.largest_split_ulps = largest_split_ulps;
  report.inner_vertices = inner_vertices;
}

ViewFigures measure(const Model& model, const ModelView& view, const SectionStack& stack,
                    const SectionRange& sections) {
  Model sound;
  sound.points = model.points;
  sound.tets = IdVector<TetId, TetVertices>(view.tets);
  sound.frame = model.frame;
  ViewFigures figures;
  figures.volume = volume(sound);
  figures.overshoot = overshoot(view, stack, sections);
  figures.smallest_dihedral_degrees = smallest_dihedral_degrees(view);
  return figures;
}

}  // namespace tetloft::internal::checking

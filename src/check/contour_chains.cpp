// The boundary of the in-plane triangles, as oriented edges with the region on the left,
// must be the oriented contours, each edge replaced by a chain of inserted vertices.
#include "check/contour_chains.hpp"

#include <algorithm>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include <tetloft/nesting.hpp>

#include "check/edge_distance.hpp"

namespace tetloft::internal::checking {

namespace {

// The model's vertices of one plane by (x, y).
class PlaneVertices {
 public:
  PlaneVertices(const ModelView& view, const SectionRange& sections)
      : view_(view), first_(sections.first), sorted_(sections.end - sections.first) {
    for (std::size_t v = 0; v < view.points.size(); ++v) {
      if (sections.holds_plane(view.level[v])) {
        sorted_[static_cast<std::size_t>(view.level[v] / 2) - first_].push_back(VertexId(v));
      }
    }
    for (auto& vertices : sorted_) {
      std::sort(vertices.begin(), vertices.end(), [&](VertexId a, VertexId b) {
        if (less(a, view_.xy(b))) return true;
        return !less(b, view_.xy(a)) && a < b;
      });
    }
  }

  [[nodiscard]] const std::vector<VertexId>& of(std::size_t plane) const {
    return sorted_[plane - first_];
  }

  /// The first vertex at a point, preferring one that tets use; invalid if there is none.
  [[nodiscard]] VertexId at(std::size_t plane, const Point2& p) const {
    const auto& vertices = of(plane);
    const auto begin = std::lower_bound(vertices.begin(), vertices.end(), p,
                                        [&](VertexId v, const Point2& q) { return less(v, q); });
    VertexId found;
    for (auto i = begin; i != vertices.end() && view_.xy(*i) == p; ++i) {
      if (view_.used[i->index()] != 0) return *i;
      if (!found.valid()) found = *i;
    }
    return found;
  }

 private:
  [[nodiscard]] bool less(VertexId v, const Point2& p) const {
    return canonical_less(view_.xy(v), p);
  }
  const ModelView& view_;
  std::size_t first_;
  std::vector<std::vector<VertexId>> sorted_;
};

class ContourFollower {
 public:
  ContourFollower(const ModelView& view, const SectionStack& stack, const ContourNumbers& numbers,
                  const SectionRange& sections, const InPlaneComplex& complex,
                  const CheckOptions& options, Findings& findings)
      : view_(view),
        stack_(stack),
        numbers_(numbers),
        sections_(sections),
        options_(options),
        findings_(findings),
        vertices_(view, sections),
        next_(view.points.size()),
        passed_(view.points.size(), 0),
        is_input_(view.points.size(), 0),
        is_corner_(view.points.size(), 0) {
    for (const InPlaneComplex::Edge& edge : complex.edges) {
      is_corner_[edge.low.index()] = is_corner_[edge.high.index()] = 1;
    }
    link_boundary(complex);
  }

  OnContours run() {
    report_coincident();
    result_.contour.assign(view_.points.size(), OnContours::kNone);
    result_.chain.resize(local(sections_.end, 0));
    input_.resize(result_.chain.size());
    for (std::size_t s = sections_.first; s < sections_.end; ++s) find_input_vertices(s);
    for (std::size_t s = sections_.first; s < sections_.end; ++s) follow_section(s);
    report_leftovers();
    return std::move(result_);
  }

 private:
  // Its number among those that are followed.
  [[nodiscard]] std::size_t local(std::size_t s, std::size_t c) const {
    return numbers_.of(s, c) - numbers_.of(sections_.first, 0);
  }

  // Each boundary edge starts where exactly one does: else the boundary is branched.
  void link_boundary(const InPlaneComplex& complex) {
    for (const InPlaneComplex::Edge& edge : complex.edges) {
      if (edge.left + edge.right != 1) continue;
      const VertexId from = edge.left == 1 ? edge.low : edge.high;
      const VertexId to = edge.left == 1 ? edge.high : edge.low;
      if (next_[from.index()].valid()) {
        report_stray(from, to);
      } else {
        next_[from.index()] = to;
      }
    }
  }

  void report_stray(VertexId from, VertexId to) {
    findings_.fail(9, "an in-plane triangle ends at an edge that is on no contour",
                   [&] { return edge_text(view_, from, to) + ", " + vertex_text(view_, from); });
  }

  void report_coincident() {
    for (std::size_t plane = sections_.first; plane < sections_.end; ++plane) {
      const auto& vertices = vertices_.of(plane);
      for (std::size_t i = 1; i < vertices.size(); ++i) {
        if (view_.xy(vertices[i]) != view_.xy(vertices[i - 1])) continue;
        findings_.fail(2, "two vertices in a section plane coincide",
                       [&] { return vertex_text(view_, vertices[i]); });
      }
    }
  }

  void find_input_vertices(std::size_t s) {
    const Section& section = stack_.sections[SectionId(s)];
    for (std::size_t c = 0; c < section.contours.size(); ++c) {
      const Contour& contour = section.contours[ContourId(c)];
      std::vector<VertexId>& found = input_[local(s, c)];
      for (std::size_t i = 0; i < contour.vertices.size(); ++i) {
        const VertexId v = vertices_.at(s, contour.vertices[i]);
        found.push_back(v);
        if (!v.valid()) {
          findings_.fail(3, "an input vertex is missing", [&] { return input_text(s, c, i); });
          continue;
        }
        is_input_[v.index()] = 1;
        result_.contour[v.index()] = numbers_.of(s, c);
      }
    }
  }

  void follow_section(std::size_t s) {
    const Section& section = stack_.sections[SectionId(s)];
    const Nesting nesting = nest(section);
    for (std::size_t c = 0; c < section.contours.size(); ++c) {
      const Contour& contour = section.contours[ContourId(c)];
      const bool counter_clockwise = area_sign(contour) == Sign::positive;
      const bool hole = nesting.depth[ContourId(c)] % 2 == 1;
      follow_contour(s, c, counter_clockwise == hole);
    }
  }

  // `reversed`: the region lies to the right of the contour as given.
  void follow_contour(std::size_t s, std::size_t c, bool reversed) {
    const std::vector<Point2>& points =
        stack_.sections[SectionId(s)].contours[ContourId(c)].vertices;
    const std::size_t n = points.size();
    std::vector<VertexId> chain;
    bool complete = true;
    for (std::size_t k = 0; k < n; ++k) {
      const std::size_t from = reversed ? (n - k) % n : k;
      const std::size_t to = reversed ? n - k - 1 : (k + 1) % n;
      const VertexId begin = input_[local(s, c)][from];
      const VertexId end = input_[local(s, c)][to];
      if (!begin.valid() || !end.valid()) {
        complete = false;
        continue;
      }
      chain.push_back(begin);
      const std::size_t first = chain.size();
      VertexId v = begin;
      // Marks keep a boundary that turns in a loop from being followed for ever.
      while (passed_[v.index()] == 0) {
        passed_[v.index()] = 1;
        v = next_[v.index()];
        if (!v.valid() || is_input_[v.index()] != 0) break;
        chain.push_back(v);
      }
      if (v != end) {
        complete = false;
        findings_.fail(8, "the in-plane triangles do not follow a contour edge",
                       [&] { return input_text(s, c, reversed ? to : from); });
        continue;
      }
      check_inserted(s, c, points[from], points[to],
                     {chain.begin() + static_cast<std::ptrdiff_t>(first), chain.end()});
    }
    if (complete) result_.chain[local(s, c)] = std::move(chain);
  }

  void check_inserted(std::size_t s, std::size_t c, const Point2& a, const Point2& b,
                      const std::vector<VertexId>& inserted) {
    Point2 previous = a;
    for (const VertexId v : inserted) {
      const Point2 p = view_.xy(v);
      result_.contour[v.index()] = numbers_.of(s, c);
      const EdgeDistance distance = distance_from_edge(a, b, p, options_.split_ulps);
      result_.largest_split_ulps = std::max(result_.largest_split_ulps, distance.ulps);
      if (!distance.within) {
        findings_.fail(11, "an inserted vertex lies too far off its contour edge", [&] {
          return contour_text(s, c) + ": " + vertex_text(view_, v) + ", " +
                 std::to_string(distance.ulps) + " ulps";
        });
      }
      if (!advances(a, b, previous, p)) report_fold(s, c, v);
      previous = p;
    }
    if (!inserted.empty() && !advances(a, b, previous, b)) report_fold(s, c, inserted.back());
  }

  void report_fold(std::size_t s, std::size_t c, VertexId v) {
    findings_.fail(12, "inserted vertices do not advance along their contour edge",
                   [&] { return contour_text(s, c) + ": " + vertex_text(view_, v); });
  }

  void report_leftovers() {
    for (std::size_t v = 0; v < view_.points.size(); ++v) {
      if (next_[v].valid() && passed_[v] == 0) report_stray(VertexId(v), next_[v]);
      if (!sections_.holds_plane(view_.level[v]) || result_.contour[v] != OnContours::kNone)
        continue;
      if (is_corner_[v] != 0) {
        ++result_.off_contours;
      } else {
        findings_.fail(10, "a vertex in a section plane is a corner of no in-plane face",
                       [&] { return vertex_text(view_, VertexId(v)); });
      }
    }
  }

  [[nodiscard]] std::string input_text(std::size_t s, std::size_t c, std::size_t i) const {
    const Section& section = stack_.sections[SectionId(s)];
    const Point2& p = section.contours[ContourId(c)].vertices[i];
    Place place;
    place.section = s;
    place.contour = c;
    place.vertex = i;
    place.point = Point3{p.x, p.y, section.z};
    return to_string(place);
  }

  const ModelView& view_;
  const SectionStack& stack_;
  const ContourNumbers& numbers_;
  SectionRange sections_;
  const CheckOptions& options_;
  Findings& findings_;
  PlaneVertices vertices_;
  // next_[v]: where the boundary edge that starts at v ends; invalid if none does.
  std::vector<VertexId> next_;
  // passed_[v]: some chain has gone on from v.
  std::vector<std::uint8_t> passed_;
  std::vector<std::uint8_t> is_input_;
  std::vector<std::uint8_t> is_corner_;  // of an in-plane face that is not flat
  // input_[c][i]: the model vertex of vertex i of contour c, a local number; or invalid.
  std::vector<std::vector<VertexId>> input_;
  OnContours result_;
};

}  // namespace

OnContours follow_contours(const ModelView& view, const SectionStack& stack,
                           const ContourNumbers& numbers, const SectionRange& sections,
                           const InPlaneComplex& complex, const CheckOptions& options,
                           Findings& findings) {
  return ContourFollower(view, stack, numbers, sections, complex, options, findings).run();
}

}  // namespace tetloft::internal::checking

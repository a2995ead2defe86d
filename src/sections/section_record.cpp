#include "sections/section_record.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include <tetloft/predicates.hpp>

#include "core/guard.hpp"
#include "core/record.hpp"
#include "sections/conforming_section.hpp"

namespace tetloft::internal::sections {

namespace {

constexpr RecordKind kKind{"sect", 1, "a conforming section"};

void put_nesting(const Nesting& nesting, RecordWriter& out) {
  out.put_all(nesting.parent);
  out.put_all(nesting.depth);
  out.put_all(nesting.region);
  out.put_all(nesting.outer);
}

template <class IdType, class T>
IdVector<IdType, T> get_vector(RecordReader& in) {
  return IdVector<IdType, T>(in.get_all<T>());
}

// Indices of vertices in their contour, or kNotInput.
using Indices = IdVector<PlaneVertexId, std::size_t>;

void put_indices(const Indices& indices, RecordWriter& out) {
  out.put_count(indices.size());
  for (const std::size_t i : indices) {
    out.put(i == ConformingSection::kNotInput ? ~std::uint64_t{0} : std::uint64_t{i});
  }
}

Indices get_indices(RecordReader& in) {
  Indices indices;
  for (const std::uint64_t i : in.get_all<std::uint64_t>()) {
    indices.push_back(i == ~std::uint64_t{0} ? ConformingSection::kNotInput
                                             : static_cast<std::size_t>(i));
  }
  return indices;
}

Nesting get_nesting(RecordReader& in) {
  Nesting nesting;
  nesting.parent = get_vector<ContourId, ContourId>(in);
  nesting.depth = get_vector<ContourId, std::uint32_t>(in);
  nesting.region = get_vector<ContourId, RegionId>(in);
  nesting.outer = get_vector<RegionId, ContourId>(in);
  const std::size_t contours = nesting.region.size();
  in.require(nesting.parent.size() == contours && nesting.depth.size() == contours,
             "nests some of its contours");
  if (in.refused()) return nesting;
  for (const ContourId c : nesting.region.ids()) {
    in.require(nesting.region[c].index() < nesting.outer.size(), "names a region it lacks");
    in.require(!nesting.parent[c].valid() || nesting.parent[c].index() < contours,
               "names a contour it lacks");
  }
  for (const ContourId c : nesting.outer) {
    in.require(c.index() < contours, "names a contour it lacks");
  }
  return nesting;
}

Triangulation2 get_triangulation(RecordReader& in) {
  Triangulation2 result;
  result.points.resize(in.get_count(2 * sizeof(double)));
  for (Point2& p : result.points) {
    p.x = in.get<double>();
    p.y = in.get<double>();
    in.require(std::isfinite(p.x) && std::isfinite(p.y), "has a vertex that is not finite");
  }
  const auto& points = result.points.raw();
  in.require(std::adjacent_find(points.begin(), points.end(),
                                [](const Point2& p, const Point2& q) {
                                  return !canonical_less(p, q);
                                }) == points.end(),
             "has vertices out of order");
  result.triangles.resize(in.get_count(3 * sizeof(std::uint32_t)));
  std::vector<std::array<PlaneVertexId, 2>> sides;
  for (PlaneTriangleVertices& t : result.triangles) {
    for (PlaneVertexId& v : t) {
      v = in.get<PlaneVertexId>();
      in.require(v.index() < points.size(), "names a vertex it lacks");
    }
    if (in.refused()) return result;
    in.require(
        orient2d(result.points[t[0]], result.points[t[1]], result.points[t[2]]) == Sign::positive &&
            t[0] < t[1] && t[0] < t[2],
        "has a triangle that is none");
    for (std::size_t i = 0; i < 3; ++i) sides.push_back({t[i], t[(i + 1) % 3]});
  }
  in.require(std::is_sorted(result.triangles.begin(), result.triangles.end()),
             "has triangles out of order");
  // With this, an edge has one triangle on each side at most.
  std::sort(sides.begin(), sides.end());
  in.require(std::adjacent_find(sides.begin(), sides.end()) == sides.end(),
             "has triangles that overlap");
  return result;
}

// What is told by vertex, and of triangles.
void get_labels(RecordReader& in, ConformingSection& section) {
  section.internal = get_vector<TriangleId, std::uint8_t>(in);
  section.contour = get_vector<PlaneVertexId, ContourId>(in);
  section.region = get_vector<PlaneVertexId, RegionId>(in);
  section.next = get_vector<PlaneVertexId, PlaneVertexId>(in);
  section.previous = get_vector<PlaneVertexId, PlaneVertexId>(in);
  section.input_vertex = get_indices(in);
  section.edge_of = get_indices(in);
  section.gabriel.raw().resize(in.get_count(1));
  for (const ContourId c : section.gabriel.ids()) section.gabriel[c] = in.get<std::uint8_t>() != 0;
  const std::size_t n = section.triangulation.points.size();
  in.require(section.internal.size() == section.triangulation.triangles.size() &&
                 section.contour.size() == n && section.region.size() == n &&
                 section.next.size() == n && section.previous.size() == n &&
                 section.input_vertex.size() == n && section.edge_of.size() == n,
             "labels some of its vertices");
  const Nesting& nesting = section.nesting;
  in.require(section.gabriel.empty() || section.gabriel.size() == nesting.region.size(),
             "refines some of its contours");
  if (in.refused()) return;
  for (const PlaneVertexId v : section.contour.ids()) {
    const ContourId contour = section.contour[v];
    in.require(section.region[v].index() < nesting.outer.size(), "names a region it lacks");
    in.require(!contour.valid() || contour.index() < nesting.region.size(),
               "names a contour it lacks");
    const PlaneVertexId next = section.next[v];
    const PlaneVertexId previous = section.previous[v];
    in.require(contour.valid() == next.valid() && contour.valid() == previous.valid() &&
                   (!next.valid() || (next.index() < n && previous.index() < n)),
               "has a contour that does not close");
  }
  if (in.refused()) return;
  for (const PlaneVertexId v : section.next.ids()) {
    const PlaneVertexId next = section.next[v];
    in.require(!next.valid() || section.previous[next] == v, "has a contour that does not close");
  }
}

}  // namespace

std::string to_record(const ConformingSection& section) {
  RecordWriter out(kKind);
  out.put(section.z);
  put_nesting(section.nesting, out);
  out.put_count(section.triangulation.points.size());
  for (const Point2& p : section.triangulation.points) {
    out.put(p.x);
    out.put(p.y);
  }
  out.put_count(section.triangulation.triangles.size());
  for (const PlaneTriangleVertices& t : section.triangulation.triangles) {
    for (const PlaneVertexId v : t) out.put(v);
  }
  out.put_all(section.internal);
  out.put_all(section.contour);
  out.put_all(section.region);
  out.put_all(section.next);
  out.put_all(section.previous);
  put_indices(section.input_vertex, out);
  put_indices(section.edge_of, out);
  out.put_count(section.gabriel.size());
  for (const ContourId c : section.gabriel.ids()) {
    out.put(static_cast<std::uint8_t>(section.gabriel[c] ? 1 : 0));
  }
  return out.take();
}

Result<ConformingSection> section_from_record(std::string_view bytes, const std::string& name) {
  return guard_internal([&]() -> Result<ConformingSection> {
    RecordReader in(bytes, kKind, name);
    ConformingSection section;
    section.z = in.get<double>();
    in.require(std::isfinite(section.z), "has a height that is not finite");
    section.nesting = get_nesting(in);
    section.triangulation = get_triangulation(in);
    get_labels(in, section);
    if (Result<void> read = in.end(); !read) return read.error();
    // Neighbours and edges follow from the triangles.
    const Triangulation2 triangulation = std::move(section.triangulation);
    section.triangulation = {};
    adopt(triangulation, section);
    classify_edges(section);
    return section;
  });
}

}  // namespace tetloft::internal::sections

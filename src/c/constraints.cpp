// Constraints of Delaunay triangulations of the plane.
#include <tetloft/delaunay_triangulation2.hpp>

#include <algorithm>
#include <array>
#include <string>
#include <vector>

#include "c/changing.hpp"
#include "c/structs.hpp"

namespace tetloft::internal::c {

namespace {

static_assert(TETLOFT_CROSSING_REFUSE == static_cast<int>(Crossing::refuse) &&
              TETLOFT_CROSSING_SPLIT == static_cast<int>(Crossing::split));

Crossing crossing_of_number(std::int32_t crossing) {
  return enumerator_of(crossing, Crossing::split, "crossing");
}

std::vector<std::array<DelaunayVertex, 2>> segments_of(const VertexNumber* ends,
                                                       std::size_t count) {
  require_array(ends, count, 2 * sizeof(VertexNumber), "segments");
  std::vector<std::array<DelaunayVertex, 2>> segments(count);
  for (std::size_t i = 0; i < count; ++i) {
    segments[i] = {vertex_of_number(ends[2 * i]), vertex_of_number(ends[2 * i + 1])};
  }
  return segments;
}

// Ends a body with TETLOFT_INVALID_INPUT where there is no such constraint.
ConstraintId live_constraint(const DelaunayTriangulation2& t, std::uint32_t number) {
  const ConstraintId c = ConstraintId(number);
  if (!t.is_live(c)) {
    throw Failed(Error{ErrorCode::invalid_input,
                       "there is no constraint " + std::to_string(number) + ", or no longer",
                       {}});
  }
  return c;
}

}  // namespace

}  // namespace tetloft::internal::c

using namespace tetloft::internal::c;
using tetloft::ConstraintId;
using tetloft::Crossing;
using tetloft::DelaunayTriangulation2;

tetloft_status tetloft_delaunay_plane_insert_constraint(tetloft_delaunay_plane* delaunay,
                                                        uint64_t u, uint64_t v, int32_t crossing,
                                                        uint32_t* constraint) {
  clear(constraint);
  return answer([&] {
    const auto value = value_of_handle(delaunay, "delaunay");
    require_output(constraint, "constraint");
    const Crossing what = crossing_of_number(crossing);
    const ConstraintId made = value_of(value->change([&](DelaunayTriangulation2& t) {
      return t.insert_constraint(vertex_of_number(u), vertex_of_number(v), what);
    }));
    *constraint = made.value();
  });
}

tetloft_status tetloft_delaunay_plane_insert_constraints(tetloft_delaunay_plane* delaunay,
                                                         const uint64_t* segments,
                                                         size_t segment_count, int32_t crossing,
                                                         uint32_t* constraints) {
  return answer([&] {
    const auto value = value_of_handle(delaunay, "delaunay");
    const Crossing what = crossing_of_number(crossing);
    const auto given = segments_of(segments, segment_count);
    const std::vector<ConstraintId> made = value_of(value->change(
        [&](DelaunayTriangulation2& t) { return t.insert_constraints(given, what); }));
    if (constraints != nullptr) std::copy_n(numbers_of(made), made.size(), constraints);
  });
}

tetloft_status tetloft_delaunay_plane_remove_constraint(tetloft_delaunay_plane* delaunay,
                                                        uint32_t constraint) {
  return answer([&] {
    require_success(value_of_handle(delaunay, "delaunay")->change([&](DelaunayTriangulation2& t) {
      return t.remove_constraint(ConstraintId(constraint));
    }));
  });
}

tetloft_status tetloft_delaunay_plane_has_constraint(const tetloft_delaunay_plane* delaunay,
                                                     uint32_t constraint, int* has) {
  clear(has);
  return answer([&] {
    const auto value = value_of_handle(delaunay, "delaunay");
    require_output(has, "has");
    *has = value->ask([&](const DelaunayTriangulation2& t) {
      return t.is_live(ConstraintId(constraint)) ? 1 : 0;
    });
  });
}

tetloft_status tetloft_delaunay_plane_constraints(const tetloft_delaunay_plane* delaunay,
                                                  uint32_t* constraints, size_t capacity,
                                                  size_t* count) {
  return ChangingPlane::counted(
      delaunay, constraints, capacity, count, "constraints",
      [](const DelaunayTriangulation2& t) { return t.constraint_count(); },
      [](const DelaunayTriangulation2& t, uint32_t* to) {
        for (const ConstraintId c : t.constraints()) *to++ = c.value();
      });
}

tetloft_status tetloft_delaunay_plane_constraint_ends(const tetloft_delaunay_plane* delaunay,
                                                      uint32_t constraint, uint64_t* ends) {
  if (ends != nullptr) std::fill_n(ends, 2, 0);
  return answer([&] {
    const auto value = value_of_handle(delaunay, "delaunay");
    require_output(ends, "ends");
    put_vertices(value->ask([&](const DelaunayTriangulation2& t) {
      return t.ends(live_constraint(t, constraint));
    }),
                 ends);
  });
}

tetloft_status tetloft_delaunay_plane_constraint_edges(const tetloft_delaunay_plane* delaunay,
                                                       uint32_t constraint, uint64_t* edges,
                                                       size_t capacity, size_t* count) {
  return ChangingPlane::found(delaunay, edges, capacity, count, "edges",
                              [&](const DelaunayTriangulation2& t) {
                                return vertex_numbers(t.edges(live_constraint(t, constraint)));
                              });
}

tetloft_status tetloft_delaunay_plane_edge_constraints(const tetloft_delaunay_plane* delaunay,
                                                       uint64_t u, uint64_t v,
                                                       uint32_t* constraints, size_t capacity,
                                                       size_t* count) {
  return ChangingPlane::found(delaunay, constraints, capacity, count, "constraints",
                              [&](const DelaunayTriangulation2& t) {
                                return t.constraints(live_vertex(t, u), live_vertex(t, v));
                              });
}

tetloft_status tetloft_delaunay_plane_inside(const tetloft_delaunay_plane* delaunay,
                                             uint64_t* triangles, size_t capacity, size_t* count) {
  return ChangingPlane::found(delaunay, triangles, capacity, count, "triangles",
                              [](const DelaunayTriangulation2& t) {
                                return ChangingPlane::corners(t, value_of(t.inside()));
                              });
}

// Memory that ends in triangulations, sections and meshes.
#include <gtest/gtest.h>

#include <array>
#include <vector>

#include <tetloft/tetloft.hpp>

#include "delaunay2/incremental.hpp"
#include "robustness/failing_allocator.hpp"
#include "robustness/inputs.hpp"
#include "robustness/sweep.hpp"

namespace tetloft::test {
namespace {

std::vector<Point3> points_in_space() {
  std::vector<Point3> points;
  for (int i = 0; i < 60; ++i) {
    points.push_back({static_cast<double>(i * 7 % 11), static_cast<double>(i * 5 % 13),
                      static_cast<double>(i * 3 % 7)});
  }
  return points;
}

std::vector<Point2> corners(const SectionStack& stack) {
  std::vector<Point2> points;
  for (const Contour& contour : stack.sections[SectionId(0)].contours) {
    points.insert(points.end(), contour.vertices.begin(), contour.vertices.end());
  }
  return points;
}

TEST(MemoryEnds, InTriangulations) {
  const std::vector<Point3> space = points_in_space();
  sweep("delaunay3", [&] { return ended(delaunay3(space)); });
  const std::vector<Point3> many = many_points_in_space();
  sweep("delaunay3 on 3", [&] { return ended(delaunay3(many, {.execution = {.threads = 3}})); });
  std::vector<Point3> planes;
  for (const Section& section : tower(2).sections) {
    for (const Contour& contour : section.contours) {
      for (const Point2& p : contour.vertices) planes.push_back({p.x, p.y, section.z});
    }
  }
  for (const unsigned threads : {1U, 2U}) {
    sweep("delaunay3, slab, " + std::to_string(threads), [&] {
      return ended(
          delaunay3(planes, {.engine = DelaunayEngine::slab, .execution = {.threads = threads}}));
    });
  }
  const SectionStack stack = tower(1, 12);
  const std::vector<Point2> flat = corners(stack);
  sweep("delaunay2", [&] { return ended(delaunay2(flat)); });
  const std::vector<Segment> segments{{PlaneVertexId(0), PlaneVertexId(4)},
                                      {PlaneVertexId(5), PlaneVertexId(11)}};
  const ConformingOptions options{.gabriel = {true, false}};
  const std::vector<Segment> nowhere{{PlaneVertexId(0), PlaneVertexId(99)}};
  sweep("conforming_delaunay2",
        [&] { return ended(conforming_delaunay2(flat, segments, options)); });
  sweep("conforming_delaunay2, refused",
        [&] { return ended(conforming_delaunay2(flat, nowhere)); });
  const ConformingSection section = conform(stack.sections[SectionId(0)], SectionId(0)).value();
  sweep("slab_delaunay3",
        [&] { return ended(slab_delaunay3(section.triangulation, section.triangulation)); });
}

// Crosses itself, doubles back and touches.
SectionStack broken_stack() {
  SectionStack stack;
  Section section;
  section.contours.push_back({{{0, 0}, {4, 0}, {4, 4}, {0, 4}, {0, 0}}});
  section.contours.push_back({{{3, 3}, {6, 3}, {6, 6}, {3, 6}, {3, 6}}});
  section.contours.push_back({{{10, 0}, {12, 2}, {12, 0}, {10, 2}}});
  stack.sections.push_back(section);
  return stack;
}

TEST(MemoryEnds, InSections) {
  const SectionStack stack = case_stack("nested_hole");
  const Section& section = stack.sections[SectionId(0)];
  const SectionStack broken = broken_stack();
  const Execution alone{.threads = 1};
  sweep("validate", [&] { return ended(validate(stack, alone)); });
  sweep("validate, refused", [&] { return ended(validate(broken, alone)); });
  sweep("repair", [&] { return ended(repair(broken, {.execution = alone})); });
  sweep("snap", [&] { return ended(snap(stack, 3, alone)); });
  sweep("refine", [&] { return ended(refine(stack, 0.5, alone)); });
  const ConformOptions gabriel{.gabriel = IdVector<ContourId, bool>(section.contours.size(), true)};
  sweep("conform", [&] { return ended(conform(section, SectionId(0), gabriel)); });
  sweep("nest", [&] { return ended_throwing([&] { static_cast<void>(nest(section)); }); });
  const Nesting nesting = nest(section);
  sweep("outlines",
        [&] { return ended_throwing([&] { static_cast<void>(outlines(section, nesting)); }); });
  sweep("outline", [&] {
    return ended_throwing([&] { static_cast<void>(outline(section, nesting, RegionId(0))); });
  });
}

TEST(MemoryEnds, WhileMendingLeavesAStack) {
  const SectionStack broken = broken_stack();
  SectionStack mended;
  sweep(
      "mend",
      [&] {
        return ended_throwing([&] {
          SectionStack stack = broken;
          const std::vector<Warning> warnings = mend(stack);
          static_cast<void>(warnings);
        });
      },
      [&] {
        mended = broken;
        return mend(mended).size() == 2;
      });
}

TEST(MemoryEnds, InSkeletonsAndOverlaps) {
  const SectionStack stack = tower(2);
  const ConformingSection below = conform(stack.sections[SectionId(0)], SectionId(0)).value();
  const ConformingSection above = conform(stack.sections[SectionId(1)], SectionId(1)).value();
  const auto throwing = [](const std::string& name, const std::function<void()>& call) {
    sweep(name, [&] { return ended_throwing(call); });
  };
  throwing("voronoi_skeleton",
           [&] { static_cast<void>(voronoi_skeleton(below, EdgeKind::internal)); });
  throwing("skeleton_crossings", [&] { static_cast<void>(skeleton_crossings(below, above)); });
  throwing("well_positioned", [&] { static_cast<void>(well_positioned(below, above)); });
  const auto a = outlines(stack.sections[SectionId(0)], below.nesting);
  const auto b = outlines(stack.sections[SectionId(1)], above.nesting);
  throwing("compare_overlap",
           [&] { static_cast<void>(compare_overlap(a[RegionId(0)], b[RegionId(0)], 0.5)); });
  // Equal regions: only rationals tell that the ratio is 1.
  throwing("compare_overlap, exact",
           [&] { static_cast<void>(compare_overlap(a[RegionId(0)], a[RegionId(0)], 1)); });
  throwing("overlap_ratio",
           [&] { static_cast<void>(overlap_ratio(a[RegionId(0)], b[RegionId(0)])); });
  throwing("area", [&] { static_cast<void>(area(a[RegionId(0)])); });
  // The one is the area of the other, as integers tell.
  const Contour unit{{{0, 0}, {1, 0}, {1, 1}, {0, 1}}};
  throwing("compare_area", [&] { static_cast<void>(compare_area({{&unit}}, 1)); });
  throwing("region_distance",
           [&] { static_cast<void>(region_distance(a[RegionId(0)], b[RegionId(0)])); });
  // An ulp off a diagonal: only integers tell the distance.
  const Contour corner{{{0, 0}, {4, 4}, {0, 8}}};
  const Contour tip{{{std::nextafter(2.0, 3.0), 2}, {8, -4}, {8, 0}}};
  throwing("region_distance, exact",
           [&] { static_cast<void>(region_distance({{&corner}}, {{&tip}})); });
  throwing("area_sign", [&] {
    static_cast<void>(area_sign(stack.sections[SectionId(0)].contours[ContourId(0)]));
  });
}

// Two points a part of an ulp apart in what the filters see, and huge coordinates.
TEST(MemoryEnds, InPredicates) {
  const double huge = 0x1p1000;
  const double tiny = 0x1p-1000;
  const auto throwing = [](const std::string& name, const std::function<void()>& call) {
    sweep(name, [&] { return ended_throwing(call); });
  };
  throwing("insphere, integers", [&] {
    static_cast<void>(insphere_perturbed({huge, 0, 0}, {0, huge, 0}, {0, 0, huge}, {-huge, 0, 0},
                                         {tiny, -huge, tiny}));
  });
  throwing("orient3d, integers", [&] {
    static_cast<void>(orient3d({huge, 0, 0}, {0, huge, 0}, {0, 0, huge}, {huge, -huge, tiny}));
  });
}

TetMesh some_mesh() {
  const std::vector<Point3> points = points_in_space();
  return delaunay3(points).value().mesh;
}

TEST(MemoryEnds, InMeshQueries) {
  const TetMesh mesh = some_mesh();
  const auto throwing = [](const std::string& name, const std::function<void()>& call) {
    sweep(name, [&] { return ended_throwing(call); });
  };
  const VertexId a = mesh.vertex(TetId(0), 0);
  const VertexId b = mesh.vertex(TetId(0), 1);
  throwing("TetMesh::star", [&] { static_cast<void>(mesh.star(a)); });
  throwing("TetMesh::star of an edge", [&] { static_cast<void>(mesh.star(a, b)); });
  throwing("TetMesh::star of a face", [&] { static_cast<void>(mesh.star(HalfFaceId(0))); });
  throwing("TetMesh::ring", [&] { static_cast<void>(mesh.ring(a, b, TetId(0))); });
  throwing("TetMesh::link", [&] { static_cast<void>(mesh.link(a)); });
  throwing("TetMesh::link of an edge", [&] { static_cast<void>(mesh.link(a, b)); });
  throwing("TetMesh::classify_link", [&] { static_cast<void>(mesh.classify_link(a)); });
  throwing("TetMesh::classify_link of an edge",
           [&] { static_cast<void>(mesh.classify_link(a, b)); });
  throwing("TetMesh::singular_vertices", [&] { static_cast<void>(mesh.singular_vertices()); });
  throwing("TetMesh::boundary", [&] { static_cast<void>(mesh.boundary()); });
  throwing("TetMesh::components", [&] { static_cast<void>(mesh.components()); });
  throwing("TetMesh::validate", [&] { static_cast<void>(mesh.validate()); });
  std::vector<TetVertices> tets;
  for (std::size_t t = 0; t < mesh.tet_slots(); ++t) tets.push_back(mesh.vertices(TetId(t)));
  sweep("TetMesh::from_tets", [&] { return ended(TetMesh::from_tets(60, tets)); });
  tets.push_back(tets.front());
  sweep("TetMesh::from_tets, refused", [&] { return ended(TetMesh::from_tets(60, tets)); });
}

// The mesh itself is the caller's, and whole after each failure.
TEST(MemoryEnds, InMeshEditsThatLeaveTheMeshValid) {
  const TetMesh whole = some_mesh();
  TetMesh mesh = TetMesh(whole);
  const auto valid = [&] {
    const bool is_valid = mesh.validate().empty();
    mesh = TetMesh(whole);  // without room to spare
    return is_valid;
  };
  sweep(
      "TetMesh::add_tet",
      [&] {
        VertexId apex;
        const Ended failed = ended_throwing([&] { apex = mesh.add_vertices(4); });
        if (failed.error) return failed;
        return ended(mesh.add_tet({apex, VertexId(apex.index() + 1), VertexId(apex.index() + 2),
                                   VertexId(apex.index() + 3)}));
      },
      valid);
  sweep(
      "TetMesh::remove_tet",
      [&] {
        return ended_throwing([&] {
          for (std::size_t t = 0; t < 9; ++t) mesh.remove_tet(TetId(t));
        });
      },
      valid);
  sweep(
      "TetMesh::compact",
      [&] {
        const Ended failed = ended_throwing([&] { mesh.remove_tet(TetId(1)); });
        if (failed.error) return failed;
        return ended_throwing([&] { static_cast<void>(mesh.compact()); });
      },
      valid);
}

// A copy's scratch arrays have no room from earlier; of all that a removal needs it asks for one
// thing before it begins, and does without the rest.
TEST(MemoryEnds, WithinARemovalFromACopiedTriangulation) {
  namespace plane = internal::delaunay2_detail;
  plane::Incremental2 whole({0, 0}, {40, 0}, {0, 40}, 64);
  for (int i = 1; i < 60; ++i) {
    (void)whole.insert_nearby({static_cast<double>(i * 7 % 41), static_cast<double>(i * i % 37)});
  }
  for (std::size_t v = 1; v < whole.vertex_count(); ++v) {
    plane::Incremental2 expected = whole;
    expected.remove(plane::SiteId(v));
    plane::Incremental2 copy = whole;
    arm_allocator(2, Failing::from_there);
    copy.remove(plane::SiteId(v));
    (void)disarm_allocator();
    for (std::size_t a = 1; a < whole.vertex_count(); ++a) {
      for (std::size_t b = 1; b < a; ++b) {
        if (a == v || b == v) continue;
        const plane::SiteId from(a), to(b);
        ASSERT_EQ(copy.find_edge(from, to).valid(), expected.find_edge(from, to).valid()) << v;
      }
    }
  }
}

}  // namespace
}  // namespace tetloft::test

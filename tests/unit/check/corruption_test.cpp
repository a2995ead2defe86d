// Each corruption of a valid model fails, with the number of the guarantee it breaks.
#include <tetloft/check.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "support/refine/refine_model.hpp"
#include "unit/check/columns.hpp"
#include "unit/check/verdict_text.hpp"

namespace tetloft {
namespace {

using testing::Case;
using testing::vertex_at;

struct Corruption {
  const char* condition;  // that must be among those that fail
  const char* name;
  Case (*start)();
  void (*corrupt)(Case&, CheckOptions&);
};

void PrintTo(const Corruption& corruption, std::ostream* out) { *out << corruption.name; }

constexpr double kInfinity = std::numeric_limits<double>::infinity();

Point3& at(Case& c, double x, double y, double z) {
  return c.model.points[vertex_at(c.model, x, y, z)];
}

VertexId add_point(Case& c, double x, double y, double z) {
  return c.model.points.push_back({x, y, z});
}

// Adds a tet, turned so that it is positive.
void add_tet(Case& c, TetVertices tet) {
  const auto point = [&](std::size_t i) { return c.model.points[tet[i]]; };
  if (orient3d(point(0), point(1), point(2), point(3)) == Sign::negative) std::swap(tet[2], tet[3]);
  c.model.tets.push_back(tet);
}

template <class Condition>
void remove_tets(Case& c, Condition&& condition) {
  auto& tets = c.model.tets.raw();
  tets.erase(std::remove_if(tets.begin(), tets.end(), condition), tets.end());
}

bool all_of_tet(const Case& c, const TetVertices& tet, bool (*condition)(const Point3&)) {
  return std::all_of(tet.begin(), tet.end(),
                     [&](VertexId v) { return condition(c.model.points[v]); });
}

// Replaces a vertex in all tets.
void identify(Case& c, VertexId from, VertexId to) {
  for (TetVertices& tet : c.model.tets) std::replace(tet.begin(), tet.end(), from, to);
}

void translate(Case& c, double beyond_x, double dx, double dy, double dz) {
  for (Point3& p : c.model.points) {
    if (p.x >= beyond_x) p = {p.x + dx, p.y + dy, p.z + dz};
  }
}

// Fills the space between two disjoint triangles.
void add_bridge(Case& c, const std::array<VertexId, 3>& a, const std::array<VertexId, 3>& b) {
  add_tet(c, {a[0], a[1], a[2], b[0]});
  add_tet(c, {a[1], a[2], b[0], b[1]});
  add_tet(c, {a[2], b[0], b[1], b[2]});
}

// A column with vertices inside its middle section: in an edge, and in a face.
Case inner_case() {
  Case c = testing::slabs_case();
  const std::array diagonal{vertex_at(c.model, 4, 0, 1), vertex_at(c.model, 0, 4, 1)};
  testing::insert_vertex(c.model, diagonal, {2, 2, 1});
  const std::array face{vertex_at(c.model, 0, 0, 1), vertex_at(c.model, 4, 0, 1),
                        vertex_at(c.model, 2, 2, 1)};
  testing::insert_vertex(c.model, face, {2, 1, 1});
  return c;
}

CorrespondenceOptions labels(std::vector<Label> of) {
  CorrespondenceOptions options;
  options.labels = std::move(of);
  return options;
}

Label label(int section, int contour, std::uint32_t value) {
  return {SectionId(section), ContourId(contour), value};
}

Case plugged_case() {  // a plug in the hole of a frame, touching nothing
  testing::Shape plug = testing::moved(testing::square_shape(), 0, 0);
  for (Contour& contour : plug.contours) {
    for (Point2& p : contour.vertices) p = {2.5 + p.x / 4, 2.5 + p.y / 4};
  }
  return testing::extrude(
      {{testing::frame_shape(), {0, 1, 2}}, {testing::polygon_shape(plug.contours[0]), {0, 1, 2}}},
      {0, 1, 2});
}

Case three_case() {  // columns in a row
  return testing::extrude({{testing::square_shape(), {0, 1, 2}},
                           {testing::moved(testing::square_shape(), 10, 0), {0, 1, 2}},
                           {testing::moved(testing::square_shape(), 20, 0), {0, 1, 2}}},
                          {0, 1, 2});
}

Case tall_case() {
  return testing::extrude({{testing::square_shape(), {0, 1, 2, 3}}}, {0, 1, 2, 3});
}

const Corruption kManifold[] = {
    {"1.1", "VertexOutOfRange", testing::prism_case,
     [](Case& c, CheckOptions&) { c.model.tets[TetId(0)][2] = c.model.points.end_id(); }},
    {"1.1", "InvalidVertex", testing::prism_case,
     [](Case& c, CheckOptions&) { c.model.tets[TetId(1)][0] = VertexId(); }},
    {"1.1", "RepeatedVertex", testing::prism_case,
     [](Case& c, CheckOptions&) { c.model.tets[TetId(0)][3] = c.model.tets[TetId(0)][1]; }},
    {"1.3", "DuplicatedEndTet", testing::prism_case,
     [](Case& c, CheckOptions&) { c.model.tets.push_back(c.model.tets[TetId(1)]); }},
    {"1.2", "TetOnAnInnerFace", testing::slabs_case,
     [](Case& c, CheckOptions&) {
       // Every tet has an inner face; a third tet gets each of its faces.
       const VertexId apex = add_point(c, 2, 2, 0.5);
       const TetVertices tet = c.model.tets[TetId(0)];
       for (std::size_t i = 0; i < 4; ++i) {
         TetVertices onto = tet;
         onto[i] = apex;
         add_tet(c, onto);
       }
     }},
    {"1.3", "InvertedTet", testing::slabs_case,
     [](Case& c, CheckOptions&) {
       std::swap(c.model.tets[TetId(3)][0], c.model.tets[TetId(3)][1]);
     }},
    {"1.4", "MissingMiddleTet", testing::prism_case,
     [](Case& c, CheckOptions&) { c.model.tets.raw().pop_back(); }},
    {"1.4", "ComponentsShareAVertex", testing::pair_case,
     [](Case& c, CheckOptions&) {
       identify(c, vertex_at(c.model, 10, 1, 1), vertex_at(c.model, 4, 0, 1));
     }},
    {"1.4", "ComponentsShareAnEdge", testing::pair_case,
     [](Case& c, CheckOptions&) {
       identify(c, vertex_at(c.model, 10, 1, 1), vertex_at(c.model, 4, 0, 1));
       identify(c, vertex_at(c.model, 10, 1, 2), vertex_at(c.model, 4, 0, 2));
     }},
    {"1.4", "LinkWithAHole", testing::tube_case,
     [](Case& c, CheckOptions&) {
       const VertexId apex = add_point(c, 3, 3, 5);
       const testing::Shape frame = testing::frame_shape();
       for (const auto& t : frame.triangles) {
         const auto top = [&](std::size_t k) {
           return vertex_at(c.model, frame.points[t[k]].x, frame.points[t[k]].y, 2);
         };
         add_tet(c, {top(0), top(1), top(2), apex});
       }
     }},
    {"1.5", "SpareVertex", testing::prism_case,
     [](Case& c, CheckOptions&) { add_point(c, 1, 1, 0.5); }},
    {"1.5", "SpareVertexBeyondTheEnd", testing::prism_case,
     [](Case& c, CheckOptions&) { add_point(c, 1, 1, 7); }},
};

const Corruption kResampling[] = {
    {"2.1", "TetAcrossAPlane", testing::slabs_case,
     [](Case& c, CheckOptions&) {
       add_tet(c, {add_point(c, 20, 0, 0.5), add_point(c, 21, 0, 0.5), add_point(c, 20, 1, 0.5),
                   add_point(c, 20, 0, 2)});
     }},
    {"2.2", "TwoVerticesAtOnePlace", testing::slabs_case,
     [](Case& c, CheckOptions&) {
       // The upper slab gets vertices of its own in the plane between.
       for (const auto& [x, y] : {std::pair(0, 0), {4, 0}, {4, 4}, {0, 4}}) {
         const VertexId old = vertex_at(c.model, x, y, 1);
         const VertexId own = add_point(c, x, y, 1);
         for (TetVertices& tet : c.model.tets) {
           const bool upper = std::any_of(tet.begin(), tet.end(),
                                          [&](VertexId v) { return c.model.points[v].z > 1; });
           if (upper) std::replace(tet.begin(), tet.end(), old, own);
         }
       }
     }},
    {"2.3", "InputVertexMovedByAnUlp", testing::slabs_case,
     [](Case& c, CheckOptions&) {
       Point3& p = at(c, 4, 4, 1);
       p.x = std::nextafter(p.x, kInfinity);
     }},
    {"2.3", "InputVertexMovedOffItsPlane", testing::slabs_case,
     [](Case& c, CheckOptions&) {
       Point3& p = at(c, 4, 4, 1);
       p.z = std::nextafter(p.z, kInfinity);
     }},
    {"2.3", "ContourWithoutTets", testing::pair_case,
     [](Case& c, CheckOptions&) {
       Section& section = c.stack.sections[SectionId(1)];
       section.contours.push_back(testing::moved(testing::square_shape(), 20, 0).contours[0]);
     }},
    {"2.4", "CollinearFace", testing::prism_case,
     [](Case& c, CheckOptions&) {
       at(c, 4, 0, 0) = {0.5, 1.5, 0};
     }},
    {"2.5", "TwoTetsBelowAFace", testing::slabs_case,
     [](Case& c, CheckOptions&) {
       const VertexId apex = add_point(c, 1, 2, 0.5);
       add_tet(c, {vertex_at(c.model, 0, 0, 1), vertex_at(c.model, 4, 0, 1),
                   vertex_at(c.model, 0, 4, 1), apex});
     }},
    {"2.6", "SlabMissing", testing::pair_case,
     [](Case& c, CheckOptions&) {
       remove_tets(c, [&](const TetVertices& tet) {
         return all_of_tet(c, tet, [](const Point3& p) { return p.x >= 10 && p.z >= 1; });
       });
     }},
    {"2.7", "OverlappingFaces", testing::prism_case,
     [](Case& c, CheckOptions&) {
       add_tet(c, {vertex_at(c.model, 0, 0, 0), vertex_at(c.model, 4, 0, 0), add_point(c, 2, 1, 0),
                   add_point(c, 2, 1, 0.5)});
     }},
    {"2.8", "InnerTriangleMissing", testing::slabs_case,
     [](Case& c, CheckOptions&) {
       remove_tets(c, [&](const TetVertices& tet) {
         return std::count_if(tet.begin(), tet.end(), [&](VertexId v) {
                  return c.model.points[v].z == 0 && c.model.points[v] != Point3{0, 0, 0};
                }) == 3;
       });
     }},
    {"2.8", "HoleFilled", testing::tube_case,
     [](Case& c, CheckOptions&) {
       for (const double z : {0.0, 1.0}) {
         const auto corner = [&](double x, double y, double h) {
           return vertex_at(c.model, x, y, z + h);
         };
         add_bridge(c, {corner(2, 2, 0), corner(4, 2, 0), corner(4, 4, 0)},
                    {corner(2, 2, 1), corner(4, 2, 1), corner(4, 4, 1)});
         add_bridge(c, {corner(2, 2, 0), corner(4, 4, 0), corner(2, 4, 0)},
                    {corner(2, 2, 1), corner(4, 4, 1), corner(2, 4, 1)});
       }
     }},
    {"2.9", "BodyWithoutContour", testing::pair_case,
     [](Case& c, CheckOptions&) {
       for (Section& section : c.stack.sections) section.contours.raw().pop_back();
     }},
    {"2.7", "InnerVertexMovedOutsideTheRegion", inner_case,
     [](Case& c, CheckOptions&) {
       at(c, 2, 2, 1) = {7, 7, 1};
     }},
    {"2.7", "FaceCoveredTwice", inner_case,
     [](Case& c, CheckOptions&) {
       // The face that the inner vertex parted, whole beside its parts.
       const VertexId a = vertex_at(c.model, 0, 0, 1);
       const VertexId b = vertex_at(c.model, 4, 0, 1);
       add_tet(c, {a, b, vertex_at(c.model, 0, 4, 1), add_point(c, 1, 1, 0.5)});
     }},
    {"2.9", "SecondSheetInsideTheRegion", inner_case,
     [](Case& c, CheckOptions&) {
       add_tet(c, {add_point(c, 2.5, 2.5, 1), add_point(c, 3, 2.5, 1), add_point(c, 2.5, 3, 1),
                   add_point(c, 2.5, 2.5, 1.5)});
     }},
    {"2.9", "FaceOutsideTheRegion", inner_case,
     [](Case& c, CheckOptions&) {
       add_tet(c, {add_point(c, 20, 0, 1), add_point(c, 21, 0, 1), add_point(c, 20, 1, 1),
                   add_point(c, 20, 0, 2)});
     }},
    {"2.9", "FaceAtAnInnerVertexMissing", inner_case,
     [](Case& c, CheckOptions&) {
       const VertexId a = vertex_at(c.model, 2, 2, 1);
       const VertexId b = vertex_at(c.model, 2, 1, 1);
       remove_tets(c, [&](const TetVertices& tet) {
         return std::count(tet.begin(), tet.end(), a) + std::count(tet.begin(), tet.end(), b) == 2;
       });
     }},
    {"2.8", "InnerVertexTakenForAContourVertex", inner_case,
     [](Case& c, CheckOptions&) {
       // The input's corner goes to where nothing is.
       c.stack.sections[SectionId(1)].contours[ContourId(0)].vertices[2] = {2, 2};
     }},
    {"2.6", "InnerVertexOnOneSideOnly", inner_case,
     [](Case& c, CheckOptions&) {
       // The tets above get another vertex, an ulp higher.
       const VertexId low = vertex_at(c.model, 2, 2, 1);
       const VertexId high = add_point(c, 2, 2, std::nextafter(1, kInfinity));
       for (TetVertices& tet : c.model.tets) {
         const bool above = std::any_of(tet.begin(), tet.end(),
                                        [&](VertexId v) { return c.model.points[v].z > 2; });
         if (above) std::replace(tet.begin(), tet.end(), low, high);
       }
     }},
    {"2.11", "VertexOfAContourEdgeTooFarInside", inner_case,
     [](Case& c, CheckOptions&) {
       // A right remeshing but for a notch 16 ulps deep.
       const std::array edge{vertex_at(c.model, 0, 0, 1), vertex_at(c.model, 4, 0, 1)};
       testing::insert_vertex(c.model, edge, {2, 16 * 0x1p-50, 1});
     }},
    {"2.10", "VertexOutsideTheRegion", inner_case,
     [](Case& c, CheckOptions&) { add_point(c, 20, 0, 1); }},
    {"2.10", "ApexOutsideTheRegion", inner_case,
     [](Case& c, CheckOptions&) {
       add_tet(c, {add_point(c, 20, 0, 1), add_point(c, 20, 0, 2), add_point(c, 21, 0, 2),
                   add_point(c, 20, 1, 2)});
     }},
    {"2.10", "SpareVertexInAPlane", testing::prism_case,
     [](Case& c, CheckOptions&) { add_point(c, 1, 1, 1); }},
    {"2.11", "InsertedVertex100UlpsOff", testing::split_case,
     [](Case& c, CheckOptions&) { at(c, 2.5, 1.5, 1).x += 100 * 0x1p-50; }},
    {"2.11", "NoUlpsAllowed", testing::split_case,
     [](Case&, CheckOptions& options) { options.split_ulps = 0; }},
    {"2.12", "InsertedVerticesFoldBack", testing::prism_case,
     [](Case& c, CheckOptions& options) {
       c = testing::extrude(
           {{testing::polygon_shape({{{0, 0}, {3, -1}, {1, -0.125}, {4, 0}, {4, 4}, {0, 4}}}),
             {0, 1}}},
           {0, 1});
       for (Section& section : c.stack.sections) {
         section.contours[ContourId(0)] = testing::square_shape().contours[0];
       }
       options.split_ulps = 0x1p60;
     }},
    {"2.13", "InsertedVertexJumpsOverAContour", testing::pair_case,
     [](Case& c, CheckOptions& options) {
       // A hair of a contour beside an edge whose middle is inserted on its other side.
       c = testing::extrude(
           {{testing::polygon_shape({{{0, 0}, {2, -0.25}, {4, 0}, {4, 4}, {0, 4}}}), {0, 1}}},
           {0, 1});
       for (Section& section : c.stack.sections) {
         section.contours[ContourId(0)] = testing::square_shape().contours[0];
         section.contours.push_back({{{1.75, -0.125}, {2.25, -0.125}, {2, -0.0625}}});
       }
       options.split_ulps = 0x1p60;
     }},
    {"2.14", "EdgeAcrossTheExterior", testing::pair_case,
     [](Case& c, CheckOptions&) {
       add_tet(c, {vertex_at(c.model, 4, 0, 1), vertex_at(c.model, 10, 1, 1),
                   add_point(c, 7, 0, 1.5), add_point(c, 7, 1, 1.5)});
     }},
};

const Corruption kEmbedded[] = {
    {"3.1", "NotANumber", testing::slabs_case,
     [](Case& c, CheckOptions&) { at(c, 4, 4, 3).y = std::nan(""); }},
    {"3.1", "Infinity", testing::half_ends_case,
     [](Case& c, CheckOptions&) { at(c, 4, 0, 1.5).z = kInfinity; }},
    {"3.2", "InvertedTet", testing::prism_case,
     [](Case& c, CheckOptions&) {
       std::swap(c.model.tets[TetId(1)][1], c.model.tets[TetId(1)][3]);
     }},
    {"3.2", "AllInverted", testing::slabs_case,
     [](Case& c, CheckOptions&) {
       for (TetVertices& tet : c.model.tets) std::swap(tet[0], tet[1]);
     }},
    {"3.2", "FlatTet", testing::isolated_case,
     [](Case& c, CheckOptions&) {
       for (const auto& [x, y] : {std::pair(10, 0), {14, 0}, {14, 4}, {10, 4}})
         at(c, x, y, 2).z = 1;
     }},
    {"3.2", "CapTurnedInsideOut", testing::isolated_case,
     [](Case& c, CheckOptions&) {
       at(c, 10, 0, 2) = {18, 8, 2};
     }},
    {"3.3", "ComponentOntoAnother", testing::pair_case,
     [](Case& c, CheckOptions&) { translate(c, 10, -8, 0, 0); }},
    {"3.3", "ComponentsEqual", testing::pair_case,
     [](Case& c, CheckOptions&) { translate(c, 10, -10, -1, 0); }},
    {"3.3", "ComponentsTouchInAFace", testing::pair_case,
     [](Case& c, CheckOptions&) { translate(c, 10, -6, 0, 0); }},
    {"3.3", "ComponentsTouchInAPoint", testing::pair_case,
     [](Case& c, CheckOptions&) { translate(c, 10, -6, 3, 2); }},
    {"3.3", "CapReachesItsNeighbour", testing::isolated_case,
     [](Case& c, CheckOptions&) {
       at(c, 10, 4, 2) = {4, 4, 2};
     }},
    {"3.3", "InnerSlitClosed", plugged_case,
     [](Case& c, CheckOptions&) {
       at(c, 2.5, 2.5, 1) = {2, 2, 1};
     }},
    {"3.4", "TetInsideASolid", testing::slabs_case,
     [](Case& c, CheckOptions&) {
       add_tet(c, {add_point(c, 1, 1, 1.5), add_point(c, 2, 1, 1.5), add_point(c, 1, 2, 1.5),
                   add_point(c, 1, 1, 2)});
     }},
    {"3.4", "ComponentSwallowed", plugged_case,
     [](Case& c, CheckOptions&) {
       // The plug moves into the wall of the frame and is thinned to lie strictly inside.
       for (Point3& p : c.model.points) {
         if (p.x >= 2.5 && p.x <= 3.5) p = {p.x - 2, p.y, 0.25 + p.z * 0.75};
       }
     }},
};

const Corruption kComponents[] = {
    {"4.1", "FloatingTet", testing::slabs_case,
     [](Case& c, CheckOptions&) {
       add_tet(c, {add_point(c, 20, 0, 1.5), add_point(c, 21, 0, 1.5), add_point(c, 20, 1, 1.5),
                   add_point(c, 20, 0, 2)});
     }},
    {"4.2", "ContourWithoutTets", testing::pair_case,
     [](Case& c, CheckOptions&) {
       remove_tets(c, [&](const TetVertices& tet) {
         return all_of_tet(c, tet, [](const Point3& p) { return p.x >= 10; });
       });
     }},
    {"4.2", "ContourOnTwoComponents", testing::slabs_case,
     [](Case& c, CheckOptions&) {
       // One triangle's prisms get vertices of their own.
       for (const double z : {0.0, 1.0, 3.0}) {
         for (const auto& [x, y] : {std::pair(4, 0), {0, 4}}) {
           const VertexId old = vertex_at(c.model, x, y, z);
           const VertexId own = add_point(c, x, y, z);
           for (TetVertices& tet : c.model.tets) {
             if (std::all_of(tet.begin(), tet.end(), [&](VertexId v) {
                   return c.model.points[v].x + c.model.points[v].y >= 4;
                 })) {
               std::replace(tet.begin(), tet.end(), old, own);
             }
           }
         }
       }
     }},
    {"4.3", "BridgeCut", testing::pair_case,
     [](Case& c, CheckOptions&) {
       c.model = testing::extrude({{testing::square_shape(), {0, 1, 2}},
                                   {testing::moved(testing::square_shape(), 10, 1), {0, 1, 1.25}},
                                   {testing::moved(testing::square_shape(), 10, 1), {1.75, 2}}},
                                  {0, 1, 2})
                     .model;
     }},
    {"4.3", "SlabMissing", tall_case,
     [](Case& c, CheckOptions&) {
       remove_tets(c, [&](const TetVertices& tet) {
         return all_of_tet(c, tet, [](const Point3& p) { return p.z >= 1 && p.z <= 2; });
       });
     }},
    {"4.3", "SameLabelOnTwoComponents", testing::pair_case,
     [](Case&, CheckOptions& options) {
       options.correspondence = labels({label(0, 0, 7), label(2, 1, 7)});
     }},
    {"4.4", "TwoLabelsOnOneComponent", testing::slabs_case,
     [](Case&, CheckOptions& options) {
       options.correspondence = labels({label(0, 0, 1), label(2, 0, 2)});
     }},
    {"4.4", "ComponentsJoined", testing::pair_case,
     [](Case& c, CheckOptions&) {
       const Model& m = c.model;
       add_bridge(c, {vertex_at(m, 4, 0, 0), vertex_at(m, 4, 4, 0), vertex_at(m, 4, 4, 1)},
                  {vertex_at(m, 10, 1, 0), vertex_at(m, 10, 5, 0), vertex_at(m, 10, 5, 1)});
     }},
    {"4.4", "EqualTrianglesHaveNoReverseTet", testing::prism_case,
     [](Case&, CheckOptions& options) { options.correspondence.criterion = Criterion::reverse; }},
    {"4.4", "TwoLabelsOnOneOfThree", three_case,
     [](Case&, CheckOptions& options) {
       options.correspondence = labels({label(0, 1, 1), label(1, 1, 1), label(2, 1, 2)});
     }},
    {"4.5", "LabelThatCannotBeRealised", three_case,
     [](Case&, CheckOptions& options) {
       // Label 1 lies in the bottom section only, and all of the next has another.
       options.correspondence =
           labels({label(0, 0, 1), label(0, 2, 1), label(1, 0, 2), label(1, 1, 2), label(1, 2, 2)});
     }},
};

class Corrupted : public ::testing::TestWithParam<Corruption> {};

TEST_P(Corrupted, ModelFailsWithTheNumberOfItsGuarantee) {
  const Corruption& corruption = GetParam();
  Case c = corruption.start();
  CheckOptions options;
  const auto before = check(c.model, c.stack, options);
  ASSERT_TRUE(before.ok() && before->pass()) << testing::text(*before);
  corruption.corrupt(c, options);
  const auto after = check(c.model, c.stack, options);
  ASSERT_TRUE(after.ok()) << to_string(after.error());
  const auto number = static_cast<std::size_t>(corruption.condition[0] - '0');
  EXPECT_FALSE(after->guarantees[number - 1].pass);
  EXPECT_EQ(testing::failed_conditions(*after).count(corruption.condition), 1U)
      << testing::text(*after);
}

std::string name(const ::testing::TestParamInfo<Corruption>& info) { return info.param.name; }

INSTANTIATE_TEST_SUITE_P(Manifold, Corrupted, ::testing::ValuesIn(kManifold), name);
INSTANTIATE_TEST_SUITE_P(Resampling, Corrupted, ::testing::ValuesIn(kResampling), name);
INSTANTIATE_TEST_SUITE_P(Embedded, Corrupted, ::testing::ValuesIn(kEmbedded), name);
INSTANTIATE_TEST_SUITE_P(Components, Corrupted, ::testing::ValuesIn(kComponents), name);

}  // namespace
}  // namespace tetloft

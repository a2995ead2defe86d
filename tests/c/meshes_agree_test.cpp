// Meshes, triangulations and points of C are those of C++, bit for bit.
#include <gtest/gtest.h>

#include <array>
#include <functional>

#include <tetloft/tetloft.hpp>

#include "c/owned.hpp"
#include "core/prng.hpp"
#include "unit/io/io_support.hpp"

namespace tetloft::c_test {
namespace {

// Points of a small lattice, with duplicates, and their coordinates.
std::vector<Point3> lattice_points(std::size_t count, std::uint64_t seed) {
  internal::Prng random(seed);
  std::vector<Point3> points(count);
  for (Point3& p : points) {
    const auto coordinate = [&] { return static_cast<double>(random.below(6)); };
    p.x = coordinate();
    p.y = coordinate();
    p.z = coordinate();
  }
  return points;
}

using Query = std::function<tetloft_status(std::uint32_t*, std::size_t, std::size_t*)>;

// What a query with an array of the caller's gives: asked for the number first, and with one
// element too few.
template <class T>
void expect_query(const Query& query, const std::vector<T>& expected) {
  constexpr std::size_t kTuple = sizeof(T) / sizeof(std::uint32_t);
  std::size_t count = 12345;
  ASSERT_OK(query(nullptr, 0, &count));
  ASSERT_EQ(count, expected.size());
  std::vector<std::uint32_t> ids(kTuple * count + 1, 77);
  if (count > 0) {
    count = 0;
    EXPECT_EQ(query(ids.data(), expected.size() - 1, &count), TETLOFT_TOO_SMALL);
    EXPECT_EQ(count, expected.size());
    EXPECT_EQ(ids, std::vector<std::uint32_t>(ids.size(), 77)) << "nothing is written";
  }
  ASSERT_OK(query(ids.data(), expected.size(), &count));
  EXPECT_EQ(ids.back(), 77U);
  EXPECT_TRUE(count == 0 || same_array(ids.data(), count, expected));
}

void expect_same_stars(const tetloft_mesh* mesh, const TetMesh& expected, std::uint32_t v) {
  expect_query(
      [&](auto* to, auto n, auto* count) { return tetloft_mesh_star(mesh, v, to, n, count); },
      expected.star(VertexId(v)));
  expect_query(
      [&](auto* to, auto n, auto* count) { return tetloft_mesh_link(mesh, v, to, n, count); },
      expected.link(VertexId(v)));
  tetloft_link_kind kind = TETLOFT_LINK_HOLES;
  ASSERT_OK(tetloft_mesh_link_kind(mesh, v, &kind));
  EXPECT_EQ(static_cast<int>(kind), static_cast<int>(expected.classify_link(VertexId(v))));
  for (std::uint32_t w = 0; w < v; ++w) {
    expect_query([&](auto* to, auto n,
                     auto* count) { return tetloft_mesh_edge_star(mesh, v, w, to, n, count); },
                 expected.star(VertexId(v), VertexId(w)));
    expect_query([&](auto* to, auto n,
                     auto* count) { return tetloft_mesh_edge_link(mesh, v, w, to, n, count); },
                 expected.link(VertexId(v), VertexId(w)));
    ASSERT_OK(tetloft_mesh_edge_link_kind(mesh, v, w, &kind));
    EXPECT_EQ(static_cast<int>(kind),
              static_cast<int>(expected.classify_link(VertexId(v), VertexId(w))));
  }
}

void expect_same_mesh(const tetloft_mesh* mesh, const TetMesh& expected) {
  std::size_t vertices = 0;
  std::size_t tets = 0;
  ASSERT_OK(tetloft_mesh_counts(mesh, &vertices, &tets));
  EXPECT_EQ(vertices, expected.vertex_count());
  EXPECT_EQ(tets, expected.tet_count());
  expect_array(tetloft_mesh_tets, mesh, expected.tets());
  expect_array(tetloft_mesh_opposites, mesh, expected.opposites());
  for (std::uint32_t v = 0; v < vertices; ++v) expect_same_stars(mesh, expected, v);
  std::vector<VertexId> singular;
  for (const auto& [v, kind] : expected.singular_vertices()) singular.push_back(v);
  expect_query([&](auto* to, auto n,
                   auto* count) { return tetloft_mesh_singular_vertices(mesh, to, n, count); },
               singular);
  expect_query(
      [&](auto* to, auto n, auto* count) { return tetloft_mesh_boundary(mesh, to, n, count); },
      expected.boundary());
}

TEST(MeshesOfC, AreThoseOfCpp) {
  // Three tets: two with a face in common, one at a vertex of theirs alone, which is singular; and
  // a vertex of no tet.
  const std::vector<std::uint32_t> ids{0, 1, 2, 3, 4, 1, 3, 2, 4, 5, 6, 7};
  std::vector<TetVertices> tets(3);
  for (std::size_t i = 0; i < ids.size(); ++i) tets[i / 4][i % 4] = VertexId(ids[i]);
  Owned<tetloft_mesh> mesh;
  ASSERT_OK(tetloft_mesh_create(9, ids.data(), 3, mesh.out()));
  const TetMesh expected = TetMesh::from_tets(9, tets).value();
  EXPECT_EQ(expected.singular_vertices().size(), 1U);
  expect_same_mesh(mesh, expected);
  EXPECT_EQ(tetloft_mesh_create(7, ids.data(), 3, mesh.out()), TETLOFT_INVALID_INPUT);
  EXPECT_STREQ(tetloft_last_error(), to_string(TetMesh::from_tets(7, tets).error()).c_str());
}

TEST(MeshesOfC, EndsOfEdgesAreTwoVerticesOfTheMesh) {
  const std::vector<std::uint32_t> ids{0, 1, 2, 3};
  Owned<tetloft_mesh> mesh;
  ASSERT_OK(tetloft_mesh_create(4, ids.data(), 1, mesh.out()));
  std::size_t count = 0;
  for (const auto& [a, b] : {std::pair{0U, 0U}, {0U, 4U}, {4U, 0U}, {0U, TETLOFT_NO_ID}}) {
    tetloft_link_kind kind = TETLOFT_LINK_DISC;
    EXPECT_EQ(tetloft_mesh_edge_star(mesh, a, b, nullptr, 0, &count), TETLOFT_USAGE);
    EXPECT_EQ(tetloft_mesh_edge_link(mesh, a, b, nullptr, 0, &count), TETLOFT_USAGE);
    EXPECT_EQ(tetloft_mesh_edge_link_kind(mesh, a, b, &kind), TETLOFT_USAGE);
  }
  for (const std::uint32_t v : {4U, TETLOFT_NO_ID}) {
    tetloft_link_kind kind = TETLOFT_LINK_DISC;
    EXPECT_EQ(tetloft_mesh_star(mesh, v, nullptr, 0, &count), TETLOFT_USAGE);
    EXPECT_EQ(tetloft_mesh_link(mesh, v, nullptr, 0, &count), TETLOFT_USAGE);
    EXPECT_EQ(tetloft_mesh_link_kind(mesh, v, &kind), TETLOFT_USAGE);
  }
}

TEST(DelaunayOfC, InSpaceIsThatOfCpp) {
  for (const std::size_t count : {0U, 1U, 4U, 40U}) {
    SCOPED_TRACE(count);
    const std::vector<Point3> points = lattice_points(count, 5);
    const Delaunay3 expected = delaunay3(points).value();
    std::vector<double> xyz;
    for (const Point3& p : points) xyz.insert(xyz.end(), {p.x, p.y, p.z});
    Owned<tetloft_mesh> mesh;
    int dimension = -7;
    std::vector<std::uint32_t> representative(count);
    ASSERT_OK(tetloft_delaunay3(xyz.data(), count, nullptr, mesh.out(), &dimension,
                                representative.data()));
    EXPECT_EQ(dimension, expected.dimension);
    EXPECT_TRUE(count == 0 ||
                same_array(representative.data(), count, expected.representative.raw()));
    expect_same_mesh(mesh, expected.mesh);
  }
  tetloft_delaunay3_options options;
  ASSERT_OK(tetloft_delaunay3_options_defaults(&options));
  options.engine = TETLOFT_ENGINE_SLAB;
  const std::vector<double> tet{0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1};
  Owned<tetloft_mesh> mesh;
  const std::vector<Point3> corners{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  const Error refused = delaunay3(corners, {.engine = DelaunayEngine::slab}).error();
  EXPECT_EQ(
      static_cast<int>(tetloft_delaunay3(tet.data(), 4, &options, mesh.out(), nullptr, nullptr)),
      static_cast<int>(refused.code));
  EXPECT_EQ(tetloft_last_error(), to_string(refused));
  options.engine = TETLOFT_ENGINE_AUTOMATIC;
  options.most_tets = 1;
  const std::vector<double> two{0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 3, 3, 3};
  EXPECT_EQ(tetloft_delaunay3(two.data(), 5, &options, mesh.out(), nullptr, nullptr),
            TETLOFT_WORK_LIMIT);
  const std::vector<double> infinite{0, 0, std::numeric_limits<double>::infinity()};
  EXPECT_EQ(tetloft_delaunay3(infinite.data(), 1, nullptr, mesh.out(), nullptr, nullptr),
            TETLOFT_INVALID_INPUT);
}

void expect_same_triangulation(const tetloft_triangulation* triangulation,
                               const Triangulation2& expected) {
  expect_array(tetloft_triangulation_points, triangulation, expected.points.raw());
  expect_array(tetloft_triangulation_triangles, triangulation, expected.triangles.raw());
  expect_array(tetloft_triangulation_neighbours, triangulation, expected.neighbours.raw());
}

TEST(DelaunayOfC, InThePlaneIsThatOfCpp) {
  std::vector<Point2> points;
  std::vector<double> xy;
  for (const Point3& p : lattice_points(30, 3)) {
    points.push_back({p.x, p.y});
    xy.insert(xy.end(), {p.x, p.y});
  }
  Owned<tetloft_triangulation> triangulation;
  ASSERT_OK(tetloft_delaunay2(xy.data(), points.size(), nullptr, triangulation.out()));
  expect_same_triangulation(triangulation, delaunay2(points).value());
  const std::vector<std::uint8_t> none;
  expect_array(tetloft_triangulation_internal, static_cast<tetloft_triangulation*>(triangulation),
               none);
  const std::uint32_t* chain = nullptr;
  std::size_t count = 0;
  EXPECT_EQ(tetloft_triangulation_chain(triangulation, 0, &chain, &count), TETLOFT_USAGE);
}

TEST(DelaunayOfC, WithSegmentsIsThatOfCpp) {
  const std::vector<double> xy{0, 0, 10, 0, 5, 0.25, 5, -0.25, 3, 4};
  const std::vector<std::uint32_t> ids{0, 1, 2, 4};
  std::vector<Point2> points;
  for (std::size_t i = 0; i < xy.size(); i += 2) points.push_back({xy[i], xy[i + 1]});
  const std::vector<Segment> segments{{PlaneVertexId(0), PlaneVertexId(1)},
                                      {PlaneVertexId(2), PlaneVertexId(4)}};
  const Conforming2 expected = conforming_delaunay2(points, segments).value();
  EXPECT_FALSE(expected.split.empty());
  Owned<tetloft_triangulation> triangulation;
  ASSERT_OK(tetloft_conforming_delaunay2(xy.data(), points.size(), ids.data(), 2, nullptr,
                                         triangulation.out()));
  expect_same_triangulation(triangulation, expected.triangulation);
  for (std::size_t s = 0; s < segments.size(); ++s) {
    const std::uint32_t* chain = nullptr;
    std::size_t count = 0;
    ASSERT_OK(tetloft_triangulation_chain(triangulation, s, &chain, &count));
    EXPECT_TRUE(same_array(chain, count, expected.chains[s]));
  }
  const std::vector<std::uint32_t> wrong{0, 5};
  EXPECT_EQ(tetloft_conforming_delaunay2(xy.data(), points.size(), wrong.data(), 1, nullptr,
                                         triangulation.out()),
            TETLOFT_INVALID_INPUT);
}

TEST(DelaunayOfC, OfASectionIsThatOfCpp) {
  const std::string path = TETLOFT_DATA_DIR "/cases/nested_hole.cnt";
  const SectionStack expected = read_stack(path).value().stack;
  Owned<tetloft_stack> stack;
  ASSERT_OK(tetloft_stack_read(path.c_str(), nullptr, stack.out(), nullptr));
  for (std::size_t s = 0; s < expected.sections.size(); ++s) {
    const ConformingSection section =
        conform(expected.sections[SectionId(s)], SectionId(s)).value();
    Owned<tetloft_triangulation> triangulation;
    ASSERT_OK(tetloft_stack_triangulate(stack, s, nullptr, triangulation.out()));
    expect_same_triangulation(triangulation, section.triangulation);
    expect_array(tetloft_triangulation_internal, static_cast<tetloft_triangulation*>(triangulation),
                 section.internal.raw());
  }
  Owned<tetloft_triangulation> none;
  EXPECT_EQ(tetloft_stack_triangulate(stack, expected.sections.size(), nullptr, none.out()),
            TETLOFT_USAGE);
}

TEST(DelaunayOfC, OfASectionWithoutContoursIsEmpty) {
  const double z = 3;
  const std::size_t none = 0;
  Owned<tetloft_stack> stack;
  ASSERT_OK(tetloft_stack_create(&z, &none, 1, nullptr, 0, nullptr, 0, stack.out()));
  Owned<tetloft_triangulation> triangulation;
  ASSERT_OK(tetloft_stack_triangulate(stack, 0, nullptr, triangulation.out()));
  expect_same_triangulation(triangulation, {});
}

TEST(PointsOfC, AreThoseOfCpp) {
  const test::TempFolder folder;
  const std::vector<Point3> points = lattice_points(20, 9);
  std::vector<double> xyz;
  for (const Point3& p : points) xyz.insert(xyz.end(), {p.x, p.y, p.z});
  for (const char* name : {"xyz", "bin"}) {
    const std::string path = folder.file(std::string("a.") + name);
    const std::string bytes = format_points(points, {.format = name}).value().bytes;
    ASSERT_OK(tetloft_points_write(xyz.data(), points.size(), path.c_str(), nullptr, nullptr));
    EXPECT_EQ(test::get(path), bytes);
    tetloft_write_options options;
    ASSERT_OK(tetloft_write_options_defaults(&options));
    options.format = name;
    Owned<tetloft_bytes> formatted;
    ASSERT_OK(tetloft_points_format(xyz.data(), points.size(), &options, formatted.out(), nullptr));
    EXPECT_EQ(bytes_of(formatted), bytes);
    Owned<tetloft_points> read;
    ASSERT_OK(tetloft_points_read(path.c_str(), nullptr, read.out(), nullptr));
    expect_array(tetloft_points_data, static_cast<tetloft_points*>(read), points);
    const std::string as = std::string("a.") + name;
    ASSERT_OK(
        tetloft_points_parse(bytes.data(), bytes.size(), as.c_str(), nullptr, read.out(), nullptr));
    expect_array(tetloft_points_data, static_cast<tetloft_points*>(read), points);
  }
}

}  // namespace
}  // namespace tetloft::c_test

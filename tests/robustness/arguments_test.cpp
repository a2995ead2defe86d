// Arguments that make no sense: refused at entry, with what is wrong.
#include <gtest/gtest.h>

#include <array>
#include <cstdint>
#include <functional>
#include <limits>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include <tetloft/tetloft.hpp>

#include "robustness/inputs.hpp"
#include "unit/io/io_support.hpp"

namespace tetloft::test {
namespace {

template <class T>
void expect_error(const Result<T>& result, ErrorCode code, const std::string& what) {
  ASSERT_FALSE(result.ok()) << what;
  EXPECT_EQ(result.error().code, code) << what << ": " << to_string(result.error());
  EXPECT_FALSE(result.error().message.empty()) << what;
}

// Numbers that are no enumerator, of an enumeration whose last is `last`.
template <class Enum>
std::vector<Enum> strangers(Enum last) {
  std::vector<Enum> result;
  for (const int more : {1, 2, 17, 100}) {
    result.push_back(static_cast<Enum>(static_cast<int>(last) + more));
  }
  result.push_back(static_cast<Enum>(static_cast<std::underlying_type_t<Enum>>(-1)));
  return result;
}

TEST(Enumerators, ThatThereAreNoneOfAreRefused) {
  const SectionStack stack = case_stack("fork");
  const Model model = model_of(stack);
  const std::vector<Point3> points = model.points.raw();
  for (const Criterion criterion : strangers(Criterion::moved)) {
    ReconstructOptions options;
    options.correspondence.criterion = criterion;
    expect_error(reconstruct(stack, options), ErrorCode::usage, "criterion");
    CheckOptions checked;
    checked.correspondence.criterion = criterion;
    expect_error(check(model, stack, checked), ErrorCode::usage, "criterion");
  }
  for (const Ends ends : strangers(Ends::half)) {
    expect_error(reconstruct(stack, {.ends = ends}), ErrorCode::usage, "ends");
  }
  for (const DelaunayEngine engine : strangers(DelaunayEngine::slab)) {
    expect_error(reconstruct(stack, {.delaunay = engine}), ErrorCode::usage, "engine");
    expect_error(delaunay3(points, {.engine = engine}), ErrorCode::usage, "engine");
  }
  for (const ColourBy colour : strangers(ColourBy::evidence)) {
    for (const auto render : {render_png, render_svg, render_html}) {
      expect_error(render(model, nullptr, {.colour = colour}), ErrorCode::usage, "colour");
    }
  }
  for (const Validity validity : strangers(Validity::unchecked)) {
    expect_error(parse_cnt("S 0", "name", validity), ErrorCode::usage, "validity");
    expect_error(read_cnt(case_path("fork"), validity), ErrorCode::usage, "validity");
  }
  const TempFolder folder;
  for (const Encoding encoding : strangers(Encoding::compressed)) {
    expect_error(write_vtu(folder.file("a.vtu"), model, encoding), ErrorCode::usage, "vtu");
    expect_error(write_vtu(folder.file("a.vtu"), points, model.tets.raw(), encoding),
                 ErrorCode::usage, "vtu");
    expect_error(write_surface(folder.file("a.ply"), model, encoding), ErrorCode::usage, "ply");
    expect_error(write_lines(folder.file("a.vtp"), {}, encoding), ErrorCode::usage, "lines");
  }
  EXPECT_TRUE(folder.names().empty());
  const ConformingSection section = conform(stack.sections[SectionId(0)], SectionId(0)).value();
  for (const EdgeKind kind : strangers(EdgeKind::contour)) {
    EXPECT_TRUE(voronoi_skeleton(section, kind).empty());
  }
}

TEST(CorrespondenceOptions, AreJudgedAlikeByAllWhoTakeThem) {
  const SectionStack stack = case_stack("fork");
  const Model model = model_of(stack);
  const auto expect_refused = [&](const CorrespondenceOptions& correspondence, ErrorCode code,
                                  const std::string& what) {
    expect_error(reconstruct(stack, {.correspondence = correspondence}), code, what);
    expect_error(check(model, stack, {.correspondence = correspondence}), code, what);
    expect_error(find_links(stack, {.correspondence = correspondence}), code, what);
    expect_error(between(stack, {.correspondence = correspondence}), code, what);
  };
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  for (const double ratio : {1.0, 1.0000001, 2.0, 1e300, kInfinity, -kInfinity, -1.0, -1e-300,
                             std::numeric_limits<double>::quiet_NaN()}) {
    expect_refused({.tau = ratio}, ErrorCode::usage, "tau " + std::to_string(ratio));
  }
  for (const double ratio : {0.0, -0.0, 0.5, 0x1.fffffffffffffp-1}) {
    EXPECT_TRUE(reconstruct(stack, {.correspondence = {.tau = ratio}})) << ratio;
    EXPECT_TRUE(check(model, stack, {.correspondence = {.tau = ratio}})) << ratio;
  }
  for (const double reach : {-1e-300, -1.0, kInfinity, std::numeric_limits<double>::quiet_NaN()}) {
    expect_refused({.voids = {.reach = reach}}, ErrorCode::usage, "reach");
  }
  for (const VoidRule rule : strangers(VoidRule::free)) {
    expect_refused({.voids = {.rule = rule}}, ErrorCode::usage, "rule of voids");
  }
  const Label of_hole{SectionId(0), ContourId(0), 1};
  expect_refused({.voids = {.rule = VoidRule::free, .labels = {of_hole}}}, ErrorCode::usage,
                 "labels of free voids");
  for (const Label& label :
       {Label{SectionId(2), ContourId(0), 1}, Label{SectionId(0), ContourId(1), 1},
        Label{SectionId(), ContourId(0), 1}, Label{SectionId(0), ContourId(), 1}}) {
    expect_refused({.labels = {label}}, ErrorCode::invalid_input, "label");
  }
  const SlabId slab(0);
  const ContourId none;
  for (const LinkDecision& decision :
       {LinkDecision{SlabId(1), ContourId(0), ContourId(0)}, LinkDecision{SlabId(), none, none},
        LinkDecision{slab, ContourId(1), ContourId(0)}, LinkDecision{slab, ContourId(0), none}}) {
    expect_refused({.decisions = {decision}}, ErrorCode::invalid_input, "decision");
  }
  const LinkDecision join{slab, ContourId(0), ContourId(0)};
  LinkDecision part = join;
  part.join = false;
  expect_refused({.decisions = {join, part}}, ErrorCode::invalid_input, "contradiction");
  const std::vector<Label> different{{SectionId(0), ContourId(0), 1},
                                     {SectionId(1), ContourId(0), 2}};
  expect_refused({.labels = different, .decisions = {join}}, ErrorCode::invalid_input,
                 "different labels joined");
}

// Everything that takes a model and can say what is wrong with it.
void expect_model_refused(const Model& model, const std::string& what) {
  const TempFolder folder;
  expect_error(write_vtu(folder.file("a.vtu"), model), ErrorCode::invalid_input, what);
  for (const char* name : {"a.obj", "a.ply", "a.vtp", "a.stl"}) {
    expect_error(write_surface(folder.file(name), model), ErrorCode::invalid_input, what);
  }
  EXPECT_TRUE(folder.names().empty()) << what;
  for (const auto render : {render_png, render_svg, render_html}) {
    expect_error(render(model, nullptr, {}), ErrorCode::invalid_input, what);
  }
}

TEST(Models, WithIdsThatThereAreNotAreRefusedByName) {
  const Model whole = model_of(case_stack("fork"));
  const TetId last(whole.tets.size() - 1);
  for (const TetId t : {TetId(0), TetId(whole.tets.size() / 2), last}) {
    Model without = whole;
    without.tets.raw().erase(without.tets.raw().begin() + static_cast<std::ptrdiff_t>(t.index()));
    for (std::size_t corner = 0; corner < 4; ++corner) {
      for (const VertexId stranger : {whole.points.end_id(), VertexId(whole.points.size() + 1000),
                                      VertexId(0x7FFFFFFFU), VertexId()}) {
        Model model = whole;
        model.tets[t][corner] = stranger;
        const std::string what = "tet " + std::to_string(t.value());
        expect_model_refused(model, what);
        const TempFolder folder;
        const std::string path = folder.file("a.vtu");
        const Result<void> written = write_vtu(path, model.points.raw(), model.tets.raw());
        expect_error(written, ErrorCode::invalid_input, what);
        EXPECT_NE(written.error().message.find(what), std::string::npos);
        EXPECT_EQ(written.error().where.file, path);
        expect_error(TetMesh::from_tets(model.points.size(), model.tets.raw()),
                     ErrorCode::invalid_input, what);
        EXPECT_EQ(boundary_surface(model).triangles, boundary_surface(without).triangles);
        EXPECT_EQ(volume(model), volume(without));
        EXPECT_FALSE(check(model, case_stack("fork")).value().guarantees[0].pass);
      }
    }
  }
}

TEST(Models, WithArraysThatDoNotFitAreRefused) {
  const Model whole = model_of(case_stack("fork"));
  const std::vector<std::pair<std::string, std::function<void(Model&, std::size_t)>>> resized{
      {"component", [](Model& m, std::size_t n) { m.component.resize(n); }},
      {"slab", [](Model& m, std::size_t n) { m.slab.resize(n); }},
      {"kind", [](Model& m, std::size_t n) { m.kind.resize(n); }},
      {"section", [](Model& m, std::size_t n) { m.section.resize(n); }},
      {"contour", [](Model& m, std::size_t n) { m.contour.resize(n); }},
      {"origin", [](Model& m, std::size_t n) { m.origin.resize(n); }}};
  for (const auto& [name, resize] : resized) {
    for (const std::size_t n : {std::size_t{1}, whole.tets.size() + whole.points.size()}) {
      Model model = whole;
      resize(model, n);
      expect_model_refused(model, name);
    }
  }
  for (const TetKind kind : strangers(TetKind::prism)) {
    Model model = whole;
    model.kind[TetId(1)] = kind;
    expect_model_refused(model, "kind");
  }
  for (const PointOrigin origin : strangers(PointOrigin::inserted)) {
    Model model = whole;
    model.origin[VertexId(1)] = origin;
    expect_model_refused(model, "origin");
  }
}

TEST(Contours, ThatCannotBeDrawnAreRefused) {
  const SectionStack stack = case_stack("fork");
  const Model model = model_of(stack);
  for (const double wrong :
       {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
    SectionStack drawn = stack;
    drawn.sections[SectionId(1)].contours[ContourId(0)].vertices[2].y = wrong;
    for (const auto render : {render_png, render_svg, render_html}) {
      expect_error(render(model, &drawn, {}), ErrorCode::invalid_input, "contours");
    }
  }
}

TEST(Planes, ThatAreNoTriangulationsAreRefused) {
  const SectionStack stack = tower(1);
  const Triangulation2 good =
      conform(stack.sections[SectionId(0)], SectionId(0)).value().triangulation;
  ASSERT_TRUE(slab_delaunay3(good, good));
  std::vector<Triangulation2> bad;
  const std::size_t triangles = good.triangles.size();
  for (std::size_t i = 0; i < 3; ++i) {
    for (const std::size_t id : {good.points.size(), std::size_t{0xFFFFFFFE}}) {
      bad.push_back(good);
      bad.back().triangles[TriangleId(1)][i] = PlaneVertexId(id);
    }
    for (const std::size_t id : {triangles, std::size_t{0}, triangles - 1}) {
      if (good.neighbours[TriangleId(2)][i] == TriangleId(id)) continue;
      bad.push_back(good);
      bad.back().neighbours[TriangleId(2)][i] = TriangleId(id);
    }
  }
  bad.push_back(good);
  bad.back().neighbours.resize(triangles - 1);
  bad.push_back(good);
  bad.back().triangles.resize(triangles - 1);
  bad.push_back(good);
  bad.back().points[PlaneVertexId(3)].x = std::numeric_limits<double>::quiet_NaN();
  for (const Triangulation2& plane : bad) {
    expect_error(slab_delaunay3(plane, good), ErrorCode::invalid_input, "lower");
    expect_error(slab_delaunay3(good, plane), ErrorCode::invalid_input, "upper");
  }
}

TEST(ErrorCodes, HaveNamesAndDistinctNumbers) {
  const std::vector<std::pair<ErrorCode, std::string>> codes{
      {ErrorCode::internal, "internal"},
      {ErrorCode::out_of_memory, "out_of_memory"},
      {ErrorCode::unfit_arithmetic, "unfit_arithmetic"}};
  for (const auto& [code, name] : codes) EXPECT_EQ(name_of(code), name);
  EXPECT_EQ(static_cast<int>(ErrorCode::out_of_memory), 71);
  EXPECT_EQ(static_cast<int>(ErrorCode::unfit_arithmetic), 72);
}

}  // namespace
}  // namespace tetloft::test

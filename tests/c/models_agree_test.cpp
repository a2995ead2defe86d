// Models, their boundaries, meshes and verdicts of C are those of C++, bit for bit.
#include <gtest/gtest.h>

#include <functional>

#include <tetloft/tetloft.hpp>

#include "c/owned.hpp"
#include "unit/io/io_support.hpp"

namespace tetloft::c_test {
namespace {

std::string sample(const std::string& name) { return TETLOFT_DATA_DIR "/" + name + ".cnt"; }

SectionStack stack_of(const std::string& name) { return read_stack(sample(name)).value().stack; }

void expect_same_model(const tetloft_model* model, const Model& expected) {
  expect_array(tetloft_model_points, model, expected.points.raw());
  expect_array(tetloft_model_tets, model, expected.tets.raw());
  expect_array(tetloft_model_tet_components, model, expected.component.raw());
  expect_array(tetloft_model_tet_slabs, model, expected.slab.raw());
  expect_array(tetloft_model_tet_kinds, model, expected.kind.raw());
  expect_array(tetloft_model_point_sections, model, expected.section.raw());
  expect_array(tetloft_model_point_contours, model, expected.contour.raw());
  expect_array(tetloft_model_point_origins, model, expected.origin.raw());
  std::size_t components = 0;
  EXPECT_OK(tetloft_model_component_count(model, &components));
  EXPECT_EQ(components, expected.component_count);
  double sum = 0;
  EXPECT_OK(tetloft_model_volume(model, &sum));
  EXPECT_EQ(test::bits(sum), test::bits(volume(expected)));
}

void expect_same_report(const tetloft_model* model, const ReconstructReport& expected) {
  tetloft_report report;
  report.version = TETLOFT_REPORT_VERSION;
  ASSERT_OK(tetloft_model_report(model, &report));
  EXPECT_EQ(report.slices, expected.slices);
  EXPECT_EQ(report.sections_between, expected.sections_between);
  EXPECT_EQ(report.sections_given_up, expected.sections_given_up);
  EXPECT_EQ(report.contours, expected.contours);
  EXPECT_EQ(report.input_vertices, expected.input_vertices);
  EXPECT_EQ(report.split_vertices, expected.split_vertices);
  EXPECT_EQ(report.dividing_vertices, expected.dividing_vertices);
  EXPECT_EQ(report.vertices, expected.vertices);
  EXPECT_EQ(report.tets, expected.tets);
  EXPECT_EQ(report.components, expected.components);
  EXPECT_EQ(report.volume, expected.volume);
  EXPECT_EQ(report.smallest_lift, expected.smallest_lift);
  EXPECT_EQ(report.work, expected.work);
  EXPECT_GT(report.seconds, 0);
}

void expect_same_surface(const tetloft_model* model, const Model& expected_model) {
  const Surface expected = boundary_surface(expected_model);
  const SurfaceComponents components = surface_components(expected.triangles);
  Owned<tetloft_surface> surface;
  ASSERT_OK(tetloft_model_boundary(model, surface.out()));
  expect_array(tetloft_surface_triangles, static_cast<tetloft_surface*>(surface),
               expected.triangles);
  expect_array(tetloft_surface_tets, static_cast<tetloft_surface*>(surface), expected.tet);
  const std::uint32_t* component = nullptr;
  std::size_t count = 0;
  std::size_t parts = 0;
  ASSERT_OK(tetloft_surface_components(surface, &component, &count, &parts));
  EXPECT_TRUE(same_array(component, count, components.component));
  ASSERT_EQ(parts, components.topology.size());
  for (std::size_t c = 0; c < parts; ++c) {
    std::size_t vertices = 0;
    std::size_t edges = 0;
    std::size_t triangles = 0;
    std::int64_t genus = -1;
    ASSERT_OK(tetloft_surface_topology(surface, c, &vertices, &edges, &triangles, &genus));
    EXPECT_EQ(vertices, components.topology[c].vertices);
    EXPECT_EQ(edges, components.topology[c].edges);
    EXPECT_EQ(triangles, components.topology[c].triangles);
    EXPECT_EQ(genus, components.topology[c].genus());
  }
  EXPECT_EQ(tetloft_surface_topology(surface, parts, nullptr, nullptr, nullptr, nullptr),
            TETLOFT_USAGE);
}

struct Case {
  const char* name;
  std::function<void(tetloft_reconstruct_options&)> of_c = [](auto&) {};
  std::function<void(ReconstructOptions&)> of_cpp = [](auto&) {};
};

std::vector<Case> cases() {
  return {
      {"torus"},
      {"cases/fork", [](auto& o) { o.ends = TETLOFT_ENDS_HALF; },
       [](auto& o) { o.ends = Ends::half; }},
      {"cases/ring", [](auto& o) { o.between = 2; }, [](auto& o) { o.between = 2; }},
      {"cases/loft", [](auto& o) { o.divide_coarse = 0, o.engine = TETLOFT_ENGINE_INCREMENTAL; },
       [](auto& o) { o.divide_coarse = false, o.delaunay = DelaunayEngine::incremental; }},
      {"cases/nested_hole", [](auto& o) { o.between = 0; }, [](auto& o) { o.between = 0; }},
  };
}

TEST(ModelsOfC, AreReconstructedAsByCpp) {
  for (const Case& c : cases()) {
    SCOPED_TRACE(c.name);
    ReconstructOptions expected_options;
    c.of_cpp(expected_options);
    const Reconstruction expected = reconstruct(stack_of(c.name), expected_options).value();
    Owned<tetloft_stack> stack;
    ASSERT_OK(tetloft_stack_read(sample(c.name).c_str(), nullptr, stack.out(), nullptr));
    tetloft_reconstruct_options options;
    ASSERT_OK(tetloft_reconstruct_options_defaults(&options));
    c.of_c(options);
    Owned<tetloft_model> model;
    Owned<tetloft_warnings> warnings;
    ASSERT_OK(tetloft_reconstruct(stack, &options, model.out(), warnings.out()));
    std::size_t count = 0;
    ASSERT_OK(tetloft_warnings_count(warnings, &count));
    EXPECT_EQ(count, expected.warnings.size());
    expect_same_model(model, expected.model);
    expect_same_report(model, expected.report);
    expect_same_surface(model, expected.model);
  }
}

TEST(ModelsOfC, NullOptionsAreTheDefaults) {
  const Model expected = reconstruct(stack_of("cases/fork")).value().model;
  Owned<tetloft_stack> stack;
  ASSERT_OK(tetloft_stack_read(sample("cases/fork").c_str(), nullptr, stack.out(), nullptr));
  Owned<tetloft_model> model;
  ASSERT_OK(tetloft_reconstruct(stack, nullptr, model.out(), nullptr));
  expect_same_model(model, expected);
  tetloft_reconstruct_options options;
  ASSERT_OK(tetloft_reconstruct_options_defaults(&options));
  tetloft_correspondence correspondence;
  ASSERT_OK(tetloft_correspondence_defaults(&correspondence));
  options.correspondence = &correspondence;
  ASSERT_OK(tetloft_reconstruct(stack, &options, model.out(), nullptr));
  expect_same_model(model, expected);
}

TEST(ModelsOfC, SectionsBetweenAreThoseOfCpp) {
  const LongStack expected = between(stack_of("cases/ring"), {.sections = 1}).value();
  Owned<tetloft_stack> stack;
  ASSERT_OK(tetloft_stack_read(sample("cases/ring").c_str(), nullptr, stack.out(), nullptr));
  tetloft_reconstruct_options options;
  ASSERT_OK(tetloft_reconstruct_options_defaults(&options));
  options.between = 1;
  Owned<tetloft_stack> longer;
  Owned<tetloft_labels> decisions;
  ASSERT_OK(tetloft_between(stack, &options, longer.out(), decisions.out(), nullptr));
  tetloft_write_options cnt;
  ASSERT_OK(tetloft_write_options_defaults(&cnt));
  cnt.format = "cnt";
  Owned<tetloft_bytes> bytes;
  ASSERT_OK(tetloft_stack_format(longer, &cnt, bytes.out(), nullptr));
  EXPECT_EQ(bytes_of(bytes), format_cnt(expected.stack).value());
  ASSERT_OK(tetloft_labels_format(decisions, bytes.out()));
  const CorrespondenceOptions& told = expected.correspondence;
  EXPECT_EQ(bytes_of(bytes), format_labels({.labels = told.labels,
                                            .decisions = told.decisions,
                                            .hole_labels = told.voids.labels,
                                            .void_decisions = told.voids.decisions})
                                 .value());
  EXPECT_GT(expected.stack.sections.size(), 2U);
}

TEST(ModelsOfC, AreWrittenAndReadAsByCpp) {
  const test::TempFolder folder;
  const Model expected = reconstruct(stack_of("cases/fork")).value().model;
  Owned<tetloft_stack> stack;
  Owned<tetloft_model> model;
  ASSERT_OK(tetloft_stack_read(sample("cases/fork").c_str(), nullptr, stack.out(), nullptr));
  ASSERT_OK(tetloft_reconstruct(stack, nullptr, model.out(), nullptr));
  tetloft_write_options options;
  ASSERT_OK(tetloft_write_options_defaults(&options));
  for (const Encoding encoding : {Encoding::binary, Encoding::ascii}) {
    options.ascii = encoding == Encoding::ascii ? 1 : 0;
    options.format = nullptr;
    const std::string path = folder.file("a.vtu");
    ASSERT_OK(tetloft_model_write(model, path.c_str(), &options, nullptr));
    const std::string bytes = format_vtu(expected, encoding).value();
    EXPECT_EQ(test::get(path), bytes);
    Owned<tetloft_model> read;
    ASSERT_OK(tetloft_model_read(path.c_str(), nullptr, read.out(), nullptr));
    expect_same_model(read, expected);
    tetloft_report report;
    report.version = TETLOFT_REPORT_VERSION;
    EXPECT_EQ(tetloft_model_report(read, &report), TETLOFT_USAGE);
    ASSERT_OK(
        tetloft_model_parse(bytes.data(), bytes.size(), "a.vtu", nullptr, read.out(), nullptr));
    expect_same_model(read, expected);
    options.format = "vtu";
    Owned<tetloft_bytes> formatted;
    ASSERT_OK(tetloft_model_format(model, &options, formatted.out(), nullptr));
    EXPECT_EQ(bytes_of(formatted), bytes);
  }
  for (const char* name : {"obj", "ply", "stl", "vtp"}) {
    const Formatted surface = format_surface(expected, {.format = name}).value();
    const std::string path = folder.file(std::string("a.") + name);
    Owned<tetloft_warnings> warnings;
    ASSERT_OK(tetloft_model_write_surface(model, path.c_str(), nullptr, warnings.out()));
    EXPECT_EQ(test::get(path), surface.bytes) << name;
    EXPECT_EQ(texts_of(warnings).size(), surface.warnings.size()) << name;
    ASSERT_OK(tetloft_write_options_defaults(&options));
    options.format = name;
    Owned<tetloft_bytes> formatted;
    ASSERT_OK(tetloft_model_format_surface(model, &options, formatted.out(), nullptr));
    EXPECT_EQ(bytes_of(formatted), surface.bytes) << name;
  }
}

TEST(ModelsOfC, AreDrawnAsByCpp) {
  const test::TempFolder folder;
  const SectionStack sections = stack_of("cases/fork");
  const Model expected = reconstruct(sections).value().model;
  Owned<tetloft_stack> stack;
  Owned<tetloft_model> model;
  ASSERT_OK(tetloft_stack_read(sample("cases/fork").c_str(), nullptr, stack.out(), nullptr));
  ASSERT_OK(tetloft_reconstruct(stack, nullptr, model.out(), nullptr));
  const RenderOptions cut{.colour = ColourBy::kind,
                          .azimuth = 20,
                          .elevation = 30,
                          .width = 200,
                          .height = 100,
                          .cut = PictureCut{2, 0.5},
                          .explode = 0.25,
                          .edges = true,
                          .stretch = 2,
                          .white = true,
                          .title = "A title"};
  tetloft_render_options options;
  ASSERT_OK(tetloft_render_options_defaults(&options));
  const std::string png = folder.file("a.PNG");
  options.width = 60;
  options.height = 40;
  ASSERT_OK(tetloft_model_render(model, nullptr, png.c_str(), &options));
  EXPECT_EQ(test::get(png), render_png(expected, nullptr, {.width = 60, .height = 40}).value());
  options.colour = TETLOFT_COLOUR_KIND;
  options.azimuth = 20;
  options.elevation = 30;
  options.width = 200;
  options.height = 100;
  options.cut_axis = 2;
  options.cut_position = 0.5;
  options.explode = 0.25;
  options.edges = 1;
  options.stretch = 2;
  options.white = 1;
  options.title = "A title";
  const std::string svg = folder.file("a.svg");
  ASSERT_OK(tetloft_model_render(model, stack, svg.c_str(), &options));
  EXPECT_EQ(test::get(svg), render_svg(expected, &sections, cut).value());
  const std::string html = folder.file("a.html");
  ASSERT_OK(tetloft_model_render(model, stack, html.c_str(), &options));
  EXPECT_EQ(test::get(html), render_html(expected, &sections, cut).value());
  EXPECT_EQ(tetloft_model_render(model, stack, folder.file("a.gif").c_str(), &options),
            TETLOFT_USAGE);
}

void expect_same_verdict(const tetloft_verdict* verdict, const CheckReport& expected) {
  int pass = -1;
  ASSERT_OK(tetloft_verdict_pass(verdict, &pass));
  EXPECT_EQ(pass, expected.pass() ? 1 : 0);
  for (const GuaranteeVerdict& guarantee : expected.guarantees) {
    const char* name = nullptr;
    const char* not_asked = nullptr;
    std::size_t failures = 0;
    ASSERT_OK(
        tetloft_verdict_guarantee(verdict, guarantee.number, &name, &pass, &not_asked, &failures));
    EXPECT_EQ(name, guarantee.name);
    EXPECT_EQ(not_asked, guarantee.not_asked);
    EXPECT_EQ(pass, guarantee.pass ? 1 : 0);
    ASSERT_EQ(failures, guarantee.failures.size());
    for (std::size_t f = 0; f < failures; ++f) {
      const CheckFailure& failure = guarantee.failures[f];
      const char* what = nullptr;
      std::size_t count = 0;
      std::size_t places = 0;
      ASSERT_OK(tetloft_verdict_failure(verdict, guarantee.number, f, &what, &count, &places));
      EXPECT_EQ(what, failure.what);
      EXPECT_EQ(count, failure.count);
      ASSERT_EQ(places, failure.places.size());
      for (std::size_t p = 0; p < places; ++p) {
        const char* text = nullptr;
        ASSERT_OK(tetloft_verdict_place(verdict, guarantee.number, f, p, &text));
        EXPECT_EQ(text, failure.places[p]);
      }
    }
  }
  EXPECT_EQ(tetloft_verdict_guarantee(verdict, 0, nullptr, nullptr, nullptr, nullptr),
            TETLOFT_USAGE);
  EXPECT_EQ(tetloft_verdict_guarantee(verdict, 6, nullptr, nullptr, nullptr, nullptr),
            TETLOFT_USAGE);
  const std::vector<std::int64_t> genus(expected.genus.begin(), expected.genus.end());
  expect_array(tetloft_verdict_genus, verdict, genus);
  tetloft_figures figures;
  figures.version = TETLOFT_FIGURES_VERSION;
  ASSERT_OK(tetloft_verdict_figures(verdict, &figures));
  EXPECT_EQ(figures.components, expected.components);
  EXPECT_EQ(figures.volume, expected.volume);
  EXPECT_EQ(figures.overshoot, expected.overshoot);
  EXPECT_EQ(figures.smallest_dihedral_degrees, expected.smallest_dihedral_degrees);
  EXPECT_EQ(figures.largest_split_ulps, expected.largest_split_ulps);
  EXPECT_EQ(figures.inner_vertices, expected.inner_vertices);
  EXPECT_EQ(figures.dropped_links, expected.dropped_links);
  const auto known = [](const auto& value, std::int64_t none) {
    return value ? static_cast<std::int64_t>(*value) : none;
  };
  EXPECT_EQ(figures.cavities, known(expected.cavities, -1));
  EXPECT_EQ(figures.expected_cavities, known(expected.expected_cavities, -1));
  EXPECT_EQ(figures.least_genus, known(expected.least_genus, INT64_MIN));
  EXPECT_EQ(figures.most_genus, known(expected.most_genus, INT64_MIN));
  EXPECT_EQ(figures.deviations, expected.deviations);
  EXPECT_EQ(figures.forced_voids, expected.forced_voids);
  EXPECT_EQ(figures.unrealisable_voids, expected.unrealisable_voids);
}

TEST(VerdictsOfC, AreThoseOfCpp) {
  const SectionStack sections = stack_of("cases/fork");
  const Model whole = reconstruct(sections).value().model;
  Owned<tetloft_stack> stack;
  ASSERT_OK(tetloft_stack_read(sample("cases/fork").c_str(), nullptr, stack.out(), nullptr));
  std::vector<double> xyz;
  for (const Point3& p : whole.points) xyz.insert(xyz.end(), {p.x, p.y, p.z});
  std::vector<std::uint32_t> tets;
  for (const TetVertices& tet : whole.tets) {
    for (const VertexId v : tet) tets.push_back(v.value());
  }
  for (const std::size_t missing : {0U, 1U, 7U}) {
    SCOPED_TRACE(missing);
    Model expected;
    expected.points = whole.points;
    expected.tets.raw().assign(whole.tets.begin(),
                               whole.tets.end() - static_cast<std::ptrdiff_t>(missing));
    Owned<tetloft_model> model;
    ASSERT_OK(tetloft_model_create(xyz.data(), xyz.size() / 3, tets.data(),
                                   tets.size() / 4 - missing, model.out()));
    expect_same_model(model, expected);
    tetloft_check_options options;
    ASSERT_OK(tetloft_check_options_defaults(&options));
    options.places = 2;
    options.strict = 1;
    Owned<tetloft_verdict> verdict;
    ASSERT_OK(tetloft_check(model, stack, &options, verdict.out()));
    const CheckReport report = check(expected, sections, {.places = 2, .strict = true}).value();
    EXPECT_EQ(report.pass(), missing < 7);
    expect_same_verdict(verdict, report);
    ASSERT_OK(tetloft_check(model, stack, nullptr, verdict.out()));
    expect_same_verdict(verdict, check(expected, sections).value());
  }
}

}  // namespace
}  // namespace tetloft::c_test

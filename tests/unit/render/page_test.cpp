// The viewer's page: what it holds, where that lies, and what no name in it can break.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include <tetloft/render.hpp>

#include "unit/render/boxes.hpp"
#include "unit/render/page_arrays.hpp"

namespace tetloft {
namespace {

using test::array_of;
using test::boxes;
using test::JsonValue;
using test::page_header;

TEST(Page, HoldsTheModelAndRefersToNothingOutside) {
  Model model = boxes(2, 2);
  RenderOptions options;
  options.title = "a </script> <b>";
  const auto page = render_html(model, nullptr, options);
  ASSERT_TRUE(page);
  const auto points = array_of<float>(*page, "0-points");
  const auto tets = array_of<std::uint32_t>(*page, "0-tets");
  const auto boundary = array_of<std::uint32_t>(*page, "0-boundary");
  ASSERT_EQ(points.size(), 3 * model.points.size());
  ASSERT_EQ(tets.size(), 4 * model.tets.size());
  // Volume and area, in the page's units of half the diagonal of 7 × 2 × 6.
  const double unit = std::sqrt(49.0 + 4 + 36) / 2;
  const auto coordinate = [&](std::size_t v, std::size_t k) {
    return unit * static_cast<double>(points[3 * v + k]);
  };
  double volume = 0;
  for (std::size_t t = 0; t < tets.size(); t += 4) {
    std::array<std::array<double, 3>, 3> d{};
    for (std::size_t i = 0; i < 3; ++i) {
      for (std::size_t k = 0; k < 3; ++k) {
        d[i][k] = coordinate(tets[t + i + 1], k) - coordinate(tets[t], k);
      }
    }
    volume += (d[0][0] * (d[1][1] * d[2][2] - d[1][2] * d[2][1]) -
               d[0][1] * (d[1][0] * d[2][2] - d[1][2] * d[2][0]) +
               d[0][2] * (d[1][0] * d[2][1] - d[1][1] * d[2][0])) /
              6;
  }
  EXPECT_NEAR(volume, 2 * 2 * 2 * 6, 1e-4);
  EXPECT_EQ(boundary.size(), 2U * (4 * 4 + 4));
  EXPECT_EQ(array_of<std::uint32_t>(*page, "0-walls").size(), 2U * 2 * 2);
  EXPECT_EQ(array_of<std::int8_t>(*page, "0-normals").size(), 9 * boundary.size());
  EXPECT_EQ(array_of<std::uint32_t>(*page, "0-component").size(), model.tets.size());
  EXPECT_EQ(array_of<float>(*page, "0-contours").size(), 6U * 2 * 3 * 4);
  for (const char* outside : {"http://", "https://", "src=", "url(", "import "}) {
    std::string searched = *page;
    // The name of a standard, not a reference.
    const std::string name = "http://www.w3.org/2000/svg";
    for (std::size_t at; (at = searched.find(name)) != std::string::npos;) {
      searched.erase(at, name.size());
    }
    EXPECT_EQ(searched.find(outside), std::string::npos) << outside;
  }
  EXPECT_EQ(page->find("<b>"), std::string::npos);
}

TEST(Page, IsTheSameAtEveryScale) {
  const auto points = [](int exponent) {
    Model model = boxes(2, 2);
    for (Point3& p : model.points) {
      p = {std::ldexp(p.x, exponent), std::ldexp(p.y, exponent), std::ldexp(p.z, exponent)};
    }
    const auto page = render_html(model, nullptr);
    EXPECT_TRUE(page);
    return array_of<float>(*page, "0-points");
  };
  const std::vector<float> expected = points(0);
  for (const int exponent : {-900, -300, 70, 900}) EXPECT_EQ(points(exponent), expected);
}

TEST(Page, NoNameEndsAScriptOrIsLost) {
  const std::string name = "</script><b>\"quoted\" \\ 'Z\xc3\xa4hne' & \xe6\xad\xaf\n<!--";
  Model model = boxes(1, 3);
  model.about = {"body " + name, "m\"m", "LPS"};
  for (const std::string& each : {name, std::string(), std::string("\xff<")})
    model.component_names.push_back(each);
  RenderOptions options;
  options.title = name;
  const NamedModel named{&model, ""};
  const auto page = render_html({&named, 1}, nullptr, options);
  ASSERT_TRUE(page);
  EXPECT_EQ(page->find("<b>"), std::string::npos);
  EXPECT_EQ(page->find("<!--"), std::string::npos);
  const std::string as_json = R"(\u003c/script>\u003cb>\"quoted\" \\ 'Zähne' & 歯\u000a\u003c!--)";
  const auto says = [&](const std::string& text) { return page->find(text) != std::string::npos; };
  EXPECT_TRUE(says("\"title\":\"" + as_json + '"'));
  EXPECT_TRUE(says("\"name\":\"body " + as_json + '"'));
  EXPECT_TRUE(says("\"unit\":\"m\\\"m\""));
  EXPECT_TRUE(says("\"orientation\":\"LPS\""));
  const std::string middle = component_name(model, ComponentId(1));
  EXPECT_NE(middle.find(" 2"), std::string::npos);
  EXPECT_TRUE(says("\"components\":[\"" + as_json + "\",\"body " + as_json +
                   " 2\",\"\xef\xbf\xbd\\u003c\"]"));
}

// Components are told by the numbers that the model has for them, whichever of them there are.
TEST(Page, ComponentsKeepTheirNamesWhereNumbersAreLeftOut) {
  Model model = boxes(1, 2);
  for (ComponentId& c : model.component) c = ComponentId(c == ComponentId(0) ? 2U : 5U);
  model.component_count = 6;
  for (const char* each : {"a", "b", "c", "d", "e", "f"}) model.component_names.push_back(each);
  const auto page = render_html(model, nullptr);
  ASSERT_TRUE(page);
  const JsonValue header = page_header(*page);
  const auto& names = header.at("models").array.at(0).at("components").array;
  ASSERT_EQ(names.size(), 2U);
  EXPECT_EQ(names[0].string, "c");
  EXPECT_EQ(names[1].string, "f");
}

Point3 mapped(const JsonValue& map, const std::array<double, 3>& p) {
  std::array<double, 3> q{};
  for (std::size_t i = 0; i < 3; ++i) {
    q[i] = map.array.at(9 + i).number;
    for (std::size_t k = 0; k < 3; ++k) q[i] += p[k] * map.array.at(3 * k + i).number;
  }
  return {q[0], q[1], q[2]};
}

double distance(const Point3& a, const Point3& b) {
  return std::hypot(std::hypot(a.x - b.x, a.y - b.y), a.z - b.z);
}

// Sagittal, with coordinates exchanged; oblique; sheared.
std::vector<Frame> some_frames() {
  const double c = std::cos(0.4), s = std::sin(0.4);
  return {Frame{},
          {{Point3{0, 1, 0}, Point3{0, 0, 1}, Point3{1, 0, 0}}, {-30, 10, 1000}},
          {{Point3{c, 0, -s}, Point3{0, 1, 0}, Point3{s, 0, c}}, {5, -6, 7}},
          {{Point3{2, 0, 0}, Point3{0.5, 1, 0}, Point3{0, 0.25, 3}}, {0, 0, 0}}};
}

TEST(Page, ModelsLieAsInTheirFilesInOneSpace) {
  std::vector<Model> models;
  std::vector<NamedModel> named;
  for (const Frame& frame : some_frames()) {
    models.push_back(boxes(2, 2));
    models.back().frame = frame;
  }
  for (const Model& model : models) named.push_back({&model, "frame"});
  for (const double stretch : {1.0, 2.5}) {
    RenderOptions options;
    options.stretch = stretch;
    const auto page = render_html(named, nullptr, options);
    ASSERT_TRUE(page);
    const JsonValue header = page_header(*page);
    const double length = header.at("length").number;
    std::vector<Point3> shown, expected;
    for (std::size_t m = 0; m < models.size(); ++m) {
      const JsonValue& told = header.at("models").array.at(m);
      const auto own = array_of<float>(*page, std::to_string(m) + "-points");
      ASSERT_EQ(own.size(), 3 * models[m].points.size());
      for (std::size_t v = 0; v < models[m].points.size(); ++v) {
        const std::array<double, 3> p{own[3 * v], own[3 * v + 1], own[3 * v + 2]};
        Point3 stack = models[m].points[VertexId(v)];
        EXPECT_LT(distance(mapped(told.at("file"), p), place(models[m].frame, stack)), 1e-3);
        EXPECT_NEAR(
            told.at("stackZ").array.at(0).number + p[2] * told.at("stackZ").array.at(1).number,
            stack.z, 1e-3);
        shown.push_back(mapped(told.at("place"), p));
        stack.z *= stretch;
        expected.push_back(place(models[m].frame, stack));
      }
    }
    // The page's space is the file's but for a shift and a scale, the same for all models.
    for (std::size_t k = 0; k < shown.size(); ++k) {
      EXPECT_LT(std::abs(shown[k].x) + std::abs(shown[k].y) + std::abs(shown[k].z), 1.8);
      EXPECT_NEAR(length * (shown[k].x - shown[0].x), expected[k].x - expected[0].x, 2e-3);
      EXPECT_NEAR(length * (shown[k].y - shown[0].y), expected[k].y - expected[0].y, 2e-3);
      EXPECT_NEAR(length * (shown[k].z - shown[0].z), expected[k].z - expected[0].z, 2e-3);
    }
  }
}

TEST(Page, TellsVolumesOfTheFile) {
  for (const Frame& frame : some_frames()) {
    Model model = boxes(2, 2);
    model.frame = frame;
    for (const double stretch : {1.0, 4.0}) {
      RenderOptions options;
      options.stretch = stretch;
      const auto page = render_html(model, nullptr, options);
      ASSERT_TRUE(page);
      const JsonValue header = page_header(*page);
      for (const JsonValue& volume : header.at("models").array.at(0).at("volumes").array) {
        EXPECT_NEAR(volume.number, 2 * 2 * 6 * volume_factor(frame), 1e-9);
      }
    }
  }
}

TEST(Page, UnitAndOrientationAreThoseOfTheFirstModelThatHasAny) {
  Model bare = boxes(1), told = boxes(1);
  told.about = {"", "mm", "RAS"};
  const std::array named{NamedModel{&bare, ""}, NamedModel{&told, ""}};
  const auto page = render_html(named, nullptr);
  ASSERT_TRUE(page);
  const JsonValue header = page_header(*page);
  EXPECT_EQ(header.at("unit").string, "mm");
  EXPECT_EQ(header.at("orientation").string, "RAS");
  EXPECT_EQ(header.at("models").array.at(0).at("name").string, "model 1");
  EXPECT_EQ(header.at("models").array.at(1).at("name").string, "model 2");
}

TEST(Page, RefusesNoModelNullAndNamesTheOneThatCannotBeShown) {
  EXPECT_EQ(render_html(std::span<const NamedModel>{}, nullptr).error().code, ErrorCode::usage);
  const NamedModel none{};
  EXPECT_EQ(render_html({&none, 1}, nullptr).error().code, ErrorCode::usage);
  const Model whole = boxes(1), empty;
  const std::array named{NamedModel{&whole, "whole"}, NamedModel{&empty, "the \"empty\""}};
  const auto page = render_html(named, nullptr);
  ASSERT_FALSE(page);
  EXPECT_EQ(page.error().code, ErrorCode::invalid_input);
  EXPECT_NE(page.error().message.find("empty"), std::string::npos);
}

}  // namespace
}  // namespace tetloft

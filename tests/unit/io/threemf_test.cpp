// .3mf, unzipped and parsed by readers of the tests' own.
#include <gtest/gtest.h>

#include <array>
#include <cstdlib>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include <tetloft/formats.hpp>

#include "io/surface.hpp"
#include "support/box_models.hpp"
#include "unit/io/io_support.hpp"
#include "unit/io/zip_reader.hpp"

namespace tetloft {

using namespace internal;

namespace {

// Text of XML as it was before it was escaped.
std::string unescaped(std::string text) {
  for (const auto& [escape, plain] :
       std::vector<std::pair<std::string, std::string>>{{"&lt;", "<"},
                                                        {"&gt;", ">"},
                                                        {"&quot;", "\""},
                                                        {"&#9;", "\t"},
                                                        {"&#10;", "\n"},
                                                        {"&amp;", "&"}}) {
    for (std::size_t at = 0; (at = text.find(escape, at)) != std::string::npos;
         at += plain.size()) {
      text.replace(at, escape.size(), plain);
    }
  }
  return text;
}

struct Tag {
  std::string name;
  std::map<std::string, std::string> attributes;
  std::string text;  // up to the next tag
};

std::vector<Tag> tags_of(const std::string& xml) {
  std::vector<Tag> tags;
  for (std::size_t at = 0; (at = xml.find('<', at)) != std::string::npos;) {
    const std::size_t end = xml.find('>', at);
    Tag tag;
    tag.name = xml.substr(at + 1, xml.find_first_of(" />\n", at + 2) - at - 1);
    for (std::size_t quote = at; (quote = xml.find("=\"", quote)) < end;) {
      const std::size_t from = xml.find_last_of(' ', quote) + 1;
      const std::size_t close = xml.find('"', quote + 2);
      tag.attributes[xml.substr(from, quote - from)] =
          unescaped(xml.substr(quote + 2, close - quote - 2));
      quote = close;
    }
    at = xml.find('<', end);
    tag.text = unescaped(xml.substr(end + 1, at == std::string::npos ? at : at - end - 1));
    tags.push_back(std::move(tag));
  }
  return tags;
}

double number(const std::string& digits) { return std::strtod(digits.c_str(), nullptr); }

struct Object {
  std::string name, colour;
  std::vector<Point3> points;
  std::vector<std::array<std::size_t, 3>> triangles;
};

struct Document {
  std::string unit;
  std::map<std::string, std::string> metadata;
  std::vector<Object> objects;  // that are built
};

Document parse_document(const std::string& bytes) {
  const auto archive = test::read_zip(bytes);
  EXPECT_TRUE(archive);
  if (!archive) return {};
  EXPECT_EQ(archive->names,
            (std::vector<std::string>{"[Content_Types].xml", "_rels/.rels", "3D/3dmodel.model"}));
  EXPECT_NE(archive->files.at("_rels/.rels").bytes.find("Target=\"/3D/3dmodel.model\""),
            std::string::npos);
  Document document;
  std::vector<std::pair<std::string, std::string>> materials;
  std::map<std::string, Object> objects;
  std::string id;
  for (const Tag& tag : tags_of(archive->files.at("3D/3dmodel.model").bytes)) {
    const auto& get = [&](const char* name) { return tag.attributes.at(name); };
    if (tag.name == "model") document.unit = get("unit");
    if (tag.name == "metadata") document.metadata[get("name")] = tag.text;
    if (tag.name == "base") materials.emplace_back(get("name"), get("displaycolor"));
    if (tag.name == "object") {
      id = get("id");
      EXPECT_EQ(get("pid"), "1");
      EXPECT_EQ(get("type"), "model");
      const auto& [name, colour] = materials.at(std::stoul(get("pindex")));
      EXPECT_EQ(get("name"), name);
      EXPECT_TRUE(objects.insert({id, {name, colour, {}, {}}}).second);
    }
    if (tag.name == "vertex") {
      objects.at(id).points.push_back({number(get("x")), number(get("y")), number(get("z"))});
    }
    if (tag.name == "triangle") {
      objects.at(id).triangles.push_back(
          {std::stoul(get("v1")), std::stoul(get("v2")), std::stoul(get("v3"))});
    }
    if (tag.name == "item") document.objects.push_back(objects.at(get("objectid")));
  }
  EXPECT_EQ(document.objects.size(), objects.size());
  return document;
}

Document written(const Model& model, std::vector<Warning>* warnings = nullptr) {
  const auto made = format_surface(model, {.format = "3mf"});
  EXPECT_TRUE(made.ok()) << to_string(made.error());
  if (!made) return {};
  if (warnings != nullptr) {
    *warnings = made->warnings;
  } else {
    EXPECT_TRUE(made->warnings.empty());
  }
  return parse_document(made->bytes);
}

double volume_of(const Object& object) {
  double sum = 0;
  const Point3& o = object.points.at(0);
  for (const auto& t : object.triangles) {
    std::array<std::array<double, 3>, 3> m{};
    for (std::size_t i = 0; i < 3; ++i) {
      const Point3& p = object.points.at(t[i]);
      m[i] = {p.x - o.x, p.y - o.y, p.z - o.z};
    }
    sum += m[0][0] * (m[1][1] * m[2][2] - m[1][2] * m[2][1]) +
           m[0][1] * (m[1][2] * m[2][0] - m[1][0] * m[2][2]) +
           m[0][2] * (m[1][0] * m[2][1] - m[1][1] * m[2][0]);
  }
  return sum / 6;
}

TEST(Write3mf, KeepsComponentsNamesUnitAndPlace) {
  const Model model = testing::boxes_in_a_patient();
  const Document document = written(model);
  EXPECT_EQ(document.unit, "millimeter");
  EXPECT_EQ(document.metadata.at("Title"), testing::kHardNames[0]);
  EXPECT_EQ(document.metadata.at("Application"), "tetloft");
  EXPECT_EQ(document.metadata.at("Description"), "unit: mm; orientation: LPS");
  ASSERT_EQ(document.objects.size(), 3U);
  EXPECT_EQ(document.objects[0].name, testing::kHardNames[1]);
  EXPECT_EQ(document.objects[1].name, "two\\x0alines\\x09\\x01 #1, 100%");
  EXPECT_EQ(document.objects[2].name, testing::kHardNames[0] + " 4");
  EXPECT_NE(document.objects[0].colour, document.objects[1].colour);
  const std::array<double, 3> volumes{6, 24, 0.125};
  const std::array<std::size_t, 3> first{8, 0, 16};  // vertices of the model
  for (std::size_t k = 0; k < 3; ++k) {
    const Object& object = document.objects[k];
    ASSERT_EQ(object.points.size(), 8U);
    EXPECT_EQ(object.triangles.size(), 12U);
    EXPECT_NEAR(volume_of(object), volumes[k], 1e-9);
    for (std::size_t v = 0; v < 8; ++v) {
      EXPECT_TRUE(test::same_bits(object.points[v],
                                  place(model.frame, model.points[VertexId(first[k] + v)])));
    }
  }
}

TEST(Write3mf, KnowsUnits) {
  Model model;
  testing::add_box(model, 0, {-1, -1, -1}, {1, 1, 1});
  EXPECT_EQ(written(model).unit, "millimeter");
  EXPECT_EQ(written(model).metadata.count("Title"), 0U);
  for (const auto& [unit, expected] :
       std::vector<std::pair<std::string, std::string>>{{"um", "micron"},
                                                        {"mm", "millimeter"},
                                                        {"cm", "centimeter"},
                                                        {"in", "inch"},
                                                        {"ft", "foot"},
                                                        {"m", "meter"},
                                                        {"Millimetre", "millimeter"},
                                                        {"micrometer", "micron"}}) {
    model.about.unit = unit;
    EXPECT_EQ(written(model).unit, expected) << unit;
  }
  for (const std::string unit : {"nm", "pixel", "km", "parsec \"&"}) {
    model.about.unit = unit;
    std::vector<Warning> warnings;
    const Document document = written(model, &warnings);
    EXPECT_EQ(document.unit, "millimeter");
    EXPECT_EQ(document.metadata.at("Description"), "unit: " + unit);
    ASSERT_EQ(warnings.size(), 1U) << unit;
    EXPECT_NE(warnings[0].message.find(unit), std::string::npos);
  }
}

TEST(Write3mf, KeepsEveryDouble) {
  Model model;
  testing::add_box(model, 0, {-0x1.fffffffffffffp999, 0.1, -5e-324}, {1e22, 1.0 / 3, 1e-5});
  const Document document = written(model);
  ASSERT_EQ(document.objects.size(), 1U);
  for (std::size_t v = 0; v < 8; ++v) {
    EXPECT_TRUE(test::same_bits(document.objects[0].points[v], model.points[VertexId(v)]));
  }
}

TEST(Write3mf, TellsWhatIsNotClosed) {
  // Two bodies that share a face: it is on the boundary of neither.
  Model model;
  for (const Point3& p :
       std::vector<Point3>{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0, 0, -1}, {1, 1, 1}}) {
    model.points.push_back(p);
  }
  const auto tet = [](int a, int b, int c, int d) {
    return TetVertices{VertexId(a), VertexId(b), VertexId(c), VertexId(d)};
  };
  model.tets.push_back(tet(0, 1, 2, 4));
  model.tets.push_back(tet(1, 0, 2, 3));
  model.component.push_back(ComponentId(0));
  model.component.push_back(ComponentId(1));
  model.component_count = 2;
  std::vector<Warning> warnings;
  EXPECT_EQ(written(model, &warnings).objects.size(), 2U);
  ASSERT_EQ(warnings.size(), 2U);
  EXPECT_NE(warnings[0].message.find("'component 1'"), std::string::npos);
  EXPECT_NE(warnings[1].message.find("3 edges"), std::string::npos);
}

TEST(Write3mf, WritesTheEmptyModel) { EXPECT_TRUE(written(Model()).objects.empty()); }

}  // namespace
}  // namespace tetloft

// .glb, parsed back: the JSON by the tests' own parser, the arrays by their declarations.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstring>
#include <set>
#include <string>
#include <vector>

#include <tetloft/formats.hpp>

#include "cli/json_value.hpp"
#include "support/box_models.hpp"
#include "unit/io/io_support.hpp"

namespace tetloft {

namespace {

using test::JsonValue;

std::uint32_t word(const std::string& bytes, std::size_t at) {
  std::uint32_t value = 0;
  for (std::size_t k = 4; k-- > 0;) {
    value = value << 8 | static_cast<unsigned char>(bytes.at(at + k));
  }
  return value;
}

float real(const std::string& bytes, std::size_t at) {
  return std::bit_cast<float>(word(bytes, at));
}

using Triple = std::array<double, 3>;

struct Part {
  std::string name;
  std::vector<double> colour;
  Triple translation{};
  std::vector<Triple> points, normals;
  std::vector<std::array<std::uint32_t, 3>> triangles;
};

struct Glb {
  JsonValue json;
  std::vector<Part> parts;
};

std::vector<double> numbers(const JsonValue& value) {
  std::vector<double> all;
  for (const JsonValue& each : value.array) all.push_back(each.number);
  return all;
}

std::size_t index(const JsonValue& value) {
  EXPECT_EQ(value.kind, JsonValue::Kind::number);
  return static_cast<std::size_t>(value.number);
}

// The words of an accessor, `width` to each element.
std::vector<std::size_t> places(const JsonValue& json, const JsonValue& accessor, double type,
                                const char* kind, std::size_t width, double target) {
  EXPECT_EQ(accessor.at("componentType").number, type);
  EXPECT_EQ(accessor.at("type").string, kind);
  const JsonValue& view = json.at("bufferViews").array.at(index(accessor.at("bufferView")));
  EXPECT_EQ(view.at("target").number, target);
  EXPECT_EQ(index(view.at("byteLength")), 4 * width * index(accessor.at("count")));
  EXPECT_EQ(index(view.at("byteOffset")) % 4, 0U);
  std::vector<std::size_t> at;
  for (std::size_t k = 0; k < width * index(accessor.at("count")); ++k) {
    at.push_back(index(view.at("byteOffset")) + 4 * k);
  }
  return at;
}

std::vector<Triple> triples(const std::string& buffer, const std::vector<std::size_t>& at) {
  std::vector<Triple> all(at.size() / 3);
  for (std::size_t k = 0; k < at.size(); ++k) {
    all[k / 3][k % 3] = static_cast<double>(real(buffer, at[k]));
  }
  return all;
}

Part part_of(const JsonValue& json, const JsonValue& node, const std::string& buffer) {
  Part part;
  part.name = node.at("name").string;
  const std::vector<double> moved = numbers(node.at("translation"));
  std::copy(moved.begin(), moved.end(), part.translation.begin());
  const JsonValue& mesh = json.at("meshes").array.at(index(node.at("mesh")));
  EXPECT_EQ(mesh.at("name").string, part.name);
  const JsonValue& primitive = mesh.at("primitives").array.at(0);
  const JsonValue& material = json.at("materials").array.at(index(primitive.at("material")));
  EXPECT_EQ(material.at("name").string, part.name);
  EXPECT_FALSE(material.has("doubleSided"));
  EXPECT_EQ(material.at("pbrMetallicRoughness").at("metallicFactor").number, 0);
  part.colour = numbers(material.at("pbrMetallicRoughness").at("baseColorFactor"));
  const auto accessor = [&](const JsonValue& number) -> const JsonValue& {
    return json.at("accessors").array.at(index(number));
  };
  const JsonValue& position = accessor(primitive.at("attributes").at("POSITION"));
  part.points = triples(buffer, places(json, position, 5126, "VEC3", 3, 34962));
  part.normals = triples(buffer, places(json, accessor(primitive.at("attributes").at("NORMAL")),
                                        5126, "VEC3", 3, 34962));
  const auto corners = places(json, accessor(primitive.at("indices")), 5125, "SCALAR", 1, 34963);
  for (std::size_t k = 0; k < corners.size(); k += 3) {
    part.triangles.push_back(
        {word(buffer, corners[k]), word(buffer, corners[k + 1]), word(buffer, corners[k + 2])});
  }
  for (std::size_t i = 0; i < 3; ++i) {
    const auto by = [i](const Triple& a, const Triple& b) { return a[i] < b[i]; };
    EXPECT_EQ(numbers(position.at("min")).at(i),
              (*std::min_element(part.points.begin(), part.points.end(), by))[i]);
    EXPECT_EQ(numbers(position.at("max")).at(i),
              (*std::max_element(part.points.begin(), part.points.end(), by))[i]);
  }
  return part;
}

Glb parse_glb(const std::string& bytes) {
  Glb glb;
  EXPECT_EQ(bytes.substr(0, 4), "glTF");
  EXPECT_EQ(word(bytes, 4), 2U);
  EXPECT_EQ(word(bytes, 8), bytes.size());
  const std::size_t length = word(bytes, 12);
  EXPECT_EQ(bytes.substr(16, 4), "JSON");
  EXPECT_EQ(length % 4, 0U);
  const auto json = test::parse_json(bytes.substr(20, length));
  EXPECT_TRUE(json);
  if (!json) return glb;
  glb.json = *json;
  if (20 + length == bytes.size()) return glb;
  EXPECT_EQ(bytes.substr(24 + length, 4), std::string("BIN\0", 4));
  const std::string buffer = bytes.substr(28 + length);
  EXPECT_EQ(word(bytes, 20 + length), buffer.size());
  EXPECT_EQ(json->at("buffers").array.at(0).at("byteLength").number,
            static_cast<double>(buffer.size()));
  const JsonValue& root = json->at("nodes").array.at(0);
  for (const JsonValue& child : root.at("children").array) {
    glb.parts.push_back(part_of(*json, json->at("nodes").array.at(index(child)), buffer));
  }
  return glb;
}

Glb written(const Model& model, std::vector<Warning>* warnings = nullptr) {
  const auto made = format_surface(model, {.format = "glb"});
  EXPECT_TRUE(made.ok()) << to_string(made.error());
  if (!made) return {};
  if (warnings != nullptr) {
    *warnings = made->warnings;
  } else {
    EXPECT_TRUE(made->warnings.empty());
  }
  return parse_glb(made->bytes);
}

double volume_of(const Part& part) {
  double sum = 0;
  for (const auto& t : part.triangles) {
    const Triple& a = part.points.at(t[0]);
    const Triple& b = part.points.at(t[1]);
    const Triple& c = part.points.at(t[2]);
    sum += a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) +
           a[2] * (b[0] * c[1] - b[1] * c[0]);
  }
  return sum / 6;
}

// Where a point lies with the translation: as glTF's node hierarchy up to the root.
Triple placed(const Part& part, std::size_t v) {
  Triple p = part.points[v];
  for (std::size_t i = 0; i < 3; ++i) p[i] += part.translation[i];
  return p;
}

TEST(WriteGlb, KeepsComponentsNamesUnitAndPlace) {
  const Model model = testing::boxes_in_a_patient();
  const Glb glb = written(model);
  const JsonValue& root = glb.json.at("nodes").array.at(0);
  EXPECT_EQ(glb.json.at("asset").at("version").string, "2.0");
  EXPECT_EQ(numbers(glb.json.at("scenes").array.at(0).at("nodes")), std::vector<double>{0});
  EXPECT_EQ(root.at("name").string, testing::kHardNames[0]);
  EXPECT_EQ(root.at("extras").at("unit").string, "mm");
  EXPECT_EQ(root.at("extras").at("orientation").string, "LPS");
  EXPECT_EQ(numbers(root.at("scale")), std::vector<double>(3, 0.001));
  // (x, y, z) turned by the unit quaternion (u, w) is p + 2 w u × p + 2 u × (u × p).
  const std::vector<double> q = numbers(root.at("rotation"));
  ASSERT_EQ(q.size(), 4U);
  EXPECT_EQ(q[1], 0);
  EXPECT_EQ(q[2], 0);
  EXPECT_NEAR(2 * q[0] * q[3], -1, 1e-15);  // z goes to y, y to −z
  EXPECT_NEAR(q[0] * q[0] + q[3] * q[3], 1, 1e-15);

  ASSERT_EQ(glb.parts.size(), 3U);
  EXPECT_EQ(glb.parts[0].name, testing::kHardNames[1]);
  EXPECT_EQ(glb.parts[1].name, testing::kHardNames[2]);
  EXPECT_EQ(glb.parts[2].name, testing::kHardNames[0] + " 4");
  EXPECT_NE(glb.parts[0].colour, glb.parts[1].colour);
  const std::array<double, 3> volumes{6, 24, 0.125};
  const std::array<std::size_t, 3> first{8, 0, 16};  // vertices of the model
  for (std::size_t k = 0; k < 3; ++k) {
    const Part& part = glb.parts[k];
    EXPECT_EQ(part.triangles.size(), 12U);
    EXPECT_EQ(part.points.size(), 24U);  // a box has three normals at each corner
    EXPECT_NEAR(volume_of(part), volumes[k], 1e-5);
    std::set<std::size_t> met;
    for (std::size_t v = 0; v < part.points.size(); ++v) {
      const Triple p = placed(part, v);
      for (std::size_t corner = 0; corner < 8; ++corner) {
        const Point3 q3 = place(model.frame, model.points[VertexId(first[k] + corner)]);
        const double far = std::hypot(p[0] - q3.x, p[1] - q3.y, p[2] - q3.z);
        if (far < 1e-6) met.insert(corner);
      }
    }
    EXPECT_EQ(met.size(), 8U);
  }
}

TEST(WriteGlb, HasUnitNormalsOfFlatFaces) {
  Model model;
  testing::add_box(model, 0, {0, 0, 0}, {1, 2, 3});
  const Glb glb = written(model);
  ASSERT_EQ(glb.parts.size(), 1U);
  const Part& part = glb.parts[0];
  for (const auto& t : part.triangles) {
    const Triple& a = part.points[t[0]];
    Triple u{}, v{};
    for (std::size_t i = 0; i < 3; ++i) {
      u[i] = part.points[t[1]][i] - a[i];
      v[i] = part.points[t[2]][i] - a[i];
    }
    Triple n{u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]};
    const double length = std::hypot(n[0], n[1], n[2]);
    for (const std::uint32_t corner : t) {
      for (std::size_t i = 0; i < 3; ++i) EXPECT_EQ(part.normals[corner][i], n[i] / length);
    }
  }
  // The viewer's first colour, (222, 196, 152), as a linear factor.
  EXPECT_EQ(part.colour, (std::vector<double>{0.7305, 0.552, 0.314, 1}));
  // Nothing is known of the unit: nothing is scaled.
  EXPECT_FALSE(glb.json.at("nodes").array.at(0).has("scale"));
  EXPECT_FALSE(glb.json.at("nodes").array.at(0).has("extras"));
}

TEST(WriteGlb, KeepsDigitsFarFromTheOrigin) {
  // As float32 the coordinates near 2^25 would be 4 apart.
  Model model;
  testing::add_box(model, 0, {0x1p25, -0x1p25, 0x1p25}, {0x1p25 + 1, -0x1p25 + 1, 0x1p25 + 1});
  const Glb glb = written(model);
  ASSERT_EQ(glb.parts.size(), 1U);
  EXPECT_EQ(volume_of(glb.parts[0]), 1);
}

TEST(WriteGlb, WarnsWhereFloat32Merges) {
  Model model;
  testing::add_box(model, 0, {0, 0, 0}, {1, 1, 1});
  testing::add_box(model, 0, {0x1p30, 0, 0}, {0x1p30 + 1, 1, 1});
  std::vector<Warning> warnings;
  EXPECT_EQ(written(model, &warnings).parts.size(), 1U);
  ASSERT_EQ(warnings.size(), 2U);
  EXPECT_NE(warnings[0].message.find("float32 of glTF merges 8 vertices"), std::string::npos);
  EXPECT_NE(warnings[1].message.find("flattens"), std::string::npos);
  EXPECT_TRUE(warnings[0].where.point.has_value());
  // Components of their own keep their digits.
  for (std::size_t t = 6; t < 12; ++t) model.component[TetId(t)] = ComponentId(1);
  EXPECT_EQ(written(model).parts.size(), 2U);
}

TEST(WriteGlb, RefusesWhatIsBeyondFloat32) {
  Model model;
  testing::add_box(model, 0, {0, 0, 0}, {1, 1, 1e39});
  const auto made = format_surface(model, {.format = "glb"});
  EXPECT_EQ(made.error().code, ErrorCode::invalid_input);
  EXPECT_TRUE(made.error().where.point.has_value());
}

TEST(WriteGlb, WritesTheEmptyModel) {
  const Glb glb = written(Model());
  for (const char* list : {"meshes", "materials", "accessors", "bufferViews", "buffers"}) {
    EXPECT_FALSE(glb.json.has(list)) << list;
  }
  EXPECT_FALSE(glb.json.at("nodes").array.at(0).has("children"));
}

}  // namespace
}  // namespace tetloft

// Abaqus, Nastran and Netgen, read by this test: numbers in fields, names, faces by geometry.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdlib>
#include <map>
#include <set>
#include <string>
#include <vector>

#include <tetloft/formats.hpp>

#include "io/fitted_number.hpp"
#include "io/label_names.hpp"
#include "unit/io/io_support.hpp"
#include "unit/io/solid_support.hpp"

namespace tetloft {

using namespace internal;
namespace {

Formatted made(const Model& model, const char* format) {
  auto formatted = format_model(model, {.format = format});
  EXPECT_TRUE(formatted.ok()) << format;
  return *std::move(formatted);
}

TEST(FittedNumber, IsExactWhereItFitsAndHasAPoint) {
  EXPECT_EQ(io::fitted_number(0.0, 16), "0.");
  EXPECT_EQ(io::fitted_number(-0.0, 16), "-0.");
  EXPECT_EQ(io::fitted_number(1, 16), "1.");
  EXPECT_EQ(io::fitted_number(-1200, 16), "-1200.");
  EXPECT_EQ(io::fitted_number(0.25, 16), ".25");
  EXPECT_EQ(io::fitted_number(12.5, 16), "12.5");
  EXPECT_EQ(io::fitted_number(1e300, 16), "1.E300");
  EXPECT_EQ(io::fitted_number(5e-324, 16), "5.E-324");
  EXPECT_EQ(io::fitted_number(1.0 / 3, 16), ".333333333333333");
  EXPECT_EQ(io::fitted_number(-2.0 / 3, 16), "-.66666666666667");
  EXPECT_EQ(io::fitted_number(-1e-5 / 3, 16), "-3.3333333333E-6");
  EXPECT_EQ(io::fitted_number(123456.789012345678, 12), "123456.78901");
}

// Also where float32, of few digits, has no such difference.
TEST(FittedCoordinates, TellTheLargestDifference) {
  for (const double scale : {1.0, 1e300, 1e-100}) {
    const double value = scale / 3;
    io::FittedCoordinates coordinates(16);
    const double read = std::strtod(coordinates.text_of(value).c_str(), nullptr);
    const std::vector<Warning> warnings = coordinates.warnings();
    ASSERT_EQ(warnings.size(), 1U);
    const std::string& message = warnings[0].message;
    const std::size_t by = message.find(" by ");
    ASSERT_NE(by, std::string::npos);
    const double told = std::strtod(message.c_str() + by + 4, nullptr);
    const double due = std::fabs(value - read);
    EXPECT_NEAR(told / due, 1, 1e-6) << message;  // seven digits, as float32 has
  }
}

// Against the nearest by another way: the C library's, with as many digits as leave the field full.
TEST(FittedNumber, IsTheNearestOfTheField) {
  std::vector<double> values = test::hard_doubles();
  values.insert(values.end(), {0x1.fffffffffffffp1023, 9.9999999999999982, 0.0099999999999999985,
                               -99999.999999999985, 1e15 / 7, 1e16 / 3});
  for (const double value : values) {
    for (const std::size_t width : {12U, 16U, 20U, 24U}) {
      const std::string text = io::fitted_number(value, width);
      ASSERT_LE(text.size(), width) << value;
      EXPECT_NE(text.find('.'), std::string::npos) << text;
      const double read = std::strtod(text.c_str(), nullptr);
      ASSERT_TRUE(std::isfinite(read)) << text;
      double best = INFINITY;
      for (int digits = 1; digits <= 17; ++digits) {
        char buffer[400];
        std::snprintf(buffer, sizeof buffer, "%.*e", digits - 1, value);
        // "-d.ddde-0X": zeros of the exponent and a plus are not due.
        const int exponent =
            std::atoi(std::string(buffer).substr(std::string(buffer).find('e') + 1).c_str());
        const std::size_t sign = std::signbit(value) ? 1 : 0;
        const std::size_t size =
            sign + 1 + static_cast<std::size_t>(digits) + 1 + std::to_string(exponent).size();
        const double other = std::strtod(buffer, nullptr);
        if (size <= width) best = std::min(best, std::fabs(other - value));
      }
      EXPECT_LE(std::fabs(read - value), best) << text << " for " << value << " in " << width;
    }
    EXPECT_EQ(test::bits(std::strtod(io::fitted_number(value, 24).c_str(), nullptr)),
              test::bits(value));
  }
}

TEST(LabelNames, AreLegalAndUnique) {
  std::vector<io::ComponentGroup> groups;
  for (const char* name :
       {"Lobe a", "lobe  A", "LOBE_A_2", "", "7 up", "\xE8\x82\x9D", "_x_", "ALL"}) {
    groups.push_back({ComponentId(groups.size()), name, {}, {}});
  }
  groups.push_back({ComponentId(8), std::string(200, 'n'), {}, {}});
  groups.push_back({ComponentId(9), std::string(200, 'n'), {}, {}});
  const std::vector<std::string> labels = io::label_names(groups, {"ALL"});
  const std::vector<std::string> due{
      "LOBE_A",      "LOBE_A_2", "LOBE_A_2_2", "COMPONENT_4",        "C_7_UP",
      "COMPONENT_6", "X",        "ALL_2",      std::string(60, 'N'), std::string(58, 'N') + "_2"};
  EXPECT_EQ(labels, due);
}

// A deck by its keywords: parameters and lines of each.
struct Block {
  std::string keyword;
  std::map<std::string, std::string> parameters;
  std::vector<std::vector<std::string>> rows;
};

std::vector<Block> blocks_of(const std::string& deck) {
  std::vector<Block> blocks;
  for (const std::string& line : test::lines_of(deck)) {
    EXPECT_LT(line.size(), 256U);
    if (line.starts_with("**")) continue;
    const std::vector<std::string> words = test::words_of_line(line);
    if (!line.starts_with("*")) {
      blocks.back().rows.push_back(words);
      continue;
    }
    blocks.push_back({words[0], {}, {}});
    for (std::size_t i = 1; i < words.size(); ++i) {
      const std::size_t sign = words[i].find('=');
      blocks.back().parameters[words[i].substr(0, sign)] = words[i].substr(sign + 1);
    }
  }
  return blocks;
}

TEST(WriteAbaqus, HasSetsAndSurfacesOfComponents) {
  const Model model = test::named_solid();
  const Formatted deck = made(model, "abaqus");
  EXPECT_TRUE(deck.warnings.empty());
  std::map<std::string, std::set<std::size_t>> sets;
  std::map<std::size_t, std::array<std::size_t, 4>> elements;
  std::map<std::string, std::vector<std::vector<std::string>>> surfaces;
  for (const Block& block : blocks_of(deck.bytes)) {
    if (block.keyword == "*NODE") {
      ASSERT_EQ(block.rows.size(), model.points.size());
      for (const VertexId v : model.points.ids()) {
        const std::vector<std::string>& row = block.rows[v.index()];
        EXPECT_EQ(row.at(0), std::to_string(v.index() + 1));
        EXPECT_TRUE(test::same_bits(
            {std::stod(row.at(1)), std::stod(row.at(2)), std::stod(row.at(3))}, model.points[v]));
      }
    } else if (block.keyword == "*ELEMENT") {
      EXPECT_EQ(block.parameters.at("TYPE"), "C3D4");
      for (const auto& row : block.rows) {
        ASSERT_EQ(row.size(), 5U);
        const std::size_t number = std::stoul(row[0]);
        for (std::size_t k = 0; k < 4; ++k) elements[number][k] = std::stoul(row[1 + k]) - 1;
        EXPECT_TRUE(sets[block.parameters.at("ELSET")].insert(number).second);
      }
    } else if (block.keyword == "*ELSET") {
      EXPECT_EQ(block.parameters.at("ELSET"), "ALL_ELEMENTS");
      ASSERT_EQ(block.rows.size(), sets.size());
      for (const auto& row : block.rows) EXPECT_EQ(sets.count(row.at(0)), 1U);
    } else if (block.keyword == "*SURFACE") {
      EXPECT_EQ(block.parameters.at("TYPE"), "ELEMENT");
      surfaces[block.parameters.at("NAME")] = block.rows;
    } else if (block.keyword == "*NSET") {
      EXPECT_EQ(block.parameters.at("NSET"), "BOUNDARY_NODES");
      EXPECT_EQ(block.rows.size(), model.points.size());
    }
  }
  ASSERT_EQ(elements.size(), 7U);
  for (const TetId t : model.tets.ids()) {
    for (std::size_t k = 0; k < 4; ++k) {
      EXPECT_EQ(elements[t.index() + 1][k], model.tets[t][k].index());
    }
  }
  const std::map<std::string, std::set<std::size_t>> due{
      {"LEFT_LOBE_OF_IT", {1, 2}}, {"GR_E_7", {3}}, {"LOBE_A", {4}},
      {"LOBE_A_2", {5}},           {"C_7", {6}},    {"NO_COMPONENT", {7}}};
  EXPECT_EQ(sets, due);
  ASSERT_EQ(surfaces.size(), 1 + due.size());
  EXPECT_EQ(surfaces["BOUNDARY"].size(), 26U);
  EXPECT_EQ(surfaces["LEFT_LOBE_OF_IT_BOUNDARY"].size(), 6U);

  // The faces as the manual has them, by nodes of the element; outward, they are the volume.
  const std::map<std::string, std::array<std::size_t, 3>> corners{
      {"S1", {0, 1, 2}}, {"S2", {0, 3, 1}}, {"S3", {1, 3, 2}}, {"S4", {2, 3, 0}}};
  std::set<std::set<std::size_t>> seen;
  double volume = 0;
  for (const auto& row : surfaces["BOUNDARY"]) {
    std::array<std::size_t, 3> face{};
    for (std::size_t k = 0; k < 3; ++k) {
      face[k] = elements.at(std::stoul(row.at(0)))[corners.at(row.at(1))[k]];
    }
    EXPECT_TRUE(seen.insert({face[0], face[1], face[2]}).second);
    // The manual's order has the normal inward.
    const auto point = [&](std::size_t k) { return model.points[VertexId(face[k])]; };
    volume -= test::determinant({Point3{50, 0, 0}, point(0), point(1), point(2)});
  }
  EXPECT_NEAR(volume, 6 * 0.9 + 2, 1e-9);
  EXPECT_EQ(seen.count({1, 2, 3}), 0U);  // between the first two
  const std::string comment =
      "\n** elset GR_E_7 is Gr\xC3\xB6\xC3\x9F"
      "e 7\n";
  EXPECT_NE(deck.bytes.find(comment), std::string::npos);
  EXPECT_NE(deck.bytes.find("\n** unit: mm\n"), std::string::npos);
  EXPECT_NE(deck.bytes.find("elset LEFT_LOBE_OF_IT is " + test::first_name_printed() + '\n'),
            std::string::npos);
}

TEST(WriteAbaqus, TellsOfRounding) {
  Model model = test::named_solid();
  model.points[VertexId(0)].x = -1e-4 / 3;
  const Formatted deck = made(model, "abaqus");
  ASSERT_EQ(deck.warnings.size(), 1U);
  EXPECT_EQ(deck.warnings[0].message.find("1 of 75 coordinates"), 0U) << deck.warnings[0].message;
  EXPECT_NE(deck.bytes.find("\n1, -3.33333333333333E-5, .1, 0.\n"), std::string::npos);
  EXPECT_TRUE(format_model({}, {.format = "abaqus"}).ok());
}

// Fixed fields: of 8 characters, or 8 and four of 16.
std::string field(const std::string& line, std::size_t from, std::size_t width) {
  if (line.size() <= from) return "";
  const auto words = test::words_of_line(line.substr(from, width));
  EXPECT_LE(words.size(), 1U) << line;
  return words.empty() ? "" : words[0];
}

TEST(WriteNastran, HasCardsInFields) {
  const Model model = test::named_solid();
  const Formatted deck = made(model, "nastran");
  ASSERT_EQ(deck.warnings.size(), 1U);  // thirds
  const std::vector<std::string> lines = test::lines_of(deck.bytes);
  EXPECT_EQ(lines.back(), "ENDDATA");
  std::size_t grids = 0, tets = 0;
  std::vector<std::string> properties;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const std::string& line = lines[i];
    if (line.front() == '$' || line == "BEGIN BULK") continue;
    EXPECT_LE(line.size(), 80U);
    const std::string name = field(line, 0, 8);
    if (name == "GRID*") {
      const Point3& p = model.points[VertexId(grids++)];
      EXPECT_EQ(field(line, 8, 16), std::to_string(grids));
      EXPECT_EQ(field(line, 24, 16), "");
      EXPECT_EQ(field(line, 40, 16), io::fitted_number(p.x, 16));
      EXPECT_EQ(field(line, 56, 16), io::fitted_number(p.y, 16));
      EXPECT_EQ(line.substr(72), "*");
      EXPECT_EQ(lines.at(i + 1).substr(0, 8), "*       ");
      EXPECT_EQ(field(lines[i + 1], 8, 16), io::fitted_number(p.z, 16));
    } else if (name == "CTETRA") {
      const TetVertices& tet = model.tets[TetId(tets++)];
      const std::size_t property[]{1, 1, 2, 3, 4, 5, 6};
      EXPECT_EQ(field(line, 8, 8), std::to_string(tets));
      EXPECT_EQ(field(line, 16, 8), std::to_string(property[tets - 1]));
      for (std::size_t k = 0; k < 4; ++k) {
        EXPECT_EQ(field(line, 24 + 8 * k, 8), std::to_string(tet[k].index() + 1));
      }
    } else if (name == "PSOLID") {
      properties.push_back(field(line, 8, 8));
      EXPECT_EQ(field(line, 16, 8), properties.back());
    }
  }
  EXPECT_EQ(grids, model.points.size());
  EXPECT_EQ(tets, model.tets.size());
  EXPECT_EQ(properties, (std::vector<std::string>{"1", "2", "3", "4", "5", "6"}));
  EXPECT_NE(deck.bytes.find("$ PSOLID 2 is Gr\xC3\xB6\xC3\x9F"
                            "e 7; "),
            std::string::npos);
}

TEST(WriteNetgen, HasNegativeTetsAndOutwardFaces) {
  const Model model = test::named_solid();
  const Formatted mesh = made(model, "netgen");
  EXPECT_TRUE(mesh.warnings.empty());
  const std::vector<std::string> lines = test::lines_of(mesh.bytes);
  EXPECT_EQ(lines[0], "mesh3d");
  EXPECT_EQ(lines.back(), "endmesh");
  const auto rows = [&](const std::string& section) {
    const auto at = std::find(lines.begin(), lines.end(), section);
    const auto count = std::stol(at[1]);
    return std::vector<std::string>(at + 2, at + 2 + count);
  };
  const auto point = [&](double number) {
    return model.points[VertexId(static_cast<std::size_t>(number) - 1)];
  };
  ASSERT_EQ(rows("points").size(), model.points.size());
  for (const VertexId v : model.points.ids()) {
    const std::vector<double> p = test::numbers_of_line(rows("points")[v.index()]);
    EXPECT_TRUE(test::same_bits({p.at(0), p.at(1), p.at(2)}, model.points[v]));
  }
  ASSERT_EQ(rows("volumeelements").size(), 7U);
  for (const TetId t : model.tets.ids()) {
    const auto row = test::numbers_of_line(rows("volumeelements")[t.index()]);
    EXPECT_EQ(row.at(0), (std::vector<double>{1, 1, 2, 3, 4, 5, 6}[t.index()]));
    EXPECT_EQ(row.at(1), 4);
    EXPECT_LT(
        test::determinant({point(row.at(2)), point(row.at(3)), point(row.at(4)), point(row.at(5))}),
        -0.8);
  }
  double volume = 0;
  for (const std::string& line : rows("surfaceelements")) {
    const auto row = test::numbers_of_line(line);
    ASSERT_EQ(row.size(), 8U);
    EXPECT_EQ(row[4], 3);
    volume += test::determinant({Point3{50, 0, 0}, point(row[5]), point(row[6]), point(row[7])});
  }
  EXPECT_NEAR(volume, 6 * 0.9 + 2, 1e-9);
  EXPECT_EQ(rows("bcnames")[1], "2 GR_E_7_BOUNDARY");
  EXPECT_EQ(rows("materials"),
            (std::vector<std::string>{"1 LEFT_LOBE_OF_IT", "2 GR_E_7", "3 LOBE_A", "4 LOBE_A_2",
                                      "5 C_7", "6 NO_COMPONENT"}));
}

}  // namespace
}  // namespace tetloft

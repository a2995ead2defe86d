// tetloft slice: from a surface to a stack, and on to a solid.
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <string>
#include <vector>

#include <tetloft/io.hpp>

#include "cli/runner.hpp"
#include "support/surface_meshes.hpp"

namespace tetloft {
namespace {

using test::expect_failure;
using test::JsonValue;
using test::run;
using test::run_json;
using test::TempFolder;

std::string off_text(const TriangleMesh& mesh) {
  std::string text = "OFF\n" + std::to_string(mesh.points.size()) + ' ' +
                     std::to_string(mesh.triangles.size()) + " 0\n";
  for (const Point3& p : mesh.points) {
    for (const double c : {p.x, p.y, p.z}) text += std::to_string(c) + ' ';
    text += '\n';
  }
  for (const auto& t : mesh.triangles) {
    text += '3';
    for (const std::uint32_t v : t) text += ' ' + std::to_string(v);
    text += '\n';
  }
  return text;
}

class SliceCommand : public ::testing::Test {
 protected:
  SliceCommand() { test::put(mesh_, off_text(testing::torus_mesh(3, 1, 60, 40))); }

  TempFolder folder_;
  std::string mesh_ = folder_.file("torus.off");
  std::string out_ = folder_.file("torus.cnt");
};

TEST_F(SliceCommand, LeadsToASolidOfTheMeshsVolume) {
  for (const std::string axis : {"x", "y", "z"}) {
    const std::string stack = folder_.file("torus.vtp");
    const std::string solid = folder_.file("torus.vtu");
    const JsonValue told =
        run_json({"slice", mesh_, "--planes", "40", "--axis", axis, "-o", stack});
    EXPECT_EQ(told.at("slices").number, 40);
    EXPECT_EQ(told.at("mesh").at("vertices").number, 2400);
    EXPECT_EQ(told.at("mesh").at("triangles").number, 4800);
    EXPECT_EQ(told.at("repaired").number, 0);
    const JsonValue made = run_json({"reconstruct", stack, "-o", solid, "--ends", "half"}, 0);
    const double expected = testing::volume_of(testing::torus_mesh(3, 1, 60, 40));
    EXPECT_NEAR(made.at("volume").number, expected, 0.01 * expected) << axis;
    EXPECT_EQ(run({"check", solid, stack}).code, 0) << axis;
  }
}

TEST_F(SliceCommand, TellsWhatAFormatCannot) {
  const JsonValue turned = run_json({"slice", mesh_, "--step", "0.5", "--axis", "x", "-o", out_});
  EXPECT_EQ(turned.at("warnings").array.size(), 1U);
  EXPECT_EQ(turned.at("slices").number, 16);
  EXPECT_EQ(run_json({"slice", mesh_, "--step", "0.5", "-o", out_}).at("warnings").array.size(),
            0U);
}

TEST_F(SliceCommand, RefusesWhatMakesNoSense) {
  expect_failure({"slice", mesh_, "-o", out_}, 2, "usage", "--planes N or --step DZ", {out_});
  expect_failure({"slice", mesh_, "--planes", "3", "--step", "1", "-o", out_}, 2, "usage",
                 "give one", {out_});
  expect_failure({"slice", mesh_, "--planes", "0", "-o", out_}, 2, "usage", "--planes", {out_});
  expect_failure({"slice", mesh_, "--step", "0", "-o", out_}, 2, "usage", "--step", {out_});
  expect_failure({"slice", mesh_, "--planes", "3"}, 2, "usage", "--output", {out_});
  expect_failure({"slice", mesh_, "--planes", "3", "-o", mesh_}, 2, "usage", "torus.off");
  expect_failure({"slice", mesh_, "--planes", "3", "--axis", "w", "-o", out_}, 2, "usage", "--axis",
                 {out_});
  TriangleMesh open = testing::box_mesh({0, 0, 0}, {1, 1, 1});
  open.triangles.pop_back();
  test::put(mesh_, off_text(open));
  expect_failure({"slice", mesh_, "--planes", "3", "-o", out_}, 3, "invalid_input", "not closed",
                 {out_});
}

}  // namespace
}  // namespace tetloft

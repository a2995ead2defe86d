// From a structure set to a solid, against what is known of it analytically: volume and topology.
// Sections are cut between solids' ends, so volumes are of what lies between the first and the
// last.
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <numbers>
#include <string>

#include <tetloft/check.hpp>
#include <tetloft/formats.hpp>
#include <tetloft/reconstruct.hpp>

#include "support/dicom_writer.hpp"
#include "unit/drawings/drawing_support.hpp"

namespace tetloft {
namespace {

using namespace test;
constexpr double kPi = std::numbers::pi;

struct Solid {
  const char* name;
  double volume;
  std::vector<long> genus;  ///< of each boundary surface
  std::size_t cavities;
};

// Of the sphere of radius r between heights -h and h.
double sphere_slice(double r, double h) { return kPi * (2 * r * r * h - 2 * h * h * h / 3); }

// Of the torus of radii R and r between heights -h and h.
double torus_slice(double big, double r, double h) {
  return 4 * kPi * big * (h * std::sqrt(r * r - h * h) + r * r * std::asin(h / r));
}

void expect_solid(const Result<ReadStack>& read, const Solid& solid) {
  SCOPED_TRACE(solid.name);
  ASSERT_TRUE(read.ok()) << to_string(read.error());
  EXPECT_EQ(read->stack.about.name, solid.name);
  const auto made = reconstruct(read->stack);
  ASSERT_TRUE(made.ok()) << to_string(made.error());
  const auto report = check(made->model, read->stack);
  ASSERT_TRUE(report.ok()) << to_string(report.error());
  EXPECT_TRUE(report->pass());
  EXPECT_EQ(report->components, 1U);
  EXPECT_EQ(report->cavities, solid.cavities);
  EXPECT_EQ(report->genus, solid.genus);
  // Contours of 64 vertices and faces that are chords of the profile take a hundredth.
  EXPECT_NEAR(report->volume / solid.volume, 1, 0.0125);
}

TEST(Conformance, SolidsOfAnotherProgram) {
  const std::string file =
      std::string(TETLOFT_SHARED_DATA_DIR) + "/formats/rtstruct/rtmask_conformance_5mm.dcm";
  if (!std::filesystem::exists(file)) GTEST_SKIP() << "no reference files";
  // As its maker describes them; the first and last planes are told by the contours.
  const Solid solids[] = {{"sphere", sphere_slice(40, 35), {0}, 0},
                          {"cube", 60.0 * 60 * 55, {0}, 0},
                          {"cylinder", kPi * 30 * 30 * 75, {0}, 0},
                          // Half axes 30, 50 and 60: a sphere of radius 60, squeezed.
                          {"ellipsoid", sphere_slice(60, 55) * (30.0 / 60) * (50.0 / 60), {0}, 0},
                          {"torus", torus_slice(60, 20, 15), {1}, 0},
                          {"hollow_sphere", sphere_slice(40, 35) - sphere_slice(20, 20), {0, 0}, 1},
                          {"straw", kPi * (40 * 40 - 20 * 20) * 115, {1}, 0}};
  for (const Solid& solid : solids) {
    expect_solid(read_stack(file, {.structure = solid.name}), solid);
  }
}

// A circle of 64 vertices as ContourData, in the plane of height h across the unit vectors given.
struct Plane {
  Point3 u, v, w;
};
constexpr Plane kAxial{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
constexpr Plane kSagittal{{0, 1, 0}, {0, 0, 1}, {1, 0, 0}};
constexpr Plane kOblique{{0.6, 0.8, 0}, {-0.48, 0.36, 0.8}, {0.64, -0.48, 0.6}};

std::string circle(const Plane& plane, double radius, double height) {
  std::string data;
  for (int i = 0; i < 64; ++i) {
    const double a = radius * std::cos(2 * kPi * i / 64);
    const double b = radius * std::sin(2 * kPi * i / 64);
    for (const double Point3::*axis : {&Point3::x, &Point3::y, &Point3::z}) {
      char text[32];
      std::snprintf(text, sizeof text, "%.10g",
                    a * plane.u.*axis + b * plane.v.*axis + height * plane.w.*axis);
      data += (data.empty() ? "" : "\\") + std::string(text);
    }
  }
  return data;
}

// The profile gives radii of the circles of a height, the outer one first; 0: none.
template <class Profile>
std::string structure_set(const Plane& plane, const std::string& name, int half, int step,
                          Profile&& profile) {
  std::vector<DicomContour> contours;
  for (int h = -half; h <= half; h += step) {
    for (const double radius : profile(h)) {
      if (radius > 0) contours.push_back({circle(plane, radius, h), "CLOSED_PLANAR", "64", "UN"});
    }
  }
  return DicomWriter({}).bytes_of(
      dicom_structure_set({dicom_roi("1", name)}, {dicom_roi_contour("1", contours)}));
}

double of_sphere(double r, double h) { return r > std::abs(h) ? std::sqrt(r * r - h * h) : 0; }

TEST(Conformance, SolidsInPlanesOfAnyDirection) {
  using Radii = std::vector<double>;
  for (const Plane& plane : {kAxial, kSagittal, kOblique}) {
    expect_solid(parse_stack(structure_set(plane, "torus", 16, 2,
                                           [](double h) {
                                             const double s = of_sphere(20, h);
                                             return Radii{60 + s, 60 - s};
                                           }),
                             "a.dcm"),
                 {"torus", torus_slice(60, 20, 16), {1}, 0});
    expect_solid(parse_stack(structure_set(plane, "hollow", 36, 3,
                                           [](double h) {
                                             return Radii{of_sphere(40, h), of_sphere(20, h)};
                                           }),
                             "a.dcm"),
                 {"hollow", sphere_slice(40, 36) - sphere_slice(20, 20), {0, 0}, 1});
  }
}

}  // namespace
}  // namespace tetloft

// Structure sets: which contours are whose, and what is odd about them.
#include <gtest/gtest.h>

#include <string>

#include <tetloft/formats.hpp>

#include "support/dicom_writer.hpp"
#include "unit/drawings/drawing_support.hpp"

namespace tetloft {
namespace {

using namespace test;

std::string file_of(const DicomItem& set, DicomStyle style = {}) {
  return DicomWriter(style).bytes_of(set);
}

// One structure, with these contours.
std::string file_of(const std::vector<DicomContour>& contours, DicomStyle style = {}) {
  return file_of(dicom_structure_set({dicom_roi("3", "lung")}, {dicom_roi_contour("3", contours)}),
                 style);
}

TEST(Rtstruct, ReadsAStack) {
  const auto read = parse_stack(
      file_of({{dicom_square(5, 0)}, {dicom_square(2, 0)}, {dicom_square(4, 3)}}), "a.dcm");
  ASSERT_TRUE(read.ok()) << to_string(read.error());
  EXPECT_EQ(read->stack.about.name, "lung");
  EXPECT_EQ(read->stack.about.unit, "mm");
  ASSERT_EQ(read->stack.sections.size(), 2U);
  EXPECT_EQ(read->stack.sections[SectionId(0)].contours.size(), 2U);
  EXPECT_EQ(read->stack.sections[SectionId(1)].z, 3);
  const Contour& outer = read->stack.sections[SectionId(0)].contours[ContourId(0)];
  EXPECT_EQ(outer.vertices[0], (Point2{-5, -5}));
  EXPECT_EQ(outer.vertices[2], (Point2{5, 5}));
}

TEST(Rtstruct, AsksWhichStructure) {
  const std::string bytes = file_of(
      dicom_structure_set({dicom_roi("1", "lung"), dicom_roi("2", "heart")},
                          {dicom_roi_contour("1", {{dicom_square(5, 0)}, {dicom_square(5, 1)}}),
                           dicom_roi_contour("2", {{dicom_square(3, 0)}, {dicom_square(3, 1)}})}));
  const auto undecided = parse_stack(bytes, "a.dcm");
  ASSERT_FALSE(undecided.ok());
  EXPECT_EQ(undecided.error().code, ErrorCode::usage);
  EXPECT_NE(undecided.error().message.find("--roi"), std::string::npos);
  for (const char* const asked : {"2", "heart", "HEART"}) {
    const auto heart = parse_stack(bytes, "a.dcm", {.structure = asked});
    ASSERT_TRUE(heart.ok()) << to_string(heart.error());
    EXPECT_EQ(heart->stack.about.name, "heart");
    EXPECT_EQ(heart->stack.sections[SectionId(0)].contours[ContourId(0)].vertices[0],
              (Point2{-3, -3}));
  }
}

TEST(Rtstruct, NumbersAreReadInAllTheirForms) {
  const std::string data = " -1.50 \\+2\\0003.0\\1e1 \\ 2.5E+0\\3\\.5\\-.25\\3.\\ 7\\8\\ 3 \\\\ ";
  for (const char* const vr : {"DS", "UN", "OB", "UT"}) {
    const auto read =
        parse_stack(file_of({{data, "CLOSED_PLANAR", "4", vr}, {dicom_square(20, 9)}}), "a.dcm",
                    {.validity = Validity::unchecked});
    ASSERT_TRUE(read.ok()) << to_string(read.error());
    const auto& vertices = read->stack.sections[SectionId(0)].contours[ContourId(0)].vertices;
    const std::vector<Point2> expected{{-1.5, 2}, {10, 2.5}, {0.5, -0.25}, {7, 8}};
    EXPECT_EQ(std::vector<Point2>(vertices.begin(), vertices.end()), expected);
    EXPECT_EQ(read->stack.sections[SectionId(0)].z, 3);
  }
}

TEST(Rtstruct, ContourDataMayBeLong) {
  std::string data = "0\\0\\0";
  for (int i = 1; i < 30'000; ++i) data += '\\' + std::to_string(i) + "\\1\\0";
  ASSERT_GT(data.size(), 65534U);
  const auto read = inspected(file_of({{data, "CLOSED_PLANAR", "30000", "UN"}}));
  ASSERT_TRUE(read.ok()) << to_string(read.error());
  EXPECT_EQ(read->structures[0].points, 30'000U);
}

TEST(Rtstruct, WrongDataAreErrorsWithTheirPlace) {
  const std::string square = dicom_square(1, 0);
  expect_error(file_of({{square}, {"1\\2\\3\\4"}}),
               {"ROI 3 'lung'", "contour 1", "(3006,0050)", "4 values", "multiple of three"});
  expect_error(file_of({{"1\\2\\x\\4\\5\\6"}}), {"ROI 3 'lung', contour 0", "value 2", "'x'"});
  expect_error(file_of({{"1\\2\\3\\4\\\\6"}}), {"contour 0", "value 4", "''"});
  expect_error(file_of({{"1\\2\\nan"}}), {"value 2", "not a finite number"});
  expect_error(file_of({{"1\\2\\1e999"}}), {"value 2", "not a finite number"});
  expect_error(file_of({{"1,5\\2\\3"}}), {"value 0", "decimal comma"});
}

TEST(Rtstruct, TypesAreCountedAsTheyStandThere) {
  const std::string square = dicom_square(1, 0);
  const auto read = inspected(file_of({{square, "CLOSED_PLANAR"},
                                       {square, "CLOSEDPLANAR_XOR"},
                                       {square, "INTERPOLATED_PLANAR"},
                                       {square, "OPEN_PLANAR"},
                                       {square, "OPEN_NONPLANAR"},
                                       {"1\\2\\3", "POINT"},
                                       {square, "closed planar"},
                                       {square, "SPIRAL"},
                                       {square, "SPIRAL"},
                                       {square, ""}}));
  ASSERT_TRUE(read.ok()) << to_string(read.error());
  const std::vector<std::pair<std::string, std::size_t>> types{
      {"CLOSEDPLANAR_XOR", 1}, {"CLOSED_PLANAR", 1}, {"INTERPOLATED_PLANAR", 1},
      {"OPEN_NONPLANAR", 1},   {"OPEN_PLANAR", 1},   {"POINT", 1},
      {"SPIRAL", 2},           {"closed", 1},        {"closed planar", 1}};
  EXPECT_EQ(read->structures[0].types, types);
  EXPECT_EQ(read->lines->closed, 5U);
  EXPECT_EQ(read->lines->open, 2U);
  expect_warning(read->warnings, {"ROI 3 'lung'", "2 contours", "contour 7", "'SPIRAL'"});
  expect_warning(read->warnings, {"1 contour (contour 9)", "without ContourGeometricType"});
}

TEST(Rtstruct, OpenLinesAndPointsAreLeftOutWithAWarning) {
  const auto read = parse_stack(file_of({{dicom_square(5, 0)},
                                         {dicom_square(5, 2)},
                                         {dicom_square(1, 1), "OPEN_PLANAR"},
                                         {"1\\2\\3", "POINT"},
                                         {"1\\2\\0\\3\\4\\0"}}),
                                "a.file");
  ASSERT_TRUE(read.ok()) << to_string(read.error());
  EXPECT_EQ(read->stack.contour_count(), 2U);
  expect_warning(read->warnings, {"left out", "OPEN_PLANAR"});
  expect_warning(read->warnings, {"left out", "POINT"});
  expect_warning(read->warnings, {"left out", "one or two points"});
}

TEST(Rtstruct, OddReferencesAreWarnedOf) {
  const std::vector<DicomContour> one{{dicom_square(1, 0)}};
  const auto read = inspected(file_of(dicom_structure_set(
      {dicom_roi("1", "a"), dicom_roi("1", "b"), dicom_roi("2", "empty"), dicom_roi("", "none"),
       dicom_roi("4", "twice")},
      {dicom_roi_contour("1", one), dicom_roi_contour("4", one), dicom_roi_contour("4", one),
       dicom_roi_contour("9", one), dicom_roi_contour("", one)})));
  ASSERT_TRUE(read.ok()) << to_string(read.error());
  ASSERT_EQ(read->structures.size(), 6U);
  EXPECT_EQ(read->structures[0].contours, 1U);
  EXPECT_EQ(read->structures[1].contours, 0U);
  EXPECT_EQ(read->structures[4].contours, 2U);
  EXPECT_EQ(read->structures[5].number, 9);
  EXPECT_EQ(read->structures[5].name, "");
  EXPECT_EQ(read->structures[5].contours, 1U);
  expect_warning(read->warnings, {"ROI 1 'b'", "that of another"});
  expect_warning(read->warnings, {"ROI 0 'none'", "has no number"});
  expect_warning(read->warnings, {"ROI 4 'twice'", "several items"});
  expect_warning(read->warnings, {"ROI 9", "StructureSetROISequence"});
  expect_warning(read->warnings, {"1 item of ROIContourSequence", "left out"});
  expect_warning(read->warnings, {"without contours", "ROI 2 'empty'"});
}

TEST(Rtstruct, OddContoursAreWarnedOf) {
  const auto read = inspected(file_of({{dicom_square(1, 0), "CLOSED_PLANAR", "4"},
                                       {dicom_square(1, 1), "CLOSED_PLANAR", "5"},
                                       {"", "CLOSED_PLANAR", "0"},
                                       {dicom_square(1, 2), "CLOSED_PLANAR", "many"}}));
  ASSERT_TRUE(read.ok()) << to_string(read.error());
  EXPECT_EQ(read->structures[0].contours, 4U);
  EXPECT_EQ(read->structures[0].points, 12U);
  expect_warning(read->warnings, {"2 contours", "contour 1", "NumberOfContourPoints"});
  expect_warning(read->warnings, {"1 contour (contour 2)", "without ContourData"});
}

// The sequences may stand in the other order, and be empty or missing.
TEST(Rtstruct, SequencesStandAnywhere) {
  DicomItem set =
      dicom_structure_set({dicom_roi("1", "a")}, {dicom_roi_contour("1", {{dicom_square(1, 0)}})});
  std::swap(set[5], set[6]);
  ASSERT_EQ(set[5].element, 0x39);
  const auto swapped = inspected(file_of(set));
  ASSERT_TRUE(swapped.ok());
  EXPECT_EQ(swapped->structures[0].name, "a");
  EXPECT_EQ(swapped->structures[0].contours, 1U);
  for (const bool undefined : {false, true}) {
    const DicomStyle style{true, false, undefined, undefined};
    const auto empty = inspected(file_of(dicom_structure_set({}, {}), style));
    ASSERT_TRUE(empty.ok());
    EXPECT_EQ(empty->structures.size(), 0U);
    const auto no_contours =
        inspected(file_of(dicom_structure_set({dicom_roi("1", "a")}, {}), style));
    ASSERT_TRUE(no_contours.ok());
    ASSERT_EQ(no_contours->structures.size(), 1U);
    EXPECT_EQ(no_contours->structures[0].contours, 0U);
  }
}

TEST(Rtstruct, OtherObjectsAreNamed) {
  const auto object = [](const std::string& uid, const std::string& modality) {
    DicomItem set{dicom_value(8, 0x16, "UI", uid)};
    if (!modality.empty()) set.push_back(dicom_value(8, 0x60, "CS", modality));
    set.push_back(dicom_value(0x7FE0, 0x10, "OW", std::string(32, '\1')));
    return file_of(set);
  };
  expect_error(object("1.2.840.10008.5.1.4.1.1.2", "CT"), {"a CT image", "'CT'"});
  expect_error(object("1.2.840.10008.5.1.4.1.1.481.5", "RTPLAN"), {"RT plan", "'RTPLAN'"});
  expect_error(object("1.2.3.4", ""), {"'1.2.3.4'", "modality none"});
  const DicomWriter writer({});
  std::string directory =
      dicom_part10("1.2.840.10008.1.2.1", writer.bytes_of(dicom_value(4, 0x1130, "CS", "A")));
  const std::string set_class = "1.2.840.10008.5.1.4.1.1.481.3";
  const std::string directory_class = "1.2.840.10008.1.3.10";
  directory.replace(directory.find(set_class), directory_class.size() + 1, directory_class + '\0');
  directory.replace(directory.find(directory_class) + 21, 8, std::string(8, '\0'));
  expect_error(directory, {"a DICOMDIR"});
  // The modality alone tells; so do the sequences.
  EXPECT_TRUE(inspected(object("1.2.3.4", "RTSTRUCT")).ok());
  DicomItem bare = dicom_structure_set({dicom_roi("1", "a")}, {});
  bare.erase(bare.begin(), bare.begin() + 2);
  const auto read = inspected(std::string(128, '\0') + "DICM" + file_of(bare));
  ASSERT_TRUE(read.ok()) << to_string(read.error());
  expect_warning(read->warnings, {"does not say that it is one"});
}

TEST(Rtstruct, ObliqueAndSagittalPlanesAreFound) {
  std::vector<DicomContour> sagittal;
  for (const char* const x : {"0", "2", "4"}) {
    const std::string c = std::string(x) + '\\';
    sagittal.push_back({c + "0\\0\\" + c + "1\\0\\" + c + "1\\1\\" + c + "0\\1"});
  }
  const auto read = parse_stack(file_of(sagittal), "a.dcm");
  ASSERT_TRUE(read.ok()) << to_string(read.error());
  ASSERT_EQ(read->stack.sections.size(), 3U);
  const Point2 v = read->stack.sections[SectionId(1)].contours[ContourId(0)].vertices[2];
  const Point3 p = place(read->stack.frame, {v.x, v.y, read->stack.sections[SectionId(1)].z});
  EXPECT_EQ(p, (Point3{2, 1, 1}));
}

}  // namespace
}  // namespace tetloft

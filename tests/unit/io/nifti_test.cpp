// NIfTI files made here: types, byte orders, packing, places.
#include <gtest/gtest.h>

#include <string>

#include <tetloft/formats.hpp>
#include <tetloft/inspect.hpp>

#include "support/deflated.hpp"
#include "support/volume_files.hpp"
#include "unit/io/volume_formats_support.hpp"

namespace tetloft {
namespace {

using namespace test;

const std::string kNoExtensions(4, '\0');

Result<FileSummary> look_at(const std::string& bytes) { return inspect_bytes(bytes, "file.nii"); }

std::string file_of(const NiftiFile& nifti, const std::string& samples) {
  return nifti.header() + kNoExtensions + samples;
}
std::string few(const NiftiFile& nifti) {
  return file_of(nifti, samples_of<std::uint8_t>(kFewVoxels));
}

template <class Number>
void expect_type(int datatype, const char* name) {
  for (const bool big_endian : {false, true}) {
    for (const bool version_2 : {false, true}) {
      NiftiFile nifti;
      nifti.datatype = datatype;
      nifti.big_endian = big_endian;
      nifti.version_2 = version_2;
      nifti.vox_offset = version_2 ? 544 : 352;
      const auto summary = look_at(file_of(nifti, samples_of<Number>(kFewVoxels, big_endian)));
      EXPECT_EQ(labels_of(summary), kFewLabels) << name;
      ASSERT_TRUE(summary.ok());
      EXPECT_EQ(summary->format, "nifti");
      EXPECT_EQ(summary->volume->type, name);
    }
  }
}

TEST(Nifti, TypesVersionsAndByteOrders) {
  expect_type<std::uint8_t>(2, "uint8");
  expect_type<std::int16_t>(4, "int16");
  expect_type<std::int32_t>(8, "int32");
  expect_type<float>(16, "float32");
  expect_type<double>(64, "float64");
  expect_type<std::int8_t>(256, "int8");
  expect_type<std::uint16_t>(512, "uint16");
  expect_type<std::uint32_t>(768, "uint32");
  expect_type<std::int64_t>(1024, "int64");
  expect_type<std::uint64_t>(1280, "uint64");
}

TEST(Nifti, OtherTypesAreNamed) {
  const auto refused = [](int datatype) {
    NiftiFile nifti;
    nifti.datatype = datatype;
    return refusal_of(look_at(few(nifti)));
  };
  EXPECT_NE(refused(1).find("single bits"), std::string::npos);
  EXPECT_NE(refused(32).find("complex"), std::string::npos);
  EXPECT_NE(refused(128).find("RGB"), std::string::npos);
  EXPECT_NE(refused(1536).find("float128"), std::string::npos);
  EXPECT_EQ(refused(77), "datatype 77 is unknown");
}

TEST(Nifti, ValuesAreScaledUnlessTheSlopeIsNone) {
  NiftiFile nifti;
  nifti.slope = 2;
  nifti.intercept = -1;
  EXPECT_EQ(labels_of(look_at(few(nifti))), "-1:6 1:5 13:1");
  nifti.slope = 0;
  EXPECT_EQ(labels_of(look_at(few(nifti))), kFewLabels);
  nifti.slope = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(labels_of(look_at(few(nifti))), kFewLabels);
}

TEST(Nifti, GzipAndPairs) {
  NiftiFile nifti;
  EXPECT_EQ(labels_of(inspect_bytes(gzipped(few(nifti)), "file.bin")), kFewLabels);
  TempFolder folder;
  const std::string samples = samples_of<std::uint8_t>(kFewVoxels);
  nifti.magic = "ni1";
  nifti.vox_offset = 0;
  for (const bool packed_header : {false, true}) {
    for (const bool packed : {false, true}) {
      const std::string stem =
          folder.file(std::string(packed ? "p" : "q") + (packed_header ? "p" : "q") + " 1");
      const std::string header = stem + (packed_header ? ".hdr.gz" : ".hdr");
      put(header, packed_header ? gzipped(nifti.header()) : nifti.header());
      put(stem + (packed ? ".img.gz" : ".img"), packed ? gzipped(samples) : samples);
      EXPECT_EQ(labels_of(inspect(header)), kFewLabels) << header;
      EXPECT_EQ(labels_of(inspect(header, {.format = "nifti"})), kFewLabels) << header;
    }
  }
  put(folder.file("alone.hdr"), nifti.header());
  EXPECT_NE(refusal_of(inspect(folder.file("alone.hdr"))).find("'alone.img'"), std::string::npos);
  EXPECT_NE(refusal_of(look_at(nifti.header())).find("not read from a file"), std::string::npos);
  EXPECT_NE(refusal_of(inspect(folder.file("qq 1.img"))).find("read the .hdr"), std::string::npos);
  nifti.magic = std::string(3, '\0');
  EXPECT_NE(refusal_of(look_at(nifti.header())).find("ANALYZE"), std::string::npos);
}

TEST(Nifti, OffsetsAndExtensions) {
  NiftiFile nifti;
  nifti.vox_offset = 352 + 32;
  EXPECT_EQ(labels_of(look_at(
                file_of(nifti, std::string(32, 'x') + samples_of<std::uint8_t>(kFewVoxels)))),
            kFewLabels);
  nifti.vox_offset = 0;  // forgotten
  EXPECT_EQ(labels_of(look_at(few(nifti))), kFewLabels);
  nifti.vox_offset = -8;
  EXPECT_EQ(refusal_of(look_at(few(nifti))), "vox_offset is -8");
  nifti.vox_offset = 352.5;
  EXPECT_EQ(refusal_of(look_at(few(nifti))), "vox_offset is 352.5");
}

TEST(Nifti, LabelTablesInExtensionsNameLabels) {
  std::string table =
      "<?xml version=\"1.0\"?><CaretExtension><Date><![CDATA[now]]></Date><VolumeInformation>"
      "<LabelTable><Label Key=\"0\">none</Label><Label Key=\"1\" Red=\"1\"><![CDATA[spleen]]>"
      "</Label>\n<Label Key=\"7\"> left kidney </Label><Label Key=\"9\">absent</Label></LabelTable>"
      "</VolumeInformation></CaretExtension>";
  for (const bool big_endian : {false, true}) {
    NiftiFile nifti;
    nifti.big_endian = big_endian;
    const auto size = static_cast<std::int32_t>(table.size() + 8);
    const std::string other =
        bytes_of(std::int32_t{16}, big_endian) + bytes_of(std::int32_t{6}, big_endian) + "comment.";
    const std::string extensions = std::string("\1\0\0\0", 4) + other + bytes_of(size, big_endian) +
                                   bytes_of(std::int32_t{30}, big_endian) + table;
    nifti.vox_offset = 348 + static_cast<double>(extensions.size());
    const std::string bytes = nifti.header() + extensions + samples_of<std::uint8_t>(kFewVoxels);
    EXPECT_EQ(labels_of(look_at(bytes)), "0:6 1:5 spleen 7:1 left kidney");
    const auto read = parse_stack(gzipped(bytes), "file", {.structure = "Left Kidney"});
    ASSERT_TRUE(read.ok());
    EXPECT_EQ(read->stack.about.name, "left kidney");
    EXPECT_EQ(read->stack.about.unit, "mm");
  }
}

TEST(Nifti, TheSformCountsBeforeTheQform) {
  NiftiFile nifti;
  EXPECT_EQ(matrix_of(look_at(few(nifti))), "0.5 0 0 10 | 0 0.75 0 20 | 0 0 2 30");
  nifti.qform_code = 1;
  nifti.qform = {0, 0, 0, 10, 20, 30};
  EXPECT_EQ(warnings_of(look_at(few(nifti))), "");
  nifti.qform = {0, 0, 1, 10, 20, 31};
  const auto both = look_at(few(nifti));
  EXPECT_EQ(matrix_of(both), "0.5 0 0 10 | 0 0.75 0 20 | 0 0 2 30");
  EXPECT_NE(warnings_of(both).find("sform and qform disagree; the sform is taken"),
            std::string::npos);
  nifti.sform_code = 0;
  EXPECT_EQ(matrix_of(look_at(few(nifti))), "-0.5 0 0 10 | 0 -0.75 0 20 | 0 0 2 31");
  nifti.pixdim[0] = -1;
  EXPECT_EQ(matrix_of(look_at(few(nifti))), "-0.5 0 0 10 | 0 -0.75 0 20 | 0 0 -2 31");
  EXPECT_EQ(look_at(few(nifti))->volume->spacing, (std::array<double, 3>{0.5, 0.75, 2}));
}

TEST(Nifti, WithoutTransformsVoxelSizesAreTaken) {
  NiftiFile nifti;
  nifti.sform_code = 0;
  const auto summary = look_at(few(nifti));
  EXPECT_EQ(matrix_of(summary), "0.5 0 0 0 | 0 0.75 0 0 | 0 0 2 0");
  EXPECT_NE(warnings_of(summary).find("neither sform nor qform"), std::string::npos);
  nifti.pixdim[2] = 0;
  EXPECT_NE(warnings_of(look_at(few(nifti))).find("pixdim[2] is no size; 1 is taken"),
            std::string::npos);
}

TEST(Nifti, SingularMatricesAreNamed) {
  NiftiFile nifti;
  nifti.sform[0] = 0;
  EXPECT_EQ(
      refusal_of(look_at(few(nifti))),
      "the sform (srow_x, srow_y, srow_z) is singular: the axes of the volume lie in one plane");
  nifti.sform[0] = std::numeric_limits<double>::infinity();
  EXPECT_NE(refusal_of(look_at(few(nifti))).find("not finite"), std::string::npos);
  nifti.qform_code = 1;
  EXPECT_NE(warnings_of(look_at(few(nifti))).find("the qform is taken"), std::string::npos);
  EXPECT_EQ(matrix_of(look_at(few(nifti))), "0.5 0 0 0 | 0 0.75 0 0 | 0 0 2 0");
}

TEST(Nifti, Units) {
  const auto unit = [](int code) {
    NiftiFile nifti;
    nifti.units = code;
    return look_at(few(nifti))->unit;
  };
  EXPECT_EQ(unit(0), "");
  EXPECT_EQ(unit(1), "m");
  EXPECT_EQ(unit(2 + 8), "mm");
  EXPECT_EQ(unit(3), "um");
}

TEST(Nifti, FlatFilesAndFilesOfSeveralVolumes) {
  NiftiFile flat;
  flat.sizes = {3, 4};
  const auto summary = look_at(few(flat));
  EXPECT_EQ(labels_of(summary), kFewLabels);
  EXPECT_EQ(summary->volume->size, (std::vector<std::size_t>{3, 4}));
  EXPECT_EQ(parse_stack(few(flat), "file", {.structure = "7"})->stack.sections.size(), 1U);
  NiftiFile several;
  several.sizes = {3, 1, 2, 2};
  EXPECT_EQ(labels_of(look_at(few(several))), kFewLabels);
  EXPECT_EQ(look_at(few(several))->volume->structures,
            (std::vector<std::string>{"1:1", "2:1", "2:7"}));
}

TEST(Nifti, WhatIsCutOffOrAnnouncesTooMuchIsRefused) {
  NiftiFile nifti;
  const std::string whole = few(nifti);
  EXPECT_EQ(refusal_of(look_at(whole.substr(0, whole.size() - 1))),
            "the data are cut off: 12 voxels of type uint8 are announced, and there are 11 bytes");
  const std::string packed = gzipped(whole);
  for (std::size_t size = 1; size < packed.size(); size += 7) {
    EXPECT_NE(refusal_of(look_at(packed.substr(0, size))), "taken") << size;
  }
  nifti.sizes = {30000, 30000, 30000};
  EXPECT_NE(refusal_of(look_at(gzipped(few(nifti)))).find("cut off"), std::string::npos);
  nifti.sizes = {30000, 30000, 30000, 30000, 30000};
  EXPECT_EQ(refusal_of(look_at(few(nifti))), "dim announces too many voxels");
  nifti.sizes = {3, 0, 2};
  EXPECT_EQ(refusal_of(look_at(few(nifti))), "dim[2] is 0");
  nifti.sizes = {};
  EXPECT_NE(refusal_of(look_at(few(nifti))).find("dim[0] is 0"), std::string::npos);
}

TEST(Nifti, LargeFilesAreReadSliceBySlice) {
  TempFolder folder;
  NiftiFile nifti;
  nifti.sizes = {300, 300, 3};
  std::string samples(300 * 300 * 3, '\0');
  samples[2 * 300 * 300 + 300 * 7 + 5] = 4;
  put(folder.file("large"), file_of(nifti, samples));
  const auto read = read_stack(folder.file("large"));
  ASSERT_TRUE(read.ok()) << to_string(read.error());
  EXPECT_EQ(read->stack.sections[SectionId(0)].z, 34);
}

}  // namespace
}  // namespace tetloft

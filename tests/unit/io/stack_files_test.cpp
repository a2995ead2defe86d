// Files that are stacks by themselves, and the files that one stack is in.
#include "io/stack_files.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "unit/io/io_support.hpp"

namespace tetloft::internal::io {
namespace {

const std::string kSquares = "S 2\nv 4 z 0\n{ 0 0 2 0 2 2 0 2 }\nv 4 z 1\n{ 0 0 2 0 2 2 0 2 }\n";

std::string metaimage(const std::string& data) {
  return "ObjectType = Image\nNDims = 3\nDimSize = 2 2 2\nElementType = MET_UCHAR\n"
         "ElementDataFile = " +
         data;
}

TEST(StackFiles, AreToldByContentsOrExtensionAndNotByBeingText) {
  const test::TempFolder folder;
  test::put(folder.file("a"), metaimage("a.raw\n"));
  test::put(folder.file("b.CNT"), "whatever\n");
  test::put(folder.file("notes.txt"), "whatever\n");
  EXPECT_TRUE(is_stack_file(folder.file("a"), ""));
  EXPECT_TRUE(is_stack_file(folder.file("b.CNT"), ""));
  EXPECT_FALSE(is_stack_file(folder.file("notes.txt"), ""));
  EXPECT_FALSE(is_stack_file(folder.file("missing"), ""));
  EXPECT_TRUE(is_stack_file(folder.file("missing.cnt"), ""));
}

TEST(StackFiles, AreOfTheFormatThatIsNamed) {
  const test::TempFolder folder;
  test::put(folder.file("a.mhd"), metaimage("a.raw\n"));
  EXPECT_TRUE(is_stack_file(folder.file("a.mhd"), "metaimage"));
  EXPECT_FALSE(is_stack_file(folder.file("a.mhd"), "cnt"));
}

TEST(StackFiles, OfAVolumeAreItsHeaderAndItsData) {
  const test::TempFolder folder;
  const std::string header = folder.file("a.mhd");
  test::put(header, metaimage("a.raw\n"));
  // Without data nothing more is known.
  EXPECT_EQ(stack_files(header, ""), std::vector<std::string>{header});
  test::put(folder.file("a.raw"), "12345678");
  EXPECT_EQ(stack_files(header, ""), (std::vector<std::string>{header, folder.file("a.raw")}));
  test::put(header, metaimage("LIST\na.0\na.1\n"));
  test::put(folder.file("a.0"), "1234");
  test::put(folder.file("a.1"), "1234");
  EXPECT_EQ(stack_files(header, "metaimage"),
            (std::vector<std::string>{header, folder.file("a.0"), folder.file("a.1")}));
  test::put(header, metaimage("LOCAL\n12345678"));
  EXPECT_EQ(stack_files(header, ""), std::vector<std::string>{header});
}

TEST(StackFiles, OfAnythingElseAreOne) {
  const test::TempFolder folder;
  const std::string path = folder.file("a.cnt");
  test::put(path, kSquares);
  EXPECT_EQ(stack_files(path, ""), std::vector<std::string>{path});
  EXPECT_EQ(stack_files(folder.file("missing"), ""),
            std::vector<std::string>{folder.file("missing")});
}

TEST(StackFiles, ThatAreReadBySectionAreRecognisedOrNamed) {
  const test::TempFolder folder;
  const auto by_section = [&](const std::string& name, const std::string& bytes,
                              const ReadOptions& options = {}) {
    test::put(folder.file(name), bytes);
    return is_read_by_section(folder.file(name), options);
  };
  ReadOptions named;
  named.format = "cnt";
  ReadOptions other;
  other.format = "geojson";
  ReadOptions closing;
  closing.close_on_frame = true;
  ReadOptions unchecked;
  unchecked.validity = Validity::unchecked;
  EXPECT_TRUE(by_section("a.cnt", kSquares));
  EXPECT_TRUE(by_section("a.dat", kSquares));
  EXPECT_TRUE(by_section("a.cnt", "# no stack", named));
  EXPECT_FALSE(by_section("a.cnt", "# no stack"));
  EXPECT_FALSE(by_section("a.cnt", metaimage("LOCAL\n12345678")));
  EXPECT_FALSE(by_section("a.cnt", ""));
  for (const ReadOptions& options : {other, closing, unchecked}) {
    EXPECT_FALSE(by_section("a.cnt", kSquares, options));
  }
  EXPECT_FALSE(is_read_by_section(folder.file("missing"), named));
  EXPECT_FALSE(is_read_by_section(folder.file(""), named));
}

}  // namespace
}  // namespace tetloft::internal::io

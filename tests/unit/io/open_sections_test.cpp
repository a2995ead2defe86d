// Opening sections of a file: what is read as a whole, memory, files that change.
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <fstream>
#include <memory>
#include <string>
#include <thread>

#include <tetloft/formats.hpp>

#include "io/cnt_sections.hpp"
#include "support/counted_memory.hpp"
#include "unit/io/cnt_sections_support.hpp"

namespace tetloft {

using namespace internal;
namespace {

using io::CntBlocks;
using test::expect_same;
using test::expect_sections;
using test::Spied;
using test::SpiedBytes;
using test::TempFolder;

TEST(CntSectionStream, TakeMemoryOfSomeSections) {
  const TempFolder folder;
  const auto peak = [&](int sections) {
    const std::string path = folder.file("many.cnt");
    {
      std::ofstream file(path);
      file << "S " << sections << '\n';
      for (int s = 0; s < sections; ++s) {
        file << "v 40 z " << s << "\n{";
        for (int x = 0; x < 20; ++x) file << x << ".125 0.5\n";
        for (int x = 20; x > 0; --x) file << x << ".125 7.5\n";
        file << "}\n";
      }
    }
    return test::peak_of([&] {
      const CntBlocks blocks{.read = 4096, .validated = 20'000};
      auto file = io::open_bytes(path);
      ASSERT_TRUE(file.ok());
      auto survey = io::survey_cnt(**file, path, blocks, {.threads = 1});
      ASSERT_TRUE(survey.ok() && survey->has_value());
      io::CntSections stream(*std::move(file), path, **std::move(survey), blocks);
      for (int s = 0; s < sections; ++s) ASSERT_TRUE(stream.next()->has_value());
      ASSERT_FALSE(stream.next()->has_value());
    });
  };
  const std::size_t few = peak(500);
  const std::size_t many = peak(4000);
  // For each section its place, twice while the list grows, and its height as a plane for a moment;
  // the text of one takes 500 bytes, its vertices 640.
  EXPECT_LT(many, few + std::size_t{3500} * 200);
  EXPECT_LT(few, 300'000U);
}

// A stream of `text`, whose bytes become `then` after the survey.
Result<std::optional<Section>> first_fault(const std::string& text, const std::string& then,
                                           std::size_t& good) {
  const auto spied = std::make_shared<Spied>(Spied{text});
  auto file = std::make_unique<SpiedBytes>(spied);
  auto survey = io::survey_cnt(*file, "t.cnt", test::kSmallBlocks, {.threads = 1});
  EXPECT_TRUE(survey.ok() && survey->has_value());
  io::CntSections sections(std::move(file), "t.cnt", **std::move(survey), test::kSmallBlocks);
  spied->bytes = then;
  for (good = 0;; ++good) {
    auto next = sections.next();
    if (!next || !next->has_value()) return next;
  }
}

TEST(CntSectionStream, OfAFileThatChangesEndInAnError) {
  const std::string text =
      "S 3\nv 3 z 0\n{0 0 1 0 0 1}\nv 3 z 1\n{0 0 1 0 0 1}\nv 3 z 2\n{0 0 1 0 "
      "0 1}\n# behind it all\n";
  const auto with = [&](const std::string& from, const std::string& to) {
    std::string changed = text;
    return changed.replace(changed.rfind(from), from.size(), to);
  };
  std::size_t good = 0;
  EXPECT_TRUE(first_fault(text, text, good).ok());
  EXPECT_EQ(good, 3U);
  const auto unreadable = first_fault(text, with("0 1}", "0 y}"), good);
  ASSERT_FALSE(unreadable.ok());
  EXPECT_EQ(to_string(unreadable.error()), "t.cnt:7: 'y' is not a number");
  EXPECT_EQ(unreadable.error().code, ErrorCode::invalid_input);
  EXPECT_EQ(good, 2U);
  for (const std::string& then :
       {with("0 1}", "0 2}"), with("v 3 z 2\n{", "        {").replace(0, 3, "S 2"),
        with("{0 0 1 0 0 1}", "{0 0 1 0   1}"), with("\n# behind", "\nv 1 z 3"),
        text.substr(0, text.size() - 1), with("S 3", "S 4"), with("all", "All")}) {
    const auto changed = first_fault(text, then, good);
    if (changed.ok()) ADD_FAILURE() << then;
    if (changed.ok() || changed.error().code == ErrorCode::invalid_input) continue;
    EXPECT_EQ(to_string(changed.error()), "t.cnt: changes while it is read") << then;
    EXPECT_EQ(changed.error().code, ErrorCode::io);
  }
}

TEST(CntSectionStream, OfASectionThatIsTooLargeAreRefused) {
  const std::string text = "S 1\nv 3 z 0\n{0 0 1 0 0 1}\n" + std::string(5000, ' ');
  const io::MemoryBytes source(text);
  const auto refused = io::survey_cnt(source, "t.cnt", {.read = 16, .largest_section = 4000}, {});
  ASSERT_FALSE(refused.ok());
  EXPECT_EQ(refused.error().code, ErrorCode::io);
  EXPECT_TRUE(io::survey_cnt(source, "t.cnt", {.read = 16, .largest_section = 6000}, {}).ok());
}

TEST(OpenSections, HandsOutFromMemoryWhatIsReadAsAWhole) {
  const TempFolder folder;
  const std::string triples = folder.file("triples.cnt");
  test::put(triples, "S 1\nv 4 z 2\n{0 0 2 1 0 2\n1 1 2 0 1 2}\n");
  const std::string cnt = std::string(TETLOFT_DATA_DIR) + "/torus.cnt";
  const std::string geojson = folder.file("stack.geojson");
  ASSERT_TRUE(write_stack(geojson, read_stack(cnt)->stack).ok());
  const std::string fifo = folder.file("pipe");
  ASSERT_EQ(mkfifo(fifo.c_str(), 0600), 0);
  ReadOptions unchecked;
  unchecked.validity = Validity::unchecked;
  ReadOptions closing;
  closing.close_on_frame = true;
  const struct {
    std::string path;
    ReadOptions options;
  } cases[] = {{triples, {}}, {geojson, {}}, {cnt, unchecked}, {cnt, closing}, {fifo, {}}};
  for (const auto& [path, options] : cases) {
    SCOPED_TRACE(path);
    const bool piped = path == fifo;
    std::thread writer([&] {
      if (piped) test::put(fifo, test::get(cnt));
    });
    const auto opened = open_sections(path, options);
    writer.join();
    ASSERT_TRUE(opened.ok()) << to_string(opened.error());
    EXPECT_TRUE(opened->in_memory);
    const auto whole = read_stack(piped ? cnt : path, options);
    EXPECT_EQ(opened->count, whole->stack.sections.size());
    if (!piped) expect_same(opened->warnings, whole->warnings);
    Place place;
    place.section = 0;
    place.contour = 0;
    if (!whole->lines.empty()) {
      EXPECT_EQ(opened->sections->located(place).line, whole->lines[SectionId(0)][ContourId(0)]);
    }
    EXPECT_EQ(opened->sections->located(place).file, path);
    expect_sections(*opened->sections, whole->stack);
  }
}

TEST(OpenSections, RefusesAsTheReaderDoes) {
  const TempFolder folder;
  test::put(folder.file("no.cnt"), "S 1\nv 3 z 0\n{0 0 1 0 0 x}");
  test::put(folder.file("empty.cnt"), "");
  test::put(folder.file("odd.cnt"), "S 1\nv 3 z 0\n{0 0 1 0 0 1 2}");
  ReadOptions wrong;
  wrong.axis = 7;
  for (const std::string name : {"no.cnt", "empty.cnt", "odd.cnt", "none.cnt", ""}) {
    for (const ReadOptions& options : {ReadOptions(), wrong}) {
      const auto opened = open_sections(folder.file(name), options);
      const auto read = read_valid_stack(folder.file(name), options);
      ASSERT_FALSE(opened.ok()) << name;
      EXPECT_EQ(opened.error().code, read.error().code);
      EXPECT_EQ(to_string(opened.error()), to_string(read.error()));
    }
  }
}

}  // namespace
}  // namespace tetloft

// Zip archives, read back by a reader of the tests' own.
#include "io/bytes/zip.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "io/sink.hpp"
#include "unit/io/zip_reader.hpp"

namespace tetloft {

using namespace internal;

namespace {

std::string archive_of(const std::vector<io::ZipEntry>& entries) {
  io::StringSink sink;
  const Result<void> made = io::append_zip(sink, entries);
  EXPECT_TRUE(made.ok()) << to_string(made.error());
  return sink.take();
}

TEST(Zip, HoldsWhatIsPutIn) {
  const std::string words = [] {
    std::string text;
    for (int k = 0; k < 3000; ++k) text += "<vertex x=\"" + std::to_string(k * k) + "\"/>\n";
    return text;
  }();
  const std::string noise = "\x01q\xFF\x80z";
  const auto read =
      test::read_zip(archive_of({io::zip_entry("words.xml", words),
                                 io::zip_entry("a/b/noise", noise), io::zip_entry("empty", "")}));
  ASSERT_TRUE(read);
  EXPECT_EQ(read->names, (std::vector<std::string>{"words.xml", "a/b/noise", "empty"}));
  EXPECT_TRUE(read->files.at("words.xml").bytes == words);
  EXPECT_TRUE(read->files.at("words.xml").deflated);
  EXPECT_EQ(read->files.at("a/b/noise").bytes, noise);
  EXPECT_FALSE(read->files.at("a/b/noise").deflated);
  EXPECT_EQ(read->files.at("empty").bytes, "");
  EXPECT_FALSE(read->files.at("empty").deflated);
}

TEST(Zip, IsTheSameWhenever) {
  const auto made = [] { return archive_of({io::zip_entry("a", std::string(1000, 'x'))}); };
  EXPECT_EQ(made(), made());
  EXPECT_TRUE(test::read_zip(archive_of({})));
}

TEST(Zip, RefusesWhatItsNumbersDoNotHold) {
  io::StringSink sink;
  // Sizes as if they were so long: nothing is appended.
  std::vector<io::ZipEntry> large(2, io::zip_entry("half", "x"));
  for (io::ZipEntry& entry : large) entry.size = (std::uint64_t{1} << 31) - 95;
  EXPECT_EQ(io::append_zip(sink, large).error().code, ErrorCode::invalid_input);
  large[1].size = std::uint64_t{1} << 63;
  EXPECT_EQ(io::append_zip(sink, large).error().code, ErrorCode::invalid_input);
  const std::vector<io::ZipEntry> many(65535, io::zip_entry("", ""));
  EXPECT_EQ(io::append_zip(sink, many).error().code, ErrorCode::invalid_input);
  EXPECT_EQ(sink.take(), "");
  // By one byte less, and one entry less, they fit: 22 of the end, 76 and twice the name for each.
  large[0].size = large[1].size = (std::uint64_t{1} << 31) - 96;
  EXPECT_TRUE(io::append_zip(sink, large).ok());
  EXPECT_TRUE(io::append_zip(sink, std::span(many).first(65534)).ok());
}

}  // namespace
}  // namespace tetloft

// Records: what is written is read back; what is anything else is refused with a reason.
#include "core/record.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

namespace tetloft::testing {

using namespace internal;
namespace {

constexpr RecordKind kKind{"test", 3, "a test"};

std::string written() {
  RecordWriter out(kKind);
  out.put(std::uint32_t{0x01020304});
  out.put(-0.0);
  out.put(VertexId());
  out.put_all(std::vector<double>{1.5, 2.5});
  return out.take();
}

std::string reason(std::string_view bytes, const RecordKind& kind = kKind) {
  RecordReader in(bytes, kind, "name");
  (void)in.get<std::uint32_t>();
  (void)in.get<double>();
  (void)in.get<VertexId>();
  (void)in.get_all<double>();
  const Result<void> end = in.end();
  return end ? "" : to_string(end.error());
}

TEST(Record, ReadsBackWhatWasWritten) {
  const std::string bytes = written();
  RecordReader in(bytes, kKind, "name");
  EXPECT_EQ(in.get<std::uint32_t>(), 0x01020304U);
  EXPECT_TRUE(std::signbit(in.get<double>()));
  EXPECT_FALSE(in.get<VertexId>().valid());
  EXPECT_EQ(in.get_all<double>(), (std::vector<double>{1.5, 2.5}));
  EXPECT_TRUE(in.end());
}

TEST(Record, IsLittleEndian) {
  const std::string bytes = written();
  EXPECT_EQ(bytes.substr(0, 16), std::string("tetloft\0test\3\0\0\0", 16));
  EXPECT_EQ(bytes.substr(24, 4), "\4\3\2\1");
}

TEST(Record, EveryTruncationIsRefused) {
  const std::string bytes = written();
  for (std::size_t n = 0; n < bytes.size(); ++n) EXPECT_NE(reason(bytes.substr(0, n)), "") << n;
  EXPECT_NE(reason(bytes + "x"), "");
}

TEST(Record, EveryFlippedBitIsRefused) {
  const std::string bytes = written();
  for (std::size_t i = 0; i < bytes.size(); ++i) {
    for (int bit = 0; bit < 8; ++bit) {
      std::string damaged = bytes;
      damaged[i] = static_cast<char>(damaged[i] ^ (1 << bit));
      EXPECT_NE(reason(damaged), "") << i << ' ' << bit;
    }
  }
}

TEST(Record, SaysWhatItIsNot) {
  EXPECT_EQ(reason("S 1\n"), "name: not a test: it is no record of tetloft, or cut off");
  EXPECT_EQ(reason(written(), {"else", 3, "something else"}),
            "name: not something else: it holds something else");
  EXPECT_EQ(reason(written(), {"test", 4, "a test"}),
            "name: not a test: it has version 3, where 4 can be read");
}

TEST(Record, CountsAreNeverTrusted) {
  RecordWriter out(kKind);
  out.put_count(std::size_t{1} << 60);
  const std::string bytes = out.take();
  RecordReader in(bytes, kKind, "name");
  EXPECT_TRUE(in.get_all<double>().empty());
  EXPECT_EQ(to_string(in.end().error()), "name: not a test: it counts more than it holds");
}

TEST(Record, WhatIsLeftOverIsRefused) {
  const std::string bytes = written();
  RecordReader in(bytes, kKind, "name");
  (void)in.get<std::uint32_t>();
  EXPECT_EQ(to_string(in.end().error()), "name: not a test: it holds more than it counts");
}

}  // namespace
}  // namespace tetloft::testing

// Sections one after the other, compared with those of a reader of the whole.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <memory>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include <tetloft/section_stream.hpp>

#include "io/bytes/byte_source.hpp"
#include "io/cnt_splitter.hpp"
#include "unit/io/io_support.hpp"

namespace tetloft::test {

inline constexpr internal::io::CntBlocks kSmallBlocks{.read = 16, .validated = 40};

// Bytes that others may change, and how they are read.
struct Spied {
  std::string bytes;
  std::size_t size = bytes.size();
  std::size_t largest_read = 0;
};
class SpiedBytes final : public internal::io::ByteSource {
 public:
  explicit SpiedBytes(std::shared_ptr<Spied> spied) : spied_(std::move(spied)) {}
  [[nodiscard]] std::uint64_t size() const override { return spied_->size; }
  [[nodiscard]] Result<std::size_t> read_at(std::uint64_t offset,
                                            std::span<char> to) const override {
    spied_->largest_read = std::max(spied_->largest_read, to.size());
    return internal::io::MemoryBytes(spied_->bytes).read_at(offset, to);
  }

 private:
  std::shared_ptr<Spied> spied_;
};

inline void expect_same(const std::vector<Warning>& a, const std::vector<Warning>& b) {
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i) EXPECT_EQ(to_string(a[i]), to_string(b[i]));
}

inline void expect_same(const Section& a, const Section& b) {
  EXPECT_EQ(bits(a.z), bits(b.z));
  ASSERT_EQ(a.contours.size(), b.contours.size());
  for (const ContourId c : a.contours.ids()) {
    const auto& v = a.contours[c].vertices;
    const auto& w = b.contours[c].vertices;
    ASSERT_EQ(v.size(), w.size());
    for (std::size_t i = 0; i < v.size(); ++i) {
      EXPECT_EQ(bits(v[i].x), bits(w[i].x));
      EXPECT_EQ(bits(v[i].y), bits(w[i].y));
    }
  }
}

inline void expect_sections(SectionStream& sections, const SectionStack& stack) {
  for (const Section& section : stack.sections) {
    const auto next = sections.next();
    ASSERT_TRUE(next.ok()) << to_string(next.error());
    ASSERT_TRUE(next->has_value());
    expect_same(**next, section);
  }
  for (int again = 0; again < 2; ++again) {
    const auto end = sections.next();
    ASSERT_TRUE(end.ok()) << to_string(end.error());
    EXPECT_FALSE(end->has_value());
  }
}

}  // namespace tetloft::test

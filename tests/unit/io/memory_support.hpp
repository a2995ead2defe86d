// What a reader may take of memory for a file.
#pragma once

#include <gtest/gtest.h>

#include <cstddef>
#include <string>
#include <vector>

#include <tetloft/io.hpp>

#include "support/counted_memory.hpp"

namespace tetloft::test {

/// A file made to take much.
struct Family {
  std::string name;
  std::string bytes;
};

inline constexpr std::size_t kSize = 400'000;
// Small enough that what every reader may take does not hide what a file makes it take.
static_assert(kSize > kReaderBytes / kReaderMultiple * 10);
template <class Parse>
void expect_bounded(const std::vector<Family>& families, Parse&& parse,
                    std::size_t multiple = kReaderMultiple) {
  for (const Family& family : families) {
    const std::size_t bytes = peak_of([&] { parse(family.bytes); });
    const std::size_t size = family.bytes.size();
    EXPECT_LE(bytes + size, multiple * size + kReaderBytes)
        << family.name << ": " << bytes / size << " times its " << size << " bytes";
  }
}

}  // namespace tetloft::test

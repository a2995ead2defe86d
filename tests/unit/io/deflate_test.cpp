// Compression, undone by a decoder of the tests' own.
#include "io/bytes/deflate.hpp"

#include <gtest/gtest.h>

#include <string>
#include <utility>
#include <vector>

#include "core/prng.hpp"
#include "unit/render/inflate.hpp"

namespace tetloft {

using namespace internal;

namespace {

TEST(Deflate, RoundTripsThroughADecoderOfItsOwn) {
  Prng prng(1);
  std::vector<std::string> all{"", "a", "ab", std::string(100'000, 'x'), "abcabcabcabcabcabcab"};
  std::string noise, words, far;
  for (int k = 0; k < 70'000; ++k) noise += static_cast<char>(prng.next() & 0xFFU);
  for (int k = 0; k < 60'000; ++k) words += "tetrahedra "[prng.next() % 11];
  far = noise.substr(0, 300) + std::string(32'768 - 300, 'z') + noise.substr(0, 300) +
        std::string(32'768, 'y') + noise.substr(0, 300);
  all.insert(all.end(), {noise, words, far});
  // Fibonacci counts ask for codes longer than 15 bits.
  std::string skewed;
  std::size_t a = 1, b = 1;
  for (char c = 0; c < 24; ++c) {
    skewed += std::string(a, static_cast<char>('a' + c));
    b = std::exchange(a, a + b);
  }
  for (std::size_t k = skewed.size(); k-- > 1;) std::swap(skewed[k], skewed[prng.next() % (k + 1)]);
  all.push_back(skewed);
  for (const std::string& bytes : all) {
    const std::string packed = io::zlib_compressed(bytes);
    const auto unpacked = test::inflate(packed);
    ASSERT_TRUE(unpacked) << bytes.size();
    EXPECT_TRUE(*unpacked == bytes) << bytes.size();
  }
  EXPECT_LT(io::zlib_compressed(std::string(100'000, 'x')).size(), 300U);
  EXPECT_LT(io::zlib_compressed(words).size(), 30'000U);
}

}  // namespace
}  // namespace tetloft

#include "io/base64.hpp"

#include <gtest/gtest.h>

#include <string>

namespace tetloft {

using namespace internal;

namespace {

TEST(Base64, EncodesWhatTheDecoderReads) {
  EXPECT_EQ(io::encode_base64(""), "");
  EXPECT_EQ(io::encode_base64("f"), "Zg==");
  EXPECT_EQ(io::encode_base64("fo"), "Zm8=");
  EXPECT_EQ(io::encode_base64("foo"), "Zm9v");
  EXPECT_EQ(io::encode_base64("foobar"), "Zm9vYmFy");
  std::string bytes;
  for (int k = 0; k < 256; ++k) bytes += static_cast<char>(k);
  EXPECT_EQ(io::decode_base64(io::encode_base64(bytes), bytes.size()), bytes);
}

}  // namespace
}  // namespace tetloft

// Compressed VTK files, unpacked here by a decoder that shares nothing with the library's.
#include <gtest/gtest.h>

#include <cstdint>
#include <string>
#include <vector>

#include <tetloft/formats.hpp>

#include "unit/io/io_support.hpp"
#include "unit/render/inflate.hpp"

namespace tetloft {
namespace {

// Of more blocks than one, and not of whole ones.
Model long_model() {
  Model model;
  for (int i = 0; i < 5001; ++i) model.points.push_back({0.1 * i * i, -0.3 * i, 1.0 / (1 + i)});
  for (int i = 0; i + 3 < 5001; ++i) {
    model.tets.push_back(
        {VertexId(i), VertexId(i + 1), VertexId((i * 7919) % 5001), VertexId(i + 3)});
    model.component.push_back(ComponentId(i % 3));
  }
  model.component_count = 3;
  return model;
}

std::uint64_t word(const std::string& bytes, std::size_t at) {
  std::uint64_t value = 0;
  for (std::size_t i = 8; i-- > 0;) {
    value = value << 8 | static_cast<unsigned char>(bytes.at(at + i));
  }
  return value;
}

// The values of an array by its name, as the file format describes them.
std::string unpacked_array(const std::string& file, const std::string& name) {
  const std::size_t tag = file.find("Name=\"" + name + "\"");
  const std::size_t offset = file.find("offset=\"", tag) + 8;
  const std::string data = file.substr(file.find("<AppendedData"));
  std::size_t at = data.find('_') + 1 + std::stoul(file.substr(offset));
  const std::uint64_t blocks = word(data, at);
  const std::uint64_t block = word(data, at + 8);
  const std::uint64_t last = word(data, at + 16);
  std::vector<std::uint64_t> sizes;
  for (std::uint64_t i = 0; i < blocks; ++i) sizes.push_back(word(data, at + 24 + 8 * i));
  at += 24 + 8 * blocks;
  std::string all;
  for (std::uint64_t i = 0; i < blocks; ++i) {
    const std::string text = test::inflate(data.substr(at, sizes[i])).value_or("");
    EXPECT_EQ(text.size(), i + 1 == blocks && last != 0 ? last : block);
    all += text;
    at += sizes[i];
  }
  return all;
}

// The same of a plain file.
std::string plain_array(const std::string& file, const std::string& name) {
  const std::size_t tag = file.find("Name=\"" + name + "\"");
  const std::size_t offset = file.find("offset=\"", tag) + 8;
  const std::string data = file.substr(file.find("<AppendedData"));
  const std::size_t at = data.find('_') + 1 + std::stoul(file.substr(offset));
  return data.substr(at + 8, word(data, at));
}

TEST(PackedVtu, HoldsTheBytesOfThePlainFile) {
  const auto plain = format_vtu(long_model(), Encoding::binary);
  const auto packed = format_vtu(long_model(), Encoding::compressed);
  ASSERT_TRUE(plain.ok() && packed.ok());
  EXPECT_NE(packed->find("compressor=\"vtkZLibDataCompressor\""), std::string::npos);
  EXPECT_LT(packed->size(), plain->size() / 2);
  for (const char* name : {"component", "Points", "connectivity", "offsets", "types"}) {
    EXPECT_EQ(unpacked_array(*packed, name), plain_array(*plain, name)) << name;
  }
}

TEST(PackedVtu, HoldsSurfacesAndStacksToo) {
  WriteOptions options;
  options.format = "vtp";
  const auto plain = format_surface(long_model(), options);
  options.encoding = Encoding::compressed;
  const auto packed = format_surface(long_model(), options);
  ASSERT_TRUE(plain.ok() && packed.ok());
  for (const char* name : {"component", "Points", "connectivity", "offsets"}) {
    EXPECT_EQ(unpacked_array(packed->bytes, name), plain_array(plain->bytes, name)) << name;
  }
  const auto triangles = parse_triangles(packed->bytes, "a.vtp");
  ASSERT_TRUE(triangles.ok()) << to_string(triangles.error());
  EXPECT_EQ(triangles->mesh.triangles, parse_triangles(plain->bytes, "a.vtp")->mesh.triangles);
  EXPECT_EQ(triangles->mesh.points, parse_triangles(plain->bytes, "a.vtp")->mesh.points);
}

// Whatever is written is read: what would unpack to more than a reader takes is not packed.
TEST(PackedVtu, IsWrittenPlainWhereNoReaderWouldTakeIt) {
  Model model;
  for (int i = 0; i < 4; ++i)
    model.points.push_back({1.0 * (i == 1), 1.0 * (i == 2), 1.0 * (i == 3)});
  for (int i = 0; i < 60000; ++i) {
    model.component.push_back(ComponentId(0));
    model.slab.push_back(SlabId(0));
    model.kind.push_back(TetKind::ii);
    model.tets.push_back({VertexId(0), VertexId(1), VertexId(2), VertexId(3)});
  }
  WriteOptions options{Encoding::compressed, "vtu"};
  const auto packed = format_model(model, options);
  ASSERT_TRUE(packed.ok());
  EXPECT_TRUE(packed->bytes == *format_vtu(model, Encoding::binary));
  ASSERT_EQ(packed->warnings.size(), 1U);
  EXPECT_NE(packed->warnings[0].message.find("without compression"), std::string::npos);
  EXPECT_TRUE(parse_vtu(packed->bytes, "a.vtu").ok());
}

// Every cut, and every byte of the first block headers made another.
TEST(PackedVtu, IsReadWhateverHappensToIt) {
  const auto packed = format_vtu(test::hard_model(), Encoding::compressed);
  ASSERT_TRUE(packed.ok());
  for (std::size_t size = 0; size + 2 < packed->size(); ++size) {
    EXPECT_FALSE(parse_vtu(packed->substr(0, size), "a.vtu").ok()) << size;
  }
  const std::size_t data = packed->find("<AppendedData");
  std::size_t refused = 0;
  for (std::size_t at = data; at < packed->size(); ++at) {
    for (const int flip : {1, 0x80, 0xFF}) {
      std::string other = *packed;
      other[at] = static_cast<char>(other[at] ^ flip);
      refused += parse_vtu(other, "a.vtu").ok() ? 0U : 1U;
    }
  }
  EXPECT_GT(refused, (packed->size() - data) * 2);
}

}  // namespace
}  // namespace tetloft

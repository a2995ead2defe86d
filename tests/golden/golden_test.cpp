// Small models compared with stored ones, bit by bit; `--regenerate` stores them (README.md).
#include <gtest/gtest.h>

#include <array>
#include <cstdio>
#include <fstream>
#include <iostream>
#include <iterator>
#include <string>
#include <string_view>

#include <tetloft/io.hpp>
#include <tetloft/reconstruct.hpp>

namespace tetloft::testing {
namespace {

// One with coarse contours divided; as they are, models are small.
constexpr std::string_view kDivided = "loft";
constexpr std::array<const char*, 5> kNames{"triangular_prism", "fork", "ring", "nested_hole",
                                            "loft"};

// Hex floats leave some freedom; with a leading 1 (0 for zero) and no trailing zeros the
// text is unique.
std::string hex(double value) {
  std::array<char, 40> buffer{};
  std::snprintf(buffer.data(), buffer.size(), "%a", value);
  return buffer.data();
}

// As files have it: -1 for none.
template <class IdType>
std::string number(IdType id) {
  return id.valid() ? std::to_string(id.value()) : "-1";
}

std::string text_of(const Model& model) {
  std::string text = "points " + std::to_string(model.points.size()) + '\n';
  for (std::size_t i = 0; i < model.points.size(); ++i) {
    const VertexId v(i);
    const Point3& p = model.points[v];
    text += hex(p.x) + ' ' + hex(p.y) + ' ' + hex(p.z) + ' ' + name_of(model.origin[v]) + ' ' +
            number(model.section[v]) + ' ' + number(model.contour[v]) + '\n';
  }
  text += "tets " + std::to_string(model.tets.size()) + '\n';
  for (std::size_t i = 0; i < model.tets.size(); ++i) {
    const TetId t(i);
    for (const VertexId v : model.tets[t]) text += std::to_string(v.index()) + ' ';
    text += std::to_string(model.component[t].index()) + ' ' +
            std::to_string(model.slab[t].index()) + ' ' + name_of(model.kind[t]) + '\n';
  }
  return text;
}

Result<std::string> reconstructed(const std::string& name) {
  const Result<ReadStack> read =
      read_cnt(std::string(TETLOFT_DATA_DIR) + "/cases/" + name + ".cnt");
  if (!read) return read.error();
  const Result<Reconstruction> result =
      reconstruct(read->stack, {.divide_coarse = name == kDivided});
  if (!result) return result.error();
  return text_of(result->model);
}

std::string golden_path(const std::string& name) {
  return std::string(TETLOFT_GOLDEN_DIR) + '/' + name + ".txt";
}

class Golden : public ::testing::TestWithParam<const char*> {};

TEST_P(Golden, ModelIsTheStoredOneBitForBit) {
  const Result<std::string> text = reconstructed(GetParam());
  ASSERT_TRUE(text.ok()) << to_string(text.error());
  std::ifstream file(golden_path(GetParam()), std::ios::binary);
  ASSERT_TRUE(file.is_open());
  const std::string stored{std::istreambuf_iterator<char>(file), {}};
  EXPECT_EQ(*text, stored);
}

INSTANTIATE_TEST_SUITE_P(Cases, Golden, ::testing::ValuesIn(kNames),
                         [](const auto& instance) { return std::string(instance.param); });

int regenerate() {
  for (const char* name : kNames) {
    const Result<std::string> text = reconstructed(name);
    const Result<void> written =
        text.ok() ? write_file(golden_path(name), *text) : Result<void>(text.error());
    if (!written) {
      std::cerr << name << ": " << to_string(written.error()) << '\n';
      return 1;
    }
  }
  return 0;
}

}  // namespace
}  // namespace tetloft::testing

int main(int argc, char** argv) {
  if (argc == 2 && std::string_view(argv[1]) == "--regenerate") {
    return tetloft::testing::regenerate();
  }
  ::testing::InitGoogleTest(&argc, argv);
  return RUN_ALL_TESTS();
}

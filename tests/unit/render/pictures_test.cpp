// Pictures, decoded by code of the tests, and looked at where their content is known.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include <tetloft/render.hpp>

#include "core/prng.hpp"
#include "unit/render/boxes.hpp"
#include "unit/render/inflate.hpp"

namespace tetloft {

using namespace internal;
namespace {

using test::boxes;

struct Image {
  std::size_t width = 0, height = 0, channels = 0;
  std::string bytes;
  [[nodiscard]] int at(std::size_t x, std::size_t y, std::size_t c) const {
    return static_cast<unsigned char>(bytes[(y * width + x) * channels + c]);
  }
  [[nodiscard]] double covered() const {
    double n = 0;
    for (std::size_t y = 0; y < height; ++y) {
      for (std::size_t x = 0; x < width; ++x) n += at(x, y, 3) / 255.0;
    }
    return n;
  }
};

std::uint32_t word(const std::string& bytes, std::size_t at) {
  std::uint32_t value = 0;
  for (std::size_t k = 0; k < 4; ++k)
    value = value << 8 | static_cast<unsigned char>(bytes[at + k]);
  return value;
}

// CRC-32 of ISO/IEC 15948, annex D, one bit at a time as a polynomial division.
std::uint32_t crc_of(const std::string& bytes) {
  std::uint32_t remainder = 0xFFFFFFFFU;
  for (const char c : bytes) {
    for (unsigned k = 0; k < 8; ++k) {
      const unsigned bit = static_cast<unsigned char>(c) >> k & 1U;
      const bool carry = ((remainder ^ bit) & 1U) != 0;
      remainder >>= 1;
      if (carry) remainder ^= 0xEDB88320U;
    }
  }
  return remainder ^ 0xFFFFFFFFU;
}

std::optional<Image> decode_png(const std::string& file) {
  if (file.substr(0, 8) != "\x89PNG\r\n\x1a\n") return std::nullopt;
  Image image;
  std::string data;
  bool ended = false;
  for (std::size_t at = 8; at + 12 <= file.size() && !ended;) {
    const std::size_t n = word(file, at);
    if (at + 12 + n > file.size()) return std::nullopt;
    if (word(file, at + 8 + n) != crc_of(file.substr(at + 4, n + 4))) return std::nullopt;
    const std::string type = file.substr(at + 4, 4);
    if (type == "IHDR") {
      image.width = word(file, at + 8);
      image.height = word(file, at + 12);
      image.channels = file[at + 17] == 2 ? 3 : 4;
    }
    if (type == "IDAT") data += file.substr(at + 8, n);
    ended = type == "IEND";
    at += 12 + n;
  }
  const auto rows = test::inflate(data);
  const std::size_t stride = image.width * image.channels;
  if (!ended || !rows || rows->size() != (stride + 1) * image.height) return std::nullopt;
  std::string before(stride, '\0');
  for (std::size_t y = 0; y < image.height; ++y) {
    const int filter = (*rows)[y * (stride + 1)];
    std::string row = rows->substr(y * (stride + 1) + 1, stride);
    for (std::size_t i = 0; i < stride; ++i) {
      const int left = i < image.channels ? 0 : static_cast<unsigned char>(row[i - image.channels]);
      const int up = static_cast<unsigned char>(before[i]);
      const int corner =
          i < image.channels ? 0 : static_cast<unsigned char>(before[i - image.channels]);
      int add = 0;
      if (filter == 1) add = left;
      if (filter == 2) add = up;
      if (filter == 3) add = (left + up) / 2;
      if (filter == 4) {
        const int p = left + up - corner;
        add = corner;
        if (std::abs(p - up) <= std::abs(p - corner)) add = up;
        if (std::abs(p - left) <= std::abs(p - up) && std::abs(p - left) <= std::abs(p - corner)) {
          add = left;
        }
      }
      row[i] = static_cast<char>(static_cast<unsigned char>(row[i]) + add);
    }
    image.bytes += row;
    before = row;
  }
  return image;
}

RenderOptions small() {
  RenderOptions options;
  options.width = 200;
  options.height = 200;
  options.contours = false;
  return options;
}

Image picture(const Model& model, const RenderOptions& options) {
  const auto png = render_png(model, nullptr, options);
  EXPECT_TRUE(png) << to_string(png.error());
  const auto image = png ? decode_png(*png) : std::nullopt;
  EXPECT_TRUE(image);
  return image.value_or(Image{});
}

TEST(Png, ABoxFromTheFrontIsARectangleOfItsProportions) {
  RenderOptions options = small();
  options.azimuth = -90;
  options.elevation = 0;
  const Image image = picture(boxes(1), options);
  // 2 wide, 3 high, in 92 of 100 parts of 200 pixels.
  EXPECT_NEAR(image.covered(), 184.0 * 184.0 * 2 / 3, 200);
  EXPECT_EQ(image.at(100, 100, 3), 255);
  EXPECT_EQ(image.at(20, 100, 3), 0);
  // One face, one light but for hollows and rounding.
  EXPECT_NEAR(image.at(100, 100, 0), image.at(70, 140, 0), 2);
}

TEST(Png, StretchExplodeAndCutChangeTheOutlineAsTheySay) {
  RenderOptions options = small();
  options.azimuth = -90;
  options.elevation = 0;
  options.stretch = 0.5;
  EXPECT_NEAR(picture(boxes(1), options).covered(), 184.0 * 184.0 * 3 / 4, 200);
  options.stretch = 1;
  // Two boxes of 3 and half a gap of 3 between them: 7.5 high.
  options.explode = 0.5;
  EXPECT_NEAR(picture(boxes(2), options).covered(), 184.0 * 184.0 * 2 * 6 / 7.5 / 7.5, 300);
  options.explode = 0;
  options.cut = PictureCut{2, 1};
  EXPECT_NEAR(picture(boxes(1), options).covered(), 184.0 * 184.0 / 2, 200);
  // The part away from the eye stays: seen from −y, the cut face at y = 1 covers all.
  options.cut = PictureCut{1, 1};
  EXPECT_NEAR(picture(boxes(1), options).covered(), 184.0 * 184.0 * 2 / 3, 200);
  // From +x of two boxes the farther one is left.
  options.cut = PictureCut{0, 3};
  options.azimuth = 0;
  EXPECT_NEAR(picture(boxes(1, 2), options).covered(), 184.0 * 184.0 * 2 / 3, 200);
}

TEST(Png, ACutFaceHasNoGapsAlsoThroughVertices) {
  for (const double position : {0.5, 1.0, 2.999, 3.0, 4.0}) {
    for (int axis = 0; axis < 3; ++axis) {
      RenderOptions options = small();
      options.azimuth = axis == 1 ? -90 : 0;
      options.elevation = axis == 2 ? 90 : 0;
      options.cut = PictureCut{axis, axis == 2 ? position : position / 4};
      const Image image = picture(boxes(2), options);
      // A rectangle: every row that is covered is covered to the same pixels.
      std::set<double> rows;
      for (std::size_t y = 0; y < image.height; ++y) {
        double covered = 0;
        for (std::size_t x = 0; x < image.width; ++x) covered += image.at(x, y, 3);
        if (covered > 0) rows.insert(std::round(covered / 255));
      }
      EXPECT_GE(rows.size(), 1U) << axis << ' ' << position;
      EXPECT_LE(rows.size(), 2U) << axis << ' ' << position;
    }
  }
}

TEST(Png, ACutThroughAVertexIsCoveredHoweverTheTetIsNumbered) {
  // Cut at z = 0 through the first vertex, between the second and the others: from above the cut
  // face hides all that is left.
  Model model;
  for (const Point3& p :
       {Point3{0, 0, 0}, Point3{0.2, 0.2, -1}, Point3{0, 2, 1}, Point3{2, 0, 1}}) {
    model.points.push_back(p);
  }
  std::array<std::uint32_t, 4> order{0, 1, 2, 3};
  std::set<long> covered;
  do {
    std::size_t swaps = 0;
    for (std::size_t i = 0; i < 4; ++i) {
      for (std::size_t j = 0; j < i; ++j) swaps += order[j] > order[i] ? 1U : 0U;
    }
    if (swaps % 2 != 0) continue;  // a negative tet
    model.tets.clear();
    model.tets.push_back(
        {VertexId(order[0]), VertexId(order[1]), VertexId(order[2]), VertexId(order[3])});
    RenderOptions options = small();
    options.elevation = 90;
    options.cut = PictureCut{2, 0};
    covered.insert(std::lround(picture(model, options).covered()));
  } while (std::next_permutation(order.begin(), order.end()));
  ASSERT_EQ(covered.size(), 1U);
  EXPECT_GT(*covered.begin(), 5000);
}

TEST(Png, ColoursTellComponentsSlabsAndQualityApart) {
  const auto colours_of = [](ColourBy by) {
    RenderOptions options = small();
    options.azimuth = -90;
    options.elevation = 0;
    options.colour = by;
    const Image image = picture(boxes(2, 2), options);
    std::set<std::array<int, 3>> found;
    for (const auto& [x, y] : {std::pair{34, 60}, std::pair{34, 140}, std::pair{166, 60}}) {
      const auto ux = static_cast<std::size_t>(x);
      const auto uy = static_cast<std::size_t>(y);
      EXPECT_EQ(image.at(ux, uy, 3), 255);
      // Shades of hollows aside.
      found.insert({image.at(ux, uy, 0) / 16, image.at(ux, uy, 1) / 16, image.at(ux, uy, 2) / 16});
    }
    return found.size();
  };
  EXPECT_EQ(colours_of(ColourBy::kind), 1U);
  EXPECT_EQ(colours_of(ColourBy::slab), 2U);
  EXPECT_EQ(colours_of(ColourBy::component), 2U);
}

TEST(Png, ContoursAndEdgesAreDrawn) {
  RenderOptions options = small();
  const auto dark = [&](const Model& model) {
    const Image image = picture(model, options);
    std::size_t n = 0;
    for (std::size_t y = 0; y < image.height; ++y) {
      for (std::size_t x = 0; x < image.width; ++x) {
        n += image.at(x, y, 3) > 200 && image.at(x, y, 0) < 60 ? 1U : 0U;
      }
    }
    return n;
  };
  options.azimuth = -50;
  EXPECT_EQ(dark(boxes(2)), 0U);
  options.contours = true;
  const std::size_t with_contours = dark(boxes(2));
  EXPECT_GT(with_contours, 50U);
  // Contours that are given instead: of a second stack, at the middle of the first slab only.
  SectionStack stack;
  stack.sections.push_back({1.5, {}});
  stack.sections[SectionId(0)].contours.push_back({{{0, 0}, {2, 0}, {2, 2}, {0, 2}}});
  const auto png = render_png(boxes(2), &stack, options);
  ASSERT_TRUE(png);
  EXPECT_NE(*png, *render_png(boxes(2), nullptr, options));
  options.white = true;
  const Image white = picture(boxes(1), options);
  EXPECT_EQ(white.channels, 3U);
  EXPECT_EQ(white.at(0, 0, 0), 255);
}

TEST(Svg, DrawsSeenTrianglesOnlyAndTwelveOfABoxHaveSix) {
  RenderOptions options = small();
  const auto svg = render_svg(boxes(1), nullptr, options);
  ASSERT_TRUE(svg);
  std::size_t paths = 0;
  for (std::size_t at = svg->find("<path"); at != std::string::npos;
       at = svg->find("<path", at + 1)) {
    ++paths;
  }
  EXPECT_EQ(paths, 6U);
  options.contours = true;
  const auto with_lines = render_svg(boxes(1), nullptr, options);
  ASSERT_TRUE(with_lines);
  EXPECT_GT(with_lines->size(), svg->size());
  EXPECT_EQ(with_lines->find("nan"), std::string::npos);
  EXPECT_TRUE(with_lines->ends_with("</svg>\n"));
}

TEST(Pictures, AreTheSameAtEveryScale) {
  const auto scaled = [](int exponent) {
    Model model = boxes(2, 2);
    for (Point3& p : model.points) {
      p = {std::ldexp(p.x, exponent), std::ldexp(p.y, exponent), std::ldexp(p.z, exponent)};
    }
    return model;
  };
  RenderOptions options = small();
  options.contours = options.edges = true;
  options.explode = 0.5;
  for (const int exponent : {-900, -300, 70, 900}) {
    options.cut = PictureCut{2, 2.5};
    const auto png = render_png(scaled(0), nullptr, options);
    const auto svg = render_svg(scaled(0), nullptr, options);
    ASSERT_TRUE(png && svg);
    options.cut->position = std::ldexp(2.5, exponent);
    const auto other = render_png(scaled(exponent), nullptr, options);
    ASSERT_TRUE(other) << to_string(other.error());
    EXPECT_TRUE(*other == *png) << exponent;
    EXPECT_EQ(*render_svg(scaled(exponent), nullptr, options), *svg) << exponent;
  }
}

TEST(Pictures, RefuseWhatCannotBeDrawn) {
  const auto refused = [](const Model& model, const RenderOptions& options) {
    const auto png = render_png(model, nullptr, options);
    EXPECT_EQ(bool(png), bool(render_svg(model, nullptr, options)));
    EXPECT_EQ(bool(png), bool(render_html(model, nullptr, options)));
    return png ? std::nullopt : std::optional(png.error().code);
  };
  RenderOptions options = small();
  EXPECT_EQ(refused(boxes(1), options), std::nullopt);
  EXPECT_EQ(refused({}, options), ErrorCode::invalid_input);
  Model model = boxes(1);
  model.tets[TetId(0)][2] = VertexId(99);
  EXPECT_EQ(refused(model, options), ErrorCode::invalid_input);
  model = boxes(1);
  model.points[VertexId(0)].x = std::nan("");
  EXPECT_EQ(refused(model, options), ErrorCode::invalid_input);
  model = boxes(1);
  model.slab.resize(2);
  EXPECT_EQ(refused(model, options), ErrorCode::invalid_input);
  model = boxes(1);
  model.kind.clear();
  options.colour = ColourBy::kind;
  EXPECT_EQ(refused(model, options), ErrorCode::usage);
  model = boxes(1);
  options.colour = ColourBy::evidence;
  EXPECT_EQ(refused(model, options), ErrorCode::usage);
  model.links.push_back({SlabId(0), ContourId(0), ContourId(0)});
  EXPECT_EQ(refused(model, options), std::nullopt);
  for (const auto& change : std::vector<void (*)(Model&)>{[](Model& m) { m.slab.clear(); },
                                                          [](Model& m) { m.section.clear(); },
                                                          [](Model& m) { m.contour.clear(); }}) {
    Model less = model;
    change(less);
    EXPECT_EQ(refused(less, options), ErrorCode::usage);
  }
  for (const auto& change : std::vector<void (*)(RenderOptions&)>{
           [](RenderOptions& o) { o.width = 0; }, [](RenderOptions& o) { o.height = 9000; },
           [](RenderOptions& o) { o.elevation = 91; }, [](RenderOptions& o) { o.explode = -1; },
           [](RenderOptions& o) { o.stretch = 0; }, [](RenderOptions& o) { o.azimuth = 1 / 0.0; },
           [](RenderOptions& o) {
             o.cut = PictureCut{3, 0};
           }}) {
    options = small();
    change(options);
    EXPECT_EQ(refused(boxes(1), options), ErrorCode::usage);
  }
  for (int axis = 0; axis < 3; ++axis) {
    options = small();
    options.cut = PictureCut{axis, 1};
    EXPECT_EQ(refused(boxes(1), options), std::nullopt);
  }
  // A model without any data but points and tets.
  Model bare;
  bare.points = boxes(1).points;
  bare.tets = boxes(1).tets;
  EXPECT_EQ(refused(bare, small()), std::nullopt);
}

}  // namespace
}  // namespace tetloft

#include "render/palette.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

namespace tetloft::internal::render {

namespace {

// Type 1 in earth, reverse in reds, the rest in greens and blues, ends in grey.
constexpr std::array<Rgb, kTetKinds> kKinds{{{216, 190, 140},
                                             {158, 132, 96},
                                             {190, 60, 66},
                                             {226, 126, 84},
                                             {240, 186, 96},
                                             {70, 120, 160},
                                             {98, 166, 176},
                                             {136, 176, 120},
                                             {150, 154, 164}}};

// What lies as it is in calm colours, what was inferred in loud ones, what the user said in
// violets; without a link in grey.
constexpr std::array<Rgb, kEvidences + 1> kEvidence{{{120, 158, 178},
                                                     {150, 134, 100},
                                                     {94, 176, 142},
                                                     {240, 180, 60},
                                                     {214, 78, 62},
                                                     {122, 96, 178},
                                                     {196, 108, 178},
                                                     {232, 140, 70},
                                                     {206, 208, 212}}};

constexpr std::array<Rgb, 6> kSlabs{{{54, 62, 120},
                                     {56, 118, 158},
                                     {70, 168, 150},
                                     {150, 200, 112},
                                     {240, 208, 100},
                                     {236, 146, 84}}};

constexpr std::array<Rgb, 6> kDihedral{{{150, 22, 44},
                                        {214, 84, 52},
                                        {240, 168, 80},
                                        {226, 218, 150},
                                        {120, 186, 160},
                                        {46, 120, 142}}};

std::uint8_t byte_of(double value) {
  return static_cast<std::uint8_t>(std::lround(std::clamp(value, 0.0, 255.0)));
}

Rgb along(std::span<const Rgb> stops, double t) {
  const double at = std::clamp(t, 0.0, 1.0) * static_cast<double>(stops.size() - 1);
  const std::size_t i = std::min(static_cast<std::size_t>(at), stops.size() - 2);
  const double f = at - static_cast<double>(i);
  const auto mixed = [f](std::uint8_t a, std::uint8_t b) { return byte_of((1 - f) * a + f * b); };
  const Rgb& a = stops[i];
  const Rgb& b = stops[i + 1];
  return {mixed(a.r, b.r), mixed(a.g, b.g), mixed(a.b, b.b)};
}

}  // namespace

Rgb kind_colour(TetKind kind) { return kKinds[static_cast<std::size_t>(kind) % kKinds.size()]; }

Rgb evidence_colour(std::size_t evidence) {
  return kEvidence[std::min(evidence, kEvidence.size() - 1)];
}

Rgb slab_colour(double t) { return along(kSlabs, t); }

Rgb dihedral_colour(double t) { return along(kDihedral, t); }

std::string hex(const Rgb& colour) {
  constexpr char kDigits[] = "0123456789abcdef";
  std::string text = "#";
  for (const unsigned value : {colour.r, colour.g, colour.b}) {
    text += kDigits[value >> 4];
    text += kDigits[value & 15U];
  }
  return text;
}

}  // namespace tetloft::internal::render

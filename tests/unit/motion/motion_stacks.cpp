#include "unit/motion/motion_stacks.hpp"

#include "core/prng.hpp"

namespace tetloft::testing {

using namespace internal;

Contour octagon(const Point2& c, double radius) {
  const double s = radius * 0.707;
  return {{{c.x + radius, c.y},
           {c.x + s, c.y + s},
           {c.x, c.y + radius},
           {c.x - s, c.y + s},
           {c.x - radius, c.y},
           {c.x - s, c.y - s},
           {c.x, c.y - radius},
           {c.x + s, c.y - s}}};
}

SectionStack leaning_rods(const std::vector<Point2>& centres, double radius, const Point2& lean,
                          const std::vector<double>& heights) {
  SectionStack stack;
  for (const double z : heights) {
    Section section{z, {}};
    for (const Point2& c : centres) {
      section.contours.push_back(octagon({c.x + z * lean.x, c.y + z * lean.y}, radius));
    }
    stack.sections.push_back(std::move(section));
  }
  return stack;
}

SectionStack drifting_polygons(std::uint64_t seed, std::size_t sections) {
  Prng prng(seed);
  SectionStack stack;
  double z = 0;
  std::vector<Point2> centres;
  for (int k = 0; k < 6; ++k) {
    centres.push_back({(k % 3) * 2.5 + prng.unit() / 4, (k / 3) * 2.5 + prng.unit() / 4});
  }
  for (std::size_t s = 0; s < sections; ++s) {
    Section section{z, {}};
    for (Point2& c : centres) {
      Contour contour = octagon(c, 0.5 + prng.unit() / 8);
      for (Point2& p : contour.vertices) {
        p = {p.x + prng.unit() / 8, p.y + prng.unit() / 8};
      }
      section.contours.push_back(std::move(contour));
      c = {c.x + prng.unit() / 8, c.y - prng.unit() / 8};
    }
    stack.sections.push_back(std::move(section));
    z += 0.75 + prng.unit() / 2;
  }
  return stack;
}

IdVector<SectionId, Nesting> nestings_of(const SectionStack& stack) {
  IdVector<SectionId, Nesting> nestings;
  for (const Section& section : stack.sections) nestings.push_back(nest(section));
  return nestings;
}

SlabMotions all_motions(const SectionStack& stack, std::size_t slab) {
  const IdVector<SectionId, Nesting> nestings = nestings_of(stack);
  WantedRegions wanted;
  for (const RegionId r : nestings[SectionId(slab)].outer.ids()) wanted.lower.push_back(r);
  for (const RegionId r : nestings[SectionId(slab + 1)].outer.ids()) wanted.upper.push_back(r);
  return estimate_motions(SlabId(slab), stack, nestings, wanted);
}

}  // namespace tetloft::testing

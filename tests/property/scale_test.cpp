// Powers of two scale the model and change nothing else, as far as doubles go: coordinates of
// some 2^-900 to 2^900, every mode, what is done to stacks before and to models after.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <tetloft/check.hpp>
#include <tetloft/geiger.hpp>
#include <tetloft/reconstruct.hpp>

#include "property/same_model.hpp"
#include "support/stacks/generate.hpp"

namespace tetloft::testing {
namespace {

constexpr std::uint64_t kFirstSeed = 700;
// The exponent of the largest coordinate magnitude.
constexpr std::array kLargest{-900, -520, 520, 900};

SectionStack times(SectionStack stack, int exponent) {
  for (Section& section : stack.sections) {
    section.z = std::ldexp(section.z, exponent);
    for (Contour& contour : section.contours) {
      for (Point2& p : contour.vertices) {
        p = {std::ldexp(p.x, exponent), std::ldexp(p.y, exponent)};
      }
    }
  }
  return stack;
}

Model times(Model model, int exponent) {
  for (Point3& p : model.points) {
    p = {std::ldexp(p.x, exponent), std::ldexp(p.y, exponent), std::ldexp(p.z, exponent)};
  }
  for (RegionMotion& motion : model.motions) {
    motion.by = {std::ldexp(motion.by.x, exponent), std::ldexp(motion.by.y, exponent)};
  }
  return model;
}

// The exponents of the largest and the smallest magnitude but 0.
std::pair<int, int> magnitudes(const SectionStack& stack) {
  double largest = 0;
  double smallest = std::numeric_limits<double>::infinity();
  const auto include = [&](double value) {
    largest = std::max(largest, std::abs(value));
    if (value != 0) smallest = std::min(smallest, std::abs(value));
  };
  for (const Section& section : stack.sections) {
    include(section.z);
    for (const Contour& contour : section.contours) {
      for (const Point2& p : contour.vertices) {
        include(p.x);
        include(p.y);
      }
    }
  }
  return {std::ilogb(largest), std::ilogb(smallest)};
}

// Calls body(kind, stack, exponents): multiplied by 2 to each of the exponents, the stack has no
// denormal coordinate, nor has what is made of it.
void for_each_stack(
    std::uint64_t seeds, bool large,
    const std::function<void(StackKind, const GeneratedStack&, const std::vector<int>&)>& body) {
  constexpr int kRoom = 60;  // for the bits of what is constructed
  for (const StackKind kind : all_kinds()) {
    if (!large && kind == StackKind::large_contours) continue;
    for (std::uint64_t seed = kFirstSeed; seed < kFirstSeed + seeds; ++seed) {
      SCOPED_TRACE(std::string(name_of(kind)) + " seed " + std::to_string(seed));
      const GeneratedStack generated = generate(kind, seed);
      const auto [largest, smallest] = magnitudes(generated.stack);
      if (smallest - kRoom <= -1022) continue;
      std::vector<int> exponents;
      for (const int at : kLargest) {
        if (smallest - largest + at - kRoom > -1022) exponents.push_back(at - largest);
      }
      body(kind, generated, exponents);
    }
  }
}

void expect_scaled(const Result<Reconstruction>& before, const Result<Reconstruction>& after,
                   int exponent) {
  ASSERT_EQ(before.ok(), after.ok());
  if (!before.ok()) {
    EXPECT_EQ(before.error().code, after.error().code);
    EXPECT_EQ(before.error().message, after.error().message);
    EXPECT_EQ(before.error().where.section, after.error().where.section);
    EXPECT_EQ(before.error().where.slab, after.error().where.slab);
    ASSERT_EQ(before.error().where.point.has_value(), after.error().where.point.has_value());
    if (!before.error().where.point) return;
    const Point3& p = *before.error().where.point;
    EXPECT_EQ(
        (Point3{std::ldexp(p.x, exponent), std::ldexp(p.y, exponent), std::ldexp(p.z, exponent)}),
        *after.error().where.point);
    return;
  }
  EXPECT_TRUE(same_bits(times(before->model, exponent), after->model));
  EXPECT_EQ(before->partition, after->partition);
  EXPECT_EQ(before->report.rules, after->report.rules);
  EXPECT_EQ(before->report.smallest_lift, after->report.smallest_lift);
  EXPECT_EQ(std::ldexp(before->report.volume, 3 * exponent), after->report.volume);
}

using Options = std::function<ReconstructOptions(const GeneratedStack&, int exponent)>;

// How many models were compared.
std::size_t compare(std::uint64_t seeds, bool large, const Options& options) {
  std::size_t compared = 0;
  for_each_stack(
      seeds, large,
      [&](StackKind, const GeneratedStack& generated, const std::vector<int>& exponents) {
        const auto before = reconstruct(generated.stack, options(generated, 0));
        for (const int exponent : exponents) {
          SCOPED_TRACE("times 2^" + std::to_string(exponent));
          const auto after =
              reconstruct(times(generated.stack, exponent), options(generated, exponent));
          expect_scaled(before, after, exponent);
          if (before.ok()) ++compared;
        }
      });
  return compared;
}

ReconstructOptions defaults(const GeneratedStack& generated) {
  ReconstructOptions options;
  options.execution.threads = 1;
  options.correspondence = generated.correspondence;
  return options;
}

TEST(Scale, ModelsOfAllKindsAreTheSame) {
  EXPECT_GT(compare(2, true, [](const GeneratedStack& g, int) { return defaults(g); }), 150U);
}

TEST(Scale, ReverseCorrespondenceIsTheSame) {
  EXPECT_GT(compare(1, false,
                    [](const GeneratedStack& g, int) {
                      ReconstructOptions options = defaults(g);
                      options.correspondence.criterion = Criterion::reverse;
                      return options;
                    }),
            80U);
}

TEST(Scale, OverlapCorrespondenceAndHalfEndsAreTheSame) {
  EXPECT_GT(compare(1, false,
                    [](const GeneratedStack& g, int) {
                      ReconstructOptions options = defaults(g);
                      options.correspondence.criterion = Criterion::overlap;
                      options.ends = Ends::half;
                      return options;
                    }),
            80U);
}

TEST(Scale, SingleSectionsOfAnyThicknessAreTheSame) {
  std::size_t compared = 0;
  for_each_stack(1, false,
                 [&](StackKind, const GeneratedStack& g, const std::vector<int>& exponents) {
                   SectionStack single;
                   single.sections.push_back(g.stack.sections[SectionId(0)]);
                   if (single.sections[SectionId(0)].contours.empty()) return;
                   for (const double thickness : {0.0, 0.3, 700.0}) {
                     const auto run = [&](int exponent) {
                       ReconstructOptions options;
                       options.execution.threads = 1;
                       if (thickness != 0) options.thickness = std::ldexp(thickness, exponent);
                       return reconstruct(times(single, exponent), options);
                     };
                     const auto before = run(0);
                     for (const int exponent : exponents) {
                       expect_scaled(before, run(exponent), exponent);
                       ++compared;
                     }
                   }
                 });
  EXPECT_GT(compared, 200U);
}

TEST(Scale, GeigersModelsAreTheSame) {
  std::size_t compared = 0;
  for_each_stack(1, false,
                 [&](StackKind, const GeneratedStack& g, const std::vector<int>& exponents) {
                   const GeigerOptions options{1, true};
                   const auto before = reconstruct_geiger(g.stack, options);
                   for (const int exponent : exponents) {
                     const auto after = reconstruct_geiger(times(g.stack, exponent), options);
                     ASSERT_EQ(before.ok(), after.ok());
                     if (!before.ok()) continue;
                     EXPECT_TRUE(same_bits(times(before->model, exponent), after->model));
                     ++compared;
                   }
                 });
  EXPECT_GT(compared, 80U);
}

bool same_bits(const SectionStack& a, const SectionStack& b) {
  if (a.sections.size() != b.sections.size()) return false;
  for (std::size_t s = 0; s < a.sections.size(); ++s) {
    const Section& p = a.sections[SectionId(s)];
    const Section& q = b.sections[SectionId(s)];
    if (p.z != q.z || p.contours.size() != q.contours.size()) return false;
    for (std::size_t c = 0; c < p.contours.size(); ++c) {
      if (p.contours[ContourId(c)].vertices != q.contours[ContourId(c)].vertices) return false;
    }
  }
  return true;
}

TEST(Scale, RefiningSnappingAndRepairingAreTheSame) {
  std::size_t compared = 0;
  const auto expect_same = [&](const auto& before, const auto& after, int exponent) {
    ASSERT_EQ(before.ok(), after.ok());
    if (!before.ok()) return;
    EXPECT_TRUE(same_bits(times(before->stack, exponent), after->stack));
    ++compared;
  };
  for_each_stack(1, false,
                 [&](StackKind, const GeneratedStack& g, const std::vector<int>& exponents) {
                   const double length = std::ldexp(1.0, magnitudes(g.stack).first - 4);
                   SectionStack slips = g.stack;  // each contour a second time, moved onto itself
                   for (Section& section : slips.sections) {
                     if (section.contours.empty()) continue;
                     Contour copy = section.contours[ContourId(0)];
                     for (Point2& p : copy.vertices) p.x += length / 3;
                     section.contours.push_back(std::move(copy));
                   }
                   for (const int exponent : exponents) {
                     SCOPED_TRACE("times 2^" + std::to_string(exponent));
                     const SectionStack stack = times(g.stack, exponent);
                     expect_same(refine(g.stack, length),
                                 refine(stack, std::ldexp(length, exponent)), exponent);
                     expect_same(snap(g.stack, 12), snap(stack, 12), exponent);
                     expect_same(repair(slips), repair(times(slips, exponent)), exponent);
                   }
                 });
  EXPECT_GT(compared, 200U);
}

TEST(Scale, ConformingSectionsAreTheSame) {
  std::size_t compared = 0;
  for_each_stack(1, false,
                 [&](StackKind, const GeneratedStack& g, const std::vector<int>& exponents) {
                   for (const int exponent : exponents) {
                     const SectionStack stack = times(g.stack, exponent);
                     for (std::size_t s = 0; s < stack.sections.size(); ++s) {
                       const SectionId id(s);
                       const auto before = conform(g.stack.sections[id], id);
                       const auto after = conform(stack.sections[id], id);
                       ASSERT_EQ(before.ok(), after.ok());
                       if (!before.ok()) continue;
                       ASSERT_EQ(before->vertex_count(), after->vertex_count());
                       for (std::size_t v = 0; v < before->vertex_count(); ++v) {
                         const Point2& p = before->point(PlaneVertexId(v));
                         EXPECT_EQ((Point2{std::ldexp(p.x, exponent), std::ldexp(p.y, exponent)}),
                                   after->point(PlaneVertexId(v)));
                       }
                       EXPECT_EQ(before->triangulation.triangles, after->triangulation.triangles);
                       ++compared;
                     }
                   }
                 });
  EXPECT_GT(compared, 250U);
}

TEST(Scale, SkeletonCrossingsAreTheSame) {
  std::size_t compared = 0;
  for_each_stack(
      1, false, [&](StackKind, const GeneratedStack& g, const std::vector<int>& exponents) {
        const auto crossings_of = [](const SectionStack& stack) {
          std::vector<std::vector<SkeletonCrossing>> result;
          for (std::size_t s = 0; s + 1 < stack.sections.size(); ++s) {
            const auto below = conform(stack.sections[SectionId(s)], SectionId(s));
            const auto above = conform(stack.sections[SectionId(s + 1)], SectionId(s + 1));
            if (!below.ok() || !above.ok()) continue;
            result.push_back(skeleton_crossings(*below, *above));
          }
          return result;
        };
        const auto before = crossings_of(g.stack);
        for (const int exponent : exponents) {
          SCOPED_TRACE("times 2^" + std::to_string(exponent));
          EXPECT_EQ(before, crossings_of(times(g.stack, exponent)));
          compared += before.size();
        }
      });
  EXPECT_GT(compared, 150U);
}

std::vector<bool> verdicts(const CheckReport& report) {
  std::vector<bool> result;
  for (const GuaranteeVerdict& verdict : report.guarantees) result.push_back(verdict.pass);
  return result;
}

// `criterion`: what the model is made by, and checked by; it need not pass.
std::size_t compare_checks(Criterion criterion) {
  std::size_t compared = 0;
  for_each_stack(
      1, false, [&](StackKind, const GeneratedStack& g, const std::vector<int>& exponents) {
        ReconstructOptions made_by = defaults(g);
        made_by.correspondence.criterion = criterion;
        const auto made = reconstruct(g.stack, made_by);
        if (!made.ok()) return;
        CheckOptions options;
        options.correspondence = made_by.correspondence;
        const auto before = check(made->model, g.stack, options);
        ASSERT_TRUE(before.ok() && before->pass());
        for (const int exponent : exponents) {
          SCOPED_TRACE("times 2^" + std::to_string(exponent));
          const auto after = check(times(made->model, exponent), times(g.stack, exponent), options);
          ASSERT_TRUE(after.ok());
          EXPECT_EQ(verdicts(*before), verdicts(*after));
          EXPECT_EQ(before->genus, after->genus);
          EXPECT_EQ(before->overshoot, after->overshoot);
          EXPECT_EQ(before->smallest_dihedral_degrees, after->smallest_dihedral_degrees);
          EXPECT_EQ(before->largest_split_ulps, after->largest_split_ulps);
          EXPECT_EQ(std::ldexp(before->volume, 3 * exponent), after->volume);
          ++compared;
        }
      });
  return compared;
}

TEST(Scale, VerdictsAndFiguresOfCheckAreTheSame) {
  EXPECT_GT(compare_checks(Criterion::overlap), 80U);
}

TEST(Scale, VerdictsOfCheckByReverseTetsAreTheSame) {
  EXPECT_GT(compare_checks(Criterion::reverse), 60U);
}

// Coordinates whose bits do not all fit beside each other near 1, and models with finer bits than
// their stack's unit holds: made without a change of unit, and right.
TEST(Scale, StacksAtTheEndsOfTheRangeHaveRightModels) {
  const auto square = [](double side, double z) {
    Section section{z, {}};
    section.contours.push_back({{{0, 0}, {side, 0}, {side, side}, {0, side}}});
    return section;
  };
  const double least = std::numeric_limits<double>::denorm_min();
  for (const auto& [side, height] : {std::pair(0x1p999, 1.0),
                                     {0x1p999, 0x1p-1000},
                                     {0x1p-1000, 0x1p998},
                                     {12 * least, 0x1p-1060},
                                     {12 * least, 2 * least},
                                     {12 * least, 4 * least}}) {
    SCOPED_TRACE(side);
    SectionStack stack;
    stack.sections.push_back(square(side, 0));
    stack.sections.push_back(square(side / 2, height));
    stack.sections.push_back(square(side, 2 * height));
    const auto made = reconstruct(stack);
    ASSERT_TRUE(made.ok()) << to_string(made.error());
    const auto report = check(made->model, stack);
    ASSERT_TRUE(report.ok());
    EXPECT_TRUE(report->pass());
  }
}

}  // namespace
}  // namespace tetloft::testing

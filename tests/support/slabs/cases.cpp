#include "support/slabs/cases.hpp"

#include <gtest/gtest.h>

#include <stdexcept>
#include <utility>

#include <tetloft/io.hpp>

#include "correspondence/overlap_links.hpp"
#include "slab/delaunay.hpp"

namespace tetloft::testing {

using namespace internal;

namespace {

template <class T>
T value_or_throw(Result<T> result) {
  if (!result) throw std::runtime_error(to_string(result.error()));
  return std::move(result).value();
}

}  // namespace

SectionStack stack_from(std::string_view text) {
  return value_or_throw(parse_cnt(text, "test")).stack;
}

SectionStack sample(const std::string& name) {
  return value_or_throw(read_cnt(std::string(TETLOFT_DATA_DIR) + '/' + name)).stack;
}

std::vector<Label> labels_from(std::string_view text) {
  return value_or_throw(parse_labels(text, "test")).labels;
}

Contour box(double x0, double y0, double x1, double y1) {
  return {{{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}}};
}

SectionStack stack_of_boxes(const std::vector<std::vector<Contour>>& sections) {
  SectionStack stack;
  for (const auto& contours : sections) {
    Section section;
    section.z = static_cast<double>(stack.sections.size());
    for (const Contour& contour : contours) section.contours.push_back(contour);
    stack.sections.push_back(std::move(section));
  }
  return stack;
}

IdVector<ClassId, std::uint8_t> SlabCase::active(bool lone_too) const {
  IdVector<ClassId, std::uint8_t> result(classes->class_count(), 1);
  for (std::size_t c = 0; c < result.size() && !lone_too; ++c) {
    if (classes->is_lone(ClassId(c))) result[ClassId(c)] = 0;
  }
  return result;
}

std::unique_ptr<SlabCase> slab_case(const SectionStack& stack, std::size_t k) {
  const Section& below = stack.sections[SectionId(k)];
  const Section& above = stack.sections[SectionId(k + 1)];
  const Nesting nesting_below = nest(below);
  const Nesting nesting_above = nest(above);
  std::vector<Link> links;
  for (const LinkCandidate& candidate :
       overlap_links(SlabId(k), {below, nesting_below}, {above, nesting_above}, kDefaultOverlap)) {
    if (candidate.made()) links.push_back(candidate.link);
  }
  return slab_case(stack, k, std::move(links));
}

std::unique_ptr<SlabCase> slab_case(const SectionStack& stack, std::size_t k,
                                    std::vector<Link> links) {
  const Section& below = stack.sections[SectionId(k)];
  const Section& above = stack.sections[SectionId(k + 1)];
  if (below.contours.empty() || above.contours.empty()) return nullptr;
  auto built = std::make_unique<SlabCase>();
  built->lower = value_or_throw(conform(below, SectionId(k)));
  built->upper = value_or_throw(conform(above, SectionId(k + 1)));
  built->links = std::move(links);
  built->slab.emplace(built->lower, built->upper,
                      value_or_throw(slab_delaunay(SlabId(0), built->lower, built->upper,
                                                   DelaunayEngine::automatic, kDefaultWorkLimit)));
  built->classes.emplace(built->lower, built->upper, built->links);
  return built;
}

std::vector<NamedSlab> generated_slabs(std::uint64_t first_seed, std::uint64_t seeds) {
  std::vector<NamedSlab> slabs;
  for (const StackKind kind : all_kinds()) {
    // Conforming itself may be refused there.
    if (is_near_coincident(kind)) continue;
    for (std::uint64_t seed = first_seed; seed < first_seed + seeds; ++seed) {
      const SectionStack stack = generate(kind, seed).stack;
      for (std::size_t k = 0; k + 1 < stack.sections.size(); ++k) {
        std::unique_ptr<SlabCase> built = slab_case(stack, k);
        if (!built) continue;
        slabs.push_back({std::string(name_of(kind)) + " seed " + std::to_string(seed) + " slab " +
                             std::to_string(k),
                         std::move(built)});
      }
    }
  }
  return slabs;
}

std::optional<Checked> reconstruct_and_check(const SectionStack& stack,
                                             const ReconstructOptions& options) {
  Result<Reconstruction> result = reconstruct(stack, options);
  if (!result) {
    ADD_FAILURE() << to_string(result.error());
    return std::nullopt;
  }
  CheckOptions check_options;
  check_options.correspondence = options.correspondence;
  Result<CheckReport> report = check(result->model, stack, check_options);
  if (!report) {
    ADD_FAILURE() << to_string(report.error());
    return std::nullopt;
  }
  for (const GuaranteeVerdict& verdict : report->guarantees) {
    for (const CheckFailure& failure : verdict.failures) {
      ADD_FAILURE() << failure.what << ", " << failure.count << " times, first "
                    << (failure.places.empty() ? "nowhere" : failure.places.front());
    }
    EXPECT_TRUE(verdict.pass) << verdict.name;
  }
  return Checked{std::move(result).value(), std::move(report).value()};
}

std::uint64_t fired(const Reconstruction& result, Rule rule) {
  return result.report.rules.at(static_cast<std::size_t>(rule));
}

long double volume6(const Point3& a, const Point3& b, const Point3& c, const Point3& d) {
  const auto difference = [&](const Point3& p) {
    return std::array<long double, 3>{static_cast<long double>(p.x) - a.x,
                                      static_cast<long double>(p.y) - a.y,
                                      static_cast<long double>(p.z) - a.z};
  };
  const auto u = difference(b);
  const auto v = difference(c);
  const auto w = difference(d);
  return (u[1] * v[2] - u[2] * v[1]) * w[0] + (u[2] * v[0] - u[0] * v[2]) * w[1] +
         (u[0] * v[1] - u[1] * v[0]) * w[2];
}

}  // namespace tetloft::testing

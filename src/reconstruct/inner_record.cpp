#include "reconstruct/inner_record.hpp"

#include <algorithm>
#include <utility>

#include "core/guard.hpp"
#include "core/option_rules.hpp"

namespace tetloft::internal {

namespace {

using between::InnerSection;
using between::InnerSections;
using between::LayerLink;

constexpr std::size_t kPoint = 2 * sizeof(double);
constexpr std::size_t kLayerLink = 2 * sizeof(std::uint32_t);
// Of vectors of vectors: their counts.
constexpr std::size_t kInnerVector = sizeof(std::uint64_t);

bool is_valid(const Section& section) {
  SectionStack alone;
  alone.sections.push_back(section);
  return section.contours.empty() || accepted(validate(alone));
}

}  // namespace

void put_section(const Section& section, RecordWriter& out) {
  out.put(section.z);
  out.put_count(section.contours.size());
  for (const Contour& contour : section.contours) {
    out.put_count(contour.vertices.size());
    for (const Point2& p : contour.vertices) {
      out.put(p.x);
      out.put(p.y);
    }
  }
}

Section get_section(RecordReader& in) {
  Section section;
  section.z = in.get<double>();
  section.contours.resize(in.get_count(kInnerVector));
  for (Contour& contour : section.contours) {
    contour.vertices.resize(in.get_count(kPoint));
    for (Point2& p : contour.vertices) {
      p.x = in.get<double>();
      p.y = in.get<double>();
    }
  }
  return section;
}

void put_inner(const InnerSections& inner, RecordWriter& out) {
  out.put(static_cast<std::uint64_t>(inner.wanted));
  out.put_count(inner.sections.size());
  for (const InnerSection& mid : inner.sections) {
    put_section(mid.section, out);
    out.put_all(mid.class_of);
  }
  out.put_count(inner.links.size());
  for (const std::vector<LayerLink>& links : inner.links) {
    out.put_count(links.size());
    for (const LayerLink& link : links) {
      out.put(link.below);
      out.put(link.above);
    }
  }
}

InnerSections get_inner(RecordReader& in) {
  InnerSections inner;
  inner.wanted = in.get<std::uint64_t>();
  in.require(inner.wanted <= kMostBetween, "puts too many sections between");
  const std::size_t sections = in.get_count(kInnerVector);
  for (std::size_t k = 0; k < sections && !in.refused(); ++k) {
    InnerSection mid;
    mid.section = get_section(in);
    mid.class_of.raw() = in.get_all<ClassId>();
    if (in.refused()) return {};
    in.require(is_valid(mid.section), "puts a section between that is not valid");
    if (in.refused()) return {};
    mid.nesting = nest(mid.section);
    in.require(mid.class_of.size() == mid.nesting.outer.size(),
               "puts regions between that are of no class");
    inner.sections.push_back(std::move(mid));
  }
  inner.links.resize(in.get_count(kInnerVector));
  in.require(inner.links.size() == (sections == 0 ? 0 : sections + 1),
             "links some of the sections between");
  for (std::size_t k = 0; k < inner.links.size() && !in.refused(); ++k) {
    inner.links[k].resize(in.get_count(kLayerLink));
    for (LayerLink& link : inner.links[k]) {
      link.below = in.get<RegionId>();
      link.above = in.get<RegionId>();
    }
  }
  return inner;
}

bool fits_slab(const InnerSections& inner, std::size_t lower, std::size_t upper) {
  const std::size_t sections = inner.sections.size();
  const auto regions = [&](std::size_t layer) {
    if (layer == 0) return lower;
    return layer > sections ? upper : inner.sections[layer - 1].nesting.outer.size();
  };
  for (const InnerSection& mid : inner.sections) {
    for (const ClassId c : mid.class_of) {
      if (c.index() >= lower + upper) return false;
    }
  }
  for (std::size_t k = 0; k < inner.links.size(); ++k) {
    for (const LayerLink& link : inner.links[k]) {
      if (link.below.index() >= regions(k) || link.above.index() >= regions(k + 1)) return false;
    }
  }
  return true;
}

}  // namespace tetloft::internal

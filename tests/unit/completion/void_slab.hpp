// A completed slab and its voids, for the tests of what is done about these.
#pragma once

#include <algorithm>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "completion/completion.hpp"
#include "completion/slab_voids.hpp"
#include "sections/conforming_section.hpp"
#include "sections/face_overlay.hpp"
#include "support/slabs/cases.hpp"

namespace tetloft::testing {

using namespace internal;

struct VoidSlab {
  VoidSlab(std::unique_ptr<SlabCase> built, std::vector<Link> links_of_voids)
      : slab_case(std::move(built)),
        active(slab_case->active(false)),
        voids(slab_case->lower, slab_case->upper, links_of_voids),
        completion(slab(), classes(), active, seed(slab(), classes(), active, rules), rules) {
    apart = completion.run();
  }
  VoidSlab(const VoidSlab&) = delete;
  VoidSlab& operator=(const VoidSlab&) = delete;

  [[nodiscard]] const Slab& slab() const { return *slab_case->slab; }
  [[nodiscard]] const SlabClasses& classes() const { return *slab_case->classes; }

  std::unique_ptr<SlabCase> slab_case;
  IdVector<ClassId, std::uint8_t> active;
  SlabVoids voids;
  RuleCounts rules{};
  Completion completion;
  std::vector<LeftApart> apart;
};

/// A link for each two voids that have a face in common.
[[nodiscard]] inline std::vector<Link> links_by_faces(const SlabCase& c) {
  const sections::FaceOverlay overlay(sections::given_section(c.lower), c.lower.nesting,
                                      sections::given_section(c.upper), c.upper.nesting);
  std::vector<Link> links;
  for (const sections::OverlayFace& face : overlay.faces()) {
    if (!face.lower.solid && !face.upper.solid) {
      links.push_back({SlabId(0), face.lower.id, face.upper.id});
    }
  }
  std::sort(links.begin(), links.end());
  links.erase(std::unique(links.begin(), links.end()), links.end());
  return links;
}

/// Slab 0 of a stack; null where a section is empty. Voids are linked by faces, or not at all.
[[nodiscard]] inline std::unique_ptr<VoidSlab> void_slab(const SectionStack& stack, bool linked) {
  std::unique_ptr<SlabCase> built = slab_case(stack, 0);
  if (!built) return nullptr;
  std::vector<Link> links = linked ? links_by_faces(*built) : std::vector<Link>();
  return std::make_unique<VoidSlab>(std::move(built), std::move(links));
}

/// Calls body(slab) for some of each kind about voids.
template <class Body>
void for_each_void_slab(std::uint64_t seeds, bool linked, const Body& body) {
  for (const StackKind kind : kinds_with_voids()) {
    for (std::uint64_t seed = 1; seed <= seeds; ++seed) {
      SCOPED_TRACE(std::string(name_of(kind)) + " seed " + std::to_string(seed));
      const std::unique_ptr<VoidSlab> s = void_slab(generate(kind, seed).stack, linked);
      if (s && s->apart.empty()) body(*s);
    }
  }
}

}  // namespace tetloft::testing

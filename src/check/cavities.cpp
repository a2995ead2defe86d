// What the sections and the links of regions and voids imply, against what the model has: which
// voids hang together, and the Euler characteristic of each slab's solid, class by class.
#include "check/cavities.hpp"

#include <array>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>

namespace tetloft::internal::checking {

namespace {

constexpr const char* kName = "cavities and tunnels";

class CavityCheck {
 public:
  CavityCheck(std::span<const Deviation> deviations, const StackVoids& stack,
              const ExpectedCavities& expected, const CheckOptions& options)
      : listed_(deviations),
        stack_(stack),
        expected_(expected),
        regions_(stack.regions()),
        strict_(options.strict),
        findings_(5, kName, options.places) {}

  Findings run(std::span<const SlabPart> parts, const ModelVoids& voids) {
    check_links();
    check_voids(voids);
    std::vector<std::map<std::size_t, long>> chi(expected_.slabs.size());
    for (const SlabPart& part : parts) {
      if (part.slab >= 0 && static_cast<std::size_t>(part.slab) < chi.size()) {
        count(part, expected_.slabs[static_cast<std::size_t>(part.slab)],
              chi[static_cast<std::size_t>(part.slab)]);
      } else {
        check_end(part);
      }
    }
    check_slabs(chi);
    if (strict_) refuse_exceptions();
    return std::move(findings_);
  }

 private:
  void check_links() {
    if (expected_.voids.unrealised.has_value()) {
      findings_.fail(1, "the links of voids cannot be recomputed", [&] {
        return "label " + std::to_string(*expected_.voids.unrealised) +
               " of holes cannot be realised";
      });
    }
    for (const std::string& wrong : expected_.voids.wrong) {
      findings_.fail(2, "a link of voids cannot have been forced, or unrealisable",
                     [&] { return wrong; });
    }
  }

  void check_voids(const ModelVoids& voids) {
    for (const TriangleVertices& bubble : voids.bubbles) {
      findings_.fail(3, "a boundary surface meets no contour: a bubble",
                     [&] { return "surface of " + face_text({}, bubble); });
    }
    const auto compare = [&](const std::vector<std::size_t>& one,
                             const std::vector<std::size_t>& other, int condition,
                             const char* what) {
      std::vector<std::size_t> first(one.size(), one.size());  // of those that are one void
      for (std::size_t v = 0; v < one.size(); ++v) {
        std::size_t& leader = first[one[v]];
        if (leader == one.size()) leader = v;
        if (other[leader] == other[v]) continue;
        findings_.fail(condition, what, [&, a = leader] { return void_text(a, v); });
      }
    };
    compare(expected_.void_set, voids.set, 4, "voids that correspond are different voids");
    compare(voids.set, expected_.void_set, 5, "voids that do not correspond are one void");
  }

  // Adds what a part holds to its group.
  void count(const SlabPart& part, const SlabTopology& slab, std::map<std::size_t, long>& chi) {
    std::set<std::size_t> classes;
    for (const std::size_t r : part.regions) classes.insert(slab.class_of[r - slab.first]);
    if (classes.size() != 1) {
      findings_.fail(6, "what hangs together in a slab is not of one class there",
                     [&] { return "slab " + std::to_string(part.slab) + ", " + part_text(part); });
    }
    if (!classes.empty()) chi[slab.group_of[*classes.begin() - slab.first]] += part.chi;
  }

  void check_end(const SlabPart& part) {
    const bool expected =
        part.regions.size() == 1 && part.chi == chi_of_region(regions_, part.regions.front());
    if (expected) return;
    findings_.fail(9, "beyond the stack a region does not go on as it is",
                   [&] { return part_text(part); });
  }

  // The group of a deviation, if it is named rightly.
  [[nodiscard]] std::optional<std::size_t> group_of(const Deviation& deviation) const {
    const std::size_t slab = deviation.slab.index();
    if (!deviation.slab.valid() || slab >= expected_.slabs.size()) return std::nullopt;
    const std::size_t s = slab + (deviation.upper ? 1 : 0);
    const std::size_t c = deviation.contour.index();
    if (!deviation.contour.valid() || c >= regions_.nesting[s].region.size()) return std::nullopt;
    const std::size_t region = regions_.of(s, c);
    if (!regions_.is_outer(s, c) || expected_.slabs[slab].chi.count(region) == 0) {
      return std::nullopt;
    }
    return region;
  }

  // chi[s]: of each group in slab s, where it is not 0.
  void check_slabs(std::vector<std::map<std::size_t, long>>& chi) {
    using Numbers = std::array<long, 3>;                                // least, most, got
    std::map<std::pair<std::size_t, std::size_t>, Numbers> deviations;  // by slab and group
    for (std::size_t s = 0; s < chi.size(); ++s) {
      for (const auto& [group, expected] : expected_.slabs[s].chi) {
        const long got = chi[s][group];
        if (!expected.holds(got)) deviations[{s, group}] = {expected.least, expected.most, got};
      }
    }
    for (const Deviation& listed : listed_) {
      const std::optional<std::size_t> group = group_of(listed);
      const auto at =
          group.has_value() ? deviations.find({listed.slab.index(), *group}) : deviations.end();
      if (at != deviations.end() && at->second == Numbers{listed.least, listed.most, listed.got}) {
        deviations.erase(at);
        continue;
      }
      findings_.fail(8, "a listed deviation is none", [&] { return deviation_text(listed); });
    }
    for (const auto& [place, numbers] : deviations) {
      findings_.fail(7, "the Euler characteristic of a slab's solid is not the expected one",
                     [&, at = place, n = numbers] {
                       return "slab " + std::to_string(at.first) + ", " + region_text(at.second) +
                              ": " + numbers_text(n[0], n[1], n[2]);
                     });
    }
  }

  void refuse_exceptions() {
    constexpr const char* kWhat = "an exception, which strict does not allow";
    for (const Deviation& listed : listed_) {
      findings_.fail(10, kWhat, [&] { return deviation_text(listed); });
    }
    const auto links = [&](std::size_t number, const char* text) {
      if (number == 0) return;
      findings_.fail(
          10, kWhat, [&] { return std::to_string(number) + text; }, number);
    };
    links(expected_.voids.forced.size(), " forced links of voids");
    links(expected_.voids.unrealisable, " unrealisable links of voids");
  }

  [[nodiscard]] std::string region_text(std::size_t r) const {
    const std::size_t s = regions_.section[r];
    return contour_text(s, regions_.nesting[s].outer[RegionId(r - regions_.first[s])].index());
  }
  [[nodiscard]] std::string part_text(const SlabPart& part) const {
    std::string text = "part of " + tet_text(part.first) + ", at";
    for (const std::size_t r : part.regions) text += ' ' + region_text(r);
    return text + (part.regions.empty() ? " no region" : "");
  }
  [[nodiscard]] std::string void_text(std::size_t v) const {
    const std::size_t s = stack_.voids().section[v];
    if (stack_.is_exterior(v)) return "the exterior of section " + std::to_string(s);
    return contour_text(s, stack_.hole(v).index());
  }
  [[nodiscard]] std::string void_text(std::size_t a, std::size_t b) const {
    return void_text(a) + " and " + void_text(b);
  }
  [[nodiscard]] static std::string numbers_text(long least, long most, long got) {
    const std::string upto = least == most ? "" : " to " + std::to_string(most);
    return std::to_string(least) + upto + " expected, " + std::to_string(got) + " got";
  }
  [[nodiscard]] static std::string deviation_text(const Deviation& deviation) {
    return "slab " + std::to_string(deviation.slab.index()) +
           (deviation.upper ? ", upper contour " : ", lower contour ") +
           std::to_string(deviation.contour.index()) + ": " +
           numbers_text(deviation.least, deviation.most, deviation.got);
  }

  std::span<const Deviation> listed_;
  const StackVoids& stack_;
  const ExpectedCavities& expected_;
  const Regions& regions_;
  bool strict_;
  Findings findings_;
};

}  // namespace

Result<ExpectedCavities> expected_cavities(const StackVoids& stack, const VoidOptions& options,
                                           std::span<const VoidLink> claims,
                                           const Components::Expected& components) {
  const std::vector<Faces> faces = stack.faces();
  auto voids = expected_voids(stack, faces, components.links, options, claims);
  if (!voids.ok()) return voids.error();
  std::vector<SlabTopology> slabs = expected_topology(stack, faces, components.links, *voids);
  ExpectedCavities expected{*std::move(voids), std::move(slabs), {}, 0, {}};
  expected.void_set = expected_void_sets(stack, expected.voids);
  for (std::size_t v = 1; v < expected.void_set.size(); ++v) {
    if (expected.void_set[v] == v) ++expected.cavities;
  }
  const long pieces = static_cast<long>(components.components + expected.cavities);
  const ChiRange chi = expected_chi(stack, expected.slabs);
  expected.genus = {pieces - chi.most, pieces - chi.least};
  return expected;
}

Findings check_cavities(std::span<const SlabPart> parts, const StackVoids& stack,
                        const ModelVoids& voids, const ExpectedCavities& expected,
                        std::span<const Deviation> listed, const CheckOptions& options) {
  return CavityCheck(listed, stack, expected, options).run(parts, voids);
}

Findings no_cavities_asked() { return {5, kName, 0}; }

}  // namespace tetloft::internal::checking

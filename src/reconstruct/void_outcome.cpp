#include "reconstruct/void_outcome.hpp"

#include <algorithm>
#include <tuple>

#include "completion/slab_voids.hpp"
#include "correspondence/link_report.hpp"

namespace tetloft::internal {

namespace {

struct NamedVoid {
  bool upper = false;
  ContourId hole;
};

class Outcome {
 public:
  Outcome(const IdVector<SectionId, ConformingSection>& sections, Correspondence& decided,
          const IdVector<SectionId, Nesting>& complements)
      : sections_(sections), decided_(decided), complements_(complements) {}

  VoidOutcome of(const std::vector<Part>& parts) {
    for (const Part& part : parts) {
      // Ends close nothing.
      if (!part.lower.valid() || !part.upper.valid()) continue;
      for (const Link& link : part.solid.unrealised) {
        LinkCandidate* const candidate = find_candidate(decided_.candidates[part.slab], link);
        if (candidate != nullptr) candidate->fate = LinkFate::unrealisable;
      }
    }
    if (!complements_.empty()) result_.links = void_links(decided_.candidates, complements_);
    for (const Part& part : parts) {
      if (!part.lower.valid() || !part.upper.valid()) continue;
      for (const Inseparable& pair : part.solid.united_voids) add_forced(part, pair);
      for (const SlabDeviation& deviation : part.solid.deviations) add(part, deviation);
    }
    std::stable_sort(result_.links.begin(), result_.links.end(),
                     [](const VoidLink& a, const VoidLink& b) { return a.slab < b.slab; });
    return std::move(result_);
  }

 private:
  [[nodiscard]] NamedVoid named(const Part& part, SlabVoidId v) const {
    const SectionVoids lower = voids_of(sections_[part.lower]);
    const SectionVoids upper = voids_of(sections_[part.upper]);
    const SlabVoidNumbering numbering(lower.hole.size(), upper.hole.size());
    const bool above = numbering.is_upper(v);
    return {above, (above ? upper : lower).hole[numbering.in_section(v).index()]};
  }

  void add_forced(const Part& part, const Inseparable& pair) {
    NamedVoid a = named(part, pair[0]);
    NamedVoid b = named(part, pair[1]);
    if (a.upper && !b.upper) std::swap(a, b);
    VoidLink link;
    link.slab = part.slab;
    link.lower = a.hole;
    link.upper = b.hole;
    if (a.upper == b.upper) link.planes = a.upper ? VoidPlanes::upper : VoidPlanes::lower;
    link.fate = LinkFate::forced;
    for (VoidLink& known : result_.links) {
      if (known.slab == link.slab && known.planes == link.planes && known.lower == link.lower &&
          known.upper == link.upper) {
        known.fate = LinkFate::forced;
        return;
      }
    }
    result_.links.push_back(link);
  }

  void add(const Part& part, const SlabDeviation& deviation) {
    const bool upper = part.solid.regions.is_upper(deviation.region);
    const Nesting& nesting = sections_[upper ? part.upper : part.lower].nesting;
    result_.deviations.push_back({part.slab, upper,
                                  nesting.outer[part.solid.regions.in_section(deviation.region)],
                                  deviation.least, deviation.most, deviation.got});
  }

  const IdVector<SectionId, ConformingSection>& sections_;
  Correspondence& decided_;
  const IdVector<SectionId, Nesting>& complements_;
  VoidOutcome result_;
};

}  // namespace

VoidOutcome void_outcome(const IdVector<SectionId, ConformingSection>& sections,
                         std::optional<Correspondence>& decided,
                         const IdVector<SectionId, Nesting>& complements,
                         const std::vector<Part>& parts) {
  if (!decided) return {};
  return Outcome(sections, *decided, complements).of(parts);
}

}  // namespace tetloft::internal

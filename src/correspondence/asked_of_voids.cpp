#include "correspondence/asked_of_voids.hpp"

#include <optional>
#include <string>
#include <utility>

namespace tetloft::internal {

namespace {

Error error_at(SectionId section, std::optional<ContourId> contour, std::string message) {
  Place place;
  place.section = section.index();
  if (contour) place.contour = contour->index();
  return {ErrorCode::invalid_input, std::move(message), place};
}

// The contour that names a void in the complement: that of a hole, or the last of all.
Result<ContourId> in_complement(const IdVector<SectionId, Nesting>& nestings, SectionId section,
                                ContourId hole, const char* what) {
  const Nesting& nesting = nestings[section];
  if (!hole.valid()) return ContourId(nesting.depth.size());
  if (hole.index() >= nesting.depth.size()) {
    return error_at(section, hole, std::string(what) + " names a contour that does not exist");
  }
  if (nesting.depth[hole] % 2 == 0) {
    return error_at(section, hole, std::string(what) + " of voids names a contour that is no hole");
  }
  return hole;
}

Result<Label> in_complement(const IdVector<SectionId, Nesting>& nestings, Label label) {
  if (label.section.index() >= nestings.size()) {
    return error_at(label.section, label.contour, "the label names a section that does not exist");
  }
  if (!label.contour.valid()) {
    return error_at(label.section, std::nullopt, "there is no label for the outside");
  }
  const Result<ContourId> contour =
      in_complement(nestings, label.section, label.contour, "the label");
  if (!contour) return contour.error();
  label.contour = *contour;
  return label;
}

Result<LinkDecision> in_complement(const IdVector<SectionId, Nesting>& nestings,
                                   LinkDecision decision) {
  if (decision.slab.index() + 1 >= nestings.size()) {
    return error_at(SectionId(decision.slab.value()), std::nullopt,
                    "the decision names a section that does not exist, or has none above");
  }
  const SectionId below = lower_section(decision.slab);
  const SectionId above = upper_section(decision.slab);
  if (!decision.lower.valid() && !decision.upper.valid()) {
    return error_at(below, std::nullopt,
                    "the outside is the same in all sections: there is nothing to decide");
  }
  const Result<ContourId> lower = in_complement(nestings, below, decision.lower, "the decision");
  if (!lower) return lower.error();
  const Result<ContourId> upper = in_complement(nestings, above, decision.upper, "the decision");
  if (!upper) return upper.error();
  decision.lower = *lower;
  decision.upper = *upper;
  return decision;
}

}  // namespace

Result<Asked> asked_of_voids(const IdVector<SectionId, Nesting>& nestings,
                             const VoidOptions& options) {
  Asked asked;
  asked.voids = true;
  for (const Label& label : options.labels) {
    const Result<Label> said = in_complement(nestings, label);
    if (!said) return said.error();
    asked.labels.push_back(*said);
  }
  for (const LinkDecision& decision : options.decisions) {
    const Result<LinkDecision> said = in_complement(nestings, decision);
    if (!said) return said.error();
    asked.decisions.push_back(*said);
  }
  return asked;
}

}  // namespace tetloft::internal

// The rule as a whole.
#include "check/partition.hpp"

#include <algorithm>
#include <utility>

#include "core/unit_of_length.hpp"
#include "sections/scaling.hpp"

namespace tetloft::internal::checking {

namespace {

// Rules 1 to 4.
class CandidateFinder {
 public:
  CandidateFinder(const Regions& regions, const Motions& motions,
                  const CorrespondenceOptions& options)
      : regions_(regions), m_(regions, motions), options_(options) {}

  // In the order of links.
  Result<std::vector<Candidate>> run(const SectionStack& refined, const DecidedLinks& decided) {
    if (auto good = by_criterion(refined); !good.ok()) return good.error();
    if (options_.criterion != Criterion::reverse) {
      if (options_.chain) {
        for (const Candidate& chain : chain_links(regions_, links()))
          found_.emplace(chain.link, chain.s);
      }
      if (options_.lone) {
        for (const Link& link : lone_links(regions_, m_, links())) add(link);
      }
    }
    for (const Link& link : decided.parted) found_.erase(link);
    for (const Link& link : decided.joined) add(link);
    std::vector<Candidate> candidates;
    for (const auto& [link, s] : found_) {
      candidates.push_back({link, s, decided.joined.count(link) != 0});
    }
    return candidates;
  }

 private:
  Result<void> by_criterion(const SectionStack& refined) {
    const double tau = threshold_of(options_);
    std::vector<Link> links;
    switch (options_.criterion) {
      case Criterion::overlap: links = overlap_links(regions_, tau); break;
      case Criterion::moved: links = moved_links(regions_, m_, tau); break;
      case Criterion::reverse: {
        auto reverse = reverse_links(refined, regions_);
        if (!reverse.ok()) return reverse.error();
        links = *std::move(reverse);
      }
    }
    for (const Link& link : links) add(link);
    return {};
  }

  // With s, which only labels ask for.
  void add(const Link& link) {
    found_.emplace(link, options_.labels.empty() ? 0 : score(regions_, m_, link));
  }

  [[nodiscard]] std::vector<Link> links() const {
    std::vector<Link> links;
    for (const auto& [link, s] : found_) links.push_back(link);
    return links;
  }

  const Regions& regions_;
  MovedRatios m_;
  const CorrespondenceOptions& options_;
  std::map<Link, double> found_;  // with s
};

std::string passage_text(const Regions& regions, const Passage& passage) {
  const std::size_t s = regions.section[passage.region];
  const RegionId r(passage.region - regions.first[s]);
  return "section " + std::to_string(s) + " contour " +
         std::to_string(regions.nesting[s].outer[r].index()) +
         (passage.up ? ", upwards" : ", downwards");
}

// Where they differ.
std::vector<std::string> differences(const Regions& regions, const Motions& claimed,
                                     const Motions& estimated) {
  std::vector<std::string> texts;
  const auto compare = [&](const Motions& one, const Motions& other, bool both) {
    for (const auto& [passage, by] : one) {
      const auto same = other.find(passage);
      if (same == other.end() ? by != Point2{0, 0} : both && same->second != by) {
        texts.push_back(passage_text(regions, passage));
      }
    }
  };
  compare(claimed, estimated, true);
  compare(estimated, claimed, false);
  return texts;
}

Error contradiction(const Regions& regions, const Link& joined) {
  Place place;
  place.section = regions.section[joined.lower];
  const RegionId region(joined.lower - regions.first[*place.section]);
  place.contour = regions.nesting[*place.section].outer[region].index();
  return {ErrorCode::invalid_input, "a decision joins its region to one of another label", place};
}

}  // namespace

Result<std::vector<std::optional<std::uint32_t>>> label_regions(const Regions& regions,
                                                                const std::vector<Label>& labels) {
  std::vector<std::optional<std::uint32_t>> of_region(regions.size());
  for (const Label& label : labels) {
    Place place;
    place.section = label.section.index();
    place.contour = label.contour.index();
    if (label.section.index() >= regions.nesting.size() ||
        label.contour.index() >= regions.nesting[label.section.index()].region.size()) {
      return Error{ErrorCode::invalid_input, "a label names a contour that does not exist", place};
    }
    auto& of = of_region[regions.of(label.section.index(), label.contour.index())];
    if (of.has_value() && *of != label.label) {
      return Error{ErrorCode::invalid_input,
                   "two labels, " + std::to_string(*of) + " and " + std::to_string(label.label) +
                       ", in one region",
                   place};
    }
    of = label.label;
  }
  return of_region;
}

Result<ExpectedPartition> expected_partition(const SectionStack& given, const SectionStack& refined,
                                             const CorrespondenceOptions& options,
                                             const Claims& claims, bool estimate_anew) {
  // In the stack's unit of length neither distances nor their quotients leave the range of doubles.
  const int exponent = sections::unit_of(given).exponent();
  const SectionStack stack = sections::scaled(given, exponent);
  const Regions regions = number_regions(stack);
  auto label = label_regions(regions, options.labels);
  if (!label.ok()) return label.error();
  auto decided = decided_links(regions, options.decisions);
  if (!decided.ok()) return decided.error();

  ExpectedPartition expected;
  Motions motions;
  if (options.criterion == Criterion::moved) {
    ClaimedMotions claimed = claimed_motions(regions, claims.motions);
    expected.wrong_motions = std::move(claimed.wrong);
    motions = in_unit(claimed.motions, exponent);
    if (estimate_anew || !claims.any()) motions = estimated_motions(stack, regions);
    if (estimate_anew && claims.any()) {
      expected.other_motions = differences(regions, claimed.motions, in_unit(motions, -exponent));
    }
  }
  auto candidates = CandidateFinder(regions, motions, options).run(refined, *decided);
  if (!candidates.ok()) return candidates.error();
  DroppedLinks dropped = dropped_links(regions, claims.links, *candidates);
  expected.dropped = dropped.links.size();
  expected.wrong_dropped = std::move(dropped.wrong);
  std::erase_if(*candidates, [&](const Candidate& c) { return dropped.links.count(c.link) != 0; });
  std::set<Link> closed = std::move(decided->parted);
  closed.merge(dropped.links);

  RegionSets sets = unite_regions(stack, regions, *std::move(candidates), *label, closed);
  if (sets.contradicted.has_value()) return contradiction(regions, *sets.contradicted);
  expected.unrealised = sets.unrealised;
  expected.links = std::move(sets.accepted);
  for (std::size_t s = 0; s < stack.sections.size(); ++s) {
    for (std::size_t c = 0; c < stack.sections[SectionId(s)].contours.size(); ++c) {
      expected.set.push_back(sets.set[regions.of(s, c)]);
    }
  }
  return expected;
}

}  // namespace tetloft::internal::checking

// What the rules of links say of regions and of voids alike, word by word: all pairs, rationals,
// nothing fast. The base of correspondence_oracle and void_oracle.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <utility>
#include <vector>

#include <tetloft/correspondence.hpp>
#include <tetloft/section_stack.hpp>

#include "support/region_oracle.hpp"

namespace tetloft::oracle {

/// Of regions, the lower one first.
using RegionPair = std::pair<std::size_t, std::size_t>;

class LinkRule {
 protected:
  struct Words {
    double chain_reach = kChainReach;
    /// The first region of each section is its exterior, named by no contour, as regions of the
    /// complement go; the last contour of a section is none of the user's.
    bool exteriors = false;
  };

  /// Of the regions of this stack. All must outlive this.
  LinkRule(const SectionStack& stack, const std::vector<Label>& labels,
           const std::vector<LinkDecision>& decisions, const Words& words);

  // What is measured.
  [[nodiscard]] double z(std::size_t section) const {
    return stack_.sections[SectionId(section)].z;
  }
  [[nodiscard]] double gap(std::size_t a, std::size_t b) const;
  const Rational& ratio(const RegionPair& pair);
  double distance(const RegionPair& pair);
  [[nodiscard]] bool is_exterior(std::size_t r) const;

  // Rule 2, from the candidates so far.
  [[nodiscard]] std::vector<std::size_t> partners(std::size_t r, std::size_t section) const;
  void by_chains();
  // Rule 4.
  [[nodiscard]] std::optional<RegionPair> pair_of(SlabId slab, ContourId lower, ContourId upper,
                                                  bool outer) const;
  void decide();
  // Rules 5 to 7.
  void take_labels();
  void accept();
  void connect_labels();

  const SectionStack& stack_;
  std::vector<Region> regions_;
  std::vector<RegionPair> pairs_;
  std::map<RegionPair, double> candidates_;  // with s
  std::set<RegionPair> joined_, closed_;
  std::vector<std::size_t> set_;  // of regions
  std::set<RegionPair> links_;    // accepted
  bool refused_ = false;
  bool realised_ = true;

 private:
  std::optional<std::size_t> origin(std::size_t r, std::size_t section);
  double ratio_moved_on(std::size_t r, std::size_t from, std::size_t onto, bool& enough);
  [[nodiscard]] std::optional<std::size_t> named(std::size_t section, ContourId contour,
                                                 bool outer) const;
  bool unite(const RegionPair& pair);
  bool connect(std::uint32_t label);
  [[nodiscard]] double way(const RegionPair& pair) const;

  const std::vector<Label>& labels_;
  const std::vector<LinkDecision>& decisions_;
  Words words_;
  std::map<RegionPair, Rational> ratio_;
  std::map<RegionPair, double> distance_;
  std::vector<std::optional<std::uint32_t>> label_;  // of a region's set
};

}  // namespace tetloft::oracle

#include "reconstruct/layered_voids.hpp"

#include <algorithm>
#include <cstdint>
#include <iterator>
#include <utility>

#include "core/guard.hpp"
#include "core/sort_distinct.hpp"
#include "reconstruct/decide_voids.hpp"
#include "sections/complement.hpp"

namespace tetloft::internal {

namespace {

// The exterior and the holes.
std::size_t void_count(const Nesting& nesting) {
  return 1 + static_cast<std::size_t>(
                 std::count_if(nesting.depth.begin(), nesting.depth.end(),
                               [](std::uint32_t depth) { return depth % 2 != 0; }));
}

// Sets of voids that have the class of any member, or none yet.
class ClassedVoids {
 public:
  ClassedVoids(std::vector<std::size_t> class_of, std::size_t none)
      : sets_(class_of.size()), class_(std::move(class_of)), none_(none) {}

  /// False where that would join two classes.
  bool unite(std::size_t a, std::size_t b) {
    a = sets_.find(a);
    b = sets_.find(b);
    if (class_[a] != none_ && class_[b] != none_ && class_[a] != class_[b]) return false;
    const std::size_t both = std::min(class_[a], class_[b]);
    sets_.unite(a, b);
    class_[sets_.find(a)] = both;
    return true;
  }

 private:
  UnionFind sets_;
  std::vector<std::size_t> class_;
  std::size_t none_;
};

}  // namespace

LayeredVoids::LayeredVoids(const Layers& layers, const std::vector<Link>& links)
    : layers_(layers), links_(links) {
  for (const NestedSection& layer : layers) numbering_.add_layer(void_count(layer.nesting));
  UnionFind sets(numbering_.size());
  sets.unite(numbering_.of(0, 0), numbering_.of(last(), 0));
  for (const Link& link : links) {
    sets.unite(numbering_.of(0, link.lower.index()), numbering_.of(last(), link.upper.index()));
  }
  class_of_.assign(numbering_.size(), none());
  for (const std::size_t k : {std::size_t{0}, last()}) {
    for (std::size_t v = 0; v < numbering_.size(k); ++v) {
      class_of_[numbering_.of(k, v)] = sets.find(numbering_.of(k, v));
    }
  }
}

std::optional<IdVector<SlabId, std::vector<Link>>> LayeredVoids::decide(
    const IdVector<SlabId, std::vector<Link>>& of_regions) {
  PreparedStack stack;
  for (const NestedSection& layer : layers_) {
    stack.stack.sections.push_back(layer.section);
    stack.nestings.push_back(layer.nesting);
  }
  ReconstructOptions by_rule;
  by_rule.execution.threads = 1;  // as slabs share the threads
  const WatchedWork work(by_rule.execution, 0);
  VoidDecision decision(stack, by_rule);
  Result<std::optional<Correspondence>> voids = decision.make(of_regions, work);
  if (!accepted(voids) || !*voids) return std::nullopt;
  overlays_ = decision.take_overlays();
  return parted(std::move((*voids)->candidates));
}

IdVector<SlabId, std::vector<Link>> LayeredVoids::parted(StackCandidates candidates) const {
  const auto below = [&](const Link& link) {
    return numbering_.of(link.slab.index(), link.lower.index());
  };
  const auto above = [&](const Link& link) {
    return numbering_.of(link.slab.index() + 1, link.upper.index());
  };
  ClassedVoids sets(class_of_, none());
  IdVector<SlabId, std::vector<Link>> links(last());
  for (const SlabId k : links.ids()) {
    links[k].push_back({k, sections::kExterior, sections::kExterior});
    sets.unite(below(links[k].front()), above(links[k].front()));
  }
  SlabCandidates made;
  for (const SlabCandidates& slab : candidates) {
    std::copy_if(slab.begin(), slab.end(), std::back_inserter(made),
                 [](const LinkCandidate& candidate) { return candidate.made(); });
  }
  std::stable_sort(made.begin(), made.end(), [](const LinkCandidate& a, const LinkCandidate& b) {
    return a.score() > b.score();
  });
  for (const LinkCandidate& candidate : made) {
    const Link& link = candidate.link;
    if (sets.unite(below(link), above(link))) links[link.slab].push_back(link);
  }
  for (std::vector<Link>& slab : links) sort_distinct(slab);
  return links;
}

std::optional<RealisedVoids> LayeredVoids::realised(
    const IdVector<SlabId, std::vector<Link>>& links,
    const std::vector<std::optional<SlabSolid>>& solids) const {
  UnionFind got(numbering_.size());
  for (const SlabId k : links.ids()) {
    const SlabSolid* const solid = solids.empty() ? nullptr : &*solids[k.index()];
    const SlabVoidNumbering in_slab(numbering_.size(k.index()), numbering_.size(k.index() + 1));
    const auto in_all = [&](SlabVoidId v) {
      return numbering_.of(k.index() + (in_slab.is_upper(v) ? 1 : 0),
                           in_slab.in_section(v).index());
    };
    for (const Link& link : links[k]) {
      if (solid == nullptr || std::find(solid->unrealised.begin(), solid->unrealised.end(), link) ==
                                  solid->unrealised.end()) {
        got.unite(in_all(in_slab.in_slab(false, link.lower)),
                  in_all(in_slab.in_slab(true, link.upper)));
      }
    }
    if (solid == nullptr) continue;
    for (const auto& [a, b] : solid->united_voids) got.unite(in_all(a), in_all(b));
  }
  std::vector<std::size_t> class_of_part(numbering_.size(), none());
  for (std::size_t v = 0; v < class_of_.size(); ++v) {
    if (class_of_[v] == none()) continue;
    std::size_t& wanted = class_of_part[got.find(v)];
    if (wanted == none()) wanted = class_of_[v];
    if (wanted != class_of_[v]) return std::nullopt;
  }
  for (std::size_t v = 0; v < class_of_.size(); ++v) {
    if (class_of_part[got.find(v)] == none()) return std::nullopt;
  }
  return compare(got);
}

// As of a slab without sections between: what is not open is no link, and voids of one class may
// hang together though the links between them do not.
RealisedVoids LayeredVoids::compare(const UnionFind& got) const {
  const SlabVoidNumbering voids(numbering_.size(0), numbering_.size(last()));
  const auto in_all = [&](SlabVoidId v) {
    return numbering_.of(voids.is_upper(v) ? last() : 0, voids.in_section(v).index());
  };
  RealisedVoids result;
  UnionFind linked(voids.size());
  const auto unite = [&](SlabVoidId a, SlabVoidId b) { return linked.unite(a.index(), b.index()); };
  unite(voids.in_slab(false, sections::kExterior), voids.in_slab(true, sections::kExterior));
  for (const Link& link : links_) {
    const SlabVoidId below = voids.in_slab(false, link.lower);
    const SlabVoidId above = voids.in_slab(true, link.upper);
    if (got.same(in_all(below), in_all(above))) {
      result.links.push_back(link);
      unite(below, above);
    } else {
      result.unrealised.push_back(link);
    }
  }
  std::vector<SlabVoidId> first(numbering_.size());
  for (std::size_t v = 0; v < voids.size(); ++v) {
    SlabVoidId& of_part = first[got.find(in_all(SlabVoidId(v)))];
    if (!of_part.valid()) of_part = SlabVoidId(v);
    if (unite(of_part, SlabVoidId(v))) result.united.push_back({of_part, SlabVoidId(v)});
  }
  return result;
}

}  // namespace tetloft::internal

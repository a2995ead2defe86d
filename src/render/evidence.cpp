#include "render/evidence.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <map>
#include <utility>

#include "core/union_find.hpp"
#include "model/sureness.hpp"

namespace tetloft::internal::render {

namespace {

constexpr std::size_t kNone = std::numeric_limits<std::size_t>::max();

// Links that were made, the least sure first.
std::vector<const RegionLink*> least_sure_first(const Model& model) {
  std::vector<const RegionLink*> made;
  for (const RegionLink& link : model.links) {
    if (link.fate == LinkFate::made) made.push_back(&link);
  }
  std::stable_sort(made.begin(), made.end(), [](const RegionLink* a, const RegionLink* b) {
    return sureness(*a) < sureness(*b);
  });
  return made;
}

// A contour as a slab sees it: slab, section, contour.
using Place = std::array<std::uint32_t, 3>;

// The first link of each place.
std::map<Place, std::size_t> first_at(const std::vector<const RegionLink*>& links) {
  std::map<Place, std::size_t> first;
  for (std::size_t k = 0; k < links.size(); ++k) {
    const std::uint32_t slab = links[k]->slab.value();
    first.emplace(Place{slab, slab, links[k]->lower.value()}, k);
    first.emplace(Place{slab, slab + 1, links[k]->upper.value()}, k);
  }
  return first;
}

class Parts {
 public:
  Parts(const TetMesh& mesh, const Subject& subject)
      : subject_(subject), sets_(subject.tets.size()) {
    for (std::size_t h = 0; h < 4 * subject.tets.size(); ++h) {
      const HalfFaceId other = mesh.opposite(HalfFaceId(h));
      if (!other.valid() || other.index() < h) continue;
      const std::size_t s = h / 4;
      const std::size_t t = other.index() / 4;
      if (subject.slab[s] == subject.slab[t] && !is_end(s) && !is_end(t)) sets_.unite(s, t);
    }
  }

  [[nodiscard]] bool is_end(std::size_t tet) const {
    return !subject_.kind.empty() && subject_.kind[tet] == TetKind::prism;
  }
  [[nodiscard]] std::size_t of(std::size_t tet) const { return sets_.find(tet); }

 private:
  const Subject& subject_;
  UnionFind sets_;
};

}  // namespace

bool tells_evidence(const Model& model) {
  return !model.links.empty() && !model.slab.empty() && !model.section.empty() &&
         !model.contour.empty();
}

std::vector<std::uint8_t> evidence_by_tet(const Model& model, const TetMesh& mesh,
                                          const Subject& subject) {
  const std::vector<const RegionLink*> links = least_sure_first(model);
  const std::map<Place, std::size_t> first = first_at(links);
  const Parts parts(mesh, subject);
  std::vector<std::size_t> link_of(subject.tets.size(), kNone);  // by the name of a part
  for (std::size_t t = 0; t < subject.tets.size(); ++t) {
    if (parts.is_end(t)) continue;
    std::size_t& least = link_of[parts.of(t)];
    const std::uint32_t slab = subject.slab_number[subject.slab[t]];
    for (const VertexId v : subject.tets[t]) {
      if (!model.contour[v].valid()) continue;
      const auto found = first.find({slab, model.section[v].value(), model.contour[v].value()});
      if (found != first.end()) least = std::min(least, found->second);
    }
  }
  std::vector<std::uint8_t> evidence(subject.tets.size(), kNoEvidence);
  for (std::size_t t = 0; t < subject.tets.size(); ++t) {
    const std::size_t link = parts.is_end(t) ? kNone : link_of[parts.of(t)];
    if (link != kNone) evidence[t] = static_cast<std::uint8_t>(links[link]->evidence);
  }
  return evidence;
}

}  // namespace tetloft::internal::render
